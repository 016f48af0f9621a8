#include "SectionHandle.h"

#include "ToolGeometry.h"
#include "Units.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

// Pixels.
constexpr double arrowStart = 5;
constexpr double arrowEnd = 46;
constexpr double headLength = 13;
constexpr double headWidth = 6;
constexpr double handleReach = 8;
constexpr double inside = 60; // from the border of the picture
constexpr double turnWay = 30;

constexpr double turnStep = 15 * std::numbers::pi / 180;
constexpr double towardsEye = 0.96; // cosine: an arrow so steep is too short to be grabbed

} // namespace

Vec3 SectionHandle::anchor() const
{
    const SectionPlane& section = *m_scene.section;
    const auto onPlane = [&](const Vec3& p) { return Vec3(p + section.height(p) * section.normal); };
    if (m_drag)
        return onPlane(m_drag->anchor);
    const std::vector<Vec3> frame = planeFrame(m_scene.box, section.normal, section.offset);
    const Vec3 middle = onPlane(m_scene.box.center()), upper = (frame[2] + frame[3]) / 2;
    for (const Vec3& place : {upper, middle})
        if (const auto pixel = m_camera.pixel(place);
            pixel && pixel->minCoeff() > inside && (m_camera.size - *pixel).minCoeff() > inside)
            return place;
    return onPlane(m_camera.target);
}

Vec3 SectionHandle::direction(const Vec3& at, const Vec3& normal) const
{
    const Vec3 toEye = m_camera.perspective ? Vec3((m_camera.eye() - at).normalized()) : m_camera.backward();
    if (std::abs(normal.dot(toEye)) < towardsEye)
        return normal;
    return normal.dot(toEye) > 0 ? m_camera.upward() : Vec3(-m_camera.upward());
}

std::array<std::vector<Vec3>, 2> SectionHandle::arrows() const
{
    const Vec3 at = anchor(), way = direction(at, m_scene.section->normal);
    const double pixel = m_camera.pixelSize(at);
    Vec3 across = way.cross(m_camera.backward());
    across = across.norm() > 1e-6 ? Vec3(across.normalized()) : m_camera.rightward();
    std::array<std::vector<Vec3>, 2> result;
    for (const int side : {0, 1}) {
        const Vec3 along = (side == 0 ? pixel : -pixel) * way;
        const Vec3 tip = at + arrowEnd * along, back = tip - headLength * along;
        const Vec3 wing = headWidth * pixel * across;
        result[static_cast<std::size_t>(side)] = {at + arrowStart * along, tip, back + wing, tip, back - wing};
    }
    return result;
}

bool SectionHandle::hover(QPointF pixel)
{
    m_hovered = false;
    if (m_scene.section && !m_scene.box.isEmpty())
        for (const std::vector<Vec3>& arrow : arrows())
            m_hovered = m_hovered || distanceInPicture(m_camera, arrow, {pixel.x(), pixel.y()}) < handleReach;
    return m_hovered;
}

bool SectionHandle::press(QPointF pixel)
{
    if (!hover(pixel))
        return false;
    m_drag = Drag{*m_scene.section, anchor(), pixel};
    return true;
}

SectionPlane SectionHandle::moved(QPointF pixel) const
{
    SectionPlane plane = m_drag->start;
    const Vec3 way = direction(m_drag->anchor, plane.normal);
    plane.offset +=
        alongLine(m_camera, m_drag->anchor, way, pixel) - alongLine(m_camera, m_drag->anchor, way, m_drag->pressed);
    const auto [least, most] = sectionRange(m_scene.box, plane.normal);
    plane.offset = std::clamp(plane.offset, least, most);
    return plane;
}

/// To the side about the upright axis, upwards about a horizontal one.
SectionPlane SectionHandle::turned(QPointF pixel) const
{
    SectionPlane plane = m_drag->start;
    const QPointF way = pixel - m_drag->pressed;
    const bool upright = std::abs(plane.normal.z()) > 0.99;
    const bool sideways = std::abs(way.x()) > std::abs(way.y());
    const double angle = turnStep * std::round((sideways ? way.x() : way.y()) / turnWay);
    Vec3 axis = Vec3::UnitZ();
    if (upright) {
        Eigen::Index nearest = 0;
        (sideways ? m_camera.backward() : m_camera.rightward()).head<2>().cwiseAbs().maxCoeff(&nearest);
        axis = Vec3::Unit(nearest);
    } else if (!sideways) {
        axis = plane.normal.cross(Vec3::UnitZ()).normalized();
    }
    plane.normal = (Eigen::AngleAxisd(angle, axis) * plane.normal).normalized();
    plane.offset = plane.normal.dot(m_drag->anchor);
    return plane;
}

SectionPlane SectionHandle::dragged(QPointF pixel, Qt::KeyboardModifiers modifiers) const
{
    return modifiers & Qt::ControlModifier ? turned(pixel) : moved(pixel);
}

SectionPlane SectionHandle::cancel()
{
    const SectionPlane start = m_drag->start;
    m_drag.reset();
    m_hovered = false;
    return start;
}

QString SectionHandle::prompt() const
{
    if (m_drag && m_scene.section)
        return tr("Section at %1 \u2013 Ctrl turns it by 15\u00b0, Escape puts it back")
            .arg(lengthText(m_scene.section->offset));
    return m_hovered ? tr("Drag to move the section, with Ctrl to turn it") : QString();
}

std::vector<SceneLine> SectionHandle::lines() const
{
    std::vector<SceneLine> result;
    if (!m_scene.section || m_scene.box.isEmpty())
        return result;
    const auto add = [&](const std::vector<Vec3>& points, const QColor& color, float width, float hidden) {
        SceneLine line{{}, color, width, hidden, 0.9F};
        for (const Vec3& p : points)
            line.points.push_back(p.cast<float>());
        result.push_back(std::move(line));
    };
    const ViewScene& scene = m_scene;
    if (hovering())
        add(planeFrame(scene.box, scene.section->normal, scene.section->offset), scene.colors.hover, 1.4F, 0.35F);
    const QColor color = hovering() ? scene.colors.accent : QColor(0xf4, 0xf4, 0xf4);
    for (const std::vector<Vec3>& arrow : arrows())
        add(arrow, color, hovering() ? 4 : 2.8F, 1);
    return result;
}

} // namespace bolster
