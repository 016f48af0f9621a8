#include "SheetKernels.h"

#include "LocalStep.h"

#include <algorithm>
#include <cmath>

// Debian's compiler has a bug in code that is not used here; without the emulation there is no fallback for lanes.
#define HWY_BROKEN_EMU128 0
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "SheetKernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace bolster::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// A column: the compiler makes of it what the instruction set has.
using Four [[gnu::vector_size(32), gnu::aligned(8), gnu::may_alias]] = double;

HWY_INLINE const Four& column(const Columns& columns, int i)
{
    return *reinterpret_cast<const Four*>(columns.data() + 4 * static_cast<std::ptrdiff_t>(i));
}

HWY_INLINE Four& column(Columns& columns, int i)
{
    return *reinterpret_cast<Four*>(columns.data() + 4 * static_cast<std::ptrdiff_t>(i));
}

HWY_INLINE double dot(const Four& a, const Four& b)
{
    const Four product = a * b;
    return (product[0] + product[1]) + (product[2] + product[3]);
}

constexpr int block = 8; // vertices that are fitted together

// One number of each vertex of a block.
using Wide = hn::CappedTag<double, block>;
using Vector = hn::Vec<Wide>;
constexpr Wide wide;
constexpr int lanes = static_cast<int>(hn::MaxLanes(Wide()));
constexpr double regularisation = 4e-4; // as in LocalStep
constexpr double largestStrain = 0.5;

struct alignas(64) FitBlock {
    double covariance[6][block]; // two columns
    double area[block];
    double inverse[3][block];
    double frame[4][block];
    double fitted[4][block];
    double stretch[3][block];
    double sound[block]; // 0 where the closed form fails
};

struct Rotated {
    Vector x, y, z;
};

HWY_INLINE Vector inner(const Rotated& a, const Rotated& b)
{
    return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}

