// A cover at rest from which others are found that differ a little: warm starts on the same triangles.
#pragma once

#include "MakeGhosts.h"
#include "PatternWarp.h"
#include "PreparedSheet.h"
#include "Relaxation.h"
#include "SolvePlan.h"
#include "SurfaceMesh.h"

#include <memory>
#include <optional>
#include <stop_token>

namespace bolster {

struct WarmOrder {
    double edgeLength = 0;   ///< of the triangles, mm; 0: the design's
    double tolerance = 1e-6; ///< as in SolveOptions
    int mostIterations = 3000;
    int mostWarmIterations = 3000; ///< from home: what takes longer counts as having no cover
    int iterationsBeside = 0;      ///< of WarmCover::lookBeside; 0: until it rests
    int threads = 1;
};

/// Not for several threads at once; each may have its own.
class WarmCover {
public:
    /// Solves from the start that depends on the design alone; see `problem`.
    WarmCover(const SolveInput& input, const WarmOrder& order, const std::stop_token& stop = {});

    /// Why the last cover was not found; empty when it was, or when that was stopped.
    const Message& problem() const { return m_problem; }
    /// A cover was found to go from. Without it there are no triangles and no places.
    bool hasHome() const { return m_home.positions.cols() > 0; }
    /// Finds the cover of another design from where home is, on the same triangles: a function of home and this
    /// design alone, whatever was asked for in between. False when it has none, or needs other triangles.
    bool follow(const Design& design, const std::stop_token& stop = {});
    /// The same for differences: after `iterationsBeside` it is taken as it is. What goes on moving for much longer
    /// than others is a fold that comes or goes, and says nothing of what a small change does.
    bool lookBeside(const Design& design, const std::stop_token& stop = {});
    /// Goes to another design for good: that is home now. On other triangles if need be. When it cannot, home
    /// stays.
    bool moveHome(const Design& design, const std::stop_token& stop = {});

    const SheetState& home() const { return m_home; }
    const Design& homeDesign() const { return m_homeInput.design; }
    const SewnMesh& mesh() const { return m_sheet->mesh; }
    const PreparedSheet& sheet() const { return *m_sheet; }
    SheetState state() const { return m_relaxation->state(); }
    int iterations() const { return m_relaxation->iterations(); }
    SurfaceMeshPtr surface() const;

private:
    SolveInput asWanted(const Design& design) const;
    bool prepare(const SolveInput& input, const std::stop_token& stop);
    Ghosts ghosts(const std::stop_token& stop);
    SolvePlan planFor(const SolveInput& input) const;
    bool slideSamples(const Design& design);
    bool adapt(const SolveInput& input, const std::stop_token& stop);
    bool startFollowing(const Design& design, const std::stop_token& stop);
    bool comeToRest(int mostIterations, const std::stop_token& stop);
    bool factorsAreHome() const { return m_relaxation->factorings() == m_homeFactors; }
    void makeHome();

    WarmOrder m_order;
    DesignFiles m_files;
    std::unique_ptr<WorkerPool> m_pool;
    GhostCache m_ghostCache;
    std::unique_ptr<PreparedSheet> m_sheet;
    std::unique_ptr<Relaxation> m_relaxation;
    std::optional<PatternWarp> m_warp;
    Design m_sampled;                              // the design that was triangulated,
    std::vector<std::vector<double>> m_parameters; // and where its outlines were sampled
    SolveInput m_now;
    SolveInput m_homeInput;
    SheetState m_home;
    std::optional<Design> m_restsAt; // found from home, since that is home
    int m_homeFactors = 0;           // as in Relaxation::factorings; others are of a design that was too different
    Message m_problem;
};

} // namespace bolster
