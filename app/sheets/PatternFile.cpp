#include "PatternFile.h"

#include "HpglWriter.h"
#include "SvgWriter.h"

#include <QDateTime>

namespace bolster {

namespace {

std::string dxf(const CutPattern& pattern, const PatternOrder& order, DxfStandard standard)
{
    const QDateTime now = QDateTime::currentDateTime();
    return dxfText(pattern, {standard, order.layers, now.toString(QStringLiteral("dd-MM-yyyy")).toStdString(),
                             now.toString(QStringLiteral("HH:mm")).toStdString()});
}

} // namespace

std::string patternBytes(const CutPattern& pattern, const PatternOrder& order)
{
    switch (order.format) {
    case PatternFormat::DxfAama:
        return dxf(pattern, order, DxfStandard::Aama);
    case PatternFormat::DxfAstm:
        return dxf(pattern, order, DxfStandard::Astm);
    case PatternFormat::DxfPlain:
        return dxf(pattern, order, DxfStandard::Plain);
    case PatternFormat::Svg:
        return svgText(pattern, order.layers);
    case PatternFormat::Hpgl:
        return hpglText(pattern, order.layers, tableWidth(order.paper, order.landscape));
    case PatternFormat::Pdf:
        break;
    }
    return PatternPdf(pattern, {order.paper, order.landscape, order.layers}).bytes().toStdString();
}

QString patternEnding(PatternFormat format)
{
    switch (format) {
    case PatternFormat::Pdf:
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
