#include "PropertyForm.h"

#include "ElementText.h"
#include "Icons.h"
#include "PictureStrip.h"
#include "Units.h"
#include "ViewColors.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpacerItem>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>

#include <algorithm>
#include <cmath>
#include <utility>

namespace bolster {

namespace {

/// Leaves undo to the design unless something has been typed.
class TextBox : public QLineEdit {
public:
    explicit TextBox(QWidget* parent)
        : QLineEdit(parent)
    {
        // Set by a program that types for somebody (AT-SPI): as good as typed, but nothing of it can be undone
        // here.
        connect(this, &QLineEdit::textChanged, this, [this] {
            if (!m_displaying && !isUndoAvailable() && !isRedoAvailable())
                setModified(true);
        });
    }

    void display(const QString& text)
    {
        m_displaying = true;
        setText(text);
        m_displaying = false;
    }

protected:
    bool event(QEvent* event) override
    {
        if (!isUndoOfDesign(*this, *event))
            return QLineEdit::event(event);
        event->ignore();
        return false;
    }

private:
    bool m_displaying = false;
};

/// As high as its text, within limits. Whoever leaves it is done; Escape brings back what was there, for which the
/// panel asks. Undo is left to the design unless something has been typed.
class LinesBox : public QPlainTextEdit {
public:
    explicit LinesBox(QWidget* parent)
        : QPlainTextEdit(parent)
    {
        setTabChangesFocus(true);
        setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        constexpr int pause = 3000; // ms: who types no more wants it kept
        m_pause.setSingleShot(true);
        m_pause.setInterval(pause);
        connect(&m_pause, &QTimer::timeout, this, [this] { finish(); });
        connect(this, &QPlainTextEdit::textChanged, this, [this] {
            fitText();
            m_pause.start();
        });
        fitText();
    }

    std::function<void()> finished;

    /// The caret stays where it is unless there is something else. Of a text that would take minutes to show there
    /// is the beginning, and nothing can be typed.
    void show(const QString& text)
    {
        constexpr qsizetype mostShown = 50'000; // letters
        const QString shown = text.size() > mostShown ? text.left(mostShown) + u'\u2026' : text;
        if (shown != (hasFocus() ? toPlainText().trimmed() : toPlainText()))
            setPlainText(shown);
        setReadOnly(text.size() > mostShown);
        document()->setModified(false);
    }

protected:
    bool event(QEvent* event) override
    {
        if (!document()->isModified() && isUndoKey(*event)) {
            event->ignore();
            return false;
        }
        const bool done = QPlainTextEdit::event(event);
        if (event->type() == QEvent::ShortcutOverride && !event->isAccepted() &&
            isCommand(static_cast<const QKeyEvent&>(*event)))
            finish(); // it may be that of saving
        return done;
    }
    void keyPressEvent(QKeyEvent* event) override
    {
        if (event->key() == Qt::Key_Escape) {
            document()->setModified(false); // the panel shows what is there
            event->ignore();
        } else {
            QPlainTextEdit::keyPressEvent(event);
        }
    }
    void focusOutEvent(QFocusEvent* event) override
    {
        QPlainTextEdit::focusOutEvent(event);
        finish();
    }
    void wheelEvent(QWheelEvent* event) override
    {
        if (verticalScrollBar()->maximum() > 0 && hasFocus())
            QPlainTextEdit::wheelEvent(event);
        else
            event->ignore();
    }

private:
    static bool isUndoKey(const QEvent& event)
    {
        if (event.type() != QEvent::ShortcutOverride && event.type() != QEvent::KeyPress)
            return false;
        const auto& key = static_cast<const QKeyEvent&>(event);
        return key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo);
    }
    static bool isCommand(const QKeyEvent& event)
    {
        const bool withModifier = event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
        const bool isModifier = event.key() >= Qt::Key_Shift && event.key() <= Qt::Key_ScrollLock;
        return (withModifier || (event.key() >= Qt::Key_F1 && event.key() <= Qt::Key_F35)) && !isModifier;
    }
    void finish()
    {
        if (document()->isModified() && finished)
            finished();
    }
    void fitText()
    {
        constexpr int least = 2, most = 8; // lines
        const int lines = std::clamp(document()->blockCount(), least, most);
        const int around = 2 * (frameWidth() + static_cast<int>(document()->documentMargin()));
        setFixedHeight(lines * fontMetrics().lineSpacing() + around);
    }

