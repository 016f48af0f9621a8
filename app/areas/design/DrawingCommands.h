// Helps for drawing: snapping, rulers, guides, and a picture to trace.
#pragma once

#include <QCoreApplication>
#include <QObject>

class QWidget;

namespace bolster {

class Commands;
class PatternView;
class StatusLine;

class DrawingCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(DrawingCommands)

public:
    DrawingCommands(Commands& commands, PatternView& pattern, StatusLine& status, QWidget& window);

private:
    void addHelps();
    void addPicture();
    void addOpacities();
    void openPicture();
    void trace(const QString& path);
    void showPicture(bool shown);
    void removePicture();

    Commands& m_commands;
    PatternView& m_pattern;
    StatusLine& m_status;
    QWidget& m_window;
};

} // namespace bolster
