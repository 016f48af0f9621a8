#include "CadDocument.h"
#include "PartMesh.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_TangentialDeflection.hxx>
#include <Poly_Triangulation.hxx>
#include <Quantity_Color.hxx>
#include <Standard_Failure.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <algorithm>
#include <cmath>

namespace bolster {
namespace {

constexpr int deepest = 200;
constexpr double largestAngle = 0.35;   // radians between neighbouring triangles of a face
constexpr double edgeDeflection = 0.02; // mm
constexpr double edgeAngle = 0.1;

std::string nameOf(const TDF_Label& label)
{
    Handle(TDataStd_Name) name;
    if (!label.FindAttribute(TDataStd_Name::GetID(), name))
        return {};
    const TCollection_ExtendedString& text = name->Get();
    std::string bytes(static_cast<std::size_t>(text.LengthOfCString()) + 1, '\0');
    Standard_PCharacter at = bytes.data();
    bytes.resize(static_cast<std::size_t>(std::max(0, text.ToUTF8CString(at))));
    return bytes;
}

std::uint32_t packed(const Quantity_Color& color)
{
    Standard_Real red = 0, green = 0, blue = 0;
    color.Values(red, green, blue, Quantity_TOC_sRGB);
    std::uint32_t all = 0;
    for (const double share : {red, green, blue})
        all = all << 8 | static_cast<std::uint32_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
    return all;
}

Assembly::Edge::Kind kindOf(GeomAbs_CurveType type)
{
    switch (type) {
    case GeomAbs_Line:
        return Assembly::Edge::Kind::Line;
    case GeomAbs_Circle:
        return Assembly::Edge::Kind::Circle;
    case GeomAbs_Ellipse:
        return Assembly::Edge::Kind::Ellipse;
    case GeomAbs_BezierCurve:
    case GeomAbs_BSplineCurve:
        return Assembly::Edge::Kind::Spline;
    default:
        return Assembly::Edge::Kind::Other;
    }
}

class CadParts {
public:
    CadParts(const CadDocument& document, const CadOrder& order, AssemblyWriter& writer)
        : m_shapes(XCAFDoc_DocumentTool::ShapeTool(document.document->Main()))
        , m_colors(XCAFDoc_DocumentTool::ColorTool(document.document->Main()))
        , m_order(order)
        , m_writer(writer)
        , m_perUnit(1 / document.said.millimetresPerUnit.value_or(1))
        , m_facesWritten(document.faces)
    {}

    void write()
    {
        TDF_LabelSequence free;
        m_shapes->GetFreeShapes(free);
        for (int i = 1; i <= free.Length(); ++i)
            countShapes(free(i), 0);
        for (int i = 1; i <= free.Length(); ++i)
            addLabel(free(i), {}, {}, {}, 0);
        if (const std::uint64_t there = facesThere(); there < m_facesWritten)
            m_notMeshed += m_facesWritten - there;
        if (m_tooDeep > 0)
            m_writer.warn(AssemblyOddity::TooDeep, m_tooDeep);
        if (m_notMeshed > 0)
            m_writer.warn(AssemblyOddity::NotMeshed, m_notMeshed);
        if (m_notFinite > 0)
            m_writer.warn(AssemblyOddity::NotFinite, m_notFinite);
    }

private:
    using Parent = std::optional<std::uint32_t>;
    using Color = std::optional<std::uint32_t>;

    Color colorOf(const TDF_Label& label) const
    {
        Quantity_Color color;
        for (const XCAFDoc_ColorType type : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen})
            if (m_colors->GetColor(label, type, color))
                return packed(color);
        return {};
    }

    /// Of its first body or face that has one.
    Color colorOf(const TopoDS_Shape& shape) const
    {
        Quantity_Color color;
        for (const TopAbs_ShapeEnum kind : {TopAbs_SOLID, TopAbs_SHELL, TopAbs_FACE})
            for (TopExp_Explorer part(shape, kind); part.More(); part.Next())
                for (const XCAFDoc_ColorType type : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen})
                    if (m_colors->GetColor(part.Current(), type, color))
                        return packed(color);
        return {};
    }

    /// Of all products, each once, however often it is there.
    std::uint64_t facesThere() const
    {
        TDF_LabelSequence products;
        m_shapes->GetShapes(products);
        TopTools_IndexedMapOfShape faces;
        for (int i = 1; i <= products.Length(); ++i)
            if (!XCAFDoc_ShapeTool::IsAssembly(products(i)))
                TopExp::MapShapes(XCAFDoc_ShapeTool::GetShape(products(i)), TopAbs_FACE, faces);
        return static_cast<std::uint64_t>(faces.Extent());
    }

    /// For the progress alone: an assembly that is in itself again and again is not followed for ever.
    void countShapes(const TDF_Label& label, int depth)
    {
        TDF_Label product = label;
        if (depth > deepest || m_shapeCount >= mostAssemblyParts)
            return;
        if (XCAFDoc_ShapeTool::IsReference(label))
            XCAFDoc_ShapeTool::GetReferredShape(label, product);
        ++m_shapeCount;
        TDF_LabelSequence components;
        XCAFDoc_ShapeTool::GetComponents(product, components);
        for (int i = 1; i <= components.Length(); ++i)
            countShapes(components(i), depth + 1);
    }

