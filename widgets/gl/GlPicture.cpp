#include "GlPicture.h"

#include <cmath>

namespace bolster {

namespace {

/// Places that fill the pixel evenly however many are taken (the R2 sequence); the first is its middle.
Vec2 jitterOf(int frame)
{
    const auto part = [](double x) { return x - std::floor(x) - 0.5; };
    return {part(0.5 + frame * 0.7548776662466927), part(0.5 + frame * 0.5698402909980532)};
}

} // namespace

GlPicture::GlPicture(GlFunctions& gl)
    : m_gl(gl)
    , m_copy("screen.vert", "present.frag")
{
    m_array.create();
}

void GlPicture::drawFrame(const QSize& size, const std::function<void(const Vec2& jitter)>& draw)
{
    if (!m_frame || m_frame->size() != size)
        m_frame = std::make_unique<QOpenGLFramebufferObject>(size, QOpenGLFramebufferObject::Depth, GL_TEXTURE_2D,
                                                             GL_RGBA8);
    m_frame->bind();
    draw(jitterOf(m_count));
}

void GlPicture::copy(GLuint texture)
{
    const QOpenGLVertexArrayObject::Binder bound(&m_array);
    m_gl.glDisable(GL_DEPTH_TEST);
    m_gl.glActiveTexture(GL_TEXTURE0);
    m_gl.glBindTexture(GL_TEXTURE_2D, texture);
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    m_copy.use();
    m_copy.set("picture", 0);
    m_gl.glDrawArrays(GL_TRIANGLES, 0, 3);
}

void GlPicture::add(const QSize& size, const std::function<void(const Vec2& jitter)>& draw)
{
    if (!m_mean || m_mean->size() != size) {
        m_mean = std::make_unique<QOpenGLFramebufferObject>(size, QOpenGLFramebufferObject::NoAttachment,
                                                            GL_TEXTURE_2D, GL_RGBA16F);
        m_count = 0;
    }
    drawFrame(size, draw);
    m_mean->bind();
    m_gl.glViewport(0, 0, size.width(), size.height());
    m_gl.glEnable(GL_BLEND);
    m_gl.glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    m_gl.glBlendColor(0, 0, 0, 1.F / static_cast<float>(++m_count));
    copy(m_frame->texture());
    m_gl.glDisable(GL_BLEND);
}

void GlPicture::replace(const QSize& size, const std::function<void(const Vec2& jitter)>& draw)
{
    m_count = 0;
    drawFrame(size, draw);
}

QImage GlPicture::image(const QSize& size)
{
    const QOpenGLFramebufferObject* source = m_count > 0 ? m_mean.get() : m_frame.get();
    if (!source)
        return {};
    if (!m_shown || m_shown->size() != size)
        m_shown = std::make_unique<QOpenGLFramebufferObject>(size, QOpenGLFramebufferObject::NoAttachment,
                                                             GL_TEXTURE_2D, GL_RGBA8);
    m_shown->bind();
    m_gl.glViewport(0, 0, size.width(), size.height());
    copy(source->texture());
    QImage image = m_shown->toImage();
    image.reinterpretAsFormat(QImage::Format_RGB32); // it is opaque, and so quicker to paint
    return image;
}

} // namespace bolster
