#include "PieceElements.h"

#include "AllowanceFound.h"
#include "DesignCheck.h"
#include "OutlineFit.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr double largestPieceSize = 1e6; // mm: more than a kilometre is another unit
constexpr double farFromOutline = 60;    // mm: notches that belong to nothing
constexpr double onSewingLine = 0.05;    // mm
constexpr double sameCut = 0.5;          // mm: what nobody cuts more exactly
constexpr double metByRay = 0.005;       // mm
constexpr double farthestAlong = 6;      // times as far as the nearest place: a ray that leads somewhere else
constexpr double nearCorner = 0.1;       // mm: nobody means a place beside it by that
constexpr double usualHole = 3;          // mm
constexpr double smallestHole = 0.1;     // mm: as the rules have it
constexpr double largestHole = 100;      // mm
constexpr double mostPieces = 1000;      // as the rules have it
constexpr std::size_t longestWord = 60;  // of what a file says, in a note

Contour moved(Contour line, const Vec2& by)
{
    for (DrawnPoint& point : line.points)
        point.at += by;
    return line;
}

class PieceBuilder {
public:
    PieceBuilder(const FoundPiece& piece, PatternLines lines, FreshIds& fresh)
        : m_piece(piece)
        , m_lines(lines)
        , m_fresh(fresh)
        , m_bySewing(lines == PatternLines::Sew && piece.sew.has_value())
        , m_line(m_bySewing ? *piece.sew : piece.cut)
        , m_origin(m_line.box().isEmpty() ? Vec2(0, 0) : Vec2(m_line.box().center()))
    {}

    PieceElements build(const Change& fabric)
    {
        if (makeOutline()) {
            tellClosed();
            addPatch(fabric.id);
            addNotches();
            addHoles();
            addInnerLines();
            dropMistakes(fabric);
            tellLost();
        }
        return std::move(m_made);
    }

private:
    void note(const char* sentence, std::vector<std::string> args = {})
    {
        args.insert(args.begin(), m_piece.name);
        m_made.notes.push_back({sentence, std::move(args)});
    }

    bool makeOutline()
    {
        const double size = m_line.box().isEmpty() ? 0 : m_line.box().sizes().maxCoeff();
        if (size > largestPieceSize) {
            note(QT_TRANSLATE_NOOP("Message",
                                   "%1 is left out: it is %2 m large, the most is %3 m; is the unit right?"),
                 {numberText(size / 1000), numberText(largestPieceSize / 1000)});
            return false;
        }
        auto fitted = fittedLine(moved(m_line, -m_origin));
        if (!fitted) {
            note(m_line.points.size() < 3
                     ? QT_TRANSLATE_NOOP("Message", "%1 is left out: its outline has fewer than three points")
                     : QT_TRANSLATE_NOOP("Message", "%1 is left out: of the %2 points of its outline no curve with "
                                                    "at most %3 can be made"),
                 {std::to_string(m_line.points.size()), std::to_string(mostCurvePoints)});
            return false;
        }
        if (outlineProblem(fitted->curve)) {
            note(QT_TRANSLATE_NOOP("Message", "%1 is left out: its outline crosses itself or encloses nothing"));
            return false;
        }
        if (fitted->simplified > 0)
            note(QT_TRANSLATE_NOOP("Message",
                                   "%1: its outline has more than %2 points and is simplified, by %3 mm at "
                                   "most"),
                 {std::to_string(mostCurvePoints), numberText(fitted->simplified)});
        m_outline = std::move(fitted->curve);
        return true;
    }

    void tellClosed()
    {
        const double gap = std::max(m_piece.cut.gap, m_piece.sew ? m_piece.sew->gap : 0.0);
        if (gap > JoinOrder().same)
            note(QT_TRANSLATE_NOOP("Message", "%1: a gap of %2 mm in its outline is closed by a straight line"),
                 {numberText(gap)});
    }

