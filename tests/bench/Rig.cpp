#include "Rig.h"

#include "Scenes.h"

#include <stdexcept>

namespace bolster::bench {

Rig::Rig(const SolveInput& input)
{
    TriangulationCache cache;
    m_sheet = *prepareSheet(input, cache);
    if (!m_sheet.errors.empty())
        throw std::runtime_error(m_sheet.errors.front().english());
    constexpr double never = 0; // a tolerance that no iteration falls below
    m_relaxation.emplace(mesh(), m_pool, never, makeGhosts(input, mesh(), m_ghostCache, m_sheet.warnings, m_pool));
    startCanonically();
}

void Rig::startFlat()
{
    SheetState flat{flatPlaces(mesh()), {}};
    flat.frames.setZero(4, mesh().vertexCount());
    flat.frames.row(0).setOnes();
    m_relaxation->startFrom(std::move(flat), true);
}

void Rig::reachFit()
{
    if (m_sheet.files.clouds.empty())
        return;
    while (m_relaxation->phase() == Relaxation::Phase::Running)
        m_relaxation->iterate();
}

double Rig::iterate()
{
    if (m_relaxation->phase() == Relaxation::Phase::Converged)
        m_relaxation->startFrom(m_relaxation->state(), false);
    m_relaxation->iterate();
    if (m_relaxation->phase() == Relaxation::Phase::Failed)
        throw std::runtime_error("a benchmark failed: " + m_relaxation->reason().english());
    return m_relaxation->movement();
}

} // namespace bolster::bench
