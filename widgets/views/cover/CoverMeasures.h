// Measurements over the 3D view, with their lengths on the cover.
#pragma once

#include "ElementId.h"
#include "Geometry.h"

#include <QLineF>
#include <QWidget>

#include <map>
#include <optional>
#include <vector>

namespace bolster {

class Camera;
class Document;
class Selection;
class ShownScene;
struct Measurement;

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

    /// The one whose line is under the pointer (pixels); noElement for none.
    ElementId at(QPointF pixel) const;

signals:
    /// How long they are on the cover, mm; of those that are not on it nothing is said.
    void measured(const std::map<bolster::ElementId, double>& lengths);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Ends {
        Vec3 from = Vec3::Zero(), to = Vec3::Zero();
        double length() const { return (to - from).norm(); } ///< mm
    };
    /// On the cover; none if it is not there.
    std::optional<Ends> endsOf(const Measurement& measured) const;

    struct Seen {
        ElementId id{};
        QLineF line;       ///< pixels
        double length = 0; ///< mm
    };
    /// Those that are on the cover and in the picture.
    std::vector<Seen> seen() const;
    void measure();

    const Document& m_document;
    const Selection& m_selection;
    ShownScene& m_shown;
    const Camera& m_camera;
    bool m_wanted = true;
};

} // namespace bolster
