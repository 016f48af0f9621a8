#include "HistoryView.h"

#include "Document.h"
#include "HistoryModel.h"
#include "PictureTip.h"
#include "ViewColors.h"

#include <QContextMenuEvent>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QPainterPath>
#include <QStyledItemDelegate>

#include <algorithm>

namespace bolster {

namespace {

// Pixels.
constexpr int laneWidth = 16;
constexpr int leftMargin = 14;
constexpr int rowHeight = 38;
constexpr int pictureMargin = 3;
constexpr int branchGap = 8;

/// A line with dots, as in a plan of an underground railway.
class HistoryDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        const int depth = index.data(HistoryModel::DepthRole).toInt();
        const int width = option.fontMetrics.horizontalAdvance(index.data().toString()) +
                          option.fontMetrics.horizontalAdvance(index.data(HistoryModel::BranchRole).toString()) +
                          option.fontMetrics.horizontalAdvance(index.data(HistoryModel::NameRole).toString());
        return {leftMargin + (depth + 1) * laneWidth + width + 12,
                std::max(rowHeight, 2 * option.fontMetrics.height() + 6)};
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
        if (!m_filtered) // neighbours of a filtered list have nothing to do with each other
            paintLanes(*painter, option.rect, index, depth, mixed(base, palette.color(QPalette::Text), 0.3));
        const QPointF dot(laneX(option.rect, depth), option.rect.center().y() + 0.5);
        painter->setPen(QPen(done ? accent : mixed(base, palette.color(QPalette::Text), 0.4), 1.6));
        painter->setBrush(current ? accent : done ? mixed(base, accent, 0.5) : base);
        painter->drawEllipse(dot, current ? 5 : 3.5, current ? 5 : 3.5);

        QRect place = textPlace(option.rect, depth);
        place.setRight(paintPicture(*painter, option.rect, index, done) - 6);
        paintTime(*painter, option, index, place);
        place = upperLine(place, option.fontMetrics);
        if (const QString branch = index.data(HistoryModel::BranchRole).toString(); !branch.isEmpty())
            place.setLeft(paintBranch(*painter, option, branch, place, done) + branchGap);
        paintText(*painter, option, index, place, text);
        painter->restore();
    }

    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override
    {
        editor->setGeometry(
            textPlace(option.rect, index.data(HistoryModel::DepthRole).toInt()).adjusted(0, 5, 0, -5));
    }

    void setFiltered(bool filtered) { m_filtered = filtered; }
    /// What the next editor is for: Qt::EditRole or BranchRole.
    void setEdited(int role) { m_edited = role; }

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override
    {
        QWidget* editor = QStyledItemDelegate::createEditor(parent, option, index);
        if (auto* line = qobject_cast<QLineEdit*>(editor))
            line->setPlaceholderText(m_edited == HistoryModel::BranchRole
                                         ? HistoryView::tr("Name of this branch")
                                         : HistoryView::tr("Name of this version"));
        return editor;
    }

    void setEditorData(QWidget* editor, const QModelIndex& index) const override
    {
        if (auto* line = qobject_cast<QLineEdit*>(editor))
            line->setText(index.data(m_edited).toString());
    }

    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override
    {
        if (auto* line = qobject_cast<QLineEdit*>(editor))
            model->setData(index, line->text(), m_edited);
    }

private:
    static QRect textPlace(const QRect& rect, int depth)
    {
        return rect.adjusted(static_cast<int>(laneX(rect, depth)) - rect.left() + 13, 0, -4, 0);
    }

    static QRect upperLine(const QRect& place, const QFontMetrics& metrics)
    {
        return {place.left(), place.center().y() - metrics.height(), place.width(), metrics.height() + 1};
    }

