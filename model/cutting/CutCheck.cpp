#include "CutCheck.h"

#include "CutMarks.h"
#include "DesignCheck.h"
#include "FoldedSeam.h"
#include "SegmentDistance.h"
#include "SewnPair.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

constexpr double sameLength = 1;       // mm
constexpr double sameShare = 0.005;    // of the length
constexpr double sameAllowance = 0.05; // mm
constexpr double sharpest = 30;        // degrees outside of an inner corner
constexpr double sameTip = 0.5;        // mm
constexpr double leastBeyondNotch = 1; // mm from a notch to the sewing line
constexpr double mostBeyond = 0.1;     // mm that a line may reach out of its piece
constexpr double thinnest = 3;         // mm between the tip of a dart and another edge
constexpr double sameEnd = 1e-6;       // of an outline's parameter

class Check {
public:
    Check(const Design& design, const CutPattern& pattern)
        : m_design(design)
        , m_marks(cutMarks(design))
    {
        for (const CutPiece& piece : pattern.pieces)
            m_pieces[piece.patch].push_back(&piece);
    }

    std::vector<CutFinding> run(const std::stop_token& stop)
    {
        m_design.each<Seam>([&](ElementId id, const Seam& seam) {
            if (stop.stop_requested())
                return;
            lengths(id, seam);
            allowances(id, seam);
            if (const std::optional<FoldedSides> dart = foldedSides(m_design, seam))
                m_tips[dart->patch].push_back(dart->tip);
        });
        for (const auto& [patch, pieces] : m_pieces)
            for (const CutPiece* piece : pieces)
                if (!piece->mirrored && !stop.stop_requested())
                    look(*piece);
        std::ranges::stable_sort(m_found, [](const CutFinding& a, const CutFinding& b) {
            return a.harm != b.harm ? a.harm < b.harm : a.amount > b.amount;
        });
        return std::move(m_found);
    }

private:
    struct Weight {
        CutHarm harm;
        double amount = 0;
    };

    void add(ElementId id, ElementId patch, const Vec2& place, const Weight& weight, Message message)
    {
        const ElementPtr element = m_design.element(id);
        m_found.push_back(
            {{id, element ? labelOf(id, *element) : std::string(), "", std::move(message), Severity::Warning},
             patch,
             place,
             weight.harm,
             weight.amount});
    }
    void add(ElementId id, const CutPiece& piece, const Vec2& place, const Weight& weight, Message message)
    {
        add(id, piece.patch, piece.shrunk(place), weight, std::move(message));
    }

    /// Two widths at one seam: one side would be sewn beside its line.
    void allowances(ElementId id, const Seam& seam)
    {
        const SewnPair pair(m_design, seam);
        if (!pair.usable() || !isCut(seam.a.patch) || !isCut(seam.b.patch))
            return;
        const double a = allowanceAt(m_design, m_marks, {seam.a.patch, pair.onA(0.5)}, std::nullopt);
        const double b = allowanceAt(m_design, m_marks, {seam.b.patch, pair.onB(0.5)}, std::nullopt);
        if (std::abs(a - b) > sameAllowance)
            add(id, seam.a.patch, pair.outlineA().at(pair.outlineA().wrapped(pair.onA(0.5))),
                {CutHarm::DoesNotFit, std::abs(a - b)},
                {QT_TRANSLATE_NOOP("Message",
                                   "its sides have allowances of %1 mm and %2 mm: make them alike, or mind it "
                                   "when they are laid together"),
                 {numberText(a), numberText(b)}});
    }

    /// Seams have no names: those of their patches.
    std::string labelOf(ElementId id, const Element& element) const
    {
        const Seam* seam = std::get_if<Seam>(&element);
        if (!seam)
            return elementLabel(id, element);
        const auto name = [this](ElementId patch) {
            const Patch* found = m_design.find<Patch>(patch);
            return found ? found->name : std::string();
        };
        return elementLabel(id, element) + " (" + name(seam->a.patch) + " \u2013 " + name(seam->b.patch) + ")";
    }

    bool isCut(ElementId patch) const { return m_pieces.contains(patch); }

