#include "Rig.h"

#include "MakeGhosts.h"
#include "Scenes.h"

#include <stdexcept>

namespace bolster::bench {

Rig::Rig(const SolveInput& input, const MakeGhosts& standIn)
{
    TriangulationCache cache;
    m_sheet = *prepareSheet(input, cache);
    if (!m_sheet.errors.empty())
        throw std::runtime_error(m_sheet.errors.front().english());
    GhostCache ghostCache;
    Ghosts ghosts = makeGhosts(input, mesh(), ghostCache, m_sheet.warnings, m_pool);
    if (ghosts.empty() && standIn)
        ghosts = standIn(mesh());
    constexpr double never = 0; // a tolerance that no iteration falls below
    m_relaxation.emplace(mesh(), m_pool, never, std::move(ghosts));
    startCanonically();
}

void Rig::startFlat()
{
    SheetState flat{flatPlaces(mesh()), {}};
    flat.frames.setZero(4, mesh().vertexCount());
    flat.frames.row(0).setOnes();
    m_relaxation->startFrom(std::move(flat), true);
}

double Rig::iterate()
{
    m_relaxation->iterate();
    if (m_relaxation->phase() != Relaxation::Phase::Running)
        throw std::runtime_error("a benchmark failed: " + m_relaxation->reason().english());
    return m_relaxation->movement();
}

} // namespace bolster::bench
