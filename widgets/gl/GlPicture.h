// A picture that gets finer with every frame: the mean of frames that are moved by parts of a pixel.
#pragma once

#include "GlBuffer.h"
#include "GlProgram.h"

#include <QImage>
#include <QOpenGLFramebufferObject>

#include <functional>

namespace bolster {

/// A context must be current whenever it is used or destroyed.
class GlPicture {
public:
    static constexpr int finest = 12; ///< frames

    explicit GlPicture(GlFunctions& gl);

    /// The next `add` begins anew.
    void restart() { m_count = 0; }
    int count() const { return m_count; }
    /// Draws one more frame of the whole size.
    void add(const QSize& size, const std::function<void(const Vec2& jitter)>& draw);
    /// Draws a single frame, possibly smaller, instead of the mean.
    void replace(const QSize& size, const std::function<void(const Vec2& jitter)>& draw);
    /// What there is, stretched to a size; null before the first frame.
    QImage image(const QSize& size);

private:
    void drawFrame(const QSize& size, const std::function<void(const Vec2& jitter)>& draw);
    void copy(GLuint texture);

    GlFunctions& m_gl;
    GlProgram m_copy;
    QOpenGLVertexArrayObject m_array;
    std::unique_ptr<QOpenGLFramebufferObject> m_frame;
    std::unique_ptr<QOpenGLFramebufferObject> m_mean;
    std::unique_ptr<QOpenGLFramebufferObject> m_shown;
    int m_count = 0;
};

} // namespace bolster
