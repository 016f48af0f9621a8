#include "CutPattern.h"

#include "CutMarks.h"
#include "CutNotches.h"
#include "DesignCheck.h"
#include "FabricShown.h"
#include "PieceLayout.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

namespace bolster {

namespace {

constexpr double samePlace = 0.1;      // mm
constexpr double sameParameter = 1e-6; // of the period

std::string counted(std::string words, int count)
{
    for (std::size_t at = words.find("%1"); at != std::string::npos; at = words.find("%1"))
        words.replace(at, 2, std::to_string(count));
    return words;
}

/// What fabric has to be larger by, so that it has its size when it has shrunk.
Eigen::Matrix2d growth(const Fabric* fabric, double grain)
{
    if (!fabric)
        return Eigen::Matrix2d::Identity();
    const auto factor = [](double percent) { return 1 / (1 - percent / 100); };
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(grain * std::numbers::pi / 180).toRotationMatrix();
    const Eigen::Vector2d factors(factor(fabric->cutting.shrinkAlong), factor(fabric->cutting.shrinkAcross));
    return turn * factors.asDiagonal() * turn.transpose();
}

class PieceMaker {
public:
    PieceMaker(const Design& design, const CutOptions& options, const CutMarks& marks, ElementId id,
               const Patch& patch)
        : m_design(design)
        , m_options(options)
        , m_marks(marks)
        , m_id(id)
        , m_patch(patch)
        , m_fabric(design.find<Fabric>(fabricShown(design, id)))
        , m_grown(growth(m_fabric, patch.grain))
        , m_usual(allowanceOf(design, patch, options.allowance))
    {}

    CutPiece make(const std::vector<NotchPlace>& notches)
    {
        const PieceCutting& cutting = m_patch.cutting;
        m_piece.patch = m_id;
        m_piece.grown = m_grown;
        if (m_fabric) {
            m_piece.shrinkAlong = m_fabric->cutting.shrinkAlong;
            m_piece.shrinkAcross = m_fabric->cutting.shrinkAcross;
        }
        m_piece.name = m_patch.name;
        m_piece.quantity = static_cast<int>(std::ceil(cutting.quantity));
        m_piece.pair = cutting.pair;
        m_piece.nap = cutting.nap;
        m_piece.note = cutting.note;
        m_piece.tolerance = cutting.tolerance;
        m_piece.fabric = fabricShown(m_design, m_id);
        m_piece.fabricName = m_fabric ? m_fabric->name : std::string();
        addLines();
        for (const NotchPlace& place : notches)
            addNotch(place);
        for (const auto& [hole, drilled] : m_marks.holes)
            m_piece.holes.push_back({m_grown * drilled->place.position, drilled->diameter, hole, drilled->name});
        for (const DartMark& dart : m_marks.darts)
            markTip(dart);
        for (const auto& [element, drawn] : m_marks.lines)
            addInner(element, *drawn);
        m_piece.grain = placeGrain(m_piece, m_patch.grain);
        return std::move(m_piece);
    }

private:
    BSpline2 grown(const BSpline2& curve) const
    {
        std::vector<Vec2> points;
        for (const Vec2& point : curve.points())
            points.push_back(m_grown * point);
        return curve.withPoints(std::move(points));
    }

    /// Where a dart ends nothing is cut: a hole says it, short of its tip, so that it lies within the fold. Not
    /// where the fabric between the legs is cut out, and where the designer has drilled one.
    void markTip(const DartMark& dart)
    {
        constexpr double shortOfTip = 10, diameter = 2, taken = 15; // mm
        const Vec2 mouth = (m_patch.outline.at(dart.from) + m_patch.outline.at(dart.to)) / 2;
        const double depth = (mouth - dart.tip).norm();
        if (!(depth > 0))
            return;
        const Vec2 at = dart.tip + std::min(shortOfTip, depth / 4) / depth * (mouth - dart.tip);
        for (const auto& [hole, drilled] : m_marks.holes)
            if ((drilled->place.position - dart.tip).norm() < taken)
                return;
        const Vec2 place = m_grown * at;
        if (isInside(m_piece.cut, place) && distanceTo(m_piece.cut, place) > diameter)
            m_piece.holes.push_back({place, diameter, dart.seam, "dart"});
    }

