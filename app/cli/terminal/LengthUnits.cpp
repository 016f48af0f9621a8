#include "LengthUnits.h"

#include <cmath>

namespace bolster::cli {

std::optional<double> saidUnit(const Arguments& arguments, std::span<const LengthUnit> units)
{
    if (!arguments.has("--unit"))
        return std::nullopt;
    const std::string said = arguments.path("--unit").toStdString();
    std::string words;
    for (std::size_t i = 0; i < units.size(); ++i) {
        if (said == units[i].word)
            return units[i].millimetres;
        words.append(i == 0 ? "" : i + 1 < units.size() ? ", " : " or ").append(units[i].word);
    }
    throw UsageError("--unit is " + words + ", not \"" + said + "\"");
}

std::optional<std::string> unitName(double millimetres, std::span<const LengthUnit> units)
{
    for (const LengthUnit& unit : units)
        if (std::abs(unit.millimetres / millimetres - 1) < 1e-6)
            return unit.many;
    return std::nullopt;
}

std::optional<bool> saysUpIsY(const Arguments& arguments)
{
    if (!arguments.has("--up"))
        return std::nullopt;
    const std::string said = arguments.path("--up").toStdString();
    if (said != "y" && said != "z")
        throw UsageError("--up is y or z, not \"" + said + "\"");
    return said == "y";
}

} // namespace bolster::cli
