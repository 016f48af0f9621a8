#include "CoverGlide.h"

namespace bolster {

namespace {

constexpr int glideMs = 220;

} // namespace

CoverGlide::CoverGlide(std::function<void(const SurfaceMeshPtr&)> show)
    : m_show(std::move(show))
{
    m_steps.setStartValue(0.0);
    m_steps.setEndValue(1.0);
    m_steps.setDuration(glideMs);
    m_steps.setEasingCurve(QEasingCurve::InOutCubic);
    QObject::connect(&m_steps, &QVariantAnimation::valueChanged, &m_steps, [this](const QVariant& share) {
        if (m_to && share.toDouble() < 1)
            m_show(at(share.toDouble()));
    });
    QObject::connect(&m_steps, &QVariantAnimation::finished, &m_steps, [this] { finish(); });
}

void CoverGlide::start(SurfaceMeshPtr from, SurfaceMeshPtr to)
{
    m_steps.stop();
    m_from = std::move(from);
    m_to = std::move(to);
    if (m_animated)
        m_steps.start();
    else
        finish();
}

void CoverGlide::finish()
{
    const SurfaceMeshPtr last = m_to;
    stop();
    if (last)
        m_show(last);
}

void CoverGlide::stop()
{
    m_steps.stop();
    m_from.reset();
    m_to.reset();
}

SurfaceMeshPtr CoverGlide::at(double share) const
{
    auto step = std::make_shared<SurfaceMesh>(*m_from);
    for (std::size_t v = 0; v < step->positions.size(); ++v) {
        step->positions[v] += share * (m_to->positions[v] - step->positions[v]);
        const Eigen::Vector3f normal =
            step->normals[v] + static_cast<float>(share) * (m_to->normals[v] - step->normals[v]);
        step->normals[v] = normal.norm() > 0.1F ? Eigen::Vector3f(normal.normalized()) : m_to->normals[v];
    }
    return step;
}

} // namespace bolster
