#include "SurfaceView.h"

#include "Crosshair.h"
#include "Document.h"
#include "FramePieces.h"
#include "GlCanvas.h"
#include "MeshShape.h"
#include "PointerNote.h"
#include "ScanCutTool.h"
#include "SectionPanel.h"
#include "Selection.h"
#include "SoftwareCanvas.h"
#include "SurfaceMarks.h"
#include "SurfaceViewCube.h"
#include "SymmetryMark.h"

#include <QEvent>
#include <QResizeEvent>

#include <algorithm>
#include <chrono>
#include <utility>

namespace bolster {

namespace {

using namespace std::chrono_literals;

constexpr double opacityOfCuts = 0.3;  ///< what foam takes away is nothing that is seen
constexpr auto occlusionDelay = 450ms; ///< the cover must rest that long before its shadows are found
constexpr int movingWithin = 250;      ///< ms between two surfaces that belong to one movement
constexpr int cubeMargin = 8;          ///< pixels

/// The surface brings what such an element changes; everything else is drawn from the design.
bool seenInSurface(const Design& design, ElementId id)
{
    return design.find<Patch>(id) || design.find<Seam>(id) || design.find<FixationSeam>(id) ||
           design.find<FancySeam>(id);
}

} // namespace

SurfaceView::SurfaceView(Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_selection(selection)
    , m_layers{Layer::Cover,          Layer::Checker,      Layer::Seams,      Layer::Frames,
               Layer::FixationCurves, Layer::HandleCurves, Layer::FancySeams, Layer::Scans,
               Layer::ScanColors,     Layer::Ground,       Layer::Twins,      Layer::Symmetry}
    , m_frameShapes([this] { draw(false); })
    , m_cube(new SurfaceViewCube(this))
    , m_legend(new MapLegend(this))
    , m_sectionPanel(new SectionPanel(this))
    , m_crosshair(new Crosshair(this))
    , m_note(new PointerNote(this))
    , m_tool(makeSurfaceTool(m_toolKind, *this))
    , m_occlusionJob(&SurfaceOcclusion::of,
                     [this](std::shared_ptr<const SurfaceOcclusion> occlusion) {
                         m_scene.occlusion = std::move(occlusion);
                         draw(false);
                     })
    , m_skinJob(&SurfaceView::skinsOf, [this](const Skins& made) { takeSkins(made); })
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(160, 120);
    for (QWidget* above : std::initializer_list<QWidget*>{m_legend, m_cube, m_sectionPanel})
        above->raise(); // what comes and goes with the pointer never covers them
    m_scene.setColors(ViewColors::of(palette()));
    m_flight.setDuration(260);
    m_flight.setEasingCurve(QEasingCurve::InOutCubic);
    m_flight.setStartValue(0.0);
    m_flight.setEndValue(1.0);
    m_occlusionDelay.setSingleShot(true);
    m_occlusionDelay.setInterval(occlusionDelay);

    connect(&m_flight, &QVariantAnimation::valueChanged, this, [this](const QVariant& t) {
        m_flightTo.size = m_camera.size;
        apply(Camera::between(m_flightFrom, m_flightTo, t.toDouble()));
    });
    connect(&m_occlusionDelay, &QTimer::timeout, this, &SurfaceView::requestOcclusion);
    connect(&m_occlusionDelay, &QTimer::timeout, this, &SurfaceView::requestSkins);
    // The cross-hair stays with the cover when that has moved.
    connect(&m_occlusionDelay, &QTimer::timeout, this, [this] { showPlace(m_shown); });
    connect(m_cube, &SurfaceViewCube::viewChosen, this, [this](double azimuth, double elevation) {
        Camera camera = m_camera;
        camera.azimuth = azimuth;
        camera.elevation = elevation;
        camera.fit(m_scene.box);
        goTo(camera);
    });
    connect(m_cube, &SurfaceViewCube::turned, this, [this](double azimuthBy, double elevationBy) {
        Camera camera = m_camera;
        camera.orbit(azimuthBy, elevationBy, m_scene.box.isEmpty() ? m_camera.target : Vec3(m_scene.box.center()));
        setCamera(camera);
    });
    m_sectionPanel->setScene([this] { return m_scene.box; }, [this] { return m_camera; });
    connect(m_sectionPanel, &SectionPanel::changed, this, &SurfaceView::setSection);
    connect(m_sectionPanel, &SectionPanel::closed, this, &SurfaceView::sectionClosed);
    connect(&m_document, &Document::changed, this, &SurfaceView::designChanged);
    const auto selectionChanged = [this] {
        updateMirrored();
        updateScans();
        updateLooks();
        updateMarks();
        draw(false);
    };
    connect(&m_selection, &Selection::changed, this, selectionChanged);
    connect(&m_selection, &Selection::hoverChanged, this, selectionChanged);
    designChanged({});
}

SurfaceView::~SurfaceView()
{
    m_canvas.reset(); // before the scene that it draws
}

void SurfaceView::setSoftwareRenderer(std::unique_ptr<SoftwareRenderer> renderer)
{
    m_softwareRenderer = std::move(renderer);
}

void SurfaceView::setDrawing(Drawing drawing)
{
    m_drawing = drawing;
}

void SurfaceView::makeCanvas()
{
    const QString problem = m_drawing == Drawing::Software ? tr("Drawn in software") : glProblem();
    if (!problem.isEmpty()) {
        useSoftware(problem);
        return;
    }
    auto canvas = std::make_unique<GlCanvas>(m_scene, m_camera, this);
    connect(canvas.get(), &GlCanvas::failed, this, &SurfaceView::useSoftware, Qt::QueuedConnection);
    m_canvas = std::move(canvas);
    m_canvas->whenShownChanges([this] { emit pictured(); });
    emit rendererNote({});
}

void SurfaceView::useSoftware(const QString& note)
{
    m_canvas.reset();
    m_canvas = std::make_unique<SoftwareCanvas>(m_scene, m_camera, m_softwareRenderer, this);
    m_canvas->whenShownChanges([this] { emit pictured(); });
    m_canvas->widget().setGeometry(rect());
    m_canvas->widget().lower();
    m_canvas->widget().show();
    emit rendererNote(note);
    draw(false);
}

void SurfaceView::setSurface(SurfaceMeshPtr surface)
{
    const bool usable = surface && surface->topology &&
                        surface->positions.size() == surface->topology->vertexCount() &&
                        surface->normals.size() == surface->positions.size();
    m_surface = usable ? std::move(surface) : nullptr;
    updateCover();
    const bool moving = m_sinceSurface.isValid() && m_sinceSurface.elapsed() < movingWithin;
    m_sinceSurface.start();
    m_occlusionJob.cancel();
    updateLooks();
    updateBox();
    updateMarks();
    m_occlusionDelay.start();
    draw(moving);
}

void SurfaceView::setCover(CoverMeshPtr cover, TrimMeshPtr trims)
{
    m_cover = std::move(cover);
    m_trims = std::move(trims);
    if (!m_cover || m_cover->surface != m_surface)
        return;
    updateCover();
    updateMarks(); // they lie on what is drawn
    draw(false);
}

void SurfaceView::setFabricMaps(std::map<ElementId, FabricMapsPtr> maps)
{
    m_scene.fabrics = std::move(maps);
    updateLooks();
    draw(false);
}

void SurfaceView::setFiles(const DesignFiles& files)
{
    m_files = files;
    updateFrames();
    updateScans();
    updateBox();
    m_occlusionDelay.start();
    draw(false);
}

void SurfaceView::setField(FieldPicturePtr field)
{
    m_field = std::move(field);
    updateMarks();
    draw(m_document.gestureRunning());
}

void SurfaceView::setMap(SurfaceMapPtr map)
{
    m_legend->setMap(map);
    m_scene.map = std::move(map);
    updateScans();
    draw(false);
}

void SurfaceView::setMapReading(const QString& reading)
{
    m_legend->setReading(reading);
}

void SurfaceView::setScanPairs(std::vector<std::pair<Vec3, Vec3>> pairs)
{
    m_scanPairs = std::move(pairs);
    if (!layerVisible(Layer::ScanPairs))
        return;
    updateMarks();
    draw(false);
}

void SurfaceView::setTool(SurfaceToolKind kind)
{
    if (kind == m_toolKind)
        return;
    m_tool->leave();
    m_toolKind = kind;
    m_tool = makeSurfaceTool(kind, *this);
    if (kind != SurfaceToolKind::Select)
        setFocus();
    emit toolChanged(kind);
    refresh();
}

void SurfaceView::endTool()
{
    const auto back = [this, ended = m_tool.get()] {
        if (m_tool.get() == ended) // else another one has been begun meanwhile
            setTool(SurfaceToolKind::Select);
    };
    QMetaObject::invokeMethod(this, back, Qt::QueuedConnection);
}

void SurfaceView::startScanCut(ElementId scan, bool keep)
{
    setTool(SurfaceToolKind::CutScan);
    m_tool = std::make_unique<ScanCutTool>(static_cast<SurfaceToolContext&>(*this), scan, keep);
    refresh();
}

void SurfaceView::setDimmed(bool dimmed)
{
    if (dimmed == m_scene.dimmed)
        return;
    m_scene.dimmed = dimmed;
    draw(false);
}

void SurfaceView::setLayerVisible(Layer layer, bool visible)
{
    if (visible == layerVisible(layer))
        return;
    if (visible)
        m_layers.insert(layer);
    else
        m_layers.erase(layer);
    m_scene.checker = layerVisible(Layer::Checker);
    m_scene.meshEdges = layerVisible(Layer::MeshEdges);
    m_scene.ground = layerVisible(Layer::Ground);
    updateMirrored();
    updateCurves();
    updateFrames();
    updateScans();
    updateMarks();
    setSurface(m_surface);
}

void SurfaceView::designChanged(const std::set<ElementId>& ids)
{
    if (!ids.empty() &&
        std::ranges::all_of(ids, [this](ElementId id) { return seenInSurface(m_document.design(), id); }))
        return;
    updateCurves();
    updateFrames();
    updateScans();
    updateMirrored();
    updateLooks();
    updateBox();
    updateMarks();
    draw(m_document.gestureRunning());
}

void SurfaceView::updateScans()
{
    m_scanPoints.update(m_document.design(), m_files);
    m_scene.points.clear();
    if (layerVisible(Layer::Scans) && !m_scene.map) // which says more, and would be hidden
        m_scene.points =
            m_scanPoints.looks(m_selection.elements(), m_scene.colors, m_hidden, layerVisible(Layer::ScanColors));
    cutPoints();
}

void SurfaceView::updateFrames()
{
    std::vector<Scene::FrameLook> frames;
    std::vector<ElementId> ids;
    if (layerVisible(Layer::Frames))
        m_document.design().each<Frame>([&](ElementId id, const Frame& frame) {
            const auto mesh = m_files.meshes.find(id);
            if (mesh == m_files.meshes.end() || !mesh->second || m_hidden.contains(id))
                return;
            frames.push_back({shownMesh(mesh->second, frame.hiddenParts), frame, frame.material});
            ids.push_back(id);
        });
    m_foamMeshes.update(m_document.design(), m_files);
    if (layerVisible(Layer::Frames))
        for (const auto& [id, mesh] : m_foamMeshes.all()) {
            if (m_hidden.contains(id))
                continue;
            const Foam& foam = *m_document.design().find<Foam>(id);
            frames.push_back({mesh, foam, {FrameMaterial::Kind::Foam}, foam.cut ? opacityOfCuts : 1});
            ids.push_back(id);
        }
    m_frameIds = ids;
    if (std::ranges::equal(frames, m_scene.frames, &Scene::FrameLook::sameFrame))
        return;
    m_scene.frames = std::move(frames);
    m_frameShapes.setFrames(m_scene.frames, ids);
    keepSkins();
    m_frameBox.setEmpty();
    for (const Scene::FrameLook& frame : m_scene.frames)
        for (const Vec3& p : placedPoints(frame))
            if (p.allFinite())
                m_frameBox.extend(p);
    m_occlusionDelay.start();
}

Vec3 SurfaceView::middleOf(ElementId id) const
{
    for (std::size_t i = 0; i < m_frameIds.size(); ++i)
        if (m_frameIds[i] == id) {
            const Scene::FrameLook& look = m_scene.frames[i];
            return look.placement.placed(look.mesh->boundingBox().center());
        }
    if (const Box3 scan = m_scanPoints.box(id); !scan.isEmpty() && layerVisible(Layer::Scans))
        return scan.center(); // where a scanner stood says nothing
    const ElementPtr element = m_document.design().element(id);
    const Placement* placement = element ? elementPlacement(*element) : nullptr;
    return placement ? placement->position : Vec3(Vec3::Zero());
}

void SurfaceView::updateLooks()
{
    m_scene.patches = patchLooks(m_document.design(), m_document.design().settings().colourway,
                                 [this](ElementId fabric, const Fabric&) {
                                     const auto maps = m_scene.fabrics.find(fabric);
                                     return maps != m_scene.fabrics.end() ? maps->second : nullptr;
                                 });
    m_scene.tints.clear();
    for (const Scene::PatchLook& look : m_scene.patches) {
        QColor tint = m_scene.colors.accent;
        tint.setAlphaF(m_selection.contains(look.patch)                                         ? 0.14F
                       : m_selection.hovered() == look.patch || m_mirrored.contains(look.patch) ? 0.07F
                                                                                                : 0);
        m_scene.tints[look.patch] = tint;
    }
}

void SurfaceView::updateMarks()
{
    const SurfaceMarks::Shown shown{layerVisible(Layer::Seams), layerVisible(Layer::FixationCurves), m_mirrored};
    SurfaceMarks(m_document.design(), m_curves, m_selection, shown).fill(m_scene, m_hoveredPoint);
    if (layerVisible(Layer::Frames))
        m_foamMeshes.addLines(m_document.design(), m_selection, m_scene);
    if (m_field && layerVisible(Layer::Field))
        addFieldLines(*m_field, m_scene);
    addScanPairs();
    addFramePieces();
    if (const auto& symmetry = m_document.design().settings().symmetry; symmetry && layerVisible(Layer::Symmetry))
        addSymmetryPlane(*symmetry, m_scene);
    cutMarks();
    for (SurfaceLine& guide : m_tool->guides())
        m_scene.lines.push_back(std::move(guide));
    for (SurfaceLine& line : m_sectionHandle.lines())
        m_scene.lines.push_back(std::move(line));
}

void SurfaceView::addScanPairs()
{
    if (!layerVisible(Layer::ScanPairs))
        return;
    const QColor red(0xd8, 0x2c, 0x20);
    for (const auto& [on, of] : m_scanPairs)
        m_scene.lines.push_back({{on.cast<float>(), of.cast<float>()}, red, 1.2F, 0.25F});
}

/// A frame stands on the floor, and a cover that hangs a little below it does. Patches that lie anywhere do not
/// move the floor, nor does a frame that is hidden for a while.
double SurfaceView::floorUnder(const Box3& shown)
{
    bool any = false;
    m_document.design().each<Frame>([&](ElementId, const Frame&) { any = true; });
    if (!m_frameBox.isEmpty() || !any)
        m_standing = m_frameBox;
    constexpr double skirt = 0.15; // of the frame's size
    const double lowest = shown.min().z();
    if (m_standing.isEmpty() || std::abs(lowest - m_standing.min().z()) < skirt * m_standing.diagonal().norm())
        return lowest;
    return m_standing.min().z();
}

void SurfaceView::updateBox()
{
    Box3 solid;
    if (m_scene.surface)
        for (const Vec3& p : m_scene.surface->positions)
            if (p.allFinite())
                solid.extend(p);
    solid.extend(m_frameBox);
    if (solid.isEmpty() && layerVisible(Layer::Scans))
        solid = m_scanPoints.box();
    Box3 box = solid;
    for (const auto& [id, curve] : m_curves.all())
        for (const Vec3& p : curve.points)
            box.extend(p);
    m_scene.box = box;
    m_scene.floor = box.isEmpty() ? 0 : floorUnder(solid.isEmpty() ? box : solid) - 1;
    if (m_fitPending && !box.isEmpty() && width() > 1 && isVisible()) {
        m_fitPending = false;
        m_camera.look(StandardView::ThreeQuarter);
        m_camera.azimuth += frontSide();
        m_camera.fit(box);
    } else if (box.isEmpty()) {
        m_fitPending = !m_returned;
        m_scene.box = Box3(Vec3(-500, -500, 0), Vec3(500, 500, 0)); // ground to draw on
    }
}

void SurfaceView::requestOcclusion()
{
    if (!m_canvas || !m_canvas->drawsOcclusion())
        return;
    SurfaceOcclusion::Input input;
    input.surface = m_scene.surface;
    input.frames = m_scene.frames;
    input.floor = static_cast<float>(m_scene.floor);
    m_occlusionJob.request(std::move(input), true);
}

void SurfaceView::draw(bool moving)
{
    m_cube->setCamera(m_camera);
    if (m_canvas)
        m_canvas->refresh(moving);
}

void SurfaceView::refresh()
{
    const QString text = prompt();
    if (text != m_prompt) {
        m_prompt = text;
        emit promptChanged(text);
    }
    setCursor(m_sectionHandle.hovering() ? QCursor(Qt::SizeAllCursor) : m_tool->cursor());
    m_note->showNote(m_tool->note());
    const auto hovered = m_tool->hoveredPoint();
    const bool guided = !m_tool->guides().empty();
    if (hovered != m_hoveredPoint || guided || m_guided) {
        m_hoveredPoint = hovered;
        m_guided = guided;
        updateMarks();
        draw(m_document.gestureRunning());
    }
}

QString SurfaceView::prompt() const
{
    return m_sectionHandle.hovering() ? m_sectionHandle.prompt() : m_tool->prompt();
}

SurfaceHit SurfaceView::hit(QPointF pixel) const
{
    return m_hitTest.hit({m_camera, &m_curves, m_selection, layerVisible(Layer::Seams)}, pixel);
}

void SurfaceView::apply(const Camera& camera)
{
    m_camera = camera;
    m_camera.size = {std::max(width(), 1), std::max(height(), 1)};
    if (m_scene.section || !m_tool->guides().empty())
        updateMarks(); // handles keep their size in the picture
    placeCrosshair();
    draw(true);
    emit cameraMoved(m_camera);
}

void SurfaceView::setCamera(const Camera& camera)
{
    m_flight.stop();
    m_fitPending = false;
    const bool before = m_camera.perspective;
    apply(camera);
    if (before != m_camera.perspective)
        emit perspectiveChanged(m_camera.perspective);
}

void SurfaceView::returnTo(const Viewpoint& view)
{
    m_returned = true;
    setCamera(Camera{view, m_camera.size});
}

void SurfaceView::goTo(Camera camera)
{
    m_flight.stop();
    m_fitPending = false;
    m_flightFrom = m_camera;
    m_flightTo = camera;
    if (isVisible())
        m_flight.start();
    else
        apply(camera);
}

void SurfaceView::setPerspective(bool perspective)
{
    Camera camera = destination();
    camera.perspective = perspective;
    setCamera(camera);
}

double SurfaceView::frontSide() const
{
    if (m_scene.surface)
        return frontAzimuth(m_scene.surface->positions);
    return m_scene.frames.empty() ? 0 : frontAzimuth(placedPoints(m_scene.frames.front()));
}

void SurfaceView::setStandardView(StandardView view)
{
    m_returned = false;
    Camera camera = destination();
    camera.look(view);
    if (view == StandardView::ThreeQuarter)
        camera.azimuth += frontSide();
    camera.fit(m_scene.box);
    goTo(camera);
}

bool SurfaceView::inPicture(const Box3& box) const
{
    for (int corner = 0; corner < 8; ++corner) {
        const auto pixel = m_camera.pixel(box.corner(static_cast<Box3::CornerType>(corner)));
        if (!pixel || !rect().contains(static_cast<int>(pixel->x()), static_cast<int>(pixel->y())))
            return false;
    }
    return true;
}

void SurfaceView::fitAll()
{
    m_returned = false;
    if (!isVisible() || m_scene.box.isEmpty()) {
        m_fitPending = true;
        updateBox();
        return;
    }
    Camera camera = destination();
    camera.fit(m_scene.box);
    goTo(camera);
}

/// Where the camera is, or where it is flying to: who wants another part of that must not keep what lies between.
Camera SurfaceView::destination() const
{
    Camera camera = m_flight.state() == QAbstractAnimation::Running ? m_flightTo : m_camera;
    camera.size = m_camera.size;
    return camera;
}

Box3 SurfaceView::selectedBox() const
{
    Box3 box;
    for (const auto& [id, curve] : m_curves.all())
        if (m_selection.contains(id))
            for (const Vec3& p : curve.points)
                box.extend(p);
    if (m_scene.surface)
        for (const SurfaceTopology::PatchRange& range : m_scene.surface->topology->patches)
            if (m_selection.contains(range.patch))
                for (std::uint32_t i = 0; i < range.vertexCount; ++i)
                    box.extend(m_scene.surface->positions[range.firstVertex + i]);
    for (const ElementId id : m_selection.elements())
        box.extend(m_scanPoints.box(id));
    return box;
}

void SurfaceView::fitSelection()
{
    const Box3 box = selectedBox();
    if (box.isEmpty()) {
        fitAll();
        return;
    }
    Camera camera = m_camera;
    camera.fit(box);
    goTo(camera);
}

QImage SurfaceView::grabPicture()
{
    if (!m_canvas)
        makeCanvas();
    return m_canvas->grab();
}

void SurfaceView::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (!m_canvas) {
        makeCanvas();
        m_canvas->widget().setGeometry(rect());
        m_canvas->widget().lower();
        m_canvas->widget().show();
    }
    updateBox();
    draw(false);
}

void SurfaceView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    m_camera.size = {std::max(width(), 1), std::max(height(), 1)};
    if (m_canvas)
        m_canvas->widget().setGeometry(rect());
    m_legend->place();
    m_sectionPanel->place();
    placeCrosshair();
    m_cube->move(width() - m_cube->width() - cubeMargin, cubeMargin);
    m_cube->setVisible(width() > 3 * m_cube->width() && height() > 2 * m_cube->height());
    updateBox();
    draw(true);
}

void SurfaceView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) {
        m_scene.setColors(ViewColors::of(palette()));
        updateScans();
        updateLooks();
        updateMarks();
        draw(false);
    }
}

} // namespace bolster
