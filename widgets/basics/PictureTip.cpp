#include "PictureTip.h"

#include <QApplication>
#include <QMouseEvent>
#include <QScreen>
#include <QStyle>
#include <QToolTip>

#include <algorithm>

namespace bolster {

namespace {

constexpr QPoint belowThePointer(2, 18); // pixels
constexpr int abovePointer = 3;          // pixels

} // namespace

PictureTip::PictureTip(QWidget* owner)
    : QLabel(owner, Qt::ToolTip | Qt::BypassGraphicsProxyWidget)
{
    setTextFormat(Qt::RichText);
    setPalette(QToolTip::palette());
    setFont(QToolTip::font());
    setForegroundRole(QPalette::ToolTipText);
    setBackgroundRole(QPalette::ToolTipBase);
    setFrameStyle(QFrame::Box | QFrame::Plain);
    setMargin(4);
    hide();
}

void PictureTip::showAt(const QPoint& pointer, const QString& html)
{
    if (html.isEmpty()) {
        hide();
        return;
    }
    setText(html);
    adjustSize();
    QRect place(pointer + belowThePointer, size());
    const QScreen* screen = QGuiApplication::screenAt(pointer);
    const QRect room = (screen ? screen : QGuiApplication::primaryScreen())->availableGeometry();
    place.moveRight(std::min(place.right(), room.right()));
    if (place.bottom() > room.bottom())
        place.moveBottom(pointer.y() - abovePointer);
    move(place.topLeft());
    qApp->installEventFilter(this);
    show();
}

bool PictureTip::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::MouseMove:
    case QEvent::MouseButtonPress:
    case QEvent::KeyPress:
    case QEvent::Wheel:
    case QEvent::Leave:
    case QEvent::WindowDeactivate:
        qApp->removeEventFilter(this);
        hide();
        break;
    default:
        break;
    }
    return QLabel::eventFilter(watched, event);
}

} // namespace bolster
