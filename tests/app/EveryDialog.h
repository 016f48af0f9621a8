// Every window that a command opens, one after the other, to be looked at.
#pragma once

#include "MainWindow.h"

#include <QWidget>

#include <functional>

namespace bolster::test {

/// `look` gets each window when it is laid out, and the id of its command; afterwards it is closed. Those that
/// choose files are the system's and left out. A command whose window does not come is a failure.
void lookAtDialogs(MainWindow& window, const std::function<void(QWidget&, const QString& id)>& look);

/// What is shown in less room than its text needs: "Find … (QPushButton, 80 of 96 pixels)".
QStringList clippedTexts(const QWidget& window);

/// Controls that the keyboard reaches, and whose name or role nobody is told who does not see them.
QStringList namelessControls(const QWidget& window);

} // namespace bolster::test
