#include "Rescue.h"

#include "Background.h"
#include "LeftWork.h"
#include "Project.h"
#include "Salvage.h"
#include "SaveFlow.h"
#include "Translated.h"
#include "Unfinished.h"

#include <QDir>
#include <QFileInfo>
#include <QPushButton>
#include <QStandardPaths>

namespace bolster {

namespace {

/// "box (recovered).bolster", in the user's documents where the folder cannot be written to.
QString freePathBeside(const QString& path)
{
    const QFileInfo file(path);
    const QDir folder(QFileInfo(file.absolutePath()).isWritable()
                          ? file.absolutePath()
                          : QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    const QString name = Rescue::tr("%1 (recovered)").arg(file.completeBaseName());
    QString free = folder.filePath(name + QLatin1String(".bolster"));
    for (int n = 2; QFileInfo::exists(free); ++n)
        free = folder.filePath(QStringLiteral("%1 %2.bolster").arg(name).arg(n));
    return free;
}

/// Who has no room to try it may have some where it will be.
bool canBeSalvaged(const QString& path, const std::stop_token& stop)
{
    const WorkFolder folder;
    const Salvaged tried = salvageProject(path, folder.filePath(QStringLiteral("tried.bolster")), stop);
    return tried.problem.empty() || tried.readable;
}

} // namespace

Rescue::Rescue(FileTalk& talk, SaveFlow& saving)
    : m_talk(talk)
    , m_saving(saving)
{}

/// Designs as text say where they are wrong; there is nothing to salvage. Nor is there in an empty file, or in a
/// sound project, which cannot be opened where the disk of the journals is full.
void Rescue::failToOpen(const QString& path, const Message& problem)
{
    if (!DesignSession::isProject(path) || !QFileInfo(path).isFile() || QFileInfo(path).size() == 0) {
        offerSalvage(path, problem, false);
        return;
    }
    const std::stop_source stop;
    const auto progress = m_talk.showProgress(
        tr("Looking for what can be read in \"%1\" \u2026").arg(QFileInfo(path).fileName()), stop);
    inBackground<bool>([path, token = stop.get_token()] {
        return !openProject(path).problem.empty() && canBeSalvaged(path, token);
    }).then(this, [this, path, problem, progress](bool damaged) {
        closeProgress(progress);
        offerSalvage(path, problem, damaged);
    });
}

void Rescue::offerSalvage(const QString& path, const Message& problem, bool damaged)
{
    QMessageBox* box =
        m_talk.newBox(QMessageBox::Warning, tr("\"%1\" could not be opened.").arg(QFileInfo(path).fileName()),
                      damaged ? QMessageBox::Close : QMessageBox::Ok);
    box->setInformativeText(translated(problem));
    QPushButton* rescue = nullptr;
    if (damaged) {
        box->setInformativeText(
            translated(problem) + QStringLiteral("\n\n") +
            tr("What can be read goes into a new project beside it. This file stays as it is."));
        rescue = box->addButton(tr("&Recover what can be read"), QMessageBox::AcceptRole);
        box->setDefaultButton(rescue);
    }
    box->setObjectName(QStringLiteral("question.damaged"));
    openQuestion(box, [this, rescue, path](const QAbstractButton* pressed) {
        if (rescue && pressed == rescue)
            salvage(path);
    });
}

/// Into a new project beside it; the damaged file stays as it is.
void Rescue::salvage(const QString& path)
{
    const QString to = freePathBeside(path);
    const std::stop_source stop;
    const auto progress = m_talk.showProgress(tr("Recovering \"%1\" \u2026").arg(QFileInfo(path).fileName()), stop);
    inBackground<Salvaged>([path, to, token = stop.get_token()] {
        return salvageProject(path, to, token);
    }).then(this, [this, to, stop, progress](const Salvaged& salvaged) {
        closeProgress(progress);
        if (stop.stop_requested() && !salvaged.problem.empty())
            return;
        if (!salvaged.problem.empty())
            m_talk.fail(tr("Nothing could be recovered."), salvaged.problem);
        else
            m_saving.keepWork([this, to, salvaged] {
                emit openWanted(to);
                sayWhatIsLeft(to, salvaged.notes);
            });
    });
}

void Rescue::sayWhatIsLeft(const QString& path, const std::vector<Message>& notes)
{
    constexpr qsizetype shown = 12;
    QStringList lines;
    for (const Message& note : notes)
        lines << translated(note);
    QMessageBox* box =
        m_talk.newBox(QMessageBox::Information,
                      tr("What could be read is in \"%1\" now.").arg(QFileInfo(path).fileName()), QMessageBox::Ok);
    box->setInformativeText(lines.mid(0, shown).join(QLatin1Char('\n')));
    if (lines.size() > shown)
        box->setDetailedText(lines.join(QLatin1Char('\n')));
    openDialog(box);
}

void Rescue::offerWorkSalvage(const WorkJournal::Left& damaged)
{
    QMessageBox* box = m_talk.newBox(QMessageBox::Question,
                                     tr("The unsaved work on \"%1\" is damaged.").arg(LeftWork::nameOf(damaged)),
                                     QMessageBox::Cancel);
    box->setInformativeText(tr("What can be read goes into a new project. What you do not want any more is deleted "
                               "%n days after it was put into the bin.",
                               nullptr, WorkJournal::daysInBin()));
    const QAbstractButton* rescue = box->addButton(tr("&Recover what can be read"), QMessageBox::AcceptRole);
    const QAbstractButton* bin = box->addButton(tr("Put it into the &bin"), QMessageBox::DestructiveRole);
    box->setObjectName(QStringLiteral("question.damaged"));
    openQuestion(box, [this, rescue, bin, damaged](const QAbstractButton* pressed) {
        if (pressed == rescue)
            salvageWork(damaged, {});
        else if (pressed == bin)
            WorkJournal::putIntoBin(damaged);
    });
}

void Rescue::salvageWork(const WorkJournal::Left& damaged, const QString& why)
{
    const QString& original = damaged.place.original;
    const QString to = freePathBeside(
        original.isEmpty() ? QDir(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation))
                                 .filePath(LeftWork::nameOf(damaged))
                           : original);
    const std::stop_source stop;
    const auto progress = m_talk.showProgress(tr("Recovering \"%1\" \u2026").arg(LeftWork::nameOf(damaged)), stop);
    inBackground<Salvaged>([journal = damaged.journal, to, token = stop.get_token()] {
        return salvageJournal(journal, to, token);
    }).then(this, [this, work = LeftWork::nameOf(damaged), why, to, stop, progress](const Salvaged& salvaged) {
        closeProgress(progress);
        if (stop.stop_requested() && !salvaged.problem.empty())
            m_talk.say(tr("The damaged work is kept under File > Unsaved work"));
        else
            sayWhatBecameOf(work, why, to, salvaged);
    });
}

void Rescue::sayWhatBecameOf(const QString& work, const QString& why, const QString& recovered,
                             const Salvaged& salvaged)
{
    QMessageBox* box = m_talk.newBox(QMessageBox::Warning, tr("The unsaved work on \"%1\" is damaged.").arg(work),
                                     QMessageBox::Ok);
    const bool some = salvaged.problem.empty();
    QStringList text;
    if (some)
        text << tr("What could be read of it is in \"%1\" now.").arg(QDir::toNativeSeparators(recovered));
    else if (salvaged.readable)
        text << asSentence(translated(salvaged.problem));
    else
        text << tr("Nothing of it could be read.");
    text << tr("Nothing that was saved is concerned. The damaged work is kept under File > Unsaved work.");
    box->setInformativeText(text.join(QStringLiteral("\n\n")));
    QStringList details{why, translated(salvaged.problem)};
    for (const Message& note : salvaged.notes)
        details << translated(note);
    details.removeAll(QString());
    box->setDetailedText(details.join(u'\n'));
    const QAbstractButton* look =
        some ? box->addButton(tr("Open what was &recovered"), QMessageBox::AcceptRole) : nullptr;
    box->setObjectName(QStringLiteral("question.damaged"));
    openQuestion(box, [this, look, recovered](const QAbstractButton* pressed) {
        if (look && pressed == look)
            m_saving.keepWork([this, recovered] { emit openWanted(recovered); });
    });
}

} // namespace bolster
