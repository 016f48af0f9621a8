#include "WhatsNew.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFile>
#include <QSettings>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace bolster {

namespace {

struct WhatsNew {
    Q_DECLARE_TR_FUNCTIONS(WhatsNew)
};

const QString lastVersionKey = QStringLiteral("last-version");

} // namespace

QString whatsNewText()
{
    QFile file(QStringLiteral(":/start/whats-new.md"));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// Whoever starts the program for the first time knows no other: to them nothing is new.
bool newSinceLastStart(const QString& version)
{
    QSettings settings;
    const QString last = settings.value(lastVersionKey).toString();
    if (last == version)
        return false;
    settings.setValue(lastVersionKey, version);
    return !last.isEmpty();
}

void showWhatsNew(QWidget* window)
{
    auto* dialog = new QDialog(window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName(QStringLiteral("whats-new"));
    dialog->setWindowTitle(WhatsNew::tr("What's new"));
    auto* text = new QTextBrowser(dialog);
    text->setOpenLinks(false);
    text->setFrameShape(QFrame::NoFrame);
    text->document()->setDocumentMargin(14);
    text->setMarkdown(whatsNewText());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    auto* layout = new QVBoxLayout(dialog);
    layout->addWidget(text);
    layout->addWidget(buttons);
    dialog->resize(40 * dialog->fontMetrics().height(), 34 * dialog->fontMetrics().height());
    dialog->show();
}

} // namespace bolster
