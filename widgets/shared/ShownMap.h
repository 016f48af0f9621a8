// What is measured on the cover, with the words for its legend; shown in colours on cover and pattern.
#pragma once

#include "VertexMap.h"

#include <QString>

namespace bolster {

struct ShownMap : VertexMap {
    QString title;
    QString below; ///< in words, what negative numbers mean
    QString above;
    QString unit; ///< with the blank before it

    /// A round number that most of the values' sizes do not exceed.
    static float usualLimit(double size) { return MapScale::usualLimit(size); }
};

using ShownMapPtr = std::shared_ptr<const ShownMap>;

} // namespace bolster
