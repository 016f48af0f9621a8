#include "SeamsView.h"

#include "Document.h"
#include "Icons.h"
#include "SeamEdits.h"
#include "SeamsModel.h"
#include "Selection.h"
#include "Units.h"
#include "ViewColors.h"

#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>
#include <QTimer>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>

namespace bolster {

namespace {

ElementId idOf(const QModelIndex& index)
{
    return ElementId{index.data(SeamsModel::ElementRole).toInt()};
}

bool isEase(const QModelIndex& index)
{
    return index.column() == SeamsModel::Difference || index.column() == SeamsModel::Ratio;
}

/// Marks what puckers and what lies under the pointer in any view; lets choose from the few values there are.
class SeamDelegate : public QStyledItemDelegate {
public:
    SeamDelegate(Document& document, const Selection& selection, QObject* parent)
        : QStyledItemDelegate(parent)
        , m_document(document)
        , m_selection(selection)
    {}

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        const int sign = index.column() == SeamsModel::Difference ? signSpace : 0;
        return {QStyledItemDelegate::sizeHint(option, index).width() + sign, 2 * option.fontMetrics.height() + 6};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        const bool selected = option.state & QStyle::State_Selected;
        if (!selected && m_selection.hovered() == idOf(index))
            painter->fillRect(option.rect, mixed(option.palette.color(QPalette::Base),
                                                 option.palette.color(QPalette::Highlight), 0.14));
        QStyleOptionViewItem shown = option;
        const bool puckers = isEase(index) && index.data(SeamsModel::PuckersRole).toBool();
        const QColor warning =
            selected ? option.palette.color(QPalette::HighlightedText) : ViewColors::of(option.palette).warning;
        if (puckers)
            shown.palette.setColor(QPalette::Text, warning);
        if (index.column() == SeamsModel::Name)
            paintSides(*painter, shown, index);
        else
            QStyledItemDelegate::paint(painter, shown, index);
        if (puckers && index.column() == SeamsModel::Difference)
            icon(QStringLiteral("warning"), warning)
                .paint(painter, QRect(option.rect.left() + 3, option.rect.center().y() - 7, 14, 14));
    }

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const override
    {
        auto* box = new QComboBox(parent);
        box->addItems(SeamsModel::choices(static_cast<SeamsModel::Column>(index.column())));
        connect(box, &QComboBox::activated, this, [this, box] {
            auto* self = const_cast<SeamDelegate*>(this);
            emit self->commitData(box);
            emit self->closeEditor(box);
        });
        QTimer::singleShot(0, box, &QComboBox::showPopup); // when it has its place
        return box;
    }

    void setEditorData(QWidget* editor, const QModelIndex& index) const override
    {
        static_cast<QComboBox*>(editor)->setCurrentIndex(index.data(SeamsModel::ValueRole).toInt());
    }

    void setModelData(QWidget* editor, QAbstractItemModel*, const QModelIndex& index) const override
    {
        std::vector<ElementId> seams = {idOf(index)};
        if (m_selection.contains(seams.front()))
            seams.assign(m_selection.elements().begin(), m_selection.elements().end());
        const int value = static_cast<QComboBox*>(editor)->currentIndex();
        const Design& design = m_document.design();
        m_document.commit(index.column() == SeamsModel::MatchColumn
                              ? edits::setMatch(design, seams, static_cast<Match>(value))
                              : edits::setContinuity(design, seams, static_cast<Continuity>(value)));
    }

private:
    /// The two sides one below the other: side by side, names would have to be cut off.
    void paintSides(QPainter& painter, QStyleOptionViewItem option, const QModelIndex& index) const
    {
        initStyleOption(&option, index);
        const QStringList sides = option.text.split(QStringLiteral(" \u2013 "));
        option.text.clear();
        const QStyle* style = option.widget ? option.widget->style() : QApplication::style();
        style->drawControl(QStyle::CE_ItemViewItem, &option, &painter, option.widget);
        const bool selected = option.state & QStyle::State_Selected;
        painter.setPen(option.palette.color(selected ? QPalette::HighlightedText : QPalette::Text));
        painter.setFont(option.font);
        const QRect box = option.rect.adjusted(4, 2, -2, -2);
        const int line = option.fontMetrics.height();
        for (qsizetype i = 0; i < sides.size(); ++i)
            painter.drawText(QRect(box.left(), box.top() + static_cast<int>(i) * line + 1, box.width(), line),
                             Qt::AlignLeft | Qt::AlignVCenter,
                             option.fontMetrics.elidedText(sides[i], Qt::ElideMiddle, box.width()));
    }

