#include "Scenes.h"

#include "PatchEdits.h"
#include "PreparedSheet.h"
#include "RestingSolve.h"

#include <array>
#include <cmath>
#include <random>
#include <stdexcept>

namespace bolster::bench {

namespace {

template <class T>
ElementId addTo(Design& design, T element)
{
    const ElementId id = design.nextId();
    design = design.with({{}, {{id, nullptr, makeElement(std::move(element))}}});
    return id;
}

class Builder {
public:
    explicit Builder(double edgeLength)
    {
        m_design = m_design.with({{}, {{settingsId, nullptr, makeElement(Settings{edgeLength})}}});
        m_fabric = add(Fabric{.name = "Leather"});
    }

    template <class T>
    ElementId add(T element)
    {
        return addTo(m_design, std::move(element));
    }
    ElementId patch(std::string name, std::vector<Vec2> outline, double pressure = 0)
    {
        return add(Patch{.name = std::move(name),
                         .fabric = m_fabric,
                         .pressure = pressure,
                         .outline = BSpline2(1, true, std::move(outline))});
    }
    void sew(Stretch a, Stretch b, Continuity continuity = Continuity::C0)
    {
        add(Seam{.a = a, .b = b, .continuity = continuity});
    }
    void fix(Stretch stretch, std::vector<Vec3> polygon)
    {
        const ElementId curve = add(FixationCurve{"Rail", BSpline3(1, false, std::move(polygon))});
        FixationSeam fixation;
        fixation.stretch = stretch;
        fixation.curve = curve;
        add(std::move(fixation));
    }
    const Design& design() const { return m_design; }

private:
    Design m_design;
    ElementId m_fabric{};
};

/// The design with the edge length at which it has so many vertices; `area` is that of its patches, mm^2.
template <class Make>
Design ofSize(int vertices, double area, const Make& make)
{
    const double within = vertices < 3000 ? 0.1 : 0.01;           // coarse meshes do not come in all sizes
    double edge = std::sqrt(area / (vertices * std::sqrt(0.75))); // all triangles equilateral
    for (int round = 0; round < 20; ++round) {
        const Design design = make(edge);
        TriangulationCache cache;
        const double count = prepareSheet(design, cache)->mesh.unknownCount();
        if (std::abs(count / vertices - 1) < within)
            return design;
        edge *= std::pow(count / vertices, 0.4); // a little less than the root, or it may jump to and fro
    }
    throw std::runtime_error("a benchmark's mesh of " + std::to_string(vertices) + " vertices could not be made");
}

constexpr double clamp = 20; // mm: so much of both ends is held on three sides, which holds its direction, too
constexpr double bend = EIGEN_PI / 6;

Design bentStripWithEdges(double edgeLength, double length, double width)
{
    Builder b(edgeLength);
    const ElementId strip = b.patch("Strip", {{0, 0},
                                              {clamp, 0},
                                              {length - clamp, 0},
                                              {length, 0},
                                              {length, width},
                                              {length - clamp, width},
                                              {clamp, width},
                                              {0, width}});
    b.fix({strip, 6, 1}, {{clamp, width, 0}, {0, width, 0}, {0, 0, 0}, {clamp, 0, 0}});
    const double radius = (length - 2 * clamp) / bend;
    const Vec3 moved(clamp + radius * std::sin(bend), 0, radius * (1 - std::cos(bend)));
    const Vec3 out = clamp * Vec3(std::cos(bend), 0, std::sin(bend)), across = width * Vec3::UnitY();
    b.fix({strip, 2, 5}, {moved, moved + out, moved + out + across, moved + across});
    return b.design();
}

// The seat, mm.
constexpr double seatWidth = 520;
constexpr double seatDepth = 500;
constexpr double seatHeight = 120;
constexpr double bolsterWidth = 110;
constexpr double pressure = 0.1;
const char* const insertName = "Insert";

std::vector<Vec2> rectangle(double w, double h)
{
    return {{0, 0}, {w, 0}, {w, h}, {0, h}};
}

/// A panel at the front or the back: its upper edge is divided like the top.
std::vector<Vec2> crossPanel()
{
    constexpr double w = seatWidth, h = seatHeight, b = bolsterWidth;
    return {{0, 0}, {w, 0}, {w, h}, {w - b, h}, {b, h}, {0, h}};
}

Design seatWithEdges(double edgeLength, Continuity topSeams)
{
    Builder b(edgeLength);
    const ElementId left = b.patch("Left bolster", rectangle(bolsterWidth, seatDepth), pressure);
    const ElementId insert = b.patch(insertName, rectangle(seatWidth - 2 * bolsterWidth, seatDepth), pressure);
    const ElementId right = b.patch("Right bolster", rectangle(bolsterWidth, seatDepth), pressure);
    const ElementId front = b.patch("Front", crossPanel(), pressure);
    const ElementId rightSide = b.patch("Right side", rectangle(seatDepth, seatHeight), pressure);
    const ElementId back = b.patch("Back", crossPanel(), pressure);
    const ElementId leftSide = b.patch("Left side", rectangle(seatDepth, seatHeight), pressure);

    b.sew({left, 1, 2}, {insert, 3, 4}, topSeams);
    b.sew({right, 3, 4}, {insert, 1, 2}, topSeams);
    b.sew({left, 0, 1}, {front, 4, 5});
    b.sew({insert, 0, 1}, {front, 3, 4});
    b.sew({right, 0, 1}, {front, 2, 3});
    b.sew({left, 2, 3}, {back, 2, 3});
    b.sew({insert, 2, 3}, {back, 3, 4});
    b.sew({right, 2, 3}, {back, 4, 5});
    b.sew({left, 3, 4}, {leftSide, 2, 3});
    b.sew({right, 1, 2}, {rightSide, 2, 3});
    b.sew({front, 1, 2}, {rightSide, 3, 4});
    b.sew({rightSide, 1, 2}, {back, 5, 6});
    b.sew({back, 1, 2}, {leftSide, 3, 4});
    b.sew({leftSide, 1, 2}, {front, 5, 6});

    const std::array<Vec3, 4> corners = {
        Vec3(0, 0, 0), {seatWidth, 0, 0}, {seatWidth, seatDepth, 0}, {0, seatDepth, 0}};
    const std::array panels = {front, rightSide, back, leftSide};
    for (std::size_t k = 0; k < 4; ++k)
        b.fix({panels[k], 0, 1}, {corners[k], corners[(k + 1) % 4]});
    return b.design();
}

template <class T>
T named(const char* name)
{
    T element;
    element.name = name;
    if constexpr (requires { element.file; })
        element.file = "in memory";
    return element;
}

TriangleMesh boxMesh(const Box3& box)
{
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.points.push_back(box.corner(static_cast<Box3::CornerType>(corner)));
    for (const auto& [a, b, c, d] : {std::array{0U, 2U, 3U, 1U},
                                     {4U, 5U, 7U, 6U},
                                     {0U, 1U, 5U, 4U},
                                     {2U, 6U, 7U, 3U},
                                     {0U, 4U, 6U, 2U},
                                     {1U, 3U, 7U, 5U}}) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    }
    mesh.parts = {{"Box", 0, 12}};
    return mesh;
}

} // namespace

