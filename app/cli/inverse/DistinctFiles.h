// Outputs that are neither inputs nor each other, and how texts become them.
#pragma once

#include "Design.h"

#include <QStringList>

#include <string>

namespace bolster::cli {

/// Throws UsageError when two of these outputs are one file, or when one of them is an input, also through links.
/// Empty paths are none.
void expectDistinct(const QStringList& inputs, const QStringList& outputs);

/// Also a link that leads nowhere: what is written would come to be elsewhere.
bool isThere(const QString& path);
/// When a design is written into another folder than that it was read from: that its files have to follow it.
void sayOfFiles(const Design& design, const QString& readFrom, const QString& written);

/// Whole or not at all, with a line that says which. False when it cannot be written.
bool writeAndSay(const QString& path, const std::string& text);
/// Likewise, and never over what has come to be there meanwhile.
bool writeNewAndSay(const QString& path, const std::string& text);

/// A design, then its report, where that has a path. Each of them also when the other one cannot be written: they
/// may have taken long. False when one cannot.
bool writeWithReport(const QString& path, const std::string& design, const QString& reportPath,
                     const std::string& report);

} // namespace bolster::cli
