#include "StartCard.h"

#include "Icons.h"
#include "ViewColors.h"

#include <QKeyEvent>
#include <QPainter>
#include <QStyle>
#include <QTextLayout>
#include <QToolButton>

#include <algorithm>
#include <vector>

namespace bolster {

namespace {

constexpr double cardWidth = 11.0; // of the height of a line
constexpr double pictureHeight = 6.6;
constexpr double actionWidth = 15.0;
constexpr int titleLines = 3, wordLines = 7; // at most
constexpr int actionLines = 3;               // title and words, at least
constexpr int rim = 8;                       // pixels
constexpr double roundness = 7;

/// Where each line begins.
std::vector<int> brokenInto(const QString& text, const QFont& font, int width)
{
    QTextOption option;
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    QTextLayout layout(text, font);
    layout.setTextOption(option);
    std::vector<int> begins;
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(width);
        begins.push_back(line.textStart());
    }
    layout.endLayout();
    return begins;
}

int linesOf(const QString& text, const QFont& font, int width)
{
    return text.isEmpty() ? 0 : static_cast<int>(brokenInto(text, font, width).size());
}

/// Not more lines than `most`: the last one is elided then. Returns how many there are.
int drawLines(QPainter& painter, const QRect& rect, const QString& text, int most)
{
    const QFontMetrics metrics = painter.fontMetrics();
    const std::vector<int> begins = brokenInto(text, painter.font(), rect.width());
    const int lines = std::min(most, static_cast<int>(begins.size()));
    for (int line = 0; line < lines; ++line) {
        const auto at = static_cast<std::size_t>(line);
        const bool last = line + 1 == lines;
        const QString written = text.mid(begins[at], last ? -1 : begins[at + 1] - begins[at]).trimmed();
        painter.drawText(rect.left(), rect.top() + line * metrics.lineSpacing() + metrics.ascent(),
                         last ? metrics.elidedText(written, Qt::ElideRight, rect.width()) : written);
    }
    return lines;
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
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred); // as high as the others of its row
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
    updateGeometry();
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

/// As high as all that is written on it.
QSize StartCard::sizeHint() const
{
    const bool action = m_shape == Shape::Action;
    const int width = static_cast<int>((action ? actionWidth : cardWidth) * em());
    const int room = width - 2 * rim - (action ? pictureRect().width() + rim : 0);
    const int lines = std::min(titleLines, linesOf(text(), titleFont(font()), room)) +
                      std::min(wordLines, linesOf(m_words, font(), room));
    const int spacing = fontMetrics().lineSpacing();
    return {width, action ? std::max(actionLines, lines) * spacing + 2 * rim + em() / 2
                          : static_cast<int>(pictureHeight * em()) + lines * spacing + 3 * rim};
}

bool StartCard::showsAll() const
{
    const QRect room = wordsRect();
    const int title = linesOf(text(), titleFont(font()), room.width());
    const int words = linesOf(m_words, font(), room.width());
    return title <= titleLines && words <= wordLines &&
           (title + words) * fontMetrics().lineSpacing() <= room.height() + 1;
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
    const int title = drawLines(painter, room, text(), titleLines);
    painter.setPen(mixed(palette().color(QPalette::Base), strong, 0.68));
    painter.setFont(font());
    drawLines(painter, room.adjusted(0, title * fontMetrics().lineSpacing(), 0, 0), m_words, wordLines);
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