    void lengths(ElementId id, const Seam& seam)
    {
        const SewnPair pair(m_design, seam);
        if (!pair.usable() || !isCut(seam.a.patch) || !isCut(seam.b.patch))
            return;
        const double difference = pair.lengthB() - pair.lengthA();
        if (std::abs(difference - seam.ease) <= std::max(sameLength, sameShare * pair.length()))
            return;
        const std::string a = numberText(std::round(10 * pair.lengthA()) / 10);
        const std::string b = numberText(std::round(10 * pair.lengthB()) / 10);
        Message message{QT_TRANSLATE_NOOP("Message", "its sides are %1 mm and %2 mm long: true the seam, or say in "
                                                     "its properties how much ease is wanted"),
                        {a, b}};
        if (seam.ease != 0)
            message = {QT_TRANSLATE_NOOP("Message",
                                         "its sides are %1 mm and %2 mm long, but the second one shall be longer "
                                         "by %3 mm: true the seam, or change the ease in its properties"),
                       {a, b, numberText(seam.ease)}};
        add(id, seam.a.patch, pair.outlineA().at(pair.outlineA().wrapped(pair.onA(0.5))),
            {CutHarm::DoesNotFit, std::abs(difference - seam.ease)}, std::move(message));
    }

    void look(const CutPiece& piece)
    {
        notches(piece);
        if (!piece.label.fits)
            add(piece.patch, piece, piece.label.at, {CutHarm::Inconvenient},
                {QT_TRANSLATE_NOOP("Message",
                                   "its label finds no room: make the words shorter, or put it elsewhere")});
        for (const Vec2& gap : piece.gaps)
            add(piece.patch, piece, gap, {CutHarm::CannotBeCut},
                {QT_TRANSLATE_NOOP("Message", "its cut lines meet here: make the allowance smaller")});
        width(piece);
        corners(piece);
        beyond(piece);
        tips(piece);
    }

    /// What is cut or drilled outside of the piece is cut from somebody else's.
    void beyond(const CutPiece& piece)
    {
        for (const PieceLine& line : piece.inner) {
            const auto outside = std::ranges::find_if(line.points, [&](const LinePoint& point) {
                return !isInside(piece.cut, point.at) && distanceTo(piece.cut, point.at) > mostBeyond;
            });
            if (outside != line.points.end())
                add(line.element, piece, outside->at, {line.cut ? CutHarm::CannotBeCut : CutHarm::Inconvenient},
                    {QT_TRANSLATE_NOOP("Message", "it reaches beyond its piece: end it at the edge")});
        }
        for (const CutHole& hole : piece.holes)
            if (isInside(piece.cut, hole.at) && distanceTo(piece.cut, hole.at) < hole.diameter / 2)
                add(hole.element, piece, hole.at, {CutHarm::Weakened},
                    {QT_TRANSLATE_NOOP("Message", "the hole breaks through the edge of its piece: move it inwards, "
                                                  "or make it smaller")});
    }

    /// Of darts that leave hardly anything of the piece together.
    void tips(const CutPiece& piece)
    {
        const auto tips = m_tips.find(piece.patch);
        if (tips == m_tips.end())
            return;
        for (const Vec2& tip : tips->second) {
            double room = 1e9;
            for (std::size_t i = 0; i < piece.sew.size(); ++i) {
                const Vec2 a = piece.shrunk(piece.sew[i].at);
                const Vec2 b = piece.shrunk(piece.sew[(i + 1) % piece.sew.size()].at);
                if ((a - tip).norm() > sameTip && (b - tip).norm() > sameTip)
                    room = std::min(room, segmentDistance(tip, a, b));
            }
            if (room < thinnest)
                add(piece.patch, piece.patch, tip, {CutHarm::CannotBeCut, thinnest - room},
                    {QT_TRANSLATE_NOOP("Message",
                                       "only %1 mm are left of the piece at the tip of a dart: make it shorter"),
                     {numberText(std::round(100 * room) / 100)}});
        }
    }

    static bool isAlone(const CutNotch& notch) { return notch.element != noElement && notch.seam == noElement; }

