#include "FoundPieces.h"

#include "DrawnWords.h"
#include "LayerRole.h"
#include "PieceNotches.h"
#include "PieceTexts.h"
#include "PointGrid.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace bolster {

namespace {

constexpr double sameVertex = 0.05; // mm: a turn point and its vertex
constexpr double widestAllowance = 80;
constexpr double evenAllowance = 0.35; // of its width: how much a line may come nearer and be an allowance still
constexpr std::size_t mostNotches = 5000;

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

/// Whether all of the inner line lies inside the outer one, or on it.
bool isWithin(const Contour& inner, const Contour& outer)
{
    const Box2 a = inner.box(), b = outer.box();
    if ((a.min().array() < b.min().array() - sameVertex).any() ||
        (a.max().array() > b.max().array() + sameVertex).any())
        return false;
    const std::size_t step = std::max<std::size_t>(1, inner.points.size() / 64);
    for (std::size_t i = 0; i < inner.points.size(); i += step)
        if (!outer.contains(inner.points[i].at) && outer.distance(inner.points[i].at) > sameVertex)
            return false;
    return true;
}

/// Whether the inner line follows the outer one at a distance, as a sewing line does.
bool followsWithin(const Contour& inner, const Contour& outer)
{
    if (!isWithin(inner, outer))
        return false;
    std::vector<double> distances;
    const std::size_t step = std::max<std::size_t>(1, inner.points.size() / 200);
    for (std::size_t i = 0; i < inner.points.size(); i += step) {
        const Vec2 &a = inner.points[i].at, &b = inner.points[(i + 1) % inner.points.size()].at;
        distances.push_back(outer.distance((a + b) / 2));
    }
    std::ranges::sort(distances);
    const double middle = distances[distances.size() / 2];
    return distances.back() < widestAllowance && distances.back() <= middle * (1 + evenAllowance) + 0.5 &&
           distances.front() >= middle * (1 - evenAllowance) - 0.5 && outer.signedArea() < 4 * inner.signedArea();
}

/// The lines of one part, by what they are for.
class PartReader {
public:
    PartReader(const DrawnPart& part, const PieceOrder& order, FoundPattern& pattern)
        : m_part(part)
        , m_order(order)
        , m_pattern(pattern)
    {
        for (const DrawnLine& line : part.lines)
            if (const LayerRole copy = boundaryCopyOf(layerRole(line.layer)); copy != LayerRole::Unknown)
                m_replaced.insert(copy);
        for (const DrawnLine& line : part.lines)
            sortLine(line);
    }

    void read(FoundPiece about)
    {
        m_about = std::move(about);
        std::vector<Contour> cut = joined(m_cut), sew = joined(m_sew), unknown = joined(m_unknown);
        std::vector<FoundLine> inner = innerLines();
        if (cut.empty() && sew.empty()) {
            findOutermost(unknown, cut, sew, inner);
        } else {
            if (cut.empty())
                cut.swap(sew);
            else
                m_saysCut = true;
            for (Contour& line : unknown)
                inner.push_back({std::move(line), false});
            moveInner(cut, inner);
        }
        makePieces(std::move(cut), std::move(sew));
        distribute(std::move(inner));
    }

private:
    void sortLine(const DrawnLine& line)
    {
        LayerRole role = layerRole(line.layer);
        if (const LayerRole copy = boundaryCopyOf(role); copy != LayerRole::Unknown)
            role = copy;
        else if (m_replaced.contains(role))
            return;
        DrawnLine scaled = line;
        for (DrawnPoint& point : scaled.points)
            point.at *= m_order.unit;
        scaled.circle *= m_order.unit;
        switch (role) {
        case LayerRole::Cut:
            m_cut.push_back(std::move(scaled));
            break;
        case LayerRole::Sew:
            m_sew.push_back(std::move(scaled));
            break;
        case LayerRole::Notch:
            m_notches.push_back(std::move(scaled));
            break;
        case LayerRole::Grain:
            m_grain.push_back(std::move(scaled));
            break;
        case LayerRole::Hole:
            m_holes.push_back(std::move(scaled));
            break;
        case LayerRole::Internal:
            m_internal.push_back(std::move(scaled));
            break;
        case LayerRole::InternalCut:
            m_internalCut.push_back(std::move(scaled));
            break;
        case LayerRole::Ignored:
        case LayerRole::Turn:
        case LayerRole::Curve:
        case LayerRole::Text:
            ++m_pattern.ignored;
            break;
        default:
            m_unknown.push_back(std::move(scaled));
        }
    }

