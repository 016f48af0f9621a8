#include "FramePicture.h"

#include "PointShades.h"

#include <QColor>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bolster {
namespace {

constexpr std::uint32_t mostTrianglesDrawn = 300'000; // triangles
constexpr std::size_t mostPointsDrawn = 100'000;
constexpr double degree = std::numbers::pi / 180;

/// Rows: to the right, up, and towards whoever looks.
Eigen::Matrix3d viewFrom(double azimuth, double elevation)
{
    const Vec3 towards(std::sin(azimuth) * std::cos(elevation), -std::cos(azimuth) * std::cos(elevation),
                       std::sin(elevation));
    const Vec3 right = Vec3::UnitZ().cross(towards).normalized();
    Eigen::Matrix3d view;
    view << right.transpose(), towards.cross(right).transpose(), towards.transpose();
    return view;
}

/// What is nearer hides what is farther.
class SmallPicture {
public:
    SmallPicture(const Eigen::Matrix3d& view, QSize size)
        : m_view(view)
        , m_image(size, QImage::Format_ARGB32_Premultiplied)
        , m_depth(static_cast<std::size_t>(size.width()) * static_cast<std::size_t>(size.height()),
                  -std::numeric_limits<float>::infinity())
    {
        m_image.fill(Qt::transparent);
    }

    const QImage& image() const { return m_image; }
    Vec3 turned(const Vec3& point) const { return m_view * point; }

    /// `box` of turned points. Nothing can be drawn into one without a size.
    bool fit(const Box3& box)
    {
        if (box.isEmpty() || !(box.sizes().maxCoeff() > 0))
            return false;
        const Vec3 size = box.sizes();
        m_scale = 0.94 * std::min(m_image.width() / std::max(size.x(), 1e-12),
                                  m_image.height() / std::max(size.y(), 1e-12));
        m_middle = box.center();
        return true;
    }

    void addPoint(const Vec3& point, QRgb color)
    {
        const Eigen::Vector3f at = pixelOf(point);
        if (!at.allFinite() || at.cwiseAbs().maxCoeff() > 1e6F)
            return;
        for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}})
            draw(static_cast<int>(at.x()) + x, static_cast<int>(at.y()) + y, at.z(), color);
    }

    void addTriangle(const Vec3& first, const Vec3& second, const Vec3& third, const QColor& lit)
    {
        const Eigen::Vector3f a = pixelOf(first), b = pixelOf(second), c = pixelOf(third);
        const Eigen::Vector3f normal = (b - a).cross(c - a).normalized();
        const Eigen::Vector3f light = Eigen::Vector3f(-0.35F, -0.6F, 0.72F).normalized();
        const float bright = normal.allFinite() ? 0.35F + 0.65F * std::abs(normal.dot(light)) : 0.5F;
        const QRgb color = qRgb(static_cast<int>(static_cast<float>(lit.red()) * bright),
                                static_cast<int>(static_cast<float>(lit.green()) * bright),
                                static_cast<int>(static_cast<float>(lit.blue()) * bright));
        const float area = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
        if (area == 0 || !std::isfinite(area))
            return;
        const Eigen::Vector3f middle = (a + b + c) / 3;
        draw(static_cast<int>(middle.x()), static_cast<int>(middle.y()), middle.z(), color); // it may be tiny
        const auto [left, right] = std::minmax({a.x(), b.x(), c.x()});
        const auto [top, bottom] = std::minmax({a.y(), b.y(), c.y()});
        for (int y = static_cast<int>(top); y <= static_cast<int>(bottom); ++y)
            for (int x = static_cast<int>(left); x <= static_cast<int>(right); ++x) {
                const float px = static_cast<float>(x) + 0.5F, py = static_cast<float>(y) + 0.5F;
                const float u = ((b.x() - px) * (c.y() - py) - (b.y() - py) * (c.x() - px)) / area;
                const float v = ((c.x() - px) * (a.y() - py) - (c.y() - py) * (a.x() - px)) / area;
                if (u >= 0 && v >= 0 && u + v <= 1)
                    draw(x, y, u * a.z() + v * b.z() + (1 - u - v) * c.z(), color);
            }
    }

