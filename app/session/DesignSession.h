// The design that is open: the document, its file, what its files hold, and the journal of all that is done to it.
#pragma once

#include "DesignFile.h"
#include "DesignFolder.h"
#include "Document.h"
#include "WorkJournal.h"

#include <functional>
#include <optional>
#include <set>
#include <stop_token>

namespace bolster {

/// Reading and writing happen off the GUI thread; a function that is handed in is called when they are done, unless
/// the session is gone by then.
class DesignSession : public QObject {
    Q_OBJECT

public:
    using Done = std::function<void(const Message& problem)>; ///< empty: it worked
    /// Asks what becomes of unsaved work, and goes on if nothing is lost.
    using Replace = std::function<void(const std::function<void()>& then)>;

    explicit DesignSession(QObject* parent = nullptr);
    ~DesignSession() override;

    Document& document() { return m_document; }
    WorkJournal& journal() { return m_journal; }
    /// Where Save writes to; "" for a new design, a sample, a restored new design.
    const QString& path() const { return m_path; }
    /// Beside which further files are likely: a sample, too, which is not saved there.
    const QString& besideFile() const { return m_path.isEmpty() ? m_sample : m_path; }
    /// For the window's title.
    QString title() const;
    /// What is changed must be saved under another name.
    bool readOnly() const;
    /// What has been read by now.
    const DesignFiles& files() const { return m_files; }
    /// The same of another version; the rest is read from now on, see fileRead().
    DesignFiles filesOf(const Design& design);
    /// The file that an element means by this name, or "" when it is not there.
    QString findFile(const QString& name) const { return m_folder.find(name); }
    /// Of elements that could not be read and of their files: what only this class knows.
    Problems problems() const;
    /// Everything that was wrong when the file was opened.
    const Problems& problemsOnOpening() const { return m_opened; }

    void startNew();
    /// What new designs begin with: without a fabric a plain one, without an allowance none of their own.
    void setStart(std::optional<Fabric> fabric, std::optional<CutAllowance> allowance);
    enum class Opening {
        ToWork,
        ToLook, ///< without its path: Save asks where
        AsNew   ///< without its path, under its title: what stands there is only where a new design begins
    };
    /// A sample is opened to look. On failure everything stays as it was. What was changed while the file was read
    /// is asked about by `replace`. When stopped, nothing happens, and `done` is not called.
    void open(const QString& path, Opening opening, const Replace& replace, const Done& done,
              const std::stop_token& stop = {});
    /// Goes on with what a crash has left, or what was kept for later. When stopped, it is left as it was, and
    /// `done` is not called.
    void restore(const WorkJournal::Left& left, const Replace& replace, const Done& done,
                 const std::stop_token& stop = {});
    /// As a project, with its whole history, or as a text (".json"): the design alone, with its files beside it.
    void save(const QString& path, const Done& done);
    /// The last save has written nothing, because somebody else has changed the file since it was opened.
    bool changedByOthers() const { return m_changedByOthers; }
    /// The same, because something is in the file's place that was neither read nor written here.
    bool placeTaken() const { return m_placeTaken; }
    /// Gives the place free: what is there keeps another name in its folder, which is returned.
    static Message moveAside(const QString& path, QString* name);
    /// Their versions become a branch, whose last one is called `name`: `tip`, when it worked. Save works again
    /// then.
    void takeTheirs(const QString& name, const std::function<void(const Message& problem, NodeId tip)>& done);
    /// Writes a project that somebody else is to have; the work stays where it is.
    void saveCopy(const QString& path, const SaveOptions& options, const Done& done);
    static bool isProject(const QString& path) { return path.endsWith(u".bolster", Qt::CaseInsensitive); }
    static bool isDesign(const QString& path)
    {
        return isProject(path) || path.endsWith(u".json", Qt::CaseInsensitive);
    }
    /// A save is on its way: what the file will hold is not known yet.
    bool saving() const { return m_saves > 0; }
    /// Writing there would destroy a file that the design refers to.
    bool isElementFile(const QString& path) const;
    /// The window closes.
    void end();

