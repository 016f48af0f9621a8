// The goals of a fit as numbers whose squares are to be small.
#pragma once

#include "CoarseDerivatives.h"
#include "FitGoals.h"
#include "SeamLineRows.h"

#include <vector>

namespace bolster {

/// By how much the second side is longer than the first one, mm.
double seamDifference(const Design& design, const Seam& seam);

/// Rows of all goals for covers on one triangulation.
class FitRows {
public:
    /// `design`: as the designer left it.
    FitRows(const FitGoals& goals, const FitLocks& locks, const Design& design);

    /// Of a limit, from where strain counts: squares hardly see what is just over it, and that is most of it.
    static constexpr double belowLimit = 0.7, farBelowLimit = 0.6;
    void strainFrom(double share) { m_strainFrom = share; }

    /// Every vertex to its nearest place on target and kept shape, and what lies in the goals' area, until the next
    /// call.
    void aim(const WarmCover& cover);
    /// Where this cover is is the shape that is to be kept.
    void keep(const WarmCover& cover);
    /// May be called on several threads. `places`: of the vertices of a cover with these triangles, mm.
    Eigen::VectorXd rows(const SurfaceTopology& topology, const std::vector<Vec3>& places,
                         const Design& design) const;
    Eigen::VectorXd rows(const WarmCover& cover, const Design& design) const
    {
        return rows(*cover.mesh().topology, vertexPlaces(cover), design);
    }
    FitFigures figures(const WarmCover& cover, const Design& design) const;

private:
    struct Aim {
        int vertex = 0;
        Vec3 normal = Vec3::Zero();
        double height = 0; ///< of the target along it
        double weight = 0; ///< square root of the share of the area
    };

    /// By how much the second side of a seam is to be longer, mm.
    struct Wanted {
        double difference = 0;
        double weight = 1;
    };

    void addAims(const WarmCover& cover, const FitTarget& target, double weight, bool everywhere);
    void addStrain(const SurfaceTopology& topology, const std::vector<Vec3>& places,
                   std::vector<double>& rows) const;
    std::vector<double> unwantedStrain(const SurfaceTopology& topology, const std::vector<Vec3>& places) const;
    void addShyness(const SurfaceTopology& topology, const std::vector<Vec3>& places,
                    std::vector<double>& rows) const;
    void addSmooth(const SurfaceTopology& topology, const std::vector<Vec3>& places,
                   std::vector<double>& rows) const;
    void addSizes(const Design& design, std::vector<double>& rows) const;
    double sizeOff(const Design& design, const SizeGoal& goal) const;
    void addPattern(const Design& design, std::vector<double>& rows) const;
    std::vector<double> lengthDifferences(const Design& design) const;

    FitGoals m_goals;
    FitLocks m_locks;
    Design m_design;
    std::vector<Wanted> m_wanted; // of all seams
    std::vector<Aim> m_aims;
    double m_strainFrom = belowLimit;
    std::size_t m_keptFirst = 0;                       // of those, that are about where the cover has been
    std::vector<std::uint32_t> m_strained, m_smoothed; // triangles of these goals
    FitTarget m_kept;
    std::vector<double> m_unwanted; // of each patch of the cover that was kept
    SeamLineRows m_seams;
};

} // namespace bolster
