// Writing projects and designs.
#include "Background.h"
#include "DesignSession.h"
#include "ElementEdits.h"
#include "Project.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace bolster {

namespace {

struct Saving {
    HistoryMark held; // by the file: edits may have come before the journal was read
    bool changedByOthers = false;
    bool placeTaken = false;
};

/// Only what leads where it led when the file was read or written here is followed.
Message newLinkIn(const QString& file, const FileStamp& known)
{
    const QString link = stampOf(file, false).link;
    if (!known.known || link.isEmpty() || link == known.link)
        return {};
    return {QT_TRANSLATE_NOOP("Message", "\"%1\" is a link to \"%2\" now"),
            {file.toStdString(), link.toStdString()}};
}

/// What is in the place of a design as text, unless it is the file that was read or written here.
Message strangerIn(const QString& file, const FileStamp& known)
{
    Message stranger = newLinkIn(file, known);
    if (!stranger.empty() || !known.known || !isTaken(file) || QFileInfo(file).isDir())
        return stranger;
    if (stampOf(file, true).content != known.content)
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" was changed by another program"), {file.toStdString()}};
    return {};
}

/// Not over what somebody else has made of the project meanwhile. What we have all of may go: it is our own, though
/// the program may have died before it could tell.
Message saveOurs(Journal& journal, const QString& file, const FileStamp& known, Saving& saving)
{
    if (!isTaken(file) || QFileInfo(file).isDir())
        return journal.save(file, &saving.held);
    Message stranger = newLinkIn(file, known);
    if (stranger.empty()) {
        const OpenedProject there = openProject(file);
        stranger = there.problem;
        if (stranger.empty() && there.seal != journal.base())
            switch (journal.compare(there)) {
            case Journal::Theirs::NothingNew:
                break;
            case Journal::Theirs::MoreVersions:
                saving.changedByOthers = true;
                return {QT_TRANSLATE_NOOP("Message", "somebody else has changed \"%1\" since it was opened here"),
                        {file.toStdString()}};
            case Journal::Theirs::AnotherProject:
                stranger = {QT_TRANSLATE_NOOP("Message", "\"%1\" is another project now"), {file.toStdString()}};
            }
    }
    saving.placeTaken = !stranger.empty();
    return saving.placeTaken ? stranger : journal.save(file, &saving.held);
}

/// The files of their design that are not here yet.
Message extractMissing(const OpenedProject& theirs, const DesignFolder& folder)
{
    Edit without;
    for (const auto& [id, element] : theirs.design.elements())
        if (const std::string* file = elementFile(*element);
            file && !folder.find(QString::fromStdString(*file)).isEmpty())
            without.changes.push_back({id, element, nullptr});
    const Problems lacking = extractAssets(theirs, theirs.design.with(without), folder.folder());
    return lacking.empty() ? Message{} : lacking.front().message;
}

} // namespace

void DesignSession::save(const QString& path, const Done& done)
{
    const QString file = QFileInfo(path).absoluteFilePath();
    ++m_saves;
    m_changedByOthers = false;
    m_placeTaken = false;
    if (isProject(file))
        saveProject(file, done);
    else
        saveText(file, done);
}

void DesignSession::saveProject(const QString& file, const Done& done)
{
    const bool ours = file == m_path;
    const FileStamp known = m_journal.place().stamp;
    auto saving = std::make_shared<Saving>();
    const Writing writing{[=](Journal& journal) {
                              return ours ? saveOurs(journal, file, known, *saving)
                                          : journal.save(file, &saving->held);
                          },
                          [=] { return saving->changedByOthers || saving->placeTaken; }};
    writeProject(file, writing, [=, this](const Message& problem) {
        m_changedByOthers = saving->changedByOthers;
        m_placeTaken = saving->placeTaken;
        endSaving(file, HeldHistory{saving->held, false}, problem, stampOf(file, false), done);
    });
}

