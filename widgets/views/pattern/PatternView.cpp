#include "PatternView.h"

#include "ArcLength.h"
#include "Crosshair.h"
#include "Document.h"
#include "ElementText.h"
#include "HitSelection.h"
#include "PatternGrid.h"
#include "PatternRulers.h"
#include "ProblemSet.h"
#include "SeamColors.h"
#include "Selection.h"
#include "SelectionEdits.h"
#include "SelectionSteps.h"
#include "Translated.h"
#include "Units.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPainter>
#include <QScopeGuard>
#include <QToolTip>

#include <cmath>

namespace bolster {

namespace {

// Pixels.
constexpr double grabRadius = 7;
constexpr double fitMargin = 36;
constexpr double clickReach = 5;

} // namespace

PatternView::PatternView(Document& document, Selection& selection, ProblemSet& problems, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_selection(selection)
    , m_problems(problems)
    , m_legend(new MapLegend(this))
    , m_crosshair(new Crosshair(this))
    , m_rulers({new PatternRuler(*this, Qt::Horizontal), new PatternRuler(*this, Qt::Vertical)})
    , m_tool(makePatternTool(m_toolKind, *this))
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(200, 160);
    m_legend->raise(); // above the cross-hair
    setAttribute(Qt::WA_OpaquePaintEvent);
    connect(&document, &Document::changed, this, &PatternView::designChanged);
    const auto selectionChanged = [this] {
        m_mirrored = mirroredOfMarked(m_document.design(), m_selection);
        refresh();
    };
    connect(&selection, &Selection::changed, this, selectionChanged);
    connect(&selection, &Selection::hoverChanged, this, selectionChanged);
    connect(&problems, &ProblemSet::changed, this, &PatternView::refresh);
    m_scene.reset(document.design());
    m_seamColors = seamColors(document.design(), ViewColors::of(palette()).dark);
}

PatternView::~PatternView() = default;

void PatternView::designChanged(const std::set<ElementId>& ids)
{
    const auto elsewhere = [this](ElementId id) {
        const Design& design = m_document.design();
        return design.find<FixationCurve>(id) || design.find<Frame>(id);
    };
    if (!ids.empty() && std::ranges::all_of(ids, elsewhere))
        return; // the pattern stays as it is while a curve is dragged in 3D
    m_scene.update(m_document.design(), ids);
    m_seamColors = seamColors(m_document.design(), ViewColors::of(palette()).dark);
    m_mirrored = mirroredOfMarked(m_document.design(), m_selection);
    refresh();
}

void PatternView::setSurface(const SurfaceMeshPtr& surface)
{
    m_surface = surface;
    const auto topology = surface ? surface->topology : nullptr;
    m_mesh.setTopology(topology);
    if (m_layers.mesh)
        update();
}

void PatternView::setFabricColors(std::map<ElementId, QColor> colors)
{
    m_scene.setFabricColors(m_document.design(), std::move(colors));
    update();
}

void PatternView::setMap(const SurfaceMapPtr& map)
{
    m_map.setMap(map);
    m_mapShown = map;
    placeLegend();
}

void PatternView::setLegendShown(bool shown)
{
    m_legendShown = shown;
    placeLegend();
}

void PatternView::placeLegend()
{
    m_legend->setMap(m_legendShown ? m_mapShown : nullptr);
    m_legend->place(busyPlaces());
    if (!m_fitted.isEmpty())
        fit();
    update();
}

void PatternView::setHidden(std::set<ElementId> hidden)
{
    m_hidden = std::move(hidden);
    update();
}

void PatternView::setMapReading(const QString& reading)
{
    m_legend->setReading(reading);
}

void PatternView::setLayers(const PatternLayers& layers)
{
    m_layers = layers;
    m_snap.grid = layers.grid;
    update();
}

void PatternView::setSnapping(bool on)
{
    m_snap.on = on;
}

void PatternView::setRulersShown(bool shown)
{
    for (PatternRuler* ruler : m_rulers)
        ruler->setVisible(shown);
    emit freeRoomChanged();
}

QRect PatternView::freeRoom() const
{
    const int ruler = m_rulers.front()->isHidden() ? 0 : PatternRuler::thickness;
    return rect().adjusted(ruler, ruler, 0, -scaleBarRoom);
}

void PatternView::setGuides(const PatternGuides& guides)
{
    m_guides = guides;
    m_snap.guides = m_guidesShown ? m_guides : PatternGuides();
    refresh();
}

void PatternView::setGuidesShown(bool shown)
{
    m_guidesShown = shown;
    setGuides(m_guides);
}

void PatternView::setBackground(const BackgroundPicture& picture)
{
    m_background = picture;
    refresh();
}

void PatternView::fitAll()
{
    showBox(m_scene.boundingBox());
}

void PatternView::fitSelection()
{
    const Box2 box = m_scene.boundingBox(m_selection.elements());
    showBox(box.isEmpty() ? m_scene.boundingBox() : box);
}

void PatternView::showBox(const Box2& box)
{
    m_fitted = box;
    fit();
}

/// With a map its legend gets a strip of its own where it would cover patches.
void PatternView::fit()
{
    apply(PatternTransform::fitting(m_fitted, size(), fitMargin));
    if (m_legend->isHidden() || m_legend->place(busyPlaces()))
        return;
    const int strip = m_legend->height();
    if (height() < 3 * strip)
        return;
    apply(PatternTransform::fitting(m_fitted, size() - QSize(0, strip), fitMargin));
    m_legend->place(busyPlaces());
}

/// Where the legend would cover something: rulers, the scale bar, patches. Pixels.
std::vector<QRectF> PatternView::busyPlaces() const
{
    std::vector<QRectF> places{scaleBarPlace(m_transform, size())};
    for (const PatternRuler* ruler : m_rulers)
        if (!ruler->isHidden())
            places.push_back(ruler->geometry());
    for (const auto& [id, patch] : m_scene.patches())
        places.push_back(
            QRectF(m_transform.toPixels(patch.box.min()), m_transform.toPixels(patch.box.max())).normalized());
    return places;
}

void PatternView::setTransform(const PatternTransform& transform)
{
    m_fitted.setEmpty();
    apply(transform);
    emit transformChanged(m_transform);
}

void PatternView::apply(const PatternTransform& transform)
{
    m_transform = transform;
    placeCrosshair();
    refresh();
}

void PatternView::setTool(PatternToolKind kind)
{
    if (kind == m_toolKind)
        return;
    m_tool->leave();
    m_toolKind = kind;
    m_tool = makePatternTool(kind, *this);
    if (kind != PatternToolKind::Select)
        setFocus();
    emit toolChanged(kind);
    refresh();
}

void PatternView::endTool()
{
    const auto back = [this, ended = m_tool.get()] {
        if (m_tool.get() == ended) // else another one has been begun meanwhile
            setTool(PatternToolKind::Select);
    };
    QMetaObject::invokeMethod(this, back, Qt::QueuedConnection);
}

QString PatternView::prompt() const
{
    if (const auto& breakage = m_document.breakage())
        return tr("%1 Let go here, and it goes back to where it was.").arg(translated(breakage->why));
    return m_tool->prompt();
}

PatternHit PatternView::hit(QPointF pixel) const
{
    if (m_moving && m_hit && m_hit->first == pixel)
        return m_hit->second;
    const PatternHit found = m_scene.hit(
        m_transform.toLayout(pixel), m_transform.millimetres(grabRadius),
        [this](ElementId id) { return pointsShown(id); },
        [this](const PatternLine& line) { return m_layers.shows(line); });
    m_hit = {pixel, found};
    return found;
}

bool PatternView::pointsShown(ElementId id) const
{
    if (const auto line = m_scene.lines().find(id); line != m_scene.lines().end())
        return m_layers.points && m_layers.shows(line->second) &&
               (m_selection.contains(id) || m_selection.hovered() == id);
    const PatternPatch* patch = m_scene.patch(id);
    return patch && m_layers.points && (m_selection.contains(id) || m_selection.hovered() == id) &&
           PatternPainter::pointsReadable(*patch, m_transform);
}

std::optional<CoverPoint> PatternView::patchPointAt(QPointF pixel) const
{
    const PatternHit found = hit(pixel);
    const Patch* patch = m_document.design().find<Patch>(found.patch);
    if (!patch)
        return std::nullopt;
    return CoverPoint{found.patch, fromLayout(*patch, m_transform.toLayout(pixel))};
}

void PatternView::showPlace(const std::optional<CoverPoint>& point)
{
    m_place = point;
    placeCrosshair();
}

void PatternView::placeCrosshair()
{
    const Patch* patch = m_place ? m_document.design().find<Patch>(m_place->patch) : nullptr;
    m_crosshair->showAt(patch ? std::optional(m_transform.toPixels(toLayout(*patch, m_place->outline)))
                              : std::nullopt);
}

void PatternView::reveal(const CoverPoint& point)
{
    const Patch* patch = m_document.design().find<Patch>(point.patch);
    if (!patch)
        return;
    const QPointF pixel = m_transform.toPixels(toLayout(*patch, point.outline));
    if (!QRectF(rect()).contains(pixel))
        setTransform(m_transform.panned(QRectF(rect()).center() - pixel));
}

void PatternView::refresh()
{
    if (m_panFrom)
        setCursor(Qt::ClosedHandCursor);
    else
        setCursor(m_spaceDown ? QCursor(Qt::OpenHandCursor) : m_tool->cursor());
    if (const QString text = prompt(); text != m_prompt) {
        m_prompt = text;
        emit promptChanged(text);
    }
    for (PatternRuler* ruler : m_rulers)
        ruler->update();
    update();
}

void PatternView::report(const QString& problem)
{
    emit failed(problem);
}

bool PatternView::event(QEvent* event)
{
    try {
        return handle(event);
    } catch (const std::exception& error) {
        toolFailed(error);
        return true;
    }
}

/// The design is again what it was before the gesture.
void PatternView::toolFailed(const std::exception& error)
{
    m_document.cancelGesture();
    m_tool = makePatternTool(m_toolKind, *this);
    emit failed(tr("This could not be done, and nothing was changed: %1").arg(QString::fromUtf8(error.what())));
    refresh();
}

bool PatternView::handle(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        if (m_toolKind == PatternToolKind::Select) // the others write beside the pointer themselves
            QToolTip::showText(help->globalPos(), toolTipAt(help->pos()), this);
        return true;
    }
    if (event->type() == QEvent::NativeGesture) {
        const auto* gesture = static_cast<QNativeGestureEvent*>(event);
        if (gesture->gestureType() == Qt::ZoomNativeGesture)
            setTransform(m_transform.zoomed(gesture->position(), 1 + gesture->value()));
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride) {
        // Space and the arrows are ours even where a window gives them another meaning.
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Space || (key >= Qt::Key_Left && key <= Qt::Key_Down) || m_tool->wants(key))
            event->accept();
    }
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Tab) {
        m_document.finishGesture();
        if (m_tool->wants(Qt::Key_Tab))
            return m_tool->keyPress(*static_cast<QKeyEvent*>(event));
    }
    // Tab walks through the pattern while patches are selected; F6 leads out of the view.
    if (event->type() == QEvent::KeyPress && m_toolKind == PatternToolKind::Select &&
        !m_document.gestureRunning()) {
        const auto* press = static_cast<QKeyEvent*>(event);
        const bool back = press->key() == Qt::Key_Backtab;
        const bool plain = (press->modifiers() & ~Qt::ShiftModifier) == Qt::NoModifier;
        if (plain && (back || press->key() == Qt::Key_Tab) && selectNext(m_document.design(), m_selection, !back))
            return true;
    }
    return QWidget::event(event);
}

