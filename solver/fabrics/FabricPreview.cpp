#include "FabricPreview.h"

#include "LinearLight.h"
#include "PeriodicNoise.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace bolster {

namespace {

using Vec = Eigen::Vector3f;
using Shape = FabricPreviewOptions::Shape;

constexpr int samplesAcross = 5; ///< per pixel and direction: the maps are finer than the picture

/// A place of the shape seen from straight ahead: where on the fabric, half widths, and how it faces.
struct Place {
    Spot cloth;
    Vec normal;
};

/// How high a cushion rises over a square, and over a ball's disc; x and y from -1 to 1.
std::optional<Place> placeAt(Shape shape, Spot at)
{
    if (shape == Shape::Flat)
        return Place{at, Vec::UnitZ()};
    at /= 0.94f;
    if (shape == Shape::Ball) {
        const float r2 = at.squaredNorm();
        if (r2 >= 1)
            return std::nullopt;
        const float r = std::sqrt(std::max(r2, 1e-8f));
        return Place{at * (std::asin(r) / r), Vec(at.x(), at.y(), std::sqrt(1 - r2))};
    }
    // Its sides are drawn in between the corners, as those of a filled cushion are.
    const Spot drawn(at.x() * (1 + 0.10f * (1 - at.y() * at.y())), at.y() * (1 + 0.10f * (1 - at.x() * at.x())));
    const float x2 = drawn.x() * drawn.x(), y2 = drawn.y() * drawn.y();
    if (x2 >= 1 || y2 >= 1)
        return std::nullopt;
    const float height = 0.62f * std::sqrt((1 - x2) * (1 - y2));
    const float over = std::max(height, 0.05f);
    const Vec slope(0.38f * drawn.x() * (1 - y2) / over, 0.38f * drawn.y() * (1 - x2) / over, 1);
    return Place{drawn * (1 + 0.12f * drawn.squaredNorm()), slope.normalized()};
}

struct Cloth {
    Light color;
    Vec relief;
    float roughness;
};

Cloth clothAt(const FabricMaps& maps, const Spot& mm)
{
    const auto wrapped = [](float at, double size, int pixels) {
        const float repeat = at / static_cast<float>(size);
        return std::clamp(static_cast<int>((repeat - std::floor(repeat)) * static_cast<float>(pixels)), 0,
                          pixels - 1);
    };
    const int x = wrapped(mm.x(), maps.widthMm, maps.width), y = wrapped(-mm.y(), maps.heightMm, maps.height);
    const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(maps.width) + x;
    Cloth cloth{};
    for (std::size_t c = 0; c < 3; ++c) {
        cloth.color[static_cast<Eigen::Index>(c)] = toLinear(static_cast<float>(maps.albedo[4 * i + c]) / 255);
        cloth.relief[static_cast<Eigen::Index>(c)] = static_cast<float>(maps.normal[3 * i + c]) / 127.5f - 1;
    }
    cloth.roughness = static_cast<float>(maps.roughness[i]) / 255;
    return cloth;
}

/// GGX for a light that is large, with the visibility term of B. Karis, "Real shading in Unreal Engine 4", 2013.
float highlight(const Vec& n, const Vec& light, float roughness, float lightSize)
{
    const Vec half = (light + Vec::UnitZ()).normalized();
    const float a = std::min(1.f, roughness * roughness + lightSize), a2 = a * a;
    const float nh = std::max(0.f, n.dot(half)), lh = std::max(0.f, light.dot(half));
    const float d = nh * nh * (a2 - 1) + 1;
    return std::max(0.f, n.dot(light)) * a2 / (d * d * std::max(0.1f, lh * lh) * (4 * roughness + 2));
}

Light shaded(const Cloth& cloth, const Vec& n, float sheen)
{
    static const Vec key = Vec(-0.45f, 0.62f, 0.64f).normalized(), rim = Vec(0.75f, 0.35f, -0.1f).normalized();
    static const Light keyLight(1.02f, 0.98f, 0.92f), sky(0.50f, 0.52f, 0.56f), floor(0.25f, 0.235f, 0.22f),
        rimLight(0.30f, 0.32f, 0.37f);
    const float nv = std::clamp(n.z(), 0.03f, 1.f);
    const auto wrapped = [&](const Vec& light, float by) {
        return std::max(0.f, n.dot(light) + by) / ((1 + by) * (1 + by));
    };
    const Light fuzz = sheen * std::pow(1 - nv, 3.f) * (0.75f * cloth.color + 0.25f);
    const Light room = floor + (0.5f + 0.5f * n.y()) * (sky - floor);
    return keyLight * (cloth.color * wrapped(key, 0.15f) + fuzz * wrapped(key, 0.5f) +
                       0.04f * highlight(n, key, cloth.roughness, 0.22f)) +
           rimLight * (cloth.color * wrapped(rim, 0.1f) + fuzz * wrapped(rim, 0.5f) +
                       0.08f * highlight(n, rim, cloth.roughness, 0.15f)) +
           room * (cloth.color + fuzz + 0.04f * (1 - 0.6f * cloth.roughness));
}

struct Sample {
    Light light = Light::Zero();
    float opacity = 0;
};

Sample sampleAt(const FabricMaps& maps, const FabricPreviewOptions& options, const Spot& at)
{
    const std::optional<Place> place = placeAt(options.shape, at);
    if (!place)
        return {};
    const auto c = static_cast<float>(std::cos(options.rotation)),
               s = static_cast<float>(std::sin(options.rotation));
    const Spot mm = place->cloth * static_cast<float>(options.width / 2);
    const Cloth cloth = clothAt(maps, {c * mm.x() + s * mm.y(), c * mm.y() - s * mm.x()});
    const Vec relief(c * cloth.relief.x() - s * cloth.relief.y(), s * cloth.relief.x() + c * cloth.relief.y(),
                     cloth.relief.z());
    const Vec& n = place->normal;
    const Vec right = (Vec::UnitX() - n.x() * n).normalized(), up = n.cross(right);
    return {shaded(cloth, (relief.x() * right + relief.y() * up + relief.z() * n).normalized(),
                   static_cast<float>(maps.sheen)),
            1};
}

/// Bright light is drawn in gently, so that highlights keep their colour.
float displayed(float light)
{
    return toEncoded(light < 0.7f ? light : 0.7f + 0.3f * (1 - std::exp(-(light - 0.7f) / 0.3f)));
}

} // namespace

