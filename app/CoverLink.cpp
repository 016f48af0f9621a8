#include "CoverLink.h"

#include "SeamTrims.h"
#include "SurfaceRefiner.h"

#include <QDebug>

#include <chrono>
#include <exception>

namespace bolster {

namespace {

using namespace std::chrono_literals;

constexpr auto restAfter = 120ms;
constexpr std::uint32_t mostForTwoLevels = 25000; ///< vertices: more give more triangles than pixels

} // namespace

/// Keeps what belongs to the topology.
class CoverLink::Maker {
public:
    Made operator()(const Wanted& wanted)
    {
        try {
            Made made;
            const SurfaceTopology& topology = *wanted.surface->topology;
            if (m_last.cover && m_last.cover->surface == wanted.surface)
                made.cover = m_last.cover;
            else
                made.cover = m_refiner.refine(wanted.surface, topology.vertexCount() <= mostForTwoLevels ? 2 : 1);
            made.trims = m_trims.make(wanted.design, *made.cover);
            m_last = made;
            return made;
        } catch (const std::exception& problem) {
            qWarning("The cover is shown as it is solved: %s", problem.what());
            return {};
        }
    }

private:
    SurfaceRefiner m_refiner;
    SeamTrims m_trims;
    Made m_last;
};

CoverLink::CoverLink(QObject* parent)
    : QObject(parent)
    , m_job([maker = std::make_shared<Maker>()](const Wanted& wanted,
                                                const std::stop_token&) { return (*maker)(wanted); },
            [this](const Made& made) {
                if (made.cover)
                    emit refined(made.cover, made.trims);
            })
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(restAfter);
    connect(&m_rest, &QTimer::timeout, this, &CoverLink::ask);
}

CoverLink::~CoverLink() = default;

void CoverLink::setSurface(const SurfaceMeshPtr& surface)
{
    m_surface = surface;
    m_job.cancel();
    if (surface)
        m_rest.start();
    else
        m_rest.stop();
}

void CoverLink::setDesign(const Design& design)
{
    m_design = design;
    if (m_surface)
        m_rest.start();
}

void CoverLink::ask()
{
    m_job.request({m_surface, m_design}, true);
}

} // namespace bolster
