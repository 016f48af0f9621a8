#include "SvgWriter.h"

#include "CutTable.h"
#include "CutText.h"

#include <numbers>

namespace bolster {

namespace {

constexpr double border = 10; // mm

std::string escapedXml(std::string_view text)
{
    std::string result;
    for (const char c : text)
        switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        default:
            if (static_cast<unsigned char>(c) >= 0x20) // others may not be in XML at all
                result += c;
        }
    return result;
}

/// What people read of the label, for programs that import it.
std::string aboutPiece(const CutPiece& piece)
{
    std::string about;
    for (const auto& [key, value] : {std::pair<const char*, std::string>("piece", piece.name),
                                     {"quantity", quantityText(piece)},
                                     {"fabric", piece.fabricName},
                                     {"nap", napText(piece)},
                                     {"grain-tolerance", toleranceText(piece)},
                                     {"shrinkage", shrinkageText(piece)},
                                     {"note", piece.note}})
        if (!value.empty())
            about.append(" data-").append(key).append("=\"").append(escapedXml(value)).append("\"");
    return about;
}

class Svg {
public:
    Svg(const CutPattern& pattern)
        : m_pattern(pattern)
        , m_table(arranged(pattern, usualTableWidth))
        , m_size(m_table.size + Vec2(2 * border, 2 * border))
    {
        m_text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
                 decimal(m_size.x()) + "mm\" height=\"" + decimal(m_size.y()) + "mm\" viewBox=\"0 0 " +
                 decimal(m_size.x()) + " " + decimal(m_size.y()) + "\">\n";
        // The heads of grain lines, which are no lines of their own for who reads the file.
        m_text += "  <defs><marker id=\"up\" markerUnits=\"userSpaceOnUse\" markerWidth=\"7\" markerHeight=\"5\" "
                  "refX=\"6.5\" refY=\"2.5\" orient=\"auto-start-reverse\"><path d=\"M0.5 0.5L6.5 2.5L0.5 4.5\" "
                  "fill=\"none\" stroke=\"#000000\" stroke-width=\"0.1\"/></marker></defs>\n";
        if (!pattern.style.empty())
            m_text += "  <title>" + escapedXml(pattern.style) + "</title>\n";
    }

    /// A group with what `write` adds for each piece.
    template <class Write>
    void layer(const char* id, const char* stroke, const Write& write)
    {
        m_text += std::string("  <g id=\"") + id + "\" fill=\"none\" stroke=\"" + stroke +
                  "\" stroke-width=\"0.1\" stroke-linejoin=\"round\">\n";
        for (const TablePiece& place : m_table.pieces) {
            m_place = &place;
            write(m_pattern.pieces[place.piece]);
        }
        m_text += "  </g>\n";
    }

    void path(const std::vector<Vec2>& points, bool closed, const std::string& about = {})
    {
        m_text.append("    <path").append(about).append(" d=\"");
        for (std::size_t i = 0; i < points.size(); ++i)
            m_text.append(i == 0 ? "M" : "L").append(placed(points[i]));
        m_text += closed ? "Z\"/>\n" : "\"/>\n";
    }
    void path(const std::vector<LinePoint>& line, bool closed, const std::string& about = {})
    {
        std::vector<Vec2> points;
        for (const LinePoint& point : line)
            points.push_back(point.at);
        path(points, closed, about);
    }
    void circle(const Vec2& at, double radius)
    {
        const Vec2 p = onSheet(at);
        m_text += "    <circle cx=\"" + decimal(p.x()) + "\" cy=\"" + decimal(p.y()) + "\" r=\"" + decimal(radius) +
                  "\"/>\n";
    }
    void label(const PieceLabel& label)
    {
        const Eigen::Rotation2Dd turn(label.rotation * std::numbers::pi / 180);
        double down = static_cast<double>(label.lines.size()) / 2 - 0.8;
        for (const std::string& line : label.lines) {
            const Vec2 p = onSheet(label.at + turn * Vec2(0, down * label.height));
            const double degrees = -(label.rotation + m_place->angle * 180 / std::numbers::pi);
            m_text += "    <text x=\"" + decimal(p.x()) + "\" y=\"" + decimal(p.y()) + "\" transform=\"rotate(" +
                      decimal(degrees) + " " + decimal(p.x()) + " " + decimal(p.y()) +
                      ")\" font-family=\"sans-serif\" font-size=\"" + decimal(0.75 * label.height) +
                      "\" text-anchor=\"middle\" fill=\"#000000\" stroke=\"none\">" + escapedXml(line) +
                      "</text>\n";
            down -= 1;
        }
    }

    std::string result() { return std::move(m_text) + "</svg>\n"; }

private:
    /// y runs down there.
    Vec2 onSheet(const Vec2& point) const
    {
        const Vec2 p = m_place->at(point);
        return {p.x() + border, m_size.y() - border - p.y()};
    }
    std::string placed(const Vec2& point) const
    {
        const Vec2 p = onSheet(point);
        return decimal(p.x()) + " " + decimal(p.y());
    }

    const CutPattern& m_pattern;
    CutTable m_table;
    Vec2 m_size;
    const TablePiece* m_place = nullptr;
    std::string m_text;
};

} // namespace

std::string svgText(const CutPattern& pattern, const CutLayers& layers)
{
    Svg svg(pattern);
    if (layers.internal)
        svg.layer("internal", "#808080", [&](const CutPiece& piece) {
            for (const PieceLine& line : piece.inner)
                svg.path(line.points, line.closed);
        });
    if (layers.holes)
        svg.layer("holes", "#000000", [&](const CutPiece& piece) {
            for (const CutHole& hole : piece.holes)
                svg.circle(hole.at, hole.diameter / 2);
        });
    if (layers.grain)
        svg.layer("grain", "#000000", [&](const CutPiece& piece) {
            const char* const heads = piece.grain.nap == Nap::OneWay
                                          ? " marker-end=\"url(#up)\""
                                          : " marker-start=\"url(#up)\" marker-end=\"url(#up)\"";
            svg.path(std::vector{piece.grain.from, piece.grain.to}, false, heads);
        });
    if (layers.labels)
        svg.layer("labels", "#000000", [&](const CutPiece& piece) { svg.label(piece.label); });
    if (layers.sew)
        svg.layer("sew", "#0060c0", [&](const CutPiece& piece) {
            svg.path(piece.sew, true, layers.cut ? std::string() : aboutPiece(piece));
        });
    if (layers.notches)
        svg.layer("notches", "#000000", [&](const CutPiece& piece) {
            for (const CutNotch& notch : piece.notches)
                for (const std::vector<Vec2>& line : notchLines(notch))
                    svg.path(line, false);
        });
    if (layers.cut)
        svg.layer("cut", "#000000", [&](const CutPiece& piece) { svg.path(piece.cut, true, aboutPiece(piece)); });
    return svg.result();
}

} // namespace bolster