    QTimer m_pause; ///< since somebody typed
};

/// Scrolling through the panel must not change on the way what has no keyboard.
class WheelGuard : public QObject {
public:
    explicit WheelGuard(QWidget* guarded)
        : QObject(guarded)
        , m_guarded(guarded)
    {}

protected:
    bool eventFilter(QObject*, QEvent* event) override
    {
        if (event->type() != QEvent::Wheel || m_guarded->hasFocus())
            return false;
        event->ignore(); // for whoever scrolls
        return true;
    }

private:
    QWidget* m_guarded;
};

/// As high as its rows, up to a limit; says which row is pointed at.
class CheckList : public QTreeWidget {
public:
    static constexpr int number = Qt::UserRole;

    explicit CheckList(QWidget* parent)
        : QTreeWidget(parent)
    {
        setHeaderHidden(true);
        setMouseTracking(true);
        setUniformRowHeights(true);
        setIndentation(16);
        setTextElideMode(Qt::ElideMiddle);
        setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        connect(this, &QTreeWidget::itemEntered, this, [this](QTreeWidgetItem* item) { point(item); });
        connect(this, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) { point(item); });
    }

    void fitRows()
    {
        constexpr int most = 9;
        int rows = 0;
        for (QTreeWidgetItemIterator it(this); *it && rows < most; ++it)
            ++rows;
        setFixedHeight(std::max(1, rows) * std::max(1, sizeHintForRow(0)) + 2 * frameWidth());
    }

    std::function<void(int)> pointed;

protected:
    bool viewportEvent(QEvent* event) override
    {
        if (event->type() == QEvent::Leave || event->type() == QEvent::Hide)
            point(nullptr);
        return QTreeWidget::viewportEvent(event);
    }
    void hideEvent(QHideEvent* event) override
    {
        point(nullptr);
        QTreeWidget::hideEvent(event);
    }

private:
    void point(const QTreeWidgetItem* item)
    {
        const int row = item ? item->data(0, number).toInt() : -1;
        if (pointed && std::exchange(m_row, row) != row)
            pointed(row);
    }

    int m_row = -1;
};

} // namespace

PropertyForm::PropertyForm(QWidget* parent)
    : QWidget(parent)
    , m_layout(new QFormLayout(this))
{
    m_layout->setContentsMargins(10, 10, 10, 10);
    m_layout->setHorizontalSpacing(10);
    m_layout->setVerticalSpacing(6);
    m_layout->setLabelAlignment(Qt::AlignLeft);
    m_layout->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_layout->setRowWrapPolicy(QFormLayout::WrapLongRows);
}

void PropertyForm::addRoomBelow()
{
    m_layout->addItem(new QSpacerItem(0, 0, QSizePolicy::Minimum, QSizePolicy::Expanding));
}

void PropertyForm::refresh()
{
    for (const std::function<void()>& show : m_shows)
        show();
}

void PropertyForm::focusFirst()
{
    for (QWidget* field : findChildren<QWidget*>()) {
        if (!(field->focusPolicy() & Qt::TabFocus) || !field->isVisibleTo(this) || !field->isEnabled())
            continue;
        field->setFocus(Qt::TabFocusReason); // selects the text
        return;
    }
}

void PropertyForm::addField(const QString& label, QWidget* field, std::function<void()> show)
{
    show();
    m_shows.push_back(std::move(show));
    if (label.isEmpty())
        m_layout->addRow(field);
    else
        m_layout->addRow(label, field);
}

