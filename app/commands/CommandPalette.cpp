#include "CommandPalette.h"

#include "Commands.h"
#include "Icons.h"
#include "ViewColors.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMainWindow>
#include <QMenuBar>
#include <QPainter>
#include <QSettings>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include <algorithm>

namespace bolster {

namespace {

const QString recentCommandsKey = QStringLiteral("palette/recent");
constexpr int mostRecentCommands = 12;
// Pixels.
constexpr int paletteWidth = 600;
constexpr int commandRowHeight = 30;
constexpr int mostRows = 12;

enum Role { PathRole = Qt::UserRole, KeysRole, EnabledRole };

QString idOf(const QAction& action)
{
    return action.objectName().isEmpty() ? action.text() : action.objectName();
}

/// Sign, text, the menu it is in, and its keys at the right.
class CommandDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override
    {
        return {option.rect.width(), std::max(commandRowHeight, option.fontMetrics.height() + 10)};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        const QPalette& palette = option.palette;
        const bool chosen = option.state & QStyle::State_Selected;
        const bool enabled = index.data(EnabledRole).toBool();
        const QColor base = palette.color(chosen ? QPalette::Highlight : QPalette::Base);
        const QColor text = palette.color(chosen ? QPalette::HighlightedText : QPalette::Text);
        painter->save();
        if (chosen)
            painter->fillRect(option.rect, base);
        QRect place = option.rect.adjusted(10, 0, -12, 0);
        index.data(Qt::DecorationRole)
            .value<QIcon>()
            .paint(painter, QRect(place.left(), place.center().y() - 8, 17, 17), Qt::AlignCenter,
                   enabled ? QIcon::Normal : QIcon::Disabled);
        place.setLeft(place.left() + 28);
        const QString keys = index.data(KeysRole).toString();
        const QColor muted = mixed(base, text, chosen ? 0.75 : 0.55);
        painter->setPen(muted);
        painter->drawText(place, Qt::AlignVCenter | Qt::AlignRight, keys);
        if (!keys.isEmpty())
            place.setRight(place.right() - option.fontMetrics.horizontalAdvance(keys) - 16);
        painter->setPen(enabled ? text : mixed(base, text, 0.4));
        const QString title = option.fontMetrics.elidedText(index.data().toString(), Qt::ElideRight, place.width());
        painter->drawText(place, Qt::AlignVCenter | Qt::AlignLeft, title);
        place.setLeft(place.left() + option.fontMetrics.horizontalAdvance(title) + 12);
        painter->setPen(muted);
        painter->drawText(
            place, Qt::AlignVCenter | Qt::AlignLeft,
            option.fontMetrics.elidedText(index.data(PathRole).toString(), Qt::ElideRight, place.width()));
        painter->restore();
    }
};

} // namespace

CommandPalette::CommandPalette(QMainWindow& window)
    : QFrame(&window)
    , m_window(window)
    , m_field(new QLineEdit(this))
    , m_list(new QListWidget(this))
{
    setObjectName(QStringLiteral("commandPalette"));
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    m_field->setPlaceholderText(tr("Find a command"));
    m_field->setAccessibleName(m_field->placeholderText());
    m_field->setClearButtonEnabled(true);
    m_field->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
    m_field->setMinimumHeight(32);
    m_list->setAccessibleName(tr("Commands"));
    m_list->setItemDelegate(new CommandDelegate(m_list));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setUniformItemSizes(true);
    setFocusProxy(m_field);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addWidget(m_field);
    layout->addWidget(m_list);
    hide();

    connect(m_field, &QLineEdit::textChanged, this, &CommandPalette::filter);
    connect(m_list, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) { run(m_list->row(item)); });
    m_field->installEventFilter(this);
    window.installEventFilter(this);
}

void CommandPalette::open()
{
    if (isVisible())
        return;
    const QStringList recent = QSettings().value(recentCommandsKey).toStringList();
    const auto rank = [&recent](const MenuEntry& command) {
        const qsizetype place = recent.indexOf(idOf(*command.action));
        const qsizetype found = place < 0 ? recent.indexOf(Commands::formerId(*command.action)) : place;
        return found < 0 ? recent.size() : found;
    };
    m_commands = commandsOf(*m_window.menuBar());
    std::ranges::stable_sort(m_commands, {}, rank);
    m_focusBefore = QApplication::focusWidget();
    m_field->clear();
    filter();
    place();
    raise();
    show();
    m_field->setFocus(Qt::PopupFocusReason);
    qApp->installEventFilter(this); // a click elsewhere
}