QString PatternView::toolTipAt(QPointF pixel) const
{
    const PatternHit found = hit(pixel);
    if (!found)
        return {};
    const Design& design = m_document.design();
    const ElementId id = found.element();
    QStringList lines{displayName(design, id)};
    if (const Seam* seam = design.find<Seam>(id)) {
        lines << seamSummary(design, *seam);
    } else if (const FixationSeam* fixation = design.find<FixationSeam>(id)) {
        lines << lengthText(stretchLength(design, fixation->stretch));
    } else if (const auto line = m_scene.lines().find(id); line != m_scene.lines().end()) {
        lines << lengthText(ArcLength2(line->second.curve()).total());
    } else if (const Patch* patch = design.find<Patch>(id)) {
        const Vec2 extent = patch->outline.boundingBox().sizes();
        lines << sizeText(extent.x(), extent.y());
    }
    if (const auto edge = edgeAt(m_scene, found))
        lines << tr("Edge: %1").arg(lengthText(stretchLength(design, edge->stretch)));
    lines << m_problems.text(id);
    lines.removeAll(QString());
    return lines.join(u'\n');
}

void PatternView::paintEvent(QPaintEvent*)
{
    const ViewColors colors = ViewColors::of(palette());
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * 0.92);
    QPainter painter(this);
    const std::set<ElementId> invalid = m_document.breakage() ? m_document.breakage()->elements : ChangeSet();
    const PatternPainter::Input input{m_scene, m_mesh,       m_map,       m_selection, m_problems,
                                      invalid, m_seamColors, m_transform, m_layers,    colors,
                                      small,   size(),       m_mirrored,  m_hidden};
    PatternPainter(painter, input).paint();
    paintBackground(painter, m_background, m_transform, colors.dark);
    paintGuides(painter, m_snap.guides, m_transform, size(), colors);
    m_tool->paint(painter, colors);
}

