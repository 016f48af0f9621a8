#include "StartCard.h"

#include "Icons.h"
#include "ViewColors.h"

#include <QKeyEvent>
#include <QPainter>
#include <QStyle>
#include <QTextLayout>
#include <QToolButton>

namespace bolster {

namespace {

constexpr double cardWidth = 11.0; // of the height of a line
constexpr double pictureHeight = 6.6;
constexpr double actionWidth = 15.0;
constexpr int actionLines = 3; // title and words
constexpr int rim = 8;         // pixels
constexpr double roundness = 7;

/// As many lines as fit, the last one elided.
void drawLines(QPainter& painter, const QRect& rect, const QString& text, int most)
{
    const QFontMetrics metrics = painter.fontMetrics();
    QTextLayout layout(text, painter.font());
    layout.beginLayout();
    for (int line = 0; line < most; ++line) {
        QTextLine row = layout.createLine();
        if (!row.isValid())
            break;
        row.setLineWidth(rect.width());
        const QPoint at(rect.left(), rect.top() + line * metrics.lineSpacing() + metrics.ascent());
        const QString rest = text.mid(row.textStart());
        const bool last = line + 1 == most;
        painter.drawText(at, last ? metrics.elidedText(rest, Qt::ElideRight, rect.width())
                                  : text.mid(row.textStart(), row.textLength()).trimmed());
    }
    layout.endLayout();
}

QFont titleFont(QFont font)
{
    font.setWeight(QFont::DemiBold);
    return font;
}

} // namespace

StartCard::StartCard(Shape shape, const QString& icon, const QString& title, const QString& words, QWidget* parent)
    : QAbstractButton(parent)
    , m_shape(shape)
    , m_icon(icon)
    , m_words(words)
{
    setText(title);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setAttribute(Qt::WA_Hover);
    updateAccessibleName();
}

void StartCard::updateAccessibleName()
{
    setAccessibleName(m_words.isEmpty() ? text() : text() + QStringLiteral(", ") + m_words);
}

void StartCard::setPicture(const QImage& picture)
{
    m_picture = picture;
    update();
}

void StartCard::setMissing(const QString& words)
{
    m_missing = true;
    m_words = words;
    updateAccessibleName();
    updateCross();
    update();
}

void StartCard::setRemovable(const QString& tip)
{
    m_cross = new QToolButton(this);
    m_cross->setIcon(bolster::icon(QStringLiteral("close")));
    m_cross->setAutoRaise(true);
    m_cross->setFocusPolicy(Qt::NoFocus); // Delete does it
    m_cross->setToolTip(tip);
    m_cross->setCursor(Qt::ArrowCursor);
    connect(m_cross, &QToolButton::clicked, this, &StartCard::removeWanted);
    updateCross();
}

QSize StartCard::sizeHint() const
{
    if (m_shape == Shape::Action)
        return {static_cast<int>(actionWidth * em()),
                actionLines * fontMetrics().lineSpacing() + 2 * rim + em() / 2};
    const int width = static_cast<int>(cardWidth * em());
    const bool oneLine =
        m_words.isEmpty() && QFontMetrics(titleFont(font())).horizontalAdvance(text()) <= width - 2 * rim;
    return {width,
            static_cast<int>(pictureHeight * em()) + (oneLine ? 1 : 2) * fontMetrics().lineSpacing() + 3 * rim};
}

QRect StartCard::pictureRect() const
{
    const QRect inside = rect().adjusted(rim, rim, -rim, -rim);
    if (m_shape == Shape::Picture)
        return {inside.topLeft(), QSize(inside.width(), static_cast<int>(pictureHeight * em()))};
    return {inside.topLeft(), QSize(2 * em(), inside.height())};
}

QRect StartCard::wordsRect() const
{
    const QRect inside = rect().adjusted(rim, rim, -rim, -rim);
    return m_shape == Shape::Picture ? inside.adjusted(0, pictureRect().height() + rim / 2, 0, 0)
                                     : inside.adjusted(pictureRect().width() + rim, em() / 4, 0, 0);
}

void StartCard::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ViewColors colors = ViewColors::of(palette());
    const QColor base = palette().color(QPalette::Base), text = palette().color(QPalette::Text);
    const bool chosen = hasFocus(), hovered = underMouse() || isDown();
    QColor fill = mixed(base, text, colors.dark ? 0.06 : 0.0);
    if (hovered)
        fill = mixed(fill, palette().color(QPalette::Highlight), isDown() ? 0.2 : 0.1);
    painter.setPen(QPen(chosen ? palette().color(QPalette::Highlight) : mixed(base, text, hovered ? 0.3 : 0.16),
                        chosen ? 2 : 1));
    painter.setBrush(fill);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), roundness, roundness);
    painter.setOpacity(m_missing ? 0.5 : 1.0);
    paintPicture(painter);
    paintWords(painter);
}

