// Sheets of printers, and rolls of plotters.
#pragma once

#include <QSizeF>
#include <QString>
#include <QStringList>

#include <optional>

namespace bolster {

struct PaperSize {
    QSizeF size{210, 297}; ///< mm, upright
    bool roll = false;     ///< as long as it needs to be

    friend bool operator==(const PaperSize&, const PaperSize&) = default;
};

/// "A4", "a3", "A0", "letter", "tabloid", "roll:900" ...; nothing for other words.
std::optional<PaperSize> paperSize(const QString& word);
/// Those with names.
QStringList paperNames();

} // namespace bolster