/// From the journal, or where its disk takes nothing more, from one that stands in for it.
void DesignSession::writeProject(const QString& file, const Writing& writing, const Done& done)
{
    if (!m_journal.catchUp().empty()) {
        writeFromStandIn(file, writing, done);
        return;
    }
    writeFrom(m_journal.journal(), writing, [=, this](const Message& problem) {
        if (problem.empty() || writing.refused())
            done(problem);
        else
            writeFromStandIn(file, writing, done);
    });
}

void DesignSession::writeFromStandIn(const QString& file, const Writing& writing, const Done& done)
{
    using StandIn = std::shared_ptr<WorkJournal::StandIn>;
    inBackground<StandIn>([make = m_journal.standIns(), file] { return make(file); }, savingPool())
        .then(this, [=, this, generation = m_generation](const StandIn& made) {
            if (generation != m_generation)
                return;
            if (!made->problem.empty()) {
                done(made->problem);
                return;
            }
            const std::shared_ptr<Journal> journal(made, made->journal.get());
            writeFrom(journal, writing, [this, journal, done](const Message& problem) {
                if (problem.empty())
                    m_journal.savedBy(*journal);
                done(problem);
            });
        });
}

void DesignSession::writeFrom(const std::shared_ptr<Journal>& journal, const Writing& writing, const Done& done)
{
    addFiles(journal, [=, this](const Message& lacking) {
        const Message problem = lacking.empty() ? m_journal.catchUp(*journal) : lacking;
        if (problem.empty())
            besideEdits(journal, writing.work, done);
        else
            done(problem);
    });
}

/// Another name in the same folder, so that nothing has to be copied.
Message DesignSession::moveAside(const QString& path, QString* name)
{
    const QFileInfo file(path);
    const auto named = [&](const QString& addition) {
        return file.completeBaseName() + addition + (file.suffix().isEmpty() ? QString() : u'.' + file.suffix());
    };
    const QDir folder(file.absolutePath());
    *name = named(tr(" (other)"));
    for (int n = 2; isTaken(folder.filePath(*name)); ++n)
        *name = named(tr(" (other %1)").arg(n));
    const QByteArray to = QFile::encodeName(folder.filePath(*name));
    if (std::rename(QFile::encodeName(path).constData(), to.constData()) != 0) // a link itself, too
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be renamed (%2)"),
                {path.toStdString(), std::strerror(errno)}};
    return {};
}

void DesignSession::takeTheirs(const QString& name,
                               const std::function<void(const Message& problem, NodeId tip)>& done)
{
    using Theirs = std::shared_ptr<const OpenedProject>;
    inBackground<Theirs>([file = m_path] {
        return std::make_shared<const OpenedProject>(openProject(file));
    }).then(this, [this, name, done, generation = m_generation](const Theirs& theirs) {
        if (generation != m_generation)
            return;
        NodeId tip = 0;
        Message problem = theirs->problem;
        if (problem.empty())
            problem = m_journal.takeIn(*theirs, name.toStdString(), tip);
        if (!problem.empty()) {
            done(problem, tip);
            return;
        }
        m_changedByOthers = false;
        besideEdits(
            m_journal.journal(), [theirs, folder = m_folder](Journal&) { return extractMissing(*theirs, folder); },
            [done, tip](const Message& lacking) { done(lacking, tip); });
    });
}

/// A copy may have less in it, so it never takes the place of the original.
void DesignSession::saveCopy(const QString& path, const SaveOptions& options, const Done& done)
{
    const QString target = QFileInfo(path).canonicalFilePath();
    if (!target.isEmpty() && !m_path.isEmpty() && target == QFileInfo(m_path).canonicalFilePath()) {
        done({QT_TRANSLATE_NOOP("Message", "it is the project that is open here; choose another name"), {}});
        return;
    }
    const Writing writing{[path, options](Journal& journal) { return journal.saveCopy(path, options); },
                          [] { return false; }};
    writeProject(path, writing, done);
}

