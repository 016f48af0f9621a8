#include "VersionPane.h"

#include "CoverLink.h"
#include "DesignFiles.h"
#include "PatternView.h"
#include "RayRenderer.h"
#include "SolverLink.h"
#include "SurfaceView.h"

#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QSplitter>
#include <QVBoxLayout>

namespace bolster {

VersionPane::VersionPane(QWidget* parent)
    : QWidget(parent)
    , m_solver(std::make_unique<SolverLink>(m_document))
    , m_covers(std::make_unique<CoverLink>())
    , m_title(new QLabel)
    , m_views(new QSplitter(Qt::Vertical))
    , m_pattern(new PatternView(m_document, m_selection, m_problems))
    , m_surface(new SurfaceView(m_document, m_selection))
{
    m_surface->setSoftwareRenderer(std::make_unique<RayRenderer>());
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_title->setTextFormat(Qt::PlainText);
    m_title->setContentsMargins(8, 6, 8, 6);
    m_views->addWidget(m_pattern);
    m_views->addWidget(m_surface);
    m_views->setSizes({100, 130});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_title);
    layout->addWidget(m_views, 1);
    m_pattern->installEventFilter(this);
    m_surface->installEventFilter(this);
    connect(m_covers.get(), &CoverLink::refined, m_surface, &SurfaceView::setCover);
    connect(m_solver.get(), &SolverLink::surfaceShown, m_surface, &SurfaceView::setSurface);
    connect(m_solver.get(), &SolverLink::surfaceShown, m_covers.get(), &CoverLink::setSurface);
    connect(m_solver.get(), &SolverLink::surfaceChanged, this, [this](const SurfaceMeshPtr& surface) {
        m_pattern->setSurface(surface);
        if (surface && std::exchange(m_fitCover, false))
            m_surface->setStandardView(SurfaceView::StandardView::ThreeQuarter);
    });
}

VersionPane::~VersionPane() = default;

void VersionPane::setVersion(const QString& title, const Design& design, const DesignFiles& files)
{
    m_title->setText(title);
    m_selection.clear();
    m_document.reset(design);
    m_covers->setDesign(design);
    m_solver->forget(files);
    m_surface->setFiles(files);
    m_pattern->fitAll();
    m_fitCover = true;
}

void VersionPane::showForLooks()
{
    m_title->hide();
    m_views->setSizes({100, 300});
    using Layer = SurfaceView::Layer;
    for (const Layer layer : {Layer::Checker, Layer::FixationCurves, Layer::HandleCurves, Layer::FancySeams})
        m_surface->setLayerVisible(layer, false);
}

void VersionPane::setFiles(const DesignFiles& files)
{
    m_solver->setFiles(files);
    m_surface->setFiles(files);
}

/// What would begin to change something moves the picture instead.
bool VersionPane::eventFilter(QObject* view, QEvent* event)
{
    const QEvent::Type type = event->type();
    if (type == QEvent::KeyPress)
        return static_cast<QKeyEvent*>(event)->key() != Qt::Key_Home;
    if (type == QEvent::ContextMenu || type == QEvent::MouseButtonDblClick)
        return true;
    if (type != QEvent::MouseButtonPress && type != QEvent::MouseButtonRelease)
        return false;
    auto* mouse = static_cast<QMouseEvent*>(event);
    if (mouse->button() != Qt::LeftButton)
        return false;
    QMouseEvent middle(type, mouse->position(), mouse->globalPosition(), Qt::MiddleButton,
                       type == QEvent::MouseButtonPress ? Qt::MiddleButton : Qt::NoButton, mouse->modifiers());
    view->event(&middle);
    return true;
}

} // namespace bolster
