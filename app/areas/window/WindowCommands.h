// The Window menu: its parts, and how the keyboard goes from one to the next.
#pragma once

#include <QCoreApplication>
#include <QObject>

namespace bolster {

class Commands;
class Docks;
class Inspector;

class WindowCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(WindowCommands)

public:
    WindowCommands(Commands& commands, Docks& docks, Inspector& inspector);

private:
    void focusNextPart(bool forward);

    Docks& m_docks;
    Inspector& m_inspector;
};

} // namespace bolster
