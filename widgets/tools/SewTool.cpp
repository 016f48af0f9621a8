#include "SewTool.h"

#include "CurvePath.h"
#include "Document.h"
#include "ElementText.h"
#include "SeamEdits.h"
#include "SeamStretches.h"
#include "Selection.h"
#include "SewPicture.h"
#include "Translated.h"

#include <QKeyEvent>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace bolster {

namespace {

// Pixels.
constexpr double reach = 12;
constexpr double snapReach = 9;
constexpr double dragDistance = 5;

/// The shorter way round a closed curve.
double shorterWay(double way, double period)
{
    return way - period * std::round(way / period);
}

} // namespace

const Design& SewTool::design() const
{
    return m_context.document().design();
}

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
    const double tolerance = m_context.transform().millimetres(reach);
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
    double nearest = m_context.transform().millimetres(snapReach);
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

void SewTool::forgetOffer()
{
    m_offer.reset();
    m_refusal.clear();
    m_mark.reset();
    m_pointing = false;
}

void SewTool::forgetAll()
{
    m_taken.clear();
    m_from.reset();
    m_dragging = false;
    m_flipped = false;
    m_several = false;
    forgetOffer();
}

/// Undo and the lists can take away what was picked.
void SewTool::forgetGone()
{
    const auto gone = [this](const Stretch& stretch) {
        return edits::stretchProblem(design(), stretch).has_value();
    };
    if (std::ranges::any_of(m_taken, gone) || (m_from && !design().find<Patch>(m_from->patch)))
        forgetAll();
}

void SewTool::takeBack()
{
    if (!m_taken.empty())
        m_taken.pop_back();
    m_several = m_several && !m_taken.empty();
    m_flipped = m_flipped && !m_taken.empty();
}

std::vector<Stretch> SewTool::row() const
{
    return m_taken.empty() ? m_taken : std::vector(m_taken.begin() + 1, m_taken.end());
}

void SewTool::press(const PatternPointer& pointer)
{
    forgetGone();
    if (onFlipButton(pointer.pixel)) {
        m_flipped = !m_flipped;
        m_context.refresh();
        return;
    }
    m_pressed = pointer;
    const std::optional<Place> place = placeAt(pointer.layout);
    m_pressedPlace = place ? std::optional(snapped(*place)) : std::nullopt;
    m_context.refresh();
}

