// Fits the cover to a scan (paper, section 5).
#pragma once

#include "Ghosts.h"
#include "ScanIndex.h"

#include <optional>

namespace bolster {

/// A point of a scan that belongs to a point of the cover, as seen from there.
struct ScanOffset {
    double along = 0;          ///< mm, along the cover's normal, to the plane in which the scan lies there
    double aside = 0;          ///< mm, across it
    Vec3 whole = Vec3::Zero(); ///< mm
};

/// Where a placed scan is looked for around the cover.
class ScanPlace {
public:
    ScanPlace(const Scan& scan, std::shared_ptr<const ScanIndex> index);

    const ScanIndex& index() const { return *m_index; }
    /// In file units, for searching.
    Vec3 filePoint(const Vec3& at) const { return m_placement.filePoint(at); }
    double fileRadius() const { return m_threshold / m_placement.scale; }
    /// Of scan point `nearest` (-1: none) from `at` (mm) on the cover with a unit normal; nothing when it is too
    /// far or, with `beside`, only belongs to what is beside a hole.
    std::optional<ScanOffset> offset(int nearest, const Vec3& at, const Vec3& normal, bool limitAside) const;

private:
    Placement m_placement;
    double m_threshold;
    double m_widest; // mm: further aside a point belongs to a neighbour
    std::shared_ptr<const ScanIndex> m_index;
};

/// Pulls every vertex to what the scan has nearest to it. A fit: see GhostSource::misfit().
class ScanGhosts : public GhostSource {
public:
    ScanGhosts(const Scan& scan, std::shared_ptr<const ScanIndex> index, const SewnMesh& mesh);

    double gamma(const SewnMesh::Part& part) const override;
    void follow(const SheetMoment& sheet, WorkerPool& pool) override;
    void displace(const SheetMoment& sheet, const SewnMesh::Part& part, int begin, int end,
                  Columns& displacements) const override;
    std::optional<double> misfit() const override { return m_misfit; }

private:
    struct Sum {
        double squares = 0;
        int count = 0;
    };

    Sum pull(const SheetMoment& sheet, int begin, int end);

    Scan m_scan;
    ScanPlace m_place;
    std::vector<int> m_partOf;        // per vertex
    std::vector<ScanMatch> m_matches; // per free unknown
    std::vector<int> m_nearest;
    Columns m_displacements;
    double m_misfit = 0;
};

} // namespace bolster