    std::vector<Contour> joined(std::vector<DrawnLine>& lines)
    {
        JoinOrder join;
        join.largestGap = m_order.largestGap;
        return joinedLines(std::move(lines), join, m_pattern.doubled);
    }

    std::vector<FoundLine> innerLines()
    {
        std::vector<FoundLine> found;
        int none = 0;
        for (Contour& line : joinedLines(std::move(m_internal), {}, none))
            found.push_back({std::move(line), false});
        for (Contour& line : joinedLines(std::move(m_internalCut), {}, none))
            found.push_back({std::move(line), true});
        m_pattern.doubled += none;
        return found;
    }

    /// Nobody says what the lines are: those in no other one are pieces; what follows a piece inside is its sewing
    /// line.
    void findOutermost(std::vector<Contour>& lines, std::vector<Contour>& cut, std::vector<Contour>& sew,
                       std::vector<FoundLine>& inner)
    {
        std::ranges::stable_sort(lines, [](const Contour& a, const Contour& b) {
            return std::pair(a.closed, a.signedArea()) > std::pair(b.closed, b.signedArea());
        });
        for (Contour& line : lines) {
            const auto outer =
                std::ranges::find_if(cut, [&](const Contour& piece) { return isWithin(line, piece); });
            if (!line.closed && outer == cut.end())
                isOutline(line) ? m_pattern.open.push_back(std::move(line))
                                : inner.push_back({std::move(line), false});
            else if (outer == cut.end())
                cut.push_back(std::move(line));
            else if (line.closed && !line.circle && followsWithin(line, *outer) &&
                     std::ranges::none_of(sew, [&](const Contour& other) { return isWithin(other, *outer); }))
                sew.push_back(std::move(line));
            else
                inner.push_back({std::move(line), false});
        }
    }

    /// An open line that encloses something, if it only were closed.
    static bool isOutline(const Contour& line)
    {
        const Vec2 size = line.box().sizes();
        return line.points.size() > 2 && line.gap < 0.25 * size.norm();
    }

    /// Cut lines inside of others are holes; open ones are told.
    void moveInner(std::vector<Contour>& cut, std::vector<FoundLine>& inner)
    {
        std::vector<Contour> pieces;
        std::ranges::stable_sort(cut, [](const Contour& a, const Contour& b) {
            return std::pair(a.closed, a.signedArea()) > std::pair(b.closed, b.signedArea());
        });
        for (Contour& line : cut)
            if (!line.closed)
                m_pattern.open.push_back(std::move(line));
            else if (std::ranges::any_of(pieces, [&](const Contour& piece) { return isWithin(line, piece); }))
                inner.push_back({std::move(line), true});
            else
                pieces.push_back(std::move(line));
        cut = std::move(pieces);
    }

