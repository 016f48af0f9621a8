// The colours of the views, made from the palette so that they fit light and dark themes.
#pragma once

#include <QColor>
#include <QPalette>

namespace bolster {

struct ViewColors {
    bool dark = false;
    QColor canvas;
    QColor gridMinor;
    QColor gridMajor;
    QColor outline;
    QColor label;
    QColor mutedLabel;
    QColor mesh;
    QColor accent;    ///< what is selected
    QColor hover;     ///< what lies under the pointer
    QColor fixation;  ///< stretches that are fixed to the frame
    QColor handle;    ///< handle curves
    QColor fancySeam; ///< fancy seams
    QColor snap;      ///< hints why a point is where it is, and guides
    QColor pointFill;
    QColor error;
    QColor warning;

    static ViewColors of(const QPalette& palette);
    /// A soft tint of the fabric's colour on the canvas.
    QColor patchFill(const QColor& fabric, double strength) const;
};

/// `a` with the part `share` (0 to 1) of `b` in it.
QColor mixed(const QColor& a, const QColor& b, double share);

} // namespace bolster
