#include "PaperSize.h"

#include <utility>

namespace bolster {

namespace {

const std::pair<const char*, QSizeF> papers[] = {
    {"A4", {210, 297}},  {"A3", {297, 420}},         {"A2", {420, 594}},         {"A1", {594, 841}},
    {"A0", {841, 1189}}, {"Letter", {215.9, 279.4}}, {"Tabloid", {279.4, 431.8}}};
constexpr double narrowestRoll = 150, widestRoll = 5000; // mm

} // namespace

std::optional<PaperSize> paperSize(const QString& word)
{
    for (const auto& [name, size] : papers)
        if (word.compare(QLatin1String(name), Qt::CaseInsensitive) == 0)
            return PaperSize{size, false};
    if (!word.startsWith(QLatin1String("roll:"), Qt::CaseInsensitive))
        return std::nullopt;
    bool isNumber = false;
    const double width = word.mid(5).toDouble(&isNumber);
    if (!isNumber || !(width >= narrowestRoll && width <= widestRoll))
        return std::nullopt;
    return PaperSize{{width, 0}, true};
}

QStringList paperNames()
{
    QStringList names;
    for (const auto& [name, size] : papers)
        names << QString::fromLatin1(name);
    return names;
}

} // namespace bolster
