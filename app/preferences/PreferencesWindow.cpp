#include "PreferencesWindow.h"

#include "ApplyPreferences.h"
#include "Ask.h"
#include "ColumnScroll.h"
#include "Icons.h"
#include "MouseStyle.h"
#include "NumberBox.h"
#include "Translated.h"
#include "Units.h"
#include "ViewColors.h"
#include "WholeFile.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScreen>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStandardPaths>
#include <QVBoxLayout>
#include <QWheelEvent>

namespace bolster {

namespace {

constexpr int pageRole = Qt::UserRole;

QLabel* noteLabel(const QString& text, QWidget* parent)
{
    auto* label = new QLabel(text, parent);
    label->setWordWrap(true);
    return label;
}

QString preferenceFilter()
{
    return PreferencesWindow::tr("Preferences (*.json)");
}

QString preferenceFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

/// The wheel scrolls the page and changes nothing on the way.
class CalmBox : public QComboBox {
public:
    using QComboBox::QComboBox;

protected:
    void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

} // namespace

PreferencesWindow::PreferencesWindow(PreferenceStore& store, const Ways& ways, QWidget* parent)
    : QDialog(parent)
    , m_store(store)
    , m_search(new QLineEdit(this))
    , m_pages(new QListWidget(this))
    , m_scroll(new ColumnScroll(this))
    , m_nothing(noteLabel(tr("No setting has these words."), this))
{
    setWindowTitle(tr("Preferences"));
    build(ways);
    connect(m_search, &QLineEdit::textChanged, this, &PreferencesWindow::showWanted);
    const auto goToPage = [this] { // who goes to a page wants to see it
        m_search->clear();
        showWanted();
    };
    connect(m_pages, &QListWidget::currentRowChanged, this, goToPage);
    connect(m_pages, &QListWidget::itemClicked, this, goToPage); // also to the one that was shown before
    connect(&m_store, &PreferenceStore::changed, this, &PreferencesWindow::showValues);
    connect(&MouseStyles::instance(), &MouseStyles::changed, this, &PreferencesWindow::showMouse);
    m_pages->setCurrentRow(0);
    showValues();
    m_search->setFocus();
}

void PreferencesWindow::build(const Ways& ways)
{
    m_search->setPlaceholderText(tr("Find a setting"));
    m_search->setClearButtonEnabled(true);
    m_search->setAccessibleName(tr("Find a setting"));
    m_search->setObjectName(QStringLiteral("search"));
    m_search->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
    m_pages->setObjectName(QStringLiteral("pages"));
    m_pages->setAccessibleName(tr("Pages"));
    for (const PreferencePage page : preferencePages) {
        auto* item = new QListWidgetItem(pageTitle(page), m_pages);
        item->setData(pageRole, static_cast<int>(page));
    }
    constexpr int pageGap = 4; // pixels; padding of a style sheet would come after the rows were laid out
    m_pages->setSpacing(pageGap);
    m_pages->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents); // whatever the size of the letters
    m_pages->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Expanding);
    m_scroll->setWidget(buildSections(ways));
    m_scroll->setAccessibleName(tr("Settings"));

    auto* left = new QVBoxLayout;
    left->addWidget(m_search);
    left->addWidget(m_pages, 1);
    auto* top = new QHBoxLayout;
    top->addLayout(left);
    top->addSpacing(8);
    top->addWidget(m_scroll, 1);
    auto* all = new QVBoxLayout(this);
    all->addLayout(top, 1);
    all->addWidget(buildButtons());
    constexpr int widthInLines = 54, heightInLines = 35; // in the height of letters
    resize(
        (fontMetrics().height() * QSize(widthInLines, heightInLines)).boundedTo(0.9 * screen()->availableSize()));
}

