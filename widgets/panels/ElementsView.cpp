#include "ElementsView.h"

#include "Document.h"
#include "ElementsModel.h"
#include "Icons.h"
#include "ProblemSet.h"
#include "Selection.h"
#include "ViewColors.h"

#include <QEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPainter>
#include <QScrollBar>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>
#include <QTreeView>
#include <QVBoxLayout>

namespace bolster {

namespace {

/// Headings for kinds with their number, a sign for problems, and what lies under the pointer in any view.
class ElementDelegate : public QStyledItemDelegate {
public:
    ElementDelegate(const Selection& selection, QObject* parent)
        : QStyledItemDelegate(parent)
        , m_selection(selection)
    {}

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        return {QStyledItemDelegate::sizeHint(option, index).width(), option.fontMetrics.height() + 9};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        if (!index.parent().isValid()) {
            paintHeading(*painter, option, index);
            return;
        }
        const bool selected = option.state & QStyle::State_Selected;
        const QVariant id = index.data(ElementsModel::ElementRole);
        if (!selected && m_selection.hovered() == ElementId{id.toInt()})
            painter->fillRect(option.rect, mixed(option.palette.color(QPalette::Base),
                                                 option.palette.color(QPalette::Highlight), 0.14));
        QStyleOptionViewItem shortened = option;
        const int problem = index.data(ElementsModel::ProblemRole).toInt();
        const bool noted = !index.data(ElementsModel::NoteRole).toString().isEmpty();
        const int signs = (problem > 0) + noted;
        shortened.rect.setRight(option.rect.right() - signs * signRoom);
        QStyledItemDelegate::paint(painter, shortened, index);
        if (selected)
            painter->fillRect(
                QRect(shortened.rect.right() + 1, option.rect.top(), signs * signRoom, option.rect.height()),
                option.palette.brush(QPalette::Highlight));
        QRect place(option.rect.right() - 20, option.rect.center().y() - 7, 16, 16);
        const auto paintSign = [&](const QString& name, const QColor& color) {
            icon(name, selected ? option.palette.color(QPalette::HighlightedText) : color).paint(painter, place);
            place.translate(-signRoom, 0);
        };
        const ViewColors colors = ViewColors::of(option.palette);
        if (problem > 0)
            paintSign(problem == 2 ? QStringLiteral("error") : QStringLiteral("warning"),
                      problem == 2 ? colors.error : colors.warning);
        if (noted)
            paintSign(QStringLiteral("note"), colors.label);
    }

    /// What is being typed stays when something else about the line changes meanwhile.
    void setEditorData(QWidget* editor, const QModelIndex& index) const override
    {
        const auto* line = qobject_cast<QLineEdit*>(editor);
        if (!line || line->text().isEmpty())
            QStyledItemDelegate::setEditorData(editor, index);
    }

private:
    static constexpr int signRoom = 22; ///< pixels

    static void paintHeading(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index)
    {
        QFont font = option.font;
        font.setWeight(QFont::DemiBold);
        painter.save();
        painter.setFont(font);
        painter.setPen(option.palette.color(QPalette::Text));
        const QString title = index.data().toString();
        const QRect place = option.rect.adjusted(4, 0, -6, 0);
        painter.drawText(place, Qt::AlignVCenter | Qt::AlignLeft, title);
        painter.setFont(option.font);
        painter.setPen(mixed(option.palette.color(QPalette::Base), option.palette.color(QPalette::Text), 0.5));
        painter.drawText(place, Qt::AlignVCenter | Qt::AlignRight, QString::number(index.model()->rowCount(index)));
        painter.restore();
    }

    const Selection& m_selection;
};

/// Rows that follow one another are one range: a selection compares each of its ranges with all others.
QItemSelection rangesOf(std::vector<QModelIndex> rows)
{
    std::ranges::sort(rows, {}, [](const QModelIndex& row) { return std::pair(row.parent().row(), row.row()); });
    QItemSelection ranges;
    for (std::size_t from = 0, to = 0; from < rows.size(); from = to) {
        while (++to < rows.size() && rows[to].parent() == rows[from].parent() &&
               rows[to].row() == rows[to - 1].row() + 1) {
        }
        ranges.select(rows[from], rows[to - 1]);
    }
    return ranges;
}

} // namespace

ElementsView::ElementsView(Document& document, Selection& selection, ProblemSet& problems, QWidget* parent)
    : QWidget(parent)
    , m_selection(selection)
    , m_model(new ElementsModel(document, problems, this))
    , m_filter(new QSortFilterProxyModel(this))
    , m_tree(new QTreeView(this))
{
    m_filter->setSourceModel(m_model);
    m_filter->setRecursiveFilteringEnabled(true);
    m_filter->setFilterRole(ElementsModel::SearchRole);
    m_filter->setFilterCaseSensitivity(Qt::CaseInsensitive);
    buildTree();

    auto* search = m_search = new QLineEdit(this);
    search->setPlaceholderText(tr("Find an element"));
    search->setAccessibleName(search->placeholderText());
    search->setToolTip(tr("By its name, or by a word of its note"));
    m_tree->setAccessibleName(tr("Elements"));
    search->setClearButtonEnabled(true);
    search->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
    connect(search, &QLineEdit::textChanged, this, [this](const QString& text) {
        m_syncing = true; // what the search hides stays selected
        m_filter->setFilterFixedString(text);
        m_syncing = false;
        restoreExpanded();
        selectInTree();
    });

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    auto* top = new QVBoxLayout;
    top->setContentsMargins(6, 6, 6, 6);
    top->addWidget(search);
    layout->addLayout(top);
    layout->addWidget(m_tree);

    connect(&selection, &Selection::changed, this, &ElementsView::selectInTree);
    connect(&selection, &Selection::hoverChanged, m_tree->viewport(), qOverload<>(&QWidget::update));
}

