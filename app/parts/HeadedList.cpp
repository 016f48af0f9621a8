#include "HeadedList.h"

#include <QHeaderView>
#include <QScrollBar>

namespace bolster {

HeadedList::HeadedList(const QStringList& heads, int widest, QWidget* parent)
    : QTreeWidget(parent)
{
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setHeaderLabels(heads);
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    header()->setSectionResizeMode(widest, QHeaderView::Stretch);
}

QSize HeadedList::minimumSizeHint() const
{
    int width = verticalScrollBar()->sizeHint().width() + 2 * frameWidth();
    for (int column = 0; column < columnCount(); ++column)
        if (!isColumnHidden(column))
            width += header()->sectionSizeHint(column);
    return QTreeWidget::minimumSizeHint().expandedTo({width, 0});
}

} // namespace bolster
