#include "Division.h"

#include "FormLines.h"
#include "JoinedSheets.h"
#include "SegmentDistance.h"
#include "SheetCut.h"
#include "SheetImage.h"
#include "StraightSeams.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace bolster {

namespace {

constexpr int mostRounds = 6;
constexpr std::size_t manyTriangles = 4000, someTriangles = 1000; // of what is divided first, and later on
constexpr std::size_t mostCreased = 40;                           // parts between creases
constexpr std::size_t mostPieces = 100;                           // of what was one
constexpr double exactly = 1e-6;                                  // mm
constexpr double onEdge = 0.01;                                   // mm
constexpr double sameArea = 1e-4;                                 // of an area: roundoff apart
constexpr int roundsOfStraightening = 2;

/// Nothing else is sewn to it, and nothing is cut into it.
bool standsAlone(const Form& form, std::size_t p)
{
    const auto isOwn = [&](const EdgeMate& mate) { return mate.none() || mate.piece == static_cast<int>(p); };
    return std::ranges::all_of(form.pieces[p].mates, isOwn) && slitsOf(form, p).empty();
}

class Divider {
public:
    Divider(const Form& form, const FormPatternOrder& order, const DivisionProgress& progress,
            const std::stop_token& stop)
        : m_trials({true, {}, {}, slitsOf(form)}, order, stop)
        , m_progress(progress)
    {
        m_trials.cuts.onEdges = exactly; // what lies beside it is another edge
    }

    Form divided(const Form& form)
    {
        Form begun = form;
        std::vector<bool> bad = badOnes(begun);
        const bool closed = closeSlits(begun, bad);
        if (closed) {
            tellOf(form, begun);
            bad = badOnes(begun);
        }
        if (std::ranges::count(bad, true) == 0 || m_trials.isStopped())
            return m_trials.isStopped() ? form : begun;
        const std::vector<std::vector<FormSheet>> results = dividedAlike(begun, bad);
        Form now =
            divided(begun.points, begun.pieces, bad, [&](std::size_t p, const FormSheet&) { return results[p]; });
        if (m_divisions == 0) {
            begun.undivided = std::move(m_undivided);
            return begun;
        }
        // Sewn to each other, as equally long edges ask for, a few may not lie flat any more.
        for (int round = 0; round < mostRounds && !m_trials.isStopped(); ++round) {
            std::vector<bool> still = m_trials.badOnes(now, {}, m_trials.limit());
            for (std::size_t p = 0; p < still.size(); ++p)
                still[p] = still[p] && !isRough(sheetOf(now.points, now.pieces[p]));
            const int before = m_divisions;
            if (closeSlits(now, still))
                continue;
            if (std::ranges::count(still, true) > 0)
                now = divided(now.points, now.pieces, still,
                              [&](std::size_t, const FormSheet& sheet) { return parts(sheet); });
            if (m_divisions == before)
                break;
        }
        if (m_trials.isStopped())
            return form;
        sayWhatIsLost(now);
        tellOf(form, now);
        now.undivided = std::move(m_undivided);
        if (m_divisions > 0)
            now.notes.push_back(
                {QT_TRANSLATE_NOOP("Message", "What would not lie flat, or be strained by more than the "
                                              "fabric may be, is divided, which makes so many pieces more: %1"),
                 {std::to_string(m_divisions)}});
        return now;
    }

    /// Nothing is divided.
    Form withoutClosedSlits(const Form& form)
    {
        std::vector<bool> bad(form.pieces.size(), false);
        for (std::size_t p = 0; p < form.pieces.size() && !m_trials.isStopped(); ++p)
            bad[p] = form.pieces[p].isSheet() && !slitsOf(form, p).empty() &&
                     !m_trials.liesFlat(m_trials.formOf(sheetOf(form.points, form.pieces[p])));
        Form now = form;
        if (m_trials.isStopped() || !closeSlits(now, bad) || m_trials.isStopped())
            return form;
        tellOf(form, now);
        return now;
    }

private:
    /// What was said of the form before, but of cuts that have gone; and what of these.
    void tellOf(const Form& before, Form& now) const
    {
        now.notes = before.notes;
        now.openEnds = before.openEnds;
        const std::vector<std::vector<Vec3>> slits = slitsOf(now);
        for (const OpenEnd& end : before.openEnds) {
            const bool isCut = std::ranges::any_of(slits, [&](const std::vector<Vec3>& row) {
                return segmentDistance<3>(end.way.front(), row.front(), row.back()) < onEdge;
            });
            if (!isCut)
                std::erase(now.notes, end.note);
        }
        std::ranges::copy(m_notes, std::back_inserter(now.notes));
    }

