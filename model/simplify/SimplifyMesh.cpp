#include "SimplifyMesh.h"

#include "Leavings.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace bolster {
namespace {

constexpr auto notTaken = std::numeric_limits<std::uint32_t>::max();
constexpr float anyError = 1e10F; // in sizes of the part: the number of triangles decides

/// More triangles than these are simplified piece by piece, which takes less memory.
constexpr std::size_t mostAtOnce = 1'500'000;
/// Of so many times as many triangles as are wanted a second pass over all pieces removes what the first one has to
/// leave at their borders.
constexpr std::size_t leftForSecondPass = 4;

class Simplifying {
public:
    Simplifying(const TriangleMesh& mesh, std::stop_token stop)
        : m_mesh(mesh)
        , m_stop(std::move(stop))
        , m_local(mesh.points.size(), notTaken)
        , m_taken(mesh.points.size(), notTaken)
    {}

    void add(const TriangleMesh::Part& part, std::size_t triangles, bool lockBorders)
    {
        const std::size_t count = part.triangleCount;
        if (triangles >= count) {
            append(part.name, cornersOf(numbersOf(part)));
        } else if (count <= mostAtOnce) {
            append(part.name, fewer(cornersOf(numbersOf(part)), triangles, lockBorders));
        } else if (leftForSecondPass * triangles > mostAtOnce) {
            append(part.name, inPieces(part, triangles));
        } else {
            const Corners thinned = inPieces(part, leftForSecondPass * triangles);
            append(part.name, fewer(thinned, triangles, lockBorders));
        }
    }

    SimplifiedMesh take() { return std::move(m_result); }

private:
    static std::vector<std::uint32_t> numbersOf(const TriangleMesh::Part& part)
    {
        std::vector<std::uint32_t> numbers(part.triangleCount);
        std::iota(numbers.begin(), numbers.end(), part.firstTriangle);
        return numbers;
    }

    Corners cornersOf(std::span<const std::uint32_t> triangles) const
    {
        Corners corners;
        corners.reserve(3 * triangles.size());
        for (const std::uint32_t triangle : triangles)
            corners.insert(corners.end(), m_mesh.triangles[triangle].begin(), m_mesh.triangles[triangle].end());
        return corners;
    }

    /// Side by side along the longest axis of the part; the borders between pieces stay as they are.
    Corners inPieces(const TriangleMesh::Part& part, std::size_t triangles)
    {
        Box3 box;
        const std::vector<std::uint32_t> numbers = numbersOf(part);
        for (const std::uint32_t triangle : numbers)
            box.extend(m_mesh.points[m_mesh.triangles[triangle][0]]);
        Eigen::Index axis = 0;
        box.sizes().maxCoeff(&axis);
        std::vector<std::pair<float, std::uint32_t>> order; // by place; of equal ones as they are in the mesh
        order.reserve(numbers.size());
        for (const std::uint32_t triangle : numbers)
            order.emplace_back(static_cast<float>(m_mesh.points[m_mesh.triangles[triangle][0]][axis]), triangle);
        std::ranges::sort(order);
        const std::size_t pieces = (order.size() + mostAtOnce - 1) / mostAtOnce;
        Corners all;
        for (std::size_t piece = 0; piece < pieces && !m_stop.stop_requested(); ++piece) {
            const std::size_t from = order.size() * piece / pieces, to = order.size() * (piece + 1) / pieces;
            std::vector<std::uint32_t> own;
            for (std::size_t i = from; i < to; ++i)
                own.push_back(order[i].second);
            const Corners left = fewer(cornersOf(own), triangles / pieces, true);
            all.insert(all.end(), left.begin(), left.end());
        }
        return all;
    }

    Corners fewer(Corners corners, std::size_t triangles, bool lockBorders)
    {
        takeLocal(corners);
        const std::vector<float> places = nearOrigin();
        Corners kept(corners.size());
        float off = 0;
        kept.resize(meshopt_simplify(kept.data(), corners.data(), corners.size(), places.data(), m_points.size(),
                                     3 * sizeof(float), 3 * triangles, anyError,
                                     lockBorders ? unsigned(meshopt_SimplifyLockBorder) : 0U, &off));
        if (!kept.empty()) {
            const float size = meshopt_simplifyScale(places.data(), m_points.size(), 3 * sizeof(float));
            m_result.off = std::max(m_result.off, static_cast<double>(off) * static_cast<double>(size));
        }
        for (std::uint32_t& corner : kept)
            corner = m_points[corner];
        for (const std::uint32_t point : m_points)
            m_local[point] = notTaken;
        m_points.clear();
        return withoutLeavings(std::move(kept));
    }

    /// By the numbers of the points among those that are used.
    void takeLocal(Corners& corners)
    {
        for (std::uint32_t& corner : corners) {
            if (m_local[corner] == notTaken) {
                m_local[corner] = static_cast<std::uint32_t>(m_points.size());
                m_points.push_back(corner);
            }
            corner = m_local[corner];
        }
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

    void append(const std::string& name, const Corners& corners)
    {
        if (corners.empty())
            return;
        TriangleMesh& mesh = m_result.mesh;
        mesh.parts.push_back({name, static_cast<std::uint32_t>(mesh.triangles.size()),
                              static_cast<std::uint32_t>(corners.size() / 3)});
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
            std::array<std::uint32_t, 3>& triangle = mesh.triangles.emplace_back();
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const std::uint32_t point = corners[i + corner];
                if (m_taken[point] == notTaken) {
                    m_taken[point] = static_cast<std::uint32_t>(mesh.points.size());
                    mesh.points.push_back(m_mesh.points[point]);
                }
                triangle[corner] = m_taken[point];
            }
        }
    }

    const TriangleMesh& m_mesh;
    std::stop_token m_stop;
    SimplifiedMesh m_result;
    std::vector<std::uint32_t> m_points; // that are worked on
    std::vector<std::uint32_t> m_local;  // of each point its number among these
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
    Simplifying result(mesh, stop);
    for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
        if (stop.stop_requested())
            return {};
        if (isWanted(i))
            result.add(mesh.parts[i], static_cast<std::size_t>(std::ceil(share * mesh.parts[i].triangleCount)),
                       mesh.parts.size() > 1);
    }
    return stop.stop_requested() ? SimplifiedMesh() : result.take();
}

} // namespace bolster
