#include "PieceLayout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

constexpr double letterWidth = 0.52;                          // of the height from line to line
constexpr std::array lineHeights = {6.0, 5.0, 4.0, 3.0, 2.2}; // mm
constexpr double longestGrain = 200;                          // mm
constexpr double margin = 2;                                  // mm, around a label
constexpr int rows = 24;                                      // of places that are tried

double letters(const std::string& line)
{
    return static_cast<double>(std::ranges::count_if(line, [](char c) { return (c & 0xC0) != 0x80; }));
}

double widthOf(const std::vector<std::string>& lines, double height)
{
    double most = 0;
    for (const std::string& line : lines)
        most = std::max(most, letters(line));
    return most * letterWidth * height;
}

/// Whether the segment has a point in the box around 0 with these half sizes.
bool meetsBox(Vec2 a, Vec2 b, const Vec2& half)
{
    double from = 0, to = 1;
    const Vec2 way = b - a;
    for (const int axis : {0, 1}) {
        if (std::abs(way[axis]) < 1e-12) {
            if (std::abs(a[axis]) > half[axis])
                return false;
            continue;
        }
        const double t1 = (-half[axis] - a[axis]) / way[axis], t2 = (half[axis] - a[axis]) / way[axis];
        from = std::max(from, std::min(t1, t2));
        to = std::min(to, std::max(t1, t2));
    }
    return from <= to;
}

/// A piece turned so that the lines of its label run along x: what a label must not lie on.
class Room {
public:
    Room(const CutPiece& piece, double rotation, const std::vector<std::pair<Vec2, Vec2>>& avoided = {})
        : m_back(rotation * std::numbers::pi / 180)
    {
        const Eigen::Rotation2Dd turn(-m_back.angle());
        const auto turned = [&](const Vec2& point) { return Vec2(turn * point); };
        for (std::size_t i = 0; i < piece.sew.size(); ++i) {
            m_outline.push_back({turned(piece.sew[i].at), false});
            m_box.extend(m_outline.back().at);
            addSegment(m_outline.back().at, turned(piece.sew[(i + 1) % piece.sew.size()].at));
        }
        for (const PieceLine& line : piece.inner)
            for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
                addSegment(turned(line.points[i].at), turned(line.points[i + 1].at));
        for (const CutHole& hole : piece.holes)
            addSegment(turned(hole.at), turned(hole.at) + Vec2(0, 1e-6));
        if (piece.grain.from != piece.grain.to)
            addSegment(turned(piece.grain.from), turned(piece.grain.to));
        for (const auto& [a, b] : avoided)
            addSegment(turned(a), turned(b));
    }

    bool fits(const Vec2& middle, const Vec2& half) const
    {
        for (const auto& [a, b] : m_segments)
            if (meetsBox(a - middle, b - middle, half))
                return false;
        return isInside(m_outline, middle);
    }

    /// The place nearest to the middle where a box of this size fits, in the piece's coordinates.
    std::optional<Vec2> find(const Vec2& size) const
    {
        std::optional<Vec2> best;
        double nearest = 0;
        const Vec2 half = size / 2 + Vec2(margin, margin), step = m_box.sizes() / rows;
        for (int i = 1; i < rows; ++i)
            for (int k = 1; k < rows; ++k) {
                const Vec2 place = m_box.min() + Vec2(i * step.x(), k * step.y());
                const double off = (place - m_box.center()).squaredNorm();
                if ((!best || off < nearest) && fits(place, half)) {
                    best = place;
                    nearest = off;
                }
            }
        if (best)
            best = Vec2(m_back * *best);
        return best;
    }

    bool fitsAt(const Vec2& middle, const Vec2& size) const { return fits(m_back.inverse() * middle, size / 2); }

private:
    void addSegment(const Vec2& a, const Vec2& b) { m_segments.emplace_back(a, b); }

    Eigen::Rotation2Dd m_back;
    std::vector<LinePoint> m_outline;
    std::vector<std::pair<Vec2, Vec2>> m_segments;
    Box2 m_box;
};

/// The longest part of a line at this distance from 0 that lies inside; x runs along it.
std::pair<double, double> longestInside(const std::vector<Vec2>& outline, double y)
{
    std::vector<double> crossings;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
        if ((a.y() > y) != (b.y() > y))
            crossings.push_back(a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()));
    }
    std::ranges::sort(crossings);
    std::pair<double, double> best;
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
        if (crossings[k + 1] - crossings[k] > best.second - best.first)
            best = {crossings[k], crossings[k + 1]};
    return best;
}

} // namespace

GrainLine placeGrain(const CutPiece& piece, double grain)
{
    const Eigen::Rotation2Dd turn(grain * std::numbers::pi / 180);
    std::vector<Vec2> outline;
    Box2 box;
    for (const LinePoint& point : piece.sew) {
        outline.push_back(turn.inverse() * point.at);
        box.extend(outline.back());
    }
    GrainLine line;
    line.nap = piece.nap;
    std::pair<double, double> best;
    double height = 0;
    if (box.isEmpty())
        return line;
    // Beside the middle, where the label wants to be, unless it is much longer elsewhere.
    for (const double share : {0.35, 0.65, 0.25, 0.75, 0.5, 0.15, 0.85}) {
        const double y = box.min().y() + share * box.sizes().y();
        const auto there = longestInside(outline, y);
        if (there.second - there.first > 1.25 * (best.second - best.first)) {
            best = there;
            height = y;
        }
    }
    const double middle = (best.first + best.second) / 2;
    const double half = std::min(0.7 * (best.second - best.first), longestGrain) / 2;
    line.from = turn * Vec2(middle - half, height);
    line.to = turn * Vec2(middle + half, height);
    return line;
}

PieceLabel placeLabel(const CutPiece& piece, std::vector<std::string> lines, double grain,
                      const std::vector<std::pair<Vec2, Vec2>>& avoided)
{
    PieceLabel label;
    label.lines = std::move(lines);
    const double upright = grain - 90;
    label.rotation = upright;
    for (const double rotation : {upright, upright - 90}) {
        const Room room(piece, rotation, avoided);
        for (const double height : lineHeights) {
            const Vec2 size(widthOf(label.lines, height), height * static_cast<double>(label.lines.size()));
            if (const auto place = room.find(size)) {
                label.at = *place;
                label.rotation = rotation;
                label.height = height;
                label.width = size.x();
                return label;
            }
        }
    }
    label.fits = false;
    label.at = piece.box().center();
    label.height = lineHeights.back();
    label.width = widthOf(label.lines, label.height);
    return label;
}

PieceLabel placeLabel(const CutPiece& piece, std::vector<std::string> lines, const PieceLabelPlace& place)
{
    PieceLabel label;
    label.lines = std::move(lines);
    label.at = piece.grown * place.position;
    label.rotation = place.rotation;
    label.byHand = true;
    const Room room(piece, place.rotation);
    label.fits = false;
    for (const double height : lineHeights) {
        label.height = height;
        label.width = widthOf(label.lines, height);
        if (room.fitsAt(label.at, {label.width, height * static_cast<double>(label.lines.size())})) {
            label.fits = true;
            break;
        }
    }
    return label;
}

} // namespace bolster
