#include "FabricPanel.h"

#include "ColourwayEdits.h"
#include "Commands.h"
#include "ElementText.h"
#include "FabricLink.h"
#include "Icons.h"
#include "Selection.h"
#include "Translated.h"

#include <QAbstractItemView>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QMimeData>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

namespace bolster {

namespace {

constexpr int idRole = Qt::UserRole;
constexpr int pictureRole = Qt::UserRole + 1; // what the icon shows
constexpr int pictureSize = 84;

/// Its items can be dragged as fabrics.
class FabricList : public QListWidget {
public:
    using QListWidget::QListWidget;

    QMimeData* mimeData(const QList<QListWidgetItem*>& items) const override
    {
        if (items.isEmpty())
            return nullptr;
        auto* carried = new QMimeData;
        carried->setData(FabricPanel::mimeType(), QByteArray::number(items.front()->data(idRole).toInt()));
        return carried;
    }
};

ElementId idOf(const QListWidgetItem* item)
{
    return item ? static_cast<ElementId>(item->data(idRole).toInt()) : noElement;
}

QLabel* heading(const QString& text)
{
    auto* label = new QLabel(text);
    QFont bold = label->font();
    bold.setBold(true);
    label->setFont(bold);
    label->setContentsMargins(8, 6, 8, 2);
    return label;
}

/// With a switch between some actions, of which their icons say enough.
QWidget* headingWith(const QString& text, const QList<QAction*>& actions)
{
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 4, 6, 0);
    layout->setSpacing(0);
    QLabel* label = heading(text);
    label->setContentsMargins(8, 0, 8, 0);
    layout->addWidget(label, 1);
    for (QAction* action : actions) {
        auto* button = new QToolButton;
        button->setDefaultAction(action);
        button->setObjectName(action->objectName());
        button->setToolButtonStyle(Qt::ToolButtonIconOnly);
        button->setIconSize({16, 16});
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus);
        layout->addWidget(button);
    }
    return row;
}

/// The actions' own words are too long for a narrow dock.
QWidget* buttons(const QList<std::pair<QAction*, QString>>& actions)
{
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(6, 2, 6, 6);
    layout->setSpacing(4);
    for (const auto& [action, text] : actions) {
        auto* button = new QToolButton;
        button->setText(text);
        const auto follow = [button, action = action] {
            button->setEnabled(action->isEnabled());
            button->setToolTip(action->toolTip());
            button->setMenu(action->menu());
            button->setPopupMode(action->menu() ? QToolButton::InstantPopup : QToolButton::DelayedPopup);
            if (action->menu() && button->minimumWidth() == 0)
                button->setMinimumWidth(button->sizeHint().width() + 14); // room for the arrow beside the word
        };
        follow();
        QObject::connect(action, &QAction::changed, button, follow);
        QObject::connect(button, &QToolButton::clicked, action, &QAction::trigger);
        button->setFocusPolicy(Qt::TabFocus);
        layout->addWidget(button);
    }
    layout->addStretch();
    return row;
}

/// Until a fabric is baked, its colour.
QPixmap placeholder(const QColor& color)
{
    QPixmap pixmap(pictureSize, pictureSize);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawRoundedRect(pixmap.rect().adjusted(6, 6, -6, -6), 8, 8);
    return pixmap;
}

/// The list is filled with every step of a drag: a picture that is there already stays.
void setPicture(QListWidgetItem& item, const QImage& picture, const QColor& color)
{
    const QVariant shown = picture.isNull() ? QVariant(color) : QVariant(picture.cacheKey());
    if (item.data(pictureRole) == shown)
        return;
    item.setData(pictureRole, shown);
    const QPixmap pixmap = picture.isNull() ? placeholder(color) : QPixmap::fromImage(picture);
    QIcon shownAlways(pixmap);
    shownAlways.addPixmap(pixmap, QIcon::Selected); // in its own colours
    item.setIcon(shownAlways);
}

} // namespace

