#include "NumberBox.h"

#include "LengthExpression.h"
#include "Units.h"

#include <QApplication>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPointer>
#include <QSignalBlocker>
#include <QStyle>
#include <QStyleOptionSpinBox>
#include <QTimer>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace bolster {

using namespace std::chrono_literals;

bool isUndoOfDesign(const QLineEdit& edit, const QEvent& event)
{
    if (event.type() != QEvent::ShortcutOverride || edit.isModified())
        return false;
    const auto& key = static_cast<const QKeyEvent&>(event);
    return key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo);
}

QString variesText()
{
    return NumberBox::tr("varies");
}

void keepEnterInNumbers(QWidget& window)
{
    for (NumberBox* box : window.findChildren<NumberBox*>())
        box->m_enterStays = true;
}

bool takeTyped(QWidget& window)
{
    for (NumberBox* box : window.findChildren<NumberBox*>()) {
        if (!box->isVisible() || !box->isEnabled())
            continue;
        if (const QString why = box->finishTyping(); !why.isEmpty()) {
            box->setFocus();
            box->selectAll();
            box->say(why);
            return false;
        }
    }
    return true;
}

NumberBox::NumberBox(const Range& range, QWidget* parent)
    : QDoubleSpinBox(parent)
    , m_least(range.least)
    , m_most(range.most)
    , m_unit(range.unit)
    , m_decimals(range.decimals)
    , m_step(range.step)
    , m_lengths(range.unit == millimetreSuffix || range.length)
{
    setRange(range.least, range.most);
    followStyle();
    connect(&NumberStyles::instance(), &NumberStyles::changed, this, &NumberBox::followStyle);
    setKeyboardTracking(false);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed); // down to what it shows
    lineEdit()->installEventFilter(this);
    connect(this, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        lineEdit()->setModified(false); // what follows from it is to be seen
        fitShown();
        m_typedOver = false;
        m_whyRefused.clear();
        emit entered(value);
    });
    connect(lineEdit(), &QLineEdit::textEdited, this, [this] {
        m_typedOver = m_typedOver || m_varies;
        m_varies = false;
        m_refused = false;
        m_whyRefused.clear();
    });
    connect(this, &QAbstractSpinBox::editingFinished, this, [this] {
        lineEdit()->setModified(false);
        finishOver();
    });
}

/// Values stay in mm; how they are shown, and how far an arrow goes, is as the user likes it.
void NumberBox::followStyle()
{
    const QSignalBlocker quiet(this);
    setLocale(numberLocale());
    // Where a part of an inch lies must not be rounded away.
    constexpr int forInches = 4;
    const bool inches = m_lengths && NumberStyles::now().length == LengthUnit::Inches;
    setSingleStep(inches ? stepInInches() : m_step);
    setSuffix(m_varies ? QString() : shownUnit());
    setDecimals(inches ? std::max(m_decimals, forInches) : m_decimals); // shows the number anew
}

/// A part of an inch that is about as long as the step, but is seen: mm.
double NumberBox::stepInInches() const
{
    constexpr double inch = 25.4;
    const int fraction = NumberStyles::now().fraction;
    const double step = std::exp2(std::round(std::log2(m_step / inch)));
    return inch * std::max(step, fraction > 0 ? 1.0 / fraction : 0.0);
}

/// From part to part, also when it stands between two.
void NumberBox::stepBy(int steps)
{
    if (m_lengths && NumberStyles::now().length == LengthUnit::Inches && NumberStyles::now().fraction > 0 &&
        !m_varies) {
        interpretText();
        const double at = value() / singleStep();
        const double from = std::abs(at - std::round(at)) < 1e-3 ? std::round(at)
                            : steps > 0                          ? std::floor(at)
                                                                 : std::ceil(at);
        setValue(singleStep() * (from + steps));
        selectAll();
    } else {
        QDoubleSpinBox::stepBy(steps);
    }
}

QString NumberBox::shownUnit() const
{
    return m_unit == millimetreSuffix ? lengthSuffix() : m_unit;
}

/// The number that was typed may be the one that lay below "varies", or that was here before another came: nobody
/// has heard of it then.
void NumberBox::finishOver()
{
    if (!std::exchange(m_typedOver, false))
        return;
    if (std::exchange(m_refused, false))
        display(m_meanwhile);
    else
        emit entered(value());
}

bool NumberBox::event(QEvent* event)
{
    if (isUndoOfDesign(*lineEdit(), *event)) {
        event->ignore();
        return false;
    }
    if (event->type() == QEvent::MouseButtonPress)
        m_clickedInto = false; // on the arrows
    return QDoubleSpinBox::event(event);
}

/// A double click takes the number, also behind it: a unit alone is not what anybody means to type over.
bool NumberBox::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == lineEdit() && event->type() == QEvent::MouseButtonDblClick) {
        m_sinceDoubleClick.start();
        selectAll();
        return true;
    }
    if (watched == lineEdit() && event->type() == QEvent::MouseButtonPress && m_sinceDoubleClick.isValid() &&
        m_sinceDoubleClick.elapsed() < QApplication::doubleClickInterval()) { // the third click
        selectAll();
        return true;
    }
    if (watched == lineEdit() && event->type() == QEvent::MouseButtonRelease &&
        std::exchange(m_clickedInto, false) && !lineEdit()->hasSelectedText())
        selectAll(); // what is typed takes its place, as after Tab
    return QDoubleSpinBox::eventFilter(watched, event);
}