    /// Where the version has one, at the right. Returns where it begins.
    static int paintPicture(QPainter& painter, const QRect& rect, const QModelIndex& index, bool done)
    {
        const auto image = index.data(HistoryModel::PictureRole).value<QImage>();
        if (image.isNull())
            return rect.right();
        const int height = rect.height() - 2 * pictureMargin;
        const int width = image.width() * height / image.height();
        const QRect place(rect.right() - width - pictureMargin, rect.top() + pictureMargin, width, height);
        painter.save();
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.setOpacity(done ? 1 : 0.55);
        const qreal ratio = painter.device()->devicePixelRatioF();
        QImage scaled = image.scaled(place.size() * ratio, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        painter.drawImage(place, scaled);
        painter.restore();
        return place.left();
    }

    /// Below what was done.
    static void paintTime(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index,
                          const QRect& place)
    {
        QFont small = option.font;
        small.setPointSizeF(small.pointSizeF() * 0.88);
        painter.setFont(small);
        painter.setPen(mixed(option.palette.color(QPalette::Base), option.palette.color(QPalette::Text), 0.5));
        const QRect line(place.left(), place.center().y() + 1, place.width(), option.fontMetrics.height());
        painter.drawText(line, Qt::AlignTop | Qt::AlignLeft,
                         QFontMetrics(small).elidedText(index.data(HistoryModel::TimeRole).toString(),
                                                        Qt::ElideRight, place.width()));
    }

    /// A label with round ends. Returns where it ends.
    static int paintBranch(QPainter& painter, const QStyleOptionViewItem& option, const QString& name,
                           const QRect& place, bool done)
    {
        const QColor base = option.palette.color(QPalette::Base);
        const QColor accent = option.palette.color(QPalette::Highlight);
        const int width = std::min(option.fontMetrics.horizontalAdvance(name) + 16, place.width());
        const int height = option.fontMetrics.height() + 2;
        const QRectF label(place.left() + 0.5, place.center().y() - height / 2 + 0.5, width, height);
        painter.setPen(QPen(mixed(base, accent, done ? 0.8 : 0.4), 1));
        painter.setBrush(mixed(base, accent, done ? 0.25 : 0.1));
        painter.drawRoundedRect(label, label.height() / 2, label.height() / 2);
        painter.setFont(option.font);
        painter.setPen(mixed(base, option.palette.color(QPalette::Text), done ? 1.0 : 0.6));
        painter.drawText(label.adjusted(8, 0, -6, 0), Qt::AlignVCenter | Qt::AlignLeft,
                         option.fontMetrics.elidedText(name, Qt::ElideRight, width - 14));
        return place.left() + width;
    }

    /// A name stands bold before what was done.
    static void paintText(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index,
                          QRect place, const QColor& color)
    {
        const bool current = index.data(HistoryModel::CurrentRole).toBool();
        const QString name = index.data(HistoryModel::NameRole).toString();
        QFont font = option.font;
        const auto draw = [&](const QString& text, bool bold, const QColor& ink) {
            font.setBold(bold);
            const QFontMetrics metrics(font);
            painter.setFont(font);
            painter.setPen(ink);
            painter.drawText(place, Qt::AlignVCenter | Qt::AlignLeft,
                             metrics.elidedText(text, Qt::ElideMiddle, place.width()));
            place.setLeft(place.left() + metrics.horizontalAdvance(text) + 8);
        };
        if (!name.isEmpty())
            draw(name, true, color);
        if (place.width() > 20)
            draw(index.data().toString(), current && name.isEmpty(),
                 name.isEmpty() ? color : mixed(option.palette.color(QPalette::Base), color, 0.6));
    }

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

    bool m_filtered = false;
    int m_edited = Qt::EditRole;
};

} // namespace

HistoryView::HistoryView(Document& document, QWidget* parent)
    : QListView(parent)
    , m_document(document)
    , m_model(new HistoryModel(document, this))
    , m_tip(new PictureTip(this))
{
    setModel(m_model);
    setItemDelegate(new HistoryDelegate(this));
    setUniformItemSizes(true); // all are equally high, so adding one asks for no other
    setMouseTracking(true);
    setFrameShape(QFrame::NoFrame);
    setSelectionMode(NoSelection);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(ScrollPerPixel);
    connect(this, &QListView::clicked, this,
            [this](const QModelIndex& index) { m_document.jumpTo(index.data(HistoryModel::NodeRole).toInt()); });
    connect(this, &QListView::activated, this,
            [this](const QModelIndex& index) { m_document.jumpTo(index.data(HistoryModel::NodeRole).toInt()); });
    setEditTriggers(DoubleClicked | EditKeyPressed);
    connect(m_model, &QAbstractItemModel::modelReset, this, [this] {
        applyFilter(0, m_model->rowCount() - 1);
        m_shown = -1;
        showCurrent();
    });
    connect(m_model, &QAbstractItemModel::rowsInserted, this,
            [this](const QModelIndex&, int first, int last) { applyFilter(first, last); });
    connect(m_model, &QAbstractItemModel::dataChanged, this,
            [this](const QModelIndex& first, const QModelIndex& last, const QList<int>& roles) {
                if (roles == QList<int>{HistoryModel::PictureRole})
                    return; // nothing has moved
                applyFilter(first.row(), last.row());
                showCurrent();
            });
    connect(itemDelegate(), &QAbstractItemDelegate::closeEditor, this,
            [this] { static_cast<HistoryDelegate*>(itemDelegate())->setEdited(Qt::EditRole); });
    showCurrent();
}

