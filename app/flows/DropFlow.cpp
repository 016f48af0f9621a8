#include "DropFlow.h"

#include "Ask.h"
#include "Background.h"
#include "DesignFile.h"
#include "FabricCommands.h"
#include "FileFlows.h"
#include "FileFormats.h"
#include "OwnWindow.h"

#include <QDir>
#include <QFileInfo>
#include <QProgressDialog>

#include <algorithm>
#include <array>
#include <utility>

namespace bolster {

namespace {

constexpr int moment = 120;                  // ms
constexpr qint64 largestLibrary = 4'000'000; // bytes

/// A design that has nothing but fabrics is a library of them.
bool hasOnlyFabrics(const QString& file)
{
    if (QFileInfo(file).size() > largestLibrary || endingOf(file) != QLatin1String("json"))
        return false;
    const ReadDesign opened = readDesignFile(file);
    bool fabrics = false, others = !opened.readable;
    for (const auto& [id, element] : opened.design.elements()) {
        const bool fabric = std::holds_alternative<Fabric>(*element);
        fabrics = fabrics || fabric;
        others = others || !(fabric || std::holds_alternative<Settings>(*element));
    }
    return fabrics && !others;
}

} // namespace

DropFlow::DropFlow(FileFlows& files, FabricCommands& fabrics, QWidget* window)
    : QObject(window)
    , m_files(files)
    , m_fabrics(fabrics)
    , m_window(window)
    , m_elsewhere(&openInWindowOfItsOwn)
{
    m_look.setInterval(moment);
    connect(&m_look, &QTimer::timeout, this, &DropFlow::goOn);
}

bool DropFlow::takes(const QString& file)
{
    using enum FileUse;
    return std::ranges::any_of(std::array{Design, Frame, Scan, Pattern, Picture},
                               [&](FileUse use) { return isFileOf(use, file); });
}

void DropFlow::drop(const QStringList& files)
{
    QStringList sorted = files;
    std::stable_partition(sorted.begin(), sorted.end(),
                          [](const QString& file) { return isFileOf(FileUse::Design, file); });
    if (m_waiting.isEmpty())
        m_opened = false;
    m_waiting += sorted;
    goOn();
}

/// A dialog or a progress of the one before is there: imports ask, and nobody answers two questions at once.
bool DropFlow::occupied() const
{
    const QList<QDialog*> dialogs = m_window->findChildren<QDialog*>();
    return std::ranges::any_of(dialogs, [](const QDialog* dialog) {
        const auto* progress = qobject_cast<const QProgressDialog*>(dialog);
        return (dialog->isVisible() && dialog->isModal()) || (progress && !progress->wasCanceled());
    });
}

void DropFlow::goOn()
{
    if (m_going || occupied())
        return m_look.start();
    if (m_waiting.isEmpty())
        return m_look.stop();
    m_look.start(); // for the next one, and until this one is done
    take(m_waiting.takeFirst());
}

void DropFlow::take(const QString& file)
{
    if (!QFileInfo(file).isFile() || !takes(file))
        tell(m_window, QMessageBox::Information, tr("\"%1\" cannot be opened.").arg(QFileInfo(file).fileName()),
             whyNot(file));
    else if (isFileOf(FileUse::Design, file))
        takeDesign(file);
    else if (isFileOf(FileUse::Picture, file))
        m_fabrics.choosePicture(noElement, file);
    else
        import(file);
}

void DropFlow::import(const QString& file)
{
    if (isFileOf(FileUse::Frame, file))
        m_files.imports.importFrame(file); // a PLY too: a mesh is dropped more often than a scan
    else if (isFileOf(FileUse::Scan, file))
        m_files.imports.importScan(file);
    else
        m_files.imports.importPattern(file);
}

void DropFlow::takeDesign(const QString& file)
{
    m_going = true;
    inBackground<bool>([file] { return hasOnlyFabrics(file); }).then(this, [this, file](bool fabrics) {
        m_going = false;
        if (fabrics)
            m_fabrics.importFabrics(file);
        else if (!std::exchange(m_opened, true))
            m_files.opening.open(file);
        else if (!m_elsewhere(file))
            tell(m_window, QMessageBox::Warning, tr("\"%1\" cannot be opened.").arg(QFileInfo(file).fileName()),
                 tr("The system did not start the program again for another window. Open it from here instead."));
    });
}

QString DropFlow::whyNot(const QString& file) const
{
    if (QFileInfo(file).isDir())
        return tr("It is a folder. Drop the files that are in it.");
    if (!QFileInfo::exists(file))
        return tr("It is not on this computer, or not any more. Save it to a folder first.");
    const auto names = [](FileUse use) { return QString::fromStdString(namesOf(use)); };
    return tr("Bolster opens projects and designs (%1), frames (%2), scans (%3), patterns (%4) and pictures of "
              "fabrics "
              "(%5). Save it in one of these formats with the program it comes from.")
        .arg(names(FileUse::Design), names(FileUse::Frame), names(FileUse::Scan), names(FileUse::Pattern),
             names(FileUse::Picture));
}

} // namespace bolster