void PropertyForm::addLabelAbove(const QString& label, QWidget* field)
{
    auto* text = new QLabel(label, this);
    text->setBuddy(field);
    m_layout->addRow(text);
}

void PropertyForm::addHeading(const QString& text, const QIcon& sign)
{
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 2);
    layout->setSpacing(6);
    auto* picture = new QLabel(row);
    picture->setPixmap(sign.pixmap(QSize(18, 18), devicePixelRatioF()));
    auto* title = new QLabel(text, row);
    QFont font = title->font();
    font.setWeight(QFont::DemiBold);
    title->setFont(font);
    layout->addWidget(picture);
    layout->addWidget(title, 1);
    m_layout->addRow(row);
}

void PropertyForm::addPictures(const QString& name, const QString& tip,
                               const std::function<std::vector<QImage>()>& read)
{
    auto* strip = new PictureStrip(this);
    strip->setAccessibleName(name);
    strip->setToolTip(tip);
    addField({}, strip, [strip, read] { strip->setPictures(read()); });
}

void PropertyForm::addInfo(const QString& label, const std::function<QString()>& read)
{
    auto* text = new QLabel(this);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    text->setWordWrap(true);
    text->setMinimumWidth(1); // a name without blanks may be longer than the window is wide
    addField(label, text, [text, read] { text->setText(read()); });
}

void PropertyForm::addNote(const std::function<QString()>& read, const std::function<Tone()>& tone)
{
    auto* text = new QLabel(this);
    text->setWordWrap(true);
    text->setMinimumWidth(1);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    addField({}, text, [this, text, read, tone] {
        QPalette colors = palette();
        const ViewColors views = ViewColors::of(colors);
        const QColor shades[] = {views.mutedLabel, views.warning, views.error};
        colors.setColor(QPalette::WindowText, shades[static_cast<int>(tone())]);
        text->setPalette(colors);
        text->setText(read());
        text->setVisible(!text->text().isEmpty());
    });
}

void PropertyForm::addText(const QString& label, const std::function<std::optional<QString>()>& read,
                           const std::function<void(const QString&)>& write)
{
    auto* edit = new TextBox(this);
    const auto show = [edit, read] {
        if (edit->isModified())
            return;
        const std::optional<QString> text = read();
        edit->display(text.value_or(QString()));
        edit->setPlaceholderText(text ? QString() : variesText());
    };
    connect(edit, &QLineEdit::editingFinished, this, [edit, write, show] {
        if (!edit->isModified())
            return;
        edit->setModified(false);
        write(edit->text());
        show(); // what was written may have come to nothing
    });
    addField(label, edit, show);
}

void PropertyForm::addLines(const QString& label, const std::function<QString()>& read,
                            const std::function<void(const QString&)>& write)
{
    auto* edit = new LinesBox(this);
    edit->setAccessibleName(label);
    edit->finished = [edit, write, read] {
        edit->document()->setModified(false);
        write(edit->toPlainText());
        edit->show(read());
    };
    addLabelAbove(label, edit);
    addField({}, edit, [edit, read] {
        if (!edit->document()->isModified())
            edit->show(read());
    });
}

