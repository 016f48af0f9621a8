// One thing that the user made.
#pragma once

#include "Fabric.h"
#include "FixationCurve.h"
#include "FixationSeam.h"
#include "Frame.h"
#include "Patch.h"
#include "Quarantined.h"
#include "Scan.h"
#include "Seam.h"
#include "Settings.h"

#include <memory>
#include <string_view>
#include <variant>

namespace bolster {

using Element = std::variant<Settings, Fabric, Patch, Seam, FixationCurve, FixationSeam, Frame, Scan, Quarantined>;
using ElementPtr = std::shared_ptr<const Element>;

template <class T>
ElementPtr makeElement(T value)
{
    return std::make_shared<const Element>(std::move(value));
}

/// The word of the text form: "patch", "fixation_seam" ...
const char* kindName(const Element& element);
/// The element's own name, or "" for kinds without one.
const std::string& elementName(const Element& element);
/// The file that the element refers to, or null for kinds without one.
const std::string* elementFile(const Element& element);
/// The same element with another file; it must be of a kind with one.
ElementPtr withFile(const Element& element, std::string file);
/// The same element somewhere else; unchanged if it is of a kind without a place.
ElementPtr withPlacement(const Element& element, const Placement& placement);
/// Where the content of the element's file stands, or null for kinds without one.
const Placement* elementPlacement(const Element& element);
/// "patch 2 \"Seat\"", as problems name it.
std::string elementLabel(ElementId id, const Element& element);
std::string elementLabel(std::string_view kind, ElementId id, std::string_view name);

} // namespace bolster