    std::vector<bool> badOnes(const Form& form)
    {
        std::vector<bool> bad(form.pieces.size(), false);
        for (std::size_t p = 0; p < form.pieces.size() && !m_trials.isStopped(); ++p)
            bad[p] = !form.pieces[p].isSheet() ||
                     !m_trials.liesFlat(m_trials.formOf(sheetOf(form.points, form.pieces[p])));
        return bad;
    }

    /// Parts that are alike, as two arms are, and what they are divided into.
    struct Alike {
        FormSheet sheet;
        std::optional<std::vector<FormSheet>> parts; ///< none: it is too rough
        std::vector<std::size_t> members;            ///< of the pieces
    };

    /// Of each piece that is bad its parts. What is alike is divided alike, however its triangles lie: as the one
    /// of the first two that becomes fewer.
    std::vector<std::vector<FormSheet>> dividedAlike(const Form& form, const std::vector<bool>& bad)
    {
        constexpr std::size_t mostTried = 2;
        std::vector<Alike> all;
        for (std::size_t p = 0; p < bad.size() && !m_trials.isStopped(); ++p) {
            if (!bad[p])
                continue;
            FormSheet sheet = sheetOf(form.points, form.pieces[p]);
            const auto like = !standsAlone(form, p) ? all.end() : std::ranges::find_if(all, [&](const Alike& one) {
                return standsAlone(form, one.members.front()) && imageBetween(one.sheet, sheet, m_trials.stop());
            });
            std::optional<std::vector<FormSheet>> parts;
            if (like == all.end() || like->members.size() < mostTried)
                parts = flatPartsOfAll(sheet);
            if (like == all.end()) {
                all.push_back({std::move(sheet), std::move(parts), {p}});
                continue;
            }
            like->members.push_back(p);
            if (parts && (!like->parts || parts->size() < like->parts->size())) {
                like->sheet = std::move(sheet);
                like->parts = std::move(parts);
            }
        }
        std::vector<std::vector<FormSheet>> results(bad.size());
        for (const Alike& one : all)
            for (const std::size_t p : one.members) {
                const FormSheet sheet = sheetOf(form.points, form.pieces[p]);
                results[p] = one.parts ? imagesOf(*one.parts, one.sheet, sheet) : std::vector{sheet};
                if (!one.parts)
                    sayRough(form.pieces[p].name, sheet);
            }
        return results;
    }

    std::optional<std::vector<FormSheet>> flatPartsOfAll(const FormSheet& sheet)
    {
        std::vector<FormSheet> parts = flatPartsOf(betweenCreases(sheet));
        if (parts.size() >= mostPieces)
            return std::nullopt;
        parts = joined(std::move(parts), false, m_trials);
        for (int round = 0; round < roundsOfStraightening; ++round)
            straighten(parts, m_trials);
        return parts;
    }

    std::vector<FormSheet> imagesOf(std::vector<FormSheet> parts, const FormSheet& from, const FormSheet& to) const
    {
        const bool itself = from.points == to.points && from.triangles == to.triangles;
        if (const auto image = itself ? std::nullopt : imageBetween(from, to, m_trials.stop()))
            for (FormSheet& part : parts)
                part = image->of(part);
        return parts;
    }

    /// It would need more pieces than anybody sews.
    void sayRough(const std::string& name, const FormSheet& sheet)
    {
        m_rough.push_back(sheet);
        m_undivided.push_back(
            {QT_TRANSLATE_NOOP("Message",
                               "%1 is not divided: more than %2 pieces would be needed until it lies flat. "
                               "It is rough, as scans are: smooth it, or fit a cover to it and take that"),
             {name, std::to_string(mostPieces)}});
    }

