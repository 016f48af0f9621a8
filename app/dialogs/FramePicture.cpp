#include "FramePicture.h"

#include <QColor>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bolster {
namespace {

constexpr std::uint32_t mostTrianglesDrawn = 300'000; // triangles
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

class MeshDrawing {
public:
    MeshDrawing(const TriangleMesh& mesh, const Eigen::Matrix3d& view, QSize size)
        : m_mesh(mesh)
        , m_view(view)
        , m_image(size, QImage::Format_ARGB32_Premultiplied)
        , m_depth(static_cast<std::size_t>(size.width()) * static_cast<std::size_t>(size.height()),
                  -std::numeric_limits<float>::infinity())
    {
        m_image.fill(Qt::transparent);
    }

    QImage draw(const std::vector<std::uint32_t>& triangles)
    {
        Box3 box;
        for (const std::uint32_t triangle : triangles)
            for (const std::uint32_t corner : m_mesh.triangles[triangle])
                box.extend(Vec3(m_view * m_mesh.points[corner]));
        if (box.isEmpty() || !(box.sizes().maxCoeff() > 0))
            return m_image;
        const Vec3 size = box.sizes();
        m_scale = 0.94 * std::min(m_image.width() / std::max(size.x(), 1e-12),
                                  m_image.height() / std::max(size.y(), 1e-12));
        m_middle = box.center();
        for (const std::uint32_t triangle : triangles)
            drawTriangle(triangle);
        return m_image;
    }

private:
    /// Pixels; z towards whoever looks.
    Eigen::Vector3f pixelOf(std::uint32_t corner) const
    {
        const Vec3 at = m_scale * (m_view * m_mesh.points[corner] - m_middle);
        return Vec3(at.x() + m_image.width() / 2.0, m_image.height() / 2.0 - at.y(), at.z()).cast<float>();
    }

    void drawTriangle(std::uint32_t triangle)
    {
        const auto& [i, j, k] = m_mesh.triangles[triangle];
        const Eigen::Vector3f a = pixelOf(i), b = pixelOf(j), c = pixelOf(k);
        const Eigen::Vector3f normal = (b - a).cross(c - a).normalized();
        const Eigen::Vector3f light = Eigen::Vector3f(-0.35F, -0.6F, 0.72F).normalized();
        const float bright = normal.allFinite() ? 0.35F + 0.65F * std::abs(normal.dot(light)) : 0.5F;
        const QRgb color =
            qRgb(static_cast<int>(205 * bright), static_cast<int>(196 * bright), static_cast<int>(184 * bright));
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

    const TriangleMesh& m_mesh;
    Eigen::Matrix3d m_view;
    QImage m_image;
    std::vector<float> m_depth;
    double m_scale = 1;
    Vec3 m_middle = Vec3::Zero();
};

} // namespace

QImage framePicture(const TriangleMesh& mesh, const std::vector<bool>& wanted, const Quat& turn, QSize size)
{
    const auto step = static_cast<std::uint32_t>(1 + mesh.triangles.size() / mostTrianglesDrawn);
    std::vector<std::uint32_t> drawn;
    if (mesh.parts.empty())
        for (std::uint32_t i = 0; i < mesh.triangles.size(); i += step)
            drawn.push_back(i);
    for (std::size_t part = 0; part < mesh.parts.size(); ++part)
        if (wanted.empty() || wanted[part])
            for (std::uint32_t i = 0; i < mesh.parts[part].triangleCount; i += step)
                drawn.push_back(mesh.parts[part].firstTriangle + i);
    const Eigen::Matrix3d view = viewFrom(30 * degree, 20 * degree) * turn.toRotationMatrix();
    return MeshDrawing(mesh, view, size).draw(drawn);
}

} // namespace bolster
