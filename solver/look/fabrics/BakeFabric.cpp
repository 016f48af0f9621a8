#include "BakeFabric.h"

#include "Imaging.h"
#include "LinearLight.h"

#include <algorithm>
#include <array>

namespace bolster {

FabricMapsPtr bakeFabric(const Fabric& fabric, const ImagePixels* image, const BakeOptions& options)
{
    return imaging().bake(fabric, image, options);
}

bool looksAlike(const Fabric& a, const Fabric& b)
{
    FabricLook turned = b.look;
    turned.rotation = a.look.rotation;
    return a.color == b.color && a.look == turned;
}

std::string meanColor(const FabricMaps& maps)
{
    Eigen::Array3d sum = Eigen::Array3d::Zero();
    std::array<float, 256> light{};
    for (std::size_t i = 0; i < light.size(); ++i)
        light[i] = toLinear(static_cast<float>(i) / 255);
    for (std::size_t i = 0; i + 3 < maps.albedo.size(); i += 4)
        for (std::size_t c = 0; c < 3; ++c)
            sum[static_cast<Eigen::Index>(c)] += light[maps.albedo[i + c]];
    const double pixels = std::max<double>(1, static_cast<double>(maps.albedo.size()) / 4);
    return textOf((sum / pixels).cast<float>());
}

} // namespace bolster
