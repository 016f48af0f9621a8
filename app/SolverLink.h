// Ties the document to the solver: designs go there, surfaces come back. Nothing else in the program knows the
// solver's thread.
#pragma once

#include "SolverThread.h"

#include <QObject>

#include <memory>

namespace bolster {

class Document;

class SolverLink : public QObject {
    Q_OBJECT

public:
    explicit SolverLink(Document& document, QObject* parent = nullptr);
    ~SolverLink() override;

    /// The newest one; null before the first, and while there is nothing to solve.
    const SurfaceMeshPtr& surface() const { return m_surface; }
    const SolverStatus& status() const { return m_status; }
    /// Of the surface, as of when it last settled.
    const SolveReport& report() const { return m_report; }
    /// The design that `status()` is about is the present one.
    bool upToDate() const;

    /// What the design's files hold, as far as it is known by now.
    void setFiles(DesignFiles files);
    /// While paused the surface stays as it is; afterwards it catches up.
    void setPaused(bool paused);
    /// Whether the forces of cushioning are drawn.
    void setFieldShown(bool shown);
    bool paused() const { return m_paused; }
    void settle();
    /// Another design was opened: its surface has nothing to do with the last one.
    void forget(DesignFiles files);

signals:
    void surfaceChanged(const bolster::SurfaceMeshPtr& surface);
    void fieldChanged(const bolster::FieldPicturePtr& field);
    void statusChanged(const bolster::SolverStatus& status);

private:
    void send();
    void receive();

    Document& m_document;
    DesignFiles m_files;
    SurfaceMeshPtr m_surface;
    FieldPicturePtr m_field;
    SolverStatus m_status;
    SolveReport m_report;
    std::uint64_t m_answered = 0; ///< revision that the newest status answers
    bool m_paused = false;
    std::unique_ptr<SolverThread> m_thread; ///< last: its wake-ups use the rest
};

} // namespace bolster
