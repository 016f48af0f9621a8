#include "PatternFile.h"

#include "HpglWriter.h"
#include "SewingSheet.h"
#include "SvgWriter.h"

#include <QDateTime>
#include <QLocale>

namespace bolster {

namespace {

std::string dxf(const CutPattern& pattern, const PatternOrder& order, DxfStandard standard)
{
    const QDateTime now = QDateTime::currentDateTime();
    return dxfText(pattern, {standard, order.layers, now.toString(QStringLiteral("dd-MM-yyyy")).toStdString(),
                             now.toString(QStringLiteral("HH:mm")).toStdString()});
}

template <class Use>
auto withSewingSheet(const Design& design, const PatternOrder& order, const QImage& cover, const SheetWatch& watch,
                     const Use& use)
{
    const SewingPlan plan = sewingPlan(design, order.cutting, watch.stop);
    const QString today = QLocale().toString(QDate::currentDate(), QLocale::ShortFormat);
    return use(SewingSheet(design, plan, cover.isNull() ? std::vector<QImage>() : std::vector{cover}, today));
}

std::string bytesOf(const CutPattern& pattern, const PatternOrder& order, const SheetWatch& watch)
{
    switch (order.format) {
    case PatternFormat::DxfAama:
        return dxf(pattern, order, DxfStandard::Aama);
    case PatternFormat::DxfAstm:
        return dxf(pattern, order, DxfStandard::Astm);
    case PatternFormat::DxfPlain:
        return dxf(pattern, order, DxfStandard::Plain);
    case PatternFormat::DxfSplines:
        return dxf(pattern, order, DxfStandard::Splines);
    case PatternFormat::Svg:
        return svgText(pattern, order.layers);
    case PatternFormat::Hpgl:
        return hpglText(pattern, order.layers, tableWidth(order.paper, order.landscape));
    case PatternFormat::Pdf:
    case PatternFormat::SewingSheet:
        break;
    }
    return PatternPdf(pattern, {order.paper, order.landscape, order.layers}, watch.stop).bytes(watch).toStdString();
}

} // namespace

std::string patternBytes(const Design& design, const PatternOrder& order, const QImage& cover,
                         const SheetWatch& watch)
{
    if (order.format == PatternFormat::SewingSheet)
        return withSewingSheet(design, order, cover, watch, [&](const SewingSheet& sheet) {
            return sheet.pdf(order.paper, watch).toStdString();
        });
    std::string bytes = bytesOf(cutPattern(design, order.cutting, watch.stop), order, watch);
    return watch.stopped() ? std::string() : bytes;
}

std::vector<QImage> sewingPages(const Design& design, const PatternOrder& order, const QImage& cover, int width,
                                int most, int& all, const SheetWatch& watch)
{
    return withSewingSheet(design, order, cover, watch, [&](const SewingSheet& sheet) {
        return sheet.pictures(order.paper, width, most, all, watch);
    });
}

QString patternEnding(PatternFormat format)
{
    switch (format) {
    case PatternFormat::Pdf:
    case PatternFormat::SewingSheet:
        return QStringLiteral("pdf");
    case PatternFormat::Svg:
        return QStringLiteral("svg");
    case PatternFormat::Hpgl:
        return QStringLiteral("plt");
    default:
        return QStringLiteral("dxf");
    }
}

} // namespace bolster
