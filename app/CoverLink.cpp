#include "CoverLink.h"

#include "SurfaceRefiner.h"

#include <QDebug>

#include <chrono>
#include <exception>

namespace bolster {

namespace {

using namespace std::chrono_literals;

constexpr auto restAfter = 120ms;
constexpr std::uint32_t mostForTwoLevels = 25000; ///< vertices: more give more triangles than pixels

CoverMeshPtr refine(SurfaceRefiner& refiner, const SurfaceMeshPtr& surface)
{
    try {
        return refiner.refine(surface, surface->topology->vertexCount() <= mostForTwoLevels ? 2 : 1);
    } catch (const std::exception& problem) {
        qWarning("The cover is shown as it is solved: %s", problem.what());
        return nullptr;
    }
}

} // namespace

CoverLink::CoverLink(QObject* parent)
    : QObject(parent)
    , m_job([refiner = std::make_shared<SurfaceRefiner>()](
                const SurfaceMeshPtr& surface, const std::stop_token&) { return refine(*refiner, surface); },
            [this](CoverMeshPtr cover) {
                if (cover)
                    emit refined(cover);
            })
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(restAfter);
    connect(&m_rest, &QTimer::timeout, this, [this] { m_job.request(m_surface, true); });
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

} // namespace bolster
