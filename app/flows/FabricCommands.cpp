#include "FabricCommands.h"

#include "Ask.h"
#include "ColourwayEdits.h"
#include "ElementEdits.h"
#include "ElementText.h"
#include "SelectionEdits.h"
#include "Translated.h"

#include <QDir>
#include <QFileInfo>

namespace bolster {

FabricCommands::FabricCommands(DesignSession& session, Selection& selection, QWidget* window)
    : QObject(window)
    , m_session(session)
    , m_selection(selection)
    , m_window(window)
{
    connect(&session, &DesignSession::opened, this, [this] { m_chosen = noElement; });
}

ElementId FabricCommands::fabric() const
{
    const std::vector<ElementId> selected = selectedOf<Fabric>(design(), m_selection.elements());
    if (selected.size() == 1)
        return selected.front();
    return design().find<Fabric>(m_chosen) ? m_chosen : noElement;
}

bool FabricCommands::commit(const Edit& edit)
{
    if (edit.empty())
        return false;
    m_session.document().cancelGesture();
    m_session.document().commit(edit);
    return true;
}

void FabricCommands::fail(const QString& title, const Message& why)
{
    tell(m_window, QMessageBox::Warning, title, translated(why))->setObjectName(QString::fromStdString(why.key));
}

void FabricCommands::add(const Fabric& fabric)
{
    const ElementId id = design().nextId();
    if (commit(edits::addFabric(design(), fabric)))
        emit added(id);
}

void FabricCommands::duplicate()
{
    if (const Fabric* found = design().find<Fabric>(fabric()))
        add(*found);
}

void FabricCommands::rename()
{
    if (const ElementId id = fabric(); design().find<Fabric>(id))
        askName(id, tr("Rename fabric"));
}

void FabricCommands::askName(ElementId id, const QString& title)
{
    askForText(m_window, title, tr("Name:"), displayName(design(), id),
               [this, id](const QString& name) { commit(edits::renameElement(design(), id, name.toStdString())); });
}

void FabricCommands::remove()
{
    const ElementId id = fabric();
    if (!design().find<Fabric>(id))
        return;
    const auto uses = static_cast<int>(edits::patchesWith(design(), id).size());
    std::vector<ElementId> others;
    QStringList names;
    design().each<Fabric>([&](ElementId other, const Fabric&) {
        if (other == id)
            return;
        others.push_back(other);
        names << displayName(design(), other);
    });
    if (uses == 0) {
        commit(edits::removeFabric(design(), id, noElement));
        return;
    }
    if (others.empty()) {
        tell(m_window, QMessageBox::Information, tr("\"%1\" is not deleted.").arg(displayName(design(), id)),
             tr("It is the only fabric, and patches are made of it. Add another one first."));
        return;
    }
    askForOneOf(
        m_window, tr("Delete fabric"),
        tr("%n patches have \"%1\". What shall they get instead?", nullptr, uses).arg(displayName(design(), id)),
        names, [this, id, others, names](const QString& chosen) {
            if (const qsizetype place = names.indexOf(chosen); place >= 0)
                commit(edits::removeFabric(design(), id, others[static_cast<std::size_t>(place)]));
        });
}

void FabricCommands::assign(const std::vector<ElementId>& patches, ElementId fabric)
{
    const Edit edit = edits::giveFabric(design(), patches, fabric);
    if (commit(edit))
        emit done(translated(edit.verb));
}

void FabricCommands::assignToSelection()
{
    const std::vector<ElementId> patches = selectedOf<Patch>(design(), m_selection.elements());
    if (patches.empty())
        emit done(tr("Select the patches that shall get the fabric, then choose it in the library."));
    else
        assign(patches, fabric());
}

void FabricCommands::newColourway()
{
    askForText(m_window, tr("New colourway"), tr("Name of the colourway; it begins as what is shown now:"),
               tr("Colourway"),
               [this](const QString& name) { commit(edits::addColourway(design(), name.toStdString())); });
}

void FabricCommands::renameColourway()
{
    if (const ElementId shown = design().settings().colourway; design().find<Colourway>(shown))
        askName(shown, tr("Rename colourway"));
}

void FabricCommands::removeColourway()
{
    const ElementId shown[] = {design().settings().colourway};
    if (design().find<Colourway>(shown[0]))
        commit(edits::removeElements(design(), shown));
}

void FabricCommands::showColourway(ElementId colourway)
{
    if (colourway != design().settings().colourway)
        commit(edits::showColourway(design(), colourway));
}

} // namespace bolster
