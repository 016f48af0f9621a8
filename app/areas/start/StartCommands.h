// The start page, and what stands around a program's start: other windows, and what is new.
#pragma once

#include <QCoreApplication>
#include <QObject>

#include <functional>

class QWidget;

namespace bolster {

class Banner;
class Commands;
class CoverView;
class DesignSession;
class PatternView;
class StartPage;
struct FileFlows;

class StartCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(StartCommands)

public:
    struct Parts {
        StartPage& page;
        DesignSession& session;
        FileFlows& files;
        PatternView& pattern;
        CoverView& coverView;
        Banner& banner;
        QWidget& window;
    };

    StartCommands(Commands& commands, const Parts& parts);

    /// At the start of the program, with nothing to open.
    void greet();

private:
    void addCommands(Commands& commands);
    void connectPage(Commands& commands);
    void closeWhenBegun();
    void openPage();
    void sayWhatIsNew();
    bool untouched() const;
    void begin(const std::function<void()>& what);
    void sayWhatIsNext();

    Parts m_parts;
    Commands& m_commands;
    bool m_begunWithFrame = false; ///< the start page has asked for one
};

} // namespace bolster
