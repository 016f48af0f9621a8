// What the sewing tool draws: the stretches, how they will be joined, and how their lengths match.
#pragma once

#include "Design.h"
#include "PatternScene.h"
#include "PatternTransform.h"

class QPainter;

namespace bolster {

struct ViewColors;

/// One picture; made anew for each paint event. Positions are pixels, `marks` layout mm.
class SewPicture {
public:
    static constexpr double buttonRadius = 12;

    SewPicture(const PatternScene& scene, const PatternTransform& transform)
        : m_scene(scene)
        , m_transform(transform)
    {}

    Design design;
    std::vector<Stretch> taken; ///< the first side, then those of the second
    std::optional<Stretch> offer;
    bool refused = false; ///< the offer
    bool flipped = false;
    std::vector<Vec2> marks;
    QPointF pointer;
    std::optional<QPointF> button;
    bool buttonHovered = false;

    void paint(QPainter& painter, const ViewColors& colors) const;
    /// Beside the middle of a stretch, inside its patch.
    std::optional<QPointF> besideMiddle(const Stretch& stretch) const;

private:
    QPainterPath path(const Stretch& stretch, bool backwards) const;
    bool leftIsInside(const Stretch& stretch, bool backwards) const;
    /// The second side with what is offered for it.
    std::vector<Stretch> row() const;
    void paintStretch(QPainter& painter, const Stretch& stretch, bool backwards, const QColor& color) const;
    void paintSeams(QPainter& painter, const ViewColors& colors) const;
    void paintButton(QPainter& painter, const ViewColors& colors) const;
    void paintFigures(QPainter& painter, const ViewColors& colors) const;
    QStringList figures(bool* puckers) const;

    const PatternScene& m_scene;
    const PatternTransform& m_transform;
};

} // namespace bolster