QWidget* PreferencesWindow::buildSections(const Ways& ways)
{
    auto* inside = new QWidget(this);
    auto* column = new QVBoxLayout(inside);
    column->setContentsMargins(8, 0, 16, 8);
    for (const PreferencePage page : preferencePages) {
        auto* box = new QWidget(inside);
        auto* lines = new QVBoxLayout(box);
        lines->setContentsMargins(0, 0, 0, 14);
        lines->setSpacing(12);
        auto* title = new QLabel(pageTitle(page), box);
        QFont large = title->font();
        large.setBold(true);
        title->setFont(large);
        lines->addWidget(title);
        auto* form = new QFormLayout;
        form->setHorizontalSpacing(16);
        form->setVerticalSpacing(4);
        form->setRowWrapPolicy(QFormLayout::WrapLongRows);
        form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
        for (const PreferenceRow& setting : preferenceTable())
            if (setting.page == page)
                addRow(*form, *box, setting, ways);
        lines->addLayout(form);
        m_sections.push_back({page, box, title, {}});
        addMore(*lines, m_sections.back(), ways.editKeys);
        column->addWidget(box);
    }
    column->addWidget(m_nothing);
    column->addStretch(1);
    return inside;
}

void PreferencesWindow::addRow(QFormLayout& form, QWidget& box, const PreferenceRow& setting, const Ways& ways)
{
    auto* field = new QWidget(&box);
    field->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    Row row{&setting, nullptr, {field}, {}};
    row.editor = editorFor(setting, *field, row.show);
    row.editor->setObjectName(QString::fromLatin1(setting.key));
    auto* lines = new QVBoxLayout(field);
    constexpr int gapBelow = 12; // pixels
    lines->setContentsMargins(0, 0, 0, gapBelow);
    lines->setSpacing(4);
    lines->addWidget(row.editor, 0, Qt::AlignLeft);
    if (const QString note = setting.noteText(); !note.isEmpty())
        lines->addWidget(noteLabel(note, field));
    if (setting.atNextStart) {
        auto* restart = new QPushButton(tr("&Restart now"), field);
        restart->setObjectName(QStringLiteral("restart"));
        restart->setToolTip(tr("Closes Bolster, and asks about unsaved work as always; then it starts again with "
                               "the same project"));
        restart->setAutoDefault(false);
        connect(restart, &QPushButton::clicked, this, ways.restart);
        lines->addWidget(restart, 0, Qt::AlignLeft);
        row.restart = restart;
    }
    if (std::holds_alternative<OnOff>(setting.form)) { // which has its label itself
        form.addRow(field);
    } else {
        auto* label = new QLabel(setting.labelText(), &box);
        label->setBuddy(row.editor);
        row.editor->setAccessibleName(setting.labelText());
        row.parts << label;
        form.addRow(label, field);
    }
    m_rows.push_back(std::move(row));
}

QWidget* PreferencesWindow::editorFor(const PreferenceRow& setting, QWidget& box, std::function<void()>& show)
{
    const auto now = [this, &setting] { return valueOf(m_store.now(), setting); };
    if (const auto* form = std::get_if<OneOf>(&setting.form)) {
        auto* choice = new CalmBox(&box);
        for (const PreferenceChoice& one : form->choices())
            choice->addItem(one.label, one.id);
        connect(choice, &QComboBox::activated, this,
                [this, choice, &setting] { set(setting, choice->currentData()); });
        show = [choice, now] { choice->setCurrentIndex(choice->findData(now())); };
        return choice;
    }
    if (std::holds_alternative<OnOff>(setting.form)) {
        auto* check = new QCheckBox(setting.labelText(), &box);
        connect(check, &QCheckBox::clicked, this, [this, &setting](bool on) { set(setting, on); });
        show = [check, now] { check->setChecked(now().toBool()); };
        return check;
    }
    if (const auto* form = std::get_if<WholeNumber>(&setting.form)) {
        NumberBox::Range range{QCoreApplication::translate("Preferences", form->suffix), 0,
                               static_cast<double>(form->least), static_cast<double>(form->most),
                               static_cast<double>(form->step)};
        auto* number = new NumberBox(range, &box);
        connect(number, &NumberBox::entered, this,
                [this, &setting](double value) { set(setting, static_cast<int>(value)); });
        show = [number, now] { number->display(now().toDouble()); };
        return number;
    }
    if (const auto* form = std::get_if<LengthNumber>(&setting.form)) {
        auto* number = new NumberBox({millimetreSuffix, 2, form->least, form->most, 1}, &box);
        connect(number, &NumberBox::entered, this, [this, &setting](double value) { set(setting, value); });
        show = [number, now] { number->display(now().toDouble()); };
        return number;
    }
    auto* folder = new QWidget(&box);
    auto* name = new QLineEdit(folder);
    constexpr int lettersSeen = 32; // of a path
    name->setMinimumWidth(lettersSeen * name->fontMetrics().averageCharWidth());
    name->setPlaceholderText(tr("none"));
    name->setAccessibleName(setting.labelText());
    auto* choose = new QPushButton(tr("Choose \u2026"), folder);
    choose->setAutoDefault(false);
    auto* line = new QHBoxLayout(folder);
    line->setContentsMargins({});
    line->addWidget(name, 1);
    line->addWidget(choose);
    folder->setFocusProxy(name);
    connect(name, &QLineEdit::editingFinished, this, [this, name, &setting] {
        name->setModified(false);
        set(setting, QDir::fromNativeSeparators(name->text().trimmed()));
    });
    connect(choose, &QPushButton::clicked, this, [this, &setting, now] {
        auto* dialog = new QFileDialog(this, setting.labelText(), now().toString());
        dialog->setFileMode(QFileDialog::Directory);
        dialog->setOption(QFileDialog::ShowDirsOnly);
        connect(dialog, &QFileDialog::fileSelected, this,
                [this, &setting](const QString& at) { set(setting, at); });
        openDialog(dialog);
    });
    show = [name, now] {
        if (!name->isModified()) // nobody is typing
            name->setText(QDir::toNativeSeparators(now().toString()));
    };
    return folder;
}

