#include "SolveFailure.h"

#include "Element.h"
#include "Relaxation.h"
#include "SpokenName.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <optional>

namespace bolster {

namespace {

constexpr double farAway = 100;     // D between what holds a cover: no cloth reaches that far
constexpr double highPressure = 10; // in units of the stretch stiffness: a balloon bursts long before

using Part = SewnMesh::Part;

/// The seam or handle that holds an unknown.
ElementId holderOf(const SewnMesh& mesh, std::uint32_t unknown)
{
    const SurfaceTopology& topology = *mesh.topology;
    const auto holds = [&](const std::vector<std::uint32_t>& chain) {
        return std::ranges::any_of(chain, [&](std::uint32_t v) { return topology.unknown[v] == unknown; });
    };
    for (const SurfaceTopology::Chain& chain : topology.fixations)
        if (holds(chain.a))
            return chain.seam;
    for (const SurfaceTopology::Line& line : topology.lines)
        if (holds(line.vertices))
            return line.element;
    return {};
}

/// What holds the cover farthest from the middle of all that does; nothing when that is not far.
std::optional<SolveFailure> farHolder(const SewnMesh& mesh, const Design& design, const std::string& iterations)
{
    if (mesh.targets.empty())
        return std::nullopt;
    std::array<std::vector<double>, 3> all;
    for (const Vec3& target : mesh.targets)
        for (std::size_t axis = 0; axis < 3; ++axis)
            all[axis].push_back(target[static_cast<Eigen::Index>(axis)]);
    Vec3 middle;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto median = all[axis].begin() + static_cast<std::ptrdiff_t>(all[axis].size() / 2);
        std::ranges::nth_element(all[axis], median);
        middle[static_cast<Eigen::Index>(axis)] = *median;
    }
    const auto farthest =
        std::ranges::max_element(mesh.targets, {}, [&](const Vec3& target) { return (target - middle).norm(); });
    const double distance = (*farthest - middle).norm();
    if (distance < farAway * mesh.largestDiameter())
        return std::nullopt;
    const auto unknown = static_cast<std::uint32_t>(mesh.freeCount + (farthest - mesh.targets.begin()));
    const ElementId holder = holderOf(mesh, unknown);
    return SolveFailure{{QT_TRANSLATE_NOOP("Message", "The surface ran away after %1 iterations: %2 holds it %3 mm "
                                                      "from everything else. Bring that curve nearer."),
                         {iterations, spokenName(design, holder), numberText(distance)}},
                        holder};
}

const Part& mostPressed(const SewnMesh& mesh)
{
    return *std::ranges::max_element(mesh.parts, {}, [](const Part& part) {
        return std::abs(part.material.pressure) / std::max(1e-9, part.material.stiffness);
    });
}

/// The part whose size is farthest from that of the middle one.
const Part& oddestSize(const SewnMesh& mesh)
{
    std::vector<double> areas;
    for (const Part& part : mesh.parts)
        areas.push_back(part.area);
    const auto median = areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 2);
    std::ranges::nth_element(areas, median);
    const double middle = *median;
    return *std::ranges::max_element(mesh.parts, {}, [&](const Part& part) {
        const double odds = std::abs(std::log(part.area / middle));
        return std::isfinite(odds) ? odds : 1e30;
    });
}

} // namespace

Message failureMessage(const std::exception& error)
{
    if (dynamic_cast<const std::bad_alloc*>(&error))
        return {QT_TRANSLATE_NOOP("Message",
                                  "There is not enough memory for this surface. Choose a larger edge length."),
                {}};
    return {QT_TRANSLATE_NOOP("Message", "The solver failed: %1. The last good surface is kept."), {error.what()}};
}

SolveFailure explainFailure(const Relaxation& failed, const Design& design)
{
    const SewnMesh& mesh = failed.mesh();
    const std::string iterations = std::to_string(failed.iterations());
    const Part& odd = oddestSize(mesh);
    if (!failed.ranAway())
        return {
            {QT_TRANSLATE_NOOP("Message", "The equations of the cover could not be solved: %1 is degenerate or its "
                                          "numbers are too large. Check its outline and its fabric."),
             {spokenName(design, odd.patch)}},
            odd.patch};
    const Part& pressed = mostPressed(mesh);
    if (std::abs(pressed.material.pressure) > highPressure * pressed.material.stiffness)
        return {
            {QT_TRANSLATE_NOOP("Message", "The surface ran away after %1 iterations: the pressure of %2 (%3) is "
                                          "too high for its fabric. Lower it."),
             {iterations, spokenName(design, pressed.patch), numberText(pressed.material.pressure)}},
            pressed.patch};
    if (std::optional<SolveFailure> far = farHolder(mesh, design, iterations))
        return std::move(*far);
    return {
        {QT_TRANSLATE_NOOP("Message", "The surface ran away after %1 iterations, most likely because of %2. Check "
                                      "the size of that patch, its pressure and its fabric."),
         {iterations, spokenName(design, odd.patch)}},
        odd.patch};
}

} // namespace bolster
