#include "LayerRole.h"

#include "DrawnWords.h"

#include <array>
#include <utility>

namespace bolster {

namespace {

constexpr std::array<std::pair<std::string_view, LayerRole>, 23> numberedLayers{{
    {"1", LayerRole::Cut},           {"2", LayerRole::Turn},
    {"3", LayerRole::Curve},         {"4", LayerRole::Notch},
    {"5", LayerRole::Ignored},       {"6", LayerRole::Ignored},
    {"7", LayerRole::Grain},         {"8", LayerRole::Internal},
    {"9", LayerRole::Ignored},       {"10", LayerRole::Ignored},
    {"11", LayerRole::InternalCut},  {"12", LayerRole::Ignored},
    {"13", LayerRole::Hole},         {"14", LayerRole::Sew},
    {"15", LayerRole::Text},         {"80", LayerRole::Notch},
    {"81", LayerRole::Notch},        {"82", LayerRole::Notch},
    {"83", LayerRole::Notch},        {"84", LayerRole::FineCut},
    {"85", LayerRole::FineInternal}, {"86", LayerRole::FineInternalCut},
    {"87", LayerRole::FineSew},
}};

/// Parts of words, the more telling ones first: "internal cut" is not the cut line, "drill holes" are no notches.
constexpr std::array<std::pair<std::string_view, LayerRole>, 44> wordedLayers{{
    {"internal-cut", LayerRole::InternalCut},
    {"internal cut", LayerRole::InternalCut},
    {"internal_cut", LayerRole::InternalCut},
    {"cutout", LayerRole::InternalCut},
    {"cut-out", LayerRole::InternalCut},
    {"ausschnitt", LayerRole::InternalCut},
    {"notch", LayerRole::Notch},
    {"knips", LayerRole::Notch},
    {"passzeichen", LayerRole::Notch},
    {"cran", LayerRole::Notch},
    {"grain", LayerRole::Grain},
    {"fadenlauf", LayerRole::Grain},
    {"droit fil", LayerRole::Grain},
    {"droit-fil", LayerRole::Grain},
    {"hole", LayerRole::Hole},
    {"drill", LayerRole::Hole},
    {"punch", LayerRole::Hole},
    {"bohr", LayerRole::Hole},
    {"loch", LayerRole::Hole},
    {"label", LayerRole::Text},
    {"text", LayerRole::Text},
    {"annotation", LayerRole::Text},
    {"beschrift", LayerRole::Text},
    {"internal", LayerRole::Internal},
    {"inner", LayerRole::Internal},
    {"innen", LayerRole::Internal},
    {"guide", LayerRole::Internal},
    {"fold", LayerRole::Internal},
    {"draw", LayerRole::Internal},
    {"topstitch", LayerRole::Internal},
    {"top stitch", LayerRole::Internal},
    {"sew", LayerRole::Sew},
    {"stitch", LayerRole::Sew},
    {"seam line", LayerRole::Sew},
    {"seamline", LayerRole::Sew},
    {"seam_line", LayerRole::Sew},
    {"naht", LayerRole::Sew},
    {"couture", LayerRole::Sew},
    {"boundary", LayerRole::Cut},
    {"cut", LayerRole::Cut},
    {"schnitt", LayerRole::Cut},
    {"seam allowance", LayerRole::Cut},
    {"kontur", LayerRole::Cut},
    {"coupe", LayerRole::Cut},
}};

} // namespace

LayerRole layerRole(const std::string& layer)
{
    const std::string word = lowered(trimmed(layer));
    for (const auto& [name, role] : numberedLayers)
        if (word == name)
            return role;
    for (const auto& [part, role] : wordedLayers)
        if (word.find(part) != std::string::npos)
            return role;
    return LayerRole::Unknown;
}

} // namespace bolster
