// The menus of the right button in both views and the list of elements.
#pragma once

#include "ElementId.h"
#include "FramePieces.h"
#include "ToolKey.h"

#include <QObject>
#include <QPoint>

#include <optional>

class QMenu;
class QWidget;

namespace bolster {

class Commands;
class Document;
class Selection;

/// What a click on a frame has met.
struct PieceOfFrame {
    ElementId frame{};
    FrameMeshPtr mesh; ///< the whole
    int piece = 0;     ///< of its FramePieces
};

/// The commands for what is selected, in the order in which they are used, or those for the view itself. They are
/// the actions of the menus; what cannot be done now is left out.
class ContextMenus : public QObject {
    Q_OBJECT

public:
    ContextMenus(Document& document, Selection& selection, Commands& commands, QWidget* window);

    /// `onSomething`: what lies there is selected; else the view is meant.
    void showInPattern(const QPoint& global, bool onSomething);
    /// `piece`: of a frame, where there is one.
    void showInSurface(const QPoint& global, bool onSomething, const std::optional<PieceOfFrame>& piece);
    /// What both views offer for what is selected.
    void showInList(const QPoint& global);
    /// What the tool of this view does by keys.
    void showForTool(QWidget& view, const QPoint& global, const ToolKeys& keys);

private:
    QMenu* begin();
    void finish(QMenu& menu, const QPoint& global);
    void addHiding(QMenu& menu, const PieceOfFrame& piece);

    Document& m_document;
    Selection& m_selection;
    Commands& m_commands;
    QWidget* m_window;
};

} // namespace bolster
