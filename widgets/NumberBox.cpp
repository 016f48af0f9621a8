#include "NumberBox.h"

#include "Units.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QWheelEvent>

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
    setValue(value);
}

QString NumberBox::textFromValue(double value) const
{
    return decimalText(value, decimals(), false);
}

double NumberBox::valueFromText(const QString& text) const
{
    return QDoubleSpinBox::valueFromText(withDecimalPoint(text));
}

QValidator::State NumberBox::validate(QString& text, int& position) const
{
    text = withDecimalPoint(text);
    return QDoubleSpinBox::validate(text, position);
}

QString NumberBox::withDecimalPoint(QString text) const
{
    const QString point = locale().decimalPoint();
    const QString other = point == QLatin1String(",") ? QStringLiteral(".") : QStringLiteral(",");
    // Only a lone sign can be meant as the decimal one: the unit and signs that group digits are none of ours.
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
