// Sheets that were parted, joined again where that is possible. Private to the library.
#pragma once

#include "SheetTrials.h"

#include <map>
#include <utility>
#include <vector>

namespace bolster {

/// Two of several sheets, the lesser number first.
using SheetPair = std::pair<std::size_t, std::size_t>;

/// mm, of the borders of neighbours.
std::map<SheetPair, double> commonLengths(const std::vector<FormSheet>& sheets, const SheetTrials& trials);

/// Splinters of a mesh lean anywhere: what they part belongs to what it has most of its border in common with.
void joinCrumbs(std::vector<FormSheet>& sheets, const SheetTrials& trials);

/// Neighbours that lie flat together are one again, first those that have most of their outline in common.
/// `onlySmall`: those of which one is smaller than what is divided.
std::vector<FormSheet> joined(std::vector<FormSheet> sheets, bool onlySmall, const SheetTrials& trials);

} // namespace bolster
