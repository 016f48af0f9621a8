// What the window does with patches: clipboard, layout, shapes; and with drags that cannot be.
#include "MainWindow.h"

#include "ContextMenus.h"
#include "Docks.h"
#include "Inspector.h"
#include "PatternCommands.h"
#include "PatternView.h"
#include "StatusLine.h"
#include "Translated.h"

namespace bolster {

namespace {

/// None where the frame is of one piece.
std::optional<PieceOfFrame> pieceAt(const SurfaceView& view, const QPoint& global, const Design& design,
                                    const DesignFiles& files)
{
    const SurfaceHit hit = view.hit(view.mapFromGlobal(global));
    const auto mesh = files.meshes.find(hit.element);
    const Frame* frame = design.find<Frame>(hit.element);
    if (hit.kind != SurfaceHit::Kind::Frame || !frame || mesh == files.meshes.end() || !mesh->second)
        return std::nullopt;
    const std::shared_ptr<const FramePieces> pieces = piecesOf(mesh->second);
    const std::optional<int> piece =
        pieces->ofShown(*mesh->second, pieces->hiddenBy(*mesh->second, frame->hiddenParts), hit.triangle);
    if (!piece || pieces->pieces.size() < 2)
        return std::nullopt;
    return PieceOfFrame{hit.element, mesh->second, *piece};
}

} // namespace

void MainWindow::connectPattern()
{
    auto* commands = new PatternCommands(document(), m_selection, *m_actions, this);
    connect(commands, &PatternCommands::said, m_status, &StatusLine::flash);
    connect(commands, &PatternCommands::edgeLengthWanted, this, [this] {
        Docks::reveal(m_docks->inspector);
        m_inspector->focusFirst();
    });
    auto* menus = new ContextMenus(document(), m_selection, *m_actions, this);
    connect(m_pattern, &PatternView::contextMenuWanted, menus, &ContextMenus::showInPattern);
    connect(m_surface, &SurfaceView::contextMenuWanted, menus, [this, menus](const QPoint& at, bool onSomething) {
        menus->showInSurface(at, onSomething,
                             onSomething
                                 ? pieceAt(*m_surface, at, m_session->document().design(), m_session->files())
                                 : std::nullopt);
    });
    connect(m_pattern, &PatternView::toolMenuWanted, menus,
            [this, menus](const QPoint& at, const ToolKeys& keys) { menus->showForTool(*m_pattern, at, keys); });
    connect(m_surface, &SurfaceView::toolMenuWanted, menus,
            [this, menus](const QPoint& at, const ToolKeys& keys) { menus->showForTool(*m_surface, at, keys); });
    connect(&document(), &Document::refused, this, [this](const Message& why) {
        m_status->flash(tr("%1 It is back where it was.").arg(translated(why)));
    });
    connect(&document(), &Document::noted, this,
            [this](const Message& note) { m_status->flash(translated(note)); });
    connect(&document(), &Document::changed, this, [this] {
        if (document().gestureRunning())
            m_status->flash({}); // what was said about the last drag would hide what this one says
        else
            m_status->forgetReason();
    });
}

} // namespace bolster
