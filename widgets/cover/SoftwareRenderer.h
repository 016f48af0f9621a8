// What draws the cover where there is no OpenGL. The program hands one in: the views know no ray caster.
#pragma once

#include "Camera.h"
#include "Scene.h"

#include <QImage>

#include <stop_token>
#include <vector>

namespace bolster {

class SoftwareRenderer {
public:
    struct Request {
        Scene scene;
        Camera camera;       ///< its size is the size of the picture
        bool moving = false; ///< something moves: quick before beautiful

        friend bool operator==(const Request&, const Request&) = default;
    };
    struct Picture {
        QImage image; ///< null when stopped
        std::vector<float>
            depth; ///< Camera::depth of each pixel, row by row from the top; infinite where nothing is
    };

    virtual ~SoftwareRenderer() = default;
    /// Called on a worker thread, one call at a time.
    virtual Picture render(const Request& request, std::stop_token stop) = 0;
};

} // namespace bolster
