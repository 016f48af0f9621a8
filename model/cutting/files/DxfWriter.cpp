#include "DxfWriter.h"

#include "CutTable.h"
#include "CutText.h"
#include "DxfText.h"

#include <map>
#include <numbers>
#include <set>

namespace bolster {

namespace {

/// Layers of AAMA and ASTM by number, of the plain one by name.
struct Layers {
    const char *cut, *turn, *curve, *notch, *grain, *internal, *cutOut, *hole, *sew, *text;
};
constexpr Layers numbered{"1", "2", "3", "4", "7", "8", "11", "13", "14", "15"};
constexpr Layers named{"cut", "", "", "notches", "grain", "internal", "internal-cut", "holes", "sew", "labels"};

/// Without blocks: everything where it lies.
bool isOnTable(DxfStandard standard)
{
    return standard == DxfStandard::Plain || standard == DxfStandard::Splines;
}

BSpline2 placed(const BSpline2& curve, const TablePiece& place)
{
    std::vector<Vec2> points;
    for (const Vec2& point : curve.points())
        points.push_back(place.at(point));
    return curve.withPoints(std::move(points));
}

std::vector<Vec2> placesOf(const std::vector<LinePoint>& line, const TablePiece& place)
{
    std::vector<Vec2> points;
    for (const LinePoint& point : line)
        points.push_back(place.at(point.at));
    return points;
}

/// "KEY: value" as blocks have it.
std::vector<std::pair<std::string, std::string>> pieceWords(const CutPiece& piece)
{
    return {{"Piece Name", piece.name},
            {"Quantity", quantityText(piece)},
            {"Fabric", piece.fabricName},
            {"Nap", napText(piece)},
            {"Grain Tolerance", toleranceText(piece)},
            {"Shrinkage", shrinkageText(piece)},
            {"Annotation", piece.mirrored ? "mirrored" : piece.note}};
}

class PieceWriter {
public:
    PieceWriter(DxfText& dxf, const DxfOrder& order, const CutPiece& piece, const TablePiece& place)
        : m_dxf(dxf)
        , m_order(order)
        , m_names(isOnTable(order.standard) ? named : numbered)
        , m_piece(piece)
        , m_place(place)
    {}

    void write()
    {
        const CutLayers& layers = m_order.layers;
        comments();
        if (layers.cut && m_piece.cut == m_piece.sew)
            sewingLine(m_names.cut);
        else if (layers.cut)
            outline(m_names.cut, m_piece.cut);
        // A piece without its cut line has its sewing line for a boundary.
        if (layers.sew)
            sewingLine(layers.cut || isPlain() ? m_names.sew : m_names.cut);
        if (!isPlain()) {
            corners(layers.cut ? m_piece.cut : m_piece.sew);
            // Whoever reads the sewing line wants to know its corners, too.
            if (layers.cut && layers.sew)
                for (const LinePoint& point : m_piece.sew)
                    if (point.corner)
                        m_dxf.dot(m_names.turn, m_place.at(point.at));
        }
        if (layers.notches)
            for (const CutNotch& notch : m_piece.notches)
                isPlain() ? drawn(notch) : point(notch);
        if (layers.grain && m_piece.grain.from != m_piece.grain.to)
            m_dxf.line(m_names.grain, m_place.at(m_piece.grain.from), m_place.at(m_piece.grain.to));
        if (layers.internal)
            for (const PieceLine& line : m_piece.inner)
                inner(line.cut ? m_names.cutOut : m_names.internal, line);
        if (layers.holes)
            for (const CutHole& hole : m_piece.holes)
                this->hole(hole);
        if (layers.labels)
            label();
    }

private:
    /// What only texts for people say in the plain file, and what ASCII cannot: for programs that import it.
    void comments()
    {
        const auto isAscii = [](const std::string& words) { return ascii(words) == words; };
        if (!isPlain() && isAscii(m_piece.name) && isAscii(m_piece.fabricName) && isAscii(m_piece.note))
            return;
        for (const auto& [key, value] : pieceWords(m_piece))
            if (!value.empty())
                m_dxf.pair(999, escapedAscii(key + ": " + value));
    }

    bool isPlain() const { return isOnTable(m_order.standard); }

