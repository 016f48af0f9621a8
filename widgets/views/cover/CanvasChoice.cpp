#include "CanvasChoice.h"

#include "GlCanvas.h"
#include "GlFunctions.h"
#include "SoftwareCanvas.h"

#include <utility>

namespace bolster {

CanvasChoice::CanvasChoice(const ViewScene& scene, const Camera& camera, QWidget& view)
    : m_scene(scene)
    , m_camera(camera)
    , m_view(view)
{}

CanvasChoice::~CanvasChoice() = default;

void CanvasChoice::setSoftwareRenderer(std::unique_ptr<SoftwareRenderer> renderer)
{
    m_renderer = std::move(renderer);
}

void CanvasChoice::setReduced(bool reduced)
{
    if (std::exchange(m_reduced, reduced) != reduced && m_canvas)
        m_canvas->setReduced(reduced);
}

void CanvasChoice::make()
{
    if (m_canvas)
        return;
    const QString problem = m_drawing == Drawing::Software ? tr("Drawn in software") : glProblem();
    if (!problem.isEmpty()) {
        useSoftware(problem);
        return;
    }
    auto canvas = std::make_unique<GlCanvas>(m_scene, m_camera, &m_view);
    connect(canvas.get(), &GlCanvas::failed, this, &CanvasChoice::useSoftware, Qt::QueuedConnection);
    use(std::move(canvas));
    emit note({});
}

void CanvasChoice::makeSoon()
{
    if (m_canvas || m_loading)
        return;
    if (m_drawing == Drawing::Software || !promisesGl()) {
        make();
        return;
    }
    m_loading = std::make_unique<LatestJob<bool, bool>>(
        [](bool, const std::stop_token&) {
            loadGl();
            return true;
        },
        [this](bool) {
            make();
            refresh(false);
        });
    m_loading->request(true);
}

void CanvasChoice::setCovered(bool covered)
{
    m_covered = covered;
    if (m_canvas)
        m_canvas->widget().setVisible(!covered);
}

void CanvasChoice::useSoftware(const QString& why)
{
    m_canvas.reset();
    use(std::make_unique<SoftwareCanvas>(m_scene, m_camera, m_renderer, &m_view));
    emit note(why);
    refresh(false);
}

void CanvasChoice::use(std::unique_ptr<SceneCanvas> canvas)
{
    m_canvas = std::move(canvas);
    m_canvas->whenShownChanges([this] { emit pictured(); });
    m_canvas->setReduced(m_reduced);
    place();
    m_canvas->widget().lower();
    m_canvas->widget().setVisible(!m_covered);
    emit changed(m_canvas->drawsOcclusion());
}

void CanvasChoice::place()
{
    if (m_canvas)
        m_canvas->widget().setGeometry(m_view.rect());
}

void CanvasChoice::refresh(bool moving)
{
    if (m_canvas)
        m_canvas->refresh(moving);
}

QImage CanvasChoice::grab()
{
    make();
    return m_canvas->grab();
}

} // namespace bolster
