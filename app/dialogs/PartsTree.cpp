#include "PartsTree.h"

#include <QHeaderView>
#include <QLocale>
#include <QTimer>

#include <set>

namespace bolster {

PartsTree::PartsTree(const std::vector<PartOutline>& parts, const std::vector<std::string>& unwanted,
                     QWidget* parent)
    : QTreeWidget(parent)
{
    setColumnCount(2);
    setHeaderLabels({tr("Part"), tr("Triangles")});
    setUniformRowHeights(true);
    setAccessibleName(tr("Parts"));
    std::vector<std::uint64_t> below(parts.size());
    for (std::size_t i = parts.size(); i-- > 0;) {
        below[i] += parts[i].triangles;
        if (parts[i].parent)
            below[*parts[i].parent] += below[i];
    }
    std::vector<QTreeWidgetItem*> items(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (below[i] == 0)
            continue;
        QTreeWidgetItem* const above = parts[i].parent ? items[*parts[i].parent] : invisibleRootItem();
        auto* const item = new QTreeWidgetItem(above);
        item->setText(0, QString::fromStdString(parts[i].name));
        if (parts[i].color) {
            QPixmap swatch(12, 12);
            swatch.fill(QColor::fromRgb(*parts[i].color));
            item->setIcon(0, swatch);
        }
        item->setText(1, QLocale().toString(static_cast<qulonglong>(below[i])));
        item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        item->setFlags(item->flags() | Qt::ItemIsUserCheckable | Qt::ItemIsAutoTristate);
        items[i] = item;
        if (parts[i].triangles > 0)
            m_items.emplace_back(item, parts[i].name);
    }
    const std::set<std::string> left(unwanted.begin(), unwanted.end()); // there may be 100,000
    for (const auto& [item, name] : m_items)
        item->setCheckState(0, left.contains(name) ? Qt::Unchecked : Qt::Checked);
    expandToDepth(1);
    header()->setSectionResizeMode(0, QHeaderView::Stretch);
    header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    header()->setStretchLastSection(false);
    auto* const once = new QTimer(this); // a check of a group is one of everything in it
    once->setSingleShot(true);
    once->setInterval(0);
    connect(once, &QTimer::timeout, this, &PartsTree::changed);
    connect(this, &QTreeWidget::itemChanged, once, qOverload<>(&QTimer::start));
}

/// A part that has parts of its own is half checked when some of them are: it has been taken itself.
std::vector<std::string> PartsTree::unwanted() const
{
    std::vector<std::string> names;
    for (const auto& [item, name] : m_items)
        if (item->checkState(0) == Qt::Unchecked)
            names.push_back(name);
    return names;
}

} // namespace bolster
