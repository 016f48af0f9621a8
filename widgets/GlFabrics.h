// Fabrics' maps as textures on the graphics card.
#pragma once

#include "FabricMaps.h"
#include "GlFunctions.h"

#include <QOpenGLTexture>

#include <map>
#include <memory>
#include <set>

namespace bolster {

/// A context must be current whenever it is used or destroyed.
class GlFabrics {
public:
    /// One texture of colours, as light, and one of normals (x, y, z) with the roughness.
    struct Textures {
        std::unique_ptr<QOpenGLTexture> color;
        std::unique_ptr<QOpenGLTexture> relief;
    };

    /// Null when the maps are not whole. `anisotropy`: sharper where they are seen from the side, and slower.
    const Textures* textures(const FabricMapsPtr& maps, float anisotropy);
    /// Forgets all others.
    void keepOnly(const std::set<FabricMapsPtr>& used);

private:
    std::map<FabricMapsPtr, Textures> m_textures;
};

} // namespace bolster
