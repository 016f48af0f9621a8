// Paints pictures of a scene with OpenGL, beside the GUI thread: a window that is painted by a slow OpenGL cannot
// follow the pointer.
#pragma once

#include "GlPicture.h"
#include "SceneRenderer.h"

#include <QImage>
#include <QOpenGLContext>

#include <future>
#include <stop_token>

class QOffscreenSurface;

namespace bolster {

/// Lives on one thread, with a context that is current there from beginning to end.
class GlPainter {
public:
    struct Request {
        ViewScene scene;
        Camera camera;
        QSize size;                                   ///< pixels
        std::uint64_t version = 0;                    ///< different when something is to be seen differently
        bool moving = false;                          ///< rather quickly than finely
        std::shared_ptr<std::promise<QImage>> finest; ///< if not null: wants the finest picture at once
    };
    struct Picture {
        QImage image; ///< null when OpenGL has failed or the request was stopped
        SurfaceMeshPtr surface;
        std::uint64_t version = 0;
        bool finest = false; ///< asking again makes it no finer
        bool failed = false;
    };

    /// Throws std::runtime_error when there is no OpenGL, or one that is too old.
    explicit GlPainter(QOffscreenSurface& surface);
    ~GlPainter();

    /// Asked again with the same version, it goes on refining.
    Picture paint(const Request& request, const std::stop_token& stop);

private:
    void paintMoving(const Request& request);
    void refine(const Request& request, const std::stop_token& stop);

    QOpenGLContext m_context;
    std::unique_ptr<SceneRenderer> m_renderer;
    std::unique_ptr<GlPicture> m_picture;
    std::uint64_t m_version = 0;
    double m_frameTime = 0.01; ///< of one quick frame of the whole size, seconds
    double m_fineTime = 1;     ///< of a fine one; slow until it is known
};

} // namespace bolster
