// How a seam, fixation or trim follows the one where the mirror shows it. Private to the library.
#pragma once

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

std::optional<OutlineTrim> followed(const Lead<OutlineTrim>& lead, bool, const SewnMirror& mirror,
                                    OutlineTrim trimmed);

/// Whether the edit has made both alike already.
bool alike(const Lead<Seam>& lead, bool swapped, const SewnMirror& mirror, const Seam& other);
bool alike(const Lead<FixationSeam>& lead, bool, const SewnMirror& mirror, const FixationSeam& other);
bool alike(const Lead<OutlineTrim>& lead, bool, const SewnMirror& mirror, const OutlineTrim& other);

} // namespace bolster::edits
