// The journal of the design that is being worked on: what a document has done is on the disk before anybody sees
// it.
#pragma once

#include "Document.h"
#include "FileStamp.h"
#include "Journal.h"

#include <QDateTime>
#include <QLockFile>
#include <QTimer>

#include <functional>
#include <set>
#include <vector>

namespace bolster {

class TemporaryFile;

/// Journals lie in the user's local state folder (AppLocalDataLocation/journals): UUID.bolster, beside it
/// UUID.about with where the work belongs, and UUID.lock, which tells those of running programs from those that a
/// crash has left. A design that nothing has been done to has none.
class WorkJournal : public QObject {
    Q_OBJECT

public:
    /// Where work belongs.
    struct Place {
        QString original;     ///< the project or design that is edited; empty for a new one
        QString files;        ///< the folder in which the design's files are found; empty when it has none
        FileStamp stamp = {}; ///< of the original when it was read or written here for the last time
        QString title = {};   ///< what it is called while it has no original: that of a sample

        friend bool operator==(const Place&, const Place&) = default;
    };
    /// What a crash has left, or what somebody has kept for later.
    struct Left {
        Place place;
        QDateTime when;       ///< of the last edit
        QString journal;      ///< the file
        bool kept = false;    ///< on purpose
        bool damaged = false; ///< it was set aside: there is nothing but salvageJournal
    };
    /// A journal of one's own, with what is in it. `project.problem` says why there is none.
    struct Taken {
        std::shared_ptr<QLockFile> lock;
        std::shared_ptr<Journal> journal;
        QString base; ///< path of the journal without its ending
        OpenedProject project;
        HeldHistory held; ///< what the file holds of the project's history
    };

    /// Of no running program, newest first; those without unsaved work are removed. Long histories take a while
    /// when they are looked at for the first time. May be called on any thread.
    static QList<Left> left();
    /// The same of one project or design: no others are opened. A journal that does not say where it belongs is
    /// known by the name that all copies of a project share.
    static std::optional<Left> leftOf(const QString& original);
    /// A running program, this one or another, works on this project or design.
    static bool isWorkedOn(const QString& original);
    /// These may be called on any thread.
    static Taken takeProject(const QString& project);
    static Taken takeLeft(const Left& left);
    /// Of one that cannot be opened: it stays where it is, and nobody tries again. Nothing when it can be opened,
    /// or another program has it.
    static std::optional<Left> setAside(const Left& left);
    /// Those, newest first.
    static QList<Left> damaged();
    /// How long work that was put into the bin is kept there: days, at first and at least 30.
    static void setDaysInBin(int days);
    static int daysInBin();
    /// Kept for so many days more, then gone.
    static void putIntoBin(const Left& left);
    static void emptyBin();
    /// The folders of files of all work that is there, be it in the bin.
    static QStringList filesInUse();

    /// The document must outlive it; it is not touched by the destructor.
    explicit WorkJournal(Document& document, QObject* parent = nullptr);
    /// As end().
    ~WorkJournal() override;

    /// Follows the document, which has just been reset: to a design that is not in a project, or to `taken`.
    void start(const Place& place, const Taken& taken = {});
    /// The work belongs there from now on; what the file there holds, the document says.
    void move(const Place& place);
    const Place& place() const { return m_place; }
    /// Where somebody stood when the project was closed, unless its file was written since.
    std::optional<NodeId> lastPlace() const;
    /// What becomes of unsaved work when it ends; otherwise it is found at the next start.
    enum class Fate { Leave, KeepForLater, Bin };
    void setFate(Fate fate) { m_fate = fate; }
    /// Stops following, before the document is reset. Without unsaved work nothing remains but where one stood.
    void end();

    /// Makes sure that all that was done is in the journal, and that there is one.
    Message catchUp();
    /// The last step could not be stored, or where the work belongs: what is done is accepted, and kept in memory.
    bool failing() const { return m_failing; }
    /// The folder in which all journals are.
    static QString folder();
    /// A journal on the disk of a file that is to be saved, where that of all journals takes nothing more.
    struct StandIn {
        std::unique_ptr<TemporaryFile> file; ///< goes last
        std::unique_ptr<Journal> journal;    ///< null when `problem` says why
        Message problem;

        StandIn();
        StandIn(const StandIn&) = delete;
        StandIn& operator=(const StandIn&) = delete;
        ~StandIn();
    };
    /// Makes one, on any thread, with what the journal has. Then catchUp(standIn) brings the rest.
    std::function<std::shared_ptr<StandIn>(const QString& target)> standIns();
    Message catchUp(Journal& standIn) const;
    /// It was saved from there.
    void savedBy(const Journal& standIn);
    /// Null before the first edit.
    const std::shared_ptr<Journal>& journal() const { return m_journal; }
    /// Journal::takeIn, for the document too. `tip` is told where they were.
    Message takeIn(const OpenedProject& theirs, const std::string& name, NodeId& tip);

signals:
    /// What is done is not protected until worksAgain(). It is tried again by and by, and with every step.
    void failed(const bolster::Message& why);
    /// All that was done is in the journal now, or another design was opened.
    void worksAgain();

private:
    void follow();
    Message store();
    Message prepare();
    Message bringBack();
    Message writeAbout() const;
    void setFailing(const Message& problem);

    Document& m_document;
    Design m_root; ///< what a new journal begins with
    Place m_place;
    Fate m_fate = Fate::Leave;
    QString m_base;
    std::shared_ptr<QLockFile> m_lock;
    std::shared_ptr<Journal> m_journal;
    std::vector<std::shared_ptr<Journal>> m_gone; ///< their files were removed, but the history may still read them
    std::set<NodeId> m_renamed;                   ///< these names are not in the journal yet
    std::shared_ptr<Journal::Identity> m_identity; ///< while there is no journal, but a stand-in has saved
    std::optional<Hash> m_savedSeal;               ///< the same: of the file
    QTimer m_again;                                ///< runs while it is failing
    bool m_aboutBehind = false;
    bool m_following = false;
    bool m_failing = false;
};

} // namespace bolster
