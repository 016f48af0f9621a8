#include "PartReader.h"

#include "DrawnWords.h"
#include "LineWithin.h"
#include "PieceNotches.h"
#include "PieceTexts.h"
#include "PointGrid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

constexpr double nearPiece = 5;           // mm: marks beside a piece that are meant for it
constexpr double longestDrawnNotch = 16;  // mm: of strokes that nobody calls notches
constexpr std::size_t mostNotches = 5000; // of a piece

LayerRole boundaryCopyOf(LayerRole role)
{
    switch (role) {
    case LayerRole::FineCut:
        return LayerRole::Cut;
    case LayerRole::FineSew:
        return LayerRole::Sew;
    case LayerRole::FineInternal:
        return LayerRole::Internal;
    case LayerRole::FineInternalCut:
        return LayerRole::InternalCut;
    default:
        return LayerRole::Unknown;
    }
}

/// An open line that encloses something, if it only were closed.
bool mayBeOutline(const Contour& line)
{
    const Vec2 size = line.box().sizes();
    return line.points.size() > 2 && line.gap < 0.25 * size.norm();
}

Vec2 middleOf(const Contour& line)
{
    return line.points[line.points.size() / 2].at;
}

Vec2 centreOf(const DrawnLine& line)
{
    Box2 box;
    for (const DrawnPoint& point : line.points)
        box.extend(point.at);
    return box.center();
}

Box2 grown(const Box2& box, double by)
{
    return {box.min() - Vec2::Constant(by), box.max() + Vec2::Constant(by)};
}

/// Whether it is as short as notches are, and leads away from where the piece is cut.
bool seemsNotch(const Contour& line, const Contour& cut)
{
    if (line.closed || line.box().sizes().norm() > longestDrawnNotch)
        return false;
    const auto notch = notchOfLine(line, cut);
    return notch && cut.distance(notch->at + notch->shape.depth * *notch->inwards) > 0.5 * notch->shape.depth;
}

void markCornersOf(Contour& line, const PointGrid& grid, const std::vector<std::pair<Vec2, bool>>& dots)
{
    std::size_t met = 0;
    std::vector<Bend> bends;
    for (const DrawnPoint& point : line.points) {
        Bend bend = Bend::Smooth;
        bool found = false;
        grid.near(point.at, [&](std::size_t index) {
            if ((dots[index].first - point.at).norm() > sameVertex)
                return;
            found = true;
            if (dots[index].second)
                bend = Bend::Corner;
        });
        met += found;
        bends.push_back(bend);
    }
    // Where most are those of another line, the rest says nothing of this one.
    const bool mine = 10 * met > 9 * line.points.size() || met == bends.size();
    for (std::size_t i = 0; i < bends.size(); ++i)
        if (mine || bends[i] == Bend::Corner)
            line.points[i].bend = bends[i];
}

} // namespace

PartReader::PartReader(const DrawnPart& part, const PieceOrder& order, bool isSewn, FoundPattern& pattern)
    : m_part(part)
    , m_order(order)
    , m_isSewn(isSewn)
    , m_pattern(pattern)
{
    for (const DrawnLine& line : part.lines)
        if (const LayerRole copy = boundaryCopyOf(layerRole(line.layer)); copy != LayerRole::Unknown)
            m_replaced.insert(copy);
    for (const DrawnLine& line : part.lines)
        sortLine(line);
}

void PartReader::read(FoundPiece about)
{
    m_about = std::move(about);
    std::vector<Contour> cut = joined(m_cut, m_order.largestGap), sew = joined(m_sew, m_order.largestGap);
    std::vector<Contour> unknown = joined(m_unknown, m_order.largestGap);
    std::vector<FoundLine> inner = innerLines();
    if (cut.empty() && sew.empty()) {
        findOutermost(std::move(unknown), cut, sew, inner);
    } else {
        if (cut.empty())
            cut.swap(sew);
        else
            m_saysCut = true;
        for (Contour& line : unknown)
            inner.push_back({std::move(line), false});
        moveInner(cut, inner);
    }
    makePieces(std::move(cut));
    addSewing(std::move(sew), inner);
    if (m_saysCut && !m_isSewn)
        findSewing(inner);
    markCorners();
    distribute(std::move(inner));
}

