// How a seam, fixation or trim follows the one where the mirror shows it. Private to the library.
#pragma once

#include "PatchMark.h"
#include "SewnMirror.h"

namespace bolster::edits {

/// Before the edit and now.
template <class T>
struct Lead {
    const T& before;
    const T& now;
};

/// The counterpart with all that has changed; nothing when the mirror has no such place. `swapped` as in
/// SewnMirror::Counterpart.
std::optional<Seam> followed(const Lead<Seam>& lead, bool swapped, const SewnMirror& mirror, Seam seam);
std::optional<FixationSeam> followed(const Lead<FixationSeam>& lead, bool, const SewnMirror& mirror,
                                     FixationSeam fixation);

template <PatchMark T>
std::optional<T> followed(const Lead<T>& lead, bool, const SewnMirror& mirror, const T& there)
{
    const auto image = mirror.of(lead.now);
    if (!image)
        return std::nullopt;
    T rest = lead.before;
    whereOf(rest) = whereOf(lead.now);
    T result = rest == lead.now ? there : *image; // all but the place follows at once
    const bool moved = !(whereOf(lead.before) == whereOf(lead.now));
    whereOf(result) = moved && !mirror.same(whereOf(there), whereOf(*image)) ? whereOf(*image) : whereOf(there);
    return result;
}

/// Whether the edit has made both alike already.
bool alike(const Lead<Seam>& lead, bool swapped, const SewnMirror& mirror, const Seam& other);
bool alike(const Lead<FixationSeam>& lead, bool, const SewnMirror& mirror, const FixationSeam& other);
template <PatchMark T>
bool alike(const Lead<T>& lead, bool, const SewnMirror& mirror, const T& other)
{
    const auto image = mirror.of(lead.now);
    return image && *image == other;
}

} // namespace bolster::edits
