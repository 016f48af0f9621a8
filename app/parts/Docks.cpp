#include "Docks.h"

#include "DockTitle.h"
#include "PaneSizes.h"

#include <QApplication>
#include <QMainWindow>
#include <QPointer>

namespace bolster {

namespace {

QDockWidget* newDock(QMainWindow& window, const QString& name, const QString& title, QWidget* part)
{
    auto* dock = new QDockWidget(title, &window);
    dock->setObjectName(name); // under which the arrangement is kept
    dock->setTitleBarWidget(new DockTitle(dock));
    dock->setWidget(part);
    if (part->accessibleName().isEmpty())
        part->setAccessibleName(title);
    return dock;
}

} // namespace

Docks::Docks(QMainWindow& window, const Parts& parts)
    : pattern(newDock(window, QStringLiteral("pattern"), QCoreApplication::translate("Docks", "Pattern"),
                      parts.pattern))
    , cover(newDock(window, QStringLiteral("cover"), QCoreApplication::translate("Docks", "Cover"), parts.cover))
    , elements(newDock(window, QStringLiteral("elements"), QCoreApplication::translate("Docks", "Elements"),
                       parts.elements))
    , history(newDock(window, QStringLiteral("history"), QCoreApplication::translate("Docks", "History"),
                      parts.history))
    , inspector(newDock(window, QStringLiteral("inspector"), QCoreApplication::translate("Docks", "Properties"),
                        parts.inspector))
    , problems(newDock(window, QStringLiteral("problems"), QCoreApplication::translate("Docks", "Problems"),
                       parts.problems))
    , seams(newDock(window, QStringLiteral("seams"), QCoreApplication::translate("Docks", "Seams"), parts.seams))
    , fabrics(newDock(window, QStringLiteral("fabrics"), QCoreApplication::translate("Docks", "Fabrics"),
                      parts.fabrics))
    , spots(newDock(window, QStringLiteral("spots"), QCoreApplication::translate("Docks", "Worst spots"),
                    parts.spots))
    , cutting(newDock(window, QStringLiteral("cutting"),
                      QCoreApplication::translate("Docks", "Check before cutting"), parts.cutting))
    , jobs(newDock(window, QStringLiteral("jobs"), QCoreApplication::translate("Docks", "Jobs"), parts.jobs))
    , m_window(window)
    , m_sizes(new PaneSizes(window, all(), {pattern, cover}))
{
    window.setDockNestingEnabled(true);
    window.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    reset();
}

void Docks::reset()
{
    const QPointer<QWidget> worker = QApplication::focusWidget(); // loses the focus when its dock goes away
    for (QDockWidget* dock : all()) {
        dock->setFloating(false);
        m_window.removeDockWidget(dock);
    }
    m_window.addDockWidget(Qt::LeftDockWidgetArea, pattern);
    m_window.splitDockWidget(pattern, cover, Qt::Horizontal);
    m_window.splitDockWidget(cover, elements, Qt::Horizontal);
    m_window.splitDockWidget(elements, inspector, Qt::Vertical);
    m_window.splitDockWidget(elements, spots, Qt::Vertical);
    m_window.tabifyDockWidget(elements, history);
    m_window.tabifyDockWidget(history, seams);
    m_window.tabifyDockWidget(seams, fabrics);
    m_window.tabifyDockWidget(fabrics, jobs);
    m_window.splitDockWidget(pattern, problems, Qt::Vertical);
    m_window.tabifyDockWidget(problems, cutting);
    for (QDockWidget* dock : all())
        dock->setVisible(dock != problems && dock != spots && dock != cutting && dock != jobs);
    elements->raise();
    m_window.resizeDocks({pattern, cover, elements}, {540, 560, 280}, Qt::Horizontal);
    m_window.resizeDocks({elements, inspector}, {460, 340}, Qt::Vertical);
    m_sizes->take();
    if (worker && worker->isVisible())
        worker->setFocus();
}

QByteArray Docks::saveSizes() const
{
    return m_sizes->save();
}

void Docks::restoreSizes(const QByteArray& saved)
{
    m_sizes->restore(saved);
}

void Docks::reveal(QDockWidget* dock)
{
    dock->show();
    dock->raise();
}

} // namespace bolster
