#include "FileFlow.h"

#include "Ask.h"
#include "Banner.h"
#include "FileFormats.h"
#include "RecentFiles.h"
#include "Samples.h"
#include "Translated.h"

#include <QDir>
#include <QLocale>
#include <QMenu>
#include <QPushButton>

namespace bolster {

namespace {

QString openFilter()
{
    return FileFlow::tr("Projects and designs (%1)").arg(patternsOf(FileUse::Design));
}

} // namespace

FileFlow::FileFlow(DesignSession& session, QWidget* window, Banner* banner)
    : QObject(window)
    , m_session(session)
    , m_window(window)
    , m_banner(banner)
{
    connect(&session, &DesignSession::saveEnded, this, [this] {
        if (m_session.document().hasUnsavedWork())
            return;
        m_banner->withdraw(m_restored);
        if (!m_unprotected.empty())
            warnOfCrashes(m_unprotected); // counts from now on
    });
    connect(&session, &DesignSession::recoveryFailed, this, &FileFlow::warnOfCrashes);
    connect(&session, &DesignSession::recoveryWorksAgain, this, [this] {
        m_unprotected = {};
        m_banner->endWarning();
    });
    connect(&session, &DesignSession::wentToLastPlace, this, [this] {
        emit done(
            tr("This is the version where you were last; the one in the file is under File > Revert to saved"));
    });
}

QString FileFlow::startFolder() const
{
    return usualFolder(m_session.path());
}

void FileFlow::startNew(const Then& begun)
{
    keepWork([this, begun] {
        m_session.startNew();
        if (begun)
            begun();
    });
}

void FileFlow::openTemplate(const QString& path)
{
    keepWork([this, path] { openAs(path, DesignSession::Opening::AsNew, {}); });
}

void FileFlow::open(const QString& path, const Then& opened)
{
    const auto take = [this, opened](const QString& file) {
        keepWork([this, file, opened] { openNow(file, opened); });
    };
    if (path.isEmpty())
        askForFile(m_window, tr("Open project or design"), startFolder(), openFilter(), take);
    else
        take(path);
}

void FileFlow::openNow(const QString& path, const Then& opened)
{
    const QString original = QFileInfo(path).absoluteFilePath();
    if (const auto left = WorkJournal::leftOf(original)) { // what was not saved to it is newer
        restore(*left);
        return;
    }
    if (original == m_session.path() || !WorkJournal::isWorkedOn(original)) {
        openAs(path, DesignSession::Opening::ToWork, opened);
        return;
    }
    QMessageBox* box =
        newBox(QMessageBox::Question, tr("\"%1\" is open in another window.").arg(QFileInfo(original).fileName()),
               QMessageBox::Open | QMessageBox::Cancel);
    box->setInformativeText(tr("It can be opened here to look at; what is changed is saved under another name."));
    box->setDefaultButton(QMessageBox::Open);
    box->setObjectName(QStringLiteral("question.open-elsewhere"));
    openQuestion(box, [this, box, path, opened](const QAbstractButton* pressed) {
        if (pressed && pressed == box->button(QMessageBox::Open))
            openAs(path, DesignSession::Opening::ToLook, opened);
    });
}

/// Who cancels it stops what it is about.
QPointer<QProgressDialog> FileFlow::showProgress(const QString& text, std::stop_source stop)
{
    QPointer<QProgressDialog> dialog = openProgress(m_window, text).dialog;
    connect(dialog, &QProgressDialog::canceled, this, [dialog, stop]() mutable {
        stop.request_stop();
        closeProgress(dialog);
    });
    return dialog;
}

/// Until the design is there, whoever opens it.
QPointer<QProgressDialog> FileFlow::showReading(const QString& text, const std::stop_source& stop)
{
    closeProgress(m_reading);
    m_reading = showProgress(text, stop);
    connect(&m_session, &DesignSession::opened, m_reading,
            [reading = m_reading.data()] { closeProgress(reading); });
    return m_reading;
}

void FileFlow::openAs(const QString& path, DesignSession::Opening opening, const Then& opened)
{
    const std::stop_source stop;
    const auto reading = showReading(tr("Reading %1 \u2026").arg(QFileInfo(path).fileName()), stop);
    const auto replace = [this, reading](const Then& then) {
        closeProgress(reading);
        keepWork(then);
    };
    const auto done = [this, path, opening, opened, reading](const Message& problem) {
        closeProgress(reading);
        if (!problem.empty()) {
            failToOpen(path, problem);
            return;
        }
        if (!isSample(path) && opening != DesignSession::Opening::AsNew)
            remember(path);
        announceProblems();
        if (opened)
            opened();
    };
    m_session.open(path, opening, replace, done, stop.get_token());
}

void FileFlow::announceProblems()
{
    std::set<ElementId> bad;
    for (const Problem& problem : m_session.problemsOnOpening())
        if (problem.severity == Severity::Error)
            bad.insert(problem.element);
    if (bad.empty())
        return;
    m_banner->announce(
        Banner::Kind::Problem,
        tr("%n elements cannot be used as they are; everything else works.", nullptr, static_cast<int>(bad.size())),
        {{tr("Sh&ow"), [this] { emit problemsWanted(); }}});
}

void FileFlow::revert()
{
    m_session.document().jumpTo(m_session.document().saved());
}

bool FileFlow::hasSaved() const
{
    return !m_session.path().isEmpty() || m_session.readOnly();
}

void FileFlow::remember(const QString& path)
{
    recentFiles::add(path);
    rememberFolder(path);
}

/// Names that are the same are told apart by their folders.
void FileFlow::fillRecent(QMenu& menu)
{
    constexpr int folderWidth = 320; // pixels
    menu.clear();
    menu.setToolTipsVisible(true);
    for (const QString& file : recentFiles::all()) {
        const QString number = QString::number((menu.actions().size() + 1) % 10);
        const QString name = QFileInfo(file).fileName().replace(u'&', QStringLiteral("&&"));
        const QString folder = recentFiles::folderText(file, menu.fontMetrics(), folderWidth);
        QAction* action = menu.addAction(QStringLiteral("&%1  %2\t%3").arg(number, name, folder), this,
                                         [this, file] { open(file); });
        action->setToolTip(QDir::toNativeSeparators(file));
    }
    if (menu.isEmpty()) {
        menu.addAction(tr("Nothing yet"))->setEnabled(false);
        return;
    }
    menu.addSeparator();
    menu.addAction(tr("&Clear this list"), this, [] { recentFiles::clear(); });
}

void FileFlow::fillSamples(QMenu& menu)
{
    menu.clear();
    menu.setToolTipsVisible(true);
    for (const Sample& sample : samples()) {
        QAction* action = menu.addAction(sample.title, this, [this, path = sample.path] { open(path); });
        action->setToolTip(sample.description);
    }
    if (menu.isEmpty())
        menu.addAction(tr("The samples are not installed"))->setEnabled(false);
}

bool FileFlow::takes(const QString& file)
{
    return DesignSession::isDesign(file) || isFileOf(FileUse::Frame, file) || isFileOf(FileUse::Scan, file) ||
           isFileOf(FileUse::Pattern, file);
}

void FileFlow::drop(const QString& file)
{
    if (isFileOf(FileUse::Frame, file))
        importFrame(file); // a PLY too: a mesh is dropped more often than a scan
    else if (isFileOf(FileUse::Scan, file))
        importScan(file);
    else if (isFileOf(FileUse::Pattern, file))
        importPattern(file);
    else
        open(file);
}

} // namespace bolster
