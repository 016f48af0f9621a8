#include "PieceOutlines.h"

#include "DesignCheck.h"
#include "OpenCuts.h"
#include "PlaneCurves.h"
#include "SmoothRows.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace bolster {

namespace {

constexpr double farthestFlat = 1e6;  // mm: what lies farther out has burst when it was laid flat
constexpr double sharpTurn = 35;      // degrees: an outline or a border that turns more has a corner
constexpr double bluntTurn = 5;       // degrees: that is seen in a straight line
constexpr double mostRounded = 2;     // mm: what a coarse form has is what it is
constexpr double besideCorner = 0.05; // times its turn: straight
constexpr double mostTurned = 0.003; // of a piece's area: narrow triangles beside a cut turn over, and mean nothing
constexpr double narrowest = 0.1;    // mm: nobody sews less

/// What belongs to a length along a row, of what belongs to its points.
Vec2 between(const std::vector<double>& along, const std::vector<Vec2>& values, double length)
{
    const auto after = std::upper_bound(along.begin() + 1, along.end() - 1, length);
    const auto i = static_cast<std::size_t>(after - along.begin());
    const double t = std::clamp((length - along[i - 1]) / std::max(along[i] - along[i - 1], 1e-12), 0.0, 1.0);
    return (1 - t) * values[i - 1] + t * values[i];
}

} // namespace

PieceOutlines::PieceOutlines(const Form& form, std::vector<FlatPiece> flat, double tolerance,
                             const std::stop_token& stop)
    : m_form(form)
    , m_flat(std::move(flat))
    , m_stop(stop)
    , m_outlines(form.pieces.size())
    , m_joined(form.pieces.size())
    , m_tolerances(form.pieces.size(), tolerance)
    , m_rooms(form.pieces.size())
{
    for (std::size_t p = 0; goesOn(p); ++p)
        makeCurves(p);
    makeSidesEqual(m_form, m_outlines, m_stop);
    joinCurves();
    for (std::size_t p = 0; goesOn(p); ++p)
        if (isThere(p) && outline(p).empty())
            leaveOut(p);
}

std::vector<double> PieceOutlines::rowStarts(std::size_t p) const
{
    std::vector<double> starts;
    for (const std::size_t curve : m_outlines[p].rows)
        starts.push_back(m_joined[p].starts[curve]);
    return starts;
}

bool PieceOutlines::beginsRow(std::size_t p, std::size_t k) const
{
    return std::ranges::find(piece(p).rows, k, &BorderRow::first) != piece(p).rows.end();
}

double PieceOutlines::flatTurn(std::size_t p, std::size_t k) const
{
    return turnAt(flatPoint(p, piece(p).before(k)), flatPoint(p, k), flatPoint(p, piece(p).after(k)));
}

/// A turn between straight lines is a corner, however blunt; in a bend the places beside it turn as well.
bool PieceOutlines::standsAlone(std::size_t p, std::size_t k) const
{
    const double turn = flatTurn(p, k);
    const auto isStraightAt = [&](std::size_t i) {
        const double there = flatTurn(p, i);
        return beginsRow(p, i) || there > sharpTurn || there < besideCorner * turn;
    };
    return turn > bluntTurn && isStraightAt(piece(p).before(k)) && isStraightAt(piece(p).after(k));
}

bool PieceOutlines::isCorner(std::size_t p, std::size_t k) const
{
    if (beginsRow(p, k) || flatTurn(p, k) > sharpTurn || standsAlone(p, k) ||
        roundedBy(flatPoint(p, piece(p).before(k)), flatPoint(p, k), flatPoint(p, piece(p).after(k))) > mostRounded)
        return true;
    return piece(p).mates[k].none() && turnsOnForm(p, k);
}

bool PieceOutlines::turnsOnForm(std::size_t p, std::size_t k) const
{
    const Vec3 &before = formPoint(p, piece(p).before(k)), &at = formPoint(p, k),
               &after = formPoint(p, piece(p).after(k));
    return turnAt(before, at, after) > sharpTurn || roundedBy(before, at, after) > mostRounded;
}

/// None of a piece that is left out.
void PieceOutlines::makeCurves(std::size_t p)
{
    if (!piece(p).isSheet()) {
        m_notes.push_back(piece(p).refusal);
        return;
    }
    const auto sensible = [](const Vec2& at) { return (at.array().abs() <= farthestFlat).all(); };
    if (m_flat[p].turnedShare > mostTurned || !std::ranges::all_of(m_flat[p].at, sensible)) {
        leaveOut(p);
        return;
    }
    if (widthOf(p) < narrowest) {
        m_notes.push_back({QT_TRANSLATE_NOOP("Message", "%1 is left out: it is too narrow to be sewn. Join "
                                                        "it to what lies beside it"),
                           {piece(p).name}});
        return;
    }
    m_rooms[p] = openCuts(m_form, p, m_flat[p]);
    fitCurves(p);
}

void PieceOutlines::fitCurves(std::size_t p)
{
    try {
        m_outlines[p] = curvesOf(p);
    } catch (const std::invalid_argument&) { // edges without a length
        m_outlines[p] = {};
        leaveOut(p);
    }
}

