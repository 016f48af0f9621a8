#include "SimplifyMesh.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace bolster {
namespace {

constexpr auto notTaken = std::numeric_limits<std::uint32_t>::max();
constexpr float anyError = 1e10F; // in sizes of the part: the number of triangles decides

class Simplifying {
public:
    explicit Simplifying(const TriangleMesh& mesh)
        : m_mesh(mesh)
        , m_inPart(mesh.points.size(), notTaken)
        , m_taken(mesh.points.size(), notTaken)
    {}

    void add(const TriangleMesh::Part& part, std::size_t triangles, bool lockBorders)
    {
        const std::vector<std::uint32_t> corners = takeCorners(part);
        const std::vector<float> places = nearOrigin();
        std::vector<std::uint32_t> kept(corners.size());
        float off = 0;
        const std::size_t count = meshopt_simplify(kept.data(), corners.data(), corners.size(), places.data(),
                                                   m_points.size(), 3 * sizeof(float), 3 * triangles, anyError,
                                                   lockBorders ? unsigned(meshopt_SimplifyLockBorder) : 0U, &off);
        if (count > 0) {
            const float size = meshopt_simplifyScale(places.data(), m_points.size(), 3 * sizeof(float));
            m_result.off = std::max(m_result.off, static_cast<double>(off) * static_cast<double>(size));
            append(part.name, std::span(kept).first(count));
        }
        for (const std::uint32_t point : m_points)
            m_inPart[point] = notTaken;
        m_points.clear();
    }

    SimplifiedMesh take() { return std::move(m_result); }

private:
    /// By the numbers of its points within the part.
    std::vector<std::uint32_t> takeCorners(const TriangleMesh::Part& part)
    {
        std::vector<std::uint32_t> corners;
        corners.reserve(3 * std::size_t{part.triangleCount});
        for (std::uint32_t i = 0; i < part.triangleCount; ++i)
            for (const std::uint32_t point : m_mesh.triangles[part.firstTriangle + i]) {
                if (m_inPart[point] == notTaken) {
                    m_inPart[point] = static_cast<std::uint32_t>(m_points.size());
                    m_points.push_back(point);
                }
                corners.push_back(m_inPart[point]);
            }
        return corners;
    }

    /// Single precision is fine enough there.
    std::vector<float> nearOrigin() const
    {
        Box3 box;
        for (const std::uint32_t point : m_points)
            box.extend(m_mesh.points[point]);
        const Vec3 middle = box.isEmpty() ? Vec3::Zero().eval() : box.center().eval();
        std::vector<float> places;
        places.reserve(3 * m_points.size());
        for (const std::uint32_t point : m_points)
            for (const double coordinate : Vec3(m_mesh.points[point] - middle))
                places.push_back(static_cast<float>(coordinate));
        return places;
    }

    void append(const std::string& name, std::span<const std::uint32_t> corners)
    {
        TriangleMesh& mesh = m_result.mesh;
        mesh.parts.push_back({name, static_cast<std::uint32_t>(mesh.triangles.size()),
                              static_cast<std::uint32_t>(corners.size() / 3)});
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
            std::array<std::uint32_t, 3>& triangle = mesh.triangles.emplace_back();
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const std::uint32_t point = m_points[corners[i + corner]];
                if (m_taken[point] == notTaken) {
                    m_taken[point] = static_cast<std::uint32_t>(mesh.points.size());
                    mesh.points.push_back(m_mesh.points[point]);
                }
                triangle[corner] = m_taken[point];
            }
        }
    }

    const TriangleMesh& m_mesh;
    SimplifiedMesh m_result;
    std::vector<std::uint32_t> m_points; // of the part
    std::vector<std::uint32_t> m_inPart; // of each point its number there
    std::vector<std::uint32_t> m_taken;  // and in the result
};

} // namespace

SimplifiedMesh simplified(const TriangleMesh& mesh, const std::vector<bool>& wanted, std::size_t triangles,
                          const std::stop_token& stop)
{
    std::size_t all = 0;
    const auto isWanted = [&](std::size_t part) { return wanted.empty() || wanted[part]; };
    for (std::size_t i = 0; i < mesh.parts.size(); ++i)
        all += isWanted(i) ? mesh.parts[i].triangleCount : 0;
    const double share = all > 0 ? static_cast<double>(triangles) / static_cast<double>(all) : 1;
    Simplifying result(mesh);
    for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
        if (stop.stop_requested())
            return {};
        if (isWanted(i))
            result.add(mesh.parts[i], static_cast<std::size_t>(std::ceil(share * mesh.parts[i].triangleCount)),
                       mesh.parts.size() > 1);
    }
    return result.take();
}

} // namespace bolster
