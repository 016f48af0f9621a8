#include "OpenFlow.h"

#include "Banner.h"
#include "FileFormats.h"
#include "LeftWork.h"
#include "RecentFiles.h"
#include "Rescue.h"
#include "Samples.h"
#include "SaveFlow.h"
#include "Translated.h"
#include "WholeFile.h"

#include <QDir>
#include <QFileInfo>
#include <QMenu>

#include <set>

namespace bolster {

namespace {

QString openFilter()
{
    return OpenFlow::tr("Projects and designs (%1)").arg(patternsOf(FileUse::Design));
}

} // namespace

OpenFlow::OpenFlow(DesignSession& session, const Parts& parts)
    : m_session(session)
    , m_talk(parts.talk)
    , m_saving(parts.saving)
    , m_left(parts.left)
    , m_rescue(parts.rescue)
    , m_banner(parts.banner)
{
    connect(&session, &DesignSession::wentToLastPlace, this, [this] {
        m_talk.say(
            tr("This is the version where you were last; the one in the file is under File > Revert to saved"));
    });
    connect(&m_left, &LeftWork::openWanted, this, [this](const QString& path) { openNow(path); });
    connect(&m_rescue, &Rescue::openWanted, this, [this](const QString& path) { openNow(path); });
}

void OpenFlow::startNew(const Then& begun)
{
    m_saving.keepWork([this, begun] {
        m_session.startNew();
        if (begun)
            begun();
    });
}

void OpenFlow::openTemplate(const QString& path)
{
    m_saving.keepWork([this, path] { openAs(path, DesignSession::Opening::AsNew, {}); });
}

void OpenFlow::open(const QString& path, const Then& opened)
{
    const auto take = [this, opened](const QString& file) {
        m_saving.keepWork([this, file, opened] { openNow(file, opened); });
    };
    if (path.isEmpty())
        askForFile(m_talk.window(), tr("Open project or design"), m_talk.startFolder(), openFilter(), take);
    else
        take(path);
}

void OpenFlow::openNow(const QString& path, const Then& opened)
{
    const QString original = QFileInfo(path).absoluteFilePath();
    if (const auto left = WorkJournal::leftOf(original)) { // what was not saved to it is newer
        m_left.restore(*left);
        return;
    }
    if (fileKey(original) == fileKey(m_session.path()) || !WorkJournal::isWorkedOn(original)) {
        openAs(path, DesignSession::Opening::ToWork, opened);
        return;
    }
    QMessageBox* box = m_talk.newBox(QMessageBox::Question,
                                     tr("\"%1\" is open in another window.").arg(QFileInfo(original).fileName()),
                                     QMessageBox::Open | QMessageBox::Cancel);
    box->setInformativeText(tr("It can be opened here to look at; what is changed is saved under another name."));
    box->setDefaultButton(QMessageBox::Open);
    box->setObjectName(QStringLiteral("question.open-elsewhere"));
    openQuestion(box, [this, box, path, opened](const QAbstractButton* pressed) {
        if (pressed && pressed == box->button(QMessageBox::Open))
            openAs(path, DesignSession::Opening::ToLook, opened);
    });
}

void OpenFlow::openAs(const QString& path, DesignSession::Opening opening, const Then& opened)
{
    const std::stop_source stop;
    const auto reading = m_talk.showReading(m_talk.readingText(path), stop);
    const auto replace = [this, reading](const Then& then) {
        closeProgress(reading);
        m_saving.keepWork(then);
    };
    const auto done = [this, path, opening, opened, reading](const Message& problem) {
        closeProgress(reading);
        if (!problem.empty()) {
            m_rescue.failToOpen(path, problem);
            return;
        }
        if (!isSample(path) && opening != DesignSession::Opening::AsNew)
            m_talk.remember(path);
        announceProblems();
        if (opened)
            opened();
    };
    m_session.open(path, opening, replace, done, stop.get_token());
}

void OpenFlow::announceProblems()
{
    std::set<ElementId> bad;
    for (const Problem& problem : m_session.problemsOnOpening())
        if (problem.severity == Severity::Error)
            bad.insert(problem.element);
    if (bad.empty())
        return;
    m_banner.announce(
        Banner::Kind::Problem,
        tr("%n elements cannot be used as they are; everything else works.", nullptr, static_cast<int>(bad.size())),
        {{tr("Sh&ow"), [this] { emit problemsWanted(); }}});
}

/// Names that are the same are told apart by their folders.
void OpenFlow::fillRecent(QMenu& menu)
{
    constexpr int folderWidth = 320; // pixels
    menu.clear();
    menu.setToolTipsVisible(true);
    for (const QString& file : recentFiles::all()) {
        const QString number = QString::number((menu.actions().size() + 1) % 10);
        const QString name = isolated(QFileInfo(file).fileName()).replace(u'&', QStringLiteral("&&"));
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

void OpenFlow::fillSamples(QMenu& menu)
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

} // namespace bolster