/// The two sides of a fine tip are curves of their own, and may cross: outlines that do are fitted more
/// closely. Then sides are made equal once more.
void PieceOutlines::joinCurves()
{
    constexpr int mostRefits = 2;
    constexpr double closer = 1.0 / 8;
    for (int round = 0;; ++round) {
        bool cross = false;
        for (std::size_t p = 0; goesOn(p); ++p) {
            if (!isThere(p))
                continue;
            m_joined[p] = joined(m_outlines[p]);
            if (m_joined[p].outline.empty()) {
                m_tolerances[p] *= closer;
                cross = true;
            }
        }
        if (!cross || round == mostRefits)
            return;
        for (std::size_t p = 0; goesOn(p); ++p)
            if (isThere(p))
                fitCurves(p);
        makeSidesEqual(m_form, m_outlines, m_stop);
    }
}

PieceOutlines::Joined PieceOutlines::joined(const PieceCurves& curves)
{
    Joined result;
    try {
        result.outline = edits::joined(curves.curves, &result.starts);
        if (outlineProblem(result.outline))
            result.outline = {};
    } catch (const std::invalid_argument&) { // edges without a length
    }
    return result;
}

/// Of a strip: its area by half of its border, mm.
double PieceOutlines::widthOf(std::size_t p) const
{
    double area = 0, length = 0;
    for (std::size_t k = 0; k < piece(p).border.size(); ++k) {
        const Vec2 here = flatPoint(p, k), next = flatPoint(p, piece(p).after(k));
        area += (here.x() * next.y() - here.y() * next.x()) / 2;
        length += (next - here).norm();
    }
    return length > 0 ? 2 * std::abs(area) / length : 0;
}

PieceCurves PieceOutlines::curvesOf(std::size_t p) const
{
    const std::size_t count = piece(p).border.size(), start = piece(p).rows.front().first;
    PieceCurves outline;
    for (std::size_t k = 0; k < count;) {
        if (beginsRow(p, (start + k) % count)) {
            outline.shut.push_back(liesAtOtherSide(m_form, p, outline.rows.size(), m_flat[p]));
            outline.rows.push_back(outline.curves.size());
        }
        const bool shut = outline.shut.back();
        const std::size_t first = k;
        do
            ++k;
        while (k < count && !isCorner(p, (start + k) % count) &&
               !(shut && isCorner(p, otherSide(p, (start + k) % count))));
        std::vector<std::size_t> places;
        for (std::size_t i = first; i <= k; ++i)
            places.push_back((start + i) % count);
        outline.curves.push_back(shut ? besideOtherSide(p, places)
                                      : curveOf(flatPoints(p, places), m_tolerances[p]));
    }
    return outline;
}

std::vector<Vec2> PieceOutlines::flatPoints(std::size_t p, const std::vector<std::size_t>& places) const
{
    std::vector<Vec2> points;
    for (const std::size_t place : places)
        points.push_back(flatPoint(p, place));
    return points;
}

/// Across a cut: the place that was the same one. Of the end of a cut itself.
std::size_t PieceOutlines::otherSide(std::size_t p, std::size_t k) const
{
    return piece(p).after(static_cast<std::size_t>(piece(p).mates[k].edge));
}

/// One curve in the middle for both sides, which lie beside it as far as they are drawn apart: two curves of
/// their own would cross.
BSpline2 PieceOutlines::besideOtherSide(std::size_t p, std::vector<std::size_t> places) const
{
    std::vector<std::size_t> others;
    for (const std::size_t place : places)
        others.push_back(otherSide(p, place));
    others.back() = static_cast<std::size_t>(piece(p).mates[piece(p).before(places.back())].edge);
    const bool isSecond = others.back() < places.front();
    if (isSecond) {
        std::ranges::reverse(places);
        std::ranges::reverse(others);
    }
    std::vector<Vec2> middle, beside;
    for (std::size_t i = 0; i < places.size(); ++i) {
        middle.push_back((flatPoint(p, places[i]) + flatPoint(p, others[i])) / 2);
        beside.push_back((flatPoint(p, places[i]) - flatPoint(p, others[i])) / 2);
    }
    BSpline2 curve = curveOf(middle, m_tolerances[p]);
    const std::vector<double> along = lengthsAlong(middle);
    const double scale = along.back() / curve.domainEnd();
    // Near its tip a cut opens within a short way, which wants a knot.
    const double opened = opensWithin(m_rooms[p][places[places.size() / 2]]);
    if (beside.front().isZero() && opened < along.back())
        curve = curve.withKnot(opened / scale);
    if (beside.back().isZero() && opened < along.back())
        curve = curve.withKnot((along.back() - opened) / scale);
    std::vector<Vec2> points = curve.points();
    for (int k = 0; k < curve.pointCount(); ++k)
        points[k] += between(along, beside, scale * curve.parameterOfPoint(k));
    const BSpline2 side(curve.degree(), false, std::move(points), curve.knots());
    return isSecond ? side.reversed() : side;
}

void PieceOutlines::leaveOut(std::size_t p)
{
    m_notes.push_back({QT_TRANSLATE_NOOP("Message", "%1 is left out: laid flat it would lie over itself. "
                                                    "Divide it, or cut it in where it bulges most"),
                       {piece(p).name}});
}

} // namespace bolster
