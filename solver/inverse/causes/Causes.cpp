#include "Causes.h"

#include "SlippedOutline.h"
#include "TwinEdits.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bolster {

namespace {

// Half of what each may be.
constexpr double foamSpread = 5;      // mm
constexpr double strengthSpread = 25; // %
constexpr double seamSpread = 1.5;    // mm
constexpr double stretchSpread = 2.5; // %
constexpr double fixationSpread = 5;  // mm
constexpr double notchSpread = 5;     // mm

void addEach(std::vector<Cause>& causes, Cause::Kind kind, std::vector<Tolerance> tolerances)
{
    for (Tolerance& tolerance : tolerances) {
        const ElementId element = tolerance.freedoms.front().element;
        std::string name = tolerance.name;
        causes.push_back({kind, element, {std::move(tolerance)}, std::move(name)});
    }
}

void addStrengths(std::vector<Cause>& causes, const Design& design)
{
    for (const Freedom& thickness : foamFreedoms(design)) {
        const auto* cushion = design.find<Cushion>(thickness.element);
        const auto* foam = design.find<Foam>(thickness.element);
        const std::string name = (cushion ? cushion->name : foam->name) + ", strength";
        Freedom freedom{.kind = Freedom::Kind::Number, .element = thickness.element, .field = "strength"};
        freedom.step = (cushion ? cushion->strength : foam->strength) / 100;
        if (freedom.step > 0)
            causes.push_back({Cause::Kind::Strength, thickness.element, {{{freedom}, strengthSpread, name}}, name});
    }
}

void addSeams(std::vector<Cause>& causes, const Design& design)
{
    std::vector<Tolerance> tolerances = seamTolerances(design, seamSpread);
    std::size_t k = 0;
    design.each<Seam>([&](ElementId id, const Seam&) {
        std::string name = tolerances[k].name + ", allowance";
        causes.push_back({Cause::Kind::Seam, id, {std::move(tolerances[k++])}, std::move(name)});
    });
}

void addFixations(std::vector<Cause>& causes, const Design& design)
{
    for (Tolerance& tolerance : fixationTolerances(design, fixationSpread)) {
        const ElementId curve = tolerance.freedoms.front().element;
        if (causes.empty() || causes.back().kind != Cause::Kind::Fixation || causes.back().element != curve)
            causes.push_back(
                {Cause::Kind::Fixation, curve, {}, design.find<FixationCurve>(curve)->name + ", place"});
        causes.back().numbers.push_back(std::move(tolerance));
    }
}

/// Shifting either side is nearly the same, so that one is enough.
void addNotches(std::vector<Cause>& causes, const Design& design)
{
    const std::vector<Tolerance> seams = seamTolerances(design, 1); // for their names
    std::size_t k = 0;
    design.each<Seam>([&](ElementId id, const Seam& seam) {
        const std::string name = seams[k++].name + ", notch";
        for (const Stretch* side : {&seam.b, &seam.a}) {
            const auto* patch = design.find<Patch>(side->patch);
            if (!patch || slippedOutline(patch->outline, side->from, side->to, 1) == patch->outline)
                continue;
            const Freedom freedom{
                .kind = Freedom::Kind::Slip, .element = side->patch, .from = side->from, .to = side->to};
            causes.push_back({Cause::Kind::Notch, id, {{{freedom}, notchSpread, name}}, name});
            return;
        }
    });
}

} // namespace

const char* wordOf(Cause::Kind kind)
{
    static constexpr const char* words[] = {"foam", "strength", "seam", "stretch", "fixation", "notch"};
    return words[static_cast<std::size_t>(kind)];
}

const char* unitOf(Cause::Kind kind)
{
    return kind == Cause::Kind::Strength || kind == Cause::Kind::Stretch ? "%" : "mm";
}

Design withoutTwins(const Design& design)
{
    std::vector<ElementId> all;
    for (const auto& [id, element] : design.elements())
        all.push_back(id);
    return design.with(edits::unlinkTwins(design, all));
}

std::vector<Cause> possibleCauses(const Design& design)
{
    std::vector<Cause> causes;
    std::vector<Tolerance> foams = foamTolerances(design, foamSpread);
    for (Tolerance& foam : foams)
        foam.spread = std::max(1.0, std::round(foam.spread)); // foam grows by whole voxels
    addEach(causes, Cause::Kind::Foam, std::move(foams));
    addStrengths(causes, design);
    addSeams(causes, design);
    addEach(causes, Cause::Kind::Stretch, sizeTolerances(design, stretchSpread));
    addFixations(causes, design);
    addNotches(causes, design);
    return causes;
}

Design withCause(const Design& design, const Cause& cause, const Eigen::VectorXd& values)
{
    Eigen::VectorXd numbers = values;
    for (Eigen::Index k = 0; k < numbers.size(); ++k)
        numbers[k] /= unitOf(cause.numbers[static_cast<std::size_t>(k)]);
    return sampleDesign(design, {.all = cause.numbers}, numbers);
}

double unitOf(const Tolerance& tolerance)
{
    return tolerance.whole ? tolerance.freedoms.front().step : 1;
}

} // namespace bolster
