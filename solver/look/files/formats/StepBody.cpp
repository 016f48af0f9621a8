#include "StepBody.h"

#include "Shells.h"
#include "StepWriter.h"

#include <algorithm>
#include <array>
#include <vector>

namespace bolster {

namespace {

/// The smallest body whose box holds that of the void; `shells.size()` where there is none.
std::size_t bodyAround(const std::vector<Shell>& shells, const Shell& hole)
{
    std::size_t best = shells.size();
    for (std::size_t i = 0; i < shells.size(); ++i)
        if (!shells[i].isVoid() && shells[i].box.contains(hole.box) &&
            (best == shells.size() || shells[i].volume < shells[best].volume))
            best = i;
    return best;
}

class BodyWriter {
public:
    explicit BodyWriter(const TriangleMesh& solid)
        : m_solid(solid)
        , m_points(solid.points.size(), 0)
    {}

    /// Of a void the triangles are turned around: as if it were a body.
    int addShell(const Shell& shell)
    {
        std::vector<int> faces;
        for (const std::uint32_t triangle : shell.triangles) {
            std::array<std::uint32_t, 3> corners = m_solid.triangles[triangle];
            if (shell.isVoid())
                std::swap(corners[1], corners[2]);
            faces.push_back(addFace(corners));
        }
        return m_writer.add("CLOSED_SHELL(''," + StepWriter::list(faces, StepWriter::ref) + ")");
    }

    /// With voids it is no FACETED_BREP: one that is both OpenCASCADE 7.6 reads without its voids.
    int addBody(int shell, const std::vector<int>& voids)
    {
        if (voids.empty())
            return m_writer.add("FACETED_BREP(''," + StepWriter::ref(shell) + ")");
        std::vector<int> oriented;
        for (const int each : voids)
            oriented.push_back(m_writer.add("ORIENTED_CLOSED_SHELL('',*," + StepWriter::ref(each) + ",.F.)"));
        m_faceted = false;
        return m_writer.add("BREP_WITH_VOIDS(''," + StepWriter::ref(shell) + "," +
                            StepWriter::list(oriented, StepWriter::ref) + ")");
    }

    std::string file(const std::string& product, std::vector<int> bodies)
    {
        const int context = m_writer.addContext();
        bodies.insert(bodies.begin(), m_writer.addAxes());
        const std::string kind = m_faceted ? "FACETED_BREP_SHAPE_REPRESENTATION" : "SHAPE_REPRESENTATION";
        m_writer.addProduct(product, m_writer.add(kind + "(''," + StepWriter::list(bodies, StepWriter::ref) + "," +
                                                  StepWriter::ref(context) + ")"));
        return m_writer.file("a body", product);
    }

private:
    int addFace(const std::array<std::uint32_t, 3>& corners)
    {
        const auto place = [&](std::size_t k) -> const Vec3& { return m_solid.points[corners[k]]; };
        Vec3 normal = (place(1) - place(0)).cross(place(2) - place(0));
        normal = normal.norm() > 0 ? normal.normalized().eval() : Vec3::UnitZ().eval();
        std::array<int, 3> points{};
        std::ranges::transform(corners, points.begin(), [this](std::uint32_t corner) { return point(corner); });
        const int loop = m_writer.add("POLY_LOOP(''," + StepWriter::list(points, StepWriter::ref) + ")");
        const int bound = m_writer.add("FACE_OUTER_BOUND(''," + StepWriter::ref(loop) + ",.T.)");
        const int direction = m_writer.add("DIRECTION(''," + StepWriter::list(normal, StepWriter::real) + ")");
        const int axes = m_writer.add("AXIS2_PLACEMENT_3D(''," + StepWriter::ref(points[0]) + "," +
                                      StepWriter::ref(direction) + ",$)");
        const int plane = m_writer.add("PLANE(''," + StepWriter::ref(axes) + ")");
        return m_writer.add("FACE_SURFACE('',(" + StepWriter::ref(bound) + ")," + StepWriter::ref(plane) + ",.T.)");
    }

    int point(std::uint32_t number)
    {
        if (m_points[number] == 0)
            m_points[number] = m_writer.addPoint(m_solid.points[number]);
        return m_points[number];
    }

    const TriangleMesh& m_solid;
    StepWriter m_writer;
    std::vector<int> m_points; ///< 0: not written yet
    bool m_faceted = true;     ///< all bodies
};

} // namespace

std::string stepBody(const std::string& product, const TriangleMesh& solid)
{
    const std::vector<Shell> shells = shellsOf(solid);
    BodyWriter writer(solid);
    std::vector<int> written;
    std::vector<std::vector<int>> voids(shells.size() + 1);
    for (const Shell& shell : shells) {
        written.push_back(writer.addShell(shell));
        if (shell.isVoid())
            voids[bodyAround(shells, shell)].push_back(written.back());
    }
    std::vector<int> bodies;
    for (std::size_t i = 0; i < shells.size(); ++i)
        if (!shells[i].isVoid())
            bodies.push_back(writer.addBody(written[i], voids[i]));
    return writer.file(product, std::move(bodies));
}

} // namespace bolster
