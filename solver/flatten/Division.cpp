#include "Division.h"

#include "Fiedler.h"
#include "FormLines.h"
#include "SegmentDistance.h"
#include "SheetCut.h"
#include "SheetImage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

namespace bolster {

namespace {

using Triangle = std::array<int, 3>;

constexpr FlattenOrder quickly{0.3, 120, 0.02};
constexpr int mostRounds = 6;
constexpr double sewnMore = 0.95; // of the limit: sewn to each other pieces are strained a little more than alone
constexpr double straightMore = 1.1;  // times the strain: what a straighter seam may cost,
constexpr double littleStrain = 0.85; // or up to so much of the limit
constexpr double crumbEdges = 0.5;    // of the cover, across what no crease parts
constexpr double leastEdges = 5;      // of the cover, across a piece: a smaller one is not divided
constexpr std::size_t manyTriangles = 4000, someTriangles = 1000; // of what is divided first, and later on
constexpr double crease = 50;                                     // degrees
constexpr std::size_t mostCreased = 40;                           // parts between creases
constexpr std::size_t mostPieces = 100;                           // of what was one
constexpr double exactly = 1e-6;                                  // mm
constexpr double onEdge = 0.01;                                   // mm
constexpr double asClose = 1e-4;                                  // of a number: roundoff apart
constexpr double shorter = 0.99;                                  // times as long: worth another line
constexpr int roundsOfStraightening = 2;
constexpr double mostWinding = 4; // of what is joined again; a strip ten times as long as wide has 3.9

/// By points of the form: where it is only cut open it hangs together.
FormSheet sheetOf(const std::vector<Vec3>& points, const FormPiece& piece)
{
    FormSheet sheet;
    std::map<int, int> numbers;
    for (const Triangle& corners : piece.triangles) {
        Triangle& named = sheet.triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            const int point = piece.points[corners[k]];
            const auto [number, isNew] = numbers.emplace(point, static_cast<int>(sheet.points.size()));
            if (isNew)
                sheet.points.push_back(points[point]);
            named[k] = number->second;
        }
    }
    return sheet;
}

/// Adds triangles of a part to a mesh.
void append(TriangleMesh& mesh, const FormSheet& sheet, const std::string& part)
{
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    mesh.parts.push_back({part, static_cast<std::uint32_t>(mesh.triangles.size()),
                          static_cast<std::uint32_t>(sheet.triangles.size())});
    mesh.points.insert(mesh.points.end(), sheet.points.begin(), sheet.points.end());
    for (const auto& [a, b, c] : sheet.triangles)
        mesh.triangles.push_back({first + static_cast<std::uint32_t>(a), first + static_cast<std::uint32_t>(b),
                                  first + static_cast<std::uint32_t>(c)});
}

/// Where a piece is cut open, but for rings, for which another way may be shorter later.
std::vector<std::vector<Vec3>> slitsOf(const Form& form, std::size_t p)
{
    std::set<std::pair<int, int>> opened;
    for (const auto& [a, b] : form.opened)
        opened.insert(std::minmax(a, b));
    std::vector<std::vector<Vec3>> rows;
    const FormPiece& piece = form.pieces[p];
    for (std::size_t k = 0; k < piece.border.size(); ++k) {
        const int a = piece.points[piece.border[k]], b = piece.points[piece.border[piece.after(k)]];
        if (piece.mates[k].piece == static_cast<int>(p) && !opened.contains(std::minmax(a, b)))
            rows.push_back({form.points[a], form.points[b]});
    }
    return rows;
}

/// Nothing else is sewn to it, and nothing is cut into it.
bool standsAlone(const Form& form, std::size_t p)
{
    const auto isOwn = [&](const EdgeMate& mate) { return mate.none() || mate.piece == static_cast<int>(p); };
    return std::ranges::all_of(form.pieces[p].mates, isOwn) && slitsOf(form, p).empty();
}

/// What is cut into pieces stays so.
std::vector<std::vector<Vec3>> slitsOf(const Form& form)
{
    std::vector<std::vector<Vec3>> rows;
    for (std::size_t p = 0; p < form.pieces.size(); ++p)
        std::ranges::move(slitsOf(form, p), std::back_inserter(rows));
    return rows;
}

FormSheet together(FormSheet sheet, const FormSheet& other)
{
    const int first = static_cast<int>(sheet.points.size());
    sheet.points.insert(sheet.points.end(), other.points.begin(), other.points.end());
    for (const auto& [a, b, c] : other.triangles)
        sheet.triangles.push_back({first + a, first + b, first + c});
    return sheet;
}

/// mm, of a form of one piece.
double borderOf(const Form& form)
{
    const FormPiece& piece = form.pieces.front();
    double length = 0;
    for (std::size_t k = 0; k < piece.border.size(); ++k)
        length +=
            (form.points[piece.points[piece.border[piece.after(k)]]] - form.points[piece.points[piece.border[k]]])
                .norm();
    return length;
}

/// Of a form of one piece: the square of its border's length over that of a disc of its size.
double winding(const Form& form)
{
    const double length = borderOf(form);
    return length * length / (4 * std::numbers::pi * sheetOf(form.points, form.pieces.front()).area());
}

class Divider {
    using Pair = std::pair<std::size_t, std::size_t>; // of sheets, the lesser one first

public:
    Divider(const Form& form, const FormPatternOrder& order, const DivisionProgress& progress,
            const std::stop_token& stop)
        : m_cuts{true, {}, {}, slitsOf(form)}
        , m_order(order)
        , m_limit(bearableStrain(order.fabric))
        , m_least(std::pow(leastEdges * order.edgeLength, 2))
        , m_progress(progress)
        , m_stop(stop)
    {
        m_cuts.onEdges = exactly; // what lies beside it is another edge
        m_order.twins = false;
    }

