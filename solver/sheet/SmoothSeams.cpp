#include "SmoothSeams.h"

#include "LocalStep.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace bolster {

namespace {

// Sides that meet at less than the first angle are one sheet, at more than the second two.
constexpr double smoothAngle = 20 * EIGEN_PI / 180;
constexpr double sharpAngle = 45 * EIGEN_PI / 180;
// Triangles are irregular in some rows beside an outline.
constexpr int lopsidedRows = 4;
// Half of it lets accelerated iterations circle where the bending length is five edges.
constexpr double enoughDamping = 4;
// Of what L2 has for a vertex with triangles of usual shapes. In the middle of a seam, with edges of two bending
// lengths, it is 0.2 to 0.42.
constexpr double mostFlux = 0.65;
// What the weights of a ring beside a seam add up to at most then; in tips and strips it is more.
constexpr double usualWeights = 1.5;
// Edges: across strips that are narrower fits turn with every tenth of a millimetre.
constexpr double leastWidth = 0.4;
// So many edges apart the two sides of a closed corner can be joined.
constexpr double tipEdges = 4;
// A vertex of a seam takes much longer than others.
constexpr int chunk = 32;

/// 1 for one sheet, 0 for an edge.
double smoothness(const Eigen::Vector4d& a, const Eigen::Vector4d& b)
{
    const double cosine = rotationOf(a).col(2).dot(rotationOf(b).col(2));
    const double kink = std::acos(std::clamp(cosine, -1.0, 1.0));
    const double t = std::clamp((sharpAngle - kink) / (sharpAngle - smoothAngle), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// Carries `partnerTangent` to `tangent`, and what lies left of it to the left or, mirrored, to the right.
Eigen::Matrix2d planeMap(const Vec2& tangent, const Vec2& partnerTangent, bool mirrored)
{
    const auto basis = [](const Vec2& t, double left) {
        Eigen::Matrix2d m;
        m << t.x(), -left * t.y(), t.y(), left * t.x();
        return m;
    };
    return basis(tangent, mirrored ? -1 : 1) * basis(partnerTangent, 1).transpose();
}

Vec2 sumOfRing(const SewnMesh& mesh, int vertex, bool weighted)
{
    Vec2 sum = Vec2::Zero();
    for (int k = mesh.ringStart[vertex]; k < mesh.ringStart[vertex + 1]; ++k)
        sum += (weighted ? double{mesh.ring[k].weight} : 1) * mesh.along(vertex, mesh.ring[k]);
    return sum;
}

/// Weights with which differences to the ring's vertices give the derivative along `direction` (least squares).
std::vector<double> derivativeAlong(const SewnMesh& mesh, int vertex, const Eigen::Matrix2d& rest,
                                    const Vec2& direction)
{
    const Vec2 dual = rest.inverse() * direction;
    std::vector<double> weights;
    for (int k = mesh.ringStart[vertex]; k < mesh.ringStart[vertex + 1]; ++k)
        weights.push_back(mesh.ring[k].weight * dual.dot(mesh.along(vertex, mesh.ring[k])));
    return weights;
}

/// Sides that are far from one plane nearly cancel, and what is left turns wildly. So the frame is held where it is
/// by as much as they cancel; where it comes to rest does not change by that.
void hold(const Eigen::Vector4d& frame, Eigen::Matrix<double, 3, 2>& covariance, Eigen::Matrix2d& rest)
{
    const Eigen::Matrix<double, 3, 2> present = rotationOf(frame).leftCols<2>();
    const double cancelled = 0.5 * std::max(0.0, rest.trace() - present.cwiseProduct(covariance).sum());
    covariance += cancelled * present;
    rest += cancelled * Eigen::Matrix2d::Identity();
}

Quat quaternionOf(const Eigen::Vector4d& frame)
{
    return {frame[0], frame[1], frame[2], frame[3]};
}

/// Turns a frame from the pattern plane from which `to` leads into the one to which it leads.
Quat turnBack(const Eigen::Matrix2d& to)
{
    Eigen::Matrix3d back = Eigen::Matrix3d::Identity();
    back.topLeftCorner<2, 2>() = to.transpose();
    back(2, 2) = to.determinant() < 0 ? -1 : 1;
    return Quat(back);
}

bool wellShaped(const Eigen::Matrix2d& rest)
{
    return rest.determinant() > 1e-3 * rest.trace() * rest.trace();
}

} // namespace

SmoothSeams::SmoothSeams(const SewnMesh& mesh, const std::vector<Eigen::Matrix2d>& rest)
    : m_mesh(mesh)
{
    std::vector<int> partOf(mesh.vertexCount());
    for (int p = 0; p < std::ssize(mesh.parts); ++p)
        std::fill_n(partOf.begin() + mesh.parts[p].firstVertex, mesh.parts[p].vertexCount, p);
    for (std::size_t i = 0; i < mesh.topology->seams.size(); ++i)
        join(mesh.topology->seams[i], mesh.continuity[i], partOf, rest);
    std::ranges::stable_sort(m_joints, {}, &Joint::vertex);
    std::vector<Joint> merged;
    for (Joint& joint : m_joints) {
        if (merged.empty() || merged.back().vertex != joint.vertex)
            merged.push_back(std::move(joint));
        else
            merged.back().sides.push_back(joint.sides.front());
    }
    m_joints = std::move(merged);
    // Where several plain seams of a patch with itself meet there is no one other side.
    std::erase_if(m_joints, [](const Joint& joint) {
        return joint.sides.size() > 1 &&
               std::ranges::any_of(joint.sides, [](const Side& side) { return side.kind == Kind::Self; });
    });
    std::ranges::for_each(m_joints, [this](Joint& joint) { boundFlux(joint); });
    findLopsided(rest);
}

/// Of the narrowest sheet at a joint, in edges; 0.9 where triangles are of usual shapes.
double SmoothSeams::widthOf(const Joint& joint) const
{
    const double edge = m_mesh.parts[joint.part].meanEdge;
    double width = std::numeric_limits<double>::infinity();
    for (const Side& side : joint.sides) {
        const double along = (m_mesh.rest()[side.after] - m_mesh.rest()[side.before]).norm() / 2;
        const double area = std::min(m_mesh.area[joint.vertex], m_mesh.area[side.partner]);
        width = std::min(width, 2 * area / std::max(along * edge, 1e-300));
    }
    return width;
}

/// It goes by the fits of the iteration before. In narrow strips and in tips these say little of the slope across
/// the seam, and weights are large: covers turned about such places for good.
void SmoothSeams::boundFlux(Joint& joint) const
{
    double flux = 0, smoothing = 0;
    for (std::size_t k = 0; k < joint.flux.size(); ++k) {
        flux += std::abs(joint.flux[k]);
        smoothing += m_mesh.ring[m_mesh.ringStart[joint.vertex] + static_cast<int>(k)].weight;
    }
    const double twice = 2 * m_mesh.parts[joint.part].bendingSquared();
    const double most =
        mostFlux * (m_mesh.area[joint.vertex] + dampingOf(joint) + twice * std::min(smoothing, usualWeights));
    const double resolved = std::min(1.0, widthOf(joint) / leastWidth);
    for (double& weight : joint.flux)
        weight *= resolved * std::min(1.0, most / std::max(twice * flux, 1e-300));
}

double SmoothSeams::dampingOf(const Joint& joint) const
{
    if (joint.sides.front().kind == Kind::Self)
        return 0;
    const SewnMesh::Part& part = m_mesh.parts[joint.part];
    const double equal = joint.sides.front().kind == Kind::C1 ? 2 : 1; // what is damped more may pull more
    const double resolved = part.bendingSquared() / (part.meanEdge * part.meanEdge);
    return equal * enoughDamping * resolved * m_mesh.area[joint.vertex];
}

std::vector<double> SmoothSeams::damping() const
{
    std::vector<double> damping(m_mesh.vertexCount(), 0.0);
    for (const Joint& joint : m_joints)
        damping[joint.vertex] = dampingOf(joint);
    return damping;
}

/// A corner whose sides are sewn to each other becomes a pointed hood. At its tip the rings of both sides overlap.
bool SmoothSeams::nearTip(int part, int v, int w) const
{
    const Vec2 across = m_mesh.rest()[w] - m_mesh.rest()[v];
    return across.norm() < tipEdges * m_mesh.parts[part].meanEdge && sumOfRing(m_mesh, v, false).dot(across) > 0;
}

void SmoothSeams::join(const SurfaceTopology::Chain& seam, Continuity continuity, const std::vector<int>& partOf,
                       const std::vector<Eigen::Matrix2d>& rest)
{
    const bool self = partOf[seam.a.front()] == partOf[seam.b.front()];
    if (continuity == Continuity::C0 && !self)
        return;
    const Kind kind = continuity == Continuity::C0   ? Kind::Self
                      : continuity == Continuity::C1 ? Kind::C1
                                                     : Kind::G1;
    for (std::size_t k = 0; k < seam.a.size(); ++k) {
        const int v = static_cast<int>(seam.a[k]), w = static_cast<int>(seam.b[k]);
        if (v == w || (self && nearTip(partOf[v], v, w)) || !wellShaped(rest[v]) || !wellShaped(rest[w]))
            continue;
        const Vec2 along = chainTangent(m_mesh.rest(), seam.a, k), other = chainTangent(m_mesh.rest(), seam.b, k);
        const double outwardV = m_mesh.parts[partOf[v]].outward, outwardW = m_mesh.parts[partOf[w]].outward;
        const bool mirrored = outwardV != outwardW;
        const Eigen::Matrix2d to = planeMap(along, other, mirrored);
        const double sideV = cross(along, sumOfRing(m_mesh, v, false));
        const double sideW = cross(along, to * sumOfRing(m_mesh, w, false));
        if (sideV * sideW >= 0)
            continue; // right side to wrong side
        const std::size_t before = k > 0 ? k - 1 : 0, after = std::min(k + 1, seam.a.size() - 1);
        auto add = [&](int vertex, int partner, const Eigen::Matrix2d& map) {
            const double stiffness =
                m_mesh.parts[partOf[partner]].material.stiffness / m_mesh.parts[partOf[vertex]].material.stiffness;
            const auto& chain = vertex == v ? seam.a : seam.b;
            m_joints.push_back({vertex,
                                partOf[vertex],
                                rest[vertex],
                                {{kind, partner, stiffness, map, turnBack(map), rest[partner],
                                  static_cast<int>(chain[before]), static_cast<int>(chain[after])}},
                                derivativeAlong(m_mesh, vertex, rest[vertex], sumOfRing(m_mesh, vertex, true))});
        };
        add(v, w, to);
        add(w, v, to.transpose());
    }
}

/// For a surface with second derivatives K a ring's fitted slope is S^-1 (sum w (e^T K e) e) / 2. The offset o is
/// the point whose slope K o comes nearest to it for all K.
void SmoothSeams::findLopsided(const std::vector<Eigen::Matrix2d>& rest)
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
            const Vec2 e = m_mesh.along(v, m_mesh.ring[k]);
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
template <class Frame>
Eigen::Vector4d SmoothSeams::ringSum(int vertex, const std::vector<double>& weights, const Frame& frame) const
{
    const Eigen::Vector4d here = frame(vertex);
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const Eigen::Vector4d there = frame(m_mesh.ring[m_mesh.ringStart[vertex] + static_cast<int>(i)].vertex);
        sum += weights[i] * (there.dot(here) < 0 ? Eigen::Vector4d(-there - here) : Eigen::Vector4d(there - here));
    }
    return sum;
}

SmoothSeams::Matrix32 SmoothSeams::covariance(const SheetMoment& sheet, int vertex) const
{
    const Vec3 here = sheet.position(vertex);
    Matrix32 sum = Matrix32::Zero();
    for (int k = m_mesh.ringStart[vertex]; k < m_mesh.ringStart[vertex + 1]; ++k) {
        const SewnMesh::RingEdge& edge = m_mesh.ring[k];
        sum.noalias() +=
            (sheet.position(edge.vertex) - here) * (edge.weight * m_mesh.along(vertex, edge).transpose());
    }
    return sum;
}

/// The map from the partner's plane as it counts at the moment. For G1 it is turned so that the seam runs the same
/// way in both rings as they are fitted alone: what they say of each other's direction in the plane then is nothing
/// new.
Eigen::Matrix2d SmoothSeams::mapNow(const Joint& joint, const Side& side, const SheetMoment& sheet,
                                    const Matrix32& own, const Matrix32& other) const
{
    if (side.kind != Kind::G1)
        return side.to;
    const Vec3 seam = sheet.position(side.after) - sheet.position(side.before);
    const auto alone = [&](int vertex, const Matrix32& covariance, const Eigen::Matrix2d& rest) -> Vec2 {
        const LocalFit fit = fitVertex(covariance, rest, m_mesh.area[vertex], sheet.frames.col(vertex), 0);
        return rotationOf(fit.frame).leftCols<2>().transpose() * seam;
    };
    const Vec2 here = alone(joint.vertex, own, joint.rest);
    const Vec2 there = side.to * alone(side.partner, other, side.rest);
    const Vec2 turn(there.dot(here), cross(there, here));
    const double size = turn.norm();
    if (!(size > 0))
        return side.to;
    Eigen::Matrix2d rotation;
    rotation << turn.x(), -turn.y(), turn.y(), turn.x();
    return rotation / size * side.to;
}

/// Returns how much of the other side counts, 0 to 1.
double SmoothSeams::fitBothSides(const Joint& joint, const SheetMoment& sheet, Columns& right) const
{
    const Eigen::Vector4d frame = sheet.frames.col(joint.vertex);
    const Matrix32 own = covariance(sheet, joint.vertex);
    Matrix32 both = own;
    Eigen::Matrix2d rest = joint.rest;
    double share = 1;
    for (const Side& side : joint.sides) {
        if (side.kind == Kind::Self)
            share = smoothness(frame, sheet.frames.col(side.partner));
        const Matrix32 other = covariance(sheet, side.partner);
        const Eigen::Matrix2d to = mapNow(joint, side, sheet, own, other);
        both += share * side.stiffness * other * to.transpose();
        rest += share * side.stiffness * to * side.rest * to.transpose();
    }
    if (share == 0)
        return 0;
    if (joint.sides.front().kind != Kind::Self)
        hold(frame, both, rest);
    right.col(joint.vertex) =
        m_mesh.area[joint.vertex] * fitVertex(both, rest, m_mesh.area[joint.vertex], frame, 0).frame;
    return share;
}

/// What C1 asks of a frame beyond the common fit: not to turn in its plane against the partner's.
Eigen::Vector4d SmoothSeams::turnToPartners(const Joint& joint, const Columns& frames) const
{
    const Quat own = quaternionOf(frames.col(joint.vertex));
    double turn = 0;
    for (const Side& side : joint.sides) {
        if (side.kind != Kind::C1)
            continue;
        const Quat between = own.conjugate() * quaternionOf(frames.col(side.partner)) * side.turnBack;
        const double way = side.stiffness / (1 + side.stiffness); // both frames move, the softer side's farther
        turn += way * (between.w() < 0 ? -between.z() : between.z());
    }
    const Quat pull = own * Quat(0, 0, 0, turn);
    return dampingOf(joint) / static_cast<double>(joint.sides.size()) *
           Eigen::Vector4d(pull.w(), pull.x(), pull.y(), pull.z());
}

std::vector<int> SmoothSeams::vertices() const
{
    std::vector<int> result;
    for (const Lopsided& l : m_lopsided)
        result.push_back(l.vertex);
    for (const Joint& joint : m_joints)
        result.push_back(joint.vertex);
    return result;
}

void SmoothSeams::correct(const SheetMoment& sheet, WorkerPool& pool, Columns& right) const
{
    const auto present = [&](int v) -> Eigen::Vector4d { return sheet.frames.col(v); };
    const auto fitted = [&](int v) -> Eigen::Vector4d { return right.col(v) / m_mesh.area[v]; };
    pool.forChunks(
        static_cast<int>(m_lopsided.size()),
        [&](int, int begin, int end) {
            for (int i = begin; i < end; ++i) {
                const Lopsided& l = m_lopsided[i];
                const Eigen::Vector4d step = ringSum(l.vertex, l.offset, present);
                right.col(l.vertex) = m_mesh.area[l.vertex] * (fitted(l.vertex) - step).normalized();
            }
        },
        chunk);
    const int count = static_cast<int>(m_joints.size());
    std::vector<double> share(count);
    pool.forChunks(
        count,
        [&](int, int begin, int end) {
            for (int i = begin; i < end; ++i)
                share[i] = fitBothSides(m_joints[i], sheet, right);
        },
        chunk);
    // Smoothing ends at the border; on one sheet it would take from the other side what is added here. All fits
    // first, then the additions, because these look at the neighbours' fits.
    Columns added = Columns::Zero(4, count);
    pool.forChunks(
        count,
        [&](int, int begin, int end) {
            for (int i = begin; i < end; ++i)
                if (share[i] > 0)
                    added.col(i) = turnToPartners(m_joints[i], sheet.frames) -
                                   2 * m_mesh.parts[m_joints[i].part].bendingSquared() * share[i] *
                                       ringSum(m_joints[i].vertex, m_joints[i].flux, fitted);
        },
        chunk);
    for (int i = 0; i < count; ++i)
        right.col(m_joints[i].vertex) += added.col(i);
}

} // namespace bolster
