// Editing rules that hold for elements of every kind.
#pragma once

#include "Design.h"

#include <span>

namespace bolster::edits {

/// Adds an element under a fresh id: that of the edit's only change.
Edit addElement(const Design& design, ElementPtr element);
/// Replaces an element; empty when the content is the same.
Edit replaceElement(const Design& design, ElementId id, ElementPtr element, Message verb);
/// Where another element of its kind has that name, it gets a number, and the edit's note says so.
Edit renameElement(const Design& design, ElementId id, const std::string& name);
/// What people write at it; spaces at its ends are left out.
Edit changeNote(const Design& design, ElementId id, const std::string& note);
/// The element with a name that no other one of its kind has.
ElementPtr withFreeName(const Design& design, const Element& element);
/// Removes elements and everything that refers to them (seams of a patch, fixation seams of a curve, cushions of a
/// frame and their foam). Patches of a removed fabric are kept: fabrics in use are not removed. Colourways lose
/// what they say of removed patches and fabrics, piping of a removed fabric takes that of its patch.
Edit removeElements(const Design& design, std::span<const ElementId> ids);
Edit changeSettings(const Design& design, const Settings& settings);

} // namespace bolster::edits
