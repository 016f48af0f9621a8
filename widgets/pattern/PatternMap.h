// A map on the pattern: one picture per patch, made anew only when the numbers change.
#pragma once

#include "ShownMap.h"

#include <QImage>
#include <QRectF>

#include <map>

namespace bolster {

class PatternMap {
public:
    void setMap(ShownMapPtr map);

    struct Picture {
        QImage image;
        QRectF box; ///< in outline coordinates, mm; the first row of pixels is at its top, the smallest y
    };
    /// Null where there is none.
    const Picture* picture(ElementId patch) const;

private:
    Picture paint(const SurfaceTopology::PatchRange& range) const;

    ShownMapPtr m_map;
    std::vector<ShownMap::Rgba> m_colors;
    std::map<ElementId, Picture> m_pictures;
};

} // namespace bolster
