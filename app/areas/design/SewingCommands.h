// The Seam menu, and the same in the list of seams.
#pragma once

#include "ElementId.h"
#include "Seam.h"

#include <QCoreApplication>
#include <QObject>
#include <QPointer>

#include <functional>
#include <vector>

class QTreeView;

namespace bolster {

class Commands;
class Design;
class Docks;
class Document;
struct Edit;
class SeamProposalsWindow;
class Selection;

class SewingCommands : public QObject {
    Q_OBJECT

public:
    SewingCommands(Commands& commands, Document& document, Selection& selection, const Docks& docks);

    /// The menu of the right button.
    static void fillTable(QTreeView& table, Commands& commands);

signals:
    /// What has been selected shall be seen in the pattern.
    void selectionToShow();

private:
    using Seams = std::vector<ElementId>;

    void addSides(Commands& commands);
    void addContinuities(Commands& commands);
    void addMatches(Commands& commands);
    void addOrder(Commands& commands);
    void propose(QWidget* window);
    Seams seams() const;
    bool all(const std::function<bool(const Seam&)>& has) const;
    /// A command that edits the selected seams.
    std::function<void()> editing(std::function<Edit(const Design&, const Seams&)> edit);

    Document& m_document;
    Selection& m_selection;
    QPointer<SeamProposalsWindow> m_proposals; ///< while it is open
};

} // namespace bolster