void ElementsView::setHidden(std::set<ElementId> hidden)
{
    m_model->setHidden(std::move(hidden));
}

void ElementsView::buildTree()
{
    m_tree->setModel(m_filter);
    m_tree->setItemDelegate(new ElementDelegate(m_selection, m_tree));
    m_tree->setHeaderHidden(true);
    m_tree->setFrameShape(QFrame::NoFrame);
    m_tree->setIndentation(16);
    m_tree->setIconSize({16, 16});
    m_tree->setUniformRowHeights(true);
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    // There is one column. For rows, Qt's accessible action of a row would take its place in its group for its
    // place in the tree, and select another.
    m_tree->setSelectionBehavior(QAbstractItemView::SelectItems);
    m_tree->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_tree->setExpandsOnDoubleClick(false);
    m_tree->setMouseTracking(true);
    m_tree->setContextMenuPolicy(Qt::CustomContextMenu);
    m_tree->viewport()->installEventFilter(this);
    m_tree->installEventFilter(this);
    setFocusProxy(m_tree);

    connect(m_tree->selectionModel(), &QItemSelectionModel::selectionChanged, this, &ElementsView::selectFromTree);
    connect(m_tree, &QTreeView::entered, this, [this](const QModelIndex& index) {
        m_selection.hover(ElementId{index.data(ElementsModel::ElementRole).toInt()});
    });
    connect(m_tree, &QTreeView::customContextMenuRequested, this, &ElementsView::askForMenu);
    connect(m_tree, &QTreeView::doubleClicked, this, [this](const QModelIndex& index) {
        if (index.parent().isValid() && !(index.flags() & Qt::ItemIsEditable))
            emit shown(ElementId{index.data(ElementsModel::ElementRole).toInt()});
    });
    connect(m_tree, &QTreeView::collapsed, this, [this](const QModelIndex& index) {
        if (!m_syncing)
            m_collapsed.insert(index.data().toString());
    });
    connect(m_tree, &QTreeView::expanded, this, [this](const QModelIndex& index) {
        if (!m_syncing)
            m_collapsed.remove(index.data().toString());
    });
    // A list made anew stays where it was.
    connect(m_filter, &QAbstractItemModel::modelReset, this, [this] {
        const int scrolled = m_tree->verticalScrollBar()->value();
        restoreExpanded();
        selectInTree();
        m_tree->verticalScrollBar()->setValue(scrolled);
    });
    restoreExpanded();
}

/// The press of the right button has selected its row. By the key the place is that of the current row.
void ElementsView::askForMenu(const QPoint& at)
{
    const QModelIndex row = m_tree->indexAt(at);
    if (row.isValid() && row.parent().isValid() && !m_selection.elements().empty())
        emit contextMenuWanted(m_tree->viewport()->mapToGlobal(at));
}

void ElementsView::restoreExpanded()
{
    m_syncing = true;
    for (int row = 0; row < m_filter->rowCount(); ++row) {
        const QModelIndex group = m_filter->index(row, 0);
        m_tree->setExpanded(group, !m_collapsed.contains(group.data().toString()));
    }
    m_syncing = false;
}

QModelIndex ElementsView::indexOf(ElementId id) const
{
    return m_filter->mapFromSource(m_model->indexOf(id));
}

void ElementsView::selectInTree()
{
    if (m_syncing)
        return;
    m_syncing = true;
    std::vector<QModelIndex> rows;
    for (const ElementId id : m_selection.elements())
        if (const QModelIndex index = indexOf(id); index.isValid())
            rows.push_back(index);
    m_tree->selectionModel()->select(rangesOf(rows), QItemSelectionModel::ClearAndSelect);
    if (!rows.empty()) {
        const QModelIndex first = rows.front();
        m_tree->selectionModel()->setCurrentIndex(first, QItemSelectionModel::NoUpdate);
        if (m_tree->isExpanded(first.parent()))
            m_tree->scrollTo(first);
    }
    m_syncing = false;
}

void ElementsView::selectFromTree()
{
    if (m_syncing)
        return;
    m_syncing = true;
    Selection::Elements elements;
    for (const QModelIndex& index : m_tree->selectionModel()->selectedIndexes())
        elements.insert(ElementId{index.data(ElementsModel::ElementRole).toInt()});
    m_selection.set(std::move(elements));
    m_syncing = false;
}

void ElementsView::reveal(ElementId id)
{
    if (const QModelIndex index = indexOf(id); index.isValid())
        m_tree->expand(index.parent());
    m_selection.set({id});
}

void ElementsView::scrollToTop()
{
    m_search->clear(); // what was looked for was in the other one
    m_tree->scrollToTop();
}

void ElementsView::rename(ElementId id)
{
    reveal(id);
    const QModelIndex index = indexOf(id);
    if (index.flags() & Qt::ItemIsEditable)
        m_tree->edit(index);
}

void ElementsView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        m_model->recolor();
}

bool ElementsView::eventFilter(QObject* watched, QEvent* event)
{
    if (watched != m_tree && event->type() == QEvent::Leave)
        m_selection.hover(noElement);
    // A line in which a name is edited passes Enter on, but has done with it.
    if (watched == m_tree && m_tree->hasFocus() && event->type() == QEvent::KeyPress &&
        !m_selection.elements().empty()) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            emit propertiesWanted();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace bolster
