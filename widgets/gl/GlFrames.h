// The frames on the graphics card.
#pragma once

#include "GlBuffer.h"
#include "GlView.h"

#include <functional>
#include <span>

namespace bolster {

class GlFrames {
public:
    enum class Part { Solid, SeeThrough };

    explicit GlFrames(GlFunctions& gl);

    void update(const ViewScene& scene);
    bool has(const ViewScene& scene, Part part) const;
    /// Those that are solid hide what is behind them. Of the others only what is nearest to the eye is seen.
    /// `quick`: something moves; fewer triangles where there are many.
    void draw(const ViewScene& scene, const GlView& view, Part part, bool quick);

private:
    static Part partOf(const ViewScene& scene, std::size_t frame);
    /// Skins on the graphics card, one after the other.
    struct Skins {
        explicit Skins(GlFunctions& gl);
        using CornersOf = std::function<std::span<const FrameSkin::Corner>(const FrameSkin&)>;
        void put(const std::vector<FrameSkinPtr>& skins, const CornersOf& cornersOf);

        QOpenGLVertexArrayObject array;
        GlBuffer corners;
        std::vector<std::size_t> firstOf; ///< corner of each skin, and their end; empty until they are there
    };

    void putFewer();
    std::size_t triangles() const;
    void drawAll(const ViewScene& scene, Part part, Skins& skins);

    GlFunctions& m_gl;
    GlProgram m_program;
    std::vector<FrameSkinPtr> m_skins; ///< that are uploaded
    Skins m_all;
    Skins m_fewer; ///< for when something moves
};

} // namespace bolster
