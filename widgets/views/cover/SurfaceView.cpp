#include "SurfaceView.h"

#include "MapLegend.h"
#include "SurfaceViewCube.h"

#include <QEvent>

namespace bolster {

namespace {

constexpr int cubeMargin = 8; ///< pixels

} // namespace

SurfaceView::SurfaceView(Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent)
    , m_shown(document, selection, m_visibility)
    , m_navigation(m_shown, *this)
    , m_drag(m_navigation, m_shown)
    , m_canvas(m_shown.scene(), m_navigation.camera(), *this)
    , m_section(m_shown, m_navigation.camera(), *this)
    , m_crosshair(m_shown, m_navigation.camera(), *this)
    , m_tools(document, selection, m_shown, m_navigation.camera(), m_section.handle(), *this)
    , m_cube(new SurfaceViewCube(this))
    , m_legend(new MapLegend(this))
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(160, 120);
    m_section.raise(); // what comes and goes with the pointer never covers it, nor cube and legend
    m_shown.setColors(ViewColors::of(palette()));
    m_shown.setOverlay([this] {
        std::vector<SurfaceLine> lines = m_tools.tool().guides();
        for (SurfaceLine& line : m_section.handle().lines())
            lines.push_back(std::move(line));
        return lines;
    });
    wireScene();
    wireTools();
}

SurfaceView::~SurfaceView()
{
    // A tool that is taken away may take back what it has begun.
    m_shown.disconnect(this);
    m_shown.setOverlay({});
}

void SurfaceView::wireScene()
{
    connect(&m_shown, &ShownScene::changed, this, &SurfaceView::draw);
    connect(&m_shown, &ShownScene::sectionChanged, this, [this] { m_crosshair.place(); });
    connect(&m_shown, &ShownScene::rested, this, [this] { m_crosshair.follow(); });
    connect(&m_navigation, &SurfaceNavigation::moved, this, &SurfaceView::cameraMoved);
    connect(m_cube, &SurfaceViewCube::viewChosen, &m_navigation, &SurfaceNavigation::lookFrom);
    connect(m_cube, &SurfaceViewCube::turned, &m_navigation, &SurfaceNavigation::turn);
    connect(&m_canvas, &CanvasChoice::changed, &m_shown, &ShownScene::setShadows);
    connect(&m_canvas, &CanvasChoice::note, this, &SurfaceView::rendererNote);
    connect(&m_canvas, &CanvasChoice::pictured, this, &SurfaceView::pictured);
}

void SurfaceView::wireTools()
{
    m_tools.speakThrough(*this);
    connect(&m_section, &SectionControl::closed, this, &SurfaceView::sectionClosed);
    connect(&m_section, &SectionControl::entered, this, [this] { m_tools.tool().leave(); });
    connect(&m_section, &SectionControl::handleChanged, this, [this] {
        m_shown.refreshMarks(m_section.handle().dragging());
        m_tools.refresh();
    });
}

void SurfaceView::setSoftwareRenderer(std::unique_ptr<SoftwareRenderer> renderer)
{
    m_canvas.setSoftwareRenderer(std::move(renderer));
}

void SurfaceView::setDrawing(Drawing drawing)
{
    m_canvas.setDrawing(drawing);
}

bool SurfaceView::pictures(const SurfaceMeshPtr& surface) const
{
    return !isVisible() || (m_shown.surface() == surface && m_canvas.upToDate());
}

void SurfaceView::setMap(const SurfaceMapPtr& map)
{
    m_legend->setMap(map);
    m_shown.setMap(map);
}

void SurfaceView::setMapReading(const QString& reading)
{
    m_legend->setReading(reading);
}

void SurfaceView::reveal(const CoverPoint& point)
{
    if (const std::optional<Vec3> place = m_shown.onCover(point))
        m_navigation.reveal(*place);
}

void SurfaceView::cameraMoved()
{
    if (m_shown.scene().section || !m_tools.tool().guides().empty())
        m_shown.updateMarks(); // handles keep their size in the picture
    m_crosshair.place();
    draw(true);
}

void SurfaceView::draw(bool moving)
{
    m_cube->setCamera(m_navigation.camera());
    m_canvas.refresh(moving);
}

void SurfaceView::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_canvas.make();
    m_navigation.catchUp();
    draw(false);
}

void SurfaceView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    m_navigation.resize();
    m_canvas.place();
    m_legend->place();
    m_section.place();
    m_crosshair.place();
    m_cube->move(width() - m_cube->width() - cubeMargin, cubeMargin);
    m_cube->setVisible(width() > 3 * m_cube->width() && height() > 2 * m_cube->height());
    m_navigation.catchUp();
    draw(true);
}

void SurfaceView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange)
        m_shown.setColors(ViewColors::of(palette()));
}

} // namespace bolster
