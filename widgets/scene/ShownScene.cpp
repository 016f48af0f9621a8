#include "ShownScene.h"

#include "Document.h"
#include "SceneMarks.h"
#include "SceneVisibility.h"
#include "Selection.h"
#include "SelectionEdits.h"
#include "SymmetryMark.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace bolster {

namespace {

using namespace std::chrono_literals;
using Layer = SceneVisibility::Layer;

constexpr auto restDelay = 450ms; ///< the cover must rest that long before its shadows are found
constexpr int movingWithin = 250; ///< ms between two surfaces that belong to one movement

/// The surface brings what such an element changes; everything else is drawn from the design.
bool seenInSurface(const Design& design, ElementId id)
{
    return design.find<Patch>(id) || design.find<Seam>(id) || design.find<FixationSeam>(id) ||
           design.find<FancySeam>(id);
}

} // namespace

ShownScene::ShownScene(Document& document, Selection& selection, SceneVisibility& visibility)
    : m_document(document)
    , m_selection(selection)
    , m_visibility(visibility)
    , m_frames(m_scene, [this] { emit changed(false); })
    , m_shadows(m_scene, [this] { emit changed(false); })
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(restDelay);
    connect(&m_rest, &QTimer::timeout, this, &ShownScene::rest);
    connect(&m_document, &Document::changed, this, &ShownScene::designChanged);
    connect(&m_selection, &Selection::changed, this, &ShownScene::selectionChanged);
    connect(&m_selection, &Selection::hoverChanged, this, &ShownScene::selectionChanged);
    connect(&m_visibility, &SceneVisibility::changed, this, &ShownScene::visibilityChanged);
    designChanged({});
}

void ShownScene::designChanged(const std::set<ElementId>& ids)
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
    refreshMarks(m_document.gestureRunning());
}

void ShownScene::selectionChanged()
{
    updateMirrored();
    updateScans();
    updateLooks();
    refreshMarks(false);
}

void ShownScene::visibilityChanged()
{
    m_scene.checker = m_visibility.layerVisible(Layer::Checker);
    m_scene.meshEdges = m_visibility.layerVisible(Layer::MeshEdges);
    m_scene.ground = m_visibility.layerVisible(Layer::Ground);
    updateMirrored();
    updateCurves();
    updateFrames();
    updateScans();
    setSurface(surface());
}

void ShownScene::setSurface(SurfaceMeshPtr surface)
{
    m_cover.setSurface(std::move(surface));
    updateCover();
    const bool moving = m_sinceSurface.isValid() && m_sinceSurface.elapsed() < movingWithin;
    m_sinceSurface.start();
    m_shadows.cancel();
    updateLooks();
    updateBox();
    updateMarks();
    m_rest.start();
    emit changed(moving);
}

void ShownScene::setCover(CoverMeshPtr cover, TrimMeshPtr trims)
{
    if (!m_cover.setRefined(std::move(cover), std::move(trims)))
        return;
    updateCover();
    refreshMarks(false); // they lie on what is drawn
}

void ShownScene::setFabricMaps(std::map<ElementId, FabricMapsPtr> maps)
{
    m_scene.fabrics = std::move(maps);
    updateLooks();
    emit changed(false);
}

void ShownScene::setFiles(const DesignFiles& files)
{
    m_files = files;
    updateFrames();
    updateScans();
    updateBox();
    m_rest.start();
    emit changed(false);
}

void ShownScene::setMap(VertexMapPtr map)
{
    const bool others = bool(map) != bool(m_scene.map);
    m_scene.map = std::move(map);
    updateScans();
    if (others)
        updateMarks(); // they are darker on colours than on cloth
    emit changed(false);
}

void ShownScene::setField(FieldPicturePtr field)
{
    m_field = std::move(field);
    refreshMarks(m_document.gestureRunning());
}

void ShownScene::setScanPairs(std::vector<std::pair<Vec3, Vec3>> pairs)
{
    m_scans.setPairs(std::move(pairs));
    if (!m_visibility.layerVisible(Layer::ScanPairs))
        return;
    refreshMarks(false);
}

void ShownScene::setGuests(GuestMarks marks)
{
    if (marks.isEmpty() && m_guests.isEmpty())
        return;
    m_guests = std::move(marks);
    refreshMarks(false);
}

void ShownScene::showFramePieces(ElementId frame, const std::vector<int>& pieces)
{
    FramePieceBox box{frame, pieces};
    if (m_pieces == box)
        return;
    m_pieces = std::move(box);
    refreshMarks(false);
}

void ShownScene::setDimmed(bool dimmed)
{
    if (dimmed == m_scene.dimmed)
        return;
    m_scene.dimmed = dimmed;
    emit changed(false);
}

void ShownScene::setSection(const std::optional<SectionPlane>& section)
{
    if (section == m_scene.section)
        return;
    m_scene.section = section;
    m_hits.setSection(section);
    updateScans();
    updateMarks();
    emit sectionChanged();
    emit changed(true);
}

void ShownScene::setFrameOpacity(double opacity)
{
    m_scene.frameOpacity = opacity;
    emit changed(true);
}

void ShownScene::setScanOpacity(double opacity)
{
    m_scans.setOpacity(opacity);
    updateScans();
    emit changed(true);
}

void ShownScene::setColors(const ViewColors& colors)
{
    m_scene.setColors(colors);
    updateScans();
    updateLooks();
    refreshMarks(false);
}