    void addLines()
    {
        m_piece.outline = grown(m_patch.outline);
        SampleOrder order{m_options.chord, m_usual.width, {}};
        for (const EdgeAllowance& edge : m_marks.edges) {
            order.reach = std::max(order.reach, edge.width);
            order.breaks.push_back(edge.stretch.from);
            order.breaks.push_back(edge.stretch.to);
        }
        std::vector<OutlineSample> samples = sampled(m_patch.outline, order);
        const std::size_t count = samples.size();
        SewingLine line;
        for (std::size_t i = 0; i < count; ++i) {
            const double end = i + 1 < count ? samples[i + 1].parameter : m_patch.outline.domainEnd();
            line.vertices.push_back({m_grown * samples[i].at, widthAt((samples[i].parameter + end) / 2),
                                     samples[i].corner, m_usual.corner});
        }
        for (const CutCorner& corner : m_marks.corners) {
            const Vec2 at = m_patch.outline.at(m_patch.outline.wrapped(corner.place.at));
            for (std::size_t i = 0; i < count; ++i)
                if ((samples[i].at - at).norm() < samePlace)
                    line.vertices[i].join = corner.join;
        }
        if (m_patch.outline.signedArea() < 0)
            turnRound(line);
        for (const SewingLine::Vertex& vertex : line.vertices)
            m_piece.sew.push_back({vertex.at, vertex.corner});
        CutLine cut = cutLineOf(line);
        m_piece.cut = std::move(cut.points);
        m_piece.gaps = std::move(cut.gaps);
    }

    /// The width of an edge is kept at the vertex where it begins.
    static void turnRound(SewingLine& line)
    {
        std::ranges::reverse(line.vertices);
        const double first = line.vertices.front().width;
        for (std::size_t i = 0; i + 1 < line.vertices.size(); ++i)
            line.vertices[i].width = line.vertices[i + 1].width;
        line.vertices.back().width = first;
    }

    double widthAt(double t) const { return m_marks.widthAt(m_patch.outline, t, m_usual.width); }

    void addNotch(const NotchPlace& place)
    {
        const BSpline2& outline = m_patch.outline;
        CutNotch notch;
        notch.sewn = m_grown * outline.at(place.at);
        notch.inwards = inwardsAt(place.at);
        notch.at = onCutLine(notch.sewn, -notch.inwards);
        notch.shape = place.shape;
        notch.twice = place.twice;
        notch.element = place.element;
        notch.seam = place.seam;
        notch.fraction = place.fraction;
        m_piece.notches.push_back(notch);
    }

    /// At right angles to the sewing line; at corners between its two sides, at the mouth of a dart along its leg,
    /// so that both notches are where it is folded.
    Vec2 inwardsAt(double t) const
    {
        const BSpline2& outline = m_patch.outline;
        const double step = 1e-4 * outline.period();
        const auto at = [&](double s) { return Vec2(m_grown * outline.at(outline.wrapped(s))); };
        for (const MouthEnd& end : m_marks.mouthEnds)
            if (std::abs(std::remainder(end.at - t, outline.period())) < sameParameter * outline.period())
                if (const Vec2 leg = at(t + (end.ahead ? step : -step)) - at(t); leg.norm() > 0)
                    return leg.normalized();
        const Vec2 along = (at(t + step) - at(t)).normalized() + (at(t) - at(t - step)).normalized();
        const Vec2 left(-along.y(), along.x());
        const Vec2 inwards = outline.signedArea() < 0 ? Vec2(-left) : left;
        return inwards.norm() > 1e-9 ? Vec2(inwards.normalized()) : Vec2(0, 1);
    }

    /// Where the ray meets the cut line first; the point itself where it lies on it.
    Vec2 onCutLine(const Vec2& from, const Vec2& way) const
    {
        double nearest = std::numeric_limits<double>::infinity();
        const std::vector<LinePoint>& cut = m_piece.cut;
        for (std::size_t i = 0; i < cut.size(); ++i) {
            const Vec2 a = cut[i].at - from, b = cut[(i + 1) % cut.size()].at - from;
            const double sideA = way.x() * a.y() - way.y() * a.x(), sideB = way.x() * b.y() - way.y() * b.x();
            if ((sideA > 0) == (sideB > 0))
                continue;
            const double t = (a + (b - a) * (sideA / (sideA - sideB))).dot(way);
            if (t >= -1e-3)
                nearest = std::min(nearest, std::max(t, 0.0));
        }
        return std::isfinite(nearest) ? Vec2(from + nearest * way) : from;
    }

