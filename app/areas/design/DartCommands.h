// What the menus do with darts.
#pragma once

#include <QCoreApplication>
#include <QObject>

namespace bolster {

class Commands;
class Document;
class PatternView;
class Selection;
class StatusLine;

class DartCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(DartCommands)

public:
    DartCommands(Commands& commands, Document& document, Selection& selection, PatternView& pattern,
                 StatusLine& status);

private:
    bool isSelected() const;
    void close();

    Document& m_document;
    Selection& m_selection;
    PatternView& m_pattern;
    StatusLine& m_status;
};

} // namespace bolster
