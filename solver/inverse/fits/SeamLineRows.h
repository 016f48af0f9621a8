// Seams of a cover that shall run along curves, as rows of a fit.
#pragma once

#include "FitGoals.h"
#include "WarmCover.h"

#include <array>
#include <vector>

namespace bolster {

class SeamLineRows {
public:
    /// `design`: as the designer left it.
    SeamLineRows(const std::vector<SeamGoal>& goals, const Design& design);

    bool empty() const { return m_goals.empty(); }
    /// Places of the seams to where their curves are nearest, until the next call.
    void aim(const WarmCover& cover);
    /// `places` of the cover's vertices, mm. Two rows for each place: across the curve there.
    void add(const std::vector<Vec3>& places, std::vector<double>& rows) const;
    /// From the curves, mm.
    double rms(const WarmCover& cover) const;

private:
    /// A place of a seam, by the vertices of one of its sides.
    struct Place {
        std::array<std::uint32_t, 3> corners{};
        Eigen::Vector3d weights = Eigen::Vector3d::Zero();
        const BSpline3* line = nullptr;
    };
    struct Aim {
        Place place;
        std::array<Vec3, 2> across{};
        Vec3 to = Vec3::Zero();
    };

    std::vector<Place> placesOn(const WarmCover& cover) const;

    std::vector<SeamGoal> m_goals;
    Design m_design;
    std::vector<Aim> m_aims;
};

} // namespace bolster
