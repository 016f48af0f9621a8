#include "InsertCommands.h"

#include "Commands.h"
#include "CommitEdit.h"
#include "DesignSession.h"
#include "Insert.h"
#include "Selection.h"
#include "SolverLink.h"
#include "StatusLine.h"

namespace bolster {

InsertCommands::InsertCommands(Commands& commands, DesignSession& session, Selection& selection, SolverLink& solver,
                               StatusLine& status)
    : m_session(session)
    , m_selection(selection)
    , m_solver(solver)
    , m_status(status)
{
    commands.add({.id = "insert.cushion",
                  .formerly = "cushion",
                  .text = tr("&Cushion"),
                  .icon = "cushion",
                  .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_C},
                  .places = {"insert/1"},
                  .does = [this] { insertCushion(); }});
    const struct {
        Foam::Shape shape;
        const char* id;
        const char* formerly;
        QString text;
        QList<QKeySequence> keys;
    } shapes[] = {
        {Foam::Shape::Box,
         "insert.foam-box",
         "box-of-foam",
         tr("&Box of foam"),
         {Qt::CTRL | Qt::SHIFT | Qt::Key_B}},
        {Foam::Shape::Cylinder, "insert.foam-cylinder", "cylinder-of-foam", tr("C&ylinder of foam"), {}},
        {Foam::Shape::Sphere, "insert.foam-sphere", "sphere-of-foam", tr("&Sphere of foam"), {}},
    };
    for (const auto& row : shapes)
        commands.add({.id = row.id,
                      .formerly = row.formerly,
                      .text = row.text,
                      .icon = "foam",
                      .keys = row.keys,
                      .places = {"insert/1"},
                      .does = [this, shape = row.shape] {
                          Document& document = m_session.document();
                          document.cancelGesture();
                          insertOrTell(document, m_selection, m_status,
                                       insertFoam(document.design(), m_selection.elements(), shape,
                                                  m_solver.surface(), m_session.files()),
                                       tr("Foam belongs to a cushion: insert one first."));
                      }});
}

void InsertCommands::insertCushion()
{
    Document& document = m_session.document();
    document.cancelGesture();
    const Edit edit = bolster::insertCushion(document.design(), m_selection.elements(), m_session.files());
    insertOrTell(document, m_selection, m_status, edit, tr("Cushioning needs a frame: import one first."));
    if (const QString note = voxelNote(edit); !note.isEmpty())
        m_status.flash(note);
}

} // namespace bolster