PartReader::Lines* PartReader::linesFor(LayerRole role)
{
    switch (role) {
    case LayerRole::Cut:
        return &m_cut;
    case LayerRole::Sew:
        return &m_sew;
    case LayerRole::Notch:
        return &m_notches;
    case LayerRole::Grain:
        return &m_grain;
    case LayerRole::Hole:
        return &m_holes;
    case LayerRole::Internal:
        return &m_internal;
    case LayerRole::InternalCut:
        return &m_internalCut;
    case LayerRole::Ignored:
    case LayerRole::Turn:
    case LayerRole::Curve:
    case LayerRole::Text:
        return nullptr;
    default:
        return &m_unknown;
    }
}

void PartReader::sortLine(const DrawnLine& line)
{
    LayerRole role = layerRole(line.layer);
    if (const LayerRole copy = boundaryCopyOf(role); copy != LayerRole::Unknown)
        role = copy;
    else if (m_replaced.contains(role))
        return;
    Lines* lines = linesFor(role);
    if (!lines) {
        ++m_pattern.ignored[line.layer];
        return;
    }
    DrawnLine scaled = line;
    for (DrawnPoint& point : scaled.points)
        point.at *= m_order.unit;
    scaled.circle *= m_order.unit;
    lines->push_back(std::move(scaled));
}

std::vector<Contour> PartReader::joined(Lines& lines, double largestGap)
{
    JoinOrder join;
    join.largestGap = largestGap;
    return joinedLines(std::move(lines), join, m_pattern.doubled);
}

std::vector<FoundLine> PartReader::innerLines()
{
    std::vector<FoundLine> found;
    for (Contour& line : joined(m_internal, 0))
        found.push_back({std::move(line), false});
    for (Contour& line : joined(m_internalCut, 0))
        found.push_back({std::move(line), true});
    return found;
}

/// Nobody says what the lines are: those in no other one are pieces; what follows a piece inside is its sewing
/// line; short strokes from where it is cut are notches.
void PartReader::findOutermost(std::vector<Contour> lines, std::vector<Contour>& cut, std::vector<Contour>& sew,
                               std::vector<FoundLine>& inner)
{
    lines = withBars(std::move(lines));
    sortLargestFirst(lines);
    BoxLevels boxes;
    std::vector<bool> isSewn;
    for (Contour& line : lines) {
        std::size_t outer = cut.size();
        boxes.at(line.points.front().at, [&](std::size_t i) {
            if (i < outer && isWithin(line, cut[i]))
                outer = i;
        });
        if (!line.closed && outer == cut.size()) {
            mayBeOutline(line) ? m_pattern.open.push_back(std::move(line))
                               : inner.push_back({std::move(line), false});
        } else if (outer == cut.size()) {
            boxes.add(grown(line.box(), sameVertex), cut.size());
            cut.push_back(std::move(line));
            isSewn.push_back(false);
        } else if (line.closed && !line.circle && !isSewn[outer] && followsWithin(line, cut[outer])) {
            isSewn[outer] = true;
            sew.push_back(std::move(line));
        } else if (seemsNotch(line, cut[outer])) {
            m_drawnNotches.push_back(std::move(line));
        } else {
            inner.push_back({std::move(line), false});
        }
    }
}

/// Cut lines inside of others are holes; open ones are told.
void PartReader::moveInner(std::vector<Contour>& cut, std::vector<FoundLine>& inner)
{
    std::vector<Contour> pieces;
    sortLargestFirst(cut);
    BoxLevels boxes;
    for (Contour& line : cut) {
        bool isInner = false;
        if (line.closed)
            boxes.at(line.points.front().at,
                     [&](std::size_t i) { isInner = isInner || isWithin(line, pieces[i]); });
        if (!line.closed) {
            m_pattern.open.push_back(std::move(line));
        } else if (isInner) {
            inner.push_back({std::move(line), true});
        } else {
            boxes.add(grown(line.box(), sameVertex), pieces.size());
            pieces.push_back(std::move(line));
        }
    }
    cut = std::move(pieces);
}

