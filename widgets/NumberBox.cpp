#include "NumberBox.h"

#include "Units.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>

namespace bolster {

bool isUndoOfDesign(const QLineEdit& edit, const QEvent& event)
{
    if (event.type() != QEvent::ShortcutOverride || edit.isModified())
        return false;
    const auto& key = static_cast<const QKeyEvent&>(event);
    return key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo);
}

NumberBox::NumberBox(const Range& range, QWidget* parent)
    : QDoubleSpinBox(parent)
    , m_least(range.least)
    , m_most(range.most)
{
    setDecimals(range.decimals);
    setRange(range.least, range.most);
    setSingleStep(range.step);
    setSuffix(range.unit);
    setKeyboardTracking(false);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumWidth(72);
    connect(this, &QAbstractSpinBox::editingFinished, this, [this] { lineEdit()->setModified(false); });
}

bool NumberBox::event(QEvent* event)
{
    if (isUndoOfDesign(*lineEdit(), *event)) {
        event->ignore();
        return false;
    }
    return QDoubleSpinBox::event(event);
}

void NumberBox::display(double value)
{
    const QSignalBlocker quiet(this);
    setRange(std::min(m_least, value), std::max(m_most, value));
    setValue(value);
}

QString NumberBox::textFromValue(double value) const
{
    return decimalText(value, decimals(), false);
}

double NumberBox::valueFromText(const QString& text) const
{
    return QDoubleSpinBox::valueFromText(asWritten(text));
}

QValidator::State NumberBox::validate(QString& text, int& position) const
{
    QString written = asWritten(text); // the user's own text stays: what is typed next may change its meaning
    return QDoubleSpinBox::validate(written, position) == QValidator::Acceptable ? QValidator::Acceptable
                                                                                 : QValidator::Intermediate;
}

void NumberBox::fixup(QString& text) const
{
    const QString least = textFromValue(m_least), most = textFromValue(m_most);
    QToolTip::showText(mapToGlobal(QPoint(0, height())),
                       tr("\"%1\" is not taken: a number from %2 to %3 is needed").arg(text.trimmed(), least, most),
                       const_cast<NumberBox*>(this));
    QDoubleSpinBox::fixup(text);
}

/// With the language's decimal sign and without grouped digits.
QString NumberBox::asWritten(QString text) const
{
    const QString point = locale().decimalPoint();
    const QString other = point == QLatin1String(",") ? QStringLiteral(".") : QStringLiteral(",");
    static const QRegularExpression grouped(QStringLiteral("^\\s*[-+]?[1-9]\\d{0,2}([.,]\\d{3})+(?![\\d.,])"));
    const QRegularExpressionMatch thousands = grouped.match(text);
    if (other == locale().groupSeparator() && thousands.hasMatch() && !thousands.captured().contains(point))
        return text.remove(other);
    // Only a lone sign can be meant as the decimal one.
    if (!text.contains(point) && text.count(other) == 1)
        text.replace(other, point);
    return text;
}

void NumberBox::wheelEvent(QWheelEvent* event)
{
    // Scrolling through the panel must not change numbers on the way.
    if (hasFocus())
        QDoubleSpinBox::wheelEvent(event);
    else
        event->ignore();
}

} // namespace bolster