void StartCard::paintPicture(QPainter& painter) const
{
    const QRect room = pictureRect();
    if (m_shape == Shape::Picture) { // dark leather is seen on a dark page, too
        const QColor base = palette().color(QPalette::Base), text = palette().color(QPalette::Text);
        painter.setPen(Qt::NoPen);
        painter.setBrush(mixed(base, text, ViewColors::of(palette()).dark ? 0.34 : 0.05));
        painter.drawRoundedRect(QRectF(room), roundness - 2, roundness - 2);
    }
    if (!m_picture.isNull()) {
        const QSizeF size = QSizeF(m_picture.size()).scaled(room.size(), Qt::KeepAspectRatio);
        QRectF place({}, size);
        place.moveCenter(QRectF(room).center());
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(place, m_picture);
        return;
    }
    const int side = m_shape == Shape::Picture ? 3 * em() : 2 * em();
    const QRect place = QStyle::alignedRect(Qt::LeftToRight, Qt::AlignCenter, {side, side}, room);
    const QColor color = m_shape == Shape::Picture
                             ? mixed(palette().color(QPalette::Base), palette().color(QPalette::Text), 0.4)
                             : palette().color(QPalette::Link);
    bolster::icon(m_icon, color).paint(&painter, place);
}

void StartCard::paintWords(QPainter& painter) const
{
    const QRect room = wordsRect();
    const QColor strong = palette().color(QPalette::Text);
    painter.setPen(strong);
    painter.setFont(titleFont(font()));
    const int titleLines =
        m_shape == Shape::Picture && painter.fontMetrics().horizontalAdvance(text()) > room.width() ? 2 : 1;
    drawLines(painter, room, text(), titleLines);
    if (titleLines > 1)
        return; // the tool tip has the words
    painter.setPen(mixed(palette().color(QPalette::Base), strong, 0.68));
    painter.setFont(font());
    const QRect below = room.adjusted(0, fontMetrics().lineSpacing(), 0, 0);
    drawLines(painter, below, m_words, m_shape == Shape::Picture ? 1 : actionLines - 1);
}

void StartCard::resizeEvent(QResizeEvent*)
{
    if (!m_cross)
        return;
    const int side = em() + 6;
    m_cross->setIconSize({em() * 3 / 4, em() * 3 / 4});
    m_cross->setGeometry(width() - side - 4, 4, side, side);
}

void StartCard::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        click();
    else if (event->key() == Qt::Key_Delete && m_cross)
        emit removeWanted();
    else
        QAbstractButton::keyPressEvent(event);
}

void StartCard::updateCross()
{
    if (m_cross)
        m_cross->setVisible(m_missing || underMouse() || hasFocus());
}

void StartCard::enterEvent(QEnterEvent* event)
{
    QAbstractButton::enterEvent(event);
    updateCross();
}

void StartCard::leaveEvent(QEvent* event)
{
    QAbstractButton::leaveEvent(event);
    updateCross();
}

void StartCard::focusInEvent(QFocusEvent* event)
{
    QAbstractButton::focusInEvent(event);
    updateCross();
}

void StartCard::focusOutEvent(QFocusEvent* event)
{
    QAbstractButton::focusOutEvent(event);
    updateCross();
}

} // namespace bolster
