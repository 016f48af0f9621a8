#include "ElidedLabel.h"

#include "ElementText.h"

namespace bolster {

void ElidedLabel::setFullText(const QString& text)
{
    if (text == m_full)
        return;
    m_full = text;
    setAccessibleName(text); // what is cut off is read out, too
    updateGeometry();
    elide();
}

QSize ElidedLabel::sizeHint() const
{
    return {fontMetrics().horizontalAdvance(m_full) + 4, QLabel::sizeHint().height()};
}

void ElidedLabel::resizeEvent(QResizeEvent* event)
{
    elide();
    QLabel::resizeEvent(event);
}

void ElidedLabel::elide()
{
    setTextFormat(Qt::PlainText); // names may be in it, and it may be given one before it is polished
    const QString shown = fontMetrics().elidedText(m_full, Qt::ElideRight, width());
    setText(shown);
    setToolTip(shown == m_full ? QString() : inShortLines(m_full));
}

} // namespace bolster
