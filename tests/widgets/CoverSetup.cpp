#include "CoverSetup.h"

#include <QApplication>
#include <QWheelEvent>

#include <map>

namespace bolster::test {

namespace {

constexpr std::uint32_t cells = 8;

/// Where a node of the grid lies among the vertices: those of the outline come first, counter-clockwise.
std::uint32_t index(std::uint32_t i, std::uint32_t j)
{
    if (j == 0)
        return i;
    if (i == cells)
        return cells + j;
    if (j == cells)
        return 3 * cells - i;
    if (i == 0)
        return 4 * cells - j;
    return 4 * cells + (j - 1) * (cells - 1) + i - 1;
}

void addSquare(SurfaceTopology& topology, SurfaceMesh& mesh, ElementId patch, double x)
{
    const std::uint32_t first = topology.vertexCount();
    const auto firstTriangle = static_cast<std::uint32_t>(topology.triangles.size());
    constexpr std::uint32_t count = (cells + 1) * (cells + 1);
    topology.pattern.resize(first + count);
    mesh.positions.resize(first + count);
    mesh.normals.resize(first + count, {0, 0, 1});
    for (std::uint32_t j = 0; j <= cells; ++j)
        for (std::uint32_t i = 0; i <= cells; ++i) {
            const Vec2 p(200.0 * i / cells, 200.0 * j / cells);
            topology.pattern[first + index(i, j)] = p;
            mesh.positions[first + index(i, j)] = {x + p.x(), p.y(), 0};
        }
    for (std::uint32_t j = 0; j < cells; ++j)
        for (std::uint32_t i = 0; i < cells; ++i) {
            const auto at = [&](std::uint32_t di, std::uint32_t dj) { return first + index(i + di, j + dj); };
            topology.triangles.push_back({at(0, 0), at(1, 0), at(1, 1)});
            topology.triangles.push_back({at(0, 0), at(1, 1), at(0, 1)});
        }
    topology.patches.push_back({patch, fabricId, first, count, firstTriangle, 2 * cells * cells, 4 * cells});
}

ElementPtr square(const char* name)
{
    Patch patch;
    patch.name = name;
    patch.fabric = fabricId;
    patch.outline = BSpline2(1, true, {{0, 0}, {200, 0}, {200, 200}, {0, 200}});
    return makeElement(patch);
}

} // namespace

Design twoSquares()
{
    Seam seam;
    seam.a = {leftPatch, 1, 2};
    seam.b = {rightPatch, 3, 4};
    seam.reversed = true;
    const FixationCurve curve{"Rail",
                              BSpline3(3, false, {{0, 100, 50}, {130, 100, 50}, {270, 100, 50}, {400, 100, 50}})};
    Edit edit;
    edit.changes = {{fabricId, nullptr, makeElement(Fabric{})},
                    {leftPatch, nullptr, square("Left")},
                    {rightPatch, nullptr, square("Right")},
                    {curveId, nullptr, makeElement(curve)},
                    {seamId, nullptr, makeElement(seam)}};
    return Design().with(edit);
}

SurfaceMeshPtr twoSquaresCover()
{
    auto topology = std::make_shared<SurfaceTopology>();
    auto mesh = std::make_shared<SurfaceMesh>();
    topology->serial = 77;
    addSquare(*topology, *mesh, leftPatch, 0);
    addSquare(*topology, *mesh, rightPatch, 200);
    SurfaceTopology::Chain seam{seamId, {}, {}};
    for (std::uint32_t j = 0; j <= cells; ++j) {
        seam.a.push_back(index(cells, j));
        seam.b.push_back((cells + 1) * (cells + 1) + index(0, j));
    }
    topology->seams.push_back(seam);
    mesh->topology = topology;
    return mesh;
}

CoverMeshPtr raisedCover(const SurfaceMeshPtr& surface, float height)
{
    auto topology = std::make_shared<CoverTopology>();
    auto cover = std::make_shared<CoverMesh>();
    topology->coarse = surface->topology;
    topology->levels = 1;
    for (std::uint32_t v = 0; v < surface->positions.size(); ++v)
        topology->parents.push_back({{v, v, v}, {1, 0, 0}});
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    for (const auto& [a, b, c] : surface->topology->triangles) {
        const auto middle = [&](std::uint32_t from, std::uint32_t to) {
            const auto [known, added] =
                middles.try_emplace(std::minmax(from, to), static_cast<std::uint32_t>(topology->parents.size()));
            if (added)
                topology->parents.push_back({{from, to, 0}, {0.5F, 0.5F, 0}});
            return known->second;
        };
        const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        topology->triangles.insert(topology->triangles.end(),
                                   {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    for (const auto& [ends, middle] : middles)
        topology->edges.push_back({ends.first, ends.second, {middle, middle, middle}});
    topology->pattern = topology->carriedOver([&] {
        std::vector<Eigen::Vector2f> pattern;
        for (const Vec2& p : surface->topology->pattern)
            pattern.emplace_back(p.cast<float>());
        return pattern;
    }());
    std::vector<Eigen::Vector3f> points;
    for (const Vec3& p : surface->positions)
        points.emplace_back(p.cast<float>() + Eigen::Vector3f(0, 0, height));
    cover->points = topology->carriedOver(points);
    cover->normals.assign(cover->points.size(), Eigen::Vector3f::UnitZ());
    cover->topology = std::move(topology);
    cover->surface = surface;
    return cover;
}

SoftwareRenderer::Picture StubRenderer::render(const Request& request, std::stop_token)
{
    {
        const std::lock_guard lock(m_log->mutex);
        m_log->requests.push_back(request);
        m_log->thread = std::this_thread::get_id();
    }
    Picture picture;
    picture.image = QImage(static_cast<int>(request.camera.size.x()), static_cast<int>(request.camera.size.y()),
                           QImage::Format_RGBA8888);
    picture.image.fill(Qt::gray);
    picture.depth.assign(static_cast<std::size_t>(picture.image.width()) *
                             static_cast<std::size_t>(picture.image.height()),
                         std::numeric_limits<float>::infinity());
    return picture;
}

void Mouse::send(QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers)
{
    Qt::MouseButtons buttons = m_pressed;
    if (type == QEvent::MouseButtonRelease)
        buttons = Qt::NoButton;
    QMouseEvent event(type, at, m_widget.mapToGlobal(at), button, buttons, modifiers);
    QApplication::sendEvent(&m_widget, &event);
}

void Mouse::move(QPointF at, Qt::KeyboardModifiers modifiers)
{
    send(QEvent::MouseMove, at, Qt::NoButton, modifiers);
}

void Mouse::press(QPointF at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers)
{
    m_pressed = button;
    send(QEvent::MouseButtonPress, at, button, modifiers);
}

void Mouse::release(QPointF at, Qt::KeyboardModifiers modifiers)
{
    send(QEvent::MouseButtonRelease, at, m_pressed, modifiers);
    m_pressed = Qt::NoButton;
}

void Mouse::click(QPointF at, Qt::KeyboardModifiers modifiers)
{
    move(at, modifiers);
    press(at, Qt::LeftButton, modifiers);
    release(at, modifiers);
}

void Mouse::doubleClick(QPointF at)
{
    click(at);
    m_pressed = Qt::LeftButton;
    send(QEvent::MouseButtonDblClick, at, Qt::LeftButton, {});
    release(at);
}

void Mouse::drag(QPointF from, QPointF to, Qt::MouseButton button, Qt::KeyboardModifiers modifiers)
{
    move(from, modifiers);
    press(from, button, modifiers);
    for (int step = 1; step <= 10; ++step)
        move(from + (to - from) * step / 10, modifiers);
    release(to, modifiers);
}

void Mouse::wheel(QPointF at, int notches)
{
    QWheelEvent event(at, m_widget.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&m_widget, &event);
}

} // namespace bolster::test