    static constexpr int signSpace = 18; // pixels

    Document& m_document;
    const Selection& m_selection;
};

} // namespace

SeamsView::SeamsView(Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_selection(selection)
    , m_model(new SeamsModel(document, this))
    , m_sorted(new QSortFilterProxyModel(this))
    , m_table(new QTreeView(this))
{
    m_sorted->setSourceModel(m_model);
    m_sorted->setSortRole(SeamsModel::SortRole);
    m_sorted->setSortLocaleAware(true);
    buildTable();
    m_table->setAccessibleName(tr("Seams"));

    auto* hint = new QLabel(tr("No seams yet. Choose the sewing tool (W), then click the two edges that belong "
                               "together."));
    hint->setWordWrap(true);
    hint->setAlignment(Qt::AlignCenter);
    hint->setMargin(16);
    hint->setForegroundRole(QPalette::PlaceholderText);
    m_hint = hint;

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_table);
    layout->addWidget(m_hint);
    connect(&selection, &Selection::changed, this, &SeamsView::selectInTable);
    connect(&selection, &Selection::hoverChanged, m_table->viewport(), qOverload<>(&QWidget::update));
    connect(m_model, &QAbstractItemModel::rowsInserted, this, &SeamsView::updateHint);
    connect(m_model, &QAbstractItemModel::rowsRemoved, this, &SeamsView::updateHint);
    updateHint();
}

void SeamsView::buildTable()
{
    m_table->setModel(m_sorted);
    m_table->setItemDelegate(new SeamDelegate(m_document, m_selection, m_table));
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setRootIsDecorated(false);
    m_table->setIconSize({14, 14});
    m_table->setUniformRowHeights(true);
    m_table->setTextElideMode(Qt::ElideMiddle); // the edges of both sides are told
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setEditTriggers(QAbstractItemView::SelectedClicked | QAbstractItemView::DoubleClicked |
                             QAbstractItemView::EditKeyPressed);
    m_table->setContextMenuPolicy(Qt::ActionsContextMenu);
    m_table->setMouseTracking(true);
    m_table->viewport()->installEventFilter(this);
    m_table->installEventFilter(this);
    m_table->setSortingEnabled(true);
    m_table->sortByColumn(SeamsModel::Label, Qt::AscendingOrder);

    QHeaderView* header = m_table->header();
    header->setStretchLastSection(false);
    header->setMinimumSectionSize(28);
    header->moveSection(SeamsModel::Step, 4); // ease and the order of sewing are looked for, lengths are looked up
    fitColumns();

    connect(&NumberStyles::instance(), &NumberStyles::changed, this, &SeamsView::fitColumns);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, &SeamsView::selectFromTable);
    connect(m_table, &QTreeView::entered, this,
            [this](const QModelIndex& index) { m_selection.hover(idOf(index)); });
    connect(m_table, &QTreeView::doubleClicked, this, [this](const QModelIndex& index) {
        if (!(index.flags() & Qt::ItemIsEditable))
            emit shown(idOf(index));
    });
}

