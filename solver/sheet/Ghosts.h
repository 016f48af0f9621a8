// What pulls the cover softly: cushioning, scans, frames (paper, sections 3.5 and 4.1: ghost vertices).
#pragma once

#include "SheetMoment.h"
#include "WorkerPool.h"

#include <memory>
#include <optional>
#include <vector>

namespace bolster {

struct FieldPicture;
struct SolveReport;

/// One source of targets t_i: L1 gets the rows gamma A_i / D^2 |p_i - t_i|^2 for all vertices of the parts it acts
/// on. Its weights are constant, so that targets may move without factoring again; a vertex that it does not want
/// has its own position as target. A strength scales t_i - p_i, never gamma.
class GhostSource {
public:
    virtual ~GhostSource() = default;

    /// gamma of this part, 0 where the source does not act. Constant during the life of the source.
    virtual double gamma(const SewnMesh::Part& part) const = 0;
    /// Once in every iteration, before displace(): looks at the whole cover.
    virtual void follow(const SheetMoment&, WorkerPool&) {}
    /// Writes t_i - p_i (mm; x y z 0) for the vertices begin .. end - 1 of one part. Called on several threads.
    virtual void displace(const SheetMoment& sheet, const SewnMesh::Part& part, int begin, int end,
                          Columns& displacements) const = 0;
    /// Adds what it does to the cover to the report.
    virtual void report(const SheetMoment&, SolveReport&) const {}
    /// Adds what can be shown of its forces.
    virtual void draw(FieldPicture&) const {}

    /// A source that has one is a fit: rms of what it still has to move, mm, as of the last follow(). It starts
    /// from the cover as it is at rest without it, and has settled when this no longer changes.
    virtual std::optional<double> misfit() const { return std::nullopt; }
};

using Ghosts = std::vector<std::unique_ptr<GhostSource>>;

} // namespace bolster