void SewTool::move(const PatternPointer& pointer)
{
    forgetGone();
    const QPointF way = m_pressed ? pointer.pixel - m_pressed->pixel : QPointF();
    if (!m_dragging && m_pressedPlace && m_pressed && std::hypot(way.x(), way.y()) > dragDistance) {
        m_dragging = true;
        m_from = m_pressedPlace;
        m_way = 0;
    }
    offer(pointer);
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
    m_context.selection().hover(sewn ? sewn->first : settingsId);
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

void SewTool::release(const PatternPointer& pointer)
{
    if (!std::exchange(m_pressed, std::nullopt))
        return;
    const std::optional<Place> pressed = std::exchange(m_pressedPlace, std::nullopt);
    const bool point = pointer.modifiers & Qt::ShiftModifier && !m_from && !m_dragging;
    if (point && pressed) {
        m_from = pressed;
    } else if (!point) {
        offer(pointer);
        m_dragging = false;
        m_from.reset();
        take(pointer);
        forgetOffer(); // until the pointer moves: what it is on has just been taken
    }
    m_context.refresh();
}

void SewTool::take(const PatternPointer& pointer)
{
    if (!m_offer || !m_refusal.isEmpty()) {
        m_context.report(m_refusal.isEmpty() ? tr("Click on the outline of a patch.") : m_refusal);
        return;
    }
    m_taken.push_back(*m_offer);
    const bool more = m_several || pointer.modifiers & Qt::ControlModifier;
    if (m_taken.size() >= 2 && !more)
        sew();
}

void SewTool::sew()
{
    Message problem;
    const Edit edit =
        m_taken.size() < 2 ? Edit{} : edits::sewInRow(design(), m_taken.front(), row(), m_flipped, &problem);
    if (edit.empty()) {
        m_context.report(problem.empty() ? tr("Choose the other side first.") : translated(problem));
        return;
    }
    forgetAll();
    m_context.document().commit(edit);
    Selection::Elements added;
    for (const Change& change : edit.changes)
        added.insert(change.id);
    m_context.selection().set(added);
}

void SewTool::doubleClick(const PatternPointer& pointer)
{
    press(pointer); // who sews fast clicks twice without meaning a double click
}

bool SewTool::wants(int key) const
{
    switch (key) {
    case Qt::Key_F:
    case Qt::Key_M:
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return !m_taken.empty();
    case Qt::Key_Backspace:
        return true;
    default:
        return false;
    }
}

bool SewTool::keyPress(const QKeyEvent& event)
{
    if (!wants(event.key()))
        return false;
    forgetGone();
    if (event.key() == Qt::Key_F)
        m_flipped = !m_flipped;
    else if (event.key() == Qt::Key_M)
        m_several = !m_several;
    else if (event.key() != Qt::Key_Backspace)
        sew();
    else
        takeBack();
    m_refusal.clear();
    judgeOffer();
    m_context.refresh();
    return true;
}

bool SewTool::escape()
{
    m_pressed.reset();
    m_pressedPlace.reset();
    forgetOffer();
    if (m_from || m_dragging) {
        m_from.reset();
        m_dragging = false;
    } else if (!m_taken.empty()) {
        takeBack();
    } else {
        m_context.selection().hover(settingsId);
        m_context.endTool();
    }
    m_context.refresh();
    return true;
}

void SewTool::leave()
{
    if (m_pressed)
        return; // a drag outside goes on
    forgetOffer();
    m_context.selection().hover(settingsId);
    m_context.refresh();
}

QString SewTool::prompt() const
{
    if (m_dragging)
        return m_refusal.isEmpty() ? tr("Release where the stretch ends") : m_refusal;
    if (m_from)
        return m_refusal.isEmpty() ? tr("Click where the stretch ends \u2013 Esc goes back") : m_refusal;
    if (onFlipButton(m_pointer))
        return tr("Click to sew it the other way round (F)");
    if (!m_refusal.isEmpty())
        return m_refusal;
    if (m_taken.empty())
        return tr("Click the edge to sew \u2013 drag along the outline, or Shift+click twice, for a part of it; "
                  "Esc ends the tool");
    if (m_several)
        return tr("Click the edges of the row one after the other, Enter sews \u2013 F flips, Backspace takes one "
                  "back");
    if (m_taken.size() == 1)
        return tr("Click the edge it is sewn to \u2013 F flips, Ctrl+click or M for several in a row, Backspace "
                  "goes back");
    return tr(
        "Ctrl+click the next edge of the row, click the last one \u2013 Enter sews, F flips, Backspace takes one "
        "back");
}

QCursor SewTool::cursor() const
{
    if (onFlipButton(m_pointer))
        return Qt::PointingHandCursor;
    if (m_offer && !m_refusal.isEmpty())
        return Qt::ForbiddenCursor;
    return m_offer ? Qt::PointingHandCursor : Qt::CrossCursor;
}

/// Beside the middle of the first side, inside its patch, where nothing else is clicked.
std::optional<QPointF> SewTool::flipButton() const
{
    if (m_taken.empty())
        return std::nullopt;
    const SewPicture picture(m_context.scene(), m_context.transform());
    return picture.besideMiddle(m_taken.front());
}

bool SewTool::onFlipButton(QPointF pixel) const
{
    const std::optional<QPointF> button = flipButton();
    return button && std::hypot(pixel.x() - button->x(), pixel.y() - button->y()) <= SewPicture::buttonRadius;
}

void SewTool::paint(QPainter& painter, const ViewColors& colors) const
{
    SewPicture picture(m_context.scene(), m_context.transform());
    picture.design = design();
    picture.taken = m_taken;
    picture.offer = m_offer;
    picture.refused = !m_refusal.isEmpty();
    picture.flipped = m_flipped;
    picture.pointer = m_pointer;
    picture.button = flipButton();
    picture.buttonHovered = onFlipButton(m_pointer);
    if (m_from)
        picture.marks.push_back(m_from->at);
    if (m_mark && (m_from || m_pointing))
        picture.marks.push_back(m_mark->at);
    picture.paint(painter, colors);
}

} // namespace bolster
