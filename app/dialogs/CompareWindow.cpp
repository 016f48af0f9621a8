#include "CompareWindow.h"

#include "Background.h"
#include "CoverView.h"
#include "ElementText.h"
#include "FabricLink.h"
#include "FieldText.h"
#include "PatternView.h"
#include "SolverLink.h"
#include "Translated.h"
#include "VersionEdits.h"
#include "VersionPane.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace bolster {

namespace {

constexpr int elementRole = Qt::UserRole;
constexpr int columnGap = 32; // pixels

} // namespace

CompareWindow::CompareWindow(Document& document, FilesOf filesOf, FabricLink& fabrics, SolverLink& solver,
                             QWidget* parent)
    : QWidget(parent, Qt::Window)
    , m_document(document)
    , m_filesOf(std::move(filesOf))
    , m_fabrics(fabrics)
    , m_left(new VersionPane(solver.kept()))
    , m_right(new VersionPane)
    , m_list(new QTreeWidget)
    , m_take(new QPushButton(tr("&Take from there")))
    , m_together(new QCheckBox(tr("&Move both together")))
{
    setWindowTitle(tr("Compare versions"));
    setAttribute(Qt::WA_DeleteOnClose);
    connect(new QShortcut(QKeySequence(Qt::Key_Escape), this), &QShortcut::activated, this, &QWidget::close);
    m_right->follow(solver);
    connect(&fabrics, &FabricLink::changed, this, [this] { m_right->setFabrics(m_fabrics.maps()); });
    m_list->setHeaderLabels({tr("What differs"), tr("There"), tr("Now")});
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setAlternatingRowColors(true);
    m_list->setFrameShape(QFrame::NoFrame);
    m_take->setToolTip(tr("Makes the chosen elements as they are in the other version: one step in the history"));
    m_together->setChecked(true);
    m_together->setToolTip(tr("Turning, moving or zooming one version does the same to the other"));
    layOut();
    tieViews(*m_left, *m_right);
    tieViews(*m_right, *m_left);
    for (VersionPane* pane : {m_left, m_right})
        connect(pane, &VersionPane::coverCame, this, [this] {
            if (!m_together->isChecked())
                return;
            m_left->fitCover(m_right->box());
            m_right->fitCover(m_left->box());
        });
    connect(m_list, &QTreeWidget::itemSelectionChanged, this, &CompareWindow::selectionChanged);
    connect(m_take, &QPushButton::clicked, this, &CompareWindow::takeChosen);
    connect(&document, &Document::historyChanged, this, [this] {
        if (isVisible())
            refresh();
    });
}

void CompareWindow::layOut()
{
    auto* panes = new QSplitter(Qt::Horizontal);
    panes->addWidget(m_left);
    panes->addWidget(m_right);
    auto* below = new QWidget;
    auto* buttons = new QHBoxLayout;
    buttons->setContentsMargins(8, 6, 8, 8);
    buttons->addWidget(m_together);
    buttons->addStretch();
    buttons->addWidget(m_take);
    auto* lower = new QVBoxLayout(below);
    lower->setContentsMargins(0, 0, 0, 0);
    lower->addWidget(m_list);
    lower->addLayout(buttons);
    auto* parts = new QSplitter(Qt::Vertical);
    parts->addWidget(panes);
    parts->addWidget(below);
    parts->setSizes({640, 220});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(parts);
    resize(1200, 860);
}

void CompareWindow::tieViews(VersionPane& moved, VersionPane& other)
{
    const auto follow = [this](const auto& move) {
        if (m_following || !m_together->isChecked())
            return;
        m_following = true;
        move();
        m_following = false;
    };
    connect(&moved.coverView().navigation(), &CoverNavigation::moved, this, [follow, &other](const Camera& camera) {
        follow([&] { other.coverView().navigation().setCamera(camera); });
    });
    connect(&moved.pattern().navigation(), &PatternNavigation::transformChanged, this,
            [follow, &other](const PatternTransform& transform) {
                follow([&] { other.pattern().navigation().setTransform(transform); });
            });
}

bool CompareWindow::compareWith(NodeId node)
{
    const std::optional<Design> other = m_document.history().designAt(node, m_document.committed());
    if (!other)
        return false;
    m_original = *other;
    m_title = titleOf(node);
    showOther(numberedApart(m_document.committed(), m_original));
    refresh();
    bakeFabrics();
    return true;
}