void PreferencesWindow::addMore(QVBoxLayout& column, Section& section, const std::function<void()>& editKeys)
{
    if (section.page == PreferencePage::Mouse) {
        m_mouse = new QLabel(section.box);
        m_mouse->setObjectName(QStringLiteral("mouse-table"));
        m_mouse->setTextFormat(Qt::RichText);
        m_mouse->setWordWrap(true);
        section.more << m_mouse;
        showMouse();
    } else if (section.page == PreferencePage::Keys) {
        auto* edit = new QPushButton(tr("&Edit single shortcuts \u2026"), section.box);
        edit->setAutoDefault(false);
        connect(edit, &QPushButton::clicked, this, editKeys);
        section.more << edit;
    }
    for (QWidget* widget : section.more)
        column.addWidget(widget, 0, qobject_cast<QPushButton*>(widget) ? Qt::AlignLeft : Qt::Alignment());
}

QWidget* PreferencesWindow::buildButtons()
{
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    m_defaults = buttons->addButton(tr("Back to &defaults"), QDialogButtonBox::ResetRole);
    m_defaults->setObjectName(QStringLiteral("defaults"));
    m_defaults->setToolTip(tr("All settings of this page"));
    QPushButton* write = buttons->addButton(tr("E&xport \u2026"), QDialogButtonBox::ActionRole);
    QPushButton* read = buttons->addButton(tr("&Import \u2026"), QDialogButtonBox::ActionRole);
    connect(m_defaults, &QPushButton::clicked, this, [this] { m_store.set(withDefaults(m_store.now(), page())); });
    connect(write, &QPushButton::clicked, this, [this] {
        askWhereToWrite(this, tr("Export preferences"),
                        QDir(preferenceFolder()).filePath(tr("Bolster preferences.json")), preferenceFilter(),
                        {QStringLiteral("json")}, [this](const QString& file) { exportTo(file); });
    });
    connect(read, &QPushButton::clicked, this, [this] {
        askForFile(this, tr("Import preferences"), preferenceFolder(), preferenceFilter(),
                   [this](const QString& file) { importFrom(file); });
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    for (QPushButton* button : buttons->findChildren<QPushButton*>())
        button->setAutoDefault(false); // Enter in the search is no answer
    return buttons;
}

void PreferencesWindow::exportTo(const QString& file)
{
    const Message problem = replaceWholeFile(file, preferencesText(m_store.now()));
    if (!problem.empty())
        tell(this, QMessageBox::Warning, tr("The preferences could not be exported."), translated(problem));
}

void PreferencesWindow::importFrom(const QString& file)
{
    constexpr std::int64_t largest = 1'000'000; // bytes
    const WholeFile whole = readWholeFile(file, largest);
    const ReadPreferences read = whole.problem.empty() ? readPreferences(whole.bytes, m_store.now())
                                                       : ReadPreferences{{}, whole.problem, {}, {}};
    if (!read.problem.empty()) {
        tell(this, QMessageBox::Warning,
             tr("Nothing was imported from \"%1\"; all settings are as they were.").arg(QFileInfo(file).fileName()),
             translated(read.problem));
        return;
    }
    m_store.set(read.preferences);
    QStringList notes;
    if (!read.unknown.isEmpty())
        notes << tr("This version of Bolster does not know %n of them: %1", nullptr,
                    static_cast<int>(read.unknown.size()))
                     .arg(read.unknown.join(QStringLiteral(", ")));
    for (const QString& folder : read.noFolder)
        notes
            << tr("\"%1\" is no folder on this machine: the folder of your fabrics stays what it was.").arg(folder);
    if (!notes.isEmpty())
        tell(this, QMessageBox::Information, tr("The preferences were imported."),
             notes.join(QStringLiteral("\n\n")));
}

void PreferencesWindow::set(const PreferenceRow& setting, const QVariant& value)
{
    if (const auto wanted = withValue(m_store.now(), setting, value))
        m_store.set(*wanted);
    showValues();
}

void PreferencesWindow::showValues()
{
    for (const Row& row : m_rows) {
        row.show();
        if (row.restart)
            row.restart->setVisible(localeOf(m_store.now()) != localeOf(m_store.atStart()));
    }
}

PreferencePage PreferencesWindow::page() const
{
    const QListWidgetItem* item = m_pages->currentItem();
    return item ? static_cast<PreferencePage>(item->data(pageRole).toInt()) : preferencePages[0];
}

void PreferencesWindow::showPage(PreferencePage page)
{
    for (int row = 0; row < m_pages->count(); ++row)
        if (m_pages->item(row)->data(pageRole).toInt() == static_cast<int>(page))
            m_pages->setCurrentRow(row);
}

void PreferencesWindow::search(const QString& words)
{
    m_search->setText(words);
}

void PreferencesWindow::showWanted()
{
    const QString words = m_search->text().trimmed();
    const bool searching = !words.isEmpty();
    if (QListWidgetItem* item = m_pages->currentItem())
        item->setSelected(!searching); // what is found may be on any
    bool any = false;
    for (const Section& section : m_sections) {
        bool shown = !searching && section.page == page();
        for (const Row& row : m_rows) {
            if (row.setting->page != section.page)
                continue;
            const bool wanted = searching ? row.setting->found(words) : section.page == page();
            for (QWidget* part : row.parts)
                part->setVisible(wanted);
            shown = shown || wanted;
        }
        section.box->setVisible(shown);
        any = any || shown;
    }
    m_nothing->setVisible(!any);
    m_defaults->setEnabled(!searching);
    m_scroll->ensureVisible(0, 0);
}

/// What the buttons do now.
void PreferencesWindow::showMouse()
{
    if (!m_mouse)
        return;
    const std::pair<ViewMove, QString> moves[] = {
        {ViewMove::Turn, tr("Turn")}, {ViewMove::Pan, tr("Pan")}, {ViewMove::Zoom, tr("Zoom")}};
    QString html = QStringLiteral("<table cellpadding='3' cellspacing='0'>");
    for (const auto& [view, name] :
         {std::pair(MouseView::Cover, tr("In the 3D view")), std::pair(MouseView::Pattern, tr("In the pattern"))}) {
        html += QStringLiteral("<tr><td colspan='2'><b>%1</b></td></tr>").arg(name.toHtmlEscaped());
        for (const auto& [move, what] : moves)
            if (const QString how = allMouseTexts(view, move); !how.isEmpty())
                html += QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td>%2</td></tr>")
                            .arg(what.toHtmlEscaped(), how.toHtmlEscaped());
    }
    m_mouse->setText(html + QStringLiteral("</table>"));
}

} // namespace bolster
