#include "Element.h"

#include <algorithm>
#include <array>

namespace bolster {

const char* kindName(const Element& element)
{
    static constexpr std::array<const char*, std::variant_size_v<Element>> names = {
        "settings", "fabric", "patch", "seam", "fixation_curve", "fixation_seam", "frame", "unreadable"};
    return names[element.index()];
}

const std::string& elementName(const Element& element)
{
    static const std::string none;
    return std::visit(
        [](const auto& value) -> const std::string& {
            if constexpr (requires { value.name; })
                return value.name;
            else
                return none;
        },
        element);
}

std::string elementLabel(ElementId id, const Element& element)
{
    std::string label = std::holds_alternative<Quarantined>(element) ? "element" : kindName(element);
    std::replace(label.begin(), label.end(), '_', ' ');
    if (!std::holds_alternative<Settings>(element))
        label.append(" ").append(std::to_string(number(id)));
    if (const std::string& name = elementName(element); !name.empty())
        label.append(" \"").append(name).append("\"");
    return label;
}

} // namespace bolster
