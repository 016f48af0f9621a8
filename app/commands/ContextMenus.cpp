#include "ContextMenus.h"

#include "Commands.h"
#include "Document.h"
#include "FrameEdits.h"
#include "Selection.h"
#include "SelectionEdits.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QKeySequence>
#include <QMenu>

#include <algorithm>

namespace bolster {

namespace {

/// Fills a menu group by group with what can be done now.
class ContextMenuFiller {
    Q_DECLARE_TR_FUNCTIONS(ContextMenus)

public:
    ContextMenuFiller(QMenu& menu, const Design& design, const Selection& selection, Commands& commands)
        : m_menu(menu)
        , m_design(design)
        , m_selection(selection)
        , m_commands(commands)
    {}

    void selectionInPattern()
    {
        points();
        edges();
        sewing();
        if (m_selection.points().empty())
            patches();
        rest();
    }

    void selectionInSpace()
    {
        points();
        sewing();
        if (has<Patch>()) {
            fabric();
            group({"edit.cut", "edit.copy", "edit.duplicate"});
        }
        hiding();
        rest();
    }

    /// Of elements, whichever view shows them.
    void selectionInList()
    {
        sewing();
        has<Patch>() ? patches() : hiding();
        rest();
    }

    void pattern()
    {
        group({"tool.outline", "tool.rectangle", "tool.ellipse", "tool.sew"});
        group({"edit.paste", "layout.arrange"});
        group({"edit.select-all", "view.fit-all"});
        submenu(tr("&Show"), {"layer.grid", "layer.labels", "layer.seams", "layer.points", "layer.mesh",
                              "draw.rulers", "draw.guides"});
        group({"draw.snapping"});
    }

    void space()
    {
        group({"tool.draw-fixation"});
        group({"file.import-frame", "insert.cushion"});
        group({"view.fit-all", "view.perspective", "view.section"});
        submenu(tr("&Look from"), m_commands.startingWith("view.from-"));
        submenu(tr("&Show"), {"layer.frames", "layer.curves", "layer.seams", "layer.mesh", "layer.checker",
                              "layer.scans", "layer.ground"});
        submenu(tr("&Map"), m_commands.list({"map.strain", "map.along", "map.across", "map.shear", "map.curvature",
                                             "map.thickness", "map.deviation"}));
        group({"view.show-hidden"});
    }

private:
    template <class T>
    bool has() const
    {
        return !selectedOf<T>(m_design, m_selection.elements()).empty();
    }

    void group(const QList<QAction*>& actions)
    {
        m_menu.addSeparator();
        for (QAction* action : actions)
            if (action->isEnabled() && !m_menu.actions().contains(action))
                m_menu.addAction(action);
    }

    void group(std::initializer_list<const char*> ids) { group(m_commands.list(ids)); }
    void submenu(const QString& title, std::initializer_list<const char*> ids)
    {
        submenu(title, m_commands.list(ids));
    }

    void submenu(const QString& title, const QList<QAction*>& actions)
    {
        const auto possible = [](const QAction* action) { return action->isEnabled(); };
        if (std::ranges::none_of(actions, possible))
            return;
        QMenu* menu = m_menu.addMenu(title);
        for (QAction* action : actions)
            if (possible(action))
                menu->addAction(action);
    }

    void points()
    {
        if (m_selection.points().empty())
            return;
        group({"shape.make-corner", "shape.make-smooth", "shape.straighten"});
        group({"fixation.create"});
        group({"twin.release-points", "twin.relink-points"});
    }

    void edges()
    {
        if (m_selection.edges().empty())
            return;
        group({"shape.edge-length", "shape.equal-lengths"});
        group({"fixation.create"});
    }

    void sewing()
    {
        if (has<Seam>()) {
            group({"seam.flip", "seam.swap-sides", "shape.equal-lengths", "shape.common-tangents"});
            group({"dart.close", "dart.rotate"});
            submenu(tr("&Continuity"), m_commands.startingWith("seam.continuity-"));
            submenu(tr("&Match"), m_commands.startingWith("seam.match-"));
            group({"shape.merge-patches", "seam.list"});
        }
        if (has<FixationCurve>())
            group({"tool.attach"});
    }

