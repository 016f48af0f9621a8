// Mirror twins.
#pragma once

#include <QCoreApplication>
#include <QObject>

namespace bolster {

class Commands;
class Docks;
class Document;
class Selection;
class StatusLine;
struct Edit;

class TwinCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(TwinCommands)

public:
    TwinCommands(Commands& commands, Document& document, Selection& selection, const Docks& docks,
                 StatusLine& status);

private:
    void addLinks(Commands& commands);
    void addPoints(Commands& commands);
    bool canLink() const;
    void make();
    void link();
    void unlink();
    void release();
    void relink();
    void editSymmetry();
    void commit(const Edit& edit, const QString& problem);

    Document& m_document;
    Selection& m_selection;
    const Docks& m_docks;
    StatusLine& m_status;
};

} // namespace bolster