void PartReader::makePieces(std::vector<Contour> cut)
{
    m_first = m_pattern.pieces.size();
    const bool several = cut.size() > 1;
    for (Contour& line : cut) {
        FoundPiece piece = m_about;
        if (several && !piece.name.empty())
            piece.name.append(" ").append(std::to_string(m_pattern.pieces.size() - m_first + 1));
        for (const std::string& words : line.about)
            readKey(words, piece);
        piece.isCutLine = m_saysCut;
        piece.cut = std::move(line);
        m_near.add(grown(piece.cut.box(), nearPiece), m_pattern.pieces.size());
        m_pattern.pieces.push_back(std::move(piece));
    }
}

/// Of two in one piece the larger one is where it is sewn; what lies inside of that is a line like others there.
void PartReader::addSewing(std::vector<Contour> sew, std::vector<FoundLine>& inner)
{
    for (Contour& line : sew) {
        if (!line.closed) {
            m_pattern.open.push_back(std::move(line));
            continue;
        }
        FoundPiece* owner = ownerOf(line);
        if (!owner) {
            ++m_pattern.outside[line.layer];
            continue;
        }
        for (const std::string& words : line.about)
            readKey(words, *owner);
        if (owner->sew && owner->sew->signedArea() < line.signedArea())
            std::swap(*owner->sew, line);
        if (owner->sew)
            owner->otherSewn.push_back(std::move(line));
        else
            owner->sew = std::move(line);
    }
    for (std::size_t i = m_first; i < m_pattern.pieces.size(); ++i) {
        FoundPiece& piece = m_pattern.pieces[i];
        std::erase_if(piece.otherSewn, [&](Contour& line) {
            const bool inside = isWithin(line, *piece.sew);
            if (inside)
                inner.push_back({std::move(line), false});
            return inside;
        });
    }
}

/// Some programs write sewing lines among the internal ones.
void PartReader::findSewing(std::vector<FoundLine>& inner)
{
    std::erase_if(inner, [&](FoundLine& found) {
        if (!found.line.closed || found.line.circle || found.cut)
            return false;
        FoundPiece* owner = ownerOf(found.line);
        if (!owner || owner->sew || !followsWithin(found.line, owner->cut))
            return false;
        owner->sew = std::move(found.line);
        return true;
    });
}

FoundPiece* PartReader::ownerOf(const Contour& line)
{
    std::size_t owner = m_pattern.pieces.size();
    m_near.at(line.points.front().at, [&](std::size_t i) {
        if (i < owner && isWithin(line, m_pattern.pieces[i].cut))
            owner = i;
    });
    return owner < m_pattern.pieces.size() ? &m_pattern.pieces[owner] : nullptr;
}

/// The piece in which a point lies, or beside which; where there is one alone, that.
FoundPiece* PartReader::ownerOf(const Vec2& at)
{
    std::vector<FoundPiece>& pieces = m_pattern.pieces;
    if (pieces.size() == m_first + 1 && !m_part.name.empty())
        return &pieces.back();
    std::pair<double, std::size_t> nearest(nearPiece, pieces.size()); // distance, 0 inside
    m_near.at(at, [&](std::size_t i) {
        const double distance = pieces[i].cut.contains(at) ? 0 : pieces[i].cut.distance(at);
        nearest = std::min(nearest, std::pair(distance, i));
    });
    return nearest.second < pieces.size() ? &pieces[nearest.second] : nullptr;
}