    void makePieces(std::vector<Contour> cut, std::vector<Contour> sew)
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
            m_pattern.pieces.push_back(std::move(piece));
        }
        for (Contour& line : sew) {
            if (!line.closed) {
                m_pattern.open.push_back(std::move(line));
                continue;
            }
            FoundPiece* owner = ownerOf(line);
            if (owner && (!owner->sew || owner->sew->signedArea() < line.signedArea())) {
                for (const std::string& words : line.about)
                    readKey(words, *owner);
                owner->sew = std::move(line);
            }
        }
        markCorners();
    }

    FoundPiece* ownerOf(const Contour& line)
    {
        for (std::size_t i = m_first; i < m_pattern.pieces.size(); ++i)
            if (isWithin(line, m_pattern.pieces[i].cut))
                return &m_pattern.pieces[i];
        return nullptr;
    }

    /// The piece in which a point lies; where there is one alone, that.
    FoundPiece* ownerOf(const Vec2& at)
    {
        std::vector<FoundPiece>& pieces = m_pattern.pieces;
        if (pieces.size() == m_first + 1 && !m_part.name.empty())
            return &pieces.back();
        FoundPiece* nearest = nullptr;
        double least = 5; // mm
        for (std::size_t i = m_first; i < pieces.size(); ++i) {
            if (pieces[i].cut.contains(at))
                return &pieces[i];
            if (!pieces[i].cut.box().isEmpty() && pieces[i].cut.box().exteriorDistance(at) < least)
                if (const double distance = pieces[i].cut.distance(at); distance < least) {
                    least = distance;
                    nearest = &pieces[i];
                }
        }
        return nearest;
    }

    void distribute(std::vector<FoundLine> inner)
    {
        for (FoundLine& line : inner)
            if (FoundPiece* owner = ownerOf(middleOf(line.line)))
                owner->inner.push_back(std::move(line));
            else
                ++m_pattern.ignored;
        for (const DrawnLine& line : m_grain)
            if (FoundPiece* owner = ownerOf((line.points.front().at + line.points.back().at) / 2))
                addGrain(*owner, line.points.back().at - line.points.front().at);
        for (const DrawnLine& line : m_holes)
            if (FoundPiece* owner = ownerOf(centreOf(line)))
                owner->holes.push_back({centreOf(line), 2 * line.circle});
        for (DrawnLine& line : m_notches)
            addNotch(std::move(line));
        addDots();
        addLabels();
        for (std::size_t i = m_first; i < m_pattern.pieces.size(); ++i)
            pairDoubles(m_pattern.pieces[i].notches);
    }

    static Vec2 middleOf(const Contour& line) { return line.points[line.points.size() / 2].at; }
    static Vec2 centreOf(const DrawnLine& line)
    {
        Box2 box;
        for (const DrawnPoint& point : line.points)
            box.extend(point.at);
        return box.center();
    }

    /// The longest line tells, not its arrow heads.
    void addGrain(FoundPiece& piece, const Vec2& way)
    {
        double& longest = m_longestGrain[&piece - m_pattern.pieces.data()];
        if (way.norm() <= longest)
            return;
        longest = way.norm();
        piece.grain = std::atan2(way.y(), way.x()) * 180 / std::numbers::pi;
    }

    void addNotch(DrawnLine line)
    {
        Contour contour;
        contour.points = std::move(line.points);
        contour.closed = line.closed;
        FoundPiece* owner = ownerOf(contour.points.front().at);
        if (!owner || owner->notches.size() >= mostNotches)
            return;
        if (const auto notch = notchOfLine(contour, owner->cut))
            owner->notches.push_back(*notch);
        else
            ++m_pattern.ignored;
    }

    void addDots()
    {
        for (const DrawnDot& dot : m_part.dots) {
            const Vec2 at = m_order.unit * dot.at;
            switch (layerRole(dot.layer)) {
            case LayerRole::Turn:
            case LayerRole::Curve:
                break;
            case LayerRole::Notch:
                if (FoundPiece* owner = ownerOf(at); owner && owner->notches.size() < mostNotches)
                    owner->notches.push_back(notchOfDot(dot, m_order.unit));
                break;
            case LayerRole::Hole:
                if (FoundPiece* owner = ownerOf(at))
                    owner->holes.push_back({at, std::abs(dot.height) * m_order.unit});
                break;
            default:
                ++m_pattern.ignored;
            }
        }
    }

    /// Words inside of pieces that nothing else is known of.
    void addLabels()
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
    void markCorners()
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
            markCorners(m_pattern.pieces[i].cut, grid, dots);
            if (m_pattern.pieces[i].sew)
                markCorners(*m_pattern.pieces[i].sew, grid, dots);
        }
    }

    static void markCorners(Contour& line, const PointGrid& grid, const std::vector<std::pair<Vec2, bool>>& dots)
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

    const DrawnPart& m_part;
    const PieceOrder& m_order;
    FoundPattern& m_pattern;
    FoundPiece m_about;
    std::set<LayerRole> m_replaced;
    bool m_saysCut = false;
    std::size_t m_first = 0;
    std::map<std::ptrdiff_t, double> m_longestGrain;
    std::vector<DrawnLine> m_cut, m_sew, m_unknown, m_notches, m_grain, m_holes, m_internal, m_internalCut;
};

