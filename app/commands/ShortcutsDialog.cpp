#include "ShortcutsDialog.h"

#include "Commands.h"
#include "Icons.h"
#include "Shortcuts.h"
#include "ViewColors.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStyle>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace bolster {

namespace {

constexpr int actionRole = Qt::UserRole; // void*, null for menus

QAction* actionOf(const QTreeWidgetItem* item)
{
    return item ? static_cast<QAction*>(item->data(0, actionRole).value<void*>()) : nullptr;
}

QString textOf(const QAction& action)
{
    return QKeySequence::listToString(action.shortcuts(), QKeySequence::NativeText).replace(u';', u',');
}

} // namespace

ShortcutsDialog::ShortcutsDialog(Shortcuts& shortcuts, const QList<MenuEntry>& commands, QWidget* parent)
    : QDialog(parent)
    , m_shortcuts(shortcuts)
    , m_search(new QLineEdit(this))
    , m_tree(new QTreeWidget(this))
    , m_name(new QLabel(this))
    , m_keys(new QKeySequenceEdit(this))
    , m_clear(new QPushButton(tr("&No keys"), this))
    , m_reset(new QPushButton(tr("&Reset"), this))
    , m_note(new QLabel(this))
    , m_takeOver(new QPushButton(tr("&Take them over"), this))
{
    setWindowTitle(tr("Shortcuts"));
    build();
    fill(commands);
    connect(m_search, &QLineEdit::textChanged, this, &ShortcutsDialog::filter);
    connect(m_tree, &QTreeWidget::currentItemChanged, this, &ShortcutsDialog::showCurrent);
    connect(m_tree, &QTreeWidget::itemActivated, m_keys, [this] { m_keys->setFocus(); });
    connect(m_keys, &QKeySequenceEdit::keySequenceChanged, this, &ShortcutsDialog::propose);
    connect(m_clear, &QPushButton::clicked, this, [this] {
        m_shortcuts.set(*current(), {});
        showAllKeys();
    });
    connect(m_reset, &QPushButton::clicked, this, [this] {
        m_shortcuts.reset(*current());
        showAllKeys();
    });
    connect(m_takeOver, &QPushButton::clicked, this, [this] {
        m_shortcuts.takeOver(*current(), m_keys->keySequence());
        showAllKeys();
    });
    showCurrent();
    m_search->setFocus();
}

