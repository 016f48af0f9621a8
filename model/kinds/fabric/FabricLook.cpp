#include "FabricLook.h"

namespace bolster {

FabricLook usualLook(FabricLook::Kind kind)
{
    using Kind = FabricLook::Kind;
    FabricLook look;
    look.kind = kind;
    switch (kind) {
    case Kind::Plain:
        break;
    case Kind::Checker:
        look.scale = 20;
        break;
    case Kind::SmoothLeather:
        look.roughness = 0.35;
        look.scale = 1.5;
        break;
    case Kind::GrainedLeather:
        look.roughness = 0.5;
        look.scale = 2.8;
        break;
    case Kind::Woven:
        look.roughness = 0.85;
        look.scale = 3;
        break;
    case Kind::Velvet:
        look.roughness = 0.9;
        look.scale = 5;
        break;
    case Kind::Image:
        look.scale = 200;
        break;
    }
    return look;
}

} // namespace bolster
