#include "DxfText.h"

#include "CutText.h"

namespace bolster {

namespace {

// Handles of what every file of R2000 has.
constexpr const char* modelSpace = "1F";
constexpr const char* paperSpace = "1B";
constexpr const char* rootDictionary = "C";
constexpr const char* groups = "D";
constexpr const char* lastHandle = "FFFFFF"; // larger than any that is given

constexpr double straight = 1e-9; // of the length

/// Whether an open curve runs straight from its first point to its last.
bool isStraight(const BSpline2& curve)
{
    const Vec2 way = curve.points().back() - curve.points().front();
    double walked = 0;
    for (std::size_t i = 1; i < curve.points().size(); ++i)
        walked += (curve.points()[i] - curve.points()[i - 1]).norm();
    return way.norm() > 0 && walked - way.norm() < straight * way.norm();
}

/// One of the tables; its entries follow.
class DxfTable {
public:
    DxfTable(DxfText& dxf, std::string_view name, std::string_view handle, int entries)
        : m_dxf(dxf)
        , m_handle(handle)
    {
        dxf.pair(0, "TABLE");
        dxf.pair(2, name);
        dxf.pair(5, handle);
        dxf.pair(330, "0");
        dxf.pair(100, "AcDbSymbolTable");
        dxf.pair(70, std::to_string(entries));
    }
    ~DxfTable() { m_dxf.pair(0, "ENDTAB"); }
    DxfTable(const DxfTable&) = delete;
    DxfTable& operator=(const DxfTable&) = delete;

