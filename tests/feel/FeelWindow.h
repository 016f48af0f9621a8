// The window that gestures are played in: of a fixed size, with the car seat.
#pragma once

#include "FeelApplication.h"
#include "MainWindow.h"

#include <QStandardPaths>
#include <QTemporaryDir>

#include <memory>

namespace bolster {

/// Settings and unsaved work of its own; to be made before the application.
class FeelHome {
public:
    FeelHome();

private:
    QTemporaryDir m_home;
};

/// A shown window with the design and its surface, settled if wished; null if there is none after `mostMs`.
std::unique_ptr<MainWindow> openCarSeat(bool settled, int mostMs);

/// Whether the design is what its history says: the first design with all edits up to now, and undoing them all
/// leads back to the first one.
bool equalsItsReplay(Document& document);

} // namespace bolster
