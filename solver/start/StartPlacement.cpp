#include "StartPlacement.h"

#include "Rims.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <queue>
#include <utility>

namespace bolster {

namespace {

/// Fixations that lie this nearly on one line do not say how the patch turns about it.
constexpr double lineThreshold = 0.02;
/// Degrees by which a rim turns more than the outline on it: a wall that goes around, which no rigid patch is like.
constexpr double goesAround = 30;
constexpr std::size_t enoughFeet = 300; // of a wall on a rim

struct Rigid {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Vec3 shift = Vec3::Zero();

    Vec3 operator()(const Vec2& p) const { return rotation.leftCols<2>() * p + shift; }
};

struct Correspondence {
    Vec2 rest;
    Vec3 place;
    int vertex;
};

class Placer {
public:
    explicit Placer(const SewnMesh& mesh)
        : m_mesh(mesh)
        , m_isPlaced(mesh.parts.size())
        , m_held(mesh.parts.size())
        , m_rims(rimsOf(mesh))
    {
        m_places.setZero(3, mesh.vertexCount());
        m_frames.setZero(4, mesh.vertexCount());
        collectHeld();
        linkVertices();
    }

    SheetState run()
    {
        sortByArea();
        for (std::size_t p = 0; p < m_mesh.parts.size(); ++p)
            if (!m_held[p].empty())
                place(static_cast<int>(p), m_held[p]);
        while (placeNextThroughSeams() || placeFirstOfFreeComponent())
            continue;
        return assemble();
    }

private:
    void collectHeld()
    {
        for (std::size_t p = 0; p < m_mesh.parts.size(); ++p) {
            const SewnMesh::Part& part = m_mesh.parts[p];
            for (int v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v)
                if (isHeld(m_mesh, v))
                    m_held[p].push_back({m_mesh.rest()[v], heldAt(m_mesh, v), v});
        }
    }

    /// The vertices that share an unknown, for walking from patch to patch.
    void linkVertices()
    {
        m_sharing.resize(m_mesh.unknownCount());
        m_partOf.resize(m_mesh.vertexCount());
        m_ofComponent.resize(m_mesh.diameter.size());
        m_isSewn.assign(m_mesh.vertexCount(), 0);
        m_sewnCount.assign(m_mesh.parts.size(), 0);
        for (std::size_t p = 0; p < m_mesh.parts.size(); ++p) {
            const SewnMesh::Part& part = m_mesh.parts[p];
            m_ofComponent[part.component].push_back(static_cast<int>(p));
            for (int v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v) {
                m_partOf[v] = static_cast<int>(p);
                m_sharing[m_mesh.topology->unknown[v]].push_back(v);
            }
        }
    }