QString FabricPanel::mimeType()
{
    return QStringLiteral("application/x-bolster-fabric");
}

FabricPanel::FabricPanel(Document& document, Selection& selection, FabricLink& link, Commands& commands,
                         QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_selection(selection)
    , m_link(link)
    , m_commands(commands)
    , m_colourways(new QListWidget)
    , m_fabrics(new FabricList)
{
    m_colourways->setObjectName(QStringLiteral("colourways"));
    m_colourways->setAccessibleName(tr("Colourways"));
    m_colourways->setFrameShape(QFrame::NoFrame);
    m_colourways->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
    m_colourways->setMaximumHeight(130);
    m_colourways->setToolTip(tr("A click shows the cover in this colourway"));
    m_fabrics->setObjectName(QStringLiteral("fabrics"));
    m_fabrics->setAccessibleName(tr("Fabrics"));
    m_fabrics->setFrameShape(QFrame::NoFrame);
    m_fabrics->setViewMode(QListView::IconMode);
    m_fabrics->setIconSize({pictureSize, pictureSize});
    m_fabrics->setGridSize({pictureSize + 20, pictureSize + 40});
    m_fabrics->setResizeMode(QListView::Adjust);
    m_fabrics->setMovement(QListView::Static);
    m_fabrics->setWordWrap(true);
    m_fabrics->setDragEnabled(true);
    m_fabrics->setDragDropMode(QAbstractItemView::DragOnly);
    m_fabrics->setContextMenuPolicy(Qt::CustomContextMenu);
    setFocusProxy(m_fabrics);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(heading(tr("Colourway")));
    layout->addWidget(m_colourways);
    layout->addWidget(buttons({{commands["colourway.new"], tr("New \u2026")},
                               {commands["colourway.rename"], tr("Rename \u2026")},
                               {commands["colourway.delete"], tr("Delete")},
                               {commands["colourway.compare"], tr("Compare")}}));
    layout->addWidget(headingWith(tr("Fabrics: drag them onto patches"),
                                  {commands["fabric.on-cushions"], commands["fabric.on-balls"]}));
    layout->addWidget(m_fabrics, 1);
    layout->addWidget(buttons({{commands["fabric.new"], tr("New")},
                               {commands["fabric.assign"], tr("Assign")},
                               {commands["fabric.duplicate"], tr("Copy")},
                               {commands["fabric.delete"], tr("Delete \u2026")}}));

    connect(&document, &Document::changed, this, &FabricPanel::fill);
    connect(&link, &FabricLink::changed, this, &FabricPanel::fillFabrics);
    connect(commands["fabric.on-balls"], &QAction::toggled, this, &FabricPanel::fillFabrics);
    connect(&selection, &Selection::changed, this, &FabricPanel::followSelection);
    // Not the current item: a list that gets the focus makes its first one current, which nobody has chosen.
    connect(m_fabrics, &QListWidget::itemSelectionChanged, this, [this] { emit fabricChosen(fabric()); });
    connect(m_fabrics, &QListWidget::itemActivated, this,
            [this](const QListWidgetItem* item) { emit editWanted(idOf(item)); });
    connect(m_fabrics, &QWidget::customContextMenuRequested, this, &FabricPanel::showMenu);
    connect(m_colourways, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
        if (item)
            emit colourwayChosen(idOf(item));
    });
    fill();
}

ElementId FabricPanel::fabric() const
{
    const QList<QListWidgetItem*> chosen = m_fabrics->selectedItems();
    return chosen.isEmpty() ? noElement : idOf(chosen.front());
}

void FabricPanel::setFabric(ElementId fabric)
{
    for (int i = 0; i < m_fabrics->count(); ++i)
        if (idOf(m_fabrics->item(i)) == fabric)
            m_fabrics->setCurrentRow(i);
}

void FabricPanel::fill()
{
    fillColourways();
    fillFabrics();
}

