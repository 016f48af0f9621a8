#include "VersionPane.h"

#include "CoverLink.h"
#include "CoverView.h"
#include "DesignFiles.h"
#include "PatternView.h"
#include "RayRenderer.h"
#include "SolverLink.h"

#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QSplitter>
#include <QVBoxLayout>

namespace bolster {

VersionPane::VersionPane(std::shared_ptr<RestingCache> kept, QWidget* parent)
    : QWidget(parent)
    , m_solver(std::make_unique<SolverLink>(m_document, nullptr, std::move(kept)))
    , m_covers(std::make_unique<CoverLink>())
    , m_title(new QLabel)
    , m_views(new QSplitter(Qt::Vertical))
    , m_pattern(new PatternView(m_document, m_selection, m_problems))
    , m_coverView(new CoverView(m_document, m_selection))
{
    m_coverView->setSoftwareRenderer(std::make_unique<RayRenderer>());
    m_coverView->visibility().setLayerVisible(CoverView::Layer::Checker, false);
    m_computing = new QLabel(tr("Computing the cover \u2026"), m_coverView);
    m_computing->setObjectName(QStringLiteral("computing"));
    m_computing->setAutoFillBackground(true);
    m_computing->setFrameShape(QFrame::StyledPanel);
    m_computing->setMargin(8);
    m_computing->move(12, 12);
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_title->setTextFormat(Qt::PlainText);
    m_title->setContentsMargins(8, 6, 8, 6);
    m_views->addWidget(m_pattern);
    m_views->addWidget(m_coverView);
    m_views->setSizes({100, 130});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_title);
    layout->addWidget(m_views, 1);
    m_pattern->installEventFilter(this);
    m_coverView->installEventFilter(this);
    connect(m_covers.get(), &CoverLink::refined, &m_coverView->shown(), &ShownScene::setCover);
    connect(m_solver.get(), &SolverLink::surfaceChanged, this, &VersionPane::showSurface);
    connect(m_solver.get(), &SolverLink::statusChanged, this, &VersionPane::showState);
    showState();
}

VersionPane::~VersionPane() = default;

void VersionPane::setVersion(const QString& title, const Design& design, const DesignFiles& files)
{
    m_title->setText(title);
    m_pattern->setAccessibleName(tr("Pattern of %1").arg(title));
    m_coverView->setAccessibleName(tr("Cover of %1").arg(title));
    m_selection.clear();
    m_document.reset(design);
    m_covers->setDesign(design);
    m_coverView->shown().setFiles(files);
    m_pattern->navigation().fitAll();
    m_fitCover = true;
    if (m_followed)
        showSurface(m_followed->surface());
    else
        m_solver->forget(files);
    showState();
}

void VersionPane::follow(SolverLink& solver)
{
    m_followed = &solver;
    m_solver->setPaused(true);
    connect(&solver, &SolverLink::surfaceChanged, this, &VersionPane::showSurface);
    connect(&solver, &SolverLink::statusChanged, this, &VersionPane::showState);
}

void VersionPane::showSurface(const SurfaceMeshPtr& surface)
{
    m_coverView->shown().setSurface(surface);
    m_pattern->shown().setSurface(surface);
    m_covers->setSurface(surface);
    if (surface && std::exchange(m_fitCover, false)) {
        fitCover({});
        emit coverCame();
    }
}

void VersionPane::fitCover(const Box3& with)
{
    m_coverView->navigation().setStandardView(CoverView::StandardView::ThreeQuarter, with);
}

Box3 VersionPane::box() const
{
    return m_coverView->shown().empty() ? Box3() : m_coverView->shown().scene().box;
}

void VersionPane::showState()
{
    using State = SolverStatus::State;
    const SolverLink& solver = m_followed ? *m_followed : *m_solver;
    const State state = solver.status().state;
    const bool there = m_followed || state == State::Idle ? solver.upToDate() : solver.atRest();
    m_computing->setVisible(state != State::Failed && !there);
    m_computing->adjustSize();
    m_computing->raise();
}

void VersionPane::setFabrics(std::map<ElementId, FabricMapsPtr> fabrics)
{
    m_coverView->shown().setFabricMaps(std::move(fabrics));
}

void VersionPane::showForLooks()
{
    m_title->hide();
    m_views->setSizes({100, 300});
    using Layer = CoverView::Layer;
    for (const Layer layer : {Layer::FixationCurves, Layer::HandleCurves, Layer::FancySeams})
        m_coverView->visibility().setLayerVisible(layer, false);
}

void VersionPane::setFiles(const DesignFiles& files)
{
    m_solver->setFiles(files);
    m_coverView->shown().setFiles(files);
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