private:
    /// Pixels; z towards whoever looks.
    Eigen::Vector3f pixelOf(const Vec3& point) const
    {
        const Vec3 at = m_scale * (m_view * point - m_middle);
        return Vec3(at.x() + m_image.width() / 2.0, m_image.height() / 2.0 - at.y(), at.z()).cast<float>();
    }

    void draw(int x, int y, float depth, QRgb color)
    {
        if (!m_image.rect().contains(x, y))
            return;
        float& before = m_depth[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_image.width()) +
                                static_cast<std::size_t>(x)];
        if (depth <= before)
            return;
        before = depth;
        m_image.setPixel(x, y, color);
    }

    Eigen::Matrix3d m_view;
    QImage m_image;
    std::vector<float> m_depth;
    double m_scale = 1;
    Vec3 m_middle = Vec3::Zero();
};

Eigen::Matrix3d usualView(const Quat& turn)
{
    return viewFrom(30 * degree, 20 * degree) * turn.toRotationMatrix();
}

/// Without the hundredth at either end of each axis, and a little more.
Box3 mostOf(const std::vector<Vec3>& points)
{
    Box3 box;
    if (points.empty())
        return box;
    Vec3 low, high;
    std::vector<double> values(points.size());
    for (int axis = 0; axis < 3; ++axis) {
        std::ranges::transform(points, values.begin(), [axis](const Vec3& point) { return point[axis]; });
        const auto rank = static_cast<std::ptrdiff_t>(values.size() / 100);
        std::nth_element(values.begin(), values.begin() + rank, values.end());
        low[axis] = values[static_cast<std::size_t>(rank)];
        std::nth_element(values.begin(), values.end() - 1 - rank, values.end());
        high[axis] = *(values.end() - 1 - rank);
    }
    const Vec3 room = 0.04 * (high - low);
    return {Vec3(low - room), Vec3(high + room)};
}

} // namespace

QImage framePicture(const TriangleMesh& mesh, const std::vector<bool>& wanted, const Quat& turn, QSize size,
                    const std::vector<std::uint32_t>& colors)
{
    const auto step = static_cast<std::uint32_t>(1 + mesh.triangles.size() / mostTrianglesDrawn);
    const QColor plain(205, 196, 184);
    std::vector<std::pair<std::uint32_t, QColor>> drawn;
    if (mesh.parts.empty())
        for (std::uint32_t i = 0; i < mesh.triangles.size(); i += step)
            drawn.emplace_back(i, plain);
    for (std::size_t part = 0; part < mesh.parts.size(); ++part) {
        const QColor color = part < colors.size() ? QColor::fromRgb(colors[part]) : plain;
        if (wanted.empty() || wanted[part])
            for (std::uint32_t i = 0; i < mesh.parts[part].triangleCount; i += step)
                drawn.emplace_back(mesh.parts[part].firstTriangle + i, color);
    }
    SmallPicture picture(usualView(turn), size);
    Box3 box;
    for (const auto& [triangle, color] : drawn)
        for (const std::uint32_t corner : mesh.triangles[triangle])
            box.extend(picture.turned(mesh.points[corner]));
    if (picture.fit(box))
        for (const auto& [triangle, color] : drawn) {
            const auto& [a, b, c] = mesh.triangles[triangle];
            picture.addTriangle(mesh.points[a], mesh.points[b], mesh.points[c], color);
        }
    return picture.image();
}

QImage scanPicture(const PointCloud& cloud, const Quat& turn, QSize size)
{
    const std::size_t step = 1 + cloud.points.size() / mostPointsDrawn;
    const bool colored = cloud.colors.size() == cloud.points.size();
    SmallPicture picture(usualView(turn), size);
    std::vector<Vec3> drawn, turned;
    for (std::size_t i = 0; i < cloud.points.size(); i += step) {
        drawn.push_back(cloud.points[i]);
        turned.push_back(picture.turned(cloud.points[i]));
    }
    if (!picture.fit(mostOf(turned)))
        return picture.image();
    const std::vector<float> shades = colored ? std::vector<float>() : pointShades(drawn);
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const auto gray = colored ? 0 : static_cast<int>(215 * shades[i]);
        picture.addPoint(drawn[i], colored ? 0xff000000U | cloud.colors[i * step] : qRgb(gray, gray, gray));
    }
    return picture.image();
}

} // namespace bolster
