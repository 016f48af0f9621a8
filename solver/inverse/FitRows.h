// What a pattern is to be changed for and what shall stay, as numbers whose squares are to be small.
#pragma once

#include "CoverTeam.h"
#include "ScanIndex.h"

#include <memory>
#include <set>

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

struct FitGoals {
    FitTarget target;            ///< weight 1: what counts is the mean square distance, mm
    double targetWeight = 1;     ///
    bool strain = false;         ///< to be below the fabrics' limits
    std::optional<double> limit; ///< in %, in their place
    double strainWeight = 1;     ///< 1 % over the limit is as bad as 1 mm
    double keepShape = 0;        ///< weight of the distance from where the cover is now
    std::set<ElementId> patches; ///< that the target and the limits are about; none: all
};

struct FitLocks {
    bool lengths = true;  ///< sides of seams keep their difference
    bool straight = true; ///< edges that are straight stay so
    bool corners = false; ///< keep their angles
    double change = 0.02; ///< weight of 1 mm that a control point moves
};

struct FitFigures {
    double distanceRms = 0, distanceP95 = 0; ///< mm, where there is a target
    double covered = 0;                      ///< share of the cover that has one
    double overLimit = 0;                    ///< share of the cover's area whose strain is over the limit
    double strainRms = 0;                    ///< 1
    double shapeRms = 0;                     ///< mm, from where the cover was
    double sewnMost = 0;                     ///< mm: by how much the difference of a seam's sides has changed
};

/// Rows of all goals for covers on one triangulation.
class FitRows {
public:
    /// `design`: as the designer left it.
    FitRows(const FitGoals& goals, const FitLocks& locks, const Design& design);

    /// Every vertex to its nearest place on the target, until the next call.
    void aim(const WarmCover& cover);
    /// Where the cover is now is the shape that is to be kept.
    void keep(const WarmCover& cover);
    /// May be called on several threads.
    Eigen::VectorXd rows(const WarmCover& cover, const Design& design) const;
    FitFigures figures(const WarmCover& cover, const Design& design) const;

private:
    struct Aim {
        int vertex = 0;
        Vec3 normal = Vec3::Zero();
        double height = 0; ///< of the target along it
        double weight = 0; ///< square root of the share of the area
    };

    bool isMeant(ElementId patch) const { return m_goals.patches.empty() || m_goals.patches.contains(patch); }
    void addStrain(const WarmCover& cover, const std::vector<Vec3>& places, std::vector<double>& rows) const;
    void addPattern(const Design& design, std::vector<double>& rows) const;
    std::vector<double> lengthDifferences(const Design& design) const;
    template <class Visit>
    void eachStrain(const WarmCover& cover, const std::vector<Vec3>& places, const Visit& visit) const;

    FitGoals m_goals;
    FitLocks m_locks;
    Design m_design;
    std::vector<double> m_differences; // of seams as they were, mm
    std::vector<Aim> m_aims;
    std::vector<Aim> m_kept;
};

} // namespace bolster
