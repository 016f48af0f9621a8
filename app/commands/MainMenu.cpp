#include "MainMenu.h"

#include "Commands.h"

#include <QCoreApplication>

namespace bolster {

namespace {

struct MainMenu {
    Q_DECLARE_TR_FUNCTIONS(MainMenu)
};

} // namespace

void addMainMenus(Commands& commands)
{
    const std::pair<const char*, QString> menus[] = {
        {"file", MainMenu::tr("&File")},       {"edit", MainMenu::tr("&Edit")},
        {"view", MainMenu::tr("&View")},       {"insert", MainMenu::tr("&Insert")},
        {"pattern", MainMenu::tr("&Pattern")}, {"seam", MainMenu::tr("Sea&m")},
        {"fabric", MainMenu::tr("F&abric")},   {"frame", MainMenu::tr("F&rame")},
        {"scan", MainMenu::tr("S&can")},       {"surface", MainMenu::tr("&Surface")},
        {"window", MainMenu::tr("&Window")},   {"help", MainMenu::tr("&Help")},
    };
    for (const auto& [id, title] : menus)
        commands.add(MenuPlace{id, title});
}

} // namespace bolster
