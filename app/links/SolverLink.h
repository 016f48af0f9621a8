// Ties the document to the solver: designs go there, surfaces come back. Nothing else in the program knows the
// solver's thread.
#pragma once

#include "CoverGlide.h"
#include "SolverThread.h"

#include <QObject>
#include <QPointer>

#include <functional>
#include <memory>
#include <vector>

namespace bolster {

class Document;
class RestingCache;

class SolverLink : public QObject {
    Q_OBJECT

public:
    /// `kept`: of another one, which has surfaces of the same design's versions.
    explicit SolverLink(Document& document, QObject* parent = nullptr,
                        std::shared_ptr<RestingCache> kept = nullptr);
    ~SolverLink() override;

    /// The newest one; null before the first, and while there is nothing to solve. During a gesture it is the live
    /// surface, otherwise the resting one of this design or, until that is known, of the one before.
    const SurfaceMeshPtr& surface() const { return m_surface; }
    const SolverStatus& status() const { return m_status; }
    /// Of the surface, as of when it last came to rest.
    const SolveReport& report() const { return m_report; }
    /// Document::revision() of the design that surface() is of.
    std::uint64_t designRevision() const { return m_answered; }
    /// For others that solve versions of this design.
    const std::shared_ptr<RestingCache>& kept() const { return m_thread->kept(); }
    /// The design that `surface()` is of, or that cannot be solved, is the present one.
    bool upToDate() const;
    /// surface() is the resting surface of the present design, and no gesture is running.
    bool atRest() const;
    using Then = std::function<void(const SurfaceMeshPtr&)>;
    /// Calls `then` once with the resting surface of the design as it is by then: at once, or when it is there.
    /// With null when there will be none: nothing to solve, failed, paused. Never after the context is gone.
    void whenAtRest(QObject* context, Then then);

    /// What the design's files hold, as far as it is known by now.
    void setFiles(DesignFiles files);
    /// While paused the surface stays as it is; afterwards it catches up.
    void setPaused(bool paused);
    /// Whether the forces of cushioning are drawn.
    void setFieldShown(bool shown);
    bool paused() const { return m_paused; }
    /// Another design was opened: its surface has nothing to do with the last one.
    void forget(DesignFiles files);

    /// The cover glides from one surface to the next; so it does at first.
    void setGliding(bool glides) { m_glide.setAnimated(glides); }

signals:
    void surfaceChanged(const bolster::SurfaceMeshPtr& surface);
    /// What is to be seen: the surface, or a step on the short way from the last one to it.
    void surfaceShown(const bolster::SurfaceMeshPtr& surface);
    /// After a gesture the resting surface lies this far (mm) from where the gesture had led.
    void sprang(double distance);
    void fieldChanged(const bolster::FieldPicturePtr& field);
    void statusChanged(const bolster::SolverStatus& status);

private:
    void send();
    void sendAfterGesture();
    void receive();
    void takeSurface(SurfaceMeshPtr surface, const SurfaceMeshPtr& from);
    void answerWaiting();

    Document& m_document;
    DesignFiles m_files;
    SurfaceMeshPtr m_surface;
    FieldPicturePtr m_field;
    SolverStatus m_status;
    SolveReport m_report;
    std::uint64_t m_answered = 0; ///< revision that the surface answers
    bool m_sentInGesture = false; ///< the last request
    bool m_paused = false;
    struct Waiting {
        QPointer<QObject> context;
        Then then;
    };
    std::vector<Waiting> m_waiting; ///< for the resting surface
    CoverGlide m_glide;
    std::unique_ptr<SolverThread> m_thread; ///< last: its wake-ups use the rest
};

} // namespace bolster
