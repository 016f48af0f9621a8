#include "CoverView.h"

#include "MapLegend.h"
#include "MouseStyle.h"
#include "Selection.h"
#include "Units.h"
#include "ViewCube.h"

#include <QEvent>
#include <QPainter>

#include <utility>

namespace bolster {

namespace {

constexpr int cubeMargin = 8; ///< pixels

} // namespace

CoverView::CoverView(Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent)
    , m_selection(selection)
    , m_shown(document, selection, m_visibility)
    , m_navigation(m_shown, *this)
    , m_drag(m_navigation, m_shown)
    , m_canvas(m_shown.scene(), m_navigation.camera(), *this)
    , m_section(m_shown, m_navigation.camera(), *this)
    , m_crosshair(m_shown, m_navigation.camera(), *this)
    , m_measures(new CoverMeasures(document, selection, m_shown, m_navigation.camera(), this))
    , m_tools(document, selection, m_shown, m_navigation.camera(), m_section.handle(), *m_measures, *this)
    , m_cube(new ViewCube(this))
    , m_legend(new MapLegend(this))
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(160, 120);
    m_section.raise(); // what comes and goes with the pointer never covers it, nor cube and legend
    m_shown.setColors(ViewColors::of(palette()));
    m_shown.setOverlay([this] {
        std::vector<SceneLine> lines = m_tools.tool().guides();
        for (SceneLine& line : m_section.handle().lines())
            lines.push_back(std::move(line));
        return lines;
    });
    connect(m_measures, &CoverMeasures::measured, this, &CoverView::measured);
    wireScene();
    wireTools();
    m_whole = true;
}

CoverView::~CoverView()
{
    m_whole = false;
    // A tool that is taken away may take back what it has begun.
    m_shown.disconnect(this);
    m_shown.setOverlay({});
}

void CoverView::wireScene()
{
    connect(&m_shown, &ShownScene::changed, this, &CoverView::draw);
    connect(&m_shown, &ShownScene::sectionChanged, this, [this] { m_crosshair.place(); });
    connect(&m_shown, &ShownScene::rested, this, [this] { m_crosshair.follow(); });
    connect(&m_navigation, &CoverNavigation::moved, this, &CoverView::cameraMoved);
    connect(m_cube, &ViewCube::viewChosen, &m_navigation, &CoverNavigation::lookFrom);
    connect(m_cube, &ViewCube::turned, &m_navigation, &CoverNavigation::turn);
    connect(&m_canvas, &CanvasChoice::changed, &m_shown, &ShownScene::setShadows);
    connect(&m_canvas, &CanvasChoice::note, this, &CoverView::rendererNote);
    connect(&m_canvas, &CanvasChoice::pictured, this, &CoverView::pictured);
}

void CoverView::wireTools()
{
    m_tools.speakThrough(*this);
    connect(&NumberStyles::instance(), &NumberStyles::changed, &m_tools, &ToolHost::refresh);
    connect(&MouseStyles::instance(), &MouseStyles::changed, &m_tools, &ToolHost::refresh);
    connect(&m_section, &SectionControl::closed, this, &CoverView::sectionClosed);
    connect(&m_section, &SectionControl::entered, this, [this] { m_tools.tool().leave(); });
    connect(&m_section, &SectionControl::handleChanged, this, [this] {
        m_shown.refreshMarks(m_section.handle().dragging());
        m_tools.refresh();
    });
}

void CoverView::setSoftwareRenderer(std::unique_ptr<SoftwareRenderer> renderer)
{
    m_canvas.setSoftwareRenderer(std::move(renderer));
}

void CoverView::setDrawing(Drawing drawing)
{
    m_canvas.setDrawing(drawing);
}

bool CoverView::pictures(const SurfaceMeshPtr& surface) const
{
    return !isVisible() || m_covered || (m_shown.surface() == surface && m_canvas.upToDate());
}

void CoverView::setMap(const ShownMapPtr& map)
{
    m_legend->setMap(map);
    m_shown.setMap(map);
}

const ShownMapPtr& CoverView::map() const
{
    return m_legend->map();
}

void CoverView::setMapReading(const QString& reading)
{
    m_legend->setReading(reading);
}

QImage CoverView::grabPicture(const ViewColors& colors)
{
    m_shown.setColors(colors);
    const QImage picture = grabPicture();
    m_shown.setColors(ViewColors::of(palette()));
    return picture;
}

QImage CoverView::grabCover()
{
    constexpr double room = 0.05; // of the longer side
    const Selection::Elements elements = m_selection.elements();
    const Selection::Points points = m_selection.points();
    const Selection::Edges edges = m_selection.edges();
    m_selection.clear();
    m_selection.hover(noElement);
    const SurfaceMeshPtr surface = shownSurface();
    const Camera before = m_navigation.camera();
    Camera camera = before;
    if (surface && !surface->positions.empty()) { // as large as the view has room for
        camera.fit(surface->boundingBox());
        m_navigation.setCamera(camera);
    }
    const QImage whole = grabPicture();
    m_navigation.setCamera(before);
    m_selection.set(elements, points, edges);

    Box2 box;
    if (surface)
        for (const Vec3& position : surface->positions)
            if (const std::optional<Vec2> pixel = camera.pixel(position))
                box.extend(*pixel);
    if (box.isEmpty() || whole.isNull())
        return whole;
    const double around = room * box.sizes().maxCoeff(), dots = whole.width() / camera.size.x();
    const Vec2 low = dots * (box.min().array() - around), size = dots * (box.sizes().array() + 2 * around);
    const QRect part = QRectF(low.x(), low.y(), size.x(), size.y()).toAlignedRect() & whole.rect();
    return part.isEmpty() ? whole : whole.copy(part);
}

void CoverView::reveal(const CoverPoint& point)
{
    if (const std::optional<Vec3> place = m_shown.onCover(point))
        m_navigation.reveal(*place);
}

void CoverView::face(const CoverPoint& point)
{
    const std::optional<Vec3> place = m_shown.onCover(point), outwards = m_shown.outwards(point);
    if (place && outwards)
        m_navigation.face(*place, *outwards);
}

void CoverView::cameraMoved()
{
    if (m_shown.scene().section || !m_tools.tool().guides().empty())
        m_shown.updateMarks(); // handles keep their size in the picture
    m_crosshair.place();
    m_measures->refresh();
    draw(true);
}

void CoverView::draw(bool moving)
{
    m_cube->setCamera(m_navigation.camera());
    m_canvas.refresh(moving);
}

void CoverView::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (!m_covered)
        m_canvas.makeSoon();
    m_navigation.catchUp();
    draw(false);
}

void CoverView::setCovered(bool covered)
{
    if (std::exchange(m_covered, covered) == covered)
        return;
    m_canvas.setCovered(covered);
    if (!covered && isVisible())
        m_canvas.makeSoon();
    draw(false);
    emit pictured(); // or nothing that could be seen
}

/// Until there is something that draws.
void CoverView::paintEvent(QPaintEvent*)
{
    QPainter(this).fillRect(rect(), m_shown.scene().veil());
}

void CoverView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    m_navigation.resize();
    m_canvas.place();
    m_legend->place();
    m_section.place();
    m_crosshair.place();
    m_measures->refresh();
    m_cube->move(width() - m_cube->width() - cubeMargin, cubeMargin);
    m_cube->setVisible(width() > 3 * m_cube->width() && height() > 2 * m_cube->height());
    m_navigation.catchUp();
    draw(true);
}

void CoverView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange)
        m_shown.setColors(ViewColors::of(palette()));
}

} // namespace bolster
