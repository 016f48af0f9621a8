#include "CutLayers.h"

#include <utility>

namespace bolster {

std::optional<CutLayers> cutLayers(std::string_view words, std::string& unknown)
{
    static constexpr std::pair<std::string_view, bool CutLayers::*> known[] = {
        {"cut", &CutLayers::cut},     {"sew", &CutLayers::sew},       {"notches", &CutLayers::notches},
        {"grain", &CutLayers::grain}, {"labels", &CutLayers::labels}, {"internal", &CutLayers::internal},
        {"holes", &CutLayers::holes}};
    CutLayers layers;
    for (const auto& [word, layer] : known)
        layers.*layer = false;
    while (!words.empty()) {
        const std::string_view word = words.substr(0, words.find(','));
        words.remove_prefix(std::min(words.size(), word.size() + 1));
        bool found = false;
        for (const auto& [name, layer] : known)
            if (name == word)
                found = layers.*layer = true;
        if (!found) {
            unknown = word;
            return std::nullopt;
        }
    }
    return layers;
}

} // namespace bolster