    bool isRough(const FormSheet& sheet) const
    {
        return std::ranges::any_of(m_rough, [&](const FormSheet& rough) {
            return rough.triangles.size() == sheet.triangles.size() &&
                   std::abs(rough.area() - sheet.area()) < sameArea * sheet.area();
        });
    }

    /// With what becomes of those that are bad in their places.
    template <class Divide>
    Form divided(const std::vector<Vec3>& points, const std::vector<FormPiece>& pieces,
                 const std::vector<bool>& bad, const Divide& divide)
    {
        TriangleMesh mesh;
        for (std::size_t p = 0; p < pieces.size() && !m_trials.isStopped(); ++p) {
            FormSheet sheet = sheetOf(points, pieces[p]);
            const std::vector<FormSheet> sheets =
                bad[p] ? divide(p, std::move(sheet)) : std::vector{std::move(sheet)};
            m_divisions += static_cast<int>(sheets.size()) - 1;
            for (const FormSheet& each : sheets)
                append(mesh, each, pieces[p].part);
        }
        return cutForm(mesh, m_trials.cuts, m_trials.stop());
    }

    /// A cut where a form is hollow as a saddle does not open: its sides lie over each other. Such cuts go, if
    /// without them the piece lies flat. Whether some went, and the form is another one.
    bool closeSlits(Form& form, const std::vector<bool>& bad)
    {
        bool closed = false;
        for (std::size_t p = 0; p < bad.size() && !m_trials.isStopped(); ++p) {
            if (!bad[p] || m_trials.cuts.edges.empty())
                continue;
            const std::vector<std::vector<Vec3>> own = slitsOf(form, p);
            if (own.empty() || !m_trials.liesFlat(m_trials.withoutSlits(sheetOf(form.points, form.pieces[p]))))
                continue;
            const auto isOwn = [&](const std::vector<Vec3>& row) { // of which an edge may be a part by now
                return std::ranges::any_of(own, [&](const std::vector<Vec3>& edge) {
                    const Vec3 middle = (edge.front() + edge.back()) / 2;
                    return segmentDistance<3>(middle, row.front(), row.back()) < onEdge;
                });
            };
            std::erase_if(m_trials.cuts.edges, isOwn);
            const Vec3 at = own[own.size() / 2].front();
            m_notes.push_back(
                {QT_TRANSLATE_NOOP("Message",
                                   "A line is not cut in at %1: the sides of the cut would lie over each "
                                   "other when it is laid flat. Draw it elsewhere, or on to a border"),
                 {placeText(at)}});
            closed = true;
        }
        if (closed)
            form = divided(form.points, form.pieces, std::vector<bool>(form.pieces.size(), false),
                           [](std::size_t, FormSheet sheet) { return std::vector{std::move(sheet)}; });
        return closed;
    }

    /// Slits that went where pieces were divided and joined.
    void sayWhatIsLost(const Form& form)
    {
        std::vector<std::pair<Vec3, Vec3>> borders;
        for (const FormPiece& piece : form.pieces)
            for (std::size_t k = 0; k < piece.border.size(); ++k)
                borders.emplace_back(form.points[piece.points[piece.border[k]]],
                                     form.points[piece.points[piece.border[piece.after(k)]]]);
        for (const std::vector<Vec3>& row : m_trials.cuts.edges) {
            const Vec3 middle = (row.front() + row.back()) / 2;
            const bool isThere = std::ranges::any_of(borders, [&](const auto& border) {
                return segmentDistance<3>(middle, border.first, border.second) < onEdge;
            });
            if (isThere)
                continue;
            m_notes.push_back({QT_TRANSLATE_NOOP("Message", "A line is not cut in at %1: the piece was divided "
                                                            "another way. Draw it on to a border"),
                               {placeText(middle)}});
            return;
        }
    }

