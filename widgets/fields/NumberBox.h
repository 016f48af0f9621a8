// A field for a number with its unit.
#pragma once

#include <QDoubleSpinBox>
#include <QElapsedTimer>

#include <optional>

class QLineEdit;

namespace bolster {

/// Whether an event asks for undo or redo while nothing has been typed: then the design's is meant.
bool isUndoOfDesign(const QLineEdit& edit, const QEvent& event);

/// What a field shows where several elements have different values.
QString variesText();

/// Before what is typed in the number boxes of a window is used: takes it. False if one of them has refused what
/// was typed last and the user was not stopped by that yet; it has the keyboard then, and says why.
bool takeTyped(QWidget& window);

/// Enter in a number box of this window is done with the number and presses no button: for windows that do not end
/// with it, and whose buttons begin what takes long.
void keepEnterInNumbers(QWidget& window);

/// Shows no trailing zeros, takes sums, products and, where the unit is mm, other units ("3*25", "2.5 cm"), takes
/// and shows lengths in the unit that the user likes (its value is in mm all the same), takes
/// point and comma as the decimal sign (but "1,500" as the language groups digits), and reports a value once: when
/// the user is done with it, not with every key. What is no number or out of range is refused as a whole.
class NumberBox : public QDoubleSpinBox {
    Q_OBJECT

public:
    struct Range {
        QString unit; ///< " mm", or ""
        int decimals = 3;
        double least = -1e7;
        double most = 1e7;
        double step = 1;
        bool length = false; ///< in mm, although the unit is not shown
    };

    explicit NumberBox(const Range& range, QWidget* parent = nullptr);

    /// Without a signal; while the user is typing nothing is shown, until it is done or given up (Escape: the line
    /// of text is set unmodified, and the value shown again). A value out of range is shown as it is; nothing is
    /// shown as "varies".
    void display(std::optional<double> value);
    QString textFromValue(double value) const override;
    double valueFromText(const QString& text) const override;
    /// Nothing is refused while it is typed.
    QValidator::State validate(QString& text, int& position) const override;
    /// What is typed is no such number: says so, and the value stays.
    void fixup(QString& text) const override;
    void stepBy(int steps) override;
    QSize minimumSizeHint() const override;
    /// Done with what is typed, as if the keyboard went elsewhere. Why it was refused, once; else empty.
    QString finishTyping();

signals:
    /// The user is done with a number that is not the shown one.
    void entered(double value);

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    StepEnabled stepEnabled() const override;

private:
    void followStyle();
    void fitShown();
    double stepInInches() const;
    QString shownUnit() const;
    void finishOver();
    /// Why what was typed is not taken.
    QString refusal(const QString& text) const;
    void say(const QString& why) const;
    friend bool takeTyped(QWidget& window);
    friend void keepEnterInNumbers(QWidget& window);
    QString withoutUnit(const QString& text) const;
    /// The number that is meant, or nothing.
    std::optional<double> numberIn(const QString& text) const;

    int m_room = 0; ///< pixels, for the number that is shown
    double m_least;
    double m_most;
    QString m_unit;
    int m_decimals; ///< behind the point, of mm
    double m_step;
    bool m_lengths;                    ///< takes units of length
    bool m_enterStays = false;         ///< see keepEnterInNumbers()
    bool m_varies = false;             ///< no one value
    bool m_typedOver = false;          ///< over "varies", or over another value than what is shown since
    std::optional<double> m_meanwhile; ///< what was to be shown last
    bool m_clickedInto = false;        ///< the button is still down
    QElapsedTimer m_sinceDoubleClick;
    mutable bool m_refused = false; ///< what was typed last
    mutable QString m_whyRefused;   ///< until something else is typed or `finishTyping` has said it
};

} // namespace bolster
