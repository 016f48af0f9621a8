// The renderer of the command line's pictures as what the 3D view draws with where there is no OpenGL.
#pragma once

#include "PreviewRenderer.h"
#include "SoftwareRenderer.h"

#include <optional>

namespace bolster {

class RayRenderer : public SoftwareRenderer {
public:
    Picture render(const Request& request, std::stop_token stop) override;

private:
    Scene m_scene; ///< that was prepared
    std::optional<PreviewRenderer> m_renderer;
};

} // namespace bolster
