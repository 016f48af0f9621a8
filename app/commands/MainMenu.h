// The menus of the menu bar. What is in them the tables of the commands say.
#pragma once

namespace bolster {

class Commands;

/// In their order.
void addMainMenus(Commands& commands);

} // namespace bolster
