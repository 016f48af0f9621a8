// Writing projects and designs.
#include "Background.h"
#include "DesignSession.h"
#include "ElementEdits.h"
#include "Project.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTimer>

#include <chrono>

namespace bolster {

namespace {

using namespace std::chrono_literals;

/// Not over what somebody else has made of the project meanwhile.
Message saveOurs(Journal& journal, const QString& file)
{
    if (QFileInfo::exists(file)) {
        const OpenedProject there = openProject(file);
        if (there.problem.empty() && journal.base() && there.seal != *journal.base())
            return {QT_TRANSLATE_NOOP("Message",
                                      "somebody else has changed it since it was opened here; save under "
                                      "another name, or open it to see the changes"),
                    {}};
    }
    return journal.save(file);
}

} // namespace

void DesignSession::save(const QString& path, const Done& done)
{
    const QString file = QFileInfo(path).absoluteFilePath();
    m_saving = m_document.history().current();
    if (isProject(file))
        saveProject(file, done);
    else
        saveText(file, done);
}

void DesignSession::saveProject(const QString& file, const Done& done)
{
    addFiles([this, file, done](const Message& problem) {
        if (!problem.empty()) {
            endSaving(file, {}, problem, done);
            return;
        }
        const NodeId node = m_document.history().current();
        m_saving = node;
        const bool ours = file == m_path;
        withJournal([file, ours](Journal& journal) { return ours ? saveOurs(journal, file) : journal.save(file); },
                    [this, file, node, done](const Message& why) { endSaving(file, node, why, done); });
    });
}

void DesignSession::saveCopy(const QString& path, const SaveOptions& options, const Done& done)
{
    addFiles([this, path, options, done](const Message& problem) {
        if (problem.empty())
            withJournal([path, options](Journal& journal) { return journal.saveCopy(path, options); }, done);
        else
            done(problem);
    });
}

void DesignSession::endSaving(const QString& file, std::optional<NodeId> node, const Message& problem,
                              const Done& done)
{
    m_saving.reset();
    if (problem.empty()) {
        m_path = file;
        m_journal.move({file, m_folder.folder()});
        m_document.markSaved(*node);
        emit titleChanged();
    }
    done(problem);
    emit saveEnded();
}

/// Gives the journal to `work` beside the GUI thread, when no other work has it; edits wait meanwhile. `done` is
/// not called when another design was opened.
void DesignSession::withJournal(const std::function<Message(Journal&)>& work, const Done& done)
{
    const int generation = m_generation;
    if (!m_journal.writable()) { // a save is on its way
        QTimer::singleShot(20ms, this, [this, generation, work, done] {
            if (generation == m_generation)
                withJournal(work, done);
        });
        return;
    }
    m_journal.suspend();
    inBackground<Message>([journal = m_journal.journal(), work] {
        return work(*journal);
    }).then(this, [this, generation, done](const Message& problem) {
        if (generation != m_generation)
            return;
        m_journal.resume();
        done(problem);
    });
}

/// The files that the design uses become part of the project.
void DesignSession::addFiles(const Done& done)
{
    if (const Message problem = m_journal.prepare(); !problem.empty()) {
        done(problem);
        return;
    }
    std::map<std::string, QString> files;
    for (const auto& [key, imported] : m_known)
        if (const QString file = m_folder.find(key.second); !file.isEmpty())
            files[key.second.toStdString()] = file;
    auto names = std::make_shared<std::map<std::string, std::string>>(); // as the project has them
    withJournal(
        [files, names](Journal& journal) {
            for (const auto& [name, file] : files) {
                std::string kept = name;
                if (Message problem = journal.addAsset(kept, file); !problem.empty())
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
    Design arranged;
    if (const Message problem = m_folder.copyTo(folder, m_document.committed(), &arranged); !problem.empty()) {
        endSaving(file, {}, problem, done);
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
    m_saving = node;
    inBackground<Message>([file, design = m_document.committed()] {
        return saveDesign(design, file);
    }).then(this, [this, file, node, generation, done](const Message& problem) {
        if (generation != m_generation)
            return;
        if (problem.empty())
            m_journal.savedAsText(node);
        endSaving(file, node, problem, done);
    });
}

} // namespace bolster
