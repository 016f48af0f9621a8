// A picture to trace: a photo or scan of a pattern, under the pointer while one draws. Not part of the design.
#pragma once

#include "PatternTransform.h"

#include <QImage>
#include <QString>

class QPainter;

namespace bolster {

struct BackgroundPicture {
    QImage image; ///< null for none
    QString path;
    Vec2 corner = Vec2::Zero(); ///< upper left, layout mm
    double pixelSize = 1;       ///< mm
    double opacity = 0.6;       ///< 0 to 1
    bool shown = true;

    bool empty() const { return image.isNull(); }
    Box2 box() const; ///< in the layout, mm
    /// The same with `about` (layout mm) staying where it is.
    BackgroundPicture scaled(double factor, const Vec2& about) const;
    BackgroundPicture moved(const Vec2& delta) const;
};

/// Reads a picture file, turned upright as the camera says, and places it in the middle of a part of the layout.
/// Empty when it cannot be read; `problem` then says why, in the user's words.
BackgroundPicture readBackground(const QString& path, const Box2& into, QString* problem);

/// On a light ground as if on tracing paper: what is white in the picture hides nothing.
void paintBackground(QPainter& painter, const BackgroundPicture& picture, const PatternTransform& transform,
                     bool dark);

} // namespace bolster
