#include "FancySeam.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

double fancyProfile(Profile profile, double u)
{
    const double x = std::min(std::abs(u), 1.0);
    switch (profile) {
    case Profile::Round:
        return 0.5 + 0.5 * std::cos(std::numbers::pi * x);
    case Profile::Sharp:
        return (1 - x) * (1 - x);
    case Profile::Welt:
        return 1 - x * x;
    }
    return 0;
}

} // namespace bolster