/// As wide as their heads and what usually is in them.
void SeamsView::fitColumns()
{
    QHeaderView* header = m_table->header();
    const QFontMetrics metrics = m_table->fontMetrics();
    constexpr int besideText = 8, sign = 18; // pixels
    const bool inches =
        NumberStyles::now().length == LengthUnit::Inches; // which may have fractions, or more decimals
    const QString length = (inches ? QStringLiteral("888 88/88") : QStringLiteral("8888.8")) + lengthSuffix();
    const QString ease = (inches ? QStringLiteral("+8.888") : QStringLiteral("+88.8")) + lengthSuffix();
    const std::pair<SeamsModel::Column, QString> usual[] = {
        {SeamsModel::Label, QStringLiteral("W")},
        {SeamsModel::Difference, ease},
        {SeamsModel::Ratio, QStringLiteral("+88.8 %")},
        {SeamsModel::Step, QStringLiteral("88")},
        {SeamsModel::ContinuityColumn, QStringLiteral("G1")},
        {SeamsModel::LengthA, length},
        {SeamsModel::LengthB, length},
        {SeamsModel::MatchColumn, SeamsModel::choices(SeamsModel::MatchColumn).back()}};
    for (const auto& [column, text] : usual) {
        const QString head = m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        const bool signs = column == SeamsModel::Label || column == SeamsModel::Difference;
        header->resizeSection(column, std::max(metrics.horizontalAdvance(text) + (signs ? sign : 0),
                                               header->fontMetrics().horizontalAdvance(head)) +
                                          besideText);
    }
    fitNames();
}

/// The two names stand below each other, and leave room for what is looked for: ease and the order of sewing.
void SeamsView::fitNames()
{
    constexpr int fewestLetters = 8, mostLetters = 22;
    QHeaderView* header = m_table->header();
    int others = 0;
    for (int place = 0; place <= header->visualIndex(SeamsModel::Step); ++place)
        if (const int column = header->logicalIndex(place); column != SeamsModel::Name)
            others += header->sectionSize(column);
    const int letter = m_table->fontMetrics().averageCharWidth();
    const int head = header->fontMetrics().horizontalAdvance(
        m_model->headerData(SeamsModel::Name, Qt::Horizontal, Qt::DisplayRole).toString());
    const int least = std::max(fewestLetters * letter, head + 8);
    header->resizeSection(SeamsModel::Name, std::clamp(m_table->viewport()->width() - others - 1, least,
                                                       std::max(least, mostLetters * letter)));
}

void SeamsView::updateHint()
{
    m_table->setVisible(m_model->rowCount() > 0);
    m_hint->setVisible(m_model->rowCount() == 0);
}

void SeamsView::selectInTable()
{
    if (m_syncing)
        return;
    m_syncing = true;
    QItemSelection rows;
    for (const ElementId id : m_selection.elements())
        if (const QModelIndex index = m_sorted->mapFromSource(m_model->indexOf(id)); index.isValid())
            rows.select(index, index);
    m_table->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    if (!rows.isEmpty()) {
        const QModelIndex first = rows.indexes().front();
        m_table->selectionModel()->setCurrentIndex(first, QItemSelectionModel::NoUpdate);
        m_table->scrollTo(first);
    }
    m_syncing = false;
}

void SeamsView::selectFromTable()
{
    if (m_syncing)
        return;
    std::set<ElementId> seams;
    for (const QModelIndex& index : m_table->selectionModel()->selectedRows())
        seams.insert(idOf(index));
    m_syncing = true;
    m_selection.set(std::move(seams));
    m_syncing = false;
}

void SeamsView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        m_model->recolor();
    else if (event->type() == QEvent::FontChange)
        QMetaObject::invokeMethod(this, &SeamsView::fitColumns,
                                  Qt::QueuedConnection); // its table hears of it later
}

bool SeamsView::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_table->viewport() && event->type() == QEvent::Resize)
        fitNames();
    if (watched != m_table && event->type() == QEvent::Leave)
        m_selection.hover(noElement);
    // Here all seams are meant, not all patches: who deletes them then keeps these.
    if (watched == m_table && event->type() == QEvent::ShortcutOverride &&
        static_cast<QKeyEvent*>(event)->matches(QKeySequence::SelectAll)) {
        event->accept();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace bolster