    void outline(const char* layer, const std::vector<LinePoint>& line)
    {
        m_dxf.polyline(layer, placesOf(line, m_place), true);
    }

    void sewingLine(const char* layer)
    {
        if (m_dxf.isR2000())
            m_dxf.curve(layer, placed(m_piece.outline, m_place));
        else
            outline(layer, m_piece.sew);
    }

    void inner(const char* layer, const PieceLine& line)
    {
        if (m_dxf.isR2000())
            m_dxf.curve(layer, placed(line.curve, m_place));
        else
            m_dxf.polyline(layer, placesOf(line.points, m_place), line.closed);
    }

    void corners(const std::vector<LinePoint>& line)
    {
        for (const LinePoint& point : line)
            m_dxf.dot(point.corner ? m_names.turn : m_names.curve, m_place.at(point.at));
    }

    static const char* layerOf(NotchShape::Kind kind)
    {
        switch (kind) {
        case NotchShape::Kind::T:
            return "80";
        case NotchShape::Kind::Castle:
            return "81";
        case NotchShape::Kind::U:
            return "83";
        case NotchShape::Kind::Slit:
        case NotchShape::Kind::V:
            break;
        }
        return "4";
    }

    /// Depth as others have it: in z, negative because it goes inwards; width as thickness, a slit without one.
    void point(const CutNotch& notch)
    {
        const Vec2 inwards = Eigen::Rotation2Dd(m_place.angle) * notch.inwards;
        for (const Vec2& at : notchPoints(notch)) {
            m_dxf.dot(layerOf(notch.shape.kind), m_place.at(at));
            m_dxf.number(30, -notch.shape.depth);
            if (notch.shape.kind != NotchShape::Kind::Slit)
                m_dxf.number(39, notch.shape.width);
            m_dxf.number(50, std::atan2(inwards.y(), inwards.x()) * 180 / std::numbers::pi);
        }
    }

    void drawn(const CutNotch& notch)
    {
        for (const std::vector<Vec2>& line : notchLines(notch)) {
            std::vector<Vec2> points;
            for (const Vec2& point : line)
                points.push_back(m_place.at(point));
            m_dxf.polyline(m_names.notch, points, false);
        }
    }

    void hole(const CutHole& hole)
    {
        if (isPlain()) {
            m_dxf.circle(m_names.hole, m_place.at(hole.at), hole.diameter / 2);
            return;
        }
        m_dxf.dot(m_names.hole, m_place.at(hole.at));
        m_dxf.number(30, hole.diameter);
    }

    void label()
    {
        const PieceLabel& label = m_piece.label;
        const Eigen::Rotation2Dd turn(label.rotation * std::numbers::pi / 180);
        double down = static_cast<double>(label.lines.size()) / 2 - 0.8;
        for (const std::string& line : label.lines) {
            const Vec2 at = label.at + turn * Vec2(-label.width / 2, down * label.height);
            m_dxf.text(m_names.text, m_place.at(at), 0.7 * label.height,
                       label.rotation + m_place.angle * 180 / std::numbers::pi, line);
            down -= 1;
        }
    }

