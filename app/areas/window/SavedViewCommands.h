// The views that the user has saved under names.
#pragma once

#include <QCoreApplication>
#include <QObject>

class QAction;
class QMenu;
class QWidget;

namespace bolster {

class Commands;
class StatusLine;
class CoverView;

class SavedViewCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(SavedViewCommands)

public:
    SavedViewCommands(Commands& commands, CoverView& coverView, StatusLine& status, QWidget& window);

private:
    void fill(QMenu& menu, QAction* save);
    void save();

    CoverView& m_coverView;
    StatusLine& m_status;
    QWidget& m_window;
};

} // namespace bolster
