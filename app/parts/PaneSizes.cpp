#include "PaneSizes.h"

#include <QDataStream>
#include <QDockWidget>
#include <QEvent>
#include <QIODevice>
#include <QMainWindow>
#include <QTabBar>

#include <algorithm>
#include <cmath>

namespace bolster {

bool isInFront(const QDockWidget& dock)
{
    return dock.isVisible() &&
           (dock.isFloating() || dock.parentWidget()->rect().contains(dock.geometry().center()));
}

PaneSizes::PaneSizes(QMainWindow& window, QList<QDockWidget*> docks, QList<QDockWidget*> views)
    : QObject(&window)
    , m_window(window)
    , m_docks(std::move(docks))
    , m_views(std::move(views))
{
    window.installEventFilter(this);
    // When that is over: docks are shown, hidden and moved one after the other.
    const auto take = [this] { QMetaObject::invokeMethod(this, &PaneSizes::take, Qt::QueuedConnection); };
    for (QDockWidget* dock : m_docks) {
        connect(dock, &QDockWidget::dockLocationChanged, this, take);
        connect(dock, &QDockWidget::topLevelChanged, this, take);
        connect(dock, &QDockWidget::visibilityChanged, this, &PaneSizes::takeIfOthersAreShown,
                Qt::QueuedConnection);
    }
}

QSet<QDockWidget*> PaneSizes::shown() const
{
    QSet<QDockWidget*> shown;
    for (QDockWidget* dock : m_docks)
        if (!dock->isHidden() && !dock->isFloating())
            shown.insert(dock);
    return shown;
}

/// With the tabs above it: they belong to what docks are resized to.
QRect PaneSizes::placeOf(QDockWidget* dock) const
{
    QRect place = dock->geometry();
    if (m_window.tabifiedDockWidgets(dock).isEmpty())
        return place;
    for (const QTabBar* bar : m_window.findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
        if (bar->isVisible() && bar->geometry().bottom() + 1 == place.top() && bar->x() <= place.right() &&
            bar->geometry().right() >= place.left())
            place.setTop(bar->y());
    return place;
}

void PaneSizes::takeIfOthersAreShown()
{
    if (m_window.isVisible() && shown() != m_shown)
        take();
}

void PaneSizes::take()
{
    if (!m_window.isVisible() || m_window.isMinimized())
        return;
    m_room = m_window.size();
    m_shown = shown();
    m_wanted.clear();
    for (QDockWidget* dock : m_shown)
        if (isInFront(*dock))
            m_wanted[dock] = placeOf(dock);
}

/// Views that stand side by side share what the window is wider or narrower now.
int PaneSizes::wantedWidth(QDockWidget* dock) const
{
    const QRect wanted = m_wanted[dock];
    if (!m_views.contains(dock))
        return wanted.width();
    int row = 0;
    for (QDockWidget* view : m_views)
        if (const QRect other = m_wanted.value(view);
            other.isValid() && other.top() <= wanted.bottom() && other.bottom() >= wanted.top())
            row += other.width();
    const double more = m_window.width() - m_room.width();
    return std::max(1, static_cast<int>(std::lround(wanted.width() * (1 + more / row))));
}

void PaneSizes::apply()
{
    if (m_applying || m_wanted.isEmpty() || !m_room.isValid() || !m_window.isVisible() || m_window.isMinimized())
        return;
    if (shown() != m_shown) {
        take();
        return;
    }
    QList<QDockWidget*> docks;
    QList<int> widths, heights;
    bool asWanted = true;
    for (auto wanted = m_wanted.cbegin(); wanted != m_wanted.cend(); ++wanted) {
        QDockWidget* dock = wanted.key();
        if (dock->isHidden() || dock->isFloating() || !isInFront(*dock))
            continue;
        docks.append(dock);
        widths.append(wantedWidth(dock));
        heights.append(std::max(
            1, static_cast<int>(std::lround(wanted->height() * double(m_window.height()) / m_room.height()))));
        asWanted = asWanted && placeOf(dock).size() == QSize(widths.back(), heights.back());
    }
    m_least = leastSizes();
    if (asWanted)
        return;
    m_applying = true;
    m_window.resizeDocks(docks, widths, Qt::Horizontal);
    m_window.resizeDocks(docks, heights, Qt::Vertical);
    m_applying = false;
}

QList<QSize> PaneSizes::leastSizes() const
{
    QList<QSize> least;
    for (const QDockWidget* dock : m_docks)
        least.append(dock->minimumSizeHint().expandedTo(dock->minimumSize()));
    return least;
}

/// Not whenever the docks are laid out: that happens when they get sizes, too, and where there is no room for what
/// is wanted it would never end.
void PaneSizes::applyIfLeastSizesChanged()
{
    if (leastSizes() != m_least)
        apply();
}

QByteArray PaneSizes::save() const
{
    QByteArray saved;
    QDataStream out(&saved, QIODevice::WriteOnly);
    QHash<QString, QRect> places;
    for (auto wanted = m_wanted.cbegin(); wanted != m_wanted.cend(); ++wanted)
        places[wanted.key()->objectName()] = *wanted;
    out << m_room << places;
    return saved;
}

void PaneSizes::restore(const QByteArray& saved)
{
    QSize room;
    QHash<QString, QRect> places;
    QDataStream in(saved);
    in >> room >> places;
    m_wanted.clear();
    m_shown = shown();
    for (QDockWidget* dock : m_shown)
        if (const QRect place = places.value(dock->objectName()); place.isValid())
            m_wanted[dock] = place;
    m_room = room;
    if (in.status() != QDataStream::Ok || !room.isValid() || m_wanted.isEmpty())
        take();
    else
        apply();
}

bool PaneSizes::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == &m_window && event->type() == QEvent::Resize)
        apply();
    else if (watched == &m_window && event->type() == QEvent::LayoutRequest)
        QMetaObject::invokeMethod(this, &PaneSizes::applyIfLeastSizesChanged, Qt::QueuedConnection);
    else if (watched == &m_window && event->type() == QEvent::MouseButtonRelease) // of a border between docks
        QMetaObject::invokeMethod(this, &PaneSizes::take, Qt::QueuedConnection);
    return QObject::eventFilter(watched, event);
}

} // namespace bolster
