// Fabrics' maps as textures on the graphics card.
#pragma once

#include "FabricMaps.h"
#include "GlProgram.h"

#include <QOpenGLTexture>

#include <map>
#include <memory>
#include <set>

namespace bolster {

/// A context must be current whenever it is used or destroyed.
class GlFabrics {
public:
    /// Binds a fabric's maps for a program with fabric.glsl: turned by so many radians, as Scene::PatchLook
    /// says. Without maps it wears what the program has been told. `quick`: something moves.
    void wear(GlProgram& program, const FabricMapsPtr& maps, double turn, bool quick);
    /// Forgets all others.
    void keepOnly(const std::set<FabricMapsPtr>& used);

private:
    /// One texture of colours, as light, and one of normals (x, y, z) with the roughness.
    struct Textures {
        std::unique_ptr<QOpenGLTexture> color;
        std::unique_ptr<QOpenGLTexture> relief;
    };

    /// Null when the maps are not whole. Not `quick`: sharper where they are seen from the side, and slower.
    const Textures* textures(const FabricMapsPtr& maps, bool quick);
    std::map<FabricMapsPtr, Textures> m_textures;
};

} // namespace bolster