    void entry(std::string_view kind, std::string_view part, std::string_view name, std::string_view handle,
               int handleCode = 5)
    {
        m_dxf.pair(0, kind);
        m_dxf.pair(handleCode, handle);
        m_dxf.pair(330, m_handle);
        m_dxf.pair(100, "AcDbSymbolTableRecord");
        m_dxf.pair(100, part);
        m_dxf.pair(2, name);
    }

private:
    DxfText& m_dxf;
    std::string m_handle;
};

void writeLineTypes(DxfText& dxf)
{
    DxfTable table(dxf, "LTYPE", "5", 3);
    for (const auto& [name, handle] : {std::pair("ByBlock", "14"), {"ByLayer", "15"}, {"Continuous", "16"}}) {
        table.entry("LTYPE", "AcDbLinetypeTableRecord", name, handle);
        dxf.pair(70, "0");
        dxf.pair(3, "");
        dxf.pair(72, "65");
        dxf.pair(73, "0");
        dxf.pair(40, "0.0");
    }
}

void writeLayers(DxfText& dxf, const std::vector<std::string>& names)
{
    DxfTable table(dxf, "LAYER", "2", static_cast<int>(names.size()) + 1);
    const auto layer = [&](const std::string& name, const std::string& handle) {
        table.entry("LAYER", "AcDbLayerTableRecord", name, handle);
        dxf.pair(70, "0");
        dxf.pair(62, "7");
        dxf.pair(6, "Continuous");
        dxf.pair(390, "F");
    };
    layer("0", "10");
    for (const std::string& name : names)
        layer(name, dxf.handle());
}

void writeStyles(DxfText& dxf)
{
    {
        DxfTable table(dxf, "STYLE", "3", 1);
        table.entry("STYLE", "AcDbTextStyleTableRecord", "Standard", "11");
        dxf.pair(70, "0");
        dxf.pair(40, "0.0");
        dxf.pair(41, "1.0");
        dxf.pair(50, "0.0");
        dxf.pair(71, "0");
        dxf.pair(42, "2.5");
        dxf.pair(3, "txt");
        dxf.pair(4, "");
    }
    {
        const DxfTable table(dxf, "VIEW", "6", 0);
    }
    {
        const DxfTable table(dxf, "UCS", "7", 0);
    }
    {
        DxfTable table(dxf, "APPID", "9", 1);
        table.entry("APPID", "AcDbRegAppTableRecord", "ACAD", "12");
        dxf.pair(70, "0");
    }
    DxfTable table(dxf, "DIMSTYLE", "A", 1);
    dxf.pair(100, "AcDbDimStyleTable");
    table.entry("DIMSTYLE", "AcDbDimStyleTableRecord", "Standard", "27", 105);
    dxf.pair(70, "0");
}

void writeViewport(DxfText& dxf, const Vec2& size)
{
    DxfTable table(dxf, "VPORT", "8", 1);
    table.entry("VPORT", "AcDbViewportTableRecord", "*Active", "29");
    dxf.pair(70, "0");
    dxf.point(10, Vec2::Zero());
    dxf.point(11, {1, 1});
    dxf.point(12, size / 2);
    dxf.number(40, std::max(size.y(), 1.0));
    dxf.number(41, size.y() > 0 ? std::max(size.x() / size.y(), 0.1) : 1);
}

void writeSpaces(DxfText& dxf)
{
    DxfTable table(dxf, "BLOCK_RECORD", "1", 2);
    table.entry("BLOCK_RECORD", "AcDbBlockTableRecord", "*Model_Space", modelSpace);
    table.entry("BLOCK_RECORD", "AcDbBlockTableRecord", "*Paper_Space", paperSpace);
}

void writeBlock(DxfText& dxf, const char* name, const char* record, const char* begin, const char* end)
{
    dxf.pair(0, "BLOCK");
    dxf.pair(5, begin);
    dxf.pair(330, record);
    dxf.pair(100, "AcDbEntity");
    dxf.pair(8, "0");
    dxf.pair(100, "AcDbBlockBegin");
    dxf.pair(2, name);
    dxf.pair(70, "0");
    dxf.point(10, Vec2::Zero());
    dxf.pair(3, name);
    dxf.pair(1, "");
    dxf.pair(0, "ENDBLK");
    dxf.pair(5, end);
    dxf.pair(330, record);
    dxf.pair(100, "AcDbEntity");
    dxf.pair(8, "0");
    dxf.pair(100, "AcDbBlockEnd");
}

void writeHeader(DxfText& dxf, const Vec2& size)
{
    dxf.begin("HEADER");
    dxf.pair(9, "$ACADVER");
    dxf.pair(1, "AC1015");
    dxf.pair(9, "$HANDSEED");
    dxf.pair(5, lastHandle);
    dxf.pair(9, "$INSUNITS");
    dxf.pair(70, "4"); // millimetres
    dxf.pair(9, "$MEASUREMENT");
    dxf.pair(70, "1");
    dxf.pair(9, "$EXTMIN");
    dxf.point(10, Vec2::Zero());
    dxf.number(30, 0);
    dxf.pair(9, "$EXTMAX");
    dxf.point(10, size);
    dxf.number(30, 0);
    dxf.end();
}

} // namespace

void DxfText::pair(int code, std::string_view value)
{
    const std::string number = std::to_string(code);
    m_text.append(number.size() < 3 ? 3 - number.size() : 0, ' ').append(number).append("\r\n");
    m_text.append(value).append("\r\n");
}

void DxfText::number(int code, double value)
{
    pair(code, decimal(value, m_r2000 ? 8 : 4));
}

void DxfText::point(int code, const Vec2& at)
{
    number(code, at.x());
    number(code + 10, at.y());
}

void DxfText::begin(std::string_view section)
{
    pair(0, "SECTION");
    pair(2, section);
}

std::string DxfText::handle()
{
    char text[16];
    std::snprintf(text, sizeof text, "%X", ++m_handles);
    return text;
}

void DxfText::entity(std::string_view kind, std::string_view layer, std::string_view part)
{
    pair(0, kind);
    if (m_r2000) {
        pair(5, handle());
        pair(330, modelSpace);
        pair(100, "AcDbEntity");
    }
    pair(8, layer);
    if (m_r2000)
        pair(100, part);
}

void DxfText::line(std::string_view layer, const Vec2& from, const Vec2& to)
{
    entity("LINE", layer, "AcDbLine");
    point(10, from);
    point(11, to);
}

void DxfText::dot(std::string_view layer, const Vec2& at)
{
    entity("POINT", layer, "AcDbPoint");
    point(10, at);
}

void DxfText::circle(std::string_view layer, const Vec2& at, double radius)
{
    entity("CIRCLE", layer, "AcDbCircle");
    point(10, at);
    number(40, radius);
}

void DxfText::polyline(std::string_view layer, const std::vector<Vec2>& points, bool closed)
{
    if (m_r2000) {
        entity("LWPOLYLINE", layer, "AcDbPolyline");
        pair(90, std::to_string(points.size()));
        pair(70, closed ? "1" : "0");
        for (const Vec2& at : points)
            point(10, at);
        return;
    }
    entity("POLYLINE", layer);
    pair(66, "1");
    pair(70, closed ? "1" : "0");
    for (const Vec2& at : points) {
        entity("VERTEX", layer);
        point(10, at);
    }
    entity("SEQEND", layer);
}

void DxfText::text(std::string_view layer, const Vec2& at, double height, double degrees, std::string_view words)
{
    entity("TEXT", layer, "AcDbText");
    point(10, at);
    number(40, height);
    pair(1, ascii(words));
    if (degrees != 0)
        number(50, degrees);
    if (m_r2000)
        pair(100, "AcDbText");
}

void DxfText::curve(std::string_view layer, const BSpline2& curve)
{
    if (curve.degree() == 1) {
        polyline(layer, curve.points(), curve.closed());
        return;
    }
    std::vector<double> ends = curve.corners();
    if (!curve.closed()) {
        ends.insert(ends.begin(), curve.domainStart());
        ends.push_back(curve.domainEnd());
    } else {
        if (ends.empty())
            ends.push_back(curve.domainStart());
        ends.push_back(ends.front()); // a part that ends where it begins is the whole
    }
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        const BSpline2 part = curve.part(ends[k], ends[k + 1]);
        if (isStraight(part))
            line(layer, part.points().front(), part.points().back());
        else
            spline(layer, part);
    }
}