/// Asked here: the line of text passes the keyboard on and never sees this event.
void NumberBox::focusInEvent(QFocusEvent* event)
{
    m_clickedInto = event->reason() == Qt::MouseFocusReason;
    QDoubleSpinBox::focusInEvent(event);
}

void NumberBox::keyPressEvent(QKeyEvent* event)
{
    QDoubleSpinBox::keyPressEvent(event);
    if (m_enterStays && (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter))
        event->accept(); // else it goes on to the window's default button
}

QString NumberBox::finishTyping()
{
    interpretText();
    return std::exchange(m_whyRefused, {});
}

void NumberBox::display(std::optional<double> value)
{
    m_meanwhile = value;
    if (lineEdit()->isModified()) {
        m_typedOver = m_typedOver || value != std::optional(this->value());
        return;
    }
    const QSignalBlocker quiet(this);
    m_varies = !value;
    m_typedOver = false;
    if (const QString unit = m_varies ? QString() : shownUnit(); unit != suffix())
        setSuffix(unit);
    lineEdit()->setPlaceholderText(m_varies ? variesText() : QString());
    if (!value) {
        lineEdit()->clear();
    } else {
        setRange(std::min(m_least, *value), std::max(m_most, *value));
        setValue(*value);
    }
    fitShown();
}

/// Its place is as wide as the number that it shows needs.
void NumberBox::fitShown()
{
    if (const int width = minimumSizeHint().width(); std::exchange(m_room, width) != width)
        updateGeometry();
}

/// Less than what all numbers of the range would need: hardly any is near its limits.
QSize NumberBox::minimumSizeHint() const
{
    constexpr int besideText = 2 * 2 + 2; // pixels: what a line of text keeps free, and the caret
    const QFontMetrics metrics = fontMetrics();
    const auto widthOf = [&](const QString& text) { return metrics.horizontalAdvance(text); };
    const QString shown = m_varies ? variesText() : textFromValue(value()) + suffix();
    const QString longest = textFromValue(maximum()) + suffix();
    const int usual = std::min(widthOf(QStringLiteral("888") + suffix()), widthOf(longest));
    QStyleOptionSpinBox option;
    initStyleOption(&option);
    return style()->sizeFromContents(
        QStyle::CT_SpinBox, &option,
        {std::max(usual, widthOf(shown)) + besideText, lineEdit()->minimumSizeHint().height()}, this);
}

QAbstractSpinBox::StepEnabled NumberBox::stepEnabled() const
{
    return m_varies ? StepNone : QDoubleSpinBox::stepEnabled();
}

QString NumberBox::textFromValue(double value) const
{
    if (m_varies)
        return {};
    return m_lengths ? lengthFigure(value, m_decimals) : decimalText(value, m_decimals, false);
}

double NumberBox::valueFromText(const QString& text) const
{
    if (withoutUnit(text) == textFromValue(value()))
        return value(); // what nobody has typed over is not rounded to what is shown
    return numberIn(text).value_or(value());
}

QValidator::State NumberBox::validate(QString& text, int&) const
{
    const std::optional<double> number = numberIn(text);
    return number && *number >= minimum() && *number <= maximum() ? QValidator::Acceptable
                                                                  : QValidator::Intermediate;
}

void NumberBox::fixup(QString& text) const
{
    m_refused = true;
    if (text.trimmed().isEmpty() && (m_varies || m_typedOver))
        return; // left as it was
    m_whyRefused = refusal(text);
    say(m_whyRefused);
    QDoubleSpinBox::fixup(text);
}

void NumberBox::say(const QString& why) const
{
    // Once the keyboard is where it goes from here: a tip that is shown before goes with the focus.
    constexpr auto moment = 50ms;
    QTimer::singleShot(moment, qApp, [why, at = mapToGlobal(QPoint(0, height())), in = QPointer(window())] {
        if (in)
            QToolTip::showText(at, why, in);
    });
}

QString NumberBox::refusal(const QString& text) const
{
    const QString written = withoutUnit(text);
    const std::optional<double> number = numberIn(text);
    if (written.isEmpty())
        return tr("Not taken: a number is needed");
    if (!number)
        return (m_lengths ? tr("Not taken: \"%1\" is not a length") : tr("Not taken: \"%1\" is not a number"))
            .arg(written);
    const bool low = *number < minimum();
    const double limit = low ? minimum() : maximum();
    return (low ? tr("Not taken: %1 is too little, at least %2") : tr("Not taken: %1 is too much, at most %2"))
        .arg(written, m_lengths ? lengthText(limit, m_decimals) : decimalText(limit, m_decimals, false) + m_unit);
}

QString NumberBox::withoutUnit(const QString& text) const
{
    QString written = text.trimmed();
    const QString unit = shownUnit().trimmed();
    const QStringList asTyped =
        unit == QStringLiteral("\u00b0") ? QStringList{unit, QStringLiteral("deg")} : QStringList{unit};
    for (bool found = !unit.isEmpty(); found;) { // whoever types it has it twice: it stands there already
        found = false;
        for (const QString& ending : asTyped)
            if (written.endsWith(ending)) {
                written = written.chopped(ending.size()).trimmed();
                found = true;
            }
    }
    return written;
}

std::optional<double> NumberBox::numberIn(const QString& text) const
{
    if (m_lengths)
        if (const std::optional<double> length = parseLength(text.trimmed(), locale()))
            return length;
    const QString written = withoutUnit(text); // also of "2 cm mm": typed before the unit that stands there
    return m_lengths ? parseLength(written, locale()) : parseNumber(written, locale());
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
