#include "CoverLink.h"

#include "CoverRefiner.h"
#include "SeamRelief.h"
#include "SeamTrims.h"

#include <QDebug>

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

namespace bolster {

namespace {

using namespace std::chrono_literals;

constexpr auto restAfter = 120ms;
// Vertices: more give more triangles than pixels.
constexpr std::uint32_t mostForTwoLevels = 25'000, mostForOneLevel = 100'000;
constexpr double longEdge = 6; ///< pixels: where many triangles are looked at from near

} // namespace

/// Keeps what belongs to the topology.
class CoverLink::Maker {
public:
    Made operator()(const Wanted& wanted, const std::stop_token& stop)
    {
        try {
            Made made{wanted.surface, nullptr, nullptr};
            const SurfaceTopology& topology = *wanted.surface->topology;
            // Trims lie on a refined cover.
            const int levels = std::max(wanted.levels, SeamTrims::any(wanted.design) ? 1 : 0);
            if (levels == 0 || topology.vertexCount() == 0) // of which OpenSubdiv would complain on the terminal
                return made;
            if (m_last.cover && m_last.cover->surface == wanted.surface && m_last.cover->topology->levels == levels)
                made.cover = m_last.cover;
            else
                made.cover = m_refiner.refine(wanted.surface, levels);
            made.cover = sewn(wanted.design, made.cover);
            made.trims = m_trims.make(wanted.design, *made.cover, stop);
            if (!stop.stop_requested())
                m_last = made;
            return made;
        } catch (const std::exception& problem) {
            qWarning("The cover is shown as it is solved: %s", problem.what());
            return {wanted.surface, nullptr, nullptr};
        }
    }

private:
    /// With the relief of the seams as the design trims them.
    CoverMeshPtr sewn(const Design& design, const CoverMeshPtr& cover)
    {
        std::vector<SeamTrim> trims;
        design.each<Seam>([&](ElementId, const Seam& seam) { trims.push_back(seam.trim); });
        if (!m_relief || m_reliefOf != cover->topology || m_reliefTrims != trims) {
            m_relief = seamRelief(design, *cover->topology);
            m_reliefOf = cover->topology;
            m_reliefTrims = std::move(trims);
        }
        if (cover->relief == m_relief)
            return cover;
        auto copy = std::make_shared<CoverMesh>(*cover);
        copy->relief = m_relief;
        return copy;
    }

    CoverRefiner m_refiner;
    SeamTrims m_trims;
    SeamReliefPtr m_relief;
    std::shared_ptr<const CoverTopology> m_reliefOf;
    std::vector<SeamTrim> m_reliefTrims;
    Made m_last;
};

CoverLink::CoverLink(QObject* parent)
    : QObject(parent)
    , m_job([maker = std::make_shared<Maker>()](const Wanted& wanted,
                                                const std::stop_token& stop) { return (*maker)(wanted, stop); },
            [this](const Made& made) {
                m_made = made.of;
                if (made.cover)
                    emit refined(made.cover, made.trims);
                emit trimmed();
            })
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(restAfter);
    connect(&m_rest, &QTimer::timeout, this, &CoverLink::ask);
}

CoverLink::~CoverLink() = default;

bool CoverLink::isTrimmed() const
{
    return !SeamTrims::any(m_design) || m_made == m_surface;
}

void CoverLink::setSurface(const SurfaceMeshPtr& surface)
{
    m_surface = surface;
    m_job.cancel();
    if (surface) {
        m_rest.start();
    } else {
        m_rest.stop();
        m_made.reset();
    }
}

void CoverLink::setDesign(const Design& design)
{
    m_design = design;
    if (m_surface)
        m_rest.start();
}

void CoverLink::setPixelSize(double mm)
{
    m_pixelSize = mm;
    if (m_surface && !m_rest.isActive() && levels() > m_asked)
        m_rest.start();
}

void CoverLink::setReduced(bool reduced)
{
    if (std::exchange(m_reduced, reduced) != reduced && m_surface)
        m_rest.start();
}

/// Of subdivision.
int CoverLink::levels() const
{
    if (m_reduced)
        return 0;
    const std::uint32_t vertices = m_surface->topology->vertexCount();
    if (vertices <= mostForTwoLevels)
        return 2;
    return vertices <= mostForOneLevel || m_design.settings().edgeLength > longEdge * m_pixelSize ? 1 : 0;
}

void CoverLink::ask()
{
    m_asked = levels();
    m_job.request({m_surface, m_design, m_asked}, true);
}

} // namespace bolster