void PropertyForm::addChecks(const QString& label, const std::vector<Check>& checks,
                             const std::function<std::vector<Qt::CheckState>()>& read,
                             const std::function<void(int, bool)>& write, const std::function<void(int)>& pointed)
{
    auto* list = new CheckList(this);
    list->setAccessibleName(label);
    std::vector<QTreeWidgetItem*> items;
    QTreeWidgetItem* above = nullptr;
    for (const Check& check : checks) {
        auto* item = check.below && above ? new QTreeWidgetItem(above) : new QTreeWidgetItem(list);
        item->setText(0, check.text());
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        item->setCheckState(0, Qt::Unchecked); // before rows are measured: a mark is higher than a word
        item->setData(0, CheckList::number, static_cast<int>(items.size()));
        above = check.below ? above : item;
        items.push_back(item);
    }
    list->setRootIsDecorated(std::ranges::any_of(checks, &Check::below));
    list->expandAll();
    list->fitRows();
    list->pointed = pointed;
    connect(list, &QTreeWidget::itemChanged, this, [write](QTreeWidgetItem* item) {
        write(item->data(0, CheckList::number).toInt(), item->checkState(0) == Qt::Checked);
    });
    addLabelAbove(label, list);
    addField({}, list, [list, items, read, checks] {
        const QSignalBlocker quiet(list);
        const std::vector<Qt::CheckState> states = read();
        for (std::size_t i = 0; i < items.size() && i < states.size(); ++i) {
            const QString text = checks[i].text();
            items[i]->setText(0, text);
            items[i]->setToolTip(0, text);
            items[i]->setCheckState(0, states[i]);
        }
    });
}

void PropertyForm::addNumber(const QString& label, const NumberBox::Range& range,
                             const std::function<std::optional<double>()>& read,
                             const std::function<void(double)>& write)
{
    auto* box = new NumberBox(range, this);
    connect(box, &NumberBox::entered, this, write);
    addField(label, box, [box, read] { box->display(read()); });
}

void PropertyForm::addSlider(const QString& label, const NumberBox::Range& range, double low, double high,
                             const std::function<std::optional<double>()>& read,
                             const std::function<void(double)>& write, const std::function<void(double)>& preview,
                             const std::function<void()>& finish)
{
    constexpr int steps = 200;
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    auto* slider = new QSlider(Qt::Horizontal, row);
    slider->setRange(0, steps);
    slider->setPageStep(steps / 10);
    slider->setMinimumWidth(60);
    slider->setAccessibleName(label);
    slider->setFocusPolicy(Qt::StrongFocus);
    slider->installEventFilter(new WheelGuard(slider));
    auto* box = new NumberBox(range, row);
    box->setAccessibleName(label);
    layout->addWidget(slider, 1);
    layout->addWidget(box);
    connect(box, &NumberBox::entered, this, write);
    connect(slider, &QSlider::valueChanged, this, [slider, low, high, preview, finish](int step) {
        preview(low + (high - low) * step / steps);
        if (!slider->isSliderDown())
            finish(); // by a key, the wheel or a click beside the handle
    });
    connect(slider, &QSlider::sliderReleased, this, finish);
    addField(label, row, [slider, box, low, high, read] {
        const std::optional<double> value = read();
        box->display(value);
        if (slider->isSliderDown())
            return;
        const QSignalBlocker quiet(slider);
        const double share = std::clamp((value.value_or(low) - low) / (high - low), 0.0, 1.0);
        slider->setValue(static_cast<int>(std::lround(share * steps)));
    });
}

void PropertyForm::addNumbers(const QString& label, const NumberBox::Range& range, int count,
                              const std::function<std::optional<double>(int)>& read,
                              const std::function<void(int, double)>& write)
{
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    std::vector<NumberBox*> boxes;
    NumberBox::Range bare = range; // the unit fits only once
    bare.unit.clear();
    bare.length = range.unit == millimetreSuffix;
    for (int i = 0; i < count; ++i) {
        auto* box = new NumberBox(bare, row);
        box->setButtonSymbols(QAbstractSpinBox::NoButtons);
        box->setAccessibleName(QStringLiteral("%1, %2").arg(label).arg(i + 1));
        // Coordinates of a room in full.
        box->setMinimumWidth(box->fontMetrics().horizontalAdvance(QStringLiteral("-8888.888")) + 14);
        connect(box, &NumberBox::entered, this, [i, write](double value) { write(i, value); });
        layout->addWidget(box, 1);
        boxes.push_back(box);
    }
    const QString unit = bare.length ? lengthUnitName() : range.unit.trimmed();
    // Always above: beside a long label the row would be wider than the panel.
    row->setFocusProxy(boxes.front());
    addLabelAbove(unit.isEmpty() ? label : QStringLiteral("%1, %2").arg(label, unit), row);
    addField({}, row, [boxes, read] {
        for (std::size_t i = 0; i < boxes.size(); ++i)
            boxes[i]->display(read(static_cast<int>(i)));
    });
}

