#include "CoarseStart.h"

#include "PatternSize.h"
#include "Relaxation.h"
#include "StateTransfer.h"

#include <memory>
#include <vector>

namespace bolster {

namespace {

constexpr double coarsestVertices = 6000;   // about
constexpr double fewVertices = 40'000;      // to set coarser levels up would take longer than they save
constexpr double worthIt = 3;               // times as many vertices as the coarser level
constexpr double levelTolerance = 1e-5;     // relative to D: what is left then is less than levels differ by
constexpr int mostIterationsOfLevel = 1000; // what takes longer finds no rest

/// Lengths of edges, mm, the longest first. Each level has four times the vertices of the one before.
std::vector<double> levelsOf(const SewnMesh& mesh, double edge)
{
    double area = 0;
    for (const SewnMesh::Part& part : mesh.parts)
        area += part.area;
    const double vertices = vertexCount(area, edge);
    std::vector<double> levels;
    if (vertices < fewVertices)
        return levels;
    for (double length = edgeLengthFor(area, coarsestVertices); vertices > worthIt * vertexCount(area, length);
         length /= 2)
        levels.push_back(length);
    return levels;
}

/// A cover on coarser triangles.
class Level {
public:
    Level(PreparedSheet sheet, GhostCache& ghosts, WorkerPool& pool, const std::stop_token& stop)
        : m_sheet(std::move(sheet))
        , m_relaxation(m_sheet.mesh, pool, levelTolerance, ghostsOf(ghosts, pool, stop), stop)
    {}

    /// False when it found no rest.
    bool comeToRest(const Level* coarser, const std::stop_token& stop)
    {
        if (coarser)
            m_relaxation.startNear(coarser->stateOn(m_sheet.mesh));
        else
            m_relaxation.startCanonically();
        while (m_relaxation.phase() == Relaxation::Phase::Running &&
               m_relaxation.iterations() < mostIterationsOfLevel && !stop.stop_requested())
            m_relaxation.iterate();
        return m_relaxation.phase() == Relaxation::Phase::Converged;
    }
    SheetState stateOn(const SewnMesh& finer) const
    {
        return transferState(m_sheet.mesh, m_relaxation.state(), finer);
    }

private:
    /// Without scans: a cover is fitted when it is at rest.
    Ghosts ghostsOf(GhostCache& cache, WorkerPool& pool, const std::stop_token& stop) const
    {
        Problems said; // of the finest level they are told
        Ghosts ghosts = makeGhosts({m_sheet.design, m_sheet.files}, m_sheet.mesh, cache, said, pool, stop);
        std::erase_if(ghosts, [](const auto& source) { return source->misfit().has_value(); });
        return ghosts;
    }

    PreparedSheet m_sheet;
    Relaxation m_relaxation;
};

} // namespace

std::optional<SheetState> coarseStart(const PreparedSheet& sheet, GhostCache& ghosts, WorkerPool& pool,
                                      const std::stop_token& stop)
{
    std::unique_ptr<Level> last;
    for (const double edge : levelsOf(sheet.mesh, sheet.design.settings().edgeLength)) {
        TriangulationCache triangles;
        std::optional<PreparedSheet> coarse =
            prepareSheet(withEdgeLength({sheet.design, sheet.files}, edge), triangles, pool, stop);
        if (stop.stop_requested())
            return std::nullopt;
        // Patches may be too narrow for such edges.
        if (!coarse || coarse->mesh.parts.size() != sheet.mesh.parts.size() || !coarse->leftOut.empty())
            continue;
        auto level = std::make_unique<Level>(std::move(*coarse), ghosts, pool, stop);
        if (level->comeToRest(last.get(), stop))
            last = std::move(level);
        if (stop.stop_requested())
            return std::nullopt;
    }
    return last ? std::optional(last->stateOn(sheet.mesh)) : std::nullopt;
}

void startFromDesign(Relaxation& relaxation, std::optional<SheetState> coarse)
{
    if (coarse)
        relaxation.startNear(std::move(*coarse));
    else
        relaxation.startCanonically();
}

} // namespace bolster