    void place(int p, const std::vector<Correspondence>& points)
    {
        const SewnMesh::Part& part = m_mesh.parts[p];
        Vec2 restCentre = Vec2::Zero();
        Vec3 placeCentre = Vec3::Zero();
        for (const Correspondence& c : points) {
            restCentre += c.rest;
            placeCentre += c.place;
        }
        restCentre /= static_cast<double>(points.size());
        placeCentre /= static_cast<double>(points.size());
        Eigen::Matrix<double, 3, 2> covariance = Eigen::Matrix<double, 3, 2>::Zero();
        for (const Correspondence& c : points)
            covariance += (c.place - placeCentre) * (c.rest - restCentre).transpose();

        const auto& [centre, up, isFlat] = m_rims[part.component];
        Rigid rigid;
        const Eigen::JacobiSVD<Eigen::Matrix<double, 3, 2>, Eigen::FullPivHouseholderQRPreconditioner> svd(
            covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
        const bool stands = !m_held[p].empty() && up != Vec3::Zero();
        if (stands && turnsMore(p) > goesAround * EIGEN_PI / 180 && standAround(p))
            return;
        if (svd.singularValues()[1] > lineThreshold * svd.singularValues()[0]) {
            rigid.rotation.leftCols<2>() = svd.matrixU().leftCols<2>() * svd.matrixV().transpose();
            rigid.rotation.col(2) = rigid.rotation.col(0).cross(rigid.rotation.col(1));
        } else {
            const bool point = svd.singularValues()[0] <= 0;
            const Vec3 along = point ? Vec3(Vec3::UnitX()) : Vec3(svd.matrixU().col(0));
            Vec3 outwards = across(along, placeCentre - centre);
            if (stands && isFlat) // else a border may lean anywhere
                outwards = runsAlong(p, svd.matrixV().col(0)) * part.outward * along.cross(up);
            else if (outwards.norm() < 1e-3 * m_mesh.diameter[part.component])
                outwards = bulge(points, placeCentre, along);
            rigid.rotation = turnedOutwards(svd.matrixV().col(0), along, outwards, part.outward);
        }
        rigid.shift = placeCentre - rigid.rotation.leftCols<2>() * restCentre;
        settle(p, rigid);
    }

    /// By how much the places of a held outline turn more than the outline does, over all of it; radians.
    double turnsMore(int p) const
    {
        const SewnMesh::Part& part = m_mesh.parts[p];
        const Vec3& up = m_rims[part.component].up;
        double more = 0;
        for (const Correspondence& c : m_held[p]) {
            const std::optional<int> next = nextHeld(m_mesh, part, c.vertex);
            const std::optional<int> last = next ? nextHeld(m_mesh, part, *next) : std::nullopt;
            if (!last)
                continue;
            const Vec2 in = m_mesh.rest()[*next] - c.rest, out = m_mesh.rest()[*last] - m_mesh.rest()[*next];
            const Vec3 from = across(up, heldAt(m_mesh, *next) - c.place),
                       to = across(up, heldAt(m_mesh, *last) - heldAt(m_mesh, *next));
            more += std::atan2(up.dot(from.cross(to)), from.dot(to)) -
                    part.outward * std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
        }
        return std::abs(more);
    }

    /// 1 where the held outline, with the cloth to its left, runs along a direction of the pattern, else -1.
    double runsAlong(int p, const Vec2& direction) const
    {
        double sum = 0;
        for (const Correspondence& c : m_held[p])
            if (const std::optional<int> next = nextHeld(m_mesh, m_mesh.parts[p], c.vertex))
                sum += (m_mesh.rest()[*next] - c.rest).dot(direction);
        return (sum < 0 ? -1 : 1) * senseOf(m_mesh, m_mesh.parts[p]);
    }

    /// A wall along a rim that it goes around: each vertex where the nearest place of the rim has it, upright.
    /// False where no outline runs along the rim.
    bool standAround(int p)
    {
        const SewnMesh::Part& part = m_mesh.parts[p];
        const Vec3& up = m_rims[part.component].up;
        std::vector<Correspondence> feet;
        std::vector<Eigen::Matrix3d> turns;
        const double sense = senseOf(m_mesh, part);
        const std::size_t step = 1 + m_held[p].size() / enoughFeet;
        for (std::size_t k = 0; k < m_held[p].size(); k += step) {
            const Correspondence& c = m_held[p][k];
            const std::optional<int> next = nextHeld(m_mesh, part, c.vertex);
            if (!next)
                continue;
            const Vec2 rest = m_mesh.rest()[*next] - c.rest;
            const Vec3 along = across(up, heldAt(m_mesh, *next) - c.place);
            if (!(rest.norm() > 0) || !(along.norm() > 0))
                continue;
            feet.push_back({(m_mesh.rest()[*next] + c.rest) / 2, (heldAt(m_mesh, *next) + c.place) / 2, c.vertex});
            const Vec2 right = sense * rest.normalized();
            Eigen::Matrix3d from, to;
            from << Vec3(right.x(), right.y(), 0), Vec3(-right.y(), right.x(), 0), Vec3::UnitZ();
            to << sense * along.normalized(), up, sense * along.normalized().cross(up);
            turns.push_back(to * from.transpose());
        }
        if (feet.empty())
            return false;
        for (int v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v) {
            const Vec2& rest = m_mesh.rest()[v];
            const auto nearest = std::ranges::min_element(
                feet, {}, [&](const Correspondence& c) { return (c.rest - rest).squaredNorm(); });
            const Eigen::Matrix3d& turn = turns[static_cast<std::size_t>(nearest - feet.begin())];
            put(v, nearest->place + turn.leftCols<2>() * (rest - nearest->rest), turn);
        }
        settle(p);
        return true;
    }

    void put(int v, const Vec3& at, const Eigen::Matrix3d& turn)
    {
        const Quat q(turn);
        m_places.col(v) = at;
        m_frames.col(v) << q.w(), q.x(), q.y(), q.z();
    }

    void settle(int p, const Rigid& rigid)
    {
        const SewnMesh::Part& part = m_mesh.parts[p];
        for (int v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v)
            put(v, rigid(m_mesh.rest()[v]), rigid.rotation);
        settle(p);
    }

    /// What is sewn to it waits for its turn.
    void settle(int p)
    {
        m_isPlaced[p] = 1;
        const SewnMesh::Part& part = m_mesh.parts[p];
        for (int v = part.firstVertex; v < part.firstVertex + part.boundaryCount; ++v)
            for (const int other : m_sharing[m_mesh.topology->unknown[v]])
                if (!m_isPlaced[m_partOf[other]] && !std::exchange(m_isSewn[other], 1))
                    m_waiting.emplace(++m_sewnCount[m_partOf[other]], -m_partOf[other]);
    }

    static Vec3 across(const Vec3& along, const Vec3& v) { return v - along.dot(v) * along; }

    /// Where an arched row of places bulges to. Cloth whose straight edge follows it bends that way without strain;
    /// lying in the plane of the arch it would be sheared, and stay there for symmetry.
    static Vec3 bulge(const std::vector<Correspondence>& points, const Vec3& centre, const Vec3& along)
    {
        double spread = 0;
        for (const Correspondence& c : points)
            spread += std::pow(along.dot(c.place - centre), 2) / static_cast<double>(points.size());
        Vec3 sum = Vec3::Zero();
        for (const Correspondence& c : points)
            sum += (1 - std::pow(along.dot(c.place - centre), 2) / std::max(spread, 1e-300)) *
                   across(along, c.place - centre);
        return sum / static_cast<double>(points.size());
    }

    /// The rotation that carries `rest` to `along` and looks outwards, which is across it, or anywhere for zero.
    static Eigen::Matrix3d turnedOutwards(const Vec2& rest, const Vec3& along, const Vec3& outwards, double side)
    {
        const Vec3 normal = side * (outwards.norm() > 1e-9 ? Vec3(outwards.normalized()) : along.unitOrthogonal());
        Eigen::Matrix3d from, to;
        from << Vec3(rest.x(), rest.y(), 0), Vec3(-rest.y(), rest.x(), 0), Vec3::UnitZ();
        to << along, normal.cross(along), normal;
        return to * from.transpose();
    }

    /// The points of an unplaced patch that are sewn to placed ones.
    std::vector<Correspondence> sewnPoints(int p) const
    {
        const SewnMesh::Part& part = m_mesh.parts[p];
        std::vector<Correspondence> points;
        for (int v = part.firstVertex; v < part.firstVertex + part.boundaryCount; ++v) {
            Vec3 sum = Vec3::Zero();
            int count = 0;
            for (int other : m_sharing[m_mesh.topology->unknown[v]])
                if (m_isPlaced[m_partOf[other]]) {
                    sum += m_places.col(other);
                    ++count;
                }
            if (count > 0)
                points.push_back({m_mesh.rest()[v], sum / count, v});
        }
        return points;
    }

    bool placeNextThroughSeams()
    {
        while (!m_waiting.empty() && m_isPlaced[-m_waiting.top().second])
            m_waiting.pop();
        if (m_waiting.empty())
            return false;
        const int best = -m_waiting.top().second;
        if (!m_mesh.anchored[m_mesh.parts[best].component])
            m_rims[m_mesh.parts[best].component].centre = centreOfPlaced(m_mesh.parts[best].component);
        place(best, sewnPoints(best));
        return true;
    }

    Vec3 centreOfPlaced(int component) const
    {
        Vec3 sum = Vec3::Zero();
        double area = 0;
        for (const int p : m_ofComponent[component]) {
            const SewnMesh::Part& part = m_mesh.parts[p];
            if (!m_isPlaced[p])
                continue;
            for (int v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v)
                sum += m_mesh.area[v] * m_places.col(v);
            area += part.area;
        }
        return area > 0 ? Vec3(sum / area) : sum;
    }

    /// A component that nothing holds begins with its largest patch, lying flat; several lie side by side.
    bool placeFirstOfFreeComponent()
    {
        while (m_nextLargest < m_byArea.size() && m_isPlaced[m_byArea[m_nextLargest]])
            ++m_nextLargest;
        if (m_nextLargest == m_byArea.size())
            return false;
        const int best = m_byArea[m_nextLargest];
        const SewnMesh::Part& part = m_mesh.parts[best];
        Box2 box;
        for (int v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v)
            box.extend(m_mesh.rest()[v]);
        Rigid rigid;
        if (part.outward < 0)
            rigid.rotation = Eigen::AngleAxisd(EIGEN_PI, Vec3::UnitX()).toRotationMatrix();
        rigid.shift = Vec3(m_freeX, 0, 0) - rigid.rotation.leftCols<2>() * box.center();
        m_freeX += m_mesh.diameter[part.component];
        settle(best, rigid);
        return true;
    }

    SheetState assemble() const
    {
        SheetState state;
        state.positions.setZero(3, m_mesh.unknownCount());
        for (int u = 0; u < m_mesh.unknownCount(); ++u) {
            for (int v : m_sharing[u])
                state.positions.col(u) += m_places.col(v);
            state.positions.col(u) /= static_cast<double>(m_sharing[u].size());
        }
        for (std::size_t k = 0; k < m_mesh.targets.size(); ++k)
            state.positions.col(m_mesh.freeCount + static_cast<Eigen::Index>(k)) = m_mesh.targets[k];
        state.frames = m_frames;
        return state;
    }

    void sortByArea()
    {
        m_byArea.resize(m_mesh.parts.size());
        std::iota(m_byArea.begin(), m_byArea.end(), 0);
        std::ranges::stable_sort(m_byArea,
                                 [this](int a, int b) { return m_mesh.parts[a].area > m_mesh.parts[b].area; });
    }

    const SewnMesh& m_mesh;
    std::vector<char> m_isPlaced; // of each part
    Eigen::Matrix3Xd m_places;    // of the vertices of those,
    Eigen::Matrix4Xd m_frames;    // and how they lie: w, x, y, z
    std::vector<std::vector<Correspondence>> m_held;
    std::vector<Rim> m_rims; // per component
    std::vector<std::vector<int>> m_sharing;
    std::vector<int> m_partOf;
    std::vector<std::vector<int>> m_ofComponent; // parts
    std::vector<int> m_byArea;                   // parts, the largest first
    std::size_t m_nextLargest = 0;
    std::vector<char> m_isSewn;   // to a placed part, of each vertex
    std::vector<int> m_sewnCount; // of them, of each part
    /// Parts with the number of their points that are sewn to placed ones; of equal ones the first comes first.
    std::priority_queue<std::pair<int, int>> m_waiting;
    double m_freeX = 0;
};

} // namespace

SheetState startPlacement(const SewnMesh& mesh)
{
    return Placer(mesh).run();
}

} // namespace bolster