    void addInner(ElementId id, const PatchCurve& drawn)
    {
        if (drawn.use == LineUse::Ignored || drawn.curve.empty())
            return;
        PieceLine line{{}, grown(drawn.curve), drawn.curve.closed(), drawn.use == LineUse::Cut, id, drawn.name};
        for (const OutlineSample& sample : sampled(drawn.curve, {m_options.chord, 0, {}}))
            line.points.push_back({m_grown * sample.at, sample.corner});
        m_piece.inner.push_back(std::move(line));
    }

    const Design& m_design;
    const CutOptions& m_options;
    const CutMarks& m_marks;
    ElementId m_id;
    const Patch& m_patch;
    const Fabric* m_fabric;
    Eigen::Matrix2d m_grown;
    CutAllowance m_usual;
    CutPiece m_piece;
};

/// What a map has of a patch, or nothing of that kind.
template <class T>
const T& ofPatch(const std::map<ElementId, T>& map, ElementId id)
{
    static const T none{};
    const auto found = map.find(id);
    return found == map.end() ? none : found->second;
}

/// At spaces, in lines about so long as a name; a longer word stays whole.
void addWrapped(const std::string& text, std::vector<std::string>& lines)
{
    constexpr std::size_t longest = 28; // bytes: of letters with accents there are fewer
    std::istringstream words(text);
    bool begun = false;
    for (std::string word; words >> word;) {
        if (begun && lines.back().size() + 1 + word.size() <= longest)
            lines.back().append(" ").append(word);
        else
            lines.push_back(word);
        begun = true;
    }
}

std::vector<std::string> labelLines(const CutPiece& piece, const Patch& patch, const CutPattern& pattern,
                                    const CutWords& words)
{
    std::vector<std::string> lines{piece.name, counted(piece.pair ? words.pair : words.single, piece.quantity)};
    if (!piece.fabricName.empty())
        lines.push_back(piece.fabricName);
    std::string article = pattern.style;
    if (!pattern.version.empty())
        article += (article.empty() ? "" : " ") + pattern.version;
    if (!article.empty())
        lines.push_back(std::move(article));
    addWrapped(patch.cutting.note, lines);
    return lines;
}

} // namespace

CutAllowance allowanceOf(const Design& design, const Patch& patch, std::optional<double> otherwise)
{
    CutAllowance found;
    if (patch.allowance)
        found = *patch.allowance;
    else if (design.settings().cutting.allowance)
        found = *design.settings().cutting.allowance;
    else
        found.width = otherwise.value_or(found.width);
    found.width = possibleWidth(found.width);
    return found;
}

CutPattern cutPattern(const Design& design, const CutOptions& options, const std::stop_token& stop)
{
    const DesignCutting& cutting = design.settings().cutting;
    CutPattern pattern;
    pattern.style = cutting.style.empty() ? options.style : cutting.style;
    pattern.version = cutting.version;
    AutomaticNotches automatic = cutting.notches;
    automatic.spacing = options.notchSpacing.value_or(automatic.spacing);
    const auto notches = notchPlaces(design, automatic, stop);
    const MarksByPatch marks = cutMarks(design);
    design.each<Patch>([&](ElementId id, const Patch& patch) {
        if ((options.only && !options.only->contains(id)) || stop.stop_requested())
            return;
        if (outlineProblem(patch.outline)) {
            pattern.leftOut.push_back(id);
            return;
        }
        CutPiece piece = PieceMaker(design, options, ofPatch(marks, id), id, patch).make(ofPatch(notches, id));
        const bool unfolded = options.unfold && piece.pair;
        if (unfolded)
            piece.pair = false;
        std::vector<std::string> lines = labelLines(piece, patch, pattern, options.words);
        piece.label = patch.cutting.label ? placeLabel(piece, std::move(lines), *patch.cutting.label)
                                          : placeLabel(piece, std::move(lines), patch.grain);
        if (options.faceUp && patch.wrongSideOut) {
            piece = mirroredPiece(std::move(piece));
            piece.mirrored = false;
        }
        pattern.pieces.push_back(piece);
        if (unfolded)
            pattern.pieces.push_back(mirroredPiece(std::move(piece)));
    });
    return pattern;
}

} // namespace bolster
