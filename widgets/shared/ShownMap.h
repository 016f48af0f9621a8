// What is measured on the cover, with the words for its legend; shown in colours on cover and pattern.
#pragma once

#include "VertexMap.h"

#include <QString>

#include <optional>

namespace bolster {

struct ShownMap : VertexMap {
    QString title;
    QString below; ///< in words, what negative numbers mean
    QString above;
    QString unit;              ///< with the blank before it
    std::optional<float> mark; ///< a value that matters, marked on the scale

    /// A round number that most of the values' sizes do not exceed.
    static float usualLimit(double size) { return MapScale::usualLimit(size); }
};

using ShownMapPtr = std::shared_ptr<const ShownMap>;

} // namespace bolster
