#include "ContextMenus.h"

#include "Actions.h"
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
    ContextMenuFiller(QMenu& menu, const Design& design, const Selection& selection, const Actions& actions)
        : m_menu(menu)
        , m_design(design)
        , m_selection(selection)
        , m_actions(actions)
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
            group({m_actions.cut, m_actions.copy, m_actions.duplicate});
        }
        hiding();
        rest();
    }

    void pattern()
    {
        group(tools({PatternToolKind::Outline, PatternToolKind::Rectangle, PatternToolKind::Ellipse,
                     PatternToolKind::Sew}));
        group({m_actions.paste, m_actions.arrange});
        group({m_actions.selectAll, m_actions.fitAll});
        submenu(tr("&Show"), {m_actions.showGrid, m_actions.showLabels, m_actions.showSeams, m_actions.showPoints,
                              m_actions.showMesh, m_actions.showRulers, m_actions.showGuides});
        group({m_actions.snapping});
    }

    void space()
    {
        group(m_actions.surfaceTools);
        group({m_actions.importFrame, m_actions.insertCushion});
        group({m_actions.fitAll, m_actions.perspective, m_actions.section});
        submenu(tr("&Look from"), m_actions.standardViews);
        submenu(tr("&Show"), {m_actions.showFrames, m_actions.showCurves, m_actions.showSeams, m_actions.showMesh,
                              m_actions.showChecker, m_actions.showScans, m_actions.showGround});
        submenu(tr("&Map"), m_actions.maps + QList{m_actions.showDeviation});
        group({m_actions.showHidden});
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

    QList<QAction*> tools(std::initializer_list<PatternToolKind> kinds) const
    {
        QList<QAction*> found;
        for (QAction* action : m_actions.patternTools)
            if (std::ranges::find(kinds, static_cast<PatternToolKind>(action->data().toInt())) != kinds.end())
                found.append(action);
        return found;
    }

    void points()
    {
        if (m_selection.points().empty())
            return;
        group({m_actions.makeCorner, m_actions.makeSmooth, m_actions.straighten});
        group({m_actions.createFixation});
        group({m_actions.releasePoints, m_actions.relinkPoints});
    }

    void edges()
    {
        if (m_selection.edges().empty())
            return;
        group({m_actions.edgeLength, m_actions.equalLengths});
        group({m_actions.createFixation});
    }

    void sewing()
    {
        if (has<Seam>()) {
            group({m_actions.flipSeams, m_actions.swapSeamSides, m_actions.equalLengths});
            submenu(tr("&Continuity"), m_actions.seamContinuities);
            submenu(tr("&Match"), m_actions.seamMatches);
            group({m_actions.mergePatches, m_actions.showSeamList});
        }
        if (has<FixationCurve>())
            group(tools({PatternToolKind::Attach}));
    }

    void patches()
    {
        if (!has<Patch>())
            return;
        fabric();
        group({m_actions.cut, m_actions.copy, m_actions.paste, m_actions.duplicate});
        submenu(tr("&Arrange"), QList{m_actions.turnLeft, m_actions.turnRight, m_actions.mirrorHorizontally,
                                      m_actions.mirrorVertically} +
                                    m_actions.align + m_actions.distribute + QList{m_actions.arrange});
        group({m_actions.mergePatches});
        hiding();
    }

    void fabric() { group({m_actions.assignFabric, m_actions.editFabric}); }
    void hiding() { group({m_actions.hideSelected, m_actions.isolate, m_actions.showHidden}); }

    /// What is no matter of patches, and what can be done with anything.
    void rest()
    {
        group({m_actions.makeTwin, m_actions.linkTwins, m_actions.unlinkTwins});
        if (has<Frame>())
            group({m_actions.insertCushion});
        if (has<Cushion>())
            group(m_actions.insertFoam);
        group({m_actions.rename, m_actions.fitSelection});
        const auto ofPatch = [](const Selection::Edge& edge) { return edge.owner == edge.stretch.patch; };
        if (std::ranges::none_of(m_selection.edges(), ofPatch))
            group({m_actions.remove});
    }

    QMenu& m_menu;
    const Design& m_design;
    const Selection& m_selection;
    const Actions& m_actions;
};

} // namespace

ContextMenus::ContextMenus(Document& document, Selection& selection, Actions& actions, QWidget* window)
    : QObject(window)
    , m_document(document)
    , m_selection(selection)
    , m_actions(actions)
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
    ContextMenuFiller filler(*menu, m_document.design(), m_selection, m_actions);
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
    ContextMenuFiller filler(*menu, m_document.design(), m_selection, m_actions);
    onSomething ? filler.selectionInSpace() : filler.space();
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