/// fitVertex of LocalStep for a register of vertices.
HWY_INLINE void fit(FitBlock& in, int at, double poisson)
{
    const auto load = [&](const double* numbers) { return hn::Load(wide, numbers + at); };
    const Vector one = hn::Set(wide, 1.0), two = hn::Set(wide, 2.0);
    const Vector w = load(in.frame[0]), x = load(in.frame[1]), y = load(in.frame[2]), z = load(in.frame[3]);
    const Vector pull = hn::Mul(hn::Set(wide, regularisation), load(in.area));
    const auto twiceSum = [&](Vector a, Vector b, Vector c, Vector d) {
        return hn::Mul(two, hn::MulAdd(a, b, hn::Mul(c, d)));
    };
    const auto twiceDifference = [&](Vector a, Vector b, Vector c, Vector d) {
        return hn::Mul(two, hn::MulSub(a, b, hn::Mul(c, d)));
    };
    const Rotated before0{hn::Sub(one, twiceSum(y, y, z, z)), twiceSum(x, y, w, z), twiceDifference(x, z, w, y)};
    const Rotated before1{twiceDifference(x, y, w, z), hn::Sub(one, twiceSum(x, x, z, z)), twiceSum(y, z, w, x)};
    const Rotated g0{hn::MulAdd(pull, before0.x, load(in.covariance[0])),
                     hn::MulAdd(pull, before0.y, load(in.covariance[1])),
                     hn::MulAdd(pull, before0.z, load(in.covariance[2]))};
    const Rotated g1{hn::MulAdd(pull, before1.x, load(in.covariance[3])),
                     hn::MulAdd(pull, before1.y, load(in.covariance[4])),
                     hn::MulAdd(pull, before1.z, load(in.covariance[5]))};
    const Rotated normal{hn::MulSub(g0.y, g1.z, hn::Mul(g0.z, g1.y)), hn::MulSub(g0.z, g1.x, hn::Mul(g0.x, g1.z)),
                         hn::MulSub(g0.x, g1.y, hn::Mul(g0.y, g1.x))};
    const Vector area = hn::Sqrt(inner(normal, normal));
    const Vector m00 = hn::Add(inner(g0, g0), area), m11 = hn::Add(inner(g1, g1), area), m01 = inner(g0, g1);
    const Vector determinant = hn::MulSub(m00, m11, hn::Mul(m01, m01));
    const Vector scale = hn::Div(hn::Sqrt(hn::Add(m00, m11)), determinant);
    const Vector s00 = hn::Mul(m11, scale), s11 = hn::Mul(m00, scale), s01 = hn::Neg(hn::Mul(m01, scale));
    const auto combine = [](const Rotated& a, Vector p, const Rotated& b, Vector q) {
        return Rotated{hn::MulAdd(a.x, p, hn::Mul(b.x, q)), hn::MulAdd(a.y, p, hn::Mul(b.y, q)),
                       hn::MulAdd(a.z, p, hn::Mul(b.z, q))};
    };
    const Rotated r0 = combine(g0, s00, g1, s01), r1 = combine(g0, s01, g1, s11);
    const Vector unit = hn::Div(one, area);
    const Rotated r2{hn::Mul(normal.x, unit), hn::Mul(normal.y, unit), hn::Mul(normal.z, unit)};

    // (K + I) q, see quaternionNear().
    const Vector wx = hn::Sub(r1.z, r2.y), wy = hn::Sub(r2.x, r0.z), wz = hn::Sub(r0.y, r1.x);
    const Vector xy = hn::Add(r0.y, r1.x), xz = hn::Add(r0.z, r2.x), yz = hn::Add(r1.z, r2.y);
    const auto row = [&](Vector a, Vector b, Vector c, Vector d) {
        return hn::MulAdd(a, w, hn::MulAdd(b, x, hn::MulAdd(c, y, hn::Mul(d, z))));
    };
    const Vector plus = hn::Add(one, r0.x), minus = hn::Sub(one, r0.x);
    const Vector sum = hn::Add(r1.y, r2.z), difference = hn::Sub(r1.y, r2.z);
    const Vector q[4] = {row(hn::Add(plus, sum), wx, wy, wz), row(wx, hn::Sub(plus, sum), xy, xz),
                         row(wy, xy, hn::Add(minus, difference), yz), row(wz, xz, yz, hn::Sub(minus, difference))};
    const Vector square =
        hn::MulAdd(q[0], q[0], hn::MulAdd(q[1], q[1], hn::MulAdd(q[2], q[2], hn::Mul(q[3], q[3]))));
    const Vector length = hn::Div(one, hn::Sqrt(square));
    for (int i = 0; i < 4; ++i)
        hn::Store(hn::Mul(q[i], length), wide, in.fitted[i] + at);

    const Vector i00 = load(in.inverse[0]), i01 = load(in.inverse[1]), i11 = load(in.inverse[2]);
    const Rotated f0 = combine(g0, i00, g1, i01), f1 = combine(g0, i01, g1, i11);
    const auto clamped = [](Vector strain) {
        return hn::Clamp(strain, hn::Set(wide, -largestStrain), hn::Set(wide, largestStrain));
    };
    const Vector nu = hn::Set(wide, poisson);
    const Vector xxStrain = clamped(hn::Sub(inner(r0, f0), one)), yyStrain = clamped(hn::Sub(inner(r1, f1), one));
    const Vector xyStrain = clamped(hn::Mul(hn::Set(wide, 0.5), hn::Add(inner(r0, f1), inner(r1, f0))));
    hn::Store(hn::NegMulAdd(nu, yyStrain, one), wide, in.stretch[0] + at);
    hn::Store(hn::Mul(nu, xyStrain), wide, in.stretch[1] + at);
    hn::Store(hn::NegMulAdd(nu, xxStrain, one), wide, in.stretch[2] + at);

    const auto sound = hn::And(hn::And(hn::Gt(determinant, hn::Zero(wide)), hn::Gt(area, hn::Zero(wide))),
                               hn::Gt(square, hn::Set(wide, 1e-12)));
    hn::Store(hn::IfThenElseZero(sound, one), wide, in.sound + at);
}

