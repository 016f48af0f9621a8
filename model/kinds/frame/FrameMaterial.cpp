#include "FrameMaterial.h"

namespace bolster {

std::string colorShown(const FrameMaterial& material)
{
    if (!material.color.empty())
        return material.color;
    switch (material.kind) {
    case FrameMaterial::Kind::Plain:
        break;
    case FrameMaterial::Kind::Wood:
        return "#9a6a3c";
    case FrameMaterial::Kind::Metal:
        return "#b4b8bd";
    case FrameMaterial::Kind::Plastic:
        return "#2a2c2f";
    case FrameMaterial::Kind::Foam:
        return "#e2d4a8";
    }
    return "#adafb3";
}

} // namespace bolster