void CommandPalette::close(bool giveFocusBack)
{
    qApp->removeEventFilter(this);
    hide();
    if (giveFocusBack && m_focusBefore)
        m_focusBefore->setFocus();
    else if (m_window.focusWidget() == m_field)
        m_field->clearFocus();
}

void CommandPalette::place()
{
    const int rows = std::clamp(static_cast<int>(m_shown.size()), 1, mostRows);
    const int row = m_list->count() > 0 ? m_list->sizeHintForRow(0) : commandRowHeight;
    m_list->setFixedHeight(rows * row + 2);
    layout()->activate();
    const int width = std::min(paletteWidth, m_window.width() - 24);
    const int top = m_window.menuBar()->geometry().bottom() + 24;
    const int height = std::min(sizeHint().height(), std::max(80, m_window.height() - top - 12));
    setGeometry((m_window.width() - width) / 2, top, width, height);
}

void CommandPalette::filter()
{
    QList<std::pair<int, MenuEntry>> found;
    for (const MenuEntry& command : m_commands)
        if (const int score = matchScore(m_field->text(), command); command.action && score > 0)
            found.append({score, command});
    std::ranges::stable_sort(found, std::greater(), [](const auto& entry) { return entry.first; });
    m_shown.clear();
    m_list->clear();
    for (const auto& [score, command] : found) {
        auto* item = new QListWidgetItem(command.action->icon(), command.text, m_list);
        item->setData(PathRole, command.path);
        item->setData(KeysRole, command.action->shortcut().toString(QKeySequence::NativeText));
        item->setData(EnabledRole, command.action->isEnabled());
        m_shown.append(command);
    }
    if (m_shown.isEmpty()) {
        auto* none = new QListWidgetItem(tr("There is no such command."), m_list);
        none->setFlags(Qt::NoItemFlags);
    } else {
        m_list->setCurrentRow(0);
    }
    place();
}

void CommandPalette::run(int row)
{
    if (row < 0 || row >= m_shown.size() || !m_shown[row].action || !m_shown[row].action->isEnabled())
        return;
    const QPointer<QAction> action = m_shown[row].action;
    QStringList recent = QSettings().value(recentCommandsKey).toStringList();
    recent.removeAll(idOf(*action));
    recent.removeAll(Commands::formerId(*action));
    recent.prepend(idOf(*action));
    QSettings().setValue(recentCommandsKey, QStringList(recent.mid(0, mostRecentCommands)));
    close(true);
    action->trigger();
}

bool CommandPalette::handleKey(int key)
{
    const int last = static_cast<int>(m_shown.size()) - 1;
    const int row = m_list->currentRow();
    switch (key) {
    case Qt::Key_Escape:
        close(true);
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        run(row);
        return true;
    case Qt::Key_Up:
        m_list->setCurrentRow(row <= 0 ? last : row - 1);
        return true;
    case Qt::Key_Down:
        m_list->setCurrentRow(row >= last ? 0 : row + 1);
        return true;
    case Qt::Key_PageUp:
        m_list->setCurrentRow(std::max(0, row - mostRows));
        return true;
    case Qt::Key_PageDown:
        m_list->setCurrentRow(std::min(last, row + mostRows));
        return true;
    default:
        return false;
    }
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event)
{
    if (!isVisible())
        return QFrame::eventFilter(watched, event);
    if (watched == &m_window && event->type() == QEvent::Resize)
        place();
    if (watched == m_field && event->type() == QEvent::KeyPress)
        return handleKey(static_cast<QKeyEvent*>(event)->key());
    if (watched == m_field && event->type() == QEvent::ShortcutOverride &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape)
        event->accept();
    if (event->type() == QEvent::MouseButtonPress)
        if (const auto* widget = qobject_cast<QWidget*>(watched); widget && widget != this && !isAncestorOf(widget))
            close(false);
    return QFrame::eventFilter(watched, event);
}

} // namespace bolster
