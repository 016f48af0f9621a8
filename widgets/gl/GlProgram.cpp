#include "GlProgram.h"

#include "LinearLight.h"

#include <QFile>

#include <stdexcept>

namespace bolster {

namespace {

QByteArray resource(const char* name)
{
    QFile file(QStringLiteral(":/shaders/") + QLatin1String(name));
    if (!file.open(QIODevice::ReadOnly))
        throw std::runtime_error(std::string("shader not found: ") + name);
    return file.readAll();
}

QByteArray shaderSource(const char* name)
{
    QByteArray text = resource(name);
    for (const char* part : {"lit.glsl", "studio.glsl", "materials.glsl", "seams.glsl", "fabric.glsl"})
        text.replace(QByteArray("#include \"") + part + '"', resource(part));
    return text;
}

} // namespace

GlProgram::GlProgram(const char* vertexShader, const char* fragmentShader)
    : m_program(std::make_unique<QOpenGLShaderProgram>())
    , m_gl(glFunctions())
{
    if (!m_gl)
        throw std::runtime_error("no OpenGL 3.3");
    if (!m_program->addShaderFromSourceCode(QOpenGLShader::Vertex, shaderSource(vertexShader)) ||
        !m_program->addShaderFromSourceCode(QOpenGLShader::Fragment, shaderSource(fragmentShader)) ||
        !m_program->link())
        throw std::runtime_error(std::string(fragmentShader) + ": " + m_program->log().toStdString());
}

void GlProgram::set(const char* name, bool value)
{
    m_gl->glUniform1i(location(name), value);
}

void GlProgram::set(const char* name, int value)
{
    m_gl->glUniform1i(location(name), value);
}

void GlProgram::set(const char* name, float value)
{
    m_gl->glUniform1f(location(name), value);
}

void GlProgram::set(const char* name, const Eigen::Vector2f& value)
{
    m_gl->glUniform2fv(location(name), 1, value.data());
}

void GlProgram::set(const char* name, const Eigen::Vector3f& value)
{
    m_gl->glUniform3fv(location(name), 1, value.data());
}

void GlProgram::set(const char* name, const Eigen::Vector4f& value)
{
    m_gl->glUniform4fv(location(name), 1, value.data());
}

void GlProgram::set(const char* name, const Eigen::Matrix4f& value)
{
    m_gl->glUniformMatrix4fv(location(name), 1, GL_FALSE, value.data());
}

void GlProgram::set(const char* name, const QColor& value)
{
    m_gl->glUniform4f(location(name), value.redF(), value.greenF(), value.blueF(), value.alphaF());
}

Eigen::Vector3f linearLight(const QColor& color)
{
    return {toLinear(color.redF()), toLinear(color.greenF()), toLinear(color.blueF())};
}

} // namespace bolster
