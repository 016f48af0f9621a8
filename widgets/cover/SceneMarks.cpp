#include "SceneMarks.h"

#include "Selection.h"
#include "SelectionEdits.h"
#include "SurfaceEdges.h"

#include <cmath>

namespace bolster {

namespace {

using Points = std::vector<Eigen::Vector3f>;

/// Along the cover as it is drawn.
Points pointsOf(const ViewScene& scene, const std::vector<std::uint32_t>& vertices)
{
    Points points;
    if (scene.cover) {
        for (const std::uint32_t v : scene.cover->topology->along(vertices))
            if (scene.cover->points[v].allFinite())
                points.push_back(scene.cover->points[v]);
        return points;
    }
    const SurfaceMesh& mesh = *scene.surface;
    points.reserve(vertices.size());
    for (const std::uint32_t v : vertices)
        if (mesh.positions[v].allFinite())
            points.push_back(mesh.positions[v].cast<float>());
    return points;
}

Points pointsOf(const std::vector<Vec3>& positions, bool closed = false)
{
    Points points;
    for (const Vec3& p : positions)
        points.push_back(p.cast<float>());
    if (closed && !points.empty())
        points.push_back(points.front());
    return points;
}

QColor curveColor(const ViewColors& colors, const CoverCurve& curve)
{
    return curve.handle() ? colors.handle : fixationCurveColor(colors);
}

QColor withAlpha(QColor color, float alpha)
{
    color.setAlphaF(alpha);
    return color;
}

/// Cloth has a valley at its seams, which a line must not hide.
bool showsCloth(const ViewScene& scene)
{
    return !scene.checker && !scene.map;
}

QColor seamColor(const ViewScene& scene)
{
    return {18, 14, 12, showsCloth(scene) ? 70 : 190};
}

} // namespace

QColor fixationCurveColor(const ViewColors& colors)
{
    return colors.dark ? QColor(0x2f, 0xd6, 0xc3) : QColor(0x0a, 0x8a, 0x7d);
}

void addFieldLines(const FieldPicture& field, ViewScene& scene)
{
    const QColor section(0xd9, 0x9a, 0x2b), force(0xb3, 0x3f, 0x8f);
    for (const auto& [from, to] : field.contours)
        scene.lines.push_back({{from, to}, section, 1, 0.5F});
    for (const auto& [from, to] : field.arrows) {
        const Eigen::Vector3f way = to - from;
        Eigen::Vector3f across = way.cross(Eigen::Vector3f(0.36F, 0.48F, 0.8F)).normalized();
        across *= 0.12F * way.norm();
        const Eigen::Vector3f back = to - 0.25F * way;
        scene.lines.push_back({{from, to, back + across, to, back - across}, force, 1.2F, 0.6F});
    }
}

/// Lighter than what is selected: what is done to the selection is done to it, too.
QColor mirroredColor(const ViewColors& colors)
{
    return mixed(colors.accent, Qt::white, 0.45);
}

void cutMarks(ViewScene& scene)
{
    if (!scene.section)
        return;
    const SectionPlane& section = *scene.section;
    std::vector<SceneLine> lines;
    for (const SceneLine& line : scene.lines)
        for (std::vector<Eigen::Vector3f>& part : keptParts(line.points, section)) {
            lines.push_back(line);
            lines.back().points = std::move(part);
        }
    scene.lines = std::move(lines);
    std::erase_if(scene.dots, [&](const SceneDot& dot) { return !section.keeps(dot.at.cast<double>()); });
}

void SceneMarks::fill(ViewScene& scene, std::optional<std::pair<ElementId, int>> hoveredPoint) const
{
    scene.lines.clear();
    scene.dots.clear();
    if (scene.surface) {
        if (m_shown.seams)
            addSeams(scene);
        addFancySeams(scene);
        addOutlines(scene);
        if (m_shown.heldNormals)
            addHeldNormals(scene);
    }
    for (const auto& [id, curve] : m_curves.all())
        addCurve(scene, id, curve);
    for (const auto& [id, curve] : m_curves.all())
        if (m_selection.contains(id) || m_selection.hovered() == id)
            addControlPoints(scene, id, curve,
                             hoveredPoint && hoveredPoint->first == id ? hoveredPoint->second : -1);
    ++scene.marks;
}

void SceneMarks::addSeams(ViewScene& scene) const
{
    const SurfaceMesh& mesh = *scene.surface;
    for (const SurfaceTopology::Chain& chain : mesh.topology->seams) {
        SceneLine line{pointsOf(scene, chain.a), seamColor(scene), showsCloth(scene) ? 0.9F : 1.3F};
        if (m_selection.contains(chain.seam))
            line = {line.points, scene.colors.accent, 3, 0.35F, 1};
        else if (m_selection.hovered() == chain.seam)
            line = {line.points, scene.colors.hover, 3, 0.25F, 1};
        else if (mirrored(chain.seam))
            line = {line.points, mirroredColor(scene.colors), 2.4F, 0.25F, 1};
        scene.lines.push_back(std::move(line));
    }
}

/// The groove hides its middle from the side, the outer lines are always seen.
void SceneMarks::addFancySeams(ViewScene& scene) const
{
    const SurfaceMesh& mesh = *scene.surface;
    for (const SurfaceTopology::Line& line : mesh.topology->lines) {
        const bool selected = m_selection.contains(line.element), hovered = m_selection.hovered() == line.element;
        const bool middle = line.across == 0, outer = std::abs(line.across) == 1;
        if (m_curves.all().contains(line.element) || !(middle || outer))
            continue;
        const QColor marked = selected  ? scene.colors.accent
                              : hovered ? scene.colors.hover
                                        : mirroredColor(scene.colors);
        if (selected || hovered || mirrored(line.element))
            scene.lines.push_back({pointsOf(scene, line.vertices), marked, middle ? 2.4F : 1.2F, 0.3F});
        else
            scene.lines.push_back({pointsOf(scene, line.vertices),
                                   withAlpha(scene.colors.fancySeam, middle ? 0.7F : 0.4F), middle ? 1.2F : 0.8F,
                                   0});
    }
}

void SceneMarks::addOutlines(ViewScene& scene) const
{
    const SurfaceMesh& mesh = *scene.surface;
    const auto add = [&](const SurfaceRun& run, const QColor& color, float width, float hidden) {
        scene.lines.push_back({pointsOf(scene, run), color, width, hidden});
    };
    if (m_shown.seams)
        for (const SurfaceRun& run : unsewnOutlines(*mesh.topology))
            add(run, seamColor(scene), 1.0F, 0);
    for (const SurfaceTopology::PatchRange& range : mesh.topology->patches) {
        if (m_selection.contains(range.patch))
            add(outlineOf(range), scene.colors.accent, 2.4F, 0.25F);
        else if (m_selection.hovered() == range.patch)
            add(outlineOf(range), scene.colors.hover, 1.8F, 0);
        else if (mirrored(range.patch))
            add(outlineOf(range), mirroredColor(scene.colors), 1.8F, 0.15F);
    }
}

void SceneMarks::addCurve(ViewScene& scene, ElementId id, const CoverCurve& curve) const
{
    const bool selected = m_selection.contains(id), hovered = m_selection.hovered() == id;
    SceneLine line;
    line.points = pointsOf(curve.points);
    const bool twin = mirrored(id) && !selected;
    line.color = selected ? scene.colors.accent
                 : twin   ? mirroredColor(scene.colors)
                          : curveColor(scene.colors, curve);
    line.width = selected || hovered ? 3.2F : twin ? 2.8F : 2.2F;
    line.hidden = selected || hovered ? 0.6F : 0.22F;
    line.casing = 0.8F;
    scene.lines.push_back(std::move(line));
}

/// Short lines that stand on the cover where a normal is held, or lie in it where a tangent is.
void SceneMarks::addHeldNormals(ViewScene& scene) const
{
    constexpr std::size_t most = 9;       // along a stretch
    constexpr double relativeSize = 0.03; // of the cover
    const SurfaceMesh& mesh = *scene.surface;
    const double size = relativeSize * mesh.boundingBox().diagonal().norm();
    for (const SurfaceTopology::Chain& chain : mesh.topology->fixations) {
        const FixationSeam* held = m_design.find<FixationSeam>(chain.seam);
        if (!held || held->orientation.empty() || chain.a.size() < 2)
            continue;
        const bool marked = m_selection.contains(chain.seam) || m_selection.hovered() == chain.seam;
        const QColor color = marked ? scene.colors.accent : fixationCurveColor(scene.colors);
        const std::size_t count = std::min(most, chain.a.size());
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t k = i * (chain.a.size() - 1) / (count - 1);
            const double fraction = static_cast<double>(k) / static_cast<double>(chain.a.size() - 1);
            const Vec3 foot = mesh.positions[chain.a[k]];
            const Vec3 tip = foot + size * held->orientation.at(fraction);
            if (foot.allFinite())
                scene.lines.push_back(
                    {pointsOf(std::vector<Vec3>{foot, tip}), color, marked ? 2.4F : 1.6F, 0.3F, 0.8F});
        }
    }
}

void SceneMarks::addControlPoints(ViewScene& scene, ElementId id, const CoverCurve& curve, int hovered) const
{
    const QColor color = m_selection.contains(id) ? scene.colors.accent : curveColor(scene.colors, curve);
    const std::vector<Vec3>& points = curve.spline().points();
    if (curve.spline().degree() > 1)
        scene.lines.push_back(
            {pointsOf(points, curve.spline().closed()), withAlpha(mixed(color, Qt::white, 0.35), 0.75F), 1, 0.5F});
    for (int i = 0; i < static_cast<int>(points.size()); ++i) {
        const int point = selectionPoint(*curve.element, i);
        const bool selected = m_selection.contains(Selection::Point{id, point});
        SceneDot dot;
        dot.at = points[static_cast<std::size_t>(i)].cast<float>();
        dot.fill = selected ? scene.colors.accent : QColor(Qt::white);
        dot.rim = selected ? QColor(Qt::white) : color.darker(125);
        dot.radius = point == hovered ? 6.5F : selected ? 5.5F : 4.5F;
        scene.dots.push_back(dot);
    }
}

} // namespace bolster