    /// One row for all of a piece: of a pattern that is not sewn yet there are many.
    void lonelyNotches(const CutPiece& piece)
    {
        const auto count = std::ranges::count_if(piece.notches, isAlone);
        const auto first = std::ranges::find_if(piece.notches, isAlone);
        if (count == 1)
            add(first->element, piece, first->sewn, {CutHarm::Inconvenient},
                {QT_TRANSLATE_NOOP("Message", "nothing is sewn where it is, so it has no partner")});
        else if (count > 1)
            add(piece.patch, piece, first->sewn, {CutHarm::Inconvenient},
                {QT_TRANSLATE_NOOP("Message",
                                   "nothing is sewn where %1 of its notches are, so they have no partners"),
                 {std::to_string(count)}});
    }

    /// Where there is no allowance they go into the piece itself.
    void bareNotches(const CutPiece& piece)
    {
        const auto isBare = [](const CutNotch& notch) { return (notch.at - notch.sewn).norm() < 1e-6; };
        const auto count = std::ranges::count_if(piece.notches, isBare);
        if (count == 0)
            return;
        const CutNotch& first = *std::ranges::find_if(piece.notches, isBare);
        add(count > 1 || first.element == noElement ? piece.patch : first.element, piece, first.sewn,
            {CutHarm::Weakened, first.shape.depth},
            {QT_TRANSLATE_NOOP("Message", "notches at edges without an allowance cut into the piece: there are %1; "
                                          "give these edges an allowance"),
             {std::to_string(count)}});
    }

    void notches(const CutPiece& piece)
    {
        lonelyNotches(piece);
        bareNotches(piece);
        int crowded = 0; // of automatic ones without a partner
        for (const CutNotch& notch : piece.notches) {
            const ElementId id = notch.element == noElement ? piece.patch : notch.element;
            const double room = (notch.at - notch.sewn).norm();
            if (notch.shape.depth > room - leastBeyondNotch && room >= 1e-6)
                add(id, piece, notch.sewn, {CutHarm::Weakened, notch.shape.depth - room},
                    {QT_TRANSLATE_NOOP("Message",
                                       "a notch of %1 mm reaches the sewing line, which is %2 mm away: make it "
                                       "shallower, or the allowance wider"),
                     {numberText(notch.shape.depth), numberText(std::round(10 * room) / 10)}});
            if (notch.seam != noElement && !hasPartner(piece, notch) &&
                (notch.element != noElement || ++crowded == 1))
                add(id, piece, notch.sewn, {CutHarm::Inconvenient},
                    {QT_TRANSLATE_NOOP("Message",
                                       "it has no partner on the other side of its seam: another notch is "
                                       "too near there")});
        }
        if (crowded > 1)
            add(piece.patch, piece, piece.box().center(), {CutHarm::Inconvenient},
                {QT_TRANSLATE_NOOP("Message", "%1 of its notches have no partners on the other sides of their "
                                              "seams: others are too near there. Ask for fewer"),
                 {std::to_string(crowded)}});
    }

    /// On another piece, or on another place of the same one.
    bool hasPartner(const CutPiece& piece, const CutNotch& notch)
    {
        const auto meets = [&](const CutPiece& other) {
            return std::ranges::any_of(other.notches, [&](const CutNotch& there) {
                return &there != &notch && there.seam == notch.seam &&
                       std::abs(there.fraction - notch.fraction) < 1e-6;
            });
        };
        const Seam* seam = m_design.find<Seam>(notch.seam);
        if (!seam)
            return true;
        const ElementId other = seam->a.patch == piece.patch ? seam->b.patch : seam->a.patch;
        const auto there = m_pieces.find(other);
        return there == m_pieces.end() || std::ranges::any_of(there->second, [&](const CutPiece* one) {
                   return meets(*one) || meetsNext(notch, *one);
               });
    }