void PatternView::resizeEvent(QResizeEvent* event)
{
    for (PatternRuler* ruler : m_rulers)
        ruler->place();
    m_legend->place(busyPlaces());
    if (m_fitted.isEmpty() && event->oldSize().isValid())
        m_transform = m_transform.resized(event->oldSize(), size());
    else
        fit();
}

void PatternView::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange)
        designChanged({});
    QWidget::changeEvent(event);
}

PatternPointer PatternView::pointerOf(const QMouseEvent& event) const
{
    return {event.position(), m_transform.toLayout(event.position()), event.modifiers()};
}

void PatternView::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && m_spaceDown)) {
        m_panFrom = event->position();
        refresh();
    } else if (event->button() == Qt::LeftButton) {
        m_pressedAt = event->position();
        m_tool->press(pointerOf(*event));
    } else if (event->button() == Qt::RightButton && rightButtonSelects()) {
        // The context menu that follows is about what lies under the pointer.
        const PatternHit found = hit(event->position());
        const bool alone = m_selection.elements().size() == 1 && m_selection.edges().empty(); // its edge is meant
        if (found && (!isSelected(m_selection, m_scene, found) || (alone && edgeAt(m_scene, found))))
            selectOnly(m_selection, m_scene, found);
    }
}

/// Not while something is being drawn or dragged, nor with tools that draw.
bool PatternView::rightButtonSelects() const
{
    return !m_document.gestureRunning() && !m_panFrom && m_tool->keys().empty() &&
           (m_toolKind == PatternToolKind::Select || m_toolKind == PatternToolKind::Sew ||
            m_toolKind == PatternToolKind::Trim || m_toolKind == PatternToolKind::Measure);
}

