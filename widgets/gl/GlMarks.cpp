#include "GlMarks.h"

namespace bolster {

namespace {

constexpr float lineLift = 1.5F; ///< pixels towards the eye: lines lie on what they mark
constexpr float dotLift = 4;

std::array<std::uint8_t, 4> bytes(const QColor& color)
{
    return {static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
            static_cast<std::uint8_t>(color.blue()), static_cast<std::uint8_t>(color.alpha())};
}

} // namespace

GlMarks::GlMarks(GlFunctions& gl)
    : m_gl(gl)
    , m_lineProgram("line.vert", "line.frag")
    , m_dotProgram("dot.vert", "dot.frag")
{
    m_lineArray.create();
    {
        const QOpenGLVertexArrayObject::Binder bound(&m_lineArray);
        bindColumns(gl, m_segments, sizeof(Segment),
                    {{0, 3, GL_FLOAT, offsetof(Segment, from), true},
                     {1, 3, GL_FLOAT, offsetof(Segment, to), true},
                     {2, 4, GL_UNSIGNED_BYTE, offsetof(Segment, color), true},
                     {3, 3, GL_FLOAT, offsetof(Segment, style), true}});
    }
    m_dotArray.create();
    const QOpenGLVertexArrayObject::Binder bound(&m_dotArray);
    bindColumns(gl, m_dots, sizeof(Dot),
                {{0, 3, GL_FLOAT, offsetof(Dot, at), true},
                 {1, 4, GL_UNSIGNED_BYTE, offsetof(Dot, fill), true},
                 {2, 4, GL_UNSIGNED_BYTE, offsetof(Dot, rim), true},
                 {3, 2, GL_FLOAT, offsetof(Dot, style), true}});
}

void GlMarks::update(const ViewScene& scene)
{
    if (scene.marks == m_marks)
        return;
    m_marks = scene.marks;
    std::vector<Segment> segments;
    for (const SceneLine& line : scene.lines)
        for (std::size_t i = 1; i < line.points.size(); ++i)
            segments.push_back(
                {line.points[i - 1], line.points[i], bytes(line.color), {line.width, line.hidden, line.casing}});
    std::vector<Dot> dots;
    for (const SceneDot& dot : scene.dots)
        dots.push_back({dot.at, bytes(dot.fill), bytes(dot.rim), {dot.radius, dot.hidden}});
    m_segments.put(segments, QOpenGLBuffer::StreamDraw);
    m_dots.put(dots, QOpenGLBuffer::StreamDraw);
    m_segmentCount = static_cast<GLsizei>(segments.size());
    m_dotCount = static_cast<GLsizei>(dots.size());
}

void GlMarks::draw(const GlView& view, bool hiddenPart)
{
    m_gl.glEnable(GL_BLEND);
    m_gl.glDepthMask(GL_FALSE);
    m_gl.glDepthFunc(hiddenPart ? GL_GREATER : GL_LEQUAL);
    const auto draw = [&](GlProgram& program, QOpenGLVertexArrayObject& array, float lift, GLsizei count,
                          bool casing) {
        if (count == 0)
            return;
        program.use();
        view.setTransforms(program);
        view.setPixels(program);
        program.set("lift", lift * view.pixelRatio);
        program.set("hiddenPart", hiddenPart);
        program.set("casingPart", casing);
        const QOpenGLVertexArrayObject::Binder bound(&array);
        m_gl.glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
    };
    if (!hiddenPart)
        draw(m_lineProgram, m_lineArray, lineLift, m_segmentCount, true);
    draw(m_lineProgram, m_lineArray, lineLift, m_segmentCount, false);
    draw(m_dotProgram, m_dotArray, dotLift, m_dotCount, false);
    m_gl.glDepthFunc(GL_LEQUAL);
    m_gl.glDepthMask(GL_TRUE);
    m_gl.glDisable(GL_BLEND);
}

} // namespace bolster
