// What rows of measured lengths share.
#pragma once

#include "Document.h"
#include "Gesture.h"
#include "NumberBox.h"
#include "Units.h"

#include <cmath>
#include <functional>
#include <optional>

namespace bolster {

/// Of sizes, mm.
inline const NumberBox::Range sizeRange{millimetreSuffix, 3, 0.001, 1e6, 1};

/// What all of them are, or nothing where they differ by more than rounding.
template <class Read>
std::optional<double> sharedNumber(std::size_t count, const Read& read)
{
    if (count == 0)
        return std::nullopt;
    const double first = read(0);
    for (std::size_t i = 1; i < count; ++i)
        if (std::abs(read(i) - first) > 1e-6)
            return std::nullopt;
    return first;
}

/// As one edit; what would break something is taken back with a reason.
inline void commitChecked(Document& document, const std::function<Edit(const Design&)>& edit)
{
    Gesture gesture(document);
    gesture.update(edit(gesture.start()));
    gesture.commit();
}

} // namespace bolster
