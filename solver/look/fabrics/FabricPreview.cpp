#include "FabricPreview.h"

#include "LinearLight.h"
#include "PeriodicNoise.h"
#include "Shading.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace bolster {

namespace {

using Vec = Eigen::Vector3f;
using Shape = FabricPreviewOptions::Shape;

constexpr float shapeSize = 0.94f; ///< of the picture

/// Per pixel and direction: the maps are finer than the picture.
int samplesAcross(int pixels)
{
    return std::clamp(600 / pixels + 1, 3, 6);
}

/// A place of the shape seen from straight ahead: where on the fabric, half widths of the picture, and how it
/// faces.
struct Place {
    Spot cloth;
    Vec normal;
};

/// The fabric lies on the ball as on a globe seen from above its pole: what faces the eye has its real size.
std::optional<Place> onBall(const Spot& at)
{
    const float r2 = at.squaredNorm();
    if (r2 >= 1)
        return std::nullopt;
    const float r = std::sqrt(std::max(r2, 1e-8f));
    return Place{at * (shapeSize * std::asin(r) / r), Vec(at.x(), at.y(), std::sqrt(1 - r2))};
}

/// A square panel, filled: its sides are drawn in between the corners, and the fabric goes with them.
std::optional<Place> onCushion(const Spot& at)
{
    constexpr float drawnIn = 0.10f;
    const Spot drawn(at.x() * (1 + drawnIn * (1 - at.y() * at.y())),
                     at.y() * (1 + drawnIn * (1 - at.x() * at.x())));
    const float x2 = drawn.x() * drawn.x(), y2 = drawn.y() * drawn.y();
    if (x2 >= 1 || y2 >= 1)
        return std::nullopt;
    const float height = 0.62f * std::sqrt((1 - x2) * (1 - y2));
    const float over = std::max(height, 0.05f);
    const Vec slope(0.38f * drawn.x() * (1 - y2) / over, 0.38f * drawn.y() * (1 - x2) / over, 1);
    return Place{drawn * ((1 + 0.12f * drawn.squaredNorm()) * shapeSize / (1 + drawnIn)), slope.normalized()};
}

/// x and y from -1 to 1 over the picture.
std::optional<Place> placeAt(Shape shape, const Spot& at)
{
    switch (shape) {
    case Shape::Ball:
        return onBall(at / shapeSize);
    case Shape::Cushion:
        return onCushion(at / shapeSize);
    case Shape::Flat:
        break;
    }
    return Place{at, Vec::UnitZ()};
}

struct Cloth {
    Light color;
    Vec relief;
    float roughness;
};

/// Of a byte of the albedo: a curve that is too slow for each sample.
float lightOfByte(std::uint8_t encoded)
{
    static const auto lights = [] {
        std::array<float, 256> table{};
        for (std::size_t i = 0; i < table.size(); ++i)
            table[i] = toLinear(static_cast<float>(i) / 255);
        return table;
    }();
    return lights[encoded];
}

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
        cloth.color[static_cast<Eigen::Index>(c)] = lightOfByte(maps.albedo[4 * i + c]);
        cloth.relief[static_cast<Eigen::Index>(c)] = static_cast<float>(maps.normal[3 * i + c]) / 127.5f - 1;
    }
    cloth.roughness = static_cast<float>(maps.roughness[i]) / 255;
    return cloth;
}

/// A light with a surface, seen with the eye straight ahead.
struct Lamp {
    Lamp(const Vec& towards, const Light& ofColor, float addsToHighlights)
        : direction(towards.normalized())
        , half((direction + Vec::UnitZ()).normalized())
        , size(addsToHighlights)
        , color(ofColor)
    {}

    float wrapped(const Vec& n, float by) const { return shading::wrapped(n.dot(direction), by); }
    float highlight(const Vec& n, float roughness) const
    {
        return shading::glossy(std::max(0.f, n.dot(direction)), std::max(0.f, n.dot(half)), direction.dot(half),
                               std::min(1.f, roughness * roughness + size), roughness);
    }

    Vec direction, half;
    float size;
    Light color;
};

/// The room of studio.glsl, with the key light to the left as in a catalogue, and softer lights.
const Lamp key(Vec(-0.45f, 0.62f, 0.64f), shading::keyColor, 0.22f);
const Lamp rim(Vec(0.75f, 0.35f, -0.1f), shading::rimColor, 0.15f);

