#include "JoinedSheets.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace bolster {

namespace {

constexpr double crumbEdges = 0.5; // of the cover, across what no crease parts
constexpr double asClose = 1e-4;   // of a number: roundoff apart
constexpr double mostWinding = 4;  // of what is joined again; a strip ten times as long as wide has 3.9

/// Than a piece should: what is long anyway may have scraps that lie beside it.
bool windsMore(const Form& both, const FormSheet& one, const FormSheet& other, const SheetTrials& trials)
{
    const double now = winding(both);
    if (std::min(one.area(), other.area()) >= trials.leastArea())
        return now > mostWinding;
    return now > mostWinding && now > std::max(winding(trials.formOf(one)), winding(trials.formOf(other)));
}

} // namespace

std::map<SheetPair, double> commonLengths(const std::vector<FormSheet>& sheets, const SheetTrials& trials)
{
    TriangleMesh mesh;
    for (std::size_t k = 0; k < sheets.size(); ++k)
        append(mesh, sheets[k], std::to_string(k));
    const Form form = cutForm(mesh, trials.cuts, trials.stop());
    std::map<SheetPair, double> lengths;
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

void joinCrumbs(std::vector<FormSheet>& parts, const SheetTrials& trials)
{
    const double crumb = std::pow(crumbEdges * trials.edgeLength(), 2);
    const auto isCrumb = [&](const FormSheet& part) { return part.area() < crumb; };
    while (parts.size() > 1 && std::ranges::any_of(parts, isCrumb) && !trials.isStopped()) {
        const std::map<SheetPair, double> common = commonLengths(parts, trials);
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

std::vector<FormSheet> joined(std::vector<FormSheet> sheets, bool onlySmall, const SheetTrials& trials)
{
    joinCrumbs(sheets, trials);
    std::map<SheetPair, double> common = commonLengths(sheets, trials);
    if (onlySmall)
        std::erase_if(common, [&](const auto& each) {
            return std::min(sheets[each.first.first].area(), sheets[each.first.second].area()) >=
                   trials.leastArea();
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
    while (!common.empty() && !trials.isStopped()) {
        auto closest = common.begin();
        for (auto each = common.begin(); each != common.end(); ++each)
            closest = comesFirst(*each, *closest) ? each : closest;
        const auto [a, b] = closest->first;
        common.erase(closest);
        FormSheet both = together(sheets[a], sheets[b]);
        const Form form = trials.formOf(both);
        if (form.pieces.size() != 1 || !form.opened.empty() || windsMore(form, sheets[a], sheets[b], trials) ||
            !trials.liesFlat(both, form))
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

} // namespace bolster
