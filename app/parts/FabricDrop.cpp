#include "FabricDrop.h"

#include "FabricPanel.h"

#include <QDropEvent>
#include <QMimeData>
#include <QWidget>

namespace bolster {

FabricDrop::FabricDrop(QWidget& view, std::function<ElementId(QPointF)> patchAt,
                       std::function<void(ElementId)> hover)
    : QObject(&view)
    , m_patchAt(std::move(patchAt))
    , m_hover(std::move(hover))
{
    view.setAcceptDrops(true);
    view.installEventFilter(this);
}

bool FabricDrop::eventFilter(QObject*, QEvent* event)
{
    const QEvent::Type type = event->type();
    if (type == QEvent::DragLeave)
        m_hover(noElement);
    if (type != QEvent::DragEnter && type != QEvent::DragMove && type != QEvent::Drop)
        return false;
    auto* drop = static_cast<QDropEvent*>(event);
    if (!drop->mimeData()->hasFormat(FabricPanel::mimeType())) {
        drop->ignore(); // the window takes files
        return true;
    }
    const ElementId patch = m_patchAt(drop->position());
    m_hover(type == QEvent::Drop ? noElement : patch);
    if (type == QEvent::DragEnter || patch != noElement)
        drop->acceptProposedAction();
    else
        drop->ignore();
    if (type == QEvent::Drop && patch != noElement)
        emit dropped(patch, static_cast<ElementId>(drop->mimeData()->data(FabricPanel::mimeType()).toInt()));
    return true;
}

} // namespace bolster
