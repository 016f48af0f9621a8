// The cross-hair in the pattern: where the 3D view's pointer is.
#pragma once

#include "CoverPlaces.h"

class QWidget;

namespace bolster {

class Crosshair;
class PatternNavigation;
class ShownPattern;

class PatternCrosshair {
public:
    /// All must outlive it.
    PatternCrosshair(const ShownPattern& shown, const PatternNavigation& navigation, QWidget& view);

    /// At a point of a patch; nothing takes it away.
    void show(const std::optional<CoverPoint>& point);
    /// The picture has moved.
    void place();

private:
    const ShownPattern& m_shown;
    const PatternNavigation& m_navigation;
    Crosshair* m_crosshair; ///< the view's
    std::optional<CoverPoint> m_point;
};

} // namespace bolster
