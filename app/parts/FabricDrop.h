// Fabrics that are dragged onto a patch of a view.
#pragma once

#include "ElementId.h"

#include <QObject>
#include <QPointF>

#include <functional>

namespace bolster {

/// Takes the drags of a view that come from the library; the patch that would get the fabric is shown as hovered.
class FabricDrop : public QObject {
    Q_OBJECT

public:
    /// `patchAt` says which patch is under a pixel, or noElement.
    FabricDrop(QWidget& view, std::function<ElementId(QPointF)> patchAt, std::function<void(ElementId)> hover);

signals:
    void dropped(bolster::ElementId patch, bolster::ElementId fabric);

protected:
    bool eventFilter(QObject* view, QEvent* event) override;

private:
    std::function<ElementId(QPointF)> m_patchAt;
    std::function<void(ElementId)> m_hover;
};

} // namespace bolster
