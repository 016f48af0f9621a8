// What there is to worry about in a cover that has come to rest.
#pragma once

#include "Design.h"
#include "DesignFiles.h"
#include "FrameDistance.h"
#include "SurfaceMesh.h"

#include <optional>
#include <vector>

namespace bolster {

struct CoverFinding {
    enum class Kind {
        Free,      ///< sewn to nothing that is held, while other patches are held
        OffFrame,  ///< held off the frame
        OverLimit, ///< strained more than its fabric may be
        Folds,     ///< more cloth than there is room for
        Ease       ///< a seam gathers more cloth than it should
    };
    struct Place {
        ElementId patch{};
        Vec2 outline = Vec2::Zero(); ///< mm
    };

    Kind kind = Kind::OverLimit;
    ElementId element{};        ///< patch, fixation curve or seam
    std::optional<Place> place; ///< where it is worst
    double value = 0;           ///< %, mm, or mm^2 of folds
    double allowed = 0;         ///< in the same unit
    Message text;               ///< a whole sentence, with the element's name
};

/// What matters most comes first: by kind, then by how much it exceeds what is allowed. Small spots are none: a
/// single triangle at a corner says more about the triangulation than about the cloth.
std::vector<CoverFinding> coverFindings(const SurfaceMesh& surface, const Design& design, const DesignFiles& files,
                                        FrameDistance& frames);

} // namespace bolster
