// The design that is open: the document, its file, what its files hold, and the copy for the start after a
// crash.
#pragma once

#include "DesignFile.h"
#include "DesignFolder.h"
#include "Document.h"
#include "Recovery.h"

#include <functional>
#include <optional>
#include <set>

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
    /// Where Save writes to; "" for a new design, a sample, a restored new design.
    const QString& path() const { return m_path; }
    /// For the window's title.
    QString title() const;
    /// What has been read by now.
    const DesignFiles& files() const { return m_files; }
    /// Of elements that could not be read and of their files: what only this class knows.
    Problems problems() const;
    /// Everything that was wrong when the file was opened.
    const Problems& problemsOnOpening() const { return m_opened; }

    void startNew();
    /// A sample is opened without its path. On failure everything stays as it was. What was changed while the file
    /// was read is asked about by `replace`.
    void open(const QString& path, const Replace& replace, const Done& done);
    void restore(const Recovery::Orphan& orphan, const Replace& replace, const Done& done);
    /// Removes what a crash has left, with the files that lay beside it alone.
    static void discard(const Recovery::Orphan& orphan);
    void save(const QString& path, const Done& done);
    /// A save of the design as it is now is on its way.
    bool savingAll() const { return m_saving == m_document.history().current(); }
    /// Writing there would destroy a file that the design refers to.
    bool isElementFile(const QString& path) const;
    /// Nothing of the unsaved work is to be kept.
    void discardWork();
    /// The window closes; unsaved work that was not discarded is found at the next start.
    void end();

    /// Brings the file to the design and adds an element for it, whose `file` is filled in. With `replaced` it
    /// takes the place of that element.
    Message addWithFile(const QString& source, FileContent content, const Element& element,
                        std::optional<ElementId> replaced = {});

signals:
    void saveEnded();
    /// Another design is there now.
    void opened();
    void titleChanged();
    void filesChanged();
    /// By the user, just now.
    void imported(bolster::ElementId id);
    void problemsChanged();
    /// Unsaved work cannot be protected against a crash.
    void recoveryFailed(const bolster::Message& why);

private:
    /// A file by its name as elements have it, and what it is read as.
    using FileKey = std::pair<FileKind, QString>;

    static FileKey keyOf(const Element& element);
    void takeUnlessChanged(std::uint64_t revision, const Replace& replace, const std::function<void()>& take);
    void take(OpenedDesign opened, const QString& path, const QString& folder, const QString& title);
    void designChanged(const std::set<ElementId>& ids);
    void updateFiles();
    void readMissing(const FileKey& key);

    Document m_document;
    Recovery m_recovery;
    DesignFolder m_folder;
    QString m_path;
    QString m_title; ///< of a design without a path
    Problems m_opened;
    std::map<FileKey, ImportedFile> m_known;
    std::set<FileKey> m_reading;
    DesignFiles m_files;
    bool m_workDiscarded = false;
    std::optional<NodeId> m_saving; ///< what is being written
    int m_generation = 0;           ///< counts designs, so that late results of an earlier one are dropped
};

} // namespace bolster