    void patches()
    {
        if (!has<Patch>())
            return;
        fabric();
        group({"edit.cut", "edit.copy", "edit.paste", "edit.duplicate"});
        submenu(tr("&Arrange"), m_commands.startingWith("layout."));
        group({"shape.merge-patches"});
        hiding();
    }

    void fabric() { group({"fabric.assign", "fabric.edit"}); }
    void hiding() { group({"view.hide", "view.isolate", "view.show-hidden"}); }

    /// What is no matter of patches, and what can be done with anything.
    void rest()
    {
        group({"twin.make", "twin.link", "twin.unlink"});
        if (has<Frame>())
            group({"insert.cushion"});
        if (has<Cushion>())
            group(m_commands.startingWith("insert.foam-"));
        group({"edit.rename", "view.fit-selection"});
        const auto ofPatch = [](const Selection::Edge& edge) { return edge.owner == edge.stretch.patch; };
        if (std::ranges::none_of(m_selection.edges(), ofPatch))
            group({"edit.delete"});
    }

    QMenu& m_menu;
    const Design& m_design;
    const Selection& m_selection;
    Commands& m_commands;
};

} // namespace

ContextMenus::ContextMenus(Document& document, Selection& selection, Commands& commands, QWidget* window)
    : QObject(window)
    , m_document(document)
    , m_selection(selection)
    , m_commands(commands)
    , m_window(window)
{}

QMenu* ContextMenus::begin()
{
    auto* menu = new QMenu(m_window);
    menu->setObjectName(QStringLiteral("context-menu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    return menu;
}

void ContextMenus::finish(QMenu& menu, const QPoint& global)
{
    if (menu.isEmpty())
        menu.deleteLater();
    else
        menu.popup(global);
}

void ContextMenus::showInPattern(const QPoint& global, bool onSomething)
{
    QMenu* menu = begin();
    ContextMenuFiller filler(*menu, m_document.design(), m_selection, m_commands);
    onSomething ? filler.selectionInPattern() : filler.pattern();
    finish(*menu, global);
}

void ContextMenus::addHiding(QMenu& menu, const PieceOfFrame& piece)
{
    QAction* hide = menu.addAction(tr("Leave this &piece out"));
    hide->setObjectName(QStringLiteral("hide-frame-piece"));
    hide->setToolTip(tr("Hides this piece of the frame from the view, drawing, cushioning and contact; the frame's "
                        "properties bring it back"));
    connect(hide, &QAction::triggered, this, [this, piece] {
        m_document.commit(
            edits::showFramePieces(m_document.design(), piece.frame, piece.mesh, {piece.piece}, false));
    });
    menu.addSeparator();
}

void ContextMenus::showInSurface(const QPoint& global, bool onSomething, const std::optional<PieceOfFrame>& piece)
{
    QMenu* menu = begin();
    if (piece)
        addHiding(*menu, *piece);
    ContextMenuFiller filler(*menu, m_document.design(), m_selection, m_commands);
    onSomething ? filler.selectionInSpace() : filler.space();
    finish(*menu, global);
}

void ContextMenus::showInList(const QPoint& global)
{
    QMenu* menu = begin();
    ContextMenuFiller(*menu, m_document.design(), m_selection, m_commands).selectionInList();
    finish(*menu, global);
}

void ContextMenus::showForTool(QWidget& view, const QPoint& global, const ToolKeys& keys)
{
    QMenu* menu = begin();
    for (const ToolKey& key : keys) {
        QAction* action =
            menu->addAction(key.text + u'\t' + QKeySequence(key.key).toString(QKeySequence::NativeText));
        connect(action, &QAction::triggered, &view, [&view, code = key.key] {
            QKeyEvent press(QEvent::KeyPress, code, Qt::NoModifier);
            QCoreApplication::sendEvent(&view, &press);
        });
    }
    finish(*menu, global);
}

} // namespace bolster