void ShownScene::updateMirrored()
{
    m_mirrored = m_visibility.layerVisible(Layer::Twins) ? mirroredOfMarked(m_document.design(), m_selection)
                                                         : std::set<ElementId>();
}

void ShownScene::updateCurves()
{
    m_curves.update(m_document.design(), m_visibility.unseen(m_document.design()));
}

void ShownScene::updateCover()
{
    m_cover.update(m_visibility.layerVisible(Layer::Cover), m_visibility.unseen(m_document.design()));
    m_hits.setSurface(m_scene.surface);
    m_frames.skins().coverChanged(m_cover.surface());
}

void ShownScene::updateFrames()
{
    if (m_frames.update(m_document.design(), m_files, m_visibility))
        m_rest.start();
}

void ShownScene::updateScans()
{
    m_scans.update(m_document.design(), m_files, m_selection, m_visibility);
}

void ShownScene::updateLooks()
{
    m_cover.updateLooks(m_document.design(), m_selection, m_mirrored);
}

void ShownScene::updateMarks()
{
    const Design& design = m_document.design();
    const SceneMarks::Shown shown{m_visibility.layerVisible(Layer::Seams),
                                  m_visibility.layerVisible(Layer::FixationCurves), m_mirrored};
    SceneMarks(design, m_curves, m_selection, shown).fill(m_scene, m_hoveredPoint);
    if (m_visibility.layerVisible(Layer::Frames))
        m_frames.foam().addLines(design, m_selection, m_scene);
    if (m_field && m_visibility.layerVisible(Layer::Field))
        addFieldLines(*m_field, m_scene);
    if (m_visibility.layerVisible(Layer::ScanPairs))
        m_scans.addPairs();
    m_pieces.addTo(m_scene, design, m_files);
    if (const auto& symmetry = design.settings().symmetry; symmetry && m_visibility.layerVisible(Layer::Symmetry))
        addSymmetryPlane(*symmetry, m_scene);
    cutMarks(m_scene);
    if (m_overlay)
        for (SceneLine& line : m_overlay())
            m_scene.lines.push_back(std::move(line));
    m_scene.lines.insert(m_scene.lines.end(), m_guests.lines.begin(), m_guests.lines.end());
    m_scene.dots.insert(m_scene.dots.end(), m_guests.dots.begin(), m_guests.dots.end());
}

void ShownScene::refreshMarks(bool moving)
{
    updateMarks();
    emit changed(moving);
}

void ShownScene::updateBox()
{
    Box3 solid = m_cover.box();
    solid.extend(m_frames.box());
    if (solid.isEmpty() && m_visibility.layerVisible(Layer::Scans))
        solid = m_scans.points().box();
    Box3 box = solid;
    box.extend(m_curves.box());
    m_empty = box.isEmpty();
    m_scene.floor = m_empty ? 0 : m_frames.floorUnder(m_document.design(), solid.isEmpty() ? box : solid) - 1;
    m_scene.box = m_empty ? Box3(Vec3(-500, -500, 0), Vec3(500, 500, 0)) : box;
    emit boxChanged();
}

void ShownScene::rest()
{
    if (m_shadowsWanted)
        m_shadows.request();
    m_frames.skins().request();
    emit rested();
}

CoverHit ShownScene::hit(const Camera& camera, QPointF pixel) const
{
    return m_hits.hit({camera, &m_curves, m_selection, m_visibility.layerVisible(Layer::Seams)}, pixel);
}

std::optional<Vec3> ShownScene::scanPoint(ElementId scan, const Camera& camera, QPointF pixel) const
{
    if (!m_visibility.layerVisible(Layer::Scans) || m_visibility.hidden().contains(scan))
        return std::nullopt;
    return m_scans.points().pointAt(scan, camera, pixel);
}

std::optional<CoverPoint> ShownScene::inPattern(const CoverHit& solid) const
{
    return solid.kind == CoverHit::Kind::Cover ? m_cover.places().inPattern(solid.triangle, solid.position)
                                               : std::nullopt;
}

Vec3 ShownScene::middleOf(ElementId id) const
{
    if (const Box3 frame = m_frames.boxOf(id); !frame.isEmpty())
        return frame.center();
    if (const Box3 scan = m_scans.points().box(id); !scan.isEmpty() && m_visibility.layerVisible(Layer::Scans))
        return scan.center(); // where a scanner stood says nothing
    const ElementPtr element = m_document.design().element(id);
    const Placement* placement = element ? elementPlacement(*element) : nullptr;
    return placement ? placement->position : Vec3(Vec3::Zero());
}

Box3 ShownScene::boxWithScans() const
{
    Box3 box = m_scene.box;
    if (!m_visibility.layerVisible(Layer::Scans))
        return box;
    m_document.design().each<Scan>([&](ElementId id, const Scan&) {
        if (!m_visibility.hidden().contains(id))
            box.extend(m_scans.points().box(id));
    });
    return box;
}

Box3 ShownScene::selectedBox() const
{
    Box3 box = m_curves.box(m_selection.elements());
    box.extend(m_cover.box(m_selection.elements()));
    for (const ElementId id : m_selection.elements()) {
        box.extend(m_scans.points().box(id));
        box.extend(m_frames.boxOf(id));
    }
    return box;
}

} // namespace bolster