    void addLabel(const TDF_Label& label, const TopLoc_Location& above, Parent parent, Color inherited, int depth)
    {
        if (depth > deepest) {
            ++m_tooDeep;
            return;
        }
        TDF_Label product = label;
        TopLoc_Location here = above;
        if (XCAFDoc_ShapeTool::IsReference(label) && XCAFDoc_ShapeTool::GetReferredShape(label, product))
            here = above * XCAFDoc_ShapeTool::GetLocation(label);
        m_writer.progress(0.5 + 0.5 * static_cast<double>(++m_shapesDone) / static_cast<double>(m_shapeCount + 1));
        const std::string ofProduct = nameOf(product);
        const std::string name = ofProduct.empty() ? nameOf(label) : ofProduct;
        Color color = colorOf(label);
        if (!color)
            color = colorOf(product);
        if (!color)
            color = inherited;
        if (XCAFDoc_ShapeTool::IsAssembly(product)) {
            const std::uint32_t part = m_writer.addPart(name, parent, color);
            TDF_LabelSequence components;
            XCAFDoc_ShapeTool::GetComponents(product, components);
            for (int i = 1; i <= components.Length(); ++i)
                addLabel(components(i), here, part, color, depth + 1);
            return;
        }
        const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(product);
        if (shape.IsNull())
            return;
        addShape(m_writer.addPart(name, parent, color ? color : colorOf(shape)), name, shape, here);
    }

    void addShape(std::uint32_t part, const std::string& name, const TopoDS_Shape& shape,
                  const TopLoc_Location& where)
    {
        // The triangles stay with the shape, so a part that is there often is meshed once.
        const BRepMesh_IncrementalMesh mesher(shape, m_order.tolerance, false, largestAngle, false);
        PartMesh mesh;
        for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
            addFace(mesh, name, TopoDS::Face(face.Current()), where);
        m_notFinite += mesh.leftOut();
        mesh.send(m_writer, part);
        if (m_order.edges)
            addEdges(part, shape, where);
    }

    Vec3 inFile(const gp_Pnt& point) const { return m_perUnit * Vec3(point.X(), point.Y(), point.Z()); }

    void addFace(PartMesh& mesh, const std::string& name, const TopoDS_Face& face, const TopLoc_Location& where)
    {
        TopLoc_Location ofFace;
        const Handle(Poly_Triangulation)& triangles = BRep_Tool::Triangulation(face, ofFace);
        if (triangles.IsNull()) {
            ++m_notMeshed;
            return;
        }
        const gp_Trsf place = (where * ofFace).Transformation();
        m_points.clear();
        for (int i = 1; i <= triangles->NbNodes(); ++i)
            m_points.push_back(mesh.addPoint(inFile(triangles->Node(i).Transformed(place)), name));
        const bool mirrored = place.VectorialPart().Determinant() < 0;
        const bool turned = (face.Orientation() == TopAbs_REVERSED) != mirrored;
        for (int i = 1; i <= triangles->NbTriangles(); ++i) {
            int a = 0, b = 0, c = 0;
            triangles->Triangle(i).Get(a, b, c);
            if (turned)
                std::swap(b, c);
            const auto point = [&](int node) { return m_points.at(static_cast<std::size_t>(node - 1)); };
            const std::int64_t corners[] = {point(a), point(b), point(c)};
            mesh.addFace(corners);
        }
    }

    void addEdges(std::uint32_t part, const TopoDS_Shape& shape, const TopLoc_Location& where)
    {
        TopTools_IndexedMapOfShape edges;
        TopExp::MapShapes(shape, TopAbs_EDGE, edges);
        const gp_Trsf place = where.Transformation();
        for (int i = 1; i <= edges.Extent(); ++i) {
            const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
            if (BRep_Tool::Degenerated(edge))
                continue;
            try {
                const BRepAdaptor_Curve curve(edge);
                GCPnts_TangentialDeflection along(curve, edgeAngle, edgeDeflection);
                std::vector<Vec3> points;
                for (int at = 1; at <= along.NbPoints(); ++at)
                    points.push_back(inFile(along.Value(at).Transformed(place)));
                if (TopExp::FirstVertex(edge).IsSame(TopExp::LastVertex(edge)) && points.size() > 2)
                    points.back() = points.front(); // but for rounding they are the same
                if (std::ranges::all_of(points, [](const Vec3& point) { return point.allFinite(); }))
                    m_writer.addEdge(part, kindOf(curve.GetType()), points);
            } catch (const Standard_Failure&) { // an edge without a curve is no help to anybody
            }
        }
    }

    Handle(XCAFDoc_ShapeTool) m_shapes;
    Handle(XCAFDoc_ColorTool) m_colors;
    const CadOrder& m_order;
    AssemblyWriter& m_writer;
    double m_perUnit;
    std::uint64_t m_facesWritten;
    std::vector<std::int64_t> m_points; // scratch
    std::size_t m_shapeCount = 0;
    std::size_t m_shapesDone = 0;
    std::uint64_t m_tooDeep = 0;
    std::uint64_t m_notMeshed = 0;
    std::uint64_t m_notFinite = 0;
};

} // namespace

void writeCadParts(const CadDocument& document, const CadOrder& order, AssemblyWriter& writer)
{
    CadParts(document, order, writer).write();
}

} // namespace bolster
