#include "CardFlow.h"

#include <algorithm>

namespace bolster {

CardFlow::CardFlow(int gap, QWidget* parent)
    : QLayout(parent)
    , m_gap(gap)
{
    setContentsMargins(0, 0, 0, 0);
}

CardFlow::~CardFlow()
{
    while (QLayoutItem* item = CardFlow::takeAt(0))
        delete item;
}

QLayoutItem* CardFlow::takeAt(int index)
{
    return index >= 0 && index < m_items.size() ? m_items.takeAt(index) : nullptr;
}

int CardFlow::heightForWidth(int width) const
{
    return arrange({0, 0, width, 0}, false);
}

QSize CardFlow::minimumSize() const
{
    QSize size;
    for (const QLayoutItem* item : m_items)
        size = size.expandedTo(item->minimumSize());
    return size;
}

void CardFlow::setGeometry(const QRect& rect)
{
    QLayout::setGeometry(rect);
    arrange(rect, true);
}

/// All cells are as wide as the widest card, so that they stand below each other; what is left of a row's width
/// stays free. Returns the height.
int CardFlow::arrange(const QRect& rect, bool move) const
{
    QSize cell;
    for (const QLayoutItem* item : m_items)
        cell = cell.expandedTo(item->sizeHint());
    if (cell.isEmpty())
        return 0;
    const int columns = std::max(1, (rect.width() + m_gap) / (cell.width() + m_gap));
    cell.setWidth(std::min(cell.width(), rect.width()));
    const auto count = static_cast<int>(m_items.size());
    if (move)
        for (int i = 0; i < count; ++i)
            m_items[i]->setGeometry({rect.topLeft() + QPoint(i % columns * (cell.width() + m_gap),
                                                             i / columns * (cell.height() + m_gap)),
                                     cell});
    return (count + columns - 1) / columns * (cell.height() + m_gap) - m_gap;
}

} // namespace bolster