void PatternView::contextMenuEvent(QContextMenuEvent* event)
{
    event->accept();
    if (m_document.gestureRunning() || m_panFrom)
        return;
    const bool byKey = event->reason() == QContextMenuEvent::Keyboard;
    const QPoint global = byKey ? mapToGlobal(rect().center()) : event->globalPos();
    if (const ToolKeys keys = m_tool->keys(); !keys.empty())
        emit toolMenuWanted(global, keys);
    else
        emit contextMenuWanted(global, rightButtonSelects() &&
                                           (byKey ? !m_selection.elements().empty() : bool(hit(event->pos()))));
}

void PatternView::mouseMoveEvent(QMouseEvent* event)
{
    if (m_panFrom) {
        setTransform(m_transform.panned(event->position() - *m_panFrom));
        m_panFrom = event->position();
    } else {
        m_hit.reset();
        m_moving = true;
        const auto moved = qScopeGuard([this] { m_moving = false; });
        m_tool->move(pointerOf(*event));
        emit patchPointed(patchPointAt(event->position())); // panning keeps it
    }
    emit pointerMoved(m_transform.toLayout(event->position()));
}

void PatternView::mouseReleaseEvent(QMouseEvent* event)
{
    if (m_panFrom) {
        m_panFrom.reset();
        refresh();
    } else if (event->button() == Qt::LeftButton) {
        m_tool->release(pointerOf(*event));
        const bool click = (event->position() - m_pressedAt).manhattanLength() < clickReach;
        if (const auto point = patchPointAt(event->position());
            point && click && m_toolKind == PatternToolKind::Select)
            emit patchClicked(*point);
    }
}

void PatternView::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        m_tool->doubleClick(pointerOf(*event));
}

void PatternView::wheelEvent(QWheelEvent* event)
{
    const double steps = event->angleDelta().y() / 120.0;
    setTransform(m_transform.zoomed(event->position(), std::pow(1.2, steps)));
    event->accept();
}

void PatternView::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Space && !m_tool->wants(Qt::Key_Space)) {
        m_spaceDown = true;
        refresh();
    } else if (event->key() == Qt::Key_Home) {
        fitAll();
    } else if (event->key() == Qt::Key_Escape) {
        m_tool->escape();
    } else if (!m_tool->keyPress(*event)) {
        QWidget::keyPressEvent(event);
    }
}

void PatternView::keyReleaseEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
        m_spaceDown = false;
        refresh();
    } else if (!m_tool->keyRelease(*event)) {
        QWidget::keyReleaseEvent(event);
    }
}

void PatternView::leaveEvent(QEvent*)
{
    m_tool->leave();
    emit pointerMoved(std::nullopt);
    emit patchPointed(std::nullopt);
}

void PatternView::focusOutEvent(QFocusEvent* event)
{
    m_spaceDown = false;
    m_tool->leave();
    QWidget::focusOutEvent(event);
}

} // namespace bolster
