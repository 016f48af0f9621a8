// Frames that no cover presses down, whatever lies beside them.
#pragma once

#include "FrameMaterial.h"

namespace bolster {

/// Legs and posts stand out of a cover, and are not bent by it.
inline bool isStiff(const FrameMaterial& material)
{
    return material.kind == FrameMaterial::Kind::Wood || material.kind == FrameMaterial::Kind::Metal;
}

} // namespace bolster