void PropertyForm::addCheck(const QString& label, const std::function<std::optional<bool>()>& read,
                            const std::function<void(bool)>& write)
{
    auto* box = new QCheckBox(label, this);
    connect(box, &QCheckBox::clicked, this, [box, write] {
        box->setTristate(false);
        write(box->checkState() != Qt::Unchecked);
    });
    addField({}, box, [box, read] {
        const std::optional<bool> on = read();
        box->setTristate(!on); // a click makes it all or nothing
        box->setCheckState(!on ? Qt::PartiallyChecked : *on ? Qt::Checked : Qt::Unchecked);
    });
}

void PropertyForm::addChoice(const QString& label, const QStringList& choices, const std::function<int()>& read,
                             const std::function<void(int)>& write)
{
    auto* box = new QComboBox(this);
    box->addItems(choices);
    // Long words get a row of their own, below the label, before they are cut off.
    constexpr qsizetype leastLetters = 6, mostLetters = 22;
    qsizetype longest = leastLetters;
    for (const QString& choice : choices)
        longest = std::max(longest, choice.size());
    box->setMinimumContentsLength(static_cast<int>(std::min(longest, mostLetters)));
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setFocusPolicy(Qt::StrongFocus);
    box->setPlaceholderText(variesText());
    box->installEventFilter(new WheelGuard(box));
    connect(box, &QComboBox::activated, this, write);
    addField(label, box, [box, read] {
        const QSignalBlocker quiet(box);
        box->setCurrentIndex(read());
    });
}

void PropertyForm::addColor(const QString& label, const QString& title,
                            const std::function<std::optional<QColor>()>& read,
                            const std::function<void(const QColor&)>& write)
{
    auto* button = new QToolButton(this);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setIconSize({18, 18});
    connect(button, &QToolButton::clicked, this, [this, title, read, write] {
        auto* dialog = new QColorDialog(read().value_or(Qt::white), this);
        dialog->setWindowTitle(title);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        // Later: the edit can end this form, and the dialog with it.
        connect(dialog, &QColorDialog::colorSelected, this, write, Qt::QueuedConnection);
        dialog->open();
    });
    addField(label, button, [button, read] {
        const std::optional<QColor> color = read();
        button->setIcon(color ? colorSpot(*color) : QIcon());
        button->setText(color ? color->name() : variesText());
    });
}

void PropertyForm::addButton(const QString& text, const std::function<void()>& pressed)
{
    auto* button = new QPushButton(text, this);
    connect(button, &QPushButton::clicked, this, pressed);
    m_layout->addRow(button);
}

std::vector<QWidget*> PropertyForm::lastRow() const
{
    std::vector<QWidget*> widgets;
    for (const auto role : {QFormLayout::LabelRole, QFormLayout::FieldRole, QFormLayout::SpanningRole})
        if (const QLayoutItem* item = m_layout->itemAt(m_layout->rowCount() - 1, role); item && item->widget())
            widgets.push_back(item->widget());
    if (m_layout->rowCount() > 1 && !widgets.empty()) // the label may have a row of its own
        if (const QLayoutItem* above = m_layout->itemAt(m_layout->rowCount() - 2, QFormLayout::SpanningRole))
            if (auto* label = qobject_cast<QLabel*>(above->widget()); label && label->buddy() == widgets.back())
                widgets.push_back(label);
    return widgets;
}

void PropertyForm::explain(const QString& tip)
{
    for (QWidget* widget : lastRow())
        widget->setToolTip(inShortLines(tip));
}

void PropertyForm::nameRow(const QString& name)
{
    for (QWidget* widget : lastRow())
        widget->setObjectName(name);
}

} // namespace bolster
