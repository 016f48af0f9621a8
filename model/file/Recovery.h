// A copy of unsaved work, for the start after a crash.
#pragma once

#include "Document.h"

#include <QLockFile>
#include <QThreadPool>
#include <QTimer>

#include <memory>

namespace bolster {

/// While the document is dirty, its committed design lies as text in the user's local state folder
/// (AppLocalDataLocation/recovery/UUID.json, the path of the original beside it in UUID.origin), at most two
/// seconds old. The copy goes when the document is saved. A lock file, UUID.lock, tells the copies of running
/// programs from those that a crash has left.
class Recovery : public QObject {
    Q_OBJECT

public:
    struct Orphan {
        QString original; ///< the file that was being edited; empty for a new design
        QDateTime when;   ///< of the last change that is in the copy
        QString file;     ///< the copy: openDesign(file, frameFolder()) reads it

        /// Where the frames lie that the copy refers to.
        QString frameFolder() const;
        /// The original was saved after the copy: whoever writes the copy over it loses that.
        bool fileIsNewer() const;
    };

    /// The copies that no running program owns, newest first.
    static QList<Orphan> orphans();
    /// Removes a copy that the user doesn't want.
    static void discard(const Orphan& orphan);

    /// The document must live as long as anything can change it through its event loop; it is not touched by the
    /// destructor.
    explicit Recovery(Document& document, QObject* parent = nullptr);
    /// Leaves the copy of unsaved work where it is: nobody said that it may go.
    ~Recovery() override;

    /// The file that the document was read from or saved to; empty for a new one.
    void setOriginal(const QString& path);
    /// Takes over a copy: from now on it is this document's own, and is replaced and removed like it. So a restored
    /// design is never without a copy. Reset the document to the copy's design, mark it unsaved, then call this.
    /// False when another program has taken it meanwhile.
    bool adopt(const Orphan& orphan);
    /// The user has chosen not to keep the unsaved work (close, open another design).
    void discard();

signals:
    /// A copy could not be written; the work is not protected until a later one succeeds.
    void failed(const bolster::Message& why);

private:
    void follow();
    void write();
    void remove();
    bool lock();

    Document& m_document;
    Design m_unsaved; // what is to be written
    QString m_base;   // path of the copy without its ending
    QString m_original;
    std::unique_ptr<QLockFile> m_lock; // from the first copy on
    QTimer m_timer;
    QThreadPool m_jobs; // one thread: jobs run in the order of their start
};

} // namespace bolster
