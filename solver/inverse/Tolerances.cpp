#include "Tolerances.h"

#include <cmath>
#include <numbers>

namespace bolster {

namespace {

/// A number from 0 to 1 that looks random. Source: Steele et al., "Fast splittable pseudorandom number generators",
/// 2014 (SplitMix).
double mixed(std::uint64_t seed, std::uint64_t sample, std::uint64_t which)
{
    std::uint64_t z = seed * 0x9e3779b97f4a7c15ULL + sample * 0xbf58476d1ce4e5b9ULL + which * 0x94d049bb133111ebULL;
    for (int round = 0; round < 2; ++round) {
        z += 0x9e3779b97f4a7c15ULL;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
        z ^= z >> 31U;
    }
    return (static_cast<double>(z >> 11U) + 0.5) * 0x1.0p-53;
}

std::vector<Tolerance> each(std::vector<Freedom> freedoms, double spread)
{
    std::vector<Tolerance> tolerances;
    for (Freedom& freedom : freedoms) {
        const std::string name = freedom.name;
        const double step = freedom.step;
        tolerances.push_back({{std::move(freedom)}, spread / step, name});
    }
    return tolerances;
}

} // namespace

std::vector<Tolerance> cutTolerances(const Design& design, double spread)
{
    std::vector<Freedom> freedoms;
    design.each<Patch>([&](ElementId id, const Patch& patch) {
        freedoms.push_back({.kind = Freedom::Kind::Offset, .element = id, .name = "cut of " + patch.name});
    });
    return each(std::move(freedoms), spread);
}

std::vector<Tolerance> seamTolerances(const Design& design, double spread)
{
    std::vector<Tolerance> tolerances;
    const auto patchName = [&](ElementId id) {
        const auto* patch = design.find<Patch>(id);
        return patch ? patch->name : std::string();
    };
    design.each<Seam>([&](ElementId id, const Seam& seam) {
        Tolerance tolerance;
        for (const Stretch* side : {&seam.a, &seam.b})
            tolerance.freedoms.push_back(
                {.kind = Freedom::Kind::Offset, .element = side->patch, .from = side->from, .to = side->to});
        tolerance.spread = spread;
        tolerance.seam = id;
        tolerance.name = "seam " + std::to_string(number(id)) + ", " + patchName(seam.a.patch) + " to " +
                         patchName(seam.b.patch);
        tolerances.push_back(std::move(tolerance));
    });
    return tolerances;
}

std::vector<Tolerance> foamTolerances(const Design& design, double spread)
{
    std::vector<Tolerance> tolerances = each(foamFreedoms(design), spread);
    for (Tolerance& tolerance : tolerances)
        tolerance.whole = true;
    return tolerances;
}

std::vector<Tolerance> fixationTolerances(const Design& design, double spread)
{
    return each(fixationFreedoms(design), spread);
}

std::vector<Tolerance> stiffnessTolerances(const Design& design, double spread)
{
    std::vector<Tolerance> tolerances;
    design.each<Fabric>([&](ElementId id, const Fabric& fabric) {
        Freedom freedom{.kind = Freedom::Kind::Number, .element = id, .field = "stiffness"};
        freedom.step = fabric.stiffness / 100;
        tolerances.push_back({{std::move(freedom)}, spread, "stiffness of " + fabric.name});
    });
    return tolerances;
}

std::vector<Tolerance> sizeTolerances(const Design& design, double spread)
{
    std::vector<Freedom> freedoms;
    design.each<Patch>([&](ElementId id, const Patch& patch) {
        freedoms.push_back({.kind = Freedom::Kind::Size, .element = id, .name = "size of " + patch.name});
    });
    return each(std::move(freedoms), spread);
}

Eigen::VectorXd sampleOf(const Tolerances& tolerances, std::uint64_t number)
{
    Eigen::VectorXd values(std::ssize(tolerances.all));
    for (Eigen::Index k = 0; k < values.size(); ++k) {
        const auto which = static_cast<std::uint64_t>(2 * k);
        double value = 2 * mixed(tolerances.seed, number, which) - 1;
        if (tolerances.normal) // Box and Muller
            value = std::sqrt(-2 * std::log(mixed(tolerances.seed, number, which))) *
                    std::cos(2 * std::numbers::pi * mixed(tolerances.seed, number, which + 1)) / 3;
        const Tolerance& tolerance = tolerances.all[static_cast<std::size_t>(k)];
        values[k] = value * tolerance.spread;
        if (tolerance.whole)
            values[k] = std::round(values[k]);
    }
    return values;
}

Design sampleDesign(const Design& design, const Tolerances& tolerances, const Eigen::VectorXd& values)
{
    std::vector<Freedom> freedoms;
    std::vector<double> numbers;
    for (std::size_t k = 0; k < tolerances.all.size(); ++k)
        for (const Freedom& freedom : tolerances.all[k].freedoms) {
            freedoms.push_back(freedom);
            numbers.push_back(values[static_cast<Eigen::Index>(k)] * freedom.step);
        }
    return withFreedoms(design, freedoms, Eigen::Map<Eigen::VectorXd>(numbers.data(), std::ssize(numbers)));
}

} // namespace bolster