    /// Brings the file to the design and adds an element for it, whose `file` is filled in. With `replaced` it
    /// takes the place of that element.
    Message addWithFile(const QString& source, FileContent content, const Element& element,
                        std::optional<ElementId> replaced = {});

signals:
    void saveEnded();
    /// The design is left for another one, or for good: path() is still its own.
    void leaving();
    /// Another design is there now.
    void opened();
    void titleChanged();
    void filesChanged();
    /// One more, of whatever version.
    void fileRead();
    /// By the user, just now.
    void imported(bolster::ElementId id);
    void problemsChanged();
    /// The design is shown where one stood at the end, which is not where its file stands.
    void wentToLastPlace();
    /// Unsaved work cannot be protected against a crash, until recoveryWorksAgain.
    void recoveryFailed(const bolster::Message& why);
    void recoveryWorksAgain();

private:
    /// A file by its name as elements have it, and what it is read as.
    using FileKey = std::pair<FileKind, QString>;

    struct Opened;

    static FileKey keyOf(const Element& element);
    struct Moment;
    /// A project that is written from a journal, on another thread.
    struct Writing {
        std::function<Message(Journal&)> work;
        std::function<bool()> refused; ///< on purpose: no other journal would do better
    };

    static Opened readProject(WorkJournal::Taken taken, std::shared_ptr<OwnFolder> own,
                              const std::stop_token& stop = {});
    static Opened readDesign(const QString& file, const std::stop_token& stop);
    static Opened readLeft(const WorkJournal::Left& left, const std::stop_token& stop);
    void readNewest(const std::function<Opened(const std::stop_token&)>& read, const Replace& replace,
                    const Done& done, const std::stop_token& stop, const std::function<void(const Opened&)>& take);
    Moment now() const;
    void takeUnlessChanged(const Moment& before, const Replace& replace, const std::function<void()>& take);
    void goToLastPlace();
    void take(const Opened& opened, const QString& path, const QString& folder, const QString& title);
    void leaveWork();
    void saveProject(const QString& file, const Done& done);
    void saveText(const QString& file, const Done& done);
    void endSaving(const QString& file, const std::optional<HeldHistory>& held, const Message& problem,
                   const FileStamp& stamp, const Done& done);
    void besideEdits(const std::shared_ptr<Journal>& journal, const std::function<Message(Journal&)>& work,
                     const Done& done);
    void writeProject(const QString& file, const Writing& writing, const Done& done);
    void writeFromStandIn(const QString& file, const Writing& writing, const Done& done);
    void writeFrom(const std::shared_ptr<Journal>& journal, const Writing& writing, const Done& done);
    void addFiles(const std::shared_ptr<Journal>& journal, const Done& done);
    void renameFiles(const std::map<std::string, std::string>& names);
    void designChanged(const std::set<ElementId>& ids);
    void updateFiles();
    void readMissing(const FileKey& key);
    void takeRead(const FileKey& key, int generation, const ImportedFile& imported);
    void noteFile(const Element& element);
    static ImportedFile readFile(const FileKey& key, const DesignFolder& folder, Journal* journal);

    Document m_document;
    WorkJournal m_journal;
    std::optional<Fabric> m_startFabric;
    std::optional<CutAllowance> m_startAllowance;
    DesignFolder m_folder;
    QString m_path;
    QString m_sample; ///< that was opened
    QString m_title;  ///< of a design without a path
    bool m_onlyToLook = false;
    Problems m_opened;
    std::map<FileKey, ImportedFile> m_known;
    std::set<FileKey> m_reading;
    std::set<QString> m_names; ///< of the files that the design has meant since it was opened
    DesignFiles m_files;
    int m_saves = 0; ///< on their way
    bool m_changedByOthers = false;
    bool m_placeTaken = false;
    std::stop_source m_opening; ///< reads a design in the background; nobody waits for it when this is gone
    int m_generation = 0;       ///< counts designs, so that late results of an earlier one are dropped
};

} // namespace bolster
