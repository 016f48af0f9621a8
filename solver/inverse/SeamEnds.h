// Where stretches of outlines end that are sewn or fixed: they move along the outline, and what is sampled with
// them.
#pragma once

#include "Design.h"

#include <optional>
#include <span>
#include <vector>

namespace bolster {

struct MovedSeamEnd {
    ElementId patch{};
    double at = 0; ///< parameter of the outline; every stretch of the patch that begins or ends there goes along
    double by = 0; ///< mm along the outline, towards greater parameters
};

/// Parameters at which stretches of a patch begin or end, increasing, each once.
std::vector<double> seamEnds(const Design& design, ElementId patch);

/// `at` is meant in the design as it is: all ends move at once.
Design withSeamEnds(const Design& design, std::span<const MovedSeamEnd> moved);

/// The design with its stretches where they are in another one, for those that both have.
Design withStretchesOf(const Design& design, const Design& other);

/// Parameters of samples of a patch's outline after its stretches have changed from those of `before` to those of
/// `after`: evenly between the ends, corners stay. Nothing when ends have passed each other.
std::optional<std::vector<double>> slidSamples(const std::vector<double>& parameters, const Design& before,
                                               const Design& after, ElementId patch);

} // namespace bolster
