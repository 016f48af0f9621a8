#include "ColumnScroll.h"

#include <QEvent>
#include <QScrollBar>

namespace bolster {

ColumnScroll::ColumnScroll(QWidget* parent)
    : QScrollArea(parent)
{
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

QSize ColumnScroll::minimumSizeHint() const
{
    QSize least = QScrollArea::minimumSizeHint();
    if (const QWidget* page = widget())
        least.setWidth(page->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width() +
                       2 * frameWidth());
    return least;
}

/// The base class watches the page.
bool ColumnScroll::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == widget() && event->type() == QEvent::LayoutRequest)
        updateGeometry();
    return QScrollArea::eventFilter(watched, event);
}

} // namespace bolster