void HistoryView::setFilter(const QString& words)
{
    m_filter = words.split(u' ', Qt::SkipEmptyParts);
    static_cast<HistoryDelegate*>(itemDelegate())->setFiltered(!m_filter.isEmpty());
    applyFilter(0, m_model->rowCount() - 1);
    viewport()->update();
}

void HistoryView::applyFilter(int first, int last)
{
    for (int row = first; row <= last; ++row) {
        const QModelIndex index = m_model->index(row);
        const QString text = index.data().toString() + u' ' + index.data(HistoryModel::NameRole).toString() + u' ' +
                             index.data(HistoryModel::BranchRole).toString();
        const bool found = std::ranges::all_of(
            m_filter, [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
        setRowHidden(row, !found);
    }
}

/// A tool tip of Qt would show no picture: these are plain.
bool HistoryView::viewportEvent(QEvent* event)
{
    if (event->type() != QEvent::ToolTip)
        return QListView::viewportEvent(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    m_tip->showAt(help->globalPos(), indexAt(help->pos()).data(Qt::ToolTipRole).toString());
    return true;
}

bool HistoryView::event(QEvent* event)
{
    // F2 names a version here; in the rest of the window it renames an element.
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_F2)
        event->accept();
    return QListView::event(event);
}

void HistoryView::nameBranchOf(NodeId node)
{
    const auto first = m_document.history().branchOf(node);
    if (!first)
        return;
    const QModelIndex index = m_model->indexOf(*first);
    setRowHidden(index.row(), false); // a search may have
    scrollTo(index);
    auto* delegate = static_cast<HistoryDelegate*>(itemDelegate());
    delegate->setEdited(HistoryModel::BranchRole);
    edit(index);
}

void HistoryView::contextMenuEvent(QContextMenuEvent* event)
{
    const QModelIndex index = event->reason() == QContextMenuEvent::Mouse ? indexAt(event->pos()) : currentIndex();
    if (!index.isValid())
        return;
    const NodeId node = index.data(HistoryModel::NodeRole).toInt();
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    connect(menu->addAction(tr("&Go to this version")), &QAction::triggered, this,
            [this, node] { m_document.jumpTo(node); });
    QAction* compare = menu->addAction(tr("&Compare with now \u2026"));
    compare->setEnabled(node != m_document.history().current());
    connect(compare, &QAction::triggered, this, [this, node] { emit compareWanted(node); });
    connect(menu->addAction(tr("&Name this version \u2026")), &QAction::triggered, this,
            [this, node] { edit(m_model->indexOf(node)); });
    QAction* forget = menu->addAction(tr("&Remove its name"));
    forget->setEnabled(!index.data(HistoryModel::NameRole).toString().isEmpty());
    connect(forget, &QAction::triggered, this, [this, node] { m_document.nameVersion(node, {}); });
    menu->addSeparator();
    QAction* branch = menu->addAction(tr("Name this &branch \u2026"));
    branch->setEnabled(m_document.history().branchOf(node).has_value());
    connect(branch, &QAction::triggered, this, [this, node] { nameBranchOf(node); });
    menu->popup(event->reason() == QContextMenuEvent::Mouse ? event->globalPos()
                                                            : viewport()->mapToGlobal(visualRect(index).center()));
}

/// Only when it is another one: while a version is being named the list stays where it is.
void HistoryView::showCurrent()
{
    const NodeId node = m_document.history().current();
    if (node == m_shown)
        return;
    m_shown = node;
    const QModelIndex current = m_model->indexOf(node);
    setCurrentIndex(current);
    scrollTo(current);
}

/// Keeps the present version in sight, unless somebody has scrolled away from it.
void HistoryView::resizeEvent(QResizeEvent* event)
{
    const QModelIndex current = m_model->indexOf(m_document.history().current());
    const bool inSight =
        !event->oldSize().isValid() || visualRect(current).intersects(QRect(QPoint(), event->oldSize()));
    QListView::resizeEvent(event);
    if (inSight)
        scrollTo(current);
}

} // namespace bolster
