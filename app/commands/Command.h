// One thing that the user can ask for.
#pragma once

#include <QKeySequence>
#include <QList>
#include <QString>

#include <functional>
#include <optional>

class QMenu;

namespace bolster {

/// A row in the table of an area; what is left out is not there. A place in a menu is its id and a group, "seam/2":
/// groups are divided by lines, within them the order of the tables counts.
struct Command {
    const char* id = "";       ///< for good, whatever the text becomes: the user's keys are kept under it
    const char* formerly = ""; ///< its id in the settings until commands had ids of their own
    QString text = {};
    const char* icon = "";
    QList<QKeySequence> keys = {};
    QString tip = {};               ///< in place of the text; the keys are added
    QList<const char*> places = {}; ///< in menus
    int bar = 0;                    ///< order in the tool bar, 0: not there; each hundred is a group

    std::optional<bool> on = {}; ///< a toggle: whether it is on at first
    const char* group = "";      ///< of toggles of which one is on
    bool orNone = false;         ///< or none of its group

    std::function<bool()> enabled = {};
    std::function<bool()> visible = {};
    std::function<bool()> checked = {};    ///< a toggle that shows what others decide
    std::function<QString()> textNow = {}; ///< the text when it depends on what there is to do
    std::function<void()> does = {};
    std::function<void(bool on)> toggled = {};
};

/// A menu, in the menu bar or at a place in another menu.
struct MenuPlace {
    const char* id = "";
    QString title = {};
    const char* place = "";                ///< empty: in the menu bar
    std::function<void(QMenu&)> fill = {}; ///< each time it opens
};

} // namespace bolster
