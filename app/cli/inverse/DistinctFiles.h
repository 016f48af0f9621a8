// Outputs that are neither inputs nor each other.
#pragma once

#include <QStringList>

namespace bolster::cli {

/// Throws UsageError when two of these outputs are one file, or when one of them is an input, also through links.
/// Empty paths are none.
void expectDistinct(const QStringList& inputs, const QStringList& outputs);

} // namespace bolster::cli