    DxfText& m_dxf;
    const DxfOrder& m_order;
    const Layers& m_names;
    const CutPiece& m_piece;
    const TablePiece& m_place;
};

/// A name for each block: ASCII, and no two alike.
class BlockNames {
public:
    std::string name(const CutPiece& piece)
    {
        std::string stem;
        for (const char c : ascii(piece.name))
            stem += std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == ' ' ? c : '_';
        if (stem.empty())
            stem = "Piece";
        if (piece.mirrored)
            stem += " mirrored";
        std::string name = stem + "_M";
        for (int& count = m_counts[stem]; !m_taken.insert(name).second;)
            name = stem + " " + std::to_string(++count + 1) + "_M";
        return name;
    }

private:
    std::set<std::string> m_taken;
    std::map<std::string, int> m_counts; // of pieces with one stem, beyond the first
};

/// Whole sheets, without blocks.
void writePlain(DxfText& dxf, const CutPattern& pattern, const DxfOrder& order)
{
    const CutTable table = arranged(pattern, usualTableWidth);
    dxf.begin("HEADER");
    dxf.pair(9, "$ACADVER");
    dxf.pair(1, "AC1009");
    dxf.pair(9, "$INSUNITS"); // nobody knew it then, and everybody asks for it now
    dxf.pair(70, "4");
    dxf.pair(9, "$EXTMIN");
    dxf.point(10, Vec2::Zero());
    dxf.pair(9, "$EXTMAX");
    dxf.point(10, table.size);
    dxf.end();
    dxf.begin("ENTITIES");
    for (const TablePiece& place : table.pieces)
        PieceWriter(dxf, order, pattern.pieces[place.piece], place).write();
    dxf.end();
}

/// The same as R2000, with curves.
void writeSplines(DxfText& dxf, const CutPattern& pattern, const DxfOrder& order)
{
    const CutTable table = arranged(pattern, usualTableWidth);
    beginR2000(dxf, {{named.cut, named.notch, named.grain, named.internal, named.cutOut, named.hole, named.sew,
                      named.text},
                     table.size});
    for (const TablePiece& place : table.pieces)
        PieceWriter(dxf, order, pattern.pieces[place.piece], place).write();
    endR2000(dxf);
}

void writePieceBlock(DxfText& dxf, const CutPiece& piece, const std::string& name, const DxfOrder& order)
{
    dxf.entity("BLOCK", "0");
    dxf.pair(2, name);
    dxf.pair(70, "64");
    dxf.point(10, Vec2::Zero());
    double line = piece.box().isEmpty() ? 0 : piece.box().min().y() - 10;
    std::vector<std::pair<std::string, std::string>> words = pieceWords(piece);
    words.insert(words.begin() + 1, {"Size", "M"});
    for (const auto& [key, value] : words)
        if (!value.empty()) {
            dxf.text("1", {piece.box().min().x(), line}, 5, 0, key + ": " + value);
            line -= 7;
        }
    PieceWriter(dxf, order, piece, {}).write();
    dxf.entity("ENDBLK", "0");
}

void writeBlocks(DxfText& dxf, const CutPattern& pattern, const DxfOrder& order)
{
    const CutTable table = arranged(pattern, usualTableWidth);
    dxf.begin("HEADER");
    dxf.pair(9, "$ACADVER");
    dxf.pair(1, "AC1009");
    dxf.end();
    BlockNames names;
    std::vector<std::string> blocks;
    dxf.begin("BLOCKS");
    for (const CutPiece& piece : pattern.pieces) {
        blocks.push_back(names.name(piece));
        writePieceBlock(dxf, piece, blocks.back(), order);
    }
    dxf.end();

    dxf.begin("ENTITIES");
    std::vector<std::string> style;
    const bool astm = order.standard == DxfStandard::Astm;
    if (astm)
        style.push_back("ASTM/D13Proposal 1 Version: D 6673-04");
    style.push_back("Style Name: " + (pattern.style.empty() ? std::string("Bolster") : pattern.style));
    if (!order.date.empty())
        style.push_back("Creation Date: " + order.date);
    if (!order.time.empty())
        style.push_back("Creation Time: " + order.time);
    style.push_back("Author: Bolster");
    style.push_back("Product: Bolster");
    if (!pattern.version.empty())
        style.push_back("Version: " + pattern.version);
    style.push_back("Sample Size: M");
    style.push_back("Units: METRIC");
    style.push_back(astm ? "Curve Tolerance: 0.05" : "Tolerance: 0.05");
    double line = -20;
    for (const std::string& text : style) {
        dxf.text("1", {0, line}, 10, 0, text);
        line -= 15;
    }
    for (const TablePiece& place : table.pieces) {
        dxf.entity("INSERT", "1");
        dxf.pair(2, blocks[place.piece]);
        dxf.point(10, place.offset);
        if (place.angle != 0)
            dxf.number(50, place.angle * 180 / std::numbers::pi);
    }
    dxf.end();
}

} // namespace

std::string dxfText(const CutPattern& pattern, const DxfOrder& order)
{
    DxfText dxf(order.standard == DxfStandard::Splines);
    if (order.standard == DxfStandard::Plain)
        writePlain(dxf, pattern, order);
    else if (order.standard == DxfStandard::Splines)
        writeSplines(dxf, pattern, order);
    else
        writeBlocks(dxf, pattern, order);
    dxf.pair(0, "EOF");
    return dxf.result();
}

} // namespace bolster