void DxfText::spline(std::string_view layer, const BSpline2& open)
{
    entity("SPLINE", layer, "AcDbSpline");
    pair(70, "8"); // planar
    pair(71, std::to_string(open.degree()));
    pair(72, std::to_string(open.knots().size()));
    pair(73, std::to_string(open.points().size()));
    pair(74, "0");
    for (const double knot : open.knots())
        number(40, knot - open.domainStart());
    for (const Vec2& at : open.points()) {
        point(10, at);
        number(30, 0);
    }
}

void beginR2000(DxfText& dxf, const DxfFrame& frame)
{
    writeHeader(dxf, frame.size);
    dxf.begin("CLASSES");
    dxf.end();
    dxf.begin("TABLES");
    writeViewport(dxf, frame.size);
    writeLineTypes(dxf);
    writeLayers(dxf, frame.layers);
    writeStyles(dxf);
    writeSpaces(dxf);
    dxf.end();
    dxf.begin("BLOCKS");
    writeBlock(dxf, "*Model_Space", modelSpace, "20", "21");
    writeBlock(dxf, "*Paper_Space", paperSpace, "1C", "1D");
    dxf.end();
    dxf.begin("ENTITIES");
}

void endR2000(DxfText& dxf)
{
    dxf.end();
    dxf.begin("OBJECTS");
    dxf.pair(0, "DICTIONARY");
    dxf.pair(5, rootDictionary);
    dxf.pair(330, "0");
    dxf.pair(100, "AcDbDictionary");
    dxf.pair(281, "1");
    dxf.pair(3, "ACAD_GROUP");
    dxf.pair(350, groups);
    dxf.pair(0, "DICTIONARY");
    dxf.pair(5, groups);
    dxf.pair(330, rootDictionary);
    dxf.pair(100, "AcDbDictionary");
    dxf.pair(281, "1");
    dxf.end();
}

} // namespace bolster
