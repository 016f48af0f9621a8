// The 3D view on paper: its picture with title and date, and what the colours of a map mean.
#pragma once

#include "ShownMap.h"

#include <QDateTime>
#include <QImage>
#include <QString>

class QPagedPaintDevice;
class QWidget;

namespace bolster {

class CoverView;

struct ViewSheet {
    QImage picture;
    QString title;
    QDateTime when;
    ShownMapPtr map; ///< null when the fabrics are shown
};

/// What the view shows now, on a light ground whatever the window looks like.
ViewSheet sheetOf(CoverView& view, const QString& title);
/// One page, as large as its margins allow. Whether it could be painted.
bool paintSheet(QPagedPaintDevice& paper, const ViewSheet& sheet);
/// Asks for the printer; A4, upright or lying as the picture fits better.
void printSheet(QWidget* window, const ViewSheet& sheet);

} // namespace bolster
