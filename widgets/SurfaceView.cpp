#include "SurfaceView.h"

namespace bolster {

SurfaceView::SurfaceView(Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_selection(selection)
{}

SurfaceView::~SurfaceView() = default;

void SurfaceView::setSoftwareRenderer(std::unique_ptr<SoftwareRenderer>) {}

void SurfaceView::setDrawing(Drawing) {}

void SurfaceView::setSurface(SurfaceMeshPtr surface)
{
    m_surface = std::move(surface);
    update();
}

SurfaceMeshPtr SurfaceView::surface() const
{
    return m_surface;
}

void SurfaceView::setFrames(const FrameMeshes&) {}

void SurfaceView::setDimmed(bool) {}

void SurfaceView::fitAll() {}

void SurfaceView::fitSelection() {}

void SurfaceView::setStandardView(StandardView) {}

void SurfaceView::setPerspective(bool perspective)
{
    m_camera.perspective = perspective;
    emit perspectiveChanged(perspective);
}

bool SurfaceView::perspective() const
{
    return m_camera.perspective;
}

const Camera& SurfaceView::camera() const
{
    return m_camera;
}

void SurfaceView::setCamera(const Camera& camera)
{
    m_camera = camera;
}

void SurfaceView::setLayerVisible(Layer, bool) {}

bool SurfaceView::layerVisible(Layer) const
{
    return true;
}

QImage SurfaceView::grabPicture()
{
    return {};
}

QString SurfaceView::prompt() const
{
    return {};
}

} // namespace bolster