    /// Where two seams end at one place, as beside a dart, one notch there is for both.
    bool meetsNext(const CutNotch& notch, const CutPiece& other)
    {
        const auto placeOf = [&](const CutNotch& at) -> std::optional<double> {
            const Seam* seam = isAtEnd(at) ? m_design.find<Seam>(at.seam) : nullptr;
            if (!seam)
                return std::nullopt;
            const SewnPair& pair = m_pairs.try_emplace(at.seam, m_design, *seam).first->second;
            if (!pair.usable())
                return std::nullopt;
            return seam->b.patch == other.patch ? pair.onB(at.fraction) : pair.onA(at.fraction);
        };
        const std::optional<double> mine = placeOf(notch);
        const double period = m_design.find<Patch>(other.patch)->outline.period();
        return mine && std::ranges::any_of(other.notches, [&](const CutNotch& there) {
                   const std::optional<double> place = placeOf(there);
                   return place && std::abs(std::remainder(*place - *mine, period)) < sameEnd * period;
               });
    }

    static bool isAtEnd(const CutNotch& notch)
    {
        return notch.seam != noElement && (notch.fraction <= 0 || notch.fraction >= 1);
    }

    void width(const CutPiece& piece)
    {
        const Fabric* fabric = m_design.find<Fabric>(piece.fabric);
        const Vec2 grain = piece.grain.to - piece.grain.from;
        if (!fabric || !(grain.norm() > 0))
            return;
        const auto across = [&](const Vec2& axis) {
            double low = 1e9, high = -1e9;
            for (const LinePoint& point : piece.cut) {
                low = std::min(low, point.at.dot(axis));
                high = std::max(high, point.at.dot(axis));
            }
            return high - low;
        };
        const Vec2 along = grain.normalized();
        double least = across({-along.y(), along.x()});
        if (piece.nap == Nap::Any)
            least = std::min(least, across(along));
        if (least > fabric->cutting.width)
            add(piece.patch, piece, piece.box().center(), {CutHarm::CannotBeCut, least - fabric->cutting.width},
                {QT_TRANSLATE_NOOP("Message",
                                   "it is %1 mm wide across the grain, but \"%2\" only %3 mm: split it, or turn "
                                   "its grain"),
                 {numberText(std::ceil(least)), fabric->name, numberText(fabric->cutting.width)}});
    }

    /// Of a dart, which is folded, not spread.
    bool isTip(const CutPiece& piece, const Vec2& at) const
    {
        const auto tips = m_tips.find(piece.patch);
        return tips != m_tips.end() && std::ranges::any_of(tips->second, [&](const Vec2& tip) {
                   return (piece.shrunk(at) - tip).norm() < sameTip;
               });
    }

    /// At an inner corner the allowances must be spread when it is sewn.
    void corners(const CutPiece& piece)
    {
        const std::size_t count = piece.sew.size();
        for (std::size_t i = 0; i < count; ++i) {
            if (!piece.sew[i].corner || isTip(piece, piece.sew[i].at))
                continue;
            const Vec2 in = piece.sew[i].at - piece.sew[(i + count - 1) % count].at;
            const Vec2 out = piece.sew[(i + 1) % count].at - piece.sew[i].at;
            const double turn = std::atan2(cross(in, out), in.dot(out)) * 180 / std::numbers::pi;
            if (turn < sharpest - 180 && areaOf(piece.cut) > areaOf(piece.sew) + 1)
                add(piece.patch, piece, piece.sew[i].at, {CutHarm::Weakened, -turn},
                    {QT_TRANSLATE_NOOP("Message",
                                       "an inner corner of %1 degrees is too sharp for its seam allowances: "
                                       "make them smaller there, or the corner wider"),
                     {numberText(std::round(180 + turn))}});
        }
    }

    const Design& m_design;
    MarksByPatch m_marks;
    std::map<ElementId, std::vector<const CutPiece*>> m_pieces; // by patch
    std::map<ElementId, std::vector<Vec2>> m_tips;              // of darts, by patch
    std::map<ElementId, SewnPair> m_pairs;                      // of seams whose ends have been asked for
    std::vector<CutFinding> m_found;
};

} // namespace

std::vector<CutFinding> checkCutting(const Design& design, const CutPattern& pattern, const std::stop_token& stop)
{
    return Check(design, pattern).run(stop);
}

} // namespace bolster
