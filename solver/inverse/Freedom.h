// What may change in a design, each by one number.
#pragma once

#include "Design.h"
#include "DesignFiles.h"
#include "Field.h"

#include <Eigen/Core>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace bolster {

class FrameSlide;

/// One number, 0 in the design as it is.
struct Freedom {
    enum class Kind {
        OutlinePoint, ///< control point `index` of patch `element` along `direction` in its plane, mm
        Offset, ///< the outline of patch `element` from `from` to `to`, outwards, mm; all of it when they are equal
        Size,   ///< patch `element` about its middle, %
        CurvePlace, ///< fixation curve `element` along `axis`, mm; where others meet it, half as far
        CurveSlide, ///< fixation curve `element` along its frame (`onFrame`), mm: sideways (`axis` 0), or turned
                    ///< (1)
        SeamEnd, ///< where stretches that are sewn or fixed end on patch `element`, at `from`, along its outline,
                 ///< mm
        Slip,    ///< material of patch `element` from `from` to `to` along its outline, mm (SlippedOutline)
        Number   ///< `field` of `element`, in its own unit
    };

    Kind kind = Kind::OutlinePoint;
    ElementId element{};
    int index = 0;
    Vec2 direction = Vec2::UnitX();
    int axis = 0;
    double from = 0, to = 0;
    std::string field = {};
    std::string name = {};                   ///< for people
    double step = 1;                         ///< by which differences are taken: what is about 1 mm at the cover
    double least = -noLimit, most = noLimit; ///< that it may be, in its own unit
    std::shared_ptr<const FrameSlide> onFrame = {};
};

/// The design with all of that changed, and what goes with it (twins, what lies on outlines).
Design withFreedoms(const Design& design, std::span<const Freedom> freedoms, const Eigen::VectorXd& values);

/// Of every control point of these patches (none: all), but for those of twins that follow: across the outline,
/// at corners in both directions. (Along the outline they would change nothing but the numbers.)
std::vector<Freedom> outlineFreedoms(const Design& design, std::span<const ElementId> patches = {});
/// What cushions are thick: dilation of cushions that act, and of their foam.
std::vector<Freedom> foamFreedoms(const Design& design);
/// Of fixation curves that are in use, but for those of twins that follow.
std::vector<Freedom> fixationFreedoms(const Design& design);
/// The same, but curves that lie on a frame stay on it: sideways, and turned if they are open.
std::vector<Freedom> fixationFreedoms(const Design& design, const DesignFiles& files);
std::vector<Freedom> pressureFreedoms(const Design& design);
/// Stiffness of fabrics that are in use against the others, and how much they contract across a pull.
std::vector<Freedom> stretchFreedoms(const Design& design);
/// Where seams and fixations end on a smooth piece of an outline; at corners the outline's points do that. None on
/// patches that have twins or are ones.
std::vector<Freedom> seamEndFreedoms(const Design& design);

} // namespace bolster