void FitFrames(const SheetRings& rings, const Columns& positions, const Columns& frames, double poisson, int begin,
               int end, Columns& right, Columns& stretch)
{
    FitBlock in{};
    for (int first = begin; first < end; first += block) {
        const int count = std::min(block, end - first);
        for (int i = 0; i < count; ++i) {
            const SheetRings::Vertex* const vertex = &rings.vertices[first + i];
            const Four here = column(positions, vertex->unknown);
            Four c0 = here * -vertex->pull[0], c1 = here * -vertex->pull[1];
            for (int k = vertex->firstEdge; k < vertex[1].firstEdge; ++k) {
                const SheetRings::Edge& edge = rings.edges[k];
                const Four there = column(positions, edge.unknown);
                c0 += there * edge.pull[0];
                c1 += there * edge.pull[1];
            }
            for (int c = 0; c < 3; ++c) {
                in.covariance[c][i] = c0[c];
                in.covariance[3 + c][i] = c1[c];
                in.inverse[c][i] = vertex->inverse[c];
            }
            const Four frame = column(frames, first + i);
            for (int c = 0; c < 4; ++c)
                in.frame[c][i] = frame[c];
            in.area[i] = vertex->area;
        }
        for (int at = 0; at < block; at += lanes)
            fit(in, at, poisson);
        for (int i = 0; i < count; ++i) {
            Four fitted, strain{in.stretch[0][i], in.stretch[1][i], in.stretch[2][i], 0};
            for (int c = 0; c < 4; ++c)
                fitted[c] = in.fitted[c][i];
            column(right, first + i) = fitted * in.area[i];
            column(stretch, first + i) = in.sound[i] != 0 ? strain : Four{0, 0, 0, -1}; // -1: by the slow way
        }
    }
}

bool FrameResiduals(const SheetRings& rings, const Columns& frames, const Columns& right, double bending, int begin,
                    int end, const std::vector<int>& slots, Eigen::Matrix4Xf& residuals)
{
    double least = 0;
    for (int v = begin; v < end; ++v) {
        const SheetRings::Vertex* const vertex = &rings.vertices[v];
        const Four here = column(frames, v);
        Four smoothing = here * -vertex->weight;
        for (int k = vertex->firstEdge; k < vertex[1].firstEdge; ++k) {
            const Four there = column(frames, rings.edges[k].vertex);
            smoothing += there * rings.edges[k].weight;
            least = std::min(least, dot(here, there));
        }
        const Four residual = column(right, v) - here * vertex->area + smoothing * bending;
        float* const to = residuals.data() + 4 * static_cast<std::ptrdiff_t>(slots[v]);
        for (int c = 0; c < 4; ++c)
            to[c] = static_cast<float>(residual[c]);
    }
    return least >= 0;
}

void TurnFrames(const Columns& frames, const Eigen::Matrix4Xf& turns, const std::vector<int>& slots,
                const Columns& stretch, int begin, int end, Columns& turned, Columns& maps)
{
    for (int v = begin; v < end; ++v) {
        const float* const turn = turns.data() + 4 * static_cast<std::ptrdiff_t>(slots[v]);
        const Four before = column(frames, v);
        Four q = before + Four{turn[0], turn[1], turn[2], turn[3]};
        const double square = dot(q, q);
        q = square > 1e-24 ? q * (1 / std::sqrt(square)) : before;
        column(turned, v) = q;
        const double w = q[0], x = q[1], y = q[2], z = q[3];
        const Four r0{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y), 0};
        const Four r1{2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x), 0};
        const Four t = column(stretch, v);
        column(maps, 2 * v) = r0 * t[0] + r1 * t[1];
        column(maps, 2 * v + 1) = r0 * t[1] + r1 * t[2];
    }
}

void RingForces(const SheetRings& rings, const Columns& positions, const Columns& maps, double stiffness, int begin,
                int end, Columns& forces)
{
    for (int v = begin; v < end; ++v) {
        const SheetRings::Vertex* const vertex = &rings.vertices[v];
        Four places = column(positions, vertex->unknown) * -vertex->weight;
        Four preferred = column(maps, 2 * v) * vertex->pull[0] + column(maps, 2 * v + 1) * vertex->pull[1];
        for (int k = vertex->firstEdge; k < vertex[1].firstEdge; ++k) {
            const SheetRings::Edge& edge = rings.edges[k];
            places += column(positions, edge.unknown) * edge.weight;
            preferred +=
                column(maps, 2 * edge.vertex) * edge.pull[0] + column(maps, 2 * edge.vertex + 1) * edge.pull[1];
        }
        column(forces, v) = (places * 2 - preferred) * stiffness;
    }
}

} // namespace
} // namespace bolster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bolster {

