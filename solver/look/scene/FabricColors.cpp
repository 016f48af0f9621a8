#include "FabricColors.h"

#include "LinearLight.h"
#include "Shading.h"

namespace bolster {

std::string secondColorShown(const Fabric& fabric)
{
    using Kind = FabricLook::Kind;
    if (!fabric.look.secondColor.empty())
        return fabric.look.secondColor;
    const Light color = lightOf(fabric.color);
    switch (fabric.look.kind) {
    case Kind::Checker:
        return textOf(shading::lightSquare(color));
    case Kind::SmoothLeather:
    case Kind::GrainedLeather:
        return textOf(0.5f * color);
    case Kind::Woven:
        return textOf((1.3f * color + 0.01f).min(1.f));
    case Kind::Velvet:
        return textOf(0.35f * color);
    case Kind::Plain:
    case Kind::Image:
        break;
    }
    return textOf(color);
}

} // namespace bolster
