#include "Element.h"

#include "Kinds.h"
#include "PatchMark.h"

#include <algorithm>

namespace bolster {

const char* kindName(const Element& element)
{
    return std::visit([]<class T>(const T&) { return Description<T>::word; }, element);
}

bool hasName(const Element& element)
{
    return std::visit(
        [](const auto& value) {
            return requires
            {
                value.name;
            };
        },
        element);
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

const std::string& elementNote(const Element& element)
{
    static const std::string none;
    return std::visit(
        [](const auto& value) -> const std::string& {
            if constexpr (requires { value.note; })
                return value.note;
            else
                return none;
        },
        element);
}

ElementPtr withNote(const Element& element, std::string note)
{
    return std::visit(
        [&](auto value) {
            if constexpr (requires { value.note; })
                value.note = std::move(note);
            return makeElement(std::move(value));
        },
        element);
}

const std::string* elementFile(const Element& element)
{
    return std::visit(
        [](const auto& value) -> const std::string* {
            if constexpr (requires { Foam::Shape(value.shape); })
                return value.shape == Foam::Shape::Mesh ? &value.file : nullptr;
            else if constexpr (requires { value.look; })
                return value.look.kind == FabricLook::Kind::Image ? &value.look.file : nullptr;
            else if constexpr (requires { value.file; })
                return &value.file;
            else
                return nullptr;
        },
        element);
}

ElementPtr withFile(const Element& element, std::string file)
{
    return std::visit(
        [&](auto value) {
            if constexpr (requires { value.file; })
                value.file = std::move(file);
            else if constexpr (requires { value.look; })
                value.look.file = std::move(file);
            return makeElement(std::move(value));
        },
        element);
}

const char* elementFileField(const Element& element)
{
    return std::holds_alternative<Fabric>(element) ? "look.file" : "file";
}

bool hasShapeFile(const Element& element)
{
    return elementFile(element) && !std::holds_alternative<Fabric>(element);
}

const SeamTrim* seamTrim(const Element& element)
{
    return std::visit(
        [](const auto& value) -> const SeamTrim* {
            if constexpr (requires { value.trim; })
                return &value.trim;
            else
                return nullptr;
        },
        element);
}

ElementPtr withTrim(const Element& element, SeamTrim trim)
{
    return std::visit(
        [&](auto value) {
            if constexpr (requires { value.trim; })
                value.trim = std::move(trim);
            return makeElement(std::move(value));
        },
        element);
}

bool liesOnPatch(const Element& element)
{
    bool mark = false;
    visitMark(element, [&](const auto&) { mark = true; });
    return mark || seamTrim(element) || patchCurve(element) || // all that can be trimmed does
           std::holds_alternative<Measurement>(element);
}

const PatchCurve* patchCurve(const Element& element)
{
    return std::visit(
        [](const auto& value) -> const PatchCurve* {
            if constexpr (std::is_base_of_v<PatchCurve, std::remove_cvref_t<decltype(value)>>)
                return &value;
            else
                return nullptr;
        },
        element);
}

const PatchCurve* shapingCurve(const Element& element)
{
    return std::holds_alternative<InternalLine>(element) ? nullptr : patchCurve(element);
}

namespace {

/// The curve of either kind, by the member that holds it.
constexpr auto planeCurveOf = [](auto& value) {
    if constexpr (requires { value.outline; })
        return &value.outline;
    else if constexpr (std::is_base_of_v<PatchCurve, std::remove_const_t<std::remove_reference_t<decltype(value)>>>)
        return &value.curve;
    else
        return static_cast<const BSpline2*>(nullptr);
};

constexpr auto spaceCurveOf = [](auto& value) {
    using Kind = std::remove_cvref_t<decltype(value)>;
    if constexpr (std::is_same_v<Kind, HandleCurve>)
        return &value.target;
    else if constexpr (std::is_same_v<Kind, FixationCurve>)
        return &value.curve;
    else
        return static_cast<const BSpline3*>(nullptr);
};

} // namespace

const BSpline2* planeCurve(const Element& element)
{
    return std::visit([](const auto& value) -> const BSpline2* { return planeCurveOf(value); }, element);
}

const BSpline3* spaceCurve(const Element& element)
{
    return std::visit([](const auto& value) -> const BSpline3* { return spaceCurveOf(value); }, element);
}

ElementPtr withPlaneCurve(const Element& element, BSpline2 curve)
{
    return std::visit(
        [&](auto value) {
            if constexpr (std::is_same_v<decltype(planeCurveOf(value)), BSpline2*>)
                *planeCurveOf(value) = std::move(curve);
            return makeElement(std::move(value));
        },
        element);
}

ElementPtr withSpaceCurve(const Element& element, BSpline3 curve)
{
    return std::visit(
        [&](auto value) {
            if constexpr (std::is_same_v<decltype(spaceCurveOf(value)), BSpline3*>)
                *spaceCurveOf(value) = std::move(curve);
            return makeElement(std::move(value));
        },
        element);
}

const Placement* elementPlacement(const Element& element)
{
    return std::visit(
        [](const auto& value) -> const Placement* {
            if constexpr (std::is_base_of_v<Placement, std::decay_t<decltype(value)>>)
                return &value;
            else
                return nullptr;
        },
        element);
}

ElementPtr withPlacement(const Element& element, const Placement& placement)
{
    return std::visit(
        [&](auto value) {
            if constexpr (std::is_base_of_v<Placement, decltype(value)>)
                static_cast<Placement&>(value) = placement;
            return makeElement(std::move(value));
        },
        element);
}

std::string elementLabel(ElementId id, const Element& element)
{
    const bool readable = !std::holds_alternative<Quarantined>(element);
    return elementLabel(readable ? kindName(element) : "", id, elementName(element));
}

std::string shortened(std::string_view name)
{
    constexpr std::size_t longest = 80; // bytes
    if (name.size() <= longest)
        return std::string(name);
    std::size_t end = longest;
    while (end > 0 && (name[end] & 0xC0) == 0x80) // not inside a character
        --end;
    return std::string(name.substr(0, end)) + "\u2026";
}

std::string elementLabel(std::string_view kind, ElementId id, std::string_view name)
{
    std::string label = kind.empty() ? "element" : shortened(kind);
    std::replace(label.begin(), label.end(), '_', ' ');
    if (number(id) != 0)
        label.append(" ").append(std::to_string(number(id)));
    if (!name.empty())
        label.append(" \"").append(shortened(name)).append("\"");
    return label;
}

} // namespace bolster
