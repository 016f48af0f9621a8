// What OpenImageIO does for Bolster, in a module that is loaded when it is first wanted: it brings more than two
// hundred libraries, for which every start would wait.
#pragma once

#include "FabricMaps.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace bolster {

struct BakeOptions;
struct Fabric;
struct ImagePixels;

/// A picture that is to become a file, rows from the top down: bytes, or floats where there are none.
struct EncodeOrder {
    enum class Depth { Bytes, Shorts, Halves };

    const char* format = "png"; ///< OpenImageIO's word
    int width = 0;
    int height = 0;
    int channels = 4;
    Depth depth = Depth::Bytes; ///< in the file
    const std::uint8_t* bytes = nullptr;
    const float* floats = nullptr;
    std::vector<std::pair<std::string, std::string>> words = {}; ///< OpenImageIO's attributes
    std::vector<std::pair<std::string, int>> numbers = {};
};

/// A line of text in the middle of a strip's height.
struct TextOrder {
    enum class Align { Left, Center, Right };

    std::string text; ///< UTF-8
    int width = 0;    ///< pixels, as the next two
    int height = 0;
    int size = 12;
    Align align = Align::Left;
};

struct Imaging {
    FabricMapsPtr (*bake)(const Fabric& fabric, const ImagePixels* image, const BakeOptions& options);
    /// The bytes of the file, or "" and why there are none.
    std::string (*encode)(const EncodeOrder& order, std::string& problem);
    /// How much of each pixel is covered, 0 to 1; `false` when there is no such font.
    bool (*drawText)(const TextOrder& order, const char* font, float* share);
};

/// From any thread. Throws std::runtime_error when the module is not there: then the installation is broken.
const Imaging& imaging();

} // namespace bolster
