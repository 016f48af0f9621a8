// What a file for cutters holds of each piece.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace bolster {

struct CutLayers {
    bool cut = true;
    bool sew = true;
    bool notches = true;
    bool grain = true;
    bool labels = true;
    bool internal = true;
    bool holes = true;
};

/// Of words with commas between them: cut, sew, notches, grain, labels, internal, holes. Nothing when one of them
/// is another word: that is `unknown` then.
std::optional<CutLayers> cutLayers(std::string_view words, std::string& unknown);

} // namespace bolster
