// The journal of a project: makes every edit durable before a window shows it as done.
#pragma once

#include "DesignHash.h"
#include "Project.h"

#include <functional>
#include <mutex>

namespace bolster {

class SealedRows;

/// What a copy of a project leaves out, for a file that goes to somebody else.
struct SaveOptions {
    bool withHistory = true; ///< else only the current design
    bool withScans = true;
};

/// Lies in the user's own folder, never where sync clients are. Nobody else can open it meanwhile. No function
/// throws; each one returns what went wrong, or an empty message, and then has changed nothing. Any thread may call
/// any function: what takes long (saving, adding files) lets edits of other threads in between.
class Journal {
public:
    struct Opened {
        std::unique_ptr<Journal> journal; ///< null when project.problem says why
        OpenedProject project;
    };

    /// What a journal and its stand-ins have in common: a version that is stored in several of them is one version.
    struct Identity {
        std::string uuid;
        std::map<NodeId, std::string> uids; ///< of nodes that are not stored yet
        std::int64_t began = 0;             ///< when the first version was made, ms since 1970 UTC; 0: now
    };

    /// That of a new project; there must be no such file. `vfs` is for tests that simulate disks; `began` as of an
    /// identity.
    static Opened create(const QString& path, const Design& design, const char* vfs = nullptr,
                         std::int64_t began = 0);
    /// The same with a known name.
    static Opened create(const QString& path, const Design& design, std::shared_ptr<Identity> identity);
    /// For a project that has no journal yet, because its disk takes nothing: as standIn().
    static Opened createStandIn(const QString& path, const Design& design, std::shared_ptr<Identity> identity);
    /// That of a project file, as a copy of it; there must be no such file.
    static Opened begin(const QString& project, const QString& path);
    /// One that is there, whatever happened to the program that wrote it.
    static Opened open(const QString& path, const char* vfs = nullptr);
    /// When the disk of this one takes nothing more: another one with all that is in it, to save from. `path` is an
    /// empty file that is gone afterwards: nothing in it is durable.
    Opened standIn(const QString& path);
    /// Takes the place of this one, whose file somebody has removed: it holds the same. This one stays open for
    /// edits that are not read yet.
    Opened successor(const QString& path);
    /// The file is free then; edits that a history has not loaded yet cannot be read any more.
    ~Journal();

    /// Stores, as one durable step, the nodes that are new in the history, where it stands, and the ways for redo.
    /// The design is that of the current node. Whoever makes an edit asks refusal(edit) before it gets into the
    /// history.
    Message record(const History& history, const Design& design);
    /// What a version is called, and the branch that begins with it; "" for nothing.
    Message setNames(NodeId node, const std::string& version, const std::string& branch = {});
    /// Keeps a file by its content. `name` is what an element is to say as its "file"; it is changed when the
    /// project knows another content by this name, for older versions of the design still mean that.
    Message addAsset(std::string& name, const QString& file);
    /// Whether another file cannot have this name.
    bool hasAsset(const std::string& name);
    /// Writes a file that is kept here into a folder, under its name.
    Message extractAsset(const std::string& name, const QString& folder);
    /// A picture of a node, which may get lost: nothing else depends on it.
    Message setThumbnail(NodeId node, const std::string& png);
    /// "" when there is none. It comes from the file: nobody has looked into it.
    std::string thumbnail(NodeId node);

    /// Writes the project, as it is when this begins, to a file beside `path`, checks it, and puts it in the place
    /// of `path`, which holds the old bytes or the new ones at any moment. `held` is told what is in it. What goes
    /// wrong in the journal after that is not the file's fault: the next step tells.
    Message save(const QString& path, HistoryMark* held = nullptr);
    /// The same for a copy: what is saved elsewhere does not count as saved.
    Message saveCopy(const QString& path, const SaveOptions& options);
    /// The seal that the project file had when it was last saved or opened: another one means that somebody else
    /// has changed it.
    std::optional<Hash> base() const;
    /// A stand-in has saved the project: the file, which has this seal, is ours.
    void setBase(const Hash& seal);
    /// The project's name among all, 16 bytes.
    const std::string& uuid() const { return m_identity->uuid; }

    /// What the file of this project has that is not here.
    enum class Theirs { NothingNew, MoreVersions, AnotherProject };
    Theirs compare(const OpenedProject& theirs);
    /// Whether all versions and names that are stored here are in that file, too.
    bool isIn(const OpenedProject& file);
    /// Versions of somebody else that are stored here now.
    struct TakenIn {
        std::vector<History::Node> nodes;       ///< for the history, after all that it has
        std::map<NodeId, std::string> names;    ///< of versions that were here, and had none
        std::map<NodeId, std::string> branches; ///< the same of branches
        NodeId tip = 0;                         ///< where they were
        std::shared_ptr<StoredEdits> edits;
    };
    /// Takes in all of their versions, names and files that are not here; they hang where they were made. Where
    /// they were is called `name`, if they have not named it. What is here stays as it is, and the file counts as
    /// known then. `history` is all that was recorded.
    Message takeIn(const OpenedProject& theirs, const std::string& name, const History& history, TakenIn& taken);

private:
    struct Step; // one that is being stored
    class Moment;

    Journal(std::shared_ptr<Database> database, std::shared_ptr<Identity> identity);
    static Opened opened(std::shared_ptr<Database> database, std::shared_ptr<Identity> identity = {});
    static Opened createIn(std::shared_ptr<Database> database, const Design& design,
                           std::shared_ptr<Identity> identity);
    Opened copyTo(const QString& path, void (*prepare)(Database&));
    Message guarded(const std::function<void()>& work);
    static Message caught(const std::function<void()>& work);
    void store(Step& step, const History& history, NodeId id, const Design& design);
    void storeRedo(Step& step, const History& history);
    void accept(Step& step, NodeId current);
    void snapshotBeforeSave();
    HistoryMark mark();
    void rememberSaved(const Hash& seal, NodeId version);
    void takeNode(Step& step, const OpenedProject& theirs, NodeId node, std::vector<NodeId>& places,
                  TakenIn& taken);
    static void takeNames(Step& step, const OpenedProject& theirs, const std::vector<NodeId>& places,
                          const History& history, const std::string& name, TakenIn& taken);
    static void keepRedo(Step& step, const History& history, const TakenIn& taken);

    std::mutex m_longWork;                // one thread at a time saves or adds files
    std::shared_ptr<Database> m_database; // who has locked it has all below
    std::shared_ptr<Identity> m_identity;
    std::optional<Hash> m_base;
    HashSum m_seal;
    DesignHash m_designHash;
    std::vector<Hash> m_rowHashes;    // of the nodes that are stored
    std::vector<int> m_sinceSnapshot; // edits, by node
    NodeId m_passingSnapshot = -1;    // only for the last save; -1: none
    std::map<NodeId, NodeId> m_redo;  // as stored: where it is not the newest child
    NodeId m_current = 0;             // as stored, and its design
    Design m_design;
    std::int64_t m_run = 1;
    bool m_behind = false; // the last record failed
};

} // namespace bolster
