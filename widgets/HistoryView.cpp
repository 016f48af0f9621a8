#include "HistoryView.h"

#include "Document.h"
#include "HistoryModel.h"
#include "ViewColors.h"

#include <QPainter>
#include <QPainterPath>
#include <QStyledItemDelegate>

namespace bolster {

namespace {

// Pixels.
constexpr int laneWidth = 16;
constexpr int leftMargin = 14;
constexpr int rowHeight = 26;

/// A line with dots, as in a plan of an underground railway.
class HistoryDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        const int depth = index.data(HistoryModel::DepthRole).toInt();
        const int width = option.fontMetrics.horizontalAdvance(index.data().toString());
        return {leftMargin + (depth + 1) * laneWidth + width + 12,
                std::max(rowHeight, option.fontMetrics.height() + 8)};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        const QPalette& palette = option.palette;
        const bool current = index.data(HistoryModel::CurrentRole).toBool();
        const bool done = index.data(HistoryModel::DoneRole).toBool();
        const QColor base = palette.color(QPalette::Base);
        const QColor accent = palette.color(QPalette::Highlight);
        const QColor text = mixed(base, palette.color(QPalette::Text), done ? 1.0 : 0.45);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        if (current)
            painter->fillRect(option.rect, mixed(base, accent, 0.22));
        else if (option.state & QStyle::State_MouseOver)
            painter->fillRect(option.rect, mixed(base, accent, 0.08));

        const int depth = index.data(HistoryModel::DepthRole).toInt();
        paintLanes(*painter, option.rect, index, depth, mixed(base, palette.color(QPalette::Text), 0.3));
        const QPointF dot(laneX(option.rect, depth), option.rect.center().y() + 0.5);
        painter->setPen(QPen(done ? accent : mixed(base, palette.color(QPalette::Text), 0.4), 1.6));
        painter->setBrush(current ? accent : done ? mixed(base, accent, 0.5) : base);
        painter->drawEllipse(dot, current ? 5 : 3.5, current ? 5 : 3.5);

        QFont font = option.font;
        font.setBold(current);
        painter->setFont(font);
        painter->setPen(text);
        const QRect place = option.rect.adjusted(static_cast<int>(dot.x()) - option.rect.left() + 13, 0, -4, 0);
        painter->drawText(place, Qt::AlignVCenter | Qt::AlignLeft,
                          QFontMetrics(font).elidedText(index.data().toString(), Qt::ElideRight, place.width()));
        painter->restore();
    }

private:
    static double laneX(const QRect& rect, int depth) { return rect.left() + leftMargin + depth * laneWidth; }

    static void paintLanes(QPainter& painter, const QRect& rect, const QModelIndex& index, int depth,
                           const QColor& color)
    {
        painter.setPen(QPen(color, 1.6));
        const double middle = rect.center().y() + 0.5;
        const double top = rect.top();
        const double bottom = rect.bottom() + 1;
        const auto below = index.data(HistoryModel::LaneBitsRole).toUInt();
        const quint32 above =
            index.row() > 0 ? index.siblingAtRow(index.row() - 1).data(HistoryModel::LaneBitsRole).toUInt() : 0;
        for (int lane = 0; lane < 32; ++lane) {
            const double x = laneX(rect, lane);
            const quint32 bit = 1U << lane;
            if (lane == depth && index.data(HistoryModel::FirstOfBranchRole).toBool()) {
                const double from = laneX(rect, lane - 1);
                QPainterPath bend(QPointF(from, top));
                bend.cubicTo(from, middle, from, middle, x, middle);
                painter.drawPath(bend);
            } else if (above & bit) {
                painter.drawLine(QPointF(x, top), QPointF(x, middle));
            }
            if (below & bit)
                painter.drawLine(QPointF(x, middle), QPointF(x, bottom));
        }
    }
};

} // namespace

HistoryView::HistoryView(Document& document, QWidget* parent)
    : QListView(parent)
    , m_document(document)
    , m_model(new HistoryModel(document, this))
{
    setModel(m_model);
    setItemDelegate(new HistoryDelegate(this));
    setUniformItemSizes(false);
    setMouseTracking(true);
    setFrameShape(QFrame::NoFrame);
    setSelectionMode(NoSelection);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(ScrollPerPixel);
    connect(this, &QListView::clicked, this,
            [this](const QModelIndex& index) { m_document.jumpTo(index.data(HistoryModel::NodeRole).toInt()); });
    connect(this, &QListView::activated, this,
            [this](const QModelIndex& index) { m_document.jumpTo(index.data(HistoryModel::NodeRole).toInt()); });
    connect(m_model, &QAbstractItemModel::modelReset, this, &HistoryView::showCurrent);
    showCurrent();
}

void HistoryView::showCurrent()
{
    const QModelIndex current = m_model->indexOf(m_document.history().current());
    setCurrentIndex(current);
    scrollTo(current);
}

} // namespace bolster
