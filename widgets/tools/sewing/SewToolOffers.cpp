// What a click of the tool that sews would take.
#include "SewTool.h"

#include "CurvePath.h"
#include "ElementText.h"
#include "SeamStretches.h"
#include "Selection.h"
#include "StretchLength.h"
#include "Translated.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace bolster {

namespace {

// Pixels.
constexpr double offerReach = 12;
constexpr double offerSnapReach = 9;

/// The shorter way round a closed curve.
double shorterWay(double way, double period)
{
    return way - period * std::round(way / period);
}

} // namespace

/// Of what will be sewn.
bool SewTool::isTaken(const Place& place) const
{
    const BSpline2& outline = design().find<Patch>(place.patch)->outline;
    const double start = outline.domainStart();
    return std::ranges::any_of(m_taken, [&](const Stretch& stretch) {
        const double way = outline.wrapped(start + place.parameter - stretch.from) - start;
        return stretch.patch == place.patch &&
               way <= unwrappedEnd(stretch.from, stretch.to, start, outline.domainEnd()) - stretch.from;
    });
}

/// The outline near a place: where two edges lie on each other a free one rather than a sewn one, then the one
/// whose patch lies there.
std::optional<SewTool::Place> SewTool::placeAt(const Vec2& layout) const
{
    const double tolerance = m_context.transform().millimetres(offerReach);
    std::optional<Place> best;
    std::tuple<bool, bool, double> bestRank;
    for (const auto& [id, patch] : m_context.scene().patches()) {
        if (patch.patch().outline.empty() || patch.box.exteriorDistance(layout) > tolerance)
            continue;
        const auto closest = patch.patch().outline.closest(fromLayout(patch.patch(), layout));
        if (closest.distance > tolerance)
            continue;
        const Place place{id, closest.parameter, toLayout(patch.patch(), closest.point)};
        const bool used = edits::sewnAt(design(), id, place.parameter) || isTaken(place);
        const bool outside = !patch.path.contains(toPoint(layout));
        const std::tuple rank(used, outside, closest.distance);
        if (best && rank >= bestRank)
            continue;
        bestRank = rank;
        best = place;
    }
    return best;
}

/// On the nearest corner, control point or end of a seam, if one is near.
SewTool::Place SewTool::snapped(const Place& place) const
{
    const PatternPatch* patch = m_context.scene().patch(place.patch);
    if (!patch)
        return place;
    const BSpline2& outline = patch->patch().outline;
    Place best = place;
    double nearest = m_context.transform().millimetres(offerSnapReach);
    const auto candidate = [&](double parameter) {
        const Vec2 at = toLayout(patch->patch(), outline.at(parameter));
        if (const double distance = (at - place.at).norm(); distance < nearest) {
            nearest = distance;
            best = {place.patch, outline.wrapped(parameter), at};
        }
    };
    for (int i = 0; i < outline.pointCount(); ++i)
        candidate(outline.parameterOfPoint(i));
    for (const double corner : edits::outlineCorners(outline))
        candidate(corner);
    for (const auto& [owner, stretch] : m_context.scene().stretches())
        if (stretch.patch == place.patch) {
            candidate(stretch.from);
            candidate(stretch.to);
        }
    return best;
}

std::optional<SewTool::Place> SewTool::snappedOn(ElementId id, const Vec2& layout) const
{
    const PatternPatch* patch = m_context.scene().patch(id);
    if (!patch || patch->patch().outline.empty())
        return std::nullopt;
    const auto closest = patch->patch().outline.closest(fromLayout(patch->patch(), layout));
    return snapped({id, closest.parameter, toLayout(patch->patch(), closest.point)});
}

void SewTool::offer(const PatternPointer& pointer)
{
    forgetOffer();
    m_pointer = pointer.pixel;
    if (m_dragging)
        offerDragged(pointer);
    else if (m_from)
        offerBetween(pointer);
    else if (!onFlipButton(pointer.pixel))
        offerEdge(pointer);
    judgeOffer();
    const auto sewn =
        m_refusal.isEmpty() || !m_mark ? std::nullopt : edits::sewnAt(design(), m_mark->patch, m_mark->parameter);
    m_context.selection().hover(sewn ? sewn->first : noElement);
    m_context.refresh();
}

void SewTool::offerEdge(const PatternPointer& pointer)
{
    const std::optional<Place> place = placeAt(pointer.layout);
    if (!place)
        return;
    m_mark = place;
    m_pointing = pointer.modifiers & Qt::ShiftModifier;
    if (m_pointing) {
        m_mark = snapped(*place);
        return;
    }
    m_offer = edits::freeStretchAt(design(), place->patch, place->parameter);
    if (std::ranges::find(m_taken, m_offer.value_or(Stretch{})) != m_taken.end())
        m_offer.reset(); // the pointer has not left it yet
    if (const auto sewn = edits::sewnAt(design(), place->patch, place->parameter))
        m_refusal = translated(*edits::stretchProblem(design(), sewn->second));
}

/// The way is followed, so that a drag can go round most of an outline.
void SewTool::offerDragged(const PatternPointer& pointer)
{
    m_mark = snappedOn(m_from->patch, pointer.layout);
    if (!m_mark)
        return;
    const BSpline2& outline = m_context.scene().patch(m_mark->patch)->patch().outline;
    m_way += shorterWay(m_mark->parameter - m_from->parameter - m_way, outline.period());
    m_way = std::clamp(m_way, -outline.period(), outline.period());
    const double to = m_from->parameter + m_way;
    if (m_way != 0)
        m_offer = edits::stretchBetween(m_mark->patch, outline, std::min(m_from->parameter, to),
                                        std::max(m_from->parameter, to));
}

void SewTool::offerBetween(const PatternPointer& pointer)
{
    m_mark = snappedOn(m_from->patch, pointer.layout);
    if (!m_mark)
        return;
    const BSpline2& outline = m_context.scene().patch(m_mark->patch)->patch().outline;
    const Stretch there = edits::stretchBetween(m_mark->patch, outline, m_from->parameter, m_mark->parameter);
    const Stretch back = edits::stretchBetween(m_mark->patch, outline, m_mark->parameter, m_from->parameter);
    const double way = stretchLength(design(), there), other = stretchLength(design(), back);
    if (m_from->parameter != m_mark->parameter)
        m_offer = way <= other ? there : back;
}

void SewTool::judgeOffer()
{
    if (!m_offer)
        return;
    std::vector<Stretch> others = row();
    others.push_back(*m_offer);
    const std::optional<Message> problem = m_taken.empty()
                                               ? edits::stretchProblem(design(), *m_offer)
                                               : edits::sewingProblem(design(), m_taken.front(), others);
    if (problem)
        m_refusal = translated(*problem);
}

} // namespace bolster
