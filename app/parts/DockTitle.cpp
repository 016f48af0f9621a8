#include "DockTitle.h"

#include "Icons.h"
#include "ViewColors.h"

#include <QApplication>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QPainter>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace bolster {

namespace {

constexpr int lineWidth = 2; // pixels: below the title, or below the tabs, of the part that has the keyboard

} // namespace

DockTitle::DockTitle(QDockWidget* dock)
    : QWidget(dock)
    , m_dock(dock)
    , m_label(new QLabel(dock->windowTitle(), this))
{
    QFont font = m_label->font();
    font.setWeight(QFont::DemiBold);
    m_label->setFont(font);

    const auto button = [this](const QString& name, const QString& tip) {
        auto* result = new QToolButton(this);
        result->setIcon(icon(name));
        result->setIconSize({12, 12});
        result->setAutoRaise(true);
        result->setToolTip(tip);
        result->setAccessibleName(tip);
        result->setFocusPolicy(Qt::NoFocus);
        return result;
    };
    QToolButton* floating = button(QStringLiteral("float"), tr("Take out of the window, or put back"));
    QToolButton* close = button(QStringLiteral("close"), tr("Close; the Window menu brings it back"));
    connect(floating, &QToolButton::clicked, dock, [dock] { dock->setFloating(!dock->isFloating()); });
    connect(close, &QToolButton::clicked, dock, &QWidget::close);
    connect(dock, &QWidget::windowTitleChanged, m_label, &QLabel::setText);
    // When that is over: while docks are restored they are told before they have tabs.
    connect(dock, &QDockWidget::visibilityChanged, this, &DockTitle::updateAll, Qt::QueuedConnection);
    connect(dock, &QDockWidget::topLevelChanged, this, &DockTitle::updateAll, Qt::QueuedConnection);
    connect(dock, &QDockWidget::dockLocationChanged, this, &DockTitle::updateAll, Qt::QueuedConnection);

    connect(qApp, &QApplication::focusChanged, this, [this](const QWidget*, const QWidget* now) {
        if (now && std::exchange(m_active, m_dock->isAncestorOf(now)) != m_dock->isAncestorOf(now))
            update();
    });

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 3, 4, 3);
    layout->setSpacing(0);
    layout->addWidget(m_label, 1);
    layout->addWidget(floating);
    layout->addWidget(close);
}

/// Others get or lose their tab with this dock.
void DockTitle::updateAll()
{
    for (DockTitle* title : m_dock->parentWidget()->findChildren<DockTitle*>())
        title->updateTabbed();
}

/// A dock whose neighbours are all closed has no tab.
bool DockTitle::hasTab() const
{
    const auto* window = qobject_cast<QMainWindow*>(m_dock->parentWidget());
    if (!window || m_dock->isFloating())
        return false;
    const QList<QDockWidget*> others = window->tabifiedDockWidgets(m_dock);
    return std::ranges::any_of(others, [](const QDockWidget* other) { return !other->isHidden(); });
}

void DockTitle::updateTabbed()
{
    const bool tabbed = hasTab();
    if (tabbed == m_tabbed)
        return;
    m_tabbed = tabbed;
    for (QWidget* child : findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
        child->setVisible(!tabbed);
    updateGeometry();
    if (QLayout* outer = m_dock->layout())
        outer->invalidate();
}

QSize DockTitle::sizeHint() const
{
    return m_tabbed ? QSize(0, lineWidth) : QWidget::sizeHint();
}

QSize DockTitle::minimumSizeHint() const
{
    return m_tabbed ? QSize(0, lineWidth) : QWidget::minimumSizeHint();
}

void DockTitle::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    if (m_active)
        painter.fillRect(QRect(0, height() - lineWidth, width(), lineWidth), palette().color(QPalette::Highlight));
    if (m_tabbed || m_active)
        return;
    const QColor line = mixed(palette().color(QPalette::Window), palette().color(QPalette::Text), 0.13);
    painter.setPen(line);
    painter.drawLine(rect().bottomLeft(), rect().bottomRight());
}

} // namespace bolster
