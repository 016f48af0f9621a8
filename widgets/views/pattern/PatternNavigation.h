// Which part of the layout the pattern view shows, and how it comes to show another.
#pragma once

#include "PatternTransform.h"

#include <QObject>
#include <QSize>

class QWidget;

namespace bolster {

class PatternScene;
class Selection;

class PatternNavigation : public QObject {
    Q_OBJECT

public:
    /// All must outlive it. Of the view the size counts.
    PatternNavigation(const PatternScene& scene, const Selection& selection, const QWidget& view);

    const PatternTransform& transform() const { return m_transform; }
    void setTransform(const PatternTransform& transform);
    /// The factor of so many notches of the wheel.
    static double closer(double notches);
    void fitAll();
    void fitSelection(); ///< everything when nothing in the layout is selected
    /// Fits the selection if its edges - without edges its elements - are not all in the picture.
    void revealSelection();
    /// Moves the picture if the place (layout mm) is not in it.
    void reveal(const Vec2& layout);

    /// What was fitted last fills the view, whatever its size, until the user moves it.
    void fitAgain();
    /// Likewise, with a strip along the lower edge left free: pixels.
    void fitAbove(int strip);
    /// The view has another size.
    void resize(QSize before);

signals:
    /// By the user, moved or zoomed.
    void transformChanged(const bolster::PatternTransform& transform);
    /// Whoever has moved it.
    void moved();
    /// Something fills the view.
    void fitted();

private:
    void apply(const PatternTransform& transform);
    void fit(const Box2& box);

    const PatternScene& m_scene;
    const Selection& m_selection;
    const QWidget& m_view;
    PatternTransform m_transform;
    Box2 m_fitted; ///< in the layout; empty: the user has moved it
};

} // namespace bolster
