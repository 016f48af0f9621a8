// A shader program from the program's resources.
#pragma once

#include "Geometry.h"
#include "GlFunctions.h"

#include <QColor>
#include <QOpenGLShaderProgram>

#include <memory>

namespace bolster {

class GlProgram {
public:
    /// From :/shaders/NAME.vert and NAME.frag; throws std::runtime_error with the compiler's words. A context must
    /// be current, then and always.
    GlProgram(const char* vertexShader, const char* fragmentShader);

    void use() { m_program->bind(); }
    void set(const char* name, bool value);
    void set(const char* name, int value);
    void set(const char* name, float value);
    void set(const char* name, const Eigen::Vector2f& value);
    void set(const char* name, const Eigen::Vector3f& value);
    void set(const char* name, const Eigen::Vector4f& value);
    void set(const char* name, const Eigen::Matrix4f& value);
    void set(const char* name, const QColor& value); ///< with alpha, as displayed

private:
    int location(const char* name) { return m_program->uniformLocation(name); }

    std::unique_ptr<QOpenGLShaderProgram> m_program;
    GlFunctions* m_gl;
};

/// Linear light of a displayed colour.
Eigen::Vector3f linearLight(const QColor& color);

} // namespace bolster
