#include "ElementStretches.h"

#include "PatchMark.h"

namespace bolster {

std::vector<Stretch> stretchesOf(const Element& element)
{
    if (const auto* seam = std::get_if<Seam>(&element))
        return {seam->a, seam->b};
    if (const auto* fixation = std::get_if<FixationSeam>(&element))
        return {fixation->stretch};
    std::vector<Stretch> result;
    visitMark(element, [&](const auto& mark) {
        if constexpr (requires { mark.stretch; })
            result = {mark.stretch};
    });
    return result;
}

ElementPtr withStretches(const Element& element, const std::vector<Stretch>& stretches)
{
    Element result = element;
    if (auto* seam = std::get_if<Seam>(&result)) {
        seam->a = stretches[0];
        seam->b = stretches[1];
    } else if (auto* fixation = std::get_if<FixationSeam>(&result)) {
        fixation->stretch = stretches[0];
    } else if (auto* trimmed = std::get_if<OutlineTrim>(&result)) {
        trimmed->stretch = stretches[0];
    } else if (auto* allowance = std::get_if<EdgeAllowance>(&result)) {
        allowance->stretch = stretches[0];
    }
    return std::make_shared<const Element>(std::move(result));
}

} // namespace bolster
