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
    /// What the prepared scene was made of, to tell whether it can be used again.
    bool prepared(const Request& request) const;

    std::optional<Request> m_last;
    std::optional<PreviewRenderer> m_renderer;
};

} // namespace bolster
