// The upholstery frame: a mesh from a file, placed in the design.
#pragma once

#include "FrameMaterial.h"
#include "Message.h"
#include "Placement.h"

#include <optional>
#include <string>
#include <vector>

namespace bolster {

struct Frame : Placement {
    std::string name;
    std::string file;            ///< relative to the design's folder, never outside it
    bool contact = false;        ///< keeps the cover from passing through
    double contactGap = 0;       ///< mm that the cover keeps away then
    FrameMaterial material = {}; ///< what it looks like
    /// Of the file's parts and their pieces (FramePiece): not there for anybody.
    std::vector<std::string> hiddenParts{};
    std::string note = {}; ///< for people

    friend bool operator==(const Frame&, const Frame&) = default;
};

/// What is wrong with the name of an element's file, if anything: it must lie in the design's folder, whatever
/// system the design is opened on. Links on disk are not looked at.
std::optional<Message> elementFileProblem(const std::string& file);

} // namespace bolster