    Form divided(const Form& form)
    {
        const std::vector<FormPiece>& pieces = form.pieces;
        std::vector<bool> bad(pieces.size(), false);
        for (std::size_t p = 0; p < pieces.size() && !m_stop.stop_requested(); ++p)
            bad[p] = !pieces[p].isSheet() || !liesFlat(formOf(sheetOf(form.points, pieces[p])));
        if (std::ranges::count(bad, true) == 0)
            return form;
        const std::vector<std::vector<FormSheet>> results = dividedAlike(form, bad);
        Form now = divided(form.points, pieces, bad, [&](std::size_t p, const FormSheet&) { return results[p]; });
        if (m_divisions == 0) {
            Form same = form;
            same.undivided = std::move(m_undivided);
            return same;
        }
        // Sewn to each other, as equally long edges ask for, a few may not lie flat any more.
        for (int round = 0; round < mostRounds && !m_stop.stop_requested(); ++round) {
            std::vector<bool> still = badOnes(now, {}, m_limit);
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
        if (m_stop.stop_requested())
            return form;
        sayWhatIsLost(now);
        now.notes = form.notes;
        now.undivided = std::move(m_undivided);
        std::ranges::copy(m_notes, std::back_inserter(now.notes));
        if (m_divisions > 0)
            now.notes.push_back(
                {QT_TRANSLATE_NOOP("Message", "What would not lie flat, or be strained by more than the "
                                              "fabric may be, is divided, which makes so many pieces more: %1"),
                 {std::to_string(m_divisions)}});
        return now;
    }

private:
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
        for (std::size_t p = 0; p < bad.size() && !m_stop.stop_requested(); ++p) {
            if (!bad[p])
                continue;
            FormSheet sheet = sheetOf(form.points, form.pieces[p]);
            const auto like = !standsAlone(form, p) ? all.end() : std::ranges::find_if(all, [&](const Alike& one) {
                return standsAlone(form, one.members.front()) && imageBetween(one.sheet, sheet, m_stop);
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
        parts = joined(std::move(parts), false);
        for (int round = 0; round < roundsOfStraightening; ++round)
            straighten(parts);
        return parts;
    }

    std::vector<FormSheet> imagesOf(std::vector<FormSheet> parts, const FormSheet& from, const FormSheet& to) const
    {
        const bool itself = from.points == to.points && from.triangles == to.triangles;
        if (const auto image = itself ? std::nullopt : imageBetween(from, to, m_stop))
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
                   std::abs(rough.area() - sheet.area()) < asClose * sheet.area();
        });
    }

    /// With what becomes of those that are bad in their places.
    template <class Divide>
    Form divided(const std::vector<Vec3>& points, const std::vector<FormPiece>& pieces,
                 const std::vector<bool>& bad, const Divide& divide)
    {
        TriangleMesh mesh;
        for (std::size_t p = 0; p < pieces.size() && !m_stop.stop_requested(); ++p) {
            FormSheet sheet = sheetOf(points, pieces[p]);
            const std::vector<FormSheet> sheets =
                bad[p] ? divide(p, std::move(sheet)) : std::vector{std::move(sheet)};
            m_divisions += static_cast<int>(sheets.size()) - 1;
            for (const FormSheet& each : sheets)
                append(mesh, each, pieces[p].part);
        }
        return cutForm(mesh, m_cuts, m_stop);
    }

    Form formOf(const FormSheet& sheet) const { return formOf(sheet, m_cuts); }

    Form formOf(const FormSheet& sheet, const FormCuts& cuts) const
    {
        TriangleMesh mesh;
        append(mesh, sheet, "");
        return cutForm(mesh, cuts, m_stop);
    }

    FormCuts withoutSlits() const
    {
        FormCuts cuts = m_cuts;
        cuts.edges.clear();
        return cuts;
    }

    /// As it is, or with its slits sewn up: what is wrong with those is mended in the end.
    bool liesFlat(const FormSheet& sheet, const Form& form) const
    {
        if (liesFlat(form))
            return true;
        const bool hasSlits = !m_cuts.edges.empty() && form.pieces.size() == 1 && !slitsOf(form, 0).empty();
        return hasSlits && liesFlat(formOf(sheet, withoutSlits()));
    }

    /// A cut where a form is hollow as a saddle does not open: its sides lie over each other. Such cuts go, if
    /// without them the piece lies flat. Whether some went, and the form is another one.
    bool closeSlits(Form& form, const std::vector<bool>& bad)
    {
        bool closed = false;
        for (std::size_t p = 0; p < bad.size() && !m_stop.stop_requested(); ++p) {
            if (!bad[p] || m_cuts.edges.empty())
                continue;
            const std::vector<std::vector<Vec3>> own = slitsOf(form, p);
            if (own.empty() || !liesFlat(formOf(sheetOf(form.points, form.pieces[p]), withoutSlits())))
                continue;
            const auto isOwn = [&](const std::vector<Vec3>& row) { // of which an edge may be a part by now
                return std::ranges::any_of(own, [&](const std::vector<Vec3>& edge) {
                    const Vec3 middle = (edge.front() + edge.back()) / 2;
                    return segmentDistance<3>(middle, row.front(), row.back()) < onEdge;
                });
            };
            std::erase_if(m_cuts.edges, isOwn);
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
        for (const std::vector<Vec3>& row : m_cuts.edges) {
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

    /// Pieces that would lie over themselves or be strained by more than `limit`; none when stopped.
    std::vector<bool> badOnes(const Form& form, FlattenOrder flattening, double limit) const
    {
        flattening.poisson = m_order.fabric.poisson;
        std::vector<bool> bad(form.pieces.size(), false);
        const std::vector<FlatPiece> flat = flatten(form, flattening, m_stop);
        if (m_stop.stop_requested() || flat.empty())
            return bad;
        const std::vector<bool> become = becomePatches(form, flat, m_order, m_stop);
        for (std::size_t p = 0; p < bad.size() && !m_stop.stop_requested(); ++p)
            bad[p] = !become[p] || flat[p].strainP99 > limit;
        return bad;
    }

    bool liesFlat(const Form& form) const
    {
        const std::vector<bool> bad = badOnes(form, quickly, sewnMore * m_limit);
        return !bad.empty() && !m_stop.stop_requested() && std::ranges::count(bad, true) == 0;
    }

    /// What creases part already, unless they part it into small pieces; else all of it, with enough triangles.
    std::vector<FormSheet> betweenCreases(const FormSheet& sheet) const
    {
        if (sheet.area() < m_least)
            return {sheet};
        TriangleMesh mesh;
        append(mesh, sheet, "");
        FormCuts cuts = m_cuts;
        cuts.angle = crease;
        const Form form = cutForm(mesh, cuts, m_stop);
        std::vector<FormSheet> parts;
        for (const FormPiece& piece : form.pieces)
            parts.push_back(sheetOf(form.points, piece));
        joinCrumbs(parts);
        if (parts.size() < 2 || parts.size() > mostCreased)
            return {fine(sheet, manyTriangles)};
        return parts;
    }

    /// Splinters of a mesh lean anywhere: what they part belongs to what it has most of its border in common with.
    void joinCrumbs(std::vector<FormSheet>& parts) const
    {
        const double crumb = std::pow(crumbEdges * m_order.edgeLength, 2);
        const auto isCrumb = [&](const FormSheet& part) { return part.area() < crumb; };
        while (parts.size() > 1 && std::ranges::any_of(parts, isCrumb) && !m_stop.stop_requested()) {
            const std::map<Pair, double> common = commonLengths(parts);
            auto longest = common.end();
            for (auto each = common.begin(); each != common.end(); ++each)
                if ((isCrumb(parts[each->first.first]) || isCrumb(parts[each->first.second])) &&
                    (longest == common.end() || each->second > longest->second))
                    longest = each;
            if (longest == common.end())
                return;
            const auto [a, b] = longest->first;
            parts[a] = together(std::move(parts[a]), parts[b]);
            parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(b));
        }
    }

    /// What creases part, or else the two halves, until they lie flat; or the sheet.
    std::vector<FormSheet> parts(const FormSheet& sheet)
    {
        if (sheet.area() < m_least)
            return {sheet};
        if (std::vector<FormSheet> between = betweenCreases(sheet); between.size() > 1)
            return joined(flatPartsOf(std::move(between)), true);
        auto [below, above] = halved(sheet);
        if (below.triangles.empty() || above.triangles.empty())
            return {sheet};
        return joined(flatPartsOf({std::move(below), std::move(above)}), true);
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
        while (!waiting.empty() && done.size() < mostPieces && !m_stop.stop_requested()) {
            sheet = std::move(waiting.back());
            waiting.pop_back();
            const Form form = formOf(sheet);
            if (form.pieces.size() > 1) { // halves need not hang together
                for (const FormPiece& piece : form.pieces)
                    waiting.push_back(sheetOf(form.points, piece));
            } else if (sheet.area() < m_least || liesFlat(sheet, form)) {
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
        const Halves halves = halvesOf(sheet, m_stop);
        if (halves.ofTriangles.empty())
            return {};
        return cutInTwo(std::move(sheet), halves);
    }

    /// Neighbours that lie flat together are one again, first those that have most of their outline in common.
    std::vector<FormSheet> joined(std::vector<FormSheet> sheets, bool onlySmall) const
    {
        joinCrumbs(sheets);
        std::map<Pair, double> common = commonLengths(sheets);
        if (onlySmall)
            std::erase_if(common, [&](const auto& each) {
                return std::min(sheets[each.first.first].area(), sheets[each.first.second].area()) >= m_least;
            });
        std::vector<double> areas;
        for (const FormSheet& sheet : sheets)
            areas.push_back(sheet.area());
        const auto closeness = [&](const auto& each) {
            const auto& [pair, length] = each;
            return length / std::sqrt(std::min(areas[pair.first], areas[pair.second]));
        };
        const auto size = [&](const auto& each) { return areas[each.first.first] + areas[each.first.second]; };
        // Of those that are as close the largest: a strip grows, where halves of it would be in each other's way.
        const auto comesFirst = [&](const auto& one, const auto& other) {
            const double more = closeness(one) - closeness(other);
            return std::abs(more) > asClose * closeness(one) ? more > 0 : size(one) > (1 + asClose) * size(other);
        };
        while (!common.empty() && !m_stop.stop_requested()) {
            auto closest = common.begin();
            for (auto each = common.begin(); each != common.end(); ++each)
                closest = comesFirst(*each, *closest) ? each : closest;
            const auto [a, b] = closest->first;
            common.erase(closest);
            FormSheet both = together(sheets[a], sheets[b]);
            const Form form = formOf(both);
            if (form.pieces.size() != 1 || !form.opened.empty() || windsMore(form, sheets[a], sheets[b]) ||
                !liesFlat(both, form))
                continue;
            sheets[a] = std::move(both);
            sheets[b] = {};
            areas[a] += std::exchange(areas[b], 0);
            for (auto each = common.begin(); each != common.end();) {
                const auto [one, other] = each->first;
                if (one != b && other != b) {
                    ++each;
                    continue;
                }
                common[std::minmax(a, one == b ? other : one)] += each->second;
                each = common.erase(each);
            }
        }
        std::erase_if(sheets, [](const FormSheet& sheet) { return sheet.triangles.empty(); });
        return sheets;
    }

    /// Seams that go to and fro, along edges of coarse triangles where the form is round, become shorter ones.
    void straighten(std::vector<FormSheet>& sheets) const
    {
        for (const auto& [pair, length] : commonLengths(sheets)) {
            FormSheet &one = sheets[pair.first], &other = sheets[pair.second];
            std::optional<std::array<FormSheet, 2>> anew = partedStraight(one, other);
            if (!anew || m_stop.stop_requested())
                continue;
            const Form a = formOf(one), b = formOf(other), c = formOf((*anew)[0]), d = formOf((*anew)[1]);
            const auto isPiece = [](const Form& form) { return form.pieces.size() == 1 && form.opened.empty(); };
            if (!isPiece(c) || !isPiece(d) || borderOf(c) + borderOf(d) > shorter * (borderOf(a) + borderOf(b)))
                continue;
            const double most = std::max(strainOf(a), strainOf(b)), now = std::max(strainOf(c), strainOf(d));
            if (now > std::min(sewnMore * m_limit, std::max(straightMore * most, littleStrain * m_limit)))
                continue;
            one = std::move((*anew)[0]);
            other = std::move((*anew)[1]);
        }
    }

    /// Of a form of one piece: what 99 % of it do not exceed; infinite where it does not lie flat.
    double strainOf(const Form& form) const
    {
        FlattenOrder flattening = quickly;
        flattening.poisson = m_order.fabric.poisson;
        const std::vector<FlatPiece> flat = flatten(form, flattening, m_stop);
        const bool lies = !flat.empty() && becomePatches(form, flat, m_order, m_stop).front();
        return lies ? flat.front().strainP99 : std::numeric_limits<double>::infinity();
    }

    /// Two neighbours, with a smooth line between them but for creases.
    std::optional<std::array<FormSheet, 2>> partedStraight(const FormSheet& one, const FormSheet& other) const
    {
        const Form form = formOf(together(one, other));
        if (form.pieces.size() != 1 || !slitsOf(form, 0).empty() ||
            form.pieces[0].triangles.size() != one.triangles.size() + other.triangles.size())
            return std::nullopt;
        FormSheet both = sheetOf(form.points, form.pieces[0]);
        Halves halves;
        halves.ofTriangles.assign(one.triangles.size(), -1);
        halves.ofTriangles.resize(both.triangles.size(), 1);
        halves.ofPoints.resize(both.points.size(), 0);
        std::vector<double> areas(both.points.size(), 0);
        for (std::size_t t = 0; t < both.triangles.size(); ++t)
            for (const int corner : both.triangles[t]) {
                halves.ofPoints[corner] += both.areaNormal(t).norm() * halves.ofTriangles[t];
                areas[corner] += both.areaNormal(t).norm();
            }
        for (std::size_t v = 0; v < areas.size(); ++v)
            halves.ofPoints[v] /= std::max(areas[v], 1e-300);
        auto parts = cutInTwo(std::move(both), halves, crease);
        if (parts[0].triangles.empty() || parts[1].triangles.empty())
            return std::nullopt;
        return parts;
    }

    /// Than a piece should: what is long anyway may have scraps that lie beside it.
    bool windsMore(const Form& both, const FormSheet& one, const FormSheet& other) const
    {
        const double now = winding(both);
        if (std::min(one.area(), other.area()) >= m_least)
            return now > mostWinding;
        return now > mostWinding && now > std::max(winding(formOf(one)), winding(formOf(other)));
    }

    /// mm, of the borders of two neighbours.
    std::map<Pair, double> commonLengths(const std::vector<FormSheet>& sheets) const
    {
        TriangleMesh mesh;
        for (std::size_t k = 0; k < sheets.size(); ++k)
            append(mesh, sheets[k], std::to_string(k));
        const Form form = cutForm(mesh, m_cuts, m_stop);
        std::map<Pair, double> lengths;
        for (const FormPiece& piece : form.pieces)
            for (std::size_t k = 0; k < piece.border.size(); ++k) {
                if (piece.mates[k].none())
                    continue;
                const std::size_t one = std::stoul(piece.part),
                                  other = std::stoul(form.pieces[piece.mates[k].piece].part);
                const Vec3 &from = form.points[piece.points[piece.border[k]]],
                           &to = form.points[piece.points[piece.border[piece.after(k)]]];
                if (one < other)
                    lengths[{one, other}] += (to - from).norm();
            }
        return lengths;
    }

    FormCuts m_cuts;
    FormPatternOrder m_order;
    double m_limit, m_least; // mm^2
    const DivisionProgress& m_progress;
    std::stop_token m_stop;
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

} // namespace bolster
