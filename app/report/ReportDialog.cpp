#include "ReportDialog.h"

#include "Ask.h"
#include "Background.h"
#include "DesignJson.h"
#include "RunLog.h"
#include "Translated.h"
#include "WholeFile.h"

#include <QCheckBox>
#include <QDate>
#include <QDialogButtonBox>
#include <QDir>
#include <QLabel>
#include <QOffscreenSurface>
#include <QPlainTextEdit>
#include <QPointer>
#include <QPushButton>
#include <QStandardPaths>
#include <QVBoxLayout>

namespace bolster {

ReportDialog::ReportDialog(const Design& design, const QString& title, QWidget* parent)
    : QDialog(parent)
    , m_design(design)
    , m_surface(new QOffscreenSurface, [](QOffscreenSurface* surface) { surface->deleteLater(); })
{
    setObjectName(QStringLiteral("report"));
    setWindowTitle(tr("Report a problem"));
    setAttribute(Qt::WA_DeleteOnClose);
    build(title);
    showContents();
    askForOpenGl();
}

ReportDialog::~ReportDialog() = default;

void ReportDialog::build(const QString& title)
{
    const auto words = [this](const QString& text) {
        auto* label = new QLabel(text, this);
        label->setWordWrap(true);
        return label;
    };
    const int line = fontMetrics().height();
    m_happened = new QPlainTextEdit(this);
    m_happened->setObjectName(QStringLiteral("happened"));
    m_happened->setTabChangesFocus(true);
    m_happened->setPlaceholderText(tr("What did you do, what happened, and what should have happened?"));
    auto* what = words(tr("&What happened:"));
    what->setBuddy(m_happened);
    m_withDesign =
        new QCheckBox(tr("&Add the design (\"%1\"), without its frames, scans and pictures").arg(title), this);
    m_withDesign->setObjectName(QStringLiteral("with-design"));
    connect(m_withDesign, &QCheckBox::toggled, this, &ReportDialog::showContents);
    m_contents = new QPlainTextEdit(this);
    m_contents->setReadOnly(true);
    m_contents->setTabChangesFocus(true);
    auto* contents = words(tr("What the &report says besides:"));
    contents->setBuddy(m_contents);
    m_said = words({});
    m_said->setTextFormat(Qt::PlainText);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    m_write = buttons->addButton(tr("Write the report \u2026"), QDialogButtonBox::ActionRole);
    m_write->setObjectName(QStringLiteral("write-report"));
    connect(m_write, &QPushButton::clicked, this, &ReportDialog::choosePath);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(
        words(tr("This writes a file that you can give to those who can help. Bolster sends nothing.")));
    layout->addWidget(what);
    layout->addWidget(m_happened, 2);
    layout->addWidget(m_withDesign);
    layout->addWidget(contents);
    layout->addWidget(m_contents, 3);
    layout->addWidget(m_said);
    layout->addWidget(buttons);
    resize(40 * line, 34 * line);
}

/// A context is made beside the windows: some drivers take a second for the first one.
void ReportDialog::askForOpenGl()
{
    m_openGl = tr("not known yet");
    m_surface->create();
    if (!m_surface->isValid())
        return;
    inBackground<QString>([surface = m_surface] {
        return openGlText(*surface);
    }).then(this, [this](const QString& text) {
        m_openGl = text;
        showContents();
    });
}

ProblemReport ReportDialog::report() const
{
    ProblemReport report{
        m_happened->toPlainText().trimmed(), versionsText(m_openGl), runLogText(), lastCrashText(), {}};
    if (m_withDesign->isChecked())
        report.design = writeDesign(m_design);
    return report;
}

void ReportDialog::showContents()
{
    const ProblemReport all = report();
    const QStringList parts{all.versions, tr("Messages of this run:"), all.log.isEmpty() ? tr("(none)") : all.log,
                            tr("The last crash:"), all.crash.isEmpty() ? tr("(none)") : all.crash};
    m_contents->setPlainText(withoutHome(parts.join(u'\n')));
}

void ReportDialog::choosePath()
{
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    const QString name = QStringLiteral("bolster-report-%1.zip").arg(QDate::currentDate().toString(Qt::ISODate));
    askWhereToWrite(this, tr("Write the report"), folder.filePath(name), tr("ZIP (*.zip)"), {QStringLiteral("zip")},
                    [this](const QString& path) { writeTo(path); });
}

void ReportDialog::writeTo(const QString& path)
{
    m_write->setEnabled(false);
    inBackground<Message>([report = report(), path] {
        return replaceWholeFile(path, packedReport(report));
    }).then(this, [this, path](const Message& problem) {
        m_write->setEnabled(true);
        const QString said = problem.empty() ? QString() : asSentence(translated(problem));
        m_said->setText(problem.empty() ? tr("The report is written: %1").arg(QDir::toNativeSeparators(path))
                                        : tr("The report could not be written: %1").arg(said));
        emit written(path, said);
    });
}

} // namespace bolster
