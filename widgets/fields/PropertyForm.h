// A form whose fields read and write values through functions.
#pragma once

#include "NumberBox.h"

#include <QColor>
#include <QImage>
#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

class QFormLayout;

namespace bolster {

/// A field calls `write` when the user is done with it, and shows `read()` again on refresh(), except while the
/// user types in it. `read()` is nothing where several elements have different values: "varies" is shown then.
class PropertyForm : public QWidget {
    Q_OBJECT

public:
    explicit PropertyForm(QWidget* parent = nullptr);

    void addHeading(const QString& text, const QIcon& sign);
    /// Side by side; `name` says what they show.
    void addPictures(const QString& name, const QString& tip, const std::function<std::vector<QImage>()>& read);
    /// A line that only informs.
    void addInfo(const QString& label, const std::function<QString()>& read);
    enum class Tone { Muted, Warning, Error };
    /// Text over the whole width; hidden while it is empty.
    void addNote(
        const std::function<QString()>& read, const std::function<Tone()>& tone = [] { return Tone::Muted; });
    /// After the last row: a high dock does not pull the rows apart.
    void addRoomBelow();
    void addText(const QString& label, const std::function<std::optional<QString>()>& read,
                 const std::function<void(const QString&)>& write);
    /// Text of several lines, under its label: Enter begins a new line.
    void addLines(const QString& label, const std::function<QString()>& read,
                  const std::function<void(const QString&)>& write);
    void addNumber(const QString& label, const NumberBox::Range& range,
                   const std::function<std::optional<double>()>& read, const std::function<void(double)>& write);
    /// A number box with a slider from `low` to `high`; while that is dragged `preview` gets its value, then
    /// `finish` is called.
    void addSlider(const QString& label, const NumberBox::Range& range, double low, double high,
                   const std::function<std::optional<double>()>& read, const std::function<void(double)>& write,
                   const std::function<void(double)>& preview, const std::function<void()>& finish);
    /// Several numbers in a row below the label; both functions get the place in the row.
    void addNumbers(const QString& label, const NumberBox::Range& range, int count,
                    const std::function<std::optional<double>(int)>& read,
                    const std::function<void(int, double)>& write);
    void addCheck(const QString& label, const std::function<std::optional<bool>()>& read,
                  const std::function<void(bool)>& write);
    struct Check {
        std::function<QString()> text;
        bool below = false; ///< belongs to the one before that does not
    };
    /// A list of marks, under the label. `pointed` gets the one under the pointer or the keyboard's mark, or -1.
    void addChecks(const QString& label, const std::vector<Check>& checks,
                   const std::function<std::vector<Qt::CheckState>()>& read,
                   const std::function<void(int, bool)>& write, const std::function<void(int)>& pointed);
    /// -1: none of them, or several.
    void addChoice(const QString& label, const QStringList& choices, const std::function<int()>& read,
                   const std::function<void(int)>& write);
    /// `title`, of the dialog, says what is coloured.
    void addColor(const QString& label, const QString& title, const std::function<std::optional<QColor>()>& read,
                  const std::function<void(const QColor&)>& write);
    void addButton(const QString& text, const std::function<void()>& pressed);
    /// What the row that was added last does, for who waits with the pointer over it.
    void explain(const QString& tip);
    /// By which the manual knows it.
    void nameRow(const QString& name);

    void refresh();
    /// The keyboard goes to the first field that takes it, its text selected.
    void focusFirst();

private:
    void addField(const QString& label, QWidget* field, std::function<void()> show);
    void addLabelAbove(const QString& label, QWidget* field);
    /// Label and field.
    std::vector<QWidget*> lastRow() const;

    QFormLayout* m_layout;
    std::vector<std::function<void()>> m_shows;
};

} // namespace bolster