Light shaded(const Cloth& cloth, const Vec& n, float sheen)
{
    const float facing = std::clamp(n.z(), 0.03f, 1.f);
    const Light fuzz = shading::fuzzOf({cloth.color, cloth.roughness, sheen, shading::clothSpecular}, facing);
    const float up = 2 * n.z() * n.y(); // of the eye's direction, reflected
    const Light room = shading::roomSeen(up, cloth.roughness);
    return key.color * (cloth.color * key.wrapped(n, 0.15f) + fuzz * key.wrapped(n, 0.5f) +
                        shading::clothSpecular * key.highlight(n, cloth.roughness)) +
           rim.color * (cloth.color * rim.wrapped(n, 0.1f) + fuzz * rim.wrapped(n, 0.5f) +
                        0.08f * rim.highlight(n, cloth.roughness)) +
           shading::skyLight(n.y()) * (cloth.color + fuzz) +
           room * shading::reflected(shading::clothSpecular, cloth.roughness, std::max(facing, 0.15f));
}

/// The fabric as it lies on the shape.
class Laid {
public:
    Laid(const FabricMaps& maps, const FabricPreviewOptions& options)
        : m_maps(maps)
        , m_halfWidth(static_cast<float>(options.width / 2))
        , m_turn(Eigen::Rotation2Df(static_cast<float>(options.rotation)).toRotationMatrix())
    {}

    Light lightAt(const Place& place) const
    {
        const Cloth cloth = clothAt(m_maps, m_turn.transpose() * place.cloth * m_halfWidth);
        const Spot relief = m_turn * cloth.relief.head<2>();
        const Vec& n = place.normal;
        const Vec right = Vec(1 - n.x() * n.x(), -n.x() * n.y(), -n.x() * n.z()).normalized(), up = n.cross(right);
        return shaded(cloth, (relief.x() * right + relief.y() * up + cloth.relief.z() * n).normalized(),
                      static_cast<float>(m_maps.sheen));
    }

private:
    const FabricMaps& m_maps;
    float m_halfWidth; ///< mm
    Eigen::Matrix2f m_turn;
};

/// Samples count for the pixels around them by their distance (a tent two pixels wide): averages over single
/// pixels would let fine weaves beat against the pixels.
class Film {
public:
    explicit Film(int size)
        : m_size(size)
        , m_pixels(static_cast<std::size_t>(size) * static_cast<std::size_t>(size))
    {}

    /// `at` in pixels; without light it is see-through.
    void add(const Spot& at, const std::optional<Light>& light)
    {
        const Spot from = at.array() - 0.5f;
        const int left = static_cast<int>(std::floor(from.x())), top = static_cast<int>(std::floor(from.y()));
        const float right = from.x() - static_cast<float>(left), below = from.y() - static_cast<float>(top);
        addTo(left, top, (1 - right) * (1 - below), light);
        addTo(left + 1, top, right * (1 - below), light);
        addTo(left, top + 1, (1 - right) * below, light);
        addTo(left + 1, top + 1, right * below, light);
    }

    std::vector<std::uint8_t> rgba() const
    {
        std::vector<std::uint8_t> bytes;
        bytes.reserve(4 * m_pixels.size());
        for (const Pixel& pixel : m_pixels) {
            const Light light = pixel.covered > 0 ? Light(pixel.light / pixel.covered) : Light::Zero();
            for (int c = 0; c < 3; ++c)
                bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * displayed(light[c]))));
            bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * pixel.covered / pixel.weight)));
        }
        return bytes;
    }

private:
    struct Pixel {
        Light light = Light::Zero();
        float covered = 0;
        float weight = 0;
    };

    void addTo(int x, int y, float weight, const std::optional<Light>& light)
    {
        if (x < 0 || y < 0 || x >= m_size || y >= m_size)
            return;
        Pixel& pixel = m_pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size) + x];
        pixel.weight += weight;
        if (!light)
            return;
        pixel.light += weight * *light;
        pixel.covered += weight;
    }

    /// Bright light is drawn in gently, so that highlights keep their colour.
    static float displayed(float light) { return toEncoded(shading::toned(light, 0.7f)); }

    int m_size;
    std::vector<Pixel> m_pixels;
};

} // namespace

ImagePixelsPtr fabricPreview(const FabricMaps& maps, const FabricPreviewOptions& options)
{
    const auto picture = std::make_shared<ImagePixels>();
    picture->width = picture->height = std::clamp(options.pixels, 8, 1024);
    if (!maps.complete())
        return picture;
    const int size = picture->width, samples = samplesAcross(size), fine = size * samples;
    const Laid fabric(maps, options);
    Film film(size);
    for (int y = 0; y < fine; ++y)
        for (int x = 0; x < fine; ++x) {
            const Spot at = (Spot(x, y).array() + 0.5f) / static_cast<float>(samples); // pixels
            const std::optional<Place> place =
                placeAt(options.shape, Spot(2 * at.x() / size - 1, 1 - 2 * at.y() / size));
            film.add(at, place ? std::optional(fabric.lightAt(*place)) : std::nullopt);
        }
    picture->rgba = film.rgba();
    return picture;
}

} // namespace bolster