void DesignSession::endSaving(const QString& file, const std::optional<HeldHistory>& held, const Message& problem,
                              const FileStamp& stamp, const Done& done)
{
    --m_saves;
    if (problem.empty()) {
        m_path = file;
        m_document.setHeld(*held);
        m_journal.move({file, m_folder.folder(), stamp});
        emit titleChanged();
    }
    done(problem);
    emit saveEnded();
}

/// Edits go on meanwhile, and are in the journal at once. `done` is not called when another design was opened.
void DesignSession::besideEdits(const std::shared_ptr<Journal>& journal,
                                const std::function<Message(Journal&)>& work, const Done& done)
{
    inBackground<Message>([journal, work] { return work(*journal); }, savingPool())
        .then(this, [this, generation = m_generation, done](const Message& problem) {
            if (generation == m_generation)
                done(problem);
        });
}

/// The files that any version uses become part of the project.
void DesignSession::addFiles(const std::shared_ptr<Journal>& journal, const Done& done)
{
    std::map<std::string, QString> files;
    for (const QString& name : m_names)
        if (const QString file = m_folder.find(name); !file.isEmpty())
            files[name.toStdString()] = file;
    auto names = std::make_shared<std::map<std::string, std::string>>(); // as the project has them
    besideEdits(
        journal,
        [files, names](Journal& to) {
            for (const auto& [name, file] : files) {
                std::string kept = name;
                if (Message problem = to.addAsset(kept, file); !problem.empty())
                    return problem;
                (*names)[name] = kept;
            }
            return Message();
        },
        [this, names, done](const Message& problem) {
            if (problem.empty())
                renameFiles(*names);
            done(problem);
        });
}

/// Where an older version of the design means another file by the same name.
void DesignSession::renameFiles(const std::map<std::string, std::string>& names)
{
    Design renamed = m_document.committed();
    for (const auto& [id, element] : m_document.committed().elements()) {
        const std::string* file = elementFile(*element);
        const auto name = file ? names.find(*file) : names.end();
        if (name == names.end() || name->second == name->first)
            continue;
        const QString to = QString::fromStdString(name->second);
        QFile::copy(m_folder.find(QString::fromStdString(name->first)), QDir(m_folder.folder()).filePath(to));
        const ElementPtr next = withFile(*element, name->second);
        if (hasShapeFile(*next))
            m_known[keyOf(*next)] = m_known[keyOf(*element)];
        renamed = renamed.with(edits::replaceElement(renamed, id, next, {}));
    }
    m_document.commit(
        editBetween(m_document.committed(), renamed, {QT_TRANSLATE_NOOP("Message", "Rename a file"), {}}));
}

void DesignSession::saveText(const QString& file, const Done& done)
{
    const QString folder = QFileInfo(file).absolutePath();
    Message problem = file == m_path ? strangerIn(file, m_journal.place().stamp) : Message();
    m_placeTaken = !problem.empty();
    Design arranged;
    if (problem.empty())
        problem = m_folder.copyTo(folder, m_document.committed(), &arranged);
    if (!problem.empty()) {
        endSaving(file, {}, problem, {}, done);
        return;
    }
    // A file that had to take another name beside the design: the renamed one is what is saved and shown.
    m_folder.moved(folder);
    if (const Edit renamed =
            editBetween(m_document.committed(), arranged, {QT_TRANSLATE_NOOP("Message", "Rename a file"), {}});
        !renamed.empty())
        m_document.commit(renamed);
    const NodeId node = m_document.history().current();
    const int generation = m_generation;
    const HeldHistory held{{node, 1, {}}, true};
    using Written = std::pair<Message, FileStamp>;
    const auto write = [file, design = m_document.committed()] {
        Message why = saveDesign(design, file);
        return Written(std::move(why), stampOf(file, true));
    };
    inBackground<Written>(write, savingPool())
        .then(this, [this, file, held, generation, done](const Written& written) {
            if (generation != m_generation)
                return;
            endSaving(file, held, written.first, written.second, done);
        });
}

} // namespace bolster