void FabricPanel::fillColourways()
{
    const QSignalBlocker quiet(m_colourways);
    const Design& design = m_document.design();
    std::vector<std::pair<ElementId, QString>> entries{{noElement, tr("As made")}};
    design.each<Colourway>(
        [&](ElementId id, const Colourway&) { entries.emplace_back(id, displayName(design, id)); });
    while (m_colourways->count() > static_cast<int>(entries.size()))
        delete m_colourways->takeItem(m_colourways->count() - 1);
    while (m_colourways->count() < static_cast<int>(entries.size()))
        m_colourways->addItem(QString());
    for (int i = 0; i < m_colourways->count(); ++i) {
        const auto& [id, name] = entries[static_cast<std::size_t>(i)];
        QListWidgetItem* item = m_colourways->item(i);
        item->setData(idRole, static_cast<int>(id));
        item->setText(name);
        item->setIcon(icon(id == noElement ? QStringLiteral("patch") : QStringLiteral("colourway")));
        if (id == design.settings().colourway)
            m_colourways->setCurrentRow(i);
    }
}

void FabricPanel::fillFabrics()
{
    const Design& design = m_document.design();
    std::vector<ElementId> ids;
    design.each<Fabric>([&](ElementId id, const Fabric&) { ids.push_back(id); });
    const ElementId before = fabric();
    std::map<ElementId, FabricPictures> drawn = m_link.pictures();
    const QImage FabricPictures::*shape =
        m_commands["fabric.on-balls"]->isChecked() ? &FabricPictures::ball : &FabricPictures::cushion;
    {
        const QSignalBlocker quiet(m_fabrics);
        while (m_fabrics->count() > static_cast<int>(ids.size()))
            delete m_fabrics->takeItem(m_fabrics->count() - 1);
        while (m_fabrics->count() < static_cast<int>(ids.size()))
            m_fabrics->addItem(QString());
        for (int i = 0; i < m_fabrics->count(); ++i) {
            const ElementId id = ids[static_cast<std::size_t>(i)];
            QListWidgetItem* item = m_fabrics->item(i);
            item->setData(idRole, static_cast<int>(id));
            item->setText(displayName(design, id));
            item->setToolTip(describe(id));
            setPicture(*item, drawn[id].*shape, QColor(QString::fromStdString(design.find<Fabric>(id)->color)));
            if (id == before)
                m_fabrics->setCurrentRow(i);
        }
    }
    if (fabric() != before)
        emit fabricChosen(fabric());
}

QString FabricPanel::describe(ElementId fabric) const
{
    const auto patches = static_cast<int>(edits::patchesWith(m_document.design(), fabric).size());
    const QString use = patches == 0 ? tr("No patch has it.") : tr("%n patches have it.", nullptr, patches);
    for (const Problem& problem : m_link.problems())
        if (problem.element == fabric)
            return displayName(m_document.design(), fabric) + u'\n' + use + u'\n' + translated(problem.message);
    return displayName(m_document.design(), fabric) + u'\n' + use + u'\n' +
           tr("Drag it onto a patch; a double click shows its properties.");
}

/// A fabric that is chosen elsewhere is chosen here, too.
void FabricPanel::followSelection()
{
    const Selection::Elements& selected = m_selection.elements();
    if (selected.size() == 1 && m_document.design().find<Fabric>(*selected.begin()))
        setFabric(*selected.begin());
}

void FabricPanel::showMenu(const QPoint& at)
{
    if (!m_fabrics->itemAt(at))
        return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addActions({m_commands["fabric.assign"], m_commands["fabric.edit"], m_commands["fabric.picture"]});
    menu->addSeparator();
    menu->addActions({m_commands["fabric.duplicate"], m_commands["fabric.rename"], m_commands["fabric.delete"]});
    menu->addSeparator();
    menu->addAction(m_commands["fabric.export"]);
    menu->popup(m_fabrics->viewport()->mapToGlobal(at));
}

} // namespace bolster