void ShortcutsDialog::build()
{
    m_search->setPlaceholderText(tr("Find a command or a key"));
    m_search->setAccessibleName(m_search->placeholderText());
    m_tree->setAccessibleName(tr("Commands"));
    m_keys->setAccessibleName(tr("Keys"));
    if (auto* typed = m_keys->findChild<QLineEdit*>())
        typed->setAccessibleName(m_keys->accessibleName());
    m_search->setClearButtonEnabled(true);
    m_search->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
    m_tree->setColumnCount(2);
    m_tree->setHeaderLabels({tr("Command"), tr("Keys")});
    m_tree->setUniformRowHeights(true);
    m_tree->setStyleSheet(QStringLiteral("QTreeWidget::item { padding: 3px 0; }"));
    m_tree->header()->setStretchLastSection(false);
    m_tree->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_tree->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_note->setWordWrap(true);
    m_note->setMinimumHeight(m_takeOver->sizeHint().height()); // nothing jumps
    m_keys->setObjectName(QStringLiteral("keys"));

    auto* choice = new QHBoxLayout;
    m_keys->setMinimumWidth(m_keys->fontMetrics().horizontalAdvance(QStringLiteral("0")) * 30);
    choice->addWidget(m_name, 1);
    choice->addWidget(m_keys);
    choice->addWidget(m_clear);
    choice->addWidget(m_reset);
    auto* told = new QHBoxLayout;
    told->addWidget(m_note, 1);
    told->addWidget(m_takeOver);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    QPushButton* all = buttons->addButton(tr("Reset &all"), QDialogButtonBox::ResetRole);
    connect(all, &QPushButton::clicked, this, [this] {
        m_shortcuts.resetAll();
        showAllKeys();
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    for (QPushButton* button : findChildren<QPushButton*>())
        button->setAutoDefault(false); // Enter in the search is no answer

    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_search);
    layout->addWidget(m_tree, 1);
    layout->addLayout(choice);
    layout->addLayout(told);
    layout->addWidget(buttons);
    resize(620, 620);
}

void ShortcutsDialog::fill(const QList<MenuEntry>& commands)
{
    QPixmap nothing(m_tree->style()->pixelMetric(QStyle::PM_SmallIconSize), 1); // texts stand below each other
    nothing.fill(Qt::transparent);
    const QIcon blank(nothing);
    QHash<QString, QTreeWidgetItem*> menus;
    for (const MenuEntry& command : commands) {
        if (!m_shortcuts.actions().contains(command.action))
            continue;
        QTreeWidgetItem*& menu = menus[command.path];
        if (!menu) {
            menu = new QTreeWidgetItem(m_tree, {command.path});
            menu->setFlags(Qt::ItemIsEnabled);
            menu->setExpanded(true);
        }
        auto* item = new QTreeWidgetItem(menu, {Commands::plainText(*command.action)});
        item->setIcon(0, command.action->icon().isNull() ? blank : command.action->icon());
        item->setData(0, actionRole, QVariant::fromValue(static_cast<void*>(command.action.data())));
        showKeys(item);
    }
}

/// What has the words themselves; only where nothing has, what has their letters.
void ShortcutsDialog::filter(const QString& text)
{
    constexpr int letters = 10; // of matchScore
    const auto score = [&](const QTreeWidgetItem* menu, QTreeWidgetItem* item) {
        return matchScore(text, {actionOf(item), item->text(0), menu->text(0)});
    };
    int best = 0;
    for (int m = 0; m < m_tree->topLevelItemCount(); ++m)
        for (int i = 0; i < m_tree->topLevelItem(m)->childCount(); ++i)
            best = std::max(best, score(m_tree->topLevelItem(m), m_tree->topLevelItem(m)->child(i)));
    const int least = best > letters + 1 ? letters + 2 : 1;
    for (int m = 0; m < m_tree->topLevelItemCount(); ++m) {
        QTreeWidgetItem* menu = m_tree->topLevelItem(m);
        bool any = false;
        for (int i = 0; i < menu->childCount(); ++i) {
            QTreeWidgetItem* item = menu->child(i);
            const bool found =
                score(menu, item) >= least || item->text(1).contains(text.trimmed(), Qt::CaseInsensitive);
            item->setHidden(!found);
            any = any || found;
        }
        menu->setHidden(!any);
    }
}

/// Bold where they are the user's own.
void ShortcutsDialog::showKeys(QTreeWidgetItem* item)
{
    const QAction& action = *actionOf(item);
    item->setText(1, textOf(action));
    QFont font = m_tree->font();
    font.setBold(m_shortcuts.changed(action));
    item->setFont(1, font);
}

void ShortcutsDialog::showAllKeys()
{
    for (int m = 0; m < m_tree->topLevelItemCount(); ++m)
        for (int i = 0; i < m_tree->topLevelItem(m)->childCount(); ++i)
            showKeys(m_tree->topLevelItem(m)->child(i));
    showCurrent();
}

QAction* ShortcutsDialog::current() const
{
    return actionOf(m_tree->currentItem());
}

void ShortcutsDialog::showCurrent()
{
    const QAction* action = current();
    m_name->setText(action ? m_tree->currentItem()->text(0) : QString());
    for (QWidget* widget : {static_cast<QWidget*>(m_keys), static_cast<QWidget*>(m_clear)})
        widget->setEnabled(action != nullptr);
    m_reset->setEnabled(action && m_shortcuts.changed(*action));
    const QSignalBlocker quiet(m_keys);
    m_keys->setKeySequence(action ? action->shortcut() : QKeySequence());
    note(action ? tr("Click into the field and press the keys.") : tr("Choose a command to change its keys."),
         false);
}

void ShortcutsDialog::note(const QString& text, bool offerTakeOver)
{
    QPalette colors = palette();
    const ViewColors views = ViewColors::of(colors);
    colors.setColor(QPalette::WindowText, offerTakeOver ? views.warning : views.mutedLabel);
    m_note->setPalette(colors);
    m_note->setText(text);
    m_takeOver->setVisible(offerTakeOver);
}

void ShortcutsDialog::propose(const QKeySequence& pressed)
{
    QAction* action = current();
    if (!action || pressed.isEmpty())
        return;
    const QKeySequence keys(pressed[static_cast<uint>(pressed.count() - 1)]); // the last one counts
    {
        const QSignalBlocker quiet(m_keys);
        m_keys->setKeySequence(keys);
    }
    const QString name = keys.toString(QKeySequence::NativeText);
    if (Shortcuts::reserved(keys)) {
        note(tr("%1 is needed by the views and fields themselves.").arg(name), false);
    } else if (const QAction* holder = m_shortcuts.holder(keys, *action)) {
        note(tr("%1 belongs to \u201c%2\u201d.").arg(name, Commands::plainText(*holder)), true);
    } else {
        m_shortcuts.set(*action, keys);
        showKeys(m_tree->currentItem());
        m_reset->setEnabled(m_shortcuts.changed(*action));
        note(tr("%1 it is.").arg(name), false);
    }
}

} // namespace bolster
