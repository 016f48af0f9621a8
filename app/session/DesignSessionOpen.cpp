// Opening designs and projects.
#include "Background.h"
#include "DesignSession.h"
#include "ElementEdits.h"
#include "Project.h"
#include "Samples.h"
#include "Templates.h"

#include <QFileInfo>

#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>
#include <stop_token>

namespace bolster {

/// What was read in the background.
struct DesignSession::Opened {
    OpenedDesign design;
    WorkJournal::Taken journal;     // of a project
    std::shared_ptr<OwnFolder> own; // in which its files are
    FileStamp stamp;                // of the file, before it was read
};

/// What tells whether something was done since.
struct DesignSession::Moment {
    std::uint64_t revision = 0;
    HistoryMark mark;

    bool operator==(const Moment&) const = default;
};

void DesignSession::setStart(std::optional<Fabric> fabric, std::optional<CutAllowance> allowance)
{
    m_startFabric = std::move(fabric);
    m_startAllowance = allowance;
}

void DesignSession::startNew()
{
    const Design empty;
    Settings settings = empty.settings();
    settings.cutting.allowance = m_startAllowance;
    const Design set = empty.with(edits::replaceElement(empty, settingsId, makeElement(settings), {}));
    const Fabric fabric = m_startFabric.value_or(Fabric{tr("Fabric").toStdString()});
    take({{set.with(edits::addElement(set, makeElement(fabric))), {}, {}, true}, {}, {}, {}}, {}, {}, {});
}

DesignSession::Moment DesignSession::now() const
{
    return {m_document.revision(), m_document.mark()};
}

/// Something may have been done while another design was read.
void DesignSession::takeUnlessChanged(const Moment& before, const Replace& replace,
                                      const std::function<void()>& take)
{
    if (now() == before)
        take();
    else
        replace(take);
}

/// The current design of a project; its files are put into the folder.
DesignSession::Opened DesignSession::readProject(WorkJournal::Taken taken, std::shared_ptr<OwnFolder> own,
                                                 const std::stop_token& stop)
{
    Opened opened;
    if (!taken.journal) {
        opened.design.problems.push_back({{}, {}, {}, taken.project.problem});
        return opened;
    }
    if (!own) {
        opened.design.problems.push_back(
            {{}, {}, {}, {QT_TRANSLATE_NOOP("Message", "there is no place for the files of this project"), {}}});
        return opened;
    }
    const Design& design = taken.project.design;
    Problems lacking = extractAssets(taken.project, design, own->path());
    opened.design = openReadDesign({design, {}, true}, own->path(), stop);
    std::ranges::move(lacking, std::back_inserter(opened.design.problems));
    opened.journal = std::move(taken);
    opened.own = std::move(own);
    return opened;
}

DesignSession::Opened DesignSession::readDesign(const QString& file, const std::stop_token& stop)
{
    const bool project = looksLikeProject(file);
    const FileStamp stamp = stampOf(file, !project);
    if (!project)
        return {openDesign(file, {}, stop), {}, {}, stamp};
    Opened opened = readProject(WorkJournal::takeProject(file), OwnFolder::make(), stop);
    opened.stamp = stamp;
    return opened;
}

/// In the folder that it had, if that was one of ours; what lies elsewhere belongs to the user, and is copied.
DesignSession::Opened DesignSession::readLeft(const WorkJournal::Left& left, const std::stop_token& stop)
{
    WorkJournal::Taken taken = WorkJournal::takeLeft(left);
    if (stop.stop_requested())
        return {};
    auto own = taken.journal ? OwnFolder::takeOver(left.place.files) : nullptr;
    if (own) {
        own->keep(); // for the work, whatever comes of this
    } else if (taken.journal) {
        own = OwnFolder::make();
        DesignFolder elsewhere;
        elsewhere.start(left.place.files);
        Design copied;
        if (own)
            (void)elsewhere.copyTo(own->path(), taken.project.design, &copied); // what is missing is reported
    }
    Opened opened = readProject(std::move(taken), std::move(own), stop);
    opened.stamp = left.place.stamp;
    return opened;
}

/// In the background. Takes it unless it was stopped, or something else was asked for meanwhile.
void DesignSession::readNewest(const std::function<Opened(const std::stop_token&)>& read, const Replace& replace,
                               const Done& done, const std::stop_token& stop,
                               const std::function<void(const Opened&)>& take)
{
    const int generation = ++m_generation;
    m_opening.request_stop(); // only the newest is wanted
    m_opening = {};
    using Cancelled = std::stop_callback<std::function<void()>>;
    const auto cancelled =
        std::make_shared<Cancelled>(stop, [source = m_opening]() mutable { source.request_stop(); });
    inBackground<Opened>([read, reading = m_opening.get_token()] { return read(reading); })
        .then(this, [this, generation, before = now(), replace, done, take, cancelled,
                     reading = m_opening.get_token()](const Opened& opened) {
            if (generation != m_generation || reading.stop_requested())
                return;
            if (opened.design.readable)
                takeUnlessChanged(before, replace, [take, opened] { take(opened); });
            else
                done(opened.design.problems.empty()
                         ? Message{QT_TRANSLATE_NOOP("Message", "the file is not a design"), {}}
                         : opened.design.problems.front().message);
        });
}

void DesignSession::open(const QString& path, Opening opening, const Replace& replace, const Done& done,
                         const std::stop_token& stop)
{
    const QString file = QFileInfo(path).absoluteFilePath();
    const auto read = [file](const std::stop_token& reading) { return readDesign(file, reading); };
    readNewest(read, replace, done, stop, [this, file, opening, done](const Opened& opened) {
        const bool pathless = opening != Opening::ToWork || isSample(file);
        take(opened, pathless ? QString() : file, QFileInfo(file).absolutePath(),
             opening == Opening::AsNew ? templateTitle(file) : titleOf(file));
        m_sample = isSample(file) ? file : QString();
        m_onlyToLook = opening == Opening::ToLook;
        if (m_onlyToLook)
            emit titleChanged();
        if (opened.journal.journal)
            goToLastPlace();
        done({});
    });
}

void DesignSession::restore(const WorkJournal::Left& left, const Replace& replace, const Done& done,
                            const std::stop_token& stop)
{
    const auto read = [left](const std::stop_token& reading) { return readLeft(left, reading); };
    readNewest(read, replace, done, stop, [this, left, done](const Opened& opened) {
        const QString& original = left.place.original;
        take(opened, isSample(original) ? QString() : original, left.place.files,
             left.place.title.isEmpty() ? tr("Restored design") : left.place.title);
        done({});
    });
}

void DesignSession::take(const Opened& opened, const QString& path, const QString& folder, const QString& title)
{
    ++m_generation;
    leaveWork();
    m_folder.start(folder, opened.own);
    m_path = path;
    m_sample.clear();
    m_title = title;
    m_saves = 0;
    m_onlyToLook = false;
    m_opened = opened.design.problems;
    m_known.clear();
    m_reading.clear();
    m_names.clear();
    const Design& design = opened.design.design;
    const DesignFiles& files = opened.design.files;
    for (const auto& [id, element] : design.elements()) {
        const auto mesh = files.meshes.find(id);
        const auto cloud = files.clouds.find(id);
        if (mesh != files.meshes.end())
            m_known[keyOf(*element)] = {{mesh->second, nullptr}, {}};
        else if (cloud != files.clouds.end())
            m_known[keyOf(*element)] = {{nullptr, cloud->second}, {}};
    }
    for (const Problem& problem : m_opened)
        if (const ElementPtr element = design.element(problem.element);
            element && problem.field == "file" && hasShapeFile(*element))
            if (ImportedFile& file =
                    m_known.try_emplace(keyOf(*element), ImportedFile{{}, problem.message}).first->second;
                file.content)
                file.warning = problem.message;
    if (const OpenedProject& project = opened.journal.project; opened.journal.journal) {
        m_document.reset(design, project.history);
        m_document.setHeld(opened.journal.held);
        inBackground<ElementId>([project] {
            return largestIdEver(project);
        }).then(this, [this, generation = m_generation](ElementId largest) {
            if (generation == m_generation)
                m_document.spendIds(largest);
        });
    } else {
        m_document.reset(design);
    }
    m_journal.start({path, m_folder.folder(), opened.stamp, path.isEmpty() ? title : QString()}, opened.journal);
    for (const auto& [id, element] : design.elements())
        noteFile(*element);
    updateFiles();
    emit titleChanged();
    emit problemsChanged();
    emit DesignSession::opened();
}

/// Merely standing somewhere is nothing to ask about, and nothing to write a file for.
void DesignSession::goToLastPlace()
{
    const auto place = m_journal.lastPlace();
    if (!place || *place == m_document.history().current())
        return;
    m_document.jumpTo(*place);
    if (m_document.history().current() == *place)
        emit wentToLastPlace();
}

} // namespace bolster