Design bentStrip(int vertices, double length, double width)
{
    return ofSize(vertices, length * width, [&](double edge) { return bentStripWithEdges(edge, length, width); });
}

Eigen::Matrix3Xd flatPlaces(const SewnMesh& mesh)
{
    Eigen::Matrix3Xd places = Eigen::Matrix3Xd::Zero(3, mesh.unknownCount());
    for (int v = 0; v < mesh.vertexCount(); ++v)
        places.col(mesh.topology->unknown[v]).head<2>() = mesh.rest()[v];
    return places;
}

HeldSurface heldSurface(const SewnMesh& mesh)
{
    HeldSurface surface;
    const auto& unknown = mesh.topology->unknown;
    surface.rest = flatPlaces(mesh);
    for (const auto& [a, b, c] : mesh.topology->triangles)
        surface.triangles.push_back(
            {static_cast<int>(unknown[a]), static_cast<int>(unknown[b]), static_cast<int>(unknown[c])});
    for (int u = mesh.freeCount; u < mesh.unknownCount(); ++u)
        surface.held.push_back(u);
    surface.targets = mesh.targets;
    surface.diameter = mesh.diameter.front();
    return surface;
}

Design seat(int vertices, Continuity topSeams)
{
    const double area = seatWidth * seatDepth + 2 * (seatWidth + seatDepth) * seatHeight;
    return ofSize(vertices, area, [&](double edge) { return seatWithEdges(edge, topSeams); });
}

SolveInput cushionedSeat(int vertices, Continuity topSeams)
{
    SolveInput input(seat(vertices, topSeams));
    const ElementId frame = addTo(input.design, named<Frame>("Box"));
    constexpr double padding = 30;
    const Vec3 inset(padding, padding, 0);
    input.files.meshes[frame] = std::make_shared<const TriangleMesh>(
        boxMesh({inset - 20 * Vec3::UnitZ(), Vec3(seatWidth, seatDepth, seatHeight - padding / 2) - inset}));
    Cushion cushion = named<Cushion>("Foam");
    cushion.frame = frame;
    cushion.dilation = padding;
    addTo(input.design, std::move(cushion));
    return input;
}

SolveInput scannedSeat(int vertices, int points)
{
    SolveInput input(seat(vertices));
    const SurfaceMeshPtr cover = solveResting(input, {}).surface;
    if (!cover)
        throw std::runtime_error("a benchmark failed: its seat could not be solved");
    PointCloud cloud;
    std::mt19937 random(1);
    const auto share = [&] { return std::generate_canonical<double, 32>(random); };
    const auto& triangles = cover->topology->triangles;
    for (int k = 0; k < points; ++k) { // the triangles are of like size
        const auto& [a, b, c] =
            triangles[static_cast<std::size_t>(share() * static_cast<double>(triangles.size()))];
        const double root = std::sqrt(share()), along = share();
        const Vec3 place = (1 - root) * cover->positions[a] + root * (1 - along) * cover->positions[b] +
                           root * along * cover->positions[c];
        const Vec3 normal = cover->normals[a].cast<double>();
        cloud.points.push_back(place + (2 + share() - 0.5) * normal);
    }
    const ElementId scan = addTo(input.design, named<Scan>("Scan"));
    input.files.clouds[scan] = std::make_shared<const PointCloud>(std::move(cloud));
    return input;
}

Design withLongerInsert(const Design& seat, double share)
{
    ElementId insert{};
    seat.each<Patch>([&](ElementId id, const Patch& patch) {
        if (patch.name == insertName)
            insert = id;
    });
    return seat.with(edits::movePatchPoints(seat, insert, std::array{2, 3}, Vec2(0, share * seatDepth)));
}

} // namespace bolster::bench
