// The design that is open: the document, its file, the meshes of its frames, and the copy for the start after a
// crash.
#pragma once

#include "DesignFile.h"
#include "DesignFiles.h"
#include "Document.h"
#include "FrameFiles.h"
#include "Recovery.h"

#include <QSet>

#include <functional>
#include <optional>

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
    const FrameMeshes& frames() const { return m_frames; }
    /// What the solver may use of them.
    DesignFiles contents() const { return {m_frames, {}}; }
    /// Of elements that could not be read and of frame files: what only this class knows.
    Problems problems() const;
    /// Everything that was wrong when the file was opened.
    const Problems& problemsOnOpening() const { return m_opened; }

    void startNew();
    /// A sample is opened without its path. On failure everything stays as it was. What was changed while the file
    /// was read is asked about by `replace`.
    void open(const QString& path, const Replace& replace, const Done& done);
    void restore(const Recovery::Orphan& orphan, const Replace& replace, const Done& done);
    /// Removes what a crash has left, with the frames that lay beside it alone.
    static void discard(const Recovery::Orphan& orphan);
    void save(const QString& path, const Done& done);
    /// A save of the design as it is now is on its way.
    bool savingAll() const { return m_saving == m_document.history().current(); }
    /// Writing there would destroy a mesh that the design shows.
    bool isElementFile(const QString& path) const;
    /// Nothing of the unsaved work is to be kept.
    void discardWork();
    /// The window closes; unsaved work that was not discarded is found at the next start.
    void end();

    /// Brings the file to the design and adds a frame for it; `frame.file` is filled in. With `replaced` the mesh
    /// of an existing frame is exchanged, its name kept.
    Message addFrame(const QString& source, std::shared_ptr<const TriangleMesh> mesh, Frame frame,
                     std::optional<ElementId> replaced = {});

signals:
    void saveEnded();
    /// Another design is there now.
    void opened();
    void titleChanged();
    void framesChanged();
    /// By the user, just now.
    void frameImported(bolster::ElementId id);
    void problemsChanged();
    /// Unsaved work cannot be protected against a crash.
    void recoveryFailed(const bolster::Message& why);

private:
    void takeUnlessChanged(std::uint64_t revision, const Replace& replace, const std::function<void()>& take);
    void take(OpenedDesign opened, const QString& path, const QString& folder, const QString& title);
    void designChanged(const std::set<ElementId>& ids);
    void updateFrames();
    void readMissing(const QString& file);

    Document m_document;
    Recovery m_recovery;
    FrameFiles m_files;
    QString m_path;
    QString m_title; ///< of a design without a path
    Problems m_opened;
    /// By file name as frames have it; null: could not be read, with the reason below.
    std::map<QString, std::shared_ptr<const TriangleMesh>> m_meshes;
    std::map<QString, Message> m_meshProblems;
    QSet<QString> m_reading;
    FrameMeshes m_frames;
    bool m_workDiscarded = false;
    std::optional<NodeId> m_saving; ///< what is being written
    int m_generation = 0;           ///< counts designs, so that late results of an earlier one are dropped
};

} // namespace bolster
