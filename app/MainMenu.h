// The menu bar.
#pragma once

class QMainWindow;

namespace bolster {

class Actions;
class Docks;
class FileFlow;

/// Every action is in a menu.
void buildMenus(QMainWindow& window, Actions& actions, FileFlow& files, Docks& docks);

} // namespace bolster
