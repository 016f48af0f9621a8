// Measurements over the 3D view, with their lengths on the cover.
#pragma once

#include <QWidget>

namespace bolster {

class Camera;
class Document;
class Selection;
class ShownScene;

/// Lies above its parent without taking the pointer.
class CoverMeasures : public QWidget {
    Q_OBJECT

public:
    /// All must outlive it.
    CoverMeasures(const Document& document, const Selection& selection, ShownScene& shown, const Camera& camera,
                  QWidget* view);

    void setWanted(bool wanted);
    /// Cover, camera, design or selection have changed.
    void refresh();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    const Document& m_document;
    const Selection& m_selection;
    ShownScene& m_shown;
    const Camera& m_camera;
    bool m_wanted = true;
};

} // namespace bolster