    double quantity()
    {
        if (!m_piece.oddQuantity.empty())
            note(QT_TRANSLATE_NOOP("Message",
                                   "%1: its quantity \"%2\" is no number of pieces; it is cut once until "
                                   "somebody says how often"),
                 {m_piece.oddQuantity});
        if (m_piece.quantity > mostPieces)
            note(QT_TRANSLATE_NOOP("Message", "%1: its quantity %2 is more than possible and becomes %3"),
                 {numberText(m_piece.quantity, 10), numberText(mostPieces)});
        return std::clamp(m_piece.quantity, 1.0, mostPieces);
    }

    /// What the file says that does not become part of the patch.
    void tellWords()
    {
        if (!m_piece.oddNap.empty())
            note(QT_TRANSLATE_NOOP("Message",
                                   "%1: its nap \"%2\" is neither one way, two ways nor any; it is taken for "
                                   "two ways"),
                 {m_piece.oddNap.substr(0, longestWord)});
        if (!m_piece.shrinkage.empty())
            note(QT_TRANSLATE_NOOP("Message",
                                   "%1 is drawn larger by what its fabric shrinks (%2), and taken as it is "
                                   "drawn: a shrinkage of the fabric here would come on top"),
                 {m_piece.shrinkage.substr(0, longestWord)});
    }

    void addPatch(ElementId fabric)
    {
        tellWords();
        Patch patch;
        patch.name = m_piece.name;
        patch.fabric = fabric;
        patch.position = m_origin;
        patch.outline = m_outline;
        if (m_piece.grain)
            patch.grain = *m_piece.grain;
        patch.cutting.quantity = quantity();
        patch.cutting.pair = m_piece.pair;
        patch.cutting.note = m_piece.note;
        patch.cutting.nap = m_piece.nap.value_or(patch.cutting.nap);
        patch.cutting.tolerance = m_piece.tolerance.value_or(patch.cutting.tolerance);
        FoundAllowance allowance;
        allowance.usual.width = 0;
        if (m_bySewing)
            allowance = measuredAllowance();
        if (m_bySewing || m_piece.isCutLine || m_lines == PatternLines::Cut)
            patch.allowance = allowance.usual;
        m_made.patch = add(std::move(patch));
        for (const EdgeWidth& edge : allowance.edges)
            add(EdgeAllowance{{m_made.patch, edge.from, edge.to}, edge.width});
    }

    FoundAllowance measuredAllowance()
    {
        std::vector<Contour> others;
        for (const Contour& line : m_piece.otherSewn)
            others.push_back(moved(line, -m_origin));
        if (!others.empty())
            note(QT_TRANSLATE_NOOP("Message", "%1 has %2 sewing lines beside each other; the largest is taken, the "
                                              "others are left out"),
                 {std::to_string(others.size() + 1)});
        FoundAllowance found = foundAllowance(m_outline, moved(m_piece.cut, -m_origin), others);
        if (found.tooWide > 0)
            note(QT_TRANSLATE_NOOP("Message",
                                   "%1: its cut line lies %2 mm outside of its sewing line, which is wider than "
                                   "an allowance may be; it becomes %3 mm there"),
                 {numberText(found.tooWide), numberText(found.usual.width)});
        else if (others.empty() && found.off > sameCut)
            note(QT_TRANSLATE_NOOP("Message",
                                   "%1: its cut line is drawn anew from its allowances, and differs from "
                                   "that of the file by up to %2 mm"),
                 {numberText(found.off, 2)});
        return found;
    }

    template <class T>
    ElementId add(T value)
    {
        const ElementId id = m_fresh();
        m_made.changes.push_back({id, nullptr, makeElement(std::move(value))});
        return id;
    }

    /// Inwards from the cut line to where the outline is met first, or whatever is nearest.
    BSpline2::Closest sewnPlace(const FoundNotch& notch) const
    {
        const Vec2 at = notch.at - m_origin;
        BSpline2::Closest place = m_outline.closest(at);
        if (notch.inwards && place.distance > onSewingLine) {
            const bool away = notch.inwards->dot(place.point - at) < 0; // some programs have it so
            place = firstMet(at, away ? Vec2(-*notch.inwards) : *notch.inwards, place);
        }
        for (const double corner : m_outline.corners())
            if (const Vec2 point = m_outline.at(corner); (point - place.point).norm() < nearCorner) {
                place.parameter = corner;
                place.point = point;
            }
        place.distance = (place.point - at).norm();
        return place;
    }

