// What a frame is made of, as views and pictures show it. Mechanics know nothing of it.
#pragma once

#include <string>

namespace bolster {

struct FrameMaterial {
    enum class Kind { Plain, Wood, Metal, Plastic, Foam };

    Kind kind = Kind::Plain;
    std::string color = {}; ///< "#rrggbb", lower case; "": the usual one of the kind

    friend bool operator==(const FrameMaterial&, const FrameMaterial&) = default;
};

/// "#rrggbb"
std::string colorShown(const FrameMaterial& material);

} // namespace bolster