ImagePixelsPtr fabricPreview(const FabricMaps& maps, const FabricPreviewOptions& options)
{
    const auto picture = std::make_shared<ImagePixels>();
    picture->width = picture->height = std::clamp(options.pixels, 8, 1024);
    if (!maps.complete())
        return picture;
    const int size = picture->width, fine = size * samplesAcross;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            Sample sum;
            for (int i = 0; i < samplesAcross * samplesAcross; ++i) {
                const auto sx = static_cast<float>(x * samplesAcross + i % samplesAcross) + 0.5f;
                const auto sy = static_cast<float>(y * samplesAcross + i / samplesAcross) + 0.5f;
                const Sample one = sampleAt(maps, options, Spot(2 * sx / fine - 1, 1 - 2 * sy / fine));
                sum.light += one.light;
                sum.opacity += one.opacity;
            }
            const Light light = sum.opacity > 0 ? Light(sum.light / sum.opacity) : Light::Zero();
            for (int c = 0; c < 3; ++c)
                picture->rgba.push_back(static_cast<std::uint8_t>(std::lround(255 * displayed(light[c]))));
            picture->rgba.push_back(
                static_cast<std::uint8_t>(std::lround(255 * sum.opacity / (samplesAcross * samplesAcross))));
        }
    return picture;
}

} // namespace bolster
