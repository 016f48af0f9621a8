// What a pattern is to be changed for, what shall stay, and how far it is from there.
#pragma once

#include "BSpline.h"
#include "Design.h"
#include "ScanIndex.h"
#include "TriangleMesh.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <vector>

namespace bolster {

/// A form that the cover shall lie on: points, or those of a mesh.
struct FitTarget {
    Scan place;
    std::shared_ptr<const ScanIndex> index;
    bool empty() const { return !index || index->empty(); }
};

/// Of a mesh (mm): points on its triangles, about as dense as the cover's vertices need them.
FitTarget targetOf(const TriangleMesh& mesh);
FitTarget targetOf(const Scan& scan, const PointCloud& cloud);

/// A seam that shall run along a curve, mm.
struct SeamGoal {
    ElementId seam{};
    BSpline3 line;
};

/// A patch that shall be larger or smaller.
struct SizeGoal {
    ElementId patch{};
    double share = 1; ///< of its area as the designer left it
};

/// A disc of a patch, in the coordinates of its outline, mm.
struct AreaSpot {
    ElementId patch{};
    Vec2 at = Vec2::Zero();
    double radius = 0;

    friend bool operator==(const AreaSpot&, const AreaSpot&) = default;
};

/// A part of the cover; all of it when nothing is said.
struct FitArea {
    std::set<ElementId> patches;
    std::vector<AreaSpot> spots; ///< of the pattern as it was when they were painted

    bool isAll() const { return patches.empty() && spots.empty(); }
    bool hasWhole(ElementId patch) const;
    bool hasAny(ElementId patch) const;
    bool has(ElementId patch, const Vec2& place) const;
};

struct FitGoals {
    FitTarget target;                       ///< weight 1: what counts is the mean square distance, mm
    double targetWeight = 1;                ///
    bool strain = false;                    ///< to be below the fabrics' limits
    std::optional<double> limit;            ///< in %, in their place
    double strainWeight = 2;                ///< 1 % over the limit is as bad as 1 mm
    double keepShape = 0;                   ///< weight of the distance from where the cover is now
    static constexpr double lightly = 0.25; ///< likewise: it stays about there
    double shapeWithin = 1;     ///< mm, rms of that distance, for limits alone: what is beyond counts much more
    FitArea area;               ///< that the target and the limits are about
    std::set<ElementId> smooth; ///< patches in which no cloth shall be pressed together, which makes folds
    std::vector<SeamGoal> seams;
    std::vector<SizeGoal> sizes;

    int kinds() const { return !target.empty() + strain + !smooth.empty() + !seams.empty() + !sizes.empty(); }
    bool isFormAlone() const { return !target.empty() && kinds() == 1; }
    bool isSmoothnessAlone() const { return !smooth.empty() && kinds() == 1; }
    bool isLimitAlone() const { return strain && kinds() == 1; }
    bool any() const { return kinds() > 0; }
};

struct FitLocks {
    bool lengths =
        true; ///< sides of seams keep their difference; when that is far from their ease they come nearer to it
    bool straight = true;                           ///< edges that look straight keep the bow that they have
    static constexpr double straightShare = 0.0015; ///< of its length an edge that looks straight bows at most
    static constexpr double straightWithin(double length) ///< mm, of mm
    {
        return std::clamp(straightShare * length, 0.05, 1.0);
    }
    bool corners = false; ///< keep their angles
    bool ease = true; ///< eases stay; else sides of seams may differ as they like, and eases become what they are
    double change = 0.005; ///< weight of 1 mm that a control point moves
};

struct FitFigures {
    double distanceRms = 0, distanceP95 = 0; ///< mm, where there is a target: of FitGoals::area, as the next one
    double covered = 0;                      ///< share of the cover that has one
    double overLimit = 0; ///< share of the cover whose strain is over the limit; of the area where strain is a goal
    double strainRms = 0; ///< 1
    double shapeRms = 0;  ///< mm, from where the cover was
    double pressed = 0;   ///< share of the area of what shall be smooth where cloth is pressed together
    double seamRms = 0;   ///< mm: of the seams that have a curve to run along
    double sizeMost = 0;  ///< share of its area by which a patch is off the size that it shall have
    double sewnMost = 0;  ///< mm: how far the difference of a seam's sides is from what is wanted
};

/// Whether sides of seams, whose lengths were to stay, differ by more than a change may make of them.
bool missesLengths(const FitLocks& locks, const FitFigures& before, const FitFigures& after);
/// Whether sides of seams that differed by far more than their ease come nearer to it: what differs by mistake is
/// put right on the way, which has to be said.
bool mendsLengths(const FitLocks& locks, const FitFigures& before, const FitFigures& after);
/// Whether a cover that should come nearer to a target hardly does, and much more of it is strained over its
/// limits.
bool strainsForLittle(const FitFigures& before, const FitFigures& after);

/// Whether notably more of a cover is strained over its limits than before.
bool strainsMore(const FitFigures& before, const FitFigures& after);

/// What a change was for, and hardly brought nearer.
struct MissedGoal {
    enum class Kind { Form, Strain, Smooth, Seams, Sizes } kind;
    double before, after; ///< mm rms of the form and seams, else shares
};
/// Figures of what is no goal are 0, but for those of strain: `strained` says whether that is one.
std::vector<MissedGoal> missedGoals(bool strained, const FitFigures& before, const FitFigures& after);

} // namespace bolster