/// What the texts of a block say of its piece; the block's name otherwise.
FoundPiece aboutPart(const DrawnPart& part)
{
    FoundPiece about;
    if (part.name.empty())
        return about;
    for (const DrawnText& text : part.texts)
        readKey(text.words, about);
    if (about.name.empty()) {
        about.name = part.name;
        std::string ending("_");
        ending.append(about.size);
        if (!about.size.empty() && about.name.size() > ending.size() && about.name.ends_with(ending))
            about.name.erase(about.name.size() - ending.size());
    }
    return about;
}

void readStyle(const Drawing& drawing, FoundPattern& pattern)
{
    for (const std::string& words : drawing.texts) {
        const auto [key, value] = keyAndValue(words);
        if (key == "style name" && pattern.style.empty())
            pattern.style = value;
        else if (key == "version")
            pattern.version = value;
        else if (key == "sample size")
            pattern.sampleSize = value;
    }
}

void nameTheRest(FoundPattern& pattern)
{
    int count = 0;
    for (FoundPiece& piece : pattern.pieces) {
        ++count;
        if (piece.name.empty())
            piece.name = std::string("Piece ").append(std::to_string(count));
        if (piece.note == "mirrored")
            piece.note.clear();
    }
}

} // namespace

FoundPattern findPieces(const Drawing& drawing, const PieceOrder& order)
{
    FoundPattern pattern;
    readStyle(drawing, pattern);
    std::vector<FoundPiece> about;
    for (const DrawnPart& part : drawing.parts) {
        about.push_back(aboutPart(part));
        const std::string& size = about.back().size;
        if (!size.empty() && std::ranges::find(pattern.sizes, size) == pattern.sizes.end())
            pattern.sizes.push_back(size);
    }
    if (std::ranges::find(pattern.sizes, pattern.sampleSize) == pattern.sizes.end())
        pattern.sampleSize = pattern.sizes.empty() ? "" : pattern.sizes.front();
    const std::string& wanted = order.size.empty() ? pattern.sampleSize : order.size;
    for (std::size_t i = 0; i < drawing.parts.size(); ++i)
        if (about[i].size.empty() || about[i].size == wanted)
            PartReader(drawing.parts[i], order, pattern).read(about[i]);
    nameTheRest(pattern);
    return pattern;
}

double guessedUnit(const Drawing& drawing)
{
    if (drawing.unit)
        return *drawing.unit;
    bool english = false;
    for (const std::string& words : drawing.texts)
        if (const auto [key, value] = keyAndValue(words); key == "units")
            english = lowered(value) == "english";
    double largest = 0;
    for (const DrawnPart& part : drawing.parts) {
        Box2 box;
        for (const DrawnLine& line : part.lines)
            for (const DrawnPoint& point : line.points)
                box.extend(point.at);
        if (!box.isEmpty())
            largest = std::max(largest, box.sizes().maxCoeff());
    }
    if (english)
        return 25.4;
    // Metric is millimetres for some programs and centimetres for others. Nobody sews a pattern of 12 cm, few one
    // of 12 m.
    return largest > 0 && largest < 120 ? 10 : 1;
}

} // namespace bolster
