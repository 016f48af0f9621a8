#include "ManualCommands.h"

#include "Ask.h"
#include "Commands.h"
#include "CoverView.h"
#include "Inspector.h"
#include "ManualWindow.h"
#include "PatternView.h"
#include "ProblemsView.h"
#include "Samples.h"
#include "StatusLine.h"

#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QFileDialog>
#include <QKeyEvent>
#include <QMenu>
#include <QTabBar>

namespace bolster {

ManualCommands::ManualCommands(Commands& commands, QWidget& window, std::function<QString()> subject)
    : m_commands(commands)
    , m_window(window)
    , m_subject(std::move(subject))
    , m_folder(shippedFolder("manual"))
    , m_places(m_folder)
{
    commands.add({.id = "help.manual",
                  .text = tr("&Manual"),
                  .keys = {Qt::Key_F1},
                  .tip = tr("The page about what you are at"),
                  .places = {"help/1"},
                  .does = [this] { open(placeNow()); }});
    qApp->installEventFilter(this);
}

/// Keys of the main window's commands reach neither dialogs nor menus.
bool ManualCommands::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::KeyPress || static_cast<QKeyEvent*>(event)->key() != Qt::Key_F1 ||
        static_cast<QKeyEvent*>(event)->modifiers() != Qt::NoModifier || !watched->isWidgetType())
        return false;
    if (qobject_cast<QMenu*>(QApplication::activePopupWidget())) {
        const QString place = placeOfMenu();
        while (QWidget* menu = QApplication::activePopupWidget()) // it would lie over the manual
            if (!menu->close())
                break;
        open(place);
        return true;
    }
    const QWidget* active = QApplication::activeWindow();
    if (!active || active == &m_window || qobject_cast<const ManualWindow*>(active))
        return false;
    open(placeNow());
    return true;
}

/// Of the entry that is lit in the menu that was opened last; a menu that only leads there counts if that has none.
QString ManualCommands::placeOfMenu() const
{
    for (const QWidget* part = QApplication::activePopupWidget(); part; part = part->parentWidget())
        if (const auto* menu = qobject_cast<const QMenu*>(part); menu && menu->isVisible() && menu->activeAction())
            if (const QString place = m_places.ofCommand(menu->activeAction()->objectName()); !place.isEmpty())
                return place;
    return placeNow();
}

/// Its tools stay chosen while one is in the 3D view, where these two alone do something.
bool ManualCommands::isOfPatternAlone(const QString& tool)
{
    return tool != QLatin1String("tool.draw-fixation") && tool != QLatin1String("tool.measure");
}

QString ManualCommands::placeNow() const
{
    const QWidget* focus = QApplication::focusWidget();
    if (qobject_cast<QFileDialog*>(QApplication::activeWindow()))
        if (const QString place = m_places.ofCommand(m_commands.last()); !place.isEmpty())
            return place;
    // Nobody types into the state line: who points at its sentence asks for that.
    const QWidget* pointedAt = QApplication::widgetAt(QCursor::pos());
    const auto* line = m_window.findChild<StatusLine*>();
    if (line && line->isActiveWindow())
        if ((focus && line->isAncestorOf(focus)) || (pointedAt && line->isAncestorOf(pointedAt))) {
            const QString place = m_places.ofMessage(line->solverKey());
            return place.isEmpty() ? m_places.ofWidget(line) : place;
        }
    // A click on a tab leaves the keyboard where it was.
    if (const auto* tabs = qobject_cast<const QTabBar*>(pointedAt))
        for (const auto* dock : m_window.findChildren<QDockWidget*>())
            if (dock->windowTitle() == tabs->tabText(tabs->tabAt(tabs->mapFromGlobal(QCursor::pos()))))
                if (const QString place = m_places.ofWidget(dock->widget()); !place.isEmpty())
                    return place;
    if (const auto* problems = qobject_cast<const ProblemsView*>(focus))
        if (const QString place = m_places.ofMessage(problems->currentKey()); !place.isEmpty())
            return place;
    const bool inCover = qobject_cast<const CoverView*>(focus);
    if (inCover || qobject_cast<const PatternView*>(focus))
        for (const QAction* tool : m_commands.startingWith("tool."))
            if (tool->isChecked() && !(inCover && isOfPatternAlone(tool->objectName())))
                if (const QString place = m_places.ofCommand(tool->objectName()); !place.isEmpty())
                    return place;
    for (const QWidget* part = focus; part; part = part->parentWidget())
        for (const QString& name : {part->objectName(), qobject_cast<const Inspector*>(part) ? m_subject() : ""})
            if (const QString place = m_places.ofCommand(name); !place.isEmpty())
                return place; // of a field, or of what is selected
    const QString place = m_places.ofWidget(focus ? focus : QApplication::activeWindow());
    return place.isEmpty() ? ManualPlaces::first() : place;
}

void ManualCommands::openMessage(const QString& key)
{
    const QString place = m_places.ofMessage(key);
    open(place.isEmpty() ? placeNow() : place);
}

void ManualCommands::open(const QString& place)
{
    if (m_folder.isEmpty()) {
        tell(&m_window, QMessageBox::Warning, tr("The manual is not installed."),
             tr("It is a folder \"manual\" with the program's other files."));
        return;
    }
    QWidget* above = QApplication::activeModalWidget(); // else the manual could not be clicked
    QWidget* parent = above ? above : &m_window;
    if (m_manual && m_manual->parentWidget() != parent)
        m_manual->close();
    if (!m_manual || m_manual->parentWidget() != parent) {
        m_manual = new ManualWindow(m_folder, parent);
        const QWidget* focus = QApplication::focusWidget();
        m_manual->standBeside(focus ? focus->mapToGlobal(focus->rect().center()) : QCursor::pos());
    }
    m_manual->openAt(place);
    m_manual->QWidget::show();
    m_manual->raise();
    m_manual->activateWindow();
}

} // namespace bolster
