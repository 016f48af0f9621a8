#include "CoverFindings.h"

#include "DesignCheck.h"
#include "SpokenName.h"
#include "TriangleStrain.h"
#include "TriangleTree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace bolster {

namespace {

using Finding = CoverFinding;
using Range = SurfaceTopology::PatchRange;

constexpr double smallSpot = 400;    // mm^2: what is over its limit on less than that is no worry,
constexpr double fewTriangles = 4;   // or on fewer than that: at a tip one or two say nothing of cloth,
constexpr double smallShare = 0.1;   // unless the patch has hardly more
constexpr double foldedSpot = 2500;  // mm^2 that are pressed together or folded over
constexpr double foldStrain = 8;     // %: cloth that is pressed together more lies in folds
constexpr double offFrame = 40;      // mm: more than padding, webbing and the frame's own roundness explain
constexpr double farFromFrame = 1e5; // mm
constexpr int manyCurves = 5;        // that are off a frame: not one that was forgotten

struct Strained {
    double value = 0;  ///< %
    double excess = 0; ///< value / allowed
    double area = 0;   ///< of the pattern, mm^2
    Vec2 at = Vec2::Zero();
};

/// The value that a small spot of the patch exceeds, at the place where it is worst; nothing when that is allowed.
std::optional<Strained> worstOf(std::vector<Strained> all)
{
    double patch = 0;
    for (const Strained& one : all)
        patch += one.area;
    const double share = std::min(smallShare, fewTriangles / std::max<double>(1, static_cast<double>(all.size())));
    const double spot = std::max(smallSpot, share * patch);
    std::erase_if(all, [](const Strained& one) { return !(one.excess > 1); });
    std::ranges::sort(all, std::ranges::greater(), &Strained::excess);
    double area = 0;
    for (const Strained& one : all)
        if ((area += one.area) >= spot) {
            Strained found = one;
            found.at = all.front().at;
            return found;
        }
    return std::nullopt;
}

/// Strains of the triangles of one patch.
struct PatchStrains {
    std::vector<Strained> along, across, shear;
    Strained pressed; ///< area and worst place of what is pressed together too much
};

PatchStrains strainsOf(const SurfaceMesh& surface, const Range& range, double grain, const StretchLimits& limits)
{
    const SurfaceTopology& topology = *surface.topology;
    PatchStrains strains;
    for (std::uint32_t t = range.firstTriangle; t < range.firstTriangle + range.triangleCount; ++t) {
        std::array<Vec2, 3> rest;
        std::array<Vec3, 3> place;
        for (std::size_t k = 0; k < 3; ++k) {
            rest[k] = topology.pattern[topology.triangles[t][k]];
            place[k] = surface.positions[topology.triangles[t][k]];
        }
        const Vec2 u = rest[1] - rest[0], v = rest[2] - rest[0];
        const double area = 0.5 * std::abs(u.x() * v.y() - u.y() * v.x());
        const Vec2 middle = (rest[0] + rest[1] + rest[2]) / 3;
        const GrainStrain strain = grainStrain(rest, place, grain);
        const auto add = [&](std::vector<Strained>& to, double percent, double allowed) {
            to.push_back({percent, std::abs(percent) / allowed, area, middle});
        };
        add(strains.along, 100 * std::max(0.0, strain.along), limits.along);
        add(strains.across, 100 * std::max(0.0, strain.across), limits.across);
        add(strains.shear, 100 * strain.shear, limits.shear);
        const double pressed = 100 * (1 - principalStretches(rest, place)[1]);
        if (pressed > foldStrain) {
            strains.pressed.area += area;
            if (pressed > strains.pressed.value) {
                strains.pressed.value = pressed;
                strains.pressed.at = middle;
            }
        }
    }
    return strains;
}

/// With as many digits as it takes that one is seen to be more than the other.
std::pair<std::string, std::string> twoThatDiffer(double is, double may)
{
    for (int digits = 2; digits < 5; ++digits)
        if (std::pair texts(numberText(is, digits), numberText(may, digits)); texts.first != texts.second)
            return texts;
    return {numberText(is, 5), numberText(may, 5)};
}

void findStrains(const SurfaceMesh& surface, const Design& design, std::vector<Finding>& found)
{
    for (const Range& range : surface.topology->patches) {
        const Patch* patch = design.find<Patch>(range.patch);
        const Fabric* fabric = design.find<Fabric>(range.fabric);
        if (!patch)
            continue;
        const StretchLimits limits = fabric ? fabric->limits : StretchLimits{};
        PatchStrains strains = strainsOf(surface, range, patch->grain * std::numbers::pi / 180, limits);
        const auto consider = [&](std::vector<Strained> all, double allowed, const char* sentence) {
            if (const std::optional<Strained> over = worstOf(std::move(all))) {
                const auto [is, may] = twoThatDiffer(std::abs(over->value), allowed);
                found.push_back({Finding::Kind::OverLimit,
                                 range.patch,
                                 Finding::Place{range.patch, over->at},
                                 std::abs(over->value),
                                 allowed,
                                 {sentence, {spokenName(design, range.patch), is, may}}});
            }
        };
        consider(std::move(strains.along), limits.along,
                 QT_TRANSLATE_NOOP("Message", "%1 is stretched by %2 % along the grain, its fabric allows %3 %"));
        consider(std::move(strains.across), limits.across,
                 QT_TRANSLATE_NOOP("Message", "%1 is stretched by %2 % across the grain, its fabric allows %3 %"));
        consider(std::move(strains.shear), limits.shear,
                 QT_TRANSLATE_NOOP("Message", "%1 is sheared by %2 %, its fabric allows %3 %"));
        if (strains.pressed.area > foldedSpot)
            found.push_back(
                {Finding::Kind::Folds,
                 range.patch,
                 Finding::Place{range.patch, strains.pressed.at},
                 strains.pressed.area,
                 foldedSpot,
                 {QT_TRANSLATE_NOOP("Message", "%1 lies in folds: there is more cloth than room for it"),
                  {spokenName(design, range.patch)}}});
    }
}

/// Patches by sewn component.
std::map<ElementId, ElementId> sewnComponents(const SurfaceTopology& topology)
{
    std::map<ElementId, ElementId> first;
    for (const Range& range : topology.patches)
        first[range.patch] = range.patch;
    std::vector<ElementId> patchOf(topology.unknownCount, ElementId{});
    for (const Range& range : topology.patches)
        for (std::uint32_t v = range.firstVertex; v < range.firstVertex + range.vertexCount; ++v) {
            ElementId& other = patchOf[topology.unknown[v]];
            if (other == noElement) {
                other = range.patch;
                continue;
            }
            const ElementId a = first[other], b = first[range.patch];
            if (a != b)
                for (auto& [patch, component] : first)
                    if (component == b)
                        component = a;
        }
    return first;
}

/// Whatever is not sewn to something that is held.
void findFree(const SurfaceTopology& topology, const Design& design, std::vector<Finding>& found)
{
    const std::map<ElementId, ElementId> component = sewnComponents(topology);
    std::map<ElementId, bool> held;
    for (const auto& [patch, of] : component)
        held[of] = false;
    const auto hold = [&](const std::vector<std::uint32_t>& chain) {
        for (const Range& range : topology.patches)
            if (!chain.empty() && chain[0] >= range.firstVertex && chain[0] < range.firstVertex + range.vertexCount)
                held[component.at(range.patch)] = true;
    };
    for (const SurfaceTopology::Chain& chain : topology.fixations)
        if (const auto* seam = design.find<FixationSeam>(chain.seam); seam && seam->hasCurve())
            hold(chain.a);
    for (const SurfaceTopology::Line& line : topology.lines)
        if (const auto* handle = design.find<HandleCurve>(line.element); handle && handle->hasTarget())
            hold(line.vertices);
    const bool any = std::ranges::any_of(held, [](const auto& of) { return of.second; });
    if (!any && held.size() < 2)
        return; // a cushion on nothing is what it is
    for (const auto& [of, isHeld] : held)
        if (!isHeld)
            found.push_back({Finding::Kind::Free,
                             of,
                             std::nullopt,
                             1,
                             1,
                             {QT_TRANSLATE_NOOP("Message", "%1 floats free: nothing holds it, and it is sewn to "
                                                           "nothing that is held"),
                              {spokenName(design, of)}}});
}

void findOffFrame(const SurfaceMesh& surface, const Design& design, const TriangleTree& frame,
                  std::vector<Finding>& found)
{
    const SurfaceTopology& topology = *surface.topology;
    double padding = 0;
    design.each<Cushion>([&](ElementId, const Cushion& cushion) {
        padding = std::max(padding, cushion.enabled ? cushion.dilation : 0);
    });
    const double allowed = offFrame + padding;
    std::map<ElementId, Finding> worst; // by curve
    for (const SurfaceTopology::Chain& chain : topology.fixations) {
        const auto* seam = design.find<FixationSeam>(chain.seam);
        if (!seam || !seam->hasCurve())
            continue;
        for (const std::uint32_t v : chain.a) {
            const double distance = frame.distance(surface.positions[v], farFromFrame);
            Finding& finding = worst[seam->curve];
            if (distance <= allowed || distance <= finding.value)
                continue;
            finding = {Finding::Kind::OffFrame,
                       seam->curve,
                       Finding::Place{seam->stretch.patch, topology.pattern[v]},
                       distance,
                       allowed,
                       {QT_TRANSLATE_NOOP("Message", "%1 holds the cloth %2 mm off the frame"),
                        {spokenName(design, seam->curve), numberText(distance, 3)}}};
        }
    }
    const auto off = std::ranges::count_if(worst, [](const auto& one) { return one.second.value > 0; });
    if (off >= manyCurves && 2 * off > std::ssize(worst))
        return; // such as legs: most of the cover is held by what nobody has modelled
    for (auto& [curve, finding] : worst)
        if (finding.value > 0)
            found.push_back(std::move(finding));
}

void findEase(const Design& design, std::vector<Finding>& found)
{
    design.each<Seam>([&](ElementId id, const Seam& seam) {
        const double ease = seamEase(design, seam);
        if (puckers(design, seam))
            found.push_back(
                {Finding::Kind::Ease,
                 id,
                 std::nullopt,
                 100 * ease,
                 100 * mostEase,
                 {QT_TRANSLATE_NOOP("Message", "The seam of %1 and %2 has %3 % ease: it puckers above %4 %"),
                  {spokenName(design, seam.a.patch), spokenName(design, seam.b.patch), numberText(100 * ease, 2),
                   numberText(100 * mostEase, 2)}}});
    });
}

} // namespace

std::vector<CoverFinding> coverFindings(const SurfaceMesh& surface, const Design& design, const DesignFiles& files,
                                        FrameDistance& frames)
{
    std::vector<Finding> found;
    findFree(*surface.topology, design, found);
    if (const TriangleTree* frame = frames.tree(design, files))
        findOffFrame(surface, design, *frame, found);
    findStrains(surface, design, found);
    findEase(design, found);
    std::ranges::stable_sort(found, [](const Finding& a, const Finding& b) {
        return a.kind != b.kind ? a.kind < b.kind : a.value / a.allowed > b.value / b.allowed;
    });
    return found;
}

} // namespace bolster