/// Those of the other version may look otherwise, or not be there any more.
void CompareWindow::bakeFabrics()
{
    using Maps = std::map<ElementId, FabricMapsPtr>;
    m_left->setFabrics({});
    inBackground<Maps>([bake = m_fabrics.baker(), other = m_other] {
        Maps maps;
        other.each<Fabric>([&](ElementId id, const Fabric& fabric) { maps[id] = bake(id, fabric); });
        return maps;
    }).then(this, [this, other = m_other](const Maps& maps) {
        if (other == m_other)
            m_left->setFabrics(maps);
    });
}

QString CompareWindow::titleOf(NodeId node) const
{
    const History::Node& version = m_document.history().node(node);
    const QString when = QLocale().toString(version.time.toLocalTime(), QLocale::ShortFormat);
    const QString what = !version.name.empty()       ? QString::fromStdString(version.name)
                         : version.edit.verb.empty() ? tr("Start")
                                                     : translated(version.edit.verb);
    return tr("%1, %2").arg(what, when);
}

void CompareWindow::showOther(Design apart)
{
    m_other = std::move(apart);
    m_left->setVersion(m_title, m_other, m_filesOf(m_other));
}

void CompareWindow::refresh()
{
    if (Design apart = numberedApart(m_document.committed(), m_original); !(apart == m_other))
        showOther(std::move(apart));
    m_right->setVersion(tr("Now"), m_document.committed(), m_filesOf(m_document.committed()));
    m_right->setFabrics(m_fabrics.maps());
    fillList();
    selectionChanged();
}

void CompareWindow::updateFiles()
{
    if (!isVisible())
        return;
    m_left->setFiles(m_filesOf(m_other));
    m_right->setFiles(m_filesOf(m_document.committed()));
}

void CompareWindow::fillList()
{
    m_list->clear();
    for (const Difference& difference : differencesBetween(m_other, m_document.committed())) {
        const Design& named = difference.kind == Difference::Kind::Removed ? m_other : m_document.committed();
        auto* item = new QTreeWidgetItem(m_list, {displayName(named, difference.element)});
        item->setData(0, elementRole, static_cast<int>(difference.element));
        if (difference.kind == Difference::Kind::Added)
            item->setText(2, tr("only now"));
        else if (difference.kind == Difference::Kind::Removed)
            item->setText(1, tr("only there"));
        const ElementPtr element = named.element(difference.element);
        for (const Difference::Field& field : difference.fields) {
            auto* child = new QTreeWidgetItem(
                item, {fieldText(*element, field.key), fieldValueText(m_other, *element, field.key, field.before),
                       fieldValueText(m_document.committed(), *element, field.key, field.after)});
            child->setData(0, elementRole, static_cast<int>(difference.element));
        }
    }
    if (m_list->topLevelItemCount() == 0)
        new QTreeWidgetItem(m_list, {tr("Nothing differs")});
    m_list->expandAll();
    m_list->header()->resizeSections(QHeaderView::ResizeToContents);
    for (int column = 0; column < m_list->columnCount(); ++column)
        m_list->header()->resizeSection(column, m_list->header()->sectionSize(column) + columnGap);
}

std::set<ElementId> CompareWindow::chosen() const
{
    std::set<ElementId> ids;
    for (const QTreeWidgetItem* item : m_list->selectedItems())
        if (const QVariant id = item->data(0, elementRole); id.isValid())
            ids.insert(static_cast<ElementId>(id.toInt()));
    return ids;
}

/// Elements are taken whole: whoever chooses one of their values sees what goes with it.
void CompareWindow::chooseWhole()
{
    const QSignalBlocker quiet(m_list);
    for (const QTreeWidgetItem* item : m_list->selectedItems())
        if (QTreeWidgetItem* whole = item->parent())
            whole->setSelected(true);
    for (int row = 0; row < m_list->topLevelItemCount(); ++row)
        for (int child = 0; child < m_list->topLevelItem(row)->childCount(); ++child)
            m_list->topLevelItem(row)->child(child)->setSelected(m_list->topLevelItem(row)->isSelected());
    m_list->viewport()->update();
}

void CompareWindow::selectionChanged()
{
    chooseWhole();
    const std::set<ElementId> ids = chosen();
    m_take->setEnabled(!ids.empty());
    for (VersionPane* pane : {m_left, m_right}) {
        std::set<ElementId> there;
        for (const ElementId id : ids)
            if (id != settingsId && pane->design().element(id))
                there.insert(id);
        pane->selection().set(there);
    }
}

void CompareWindow::takeChosen()
{
    m_document.commit(edits::takeFrom(m_document.committed(), m_other, chosen()));
}

} // namespace bolster
