#include "Ask.h"

#include <QApplication>
#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QProgressBar>
#include <QProgressDialog>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QTimer>

#include <algorithm>

namespace bolster {

namespace {

const QString folderKey = QStringLiteral("folder");

class Ask {
    Q_DECLARE_TR_FUNCTIONS(Ask)
};

QString withEnding(const QString& path, const QString& filter, const QStringList& endings)
{
    if (endings.isEmpty() || endings.contains(QFileInfo(path).suffix().toLower()))
        return path;
    const auto asFiltered = std::ranges::find_if(
        endings, [&](const QString& ending) { return filter.contains(QStringLiteral("*.") + ending); });
    return path + u'.' + (asFiltered == endings.end() ? endings.front() : *asFiltered);
}

void askWhetherToReplace(QWidget* window, const QString& path, const std::function<void(bool)>& answered)
{
    auto* box = new QMessageBox(QMessageBox::Question, Ask::tr("Bolster"),
                                Ask::tr("\"%1\" exists already. Replace it?").arg(QFileInfo(path).fileName()),
                                QMessageBox::Yes | QMessageBox::No, window);
    box->setDefaultButton(QMessageBox::No);
    openQuestion(box, [box, answered](const QAbstractButton* button) {
        answered(button && button == box->button(QMessageBox::Yes));
    });
}

} // namespace

void openDialog(QDialog* dialog)
{
    if (auto* box = qobject_cast<QMessageBox*>(dialog)) {
        box->setText(asSentence(box->text()));
        box->setInformativeText(asSentence(box->informativeText()));
    }
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowModality(Qt::ApplicationModal);
    dialog->show();
}

void openQuestion(QMessageBox* box, const std::function<void(const QAbstractButton*)>& answered)
{
    QObject::connect(box, &QDialog::finished, box, [box, answered] { answered(box->clickedButton()); });
    openDialog(box);
}

QMessageBox* tell(QWidget* window, QMessageBox::Icon icon, const QString& text, const QString& more)
{
    auto* box = new QMessageBox(icon, Ask::tr("Bolster"), text, QMessageBox::Ok, window);
    box->setInformativeText(more);
    openDialog(box);
    return box;
}

QString usualFolder(const QString& openFile)
{
    if (!openFile.isEmpty())
        return QFileInfo(openFile).absolutePath();
    const QString last = QSettings().value(folderKey).toString();
    for (const QString& folder : {last, QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)})
        if (!folder.isEmpty() && QFileInfo(folder).isDir())
            return folder;
    return QDir::homePath();
}

void rememberFolder(const QString& file)
{
    QSettings().setValue(folderKey, QFileInfo(file).absolutePath());
}

void askForFile(QWidget* window, const QString& title, const QString& folder, const QString& filter,
                const Answer& chosen)
{
    // Beside a file: its name is not what is looked for.
    const QFileInfo start(folder);
    auto* dialog = new QFileDialog(window, title, start.isFile() ? start.path() : folder, filter);
    dialog->setFileMode(QFileDialog::ExistingFile);
    QObject::connect(dialog, &QFileDialog::fileSelected, window, chosen, Qt::QueuedConnection); // it closes first
    openDialog(dialog);
}

void askWhereToWrite(QWidget* window, const QString& title, const QString& proposal, const QString& filter,
                     const QStringList& endings, const Answer& chosen)
{
    auto* dialog = new QFileDialog(window, title, QFileInfo(proposal).path(), filter);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setFileMode(QFileDialog::AnyFile);
    dialog->setOption(QFileDialog::DontConfirmOverwrite); // asked below, with the ending
    dialog->selectFile(QFileInfo(proposal).fileName());
    const auto take = [=](const QString& path) {
        if (!QFileInfo::exists(path)) {
            chosen(path);
            return;
        }
        askWhetherToReplace(window, path, [=](bool replace) {
            if (replace)
                chosen(path);
            else
                askWhereToWrite(window, title, path, filter, endings, chosen);
        });
    };
    QObject::connect(dialog, &QFileDialog::fileSelected, window, [=](const QString& typed) {
        const QString path = withEnding(typed, dialog->selectedNameFilter(), endings);
        QMetaObject::invokeMethod(
            window, [=] { take(path); }, Qt::QueuedConnection); // it closes first
    });
    openDialog(dialog);
}

void askForText(QWidget* window, const QString& title, const QString& label, const QString& text,
                const Answer& typed)
{
    auto* dialog = new QInputDialog(window);
    dialog->setWindowTitle(title);
    dialog->setLabelText(label);
    dialog->setTextValue(text);
    QObject::connect(dialog, &QInputDialog::textValueSelected, window, [typed](const QString& given) {
        if (const QString trimmed = given.trimmed(); !trimmed.isEmpty())
            typed(trimmed);
    });
    openDialog(dialog);
}

void askForOneOf(QWidget* window, const QString& title, const QString& label, const QStringList& choices,
                 const Answer& chosen)
{
    auto* dialog = new QInputDialog(window);
    dialog->setWindowTitle(title);
    dialog->setLabelText(label);
    dialog->setComboBoxItems(choices);
    QObject::connect(dialog, &QInputDialog::textValueSelected, window, chosen);
    openDialog(dialog);
}

ProgressWindow openProgress(QWidget* window, const QString& text, int steps)
{
    constexpr int moment = 200; // ms
    auto* dialog = new QProgressDialog(text, Ask::tr("Cancel"), 0, steps, window);
    auto* bar = new QProgressBar(dialog);
    bar->setRange(0, steps);
    bar->setValue(0); // before that no minimum duration counts but four seconds
    dialog->setBar(bar);
    dialog->setWindowModality(Qt::WindowModal);
    dialog->setAutoClose(false);
    dialog->setAutoReset(false);
    dialog->setMinimumDuration(moment);
    return {dialog, bar};
}

namespace {

/// A dialog that goes while the window manager is about to give it the keyboard leaves nobody with it: for the
/// manager the window is the active one already, for Qt none is. Another program's keyboard is not taken.
void takeKeyboardBack(QWidget& window, int looks = 10)
{
    constexpr int moment = 150; // ms: asking once is not always enough
    QTimer::singleShot(moment, &window, [&window, looks] {
        if (QGuiApplication::applicationState() == Qt::ApplicationActive && !QApplication::activeWindow())
            window.activateWindow();
        if (looks > 1)
            takeKeyboardBack(window, looks - 1);
    });
}

} // namespace

void closeProgress(QProgressDialog* dialog)
{
    if (!dialog)
        return;
    const bool seen = dialog->isVisible();
    dialog->hide();
    dialog->deleteLater();
    if (seen)
        takeKeyboardBack(*dialog->parentWidget()->window());
}

} // namespace bolster