    /// What creases part already, unless they part it into small pieces; else all of it, with enough triangles.
    std::vector<FormSheet> betweenCreases(const FormSheet& sheet) const
    {
        if (sheet.area() < m_trials.leastArea())
            return {sheet};
        TriangleMesh mesh;
        append(mesh, sheet, "");
        FormCuts cuts = m_trials.cuts;
        cuts.angle = creaseBend;
        const Form form = cutForm(mesh, cuts, m_trials.stop());
        std::vector<FormSheet> parts;
        for (const FormPiece& piece : form.pieces)
            parts.push_back(sheetOf(form.points, piece));
        joinCrumbs(parts, m_trials);
        if (parts.size() < 2 || parts.size() > mostCreased)
            return {fine(sheet, manyTriangles)};
        return parts;
    }

    /// What creases part, or else the two halves, until they lie flat; or the sheet.
    std::vector<FormSheet> parts(const FormSheet& sheet)
    {
        if (sheet.area() < m_trials.leastArea())
            return {sheet};
        if (std::vector<FormSheet> between = betweenCreases(sheet); between.size() > 1)
            return joined(flatPartsOf(std::move(between)), true, m_trials);
        auto [below, above] = halved(sheet);
        if (below.triangles.empty() || above.triangles.empty())
            return {sheet};
        return joined(flatPartsOf({std::move(below), std::move(above)}), true, m_trials);
    }

    std::vector<FormSheet> flatPartsOf(std::vector<FormSheet> sheets)
    {
        std::vector<FormSheet> all;
        for (FormSheet& sheet : sheets)
            if (all.size() < mostPieces)
                std::ranges::move(flatParts(std::move(sheet)), std::back_inserter(all));
        return all;
    }

    /// Halves of halves, as long as they do not lie flat.
    std::vector<FormSheet> flatParts(FormSheet sheet)
    {
        std::vector<FormSheet> waiting{std::move(sheet)}, done;
        while (!waiting.empty() && done.size() < mostPieces && !m_trials.isStopped()) {
            sheet = std::move(waiting.back());
            waiting.pop_back();
            const Form form = m_trials.formOf(sheet);
            if (form.pieces.size() > 1) { // halves need not hang together
                for (const FormPiece& piece : form.pieces)
                    waiting.push_back(sheetOf(form.points, piece));
            } else if (sheet.area() < m_trials.leastArea() || m_trials.liesFlat(sheet, form)) {
                addTo(done, std::move(sheet));
            } else if (auto [below, above] = halved(sheet); below.triangles.empty() || above.triangles.empty()) {
                addTo(done, std::move(sheet));
            } else {
                waiting.push_back(std::move(below));
                waiting.push_back(std::move(above));
            }
        }
        return done;
    }

    void addTo(std::vector<FormSheet>& done, FormSheet sheet)
    {
        done.push_back(std::move(sheet));
        ++m_found;
        if (m_progress)
            m_progress(m_found);
    }

    std::array<FormSheet, 2> halved(FormSheet sheet) const
    {
        sheet = fine(std::move(sheet), someTriangles);
        const Halves halves = halvesOf(sheet, m_trials.stop());
        if (halves.ofTriangles.empty())
            return {};
        return cutInTwo(std::move(sheet), halves);
    }

    SheetTrials m_trials;
    const DivisionProgress& m_progress;
    std::vector<Message> m_notes; // cuts that are not made
    int m_divisions = 0;
    std::vector<FormSheet> m_rough;   // what is not divided
    std::vector<Message> m_undivided; // and why
    int m_found = 0;                  // pieces that lie flat
};

} // namespace

double bearableStrain(const Fabric& fabric)
{
    return std::min(fabric.limits.along, fabric.limits.across) / 100;
}

Form divided(const Form& form, const FormPatternOrder& order, const std::stop_token& stop,
             const DivisionProgress& progress)
{
    if (form.pieces.empty())
        return form;
    return Divider(form, order, progress, stop).divided(form);
}

Form withoutClosedSlits(const Form& form, const FormPatternOrder& order, const std::stop_token& stop)
{
    if (form.openEnds.empty() || form.pieces.empty())
        return form;
    return Divider(form, order, {}, stop).withoutClosedSlits(form);
}

} // namespace bolster