HWY_EXPORT(FitFrames);
HWY_EXPORT(FrameResiduals);
HWY_EXPORT(TurnFrames);
HWY_EXPORT(RingForces);

SheetRings::SheetRings(const SewnMesh& mesh)
{
    constexpr double regular = 4e-4;
    const auto& unknown = mesh.topology->unknown;
    edges.reserve(mesh.ring.size());
    vertices.reserve(mesh.area.size() + 1);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        Vertex vertex;
        vertex.unknown = static_cast<int>(unknown[v]);
        vertex.firstEdge = static_cast<int>(edges.size());
        vertex.area = mesh.area[v];
        Eigen::Matrix2d rest = regular * mesh.area[v] * Eigen::Matrix2d::Identity();
        for (int k = mesh.ringStart[v]; k < mesh.ringStart[v + 1]; ++k) {
            const SewnMesh::RingEdge& ring = mesh.ring[k];
            const Vec2 pull = ring.weight * ring.rest;
            edges.push_back(
                {ring.vertex, static_cast<int>(unknown[ring.vertex]), ring.weight, {pull.x(), pull.y()}});
            vertex.weight += ring.weight;
            vertex.pull[0] += pull.x();
            vertex.pull[1] += pull.y();
            rest += pull * ring.rest.transpose();
        }
        const double determinant = rest.determinant();
        vertex.inverse[0] = rest(1, 1) / determinant;
        vertex.inverse[1] = -rest(0, 1) / determinant;
        vertex.inverse[2] = rest(0, 0) / determinant;
        vertices.push_back(vertex);
    }
    Vertex last;
    last.firstEdge = static_cast<int>(edges.size());
    vertices.push_back(last);
}

void fitFrames(const SheetRings& rings, const Columns& positions, const Columns& frames, double poisson, int begin,
               int end, Columns& right, Columns& stretch)
{
    HWY_DYNAMIC_DISPATCH(FitFrames)(rings, positions, frames, poisson, begin, end, right, stretch);
    for (int v = begin; v < end; ++v)
        if (stretch(3, v) < 0) {
            // A collapsed ring, or a half turn: rare.
            const SheetRings::Vertex* const vertex = &rings.vertices[v];
            Eigen::Matrix<double, 3, 2> covariance = Eigen::Matrix<double, 3, 2>::Zero();
            Eigen::Matrix2d inverse;
            inverse << vertex->inverse[0], vertex->inverse[1], vertex->inverse[1], vertex->inverse[2];
            for (int k = vertex->firstEdge; k < vertex[1].firstEdge; ++k) {
                const Vec3 edge =
                    (positions.col(rings.edges[k].unknown) - positions.col(vertex->unknown)).head<3>();
                covariance += edge * Eigen::RowVector2d(rings.edges[k].pull[0], rings.edges[k].pull[1]);
            }
            const Eigen::Matrix2d rest = inverse.inverse() - 4e-4 * vertex->area * Eigen::Matrix2d::Identity();
            const LocalFit fit = fitVertex(covariance, rest, vertex->area, frames.col(v), poisson);
            right.col(v) = vertex->area * fit.frame;
            stretch.col(v) << fit.stretch(0, 0), fit.stretch(0, 1), fit.stretch(1, 1), 0;
        }
}

bool frameResiduals(const SheetRings& rings, const Columns& frames, const Columns& right, double bending, int begin,
                    int end, const std::vector<int>& slots, Eigen::Matrix4Xf& residuals)
{
    return HWY_DYNAMIC_DISPATCH(FrameResiduals)(rings, frames, right, bending, begin, end, slots, residuals);
}

void turnFrames(const Columns& frames, const Eigen::Matrix4Xf& turns, const std::vector<int>& slots,
                const Columns& stretch, int begin, int end, Columns& turned, Columns& maps)
{
    HWY_DYNAMIC_DISPATCH(TurnFrames)(frames, turns, slots, stretch, begin, end, turned, maps);
}

void ringForces(const SheetRings& rings, const Columns& positions, const Columns& maps, double stiffness, int begin,
                int end, Columns& forces)
{
    HWY_DYNAMIC_DISPATCH(RingForces)(rings, positions, maps, stiffness, begin, end, forces);
}

} // namespace bolster
#endif
