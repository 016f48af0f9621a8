#include "TourPanel.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMainWindow>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace bolster {

namespace {

constexpr int panelWidth = 22; // of the height of a line
constexpr int roomAround = 14; // pixels

} // namespace

TourPanel::TourPanel(QWidget* window)
    : QFrame(window)
    , m_count(new QLabel(this))
    , m_title(new QLabel(this))
    , m_text(new QLabel(this))
    , m_back(new QPushButton(tr("Back"), this))
    , m_next(new QPushButton(tr("Next"), this))
    , m_leave(new QPushButton(tr("Leave the tour"), this))
{
    setObjectName(QStringLiteral("tour"));
    setAccessibleName(tr("Tour"));
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::ToolTipBase);
    m_count->setForegroundRole(QPalette::PlaceholderText);
    QFont bold = m_title->font();
    bold.setWeight(QFont::DemiBold);
    bold.setPointSizeF(bold.pointSizeF() * 1.15);
    m_title->setFont(bold);
    for (QLabel* label : {m_title, m_text}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
    }
    m_next->setObjectName(QStringLiteral("tour-next"));
    m_leave->setObjectName(QStringLiteral("tour-leave"));
    m_leave->setToolTip(tr("Help > Tour goes on from here"));
    for (QPushButton* button : {m_next, m_back, m_leave})
        button->setAutoDefault(true); // Enter presses it
    connect(m_next, &QPushButton::clicked, this, &TourPanel::nextWanted);
    connect(m_back, &QPushButton::clicked, this, &TourPanel::backWanted);
    connect(m_leave, &QPushButton::clicked, this, &TourPanel::leaveWanted);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_leave);
    buttons->addStretch();
    buttons->addWidget(m_back);
    buttons->addWidget(m_next);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(14, 10, 14, 12);
    layout->addWidget(m_count);
    layout->addWidget(m_title);
    layout->addWidget(m_text);
    layout->addSpacing(4);
    layout->addLayout(buttons);
    qApp->installEventFilter(this);
    hide();
}

void TourPanel::say(int step, int steps, const QString& title, const QString& text)
{
    m_count->setText(tr("Tour, %1 of %2").arg(step).arg(steps));
    m_title->setText(title);
    m_text->setText(text);
    m_back->setVisible(step > 1);
    m_next->setText(step < steps ? tr("Next") : tr("Finish"));
    m_next->setDefault(false);
    m_leave->setVisible(true);
    fit();
    if (step == 1)
        m_next->setFocus(Qt::OtherFocusReason); // nobody works at anything yet
}

void TourPanel::praise(const QString& text)
{
    m_text->setText(text);
    m_next->setDefault(true);
    fit();
}

void TourPanel::sayTheEnd(const QString& title, const QString& text)
{
    m_count->setText(tr("Tour"));
    m_title->setText(title);
    m_text->setText(text);
    m_back->hide();
    m_leave->hide();
    m_next->setText(tr("Close"));
    fit();
}

QString TourPanel::title() const
{
    return m_title->text();
}

void TourPanel::fit()
{
    const int wide = std::min(panelWidth * fontMetrics().height(), parentWidget()->width() - 2 * roomAround);
    setFixedWidth(std::max(wide, layout()->minimumSize().width()));
    setFixedHeight(layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width()) : sizeHint().height());
    placeBeside(m_target);
    show();
    raise();
}

void TourPanel::placeBeside(const QRect& target)
{
    m_target = target;
    const QRect room = this->room();
    QPoint at(room.right() - width(), room.bottom() - height());
    const bool large = target.width() > room.width() / 3 && target.height() > room.height() / 3;
    if (large) // in its lower left corner: there is least of what one works at
        at = {target.left() + roomAround, target.bottom() - height() - roomAround};
    else if (!target.isEmpty() && target.bottom() + roomAround + height() <= room.bottom())
        at = {target.center().x() - width() / 2, target.bottom() + roomAround};
    else if (!target.isEmpty() && target.left() - roomAround - width() >= room.left())
        at = {target.left() - roomAround - width(), target.center().y() - height() / 2};
    at = {std::clamp(at.x(), room.left(), std::max(room.left(), room.right() - width())),
          std::clamp(at.y(), room.top(), std::max(room.top(), room.bottom() - height()))};
    move(besideMenus(at));
}

/// Of the window, below its menu bar.
QRect TourPanel::room() const
{
    QRect room = parentWidget()->rect();
    if (const auto* window = qobject_cast<QMainWindow*>(parentWidget()))
        if (const QWidget* bar = window->menuWidget(); bar && bar->isVisible())
            room.setTop(bar->geometry().bottom());
    return room.adjusted(roomAround, roomAround, -roomAround, -roomAround);
}

/// The same place unless a menu that is open would cover it: then at the right of all of them, or at the left.
QPoint TourPanel::besideMenus(QPoint at) const
{
    QRect menus;
    for (const QPointer<QMenu>& menu : m_menus)
        if (menu && menu->isVisible())
            menus |= QRect(parentWidget()->mapFromGlobal(menu->mapToGlobal(QPoint())), menu->size());
    if (!menus.intersects(QRect(at, size())))
        return at;
    const QRect room = this->room();
    if (menus.right() + roomAround + width() <= room.right())
        at.setX(menus.right() + roomAround);
    else if (menus.left() - roomAround - width() >= room.left())
        at.setX(menus.left() - roomAround - width());
    return at;
}

bool TourPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Show || event->type() == QEvent::Hide)
        if (auto* menu = qobject_cast<QMenu*>(watched)) {
            m_menus.removeIf([menu](const QPointer<QMenu>& other) { return !other || other == menu; });
            if (event->type() == QEvent::Show)
                m_menus << menu;
            // When it has its place, or is gone.
            QMetaObject::invokeMethod(
                this, [this] { placeBeside(QRect(m_target)); }, Qt::QueuedConnection);
        }
    return QFrame::eventFilter(watched, event);
}

void TourPanel::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape)
        emit leaveWanted();
    else
        QFrame::keyPressEvent(event);
}

} // namespace bolster