    /// As far as the outline is from a place of the ray one may go on along it.
    BSpline2::Closest firstMet(const Vec2& from, const Vec2& way, const BSpline2::Closest& nearest) const
    {
        constexpr int mostSteps = 60;
        double along = nearest.distance;
        for (int step = 0; step < mostSteps && along < farthestAlong * nearest.distance + 1; ++step) {
            const BSpline2::Closest next = m_outline.closest(from + along * way);
            if (next.distance < metByRay)
                return next;
            along += next.distance;
        }
        return nearest;
    }

    void addNotches()
    {
        for (const FoundNotch& notch : m_piece.notches) {
            const BSpline2::Closest place = sewnPlace(notch);
            if (place.distance > farFromOutline)
                ++m_lost;
            else
                add(Notch{{m_made.patch, place.parameter}, notch.shape, notch.twice});
        }
    }

    void addHoles()
    {
        int fitted = 0;
        for (const FoundHole& hole : m_piece.holes) {
            const double diameter = hole.diameter > 0 ? hole.diameter : usualHole;
            const double possible = std::clamp(diameter, smallestHole, largestHole);
            fitted += possible != diameter;
            add(DrillHole{"", {m_made.patch, hole.at - m_origin}, possible});
        }
        if (fitted > 0)
            note(QT_TRANSLATE_NOOP("Message",
                                   "%1: %2 drill holes are narrower than %3 mm or wider than %4 mm and become "
                                   "as wide as possible"),
                 {std::to_string(fitted), numberText(smallestHole), numberText(largestHole)});
    }

    void addInnerLines()
    {
        for (const FoundLine& line : m_piece.inner)
            addInnerLine(line.line, line.cut ? LineUse::Cut : LineUse::Drawn);
        if (!m_bySewing)
            for (const Contour& line : m_piece.otherSewn)
                addInnerLine(line, LineUse::Drawn);
    }

    void addInnerLine(const Contour& line, LineUse use)
    {
        auto curve = fittedLine(moved(line, -m_origin));
        if (!curve) {
            ++m_lost;
            return;
        }
        InternalLine inner;
        inner.patch = m_made.patch;
        inner.curve = std::move(curve->curve);
        inner.use = use;
        add(std::move(inner));
    }

    /// Whatever comes from a stranger: nothing is said to be imported that the rules refuse.
    void dropMistakes(const Change& fabric)
    {
        Edit all{{}, m_made.changes};
        all.changes.push_back(fabric);
        Patch patch = std::get<Patch>(*m_made.changes.front().after);
        patch.position = Vec2::Zero(); // it is laid out later
        all.changes.front().after = makeElement(std::move(patch));
        std::set<ElementId> wrong;
        for (const Problem& problem : checkDesign(Design().with(all)))
            if (problem.severity == Severity::Error && problem.element != settingsId)
                wrong.insert(problem.element);
        if (wrong.contains(m_made.patch)) {
            m_made.notes.clear();
            note(QT_TRANSLATE_NOOP("Message", "%1 is left out: it would be a patch with mistakes"));
            m_made.patch = noElement;
            m_made.changes.clear();
            m_lost = 0;
            return;
        }
        m_lost += static_cast<int>(
            std::erase_if(m_made.changes, [&](const Change& change) { return wrong.contains(change.id); }));
    }

    void tellLost()
    {
        if (m_lost > 0)
            note(QT_TRANSLATE_NOOP("Message", "%1: %2 notches or lines belong to nothing and are left out"),
                 {std::to_string(m_lost)});
    }

    const FoundPiece& m_piece;
    PatternLines m_lines;
    FreshIds& m_fresh;
    bool m_bySewing;
    const Contour& m_line;
    Vec2 m_origin;
    BSpline2 m_outline;
    int m_lost = 0;
    PieceElements m_made;
};

} // namespace

PieceElements pieceElements(const FoundPiece& piece, PatternLines lines, const Change& fabric, FreshIds& fresh)
{
    return PieceBuilder(piece, lines, fresh).build(fabric);
}

} // namespace bolster
