#include "SpotsPanel.h"

#include "Commands.h"
#include "Icons.h"
#include "ViewColors.h"

#include <QApplication>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace bolster {

namespace {

constexpr int colorRole = Qt::UserRole; // of the icon
constexpr QSize signSize(14, 14);

/// The list is filled with every step of a drag: what is there already stays.
void mark(QTreeWidgetItem& row, int column, const QColor& color, const QIcon& icon)
{
    if (row.data(column, colorRole) == QVariant(color))
        return;
    row.setData(column, colorRole, color);
    row.setIcon(column, icon);
}

/// Orange is lost on a selected row.
QIcon warningSign(const QColor& color, const QPalette& palette)
{
    const auto sign = [](const QColor& in) { return icon(QStringLiteral("warning"), in).pixmap(signSize); };
    QIcon result(sign(color));
    result.addPixmap(sign(palette.color(QPalette::HighlightedText)), QIcon::Selected);
    return result;
}

int rowHeight(const QWidget& table)
{
    return table.fontMetrics().height() + 7;
}

} // namespace

SpotsPanel::SpotsPanel(const MapLink& maps, Commands& commands, QWidget* parent)
    : QWidget(parent)
    , m_maps(maps)
    , m_list(new QWidget(this))
    , m_title(new QLabel(m_list))
    , m_summary(new QLabel(m_list))
    , m_table(new QTreeWidget(m_list))
    , m_hint(new QWidget(this))
    , m_advice(new QLabel(m_hint))
    , m_offer(new QPushButton(tr("Show the &largest strain"), m_hint))
{
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_title->setContentsMargins(8, 6, 8, 0);
    m_summary->setContentsMargins(8, 0, 8, 4);
    m_summary->setWordWrap(true);
    buildTable();
    buildHint(*commands["map.strain"]);
    auto* list = new QVBoxLayout(m_list);
    list->setContentsMargins(0, 0, 0, 0);
    list->setSpacing(0);
    list->addWidget(m_title);
    list->addWidget(m_summary);
    list->addWidget(m_table, 1);
    auto* pages = new QVBoxLayout(this);
    pages->setContentsMargins(0, 0, 0, 0);
    pages->addWidget(m_list);
    pages->addWidget(m_hint);
    m_list->hide();

    connect(&maps, &MapLink::measured, this, &SpotsPanel::fill);
    connect(m_table, &QTreeWidget::itemSelectionChanged, this, [this] {
        m_chosen.reset();
        for (QTreeWidgetItem* row : m_table->selectedItems())
            choose(*row);
    });
    // Once more: meanwhile the views may show another place.
    connect(m_table, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* row) { choose(*row); });
    connect(m_table, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* row) {
        row->setSelected(true);
        choose(*row);
    });
    fill();
}

void SpotsPanel::buildHint(QAction& strain)
{
    m_advice->setObjectName(QStringLiteral("spots-hint"));
    m_advice->setWordWrap(true);
    m_advice->setAlignment(Qt::AlignCenter);
    m_advice->setForegroundRole(QPalette::PlaceholderText);
    m_offer->setObjectName(QStringLiteral("show-strain"));
    connect(m_offer, &QPushButton::clicked, &strain, [&strain] { strain.setChecked(true); });

    auto* layout = new QVBoxLayout(m_hint);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(10);
    layout->addStretch();
    layout->addWidget(m_advice);
    layout->addWidget(m_offer, 0, Qt::AlignHCenter);
    layout->addStretch();
}

void SpotsPanel::buildTable()
{
    m_table->setObjectName(QStringLiteral("spots-table"));
    m_table->setAccessibleName(tr("Worst spots"));
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setRootIsDecorated(false);
    m_table->setUniformRowHeights(true);
    m_table->setAllColumnsShowFocus(true);
    m_table->setIconSize(signSize);
    m_table->setColumnCount(ColumnCount);
    m_table->setHeaderLabels({tr("Patch"), tr("Value"), tr("Limit")});
    QTreeWidgetItem& head = *m_table->headerItem();
    head.setToolTip(Value, tr("Negative where the fabric is pressed together"));
    head.setToolTip(Limit,
                    tr("What the fabric there may suffer. The spots are sorted by how much of it they take"));
    for (const Column column : {Value, Limit})
        head.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);

    QHeaderView* header = m_table->header();
    header->setSectionsMovable(false);
    header->setStretchLastSection(false);
    header->setSectionResizeMode(Where, QHeaderView::Stretch);
    const int digit = m_table->fontMetrics().horizontalAdvance(u'0');
    header->resizeSection(Value, 9 * digit);
    header->resizeSection(Limit, 8 * digit + 14 + 12); // with the sign of warning
}

QSize SpotsPanel::sizeHint() const
{
    constexpr int rows = 10; // with head and margins
    return {260, m_title->sizeHint().height() + m_summary->sizeHint().height() + rows * rowHeight(*m_table) + 4};
}

void SpotsPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        fill();
}

void SpotsPanel::fill()
{
    if (m_maps.measuring())
        return; // what is there stays until there is something new
    if (std::exchange(m_of, m_maps.kind()) != m_maps.kind())
        m_chosen.reset(); // of another map
    if (!m_maps.spots().empty()) {
        fillTable();
        showPage(*m_list);
        return;
    }
    const bool wanted = m_maps.kind() && MapLink::hasSpots(*m_maps.kind());
    m_advice->setText(wanted ? tr("As soon as there is a cover, its worst spots will be listed here.")
                             : tr("A map of strain or shear shows what the fabric suffers. Its worst spots will be "
                                  "listed here."));
    m_offer->setVisible(!wanted);
    m_chosen.reset();
    showPage(*m_hint);
}

void SpotsPanel::fillTable()
{
    const QSignalBlocker quiet(m_table);
    const std::vector<MapLink::Spot>& spots = m_maps.spots();
    const auto count = static_cast<int>(spots.size());
    const auto over = static_cast<int>(std::ranges::count_if(spots, &MapLink::Spot::over));
    m_title->setText(m_maps.map()->title);
    m_summary->setText(over == 0 ? tr("Nothing is over the limit of its fabric.")
                                 : tr("Over the limit of the fabric: %1 of %2").arg(over).arg(count));
    while (m_table->topLevelItemCount() > count)
        delete m_table->takeTopLevelItem(m_table->topLevelItemCount() - 1);
    while (m_table->topLevelItemCount() < count)
        m_table->addTopLevelItem(new QTreeWidgetItem);
    for (int i = 0; i < count; ++i)
        fillRow(*m_table->topLevelItem(i), spots[static_cast<std::size_t>(i)]);
    reselect();
}

void SpotsPanel::fillRow(QTreeWidgetItem& row, const MapLink::Spot& spot)
{
    const ShownMap& map = *m_maps.map();
    const MapScale scale{map.kind, map.limit};
    const auto [r, g, b, a] = scale.color(static_cast<float>(spot.value), static_cast<float>(spot.allowed));
    const QColor color(r, g, b);
    mark(row, Where, color, colorSpot(color));
    const QColor warning = spot.over() ? ViewColors::of(palette()).warning : QColor();
    mark(row, Limit, warning, spot.over() ? warningSign(warning, palette()) : QIcon());
    row.setText(Value, m_maps.figure(spot.value));
    row.setText(Limit, m_maps.figure(spot.allowed));
    row.setText(Where, spot.patch);
    QFont font = m_table->font();
    font.setBold(spot.over());
    row.setFont(Value, font);
    row.setSizeHint(Where, {0, rowHeight(*m_table)});
    for (const Column column : {Value, Limit})
        row.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    for (int column = 0; column < ColumnCount; ++column)
        row.setToolTip(column, spot.text);
    row.setData(Limit, Qt::AccessibleTextRole,
                spot.over() ? tr("over the limit of %1").arg(row.text(Limit)) : row.text(Limit));
}

/// The spot that is nearest to where the selected one was: while the cover changes, spots move and change places.
void SpotsPanel::reselect()
{
    if (!m_chosen) {
        m_table->clearSelection();
        return;
    }
    const std::vector<MapLink::Spot>& spots = m_maps.spots();
    const auto distance = [this](const MapLink::Spot& spot) {
        return spot.place.patch == m_chosen->patch ? (spot.place.outline - m_chosen->outline).norm() : 1e30;
    };
    const auto nearest = std::ranges::min_element(spots, {}, distance);
    if (distance(*nearest) > MapLink::apart) {
        m_table->clearSelection(); // it may come back
        return;
    }
    m_chosen = nearest->place;
    QTreeWidgetItem* row = m_table->topLevelItem(static_cast<int>(nearest - spots.begin()));
    if (!row->isSelected())
        m_table->setCurrentItem(row);
}

/// Whoever has the keyboard here keeps it.
void SpotsPanel::showPage(QWidget& page)
{
    const QWidget* focus = QApplication::focusWidget();
    const bool focused = focus && (focus == this || isAncestorOf(focus));
    QWidget* first = m_table;
    if (&page == m_hint && m_offer->isVisibleTo(m_hint))
        first = m_offer;
    else if (&page == m_hint)
        first = m_advice;
    page.show();
    setFocusProxy(first);
    if (focused && focus != first)
        first->setFocus();
    (&page == m_list ? m_hint : m_list)->hide();
}

void SpotsPanel::choose(QTreeWidgetItem& row)
{
    const auto index = static_cast<std::size_t>(m_table->indexOfTopLevelItem(&row));
    if (index >= m_maps.spots().size())
        return; // another map is being measured
    m_chosen = m_maps.spots()[index].place;
    emit chosen(*m_chosen);
}

} // namespace bolster
