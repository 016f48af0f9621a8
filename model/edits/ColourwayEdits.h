// Which fabrics patches are made of, and which ones they show.
#pragma once

#include "Design.h"

#include <span>

namespace bolster::edits {

/// Adds a fabric under the id design.nextId(). Its name gets a number if another one has it.
Edit addFabric(const Design& design, Fabric fabric);
/// What would lose its fabric with this one: the patches that are made of it, and those that show it under some
/// colourway. Piping is not counted.
std::vector<ElementId> patchesWith(const Design& design, ElementId fabric);
/// Removes a fabric; what is made of it, shows it or is piped with it gets the other one instead. Without another
/// one (noElement) that is possible only while no patch is made of it: see removeElements.
Edit removeFabric(const Design& design, ElementId fabric, ElementId instead);

/// What a fabric does that is dropped on patches: under a colourway they show it, else they are made of it.
Edit giveFabric(const Design& design, std::span<const ElementId> patches, ElementId fabric);

/// Makes patches of another fabric: this changes the shape, too. What a colourway says of them stays. Empty when
/// there is no such fabric.
Edit assignFabric(const Design& design, std::span<const ElementId> patches, ElementId fabric);

/// Adds a colourway under the id design.nextId(), and shows it. It begins as a copy of the one that is shown. The
/// name gets a number if another one has it.
Edit addColourway(const Design& design, const std::string& name);
/// What patches and their twins show under a colourway; with noElement for the fabric each shows its own again.
Edit setColourwayFabric(const Design& design, ElementId colourway, std::span<const ElementId> patches,
                        ElementId fabric);
/// noElement: none, each patch shows its own fabric.
Edit showColourway(const Design& design, ElementId colourway);

/// A copy of a patch shows what the patch shows, under every colourway. Without a verb.
Edit withColourOf(const Design& design, ElementId patch, ElementId copy);

} // namespace bolster::edits
