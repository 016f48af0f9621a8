#include "SelfSeams.h"

#include "LocalStep.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace bolster {

namespace {

// Sides that meet at less than the first angle are one sheet, at more than the second two.
constexpr double smoothAngle = 20 * EIGEN_PI / 180;
constexpr double sharpAngle = 45 * EIGEN_PI / 180;
// Triangles are irregular in some rows beside an outline.
constexpr int lopsidedRows = 4;
// So many edges apart the two sides of a closed corner can be joined.
constexpr double tipEdges = 4;

double cross(const Vec2& a, const Vec2& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// 1 for one sheet, 0 for an edge.
double smoothness(const Eigen::Vector4d& a, const Eigen::Vector4d& b)
{
    const double cosine = rotationOf(a).col(2).dot(rotationOf(b).col(2));
    const double kink = std::acos(std::clamp(cosine, -1.0, 1.0));
    const double t = std::clamp((sharpAngle - kink) / (sharpAngle - smoothAngle), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

Vec2 chainTangent(const std::vector<Vec2>& rest, const std::vector<std::uint32_t>& chain, std::size_t k)
{
    const std::size_t before = k > 0 ? k - 1 : 0, after = std::min(k + 1, chain.size() - 1);
    return (rest[chain[after]] - rest[chain[before]]).normalized();
}

Vec2 sumOfRing(const SewnMesh& mesh, int vertex, bool weighted)
{
    Vec2 sum = Vec2::Zero();
    for (int k = mesh.ringStart[vertex]; k < mesh.ringStart[vertex + 1]; ++k)
        sum += (weighted ? mesh.ring[k].weight : 1) * mesh.ring[k].rest;
    return sum;
}

/// Weights with which differences to the ring's vertices give the derivative along `direction` (least squares).
std::vector<double> derivativeAlong(const SewnMesh& mesh, int vertex, const Eigen::Matrix2d& rest,
                                    const Vec2& direction)
{
    const Vec2 dual = rest.inverse() * direction;
    std::vector<double> weights;
    for (int k = mesh.ringStart[vertex]; k < mesh.ringStart[vertex + 1]; ++k)
        weights.push_back(mesh.ring[k].weight * dual.dot(mesh.ring[k].rest));
    return weights;
}

bool wellShaped(const Eigen::Matrix2d& rest)
{
    return rest.determinant() > 1e-3 * rest.trace() * rest.trace();
}

} // namespace

SelfSeams::SelfSeams(const SewnMesh& mesh, const std::vector<Eigen::Matrix2d>& rest)
    : m_mesh(mesh)
{
    std::vector<int> partOf(mesh.vertexCount());
    for (int p = 0; p < std::ssize(mesh.parts); ++p)
        std::fill_n(partOf.begin() + mesh.parts[p].firstVertex, mesh.parts[p].vertexCount, p);
    for (const SurfaceTopology::Chain& seam : mesh.topology->seams)
        if (partOf[seam.a.front()] == partOf[seam.b.front()])
            join(seam, partOf, rest);
    // Where several seams meet there is no one other side.
    std::map<int, int> uses;
    for (const Joint& joint : m_joints)
        ++uses[joint.vertex];
    std::erase_if(m_joints, [&](const Joint& joint) { return uses[joint.vertex] > 1; });
    findLopsided(rest);
}

/// A corner whose sides are sewn to each other becomes a pointed hood. At its tip the rings of both sides overlap.
bool SelfSeams::nearTip(int part, int v, int w) const
{
    const Vec2 across = m_mesh.rest()[w] - m_mesh.rest()[v];
    return across.norm() < tipEdges * m_mesh.parts[part].meanEdge && sumOfRing(m_mesh, v, false).dot(across) > 0;
}

void SelfSeams::join(const SurfaceTopology::Chain& seam, const std::vector<int>& partOf,
                     const std::vector<Eigen::Matrix2d>& rest)
{
    for (std::size_t k = 0; k < seam.a.size(); ++k) {
        const int v = static_cast<int>(seam.a[k]), w = static_cast<int>(seam.b[k]);
        if (nearTip(partOf[v], v, w) || !wellShaped(rest[v]) || !wellShaped(rest[w]))
            continue;
        const Vec2 along = chainTangent(m_mesh.rest(), seam.a, k), other = chainTangent(m_mesh.rest(), seam.b, k);
        Eigen::Matrix2d turn; // carries `other` to `along`
        turn << other.dot(along), -cross(other, along), cross(other, along), other.dot(along);
        const double sideV = cross(along, sumOfRing(m_mesh, v, false));
        const double sideW = cross(along, turn * sumOfRing(m_mesh, w, false));
        if (sideV * sideW >= 0)
            continue; // right side to wrong side
        auto add = [&](int vertex, int partner, const Eigen::Matrix2d& to) {
            m_joints.push_back({vertex, partner, partOf[vertex], to, rest[vertex],
                                to * rest[partner] * to.transpose(),
                                derivativeAlong(m_mesh, vertex, rest[vertex], sumOfRing(m_mesh, vertex, true))});
        };
        add(v, w, turn);
        add(w, v, turn.transpose());
    }
}

/// For a surface with second derivatives K a ring's fitted slope is S^-1 (sum w (e^T K e) e) / 2. The offset o is
/// the point whose slope K o comes nearest to it for all K.
void SelfSeams::findLopsided(const std::vector<Eigen::Matrix2d>& rest)
{
    std::set<int> beside; // ordered, so that the order of seams does not matter
    for (const Joint& joint : m_joints)
        beside.insert(joint.vertex);
    for (int row = 0; row < lopsidedRows; ++row)
        for (int v : std::vector<int>(beside.begin(), beside.end()))
            for (int k = m_mesh.ringStart[v]; k < m_mesh.ringStart[v + 1]; ++k)
                beside.insert(m_mesh.ring[k].vertex);
    for (const SewnMesh::Part& part : m_mesh.parts)
        for (int v = part.firstVertex; v < part.firstVertex + part.boundaryCount; ++v)
            beside.erase(v);
    Eigen::Matrix<double, 6, 2> slopes; // K o for K = xx, xy + yx, yy
    slopes << 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1;
    for (int v : beside) {
        Eigen::Matrix<double, 6, 1> fitted = Eigen::Matrix<double, 6, 1>::Zero();
        for (int k = m_mesh.ringStart[v]; k < m_mesh.ringStart[v + 1]; ++k) {
            const Vec2& e = m_mesh.ring[k].rest;
            const Vec2 pull = 0.5 * m_mesh.ring[k].weight * (rest[v].inverse() * e);
            fitted.segment<2>(0) += e.x() * e.x() * pull;
            fitted.segment<2>(2) += 2 * e.x() * e.y() * pull;
            fitted.segment<2>(4) += e.y() * e.y() * pull;
        }
        const Vec2 offset = (slopes.transpose() * slopes).inverse() * (slopes.transpose() * fitted);
        m_lopsided.push_back({v, derivativeAlong(m_mesh, v, rest[v], offset)});
    }
}

/// Sum of weighted differences to the ring's frames, in the hemisphere of the vertex's own.
Eigen::Vector4d SelfSeams::ringSum(int vertex, const std::vector<double>& weights,
                                   const std::function<Eigen::Vector4d(int)>& frame) const
{
    const Eigen::Vector4d here = frame(vertex);
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const Eigen::Vector4d there = frame(m_mesh.ring[m_mesh.ringStart[vertex] + static_cast<int>(i)].vertex);
        sum += weights[i] * (there.dot(here) < 0 ? Eigen::Vector4d(-there - here) : Eigen::Vector4d(there - here));
    }
    return sum;
}

void SelfSeams::correct(const Eigen::Matrix4Xd& frames, const std::function<Matrix32(int)>& covariance,
                        const std::function<double(int)>& bendingSquared, Eigen::Matrix4Xd& right) const
{
    auto fitted = [&](int v) -> Eigen::Vector4d { return right.col(v) / m_mesh.area[v]; };
    for (const Lopsided& l : m_lopsided) {
        const Eigen::Vector4d step =
            ringSum(l.vertex, l.offset, [&](int v) -> Eigen::Vector4d { return frames.col(v); });
        right.col(l.vertex) = m_mesh.area[l.vertex] * (fitted(l.vertex) - step).normalized();
    }
    std::vector<double> share(m_joints.size());
    for (std::size_t i = 0; i < m_joints.size(); ++i) {
        const Joint& joint = m_joints[i];
        share[i] = smoothness(frames.col(joint.vertex), frames.col(joint.partner));
        if (share[i] <= 0)
            continue;
        const Matrix32 both =
            covariance(joint.vertex) + share[i] * covariance(joint.partner) * joint.turn.transpose();
        const LocalFit fit = fitVertex(both, joint.rest + share[i] * joint.partnerRest, m_mesh.area[joint.vertex],
                                       frames.col(joint.vertex), 0);
        right.col(joint.vertex) = m_mesh.area[joint.vertex] * fit.frame;
    }
    // Smoothing ends at the border; on one sheet it would take from the other side what is added here. All fits
    // first, then the additions, because these look at the neighbours' fits.
    std::vector<Eigen::Vector4d> flux(m_joints.size(), Eigen::Vector4d::Zero());
    for (std::size_t i = 0; i < m_joints.size(); ++i)
        if (share[i] > 0)
            flux[i] = -2 * bendingSquared(m_joints[i].part) * share[i] *
                      ringSum(m_joints[i].vertex, m_joints[i].flux, fitted);
    for (std::size_t i = 0; i < m_joints.size(); ++i)
        right.col(m_joints[i].vertex) += flux[i];
}

} // namespace bolster
