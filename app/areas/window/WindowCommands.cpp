#include "WindowCommands.h"

#include "Commands.h"
#include "Docks.h"
#include "Inspector.h"
#include "PaneSizes.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>

namespace bolster {

WindowCommands::WindowCommands(Commands& commands, Docks& docks, Inspector& inspector)
    : m_docks(docks)
    , m_inspector(inspector)
{
    for (QDockWidget* dock : docks.all()) {
        const QByteArray name = dock->objectName().toLatin1();
        commands.adopt(*dock->toggleViewAction(), "window.show-" + name, "show-" + name, "window/1");
        QObject::connect(dock->toggleViewAction(), &QAction::triggered, dock, [dock](bool shown) {
            if (shown)
                dock->raise(); // it may lie behind another one
        });
    }
    commands.add({{.id = "window.next-part",
                   .formerly = "next-part-of-the-window",
                   .text = tr("&Next part of the window"),
                   .keys = {Qt::Key_F6},
                   .places = {"window/2"},
                   .does = [this] { focusNextPart(true); }},
                  {.id = "window.previous-part",
                   .formerly = "previous-part-of-the-window",
                   .text = tr("Pre&vious part of the window"),
                   .keys = {Qt::SHIFT | Qt::Key_F6},
                   .places = {"window/2"},
                   .does = [this] { focusNextPart(false); }},
                  {.id = "window.reset-layout",
                   .formerly = "reset-layout",
                   .text = tr("&Reset layout"),
                   .places = {"window/3"},
                   .does = [this] { m_docks.reset(); }}});
}

/// Among the parts that can be seen; of docks on top of each other that is one.
void WindowCommands::focusNextPart(bool forward)
{
    const QWidget* now = QApplication::focusWidget();
    QList<QDockWidget*> parts;
    qsizetype place = -1;
    for (QDockWidget* dock : m_docks.all()) {
        if (!isInFront(*dock))
            continue;
        if (now && dock->isAncestorOf(now))
            place = parts.size();
        parts.append(dock);
    }
    if (parts.isEmpty())
        return;
    const qsizetype count = parts.size();
    const qsizetype next = place < 0 ? (forward ? 0 : count - 1) : (place + (forward ? 1 : count - 1)) % count;
    QDockWidget* dock = parts[next];
    dock->activateWindow(); // it may float
    if (dock == m_docks.inspector)
        m_inspector.focusFirst();
    else
        dock->widget()->setFocus(Qt::ShortcutFocusReason);
}

} // namespace bolster