void PartReader::distribute(std::vector<FoundLine> inner)
{
    for (FoundLine& line : inner)
        if (FoundPiece* owner = ownerOf(middleOf(line.line)))
            owner->inner.push_back(std::move(line));
        else
            ++m_pattern.outside[line.line.layer];
    addGrains();
    for (const DrawnLine& line : m_holes)
        if (FoundPiece* owner = ownerOf(centreOf(line)))
            owner->holes.push_back({centreOf(line), 2 * line.circle});
        else
            ++m_pattern.outside[line.layer];
    addNotches(withBars(joined(m_notches, 0)));
    addNotches(std::move(m_drawnNotches));
    addDots();
    addLabels();
    for (std::size_t i = m_first; i < m_pattern.pieces.size(); ++i)
        pairDoubles(m_pattern.pieces[i].notches);
}

void PartReader::addGrains()
{
    for (const DrawnLine& line : m_grain)
        if (FoundPiece* owner = ownerOf((line.points.front().at + line.points.back().at) / 2))
            addGrain(*owner, line.points.back().at - line.points.front().at);
        else
            ++m_pattern.outside[line.layer];
}

/// The longest line tells, not its arrow heads.
void PartReader::addGrain(FoundPiece& piece, const Vec2& way)
{
    double& longest = m_longestGrain[&piece - m_pattern.pieces.data()];
    if (way.norm() <= longest)
        return;
    longest = way.norm();
    piece.grain = std::atan2(way.y(), way.x()) * 180 / std::numbers::pi;
}

void PartReader::addNotches(std::vector<Contour> lines)
{
    for (const Contour& line : lines) {
        FoundPiece* owner = ownerOf(line.points.front().at);
        if (!owner)
            ++m_pattern.outside[line.layer];
        else if (const auto notch = notchOfLine(line, owner->cut))
            addNotch(*owner, *notch, line.layer);
        else
            ++m_pattern.ignored[line.layer];
    }
}

void PartReader::addNotch(FoundPiece& piece, const FoundNotch& notch, const std::string& layer)
{
    if (piece.notches.size() < mostNotches)
        piece.notches.push_back(notch);
    else
        ++m_pattern.ignored[layer];
}

void PartReader::addDots()
{
    for (const DrawnDot& dot : m_part.dots) {
        const LayerRole role = layerRole(dot.layer);
        if (role == LayerRole::Turn || role == LayerRole::Curve)
            continue;
        const Vec2 at = m_order.unit * dot.at;
        FoundPiece* owner = role == LayerRole::Notch || role == LayerRole::Hole ? ownerOf(at) : nullptr;
        if (role != LayerRole::Notch && role != LayerRole::Hole)
            ++m_pattern.ignored[dot.layer];
        else if (!owner)
            ++m_pattern.outside[dot.layer];
        else if (role == LayerRole::Notch)
            addNotch(*owner, notchOfDot(dot, m_order.unit), dot.layer);
        else
            owner->holes.push_back({at, std::abs(dot.height) * m_order.unit});
    }
}

/// Words inside of pieces that nothing else is known of.
void PartReader::addLabels()
{
    std::map<FoundPiece*, std::vector<std::string>> labels;
    for (const DrawnText& text : m_part.texts)
        if (keyAndValue(text.words).first.empty() && m_part.name.empty())
            if (FoundPiece* owner = ownerOf(Vec2(m_order.unit * text.at)); owner && owner->name.empty())
                labels[owner].push_back(text.words);
    for (const auto& [piece, lines] : labels)
        readLabel(lines, *piece);
}

/// Where the file has turn points and curve points, they say where corners are.
void PartReader::markCorners()
{
    PointGrid grid(sameVertex);
    std::vector<std::pair<Vec2, bool>> dots;
    for (const DrawnDot& dot : m_part.dots) {
        const LayerRole role = layerRole(dot.layer);
        if (role == LayerRole::Turn || role == LayerRole::Curve) {
            dots.emplace_back(m_order.unit * dot.at, role == LayerRole::Turn);
            grid.add(dots.back().first, dots.size() - 1);
        }
    }
    for (std::size_t i = m_first; i < m_pattern.pieces.size() && !dots.empty(); ++i) {
        markCornersOf(m_pattern.pieces[i].cut, grid, dots);
        if (m_pattern.pieces[i].sew)
            markCornersOf(*m_pattern.pieces[i].sew, grid, dots);
    }
}

} // namespace bolster
