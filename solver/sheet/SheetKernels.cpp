#include "SheetKernels.h"

#include "LocalStep.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

// Debian's compiler has a bug in code that is not used here; without the emulation there is no fallback for lanes.
#define HWY_BROKEN_EMU128 0
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "SheetKernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

// Emulated lanes become thousands of instructions, over which a sanitizer's build broods for half a minute. Only a
// test runs them there.
#if defined(__clang__)
#if HWY_TARGET == HWY_EMU128 && (__has_feature(address_sanitizer) || __has_feature(thread_sanitizer))
#pragma clang optimize off
#endif
#endif

HWY_BEFORE_NAMESPACE();
namespace bolster::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// A column: the compiler makes of it what the instruction set has.
using Four [[gnu::vector_size(32), gnu::aligned(8), gnu::may_alias]] = double;
using FourFloats [[gnu::vector_size(16), gnu::aligned(4), gnu::may_alias]] = float;

template <class Number>
HWY_INLINE Number* at(Number* columns, int i)
{
    return columns + 4 * static_cast<std::ptrdiff_t>(i);
}

HWY_INLINE const Four& column(const double* columns, int i)
{
    return *reinterpret_cast<const Four*>(at(columns, i));
}

HWY_INLINE const Four& column(const Columns& columns, int i)
{
    return column(columns.data(), i);
}

HWY_INLINE Four& column(Columns& columns, int i)
{
    return *reinterpret_cast<Four*>(at(columns.data(), i));
}

HWY_INLINE void widen(const FourFloats& numbers, Four& to)
{
#if HWY_MAX_BYTES >= 32 // the compiler takes four instructions for one
    constexpr hn::FixedTag<double, 4> four;
    constexpr hn::Rebind<float, decltype(four)> fourFloats;
    const auto from = hn::LoadU(fourFloats, reinterpret_cast<const float*>(&numbers));
    hn::StoreU(hn::PromoteTo(four, from), four, reinterpret_cast<double*>(&to));
#else
    to = __builtin_convertvector(numbers, Four);
#endif
}

HWY_INLINE void widen(const float* numbers, Four& to)
{
    widen(*reinterpret_cast<const FourFloats*>(numbers), to);
}

HWY_INLINE void narrow(const Four& numbers, float* to)
{
    *reinterpret_cast<FourFloats*>(to) = __builtin_convertvector(numbers, FourFloats);
}

/// Adds a column times a number.
HWY_INLINE void add(const Four& numbers, float times, Four& to)
{
    Four by;
    widen(FourFloats{times, times, times, times}, by);
    to += numbers * by;
}

#if HWY_MAX_BYTES >= 64

/// Two columns that numbers of an edge times columns of its other end are added to: both in one register.
class ColumnPair {
public:
    HWY_INLINE ColumnPair()
        : m_sum(hn::Zero(eight))
    {}

    /// pull[0] and pull[1] times one column.
    HWY_INLINE void add(const Four& column, const float* pull)
    {
        const auto half = hn::LoadU(four, reinterpret_cast<const double*>(&column));
        m_sum = hn::MulAdd(hn::Combine(eight, half, half), spread(pull), m_sum);
    }
    /// pull[0] times the first, pull[1] times the second column.
    HWY_INLINE void add(const float* columns, const float* pull)
    {
        m_sum = hn::MulAdd(hn::PromoteTo(eight, hn::LoadU(floats, columns)), spread(pull), m_sum);
    }
    HWY_INLINE void store(Four& first, Four& second) const
    {
        hn::StoreU(hn::LowerHalf(four, m_sum), four, reinterpret_cast<double*>(&first));
        hn::StoreU(hn::UpperHalf(four, m_sum), four, reinterpret_cast<double*>(&second));
    }

private:
    static constexpr hn::FixedTag<double, 8> eight{};
    static constexpr hn::FixedTag<double, 4> four{};
    static constexpr hn::FixedTag<float, 8> floats{};

    /// The first number four times, then the second.
    static HWY_INLINE hn::Vec<hn::FixedTag<double, 8>> spread(const float* pull)
    {
        std::int64_t pair = 0;
        std::memcpy(&pair, pull, sizeof pair);
        const auto both = hn::BitCast(floats, hn::Set(hn::FixedTag<std::int64_t, 4>(), pair));
        alignas(32) static constexpr std::int32_t order[8] = {0, 0, 0, 0, 1, 1, 1, 1};
        return hn::PromoteTo(eight, hn::TableLookupLanes(both, hn::SetTableIndices(floats, order)));
    }

    hn::Vec<hn::FixedTag<double, 8>> m_sum;
};

#else

/// Two columns that numbers of an edge times columns of its other end are added to.
class ColumnPair {
public:
    /// pull[0] and pull[1] times one column.
    HWY_INLINE void add(const Four& column, const float* pull)
    {
        bolster::HWY_NAMESPACE::add(column, pull[0], m_first);
        bolster::HWY_NAMESPACE::add(column, pull[1], m_second);
    }
    /// pull[0] times the first, pull[1] times the second column.
    HWY_INLINE void add(const float* columns, const float* pull)
    {
        Four first, second;
        widen(columns, first);
        widen(columns + 4, second);
        bolster::HWY_NAMESPACE::add(first, pull[0], m_first);
        bolster::HWY_NAMESPACE::add(second, pull[1], m_second);
    }
    HWY_INLINE void store(Four& first, Four& second) const
    {
        first = m_first;
        second = m_second;
    }

private:
    Four m_first{}, m_second{};
};

#endif

// Vertices that are worked on together: so many that what was stored for the first can be loaded in wider
// registers.
constexpr int block = 32;

// One number of each vertex of a block.
using Wide = hn::CappedTag<double, 8>;
using Vector = hn::Vec<Wide>;
using WideFloats = hn::Rebind<float, Wide>;
constexpr Wide wide;
constexpr WideFloats wideFloats;
constexpr int lanes = static_cast<int>(hn::MaxLanes(Wide()));
// Of a ring's weight: so far its frames are apart where one may lie in the opposite hemisphere.
constexpr double farApart = 0.05;

/// A column of each vertex of a block.
struct alignas(64) BlockColumns {
    double numbers[block][4];

    HWY_INLINE Four& operator[](int i) { return *reinterpret_cast<Four*>(numbers[i]); }
};

/// The same, turned: a vector for each row.
struct Rows {
    Vector w, x, y, z;

    HWY_INLINE Rows(Vector a, Vector b, Vector c, Vector d)
        : w(a)
        , x(b)
        , y(c)
        , z(d)
    {}
    HWY_INLINE explicit Rows(const double* columns) { hn::LoadInterleaved4(wide, columns, w, x, y, z); }
};

HWY_INLINE Vector inner(const Rows& a, const Rows& b)
{
    return hn::MulAdd(a.w, b.w, hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z))));
}

HWY_INLINE void store(Vector w, Vector x, Vector y, Vector z, double* columns)
{
    hn::StoreInterleaved4(w, x, y, z, wide, columns);
}

/// A rough start, and Newton's method until it is right but for the last bits: quicker than divisions and roots.
/// Not for numbers beyond what single precision can hold.
template <class Step>
HWY_INLINE Vector refined(hn::Vec<WideFloats> rough, const Step& step)
{
    return step(step(hn::PromoteTo(wide, rough)));
}

/// 1 / x.
HWY_INLINE Vector reciprocal(Vector x)
{
    return refined(hn::ApproximateReciprocal(hn::DemoteTo(wideFloats, x)),
                   [&](Vector r) { return hn::Mul(r, hn::NegMulAdd(x, r, hn::Set(wide, 2.0))); });
}

/// 1 / sqrt(x).
HWY_INLINE Vector reciprocalRoot(Vector x)
{
    const Vector half = hn::Mul(hn::Set(wide, 0.5), x);
    return refined(hn::ApproximateReciprocalSqrt(hn::DemoteTo(wideFloats, x)),
                   [&](Vector r) { return hn::Mul(r, hn::NegMulAdd(hn::Mul(half, r), r, hn::Set(wide, 1.5))); });
}

struct Rotated {
    Vector x, y, z;
};

HWY_INLINE Vector inner(const Rotated& a, const Rotated& b)
{
    return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}

/// Two columns of a rotation matrix.
struct TwoColumns {
    Rotated first, second;
};

HWY_INLINE TwoColumns rotated(const Rows& q)
{
    const Vector one = hn::Set(wide, 1.0), two = hn::Set(wide, 2.0);
    const auto twiceSum = [&](Vector a, Vector b, Vector c, Vector d) {
        return hn::Mul(two, hn::MulAdd(a, b, hn::Mul(c, d)));
    };
    const auto twiceDifference = [&](Vector a, Vector b, Vector c, Vector d) {
        return hn::Mul(two, hn::MulSub(a, b, hn::Mul(c, d)));
    };
    return {{hn::Sub(one, twiceSum(q.y, q.y, q.z, q.z)), twiceSum(q.x, q.y, q.w, q.z),
             twiceDifference(q.x, q.z, q.w, q.y)},
            {twiceDifference(q.x, q.y, q.w, q.z), hn::Sub(one, twiceSum(q.x, q.x, q.z, q.z)),
             twiceSum(q.y, q.z, q.w, q.x)}};
}

HWY_INLINE Rotated combine(const Rotated& a, Vector p, const Rotated& b, Vector q)
{
    return {hn::MulAdd(a.x, p, hn::Mul(b.x, q)), hn::MulAdd(a.y, p, hn::Mul(b.y, q)),
            hn::MulAdd(a.z, p, hn::Mul(b.z, q))};
}

struct FitBlock {
    const double* frames; // in
    BlockColumns covariance[2];
    BlockColumns smoothing;                 // of the neighbours alone
    BlockColumns fitted, residual, stretch; // out; the last number of a stretch is -1 where the closed form fails
};

/// What is found of some vertices, or of all of them.
struct Found {
    bool near = true;  ///< neighbours' frames are near each other
    bool sound = true; ///< the closed form has worked
};

/// fitVertex of LocalStep for a register of vertices, and the residual of L2.
HWY_INLINE void fit(FitBlock& in, int from, const SheetRings& rings, int vertex, double poisson, double bending,
                    Found& found)
{
    const auto load = [&](const std::vector<float>& numbers) {
        return hn::PromoteTo(wide, hn::LoadU(wideFloats, numbers.data() + vertex));
    };
    const Vector one = hn::Set(wide, 1.0);
    const Rows q(in.frames + 4 * static_cast<std::ptrdiff_t>(from));
    const Vector ringArea = load(rings.area);
    const Vector pull = hn::Mul(hn::Set(wide, ringRegularisation), ringArea);
    const TwoColumns before = rotated(q);
    const auto regular = [&](const Rows& c, const Rotated& r) {
        return Rotated{hn::MulAdd(pull, r.x, c.w), hn::MulAdd(pull, r.y, c.x), hn::MulAdd(pull, r.z, c.y)};
    };
    const Rotated g0 = regular(Rows(in.covariance[0].numbers[from]), before.first);
    const Rotated g1 = regular(Rows(in.covariance[1].numbers[from]), before.second);
    const Rotated normal{hn::MulSub(g0.y, g1.z, hn::Mul(g0.z, g1.y)), hn::MulSub(g0.z, g1.x, hn::Mul(g0.x, g1.z)),
                         hn::MulSub(g0.x, g1.y, hn::Mul(g0.y, g1.x))};
    const Vector squaredArea = inner(normal, normal);
    const Vector unit = reciprocalRoot(squaredArea), area = hn::Mul(squaredArea, unit);
    const Vector m00 = hn::Add(inner(g0, g0), area), m11 = hn::Add(inner(g1, g1), area), m01 = inner(g0, g1);
    const Vector determinant = hn::MulSub(m00, m11, hn::Mul(m01, m01));
    const Vector trace = hn::Add(m00, m11);
    const Vector scale = hn::Mul(hn::Mul(trace, reciprocalRoot(trace)), reciprocal(determinant));
    const Vector s00 = hn::Mul(m11, scale), s11 = hn::Mul(m00, scale), s01 = hn::Neg(hn::Mul(m01, scale));
    const Rotated r0 = combine(g0, s00, g1, s01), r1 = combine(g0, s01, g1, s11);
    const Rotated r2{hn::Mul(normal.x, unit), hn::Mul(normal.y, unit), hn::Mul(normal.z, unit)};

    // (K + I) q, see quaternionNear().
    const Vector wx = hn::Sub(r1.z, r2.y), wy = hn::Sub(r2.x, r0.z), wz = hn::Sub(r0.y, r1.x);
    const Vector xy = hn::Add(r0.y, r1.x), xz = hn::Add(r0.z, r2.x), yz = hn::Add(r1.z, r2.y);
    const auto row = [&](Vector a, Vector b, Vector c, Vector d) {
        return hn::MulAdd(a, q.w, hn::MulAdd(b, q.x, hn::MulAdd(c, q.y, hn::Mul(d, q.z))));
    };
    const Vector plus = hn::Add(one, r0.x), minus = hn::Sub(one, r0.x);
    const Vector sum = hn::Add(r1.y, r2.z), difference = hn::Sub(r1.y, r2.z);
    Vector f[4] = {row(hn::Add(plus, sum), wx, wy, wz), row(wx, hn::Sub(plus, sum), xy, xz),
                   row(wy, xy, hn::Add(minus, difference), yz), row(wz, xz, yz, hn::Sub(minus, difference))};
    const Vector square =
        hn::MulAdd(f[0], f[0], hn::MulAdd(f[1], f[1], hn::MulAdd(f[2], f[2], hn::Mul(f[3], f[3]))));
    const Vector toUnit = reciprocalRoot(square);
    for (Vector& number : f)
        number = hn::Mul(number, toUnit);
    store(f[0], f[1], f[2], f[3], in.fitted.numbers[from]);
    const Vector weight = hn::LoadU(wide, rings.weight.data() + vertex);
    const Rows neighbours(in.smoothing.numbers[from]);
    const Rows smoothing(hn::NegMulAdd(weight, q.w, neighbours.w), hn::NegMulAdd(weight, q.x, neighbours.x),
                         hn::NegMulAdd(weight, q.y, neighbours.y), hn::NegMulAdd(weight, q.z, neighbours.z));
    const Vector along = inner(q, smoothing);
    found.near = found.near && hn::AllFalse(wide, hn::Lt(along, hn::Mul(hn::Set(wide, -farApart), weight)));
    const auto residual = [&](Vector wanted, Vector now, Vector smooth) {
        return hn::MulAdd(ringArea, hn::Sub(wanted, now), hn::Mul(hn::Set(wide, bending), smooth));
    };
    store(residual(f[0], q.w, smoothing.w), residual(f[1], q.x, smoothing.x), residual(f[2], q.y, smoothing.y),
          residual(f[3], q.z, smoothing.z), in.residual.numbers[from]);

    const Vector i00 = load(rings.inverse[0]), i01 = load(rings.inverse[1]), i11 = load(rings.inverse[2]);
    const Rotated f0 = combine(g0, i00, g1, i01), f1 = combine(g0, i01, g1, i11);
    const auto clamped = [](Vector strain) {
        return hn::Clamp(strain, hn::Set(wide, -largestAnsweredStrain), hn::Set(wide, largestAnsweredStrain));
    };
    const Vector nu = hn::Set(wide, poisson);
    const Vector xxStrain = clamped(hn::Sub(inner(r0, f0), one)), yyStrain = clamped(hn::Sub(inner(r1, f1), one));
    const Vector xyStrain = clamped(hn::Mul(hn::Set(wide, 0.5), hn::Add(inner(r0, f1), inner(r1, f0))));
    const auto sound =
        hn::And(hn::And(hn::Gt(area, hn::Zero(wide)), hn::Gt(square, hn::Set(wide, 1e-12))),
                hn::And(hn::Gt(determinant, hn::Zero(wide)), hn::Lt(determinant, hn::Set(wide, 1e36))));
    found.sound = found.sound && hn::AllTrue(wide, sound);
    store(hn::Neg(hn::Mul(nu, yyStrain)), hn::Mul(nu, xyStrain), hn::Neg(hn::Mul(nu, xxStrain)),
          hn::IfThenElse(sound, hn::Zero(wide), hn::Set(wide, -1.0)), in.stretch.numbers[from]);
}

/// Whether the frames of these vertices lie in their neighbours' hemispheres.
bool hemispheresAgree(const SheetRings& rings, const Columns& frames, int begin, int end)
{
    for (int v = begin; v < end; ++v)
        for (int k = rings.vertices[v].firstEdge; k < rings.vertices[v + 1].firstEdge; ++k)
            if (frames.col(v).dot(frames.col(rings.edges[k].vertex)) < 0)
                return false;
    return true;
}

/// False when the closed form has failed somewhere. Tells whether all neighbours' quaternions `agree`.
bool FitFrames(const SheetRings& rings, const Columns& positions, const Columns& frames, double poisson,
               double bending, int begin, int end, const SheetResults& to, bool& agree)
{
    FitBlock in{};
    BlockColumns rest; // frames of a block that is not full
    std::fill_n(rest.numbers[0], 4 * block, 0.5);
    bool sound = true;
    for (int first = begin; first < end; first += block) {
        const int count = std::min(block, end - first);
        Found found;
        for (int i = 0; i < count; ++i) {
            const SheetRings::Vertex* const vertex = &rings.vertices[first + i];
            const Four here = column(positions, vertex->unknown);
            ColumnPair covariance;
            Four smoothing{};
            for (int k = vertex->firstEdge; k < vertex[1].firstEdge; ++k) {
                const SheetRings::Edge& edge = rings.edges[k];
                const Four apart = column(positions, edge.unknown) - here;
                covariance.add(apart, edge.pull);
                add(column(frames, edge.vertex), edge.weight, smoothing);
            }
            covariance.store(in.covariance[0][i], in.covariance[1][i]);
            in.smoothing[i] = smoothing;
        }
        in.frames = at(frames.data(), first);
        if (count < block) {
            std::copy_n(in.frames, 4 * count, rest.numbers[0]);
            in.frames = rest.numbers[0];
        }
        for (int from = 0; from < count; from += lanes)
            fit(in, from, rings, first + from, poisson, bending, found);
        sound = sound && found.sound;
        agree = agree && (found.near || hemispheresAgree(rings, frames, first, first + count));
        for (int i = 0; i < count; ++i) {
            narrow(in.residual[i], at(to.turns, to.turnSlots[first + i]));
            narrow(in.stretch[i], at(to.stretch, first + i));
            if (to.fitted)
                *reinterpret_cast<Four*>(at(to.fitted, first + i)) =
                    in.fitted[i] * static_cast<double>(rings.area[first + i]);
        }
    }
    return sound;
}

HWY_INLINE Rows sum(const Rows& a, Vector p, const Rows& b, Vector q)
{
    const auto one = [&](Vector x, Vector y) { return hn::MulAdd(x, p, hn::Mul(y, q)); };
    return {one(a.w, b.w), one(a.x, b.x), one(a.y, b.y), one(a.z, b.z)};
}

HWY_INLINE Rows normalised(const Rows& q)
{
    const Vector by = reciprocalRoot(inner(q, q));
    return {hn::Mul(q.w, by), hn::Mul(q.x, by), hn::Mul(q.y, by), hn::Mul(q.z, by)};
}

HWY_INLINE void store(const Rows& rows, double* columns)
{
    store(rows.w, rows.x, rows.y, rows.z, columns);
}

struct TurnBlock {
    BlockColumns turns;   // in
    BlockColumns maps[2]; // out
};

/// Columns in single precision.
HWY_INLINE Rows widened(const float* columns)
{
    hn::Vec<WideFloats> w, x, y, z;
    hn::LoadInterleaved4(wideFloats, columns, w, x, y, z);
    return {hn::PromoteTo(wide, w), hn::PromoteTo(wide, x), hn::PromoteTo(wide, y), hn::PromoteTo(wide, z)};
}

HWY_INLINE void storeNarrow(const Rows& rows, float* columns)
{
    hn::StoreInterleaved4(hn::DemoteTo(wideFloats, rows.w), hn::DemoteTo(wideFloats, rows.x),
                          hn::DemoteTo(wideFloats, rows.y), hn::DemoteTo(wideFloats, rows.z), wideFloats, columns);
}

/// Turns `ahead`, and makes of it the frames `beta` of the step further on.
HWY_INLINE void turn(TurnBlock& in, int from, double beta, const float* stretch, double* ahead, float* back)
{
    const Vector one = hn::Set(wide, 1.0);
    double* const numbers = at(ahead, from);
    const Rows asked(numbers), before = sum(asked, one, widened(at(back, from)), one);
    const Rows wanted = sum(Rows(in.turns.numbers[from]), one, asked, one);
    const Vector square = inner(wanted, wanted);
    const auto turns = hn::And(hn::Gt(square, hn::Set(wide, 1e-24)), hn::Lt(square, hn::Set(wide, 1e24)));
    const auto choose = [&](Vector now, Vector otherwise) { return hn::IfThenElse(turns, now, otherwise); };
    const Rows q = normalised({choose(wanted.w, asked.w), choose(wanted.x, asked.x), choose(wanted.y, asked.y),
                               choose(wanted.z, asked.z)});
    // Their signs may be opposite.
    const Vector less = hn::CopySign(hn::Set(wide, -beta), hn::Neg(inner(q, before)));
    const Rows next = normalised(sum(q, hn::Set(wide, 1 + beta), before, less));
    store(next, numbers);
    storeNarrow(sum(q, one, next, hn::Set(wide, -1.0)), at(back, from));

    const Rows t = widened(at(stretch, from));
    const TwoColumns r = rotated(q);
    const Rotated m0 = combine(r.first, hn::Add(one, t.w), r.second, t.x);
    const Rotated m1 = combine(r.first, t.x, r.second, hn::Add(one, t.y));
    store(m0.x, m0.y, m0.z, hn::Zero(wide), in.maps[0].numbers[from]);
    store(m1.x, m1.y, m1.z, hn::Zero(wide), in.maps[1].numbers[from]);
}

void TurnFrames(double beta, int begin, int end, const SheetResults& results, Columns& ahead,
                Eigen::Matrix4Xf& back, Eigen::Matrix4Xf& maps)
{
    TurnBlock in{};
    // Of a block that is not full.
    BlockColumns frames{};
    alignas(64) float steps[4 * block] = {}, stretch[4 * block] = {};
    for (int first = begin; first < end; first += block) {
        const int count = std::min(block, end - first);
        for (int i = 0; i < count; ++i)
            widen(at(results.turns, results.turnSlots[first + i]), in.turns[i]);
        double* const aheadHere = at(ahead.data(), first);
        float* const backHere = at(back.data(), first);
        const float* const stretchHere = at(results.stretch, first);
        if (count == block) {
            for (int from = 0; from < count; from += lanes)
                turn(in, from, beta, stretchHere, aheadHere, backHere);
        } else {
            std::copy_n(aheadHere, 4 * count, frames.numbers[0]);
            std::copy_n(backHere, 4 * count, steps);
            std::copy_n(stretchHere, 4 * count, stretch);
            for (int from = 0; from < count; from += lanes)
                turn(in, from, beta, stretch, frames.numbers[0], steps);
            std::copy_n(frames.numbers[0], 4 * count, aheadHere);
            std::copy_n(steps, 4 * count, backHere);
        }
        for (int i = 0; i < count; ++i) {
            narrow(in.maps[0][i], at(maps.data(), 2 * (first + i)));
            narrow(in.maps[1][i], at(maps.data(), 2 * (first + i) + 1));
        }
    }
}

void RingForces(const SheetRings& rings, const Columns& positions, const Eigen::Matrix4Xf& maps, double stiffness,
                int begin, int end, const SheetResults& to)
{
    for (int v = begin; v < end; ++v) {
        const SheetRings::Vertex* const vertex = &rings.vertices[v];
        const Four here = column(positions, vertex->unknown);
        Four places{};
        ColumnPair turned;
        for (int k = vertex->firstEdge; k < vertex[1].firstEdge; ++k) {
            const SheetRings::Edge& edge = rings.edges[k];
            add(column(positions, edge.unknown) - here, edge.weight, places);
            turned.add(at(maps.data(), 2 * edge.vertex), edge.pull);
        }
        Four first, second;
        turned.store(first, second);
        const Vec2& pull = rings.pull[v];
        Four own;
        widen(at(maps.data(), 2 * v), own);
        first += own * pull.x();
        widen(at(maps.data(), 2 * v + 1), own);
        second += own * pull.y();
        Four force = (places * 2 - (first + second)) * stiffness;
        if (to.outer)
            force += *reinterpret_cast<const Four*>(at(to.outer, v));
        if (to.moveSlots[v] >= 0)
            narrow(force, at(to.moves, to.moveSlots[v]));
        else
            narrow(force, at(to.forces, v));
    }
}

Moved MovePositions(const PositionSlots& unknowns, const float* moves, double step, double beta, int begin, int end,
                    Columns& ahead, Eigen::Matrix4Xf& back)
{
    Moved moved;
    Four overshoot{};
    for (int u = begin; u < end; ++u) {
        Four stepped, was;
        widen(at(moves, unknowns.slots[u]), stepped);
        stepped *= step;
        widen(at(back.data(), u), was);
        const Four move = stepped - was, squares = move * move;
        const double size = ((squares[0] + squares[1]) + (squares[2] + squares[3])) * unknowns.scale[u];
        if (!(size < mostMove * mostMove)) {
            moved.bounded = false;
            continue;
        }
        const Four beyond = move * beta;
        column(ahead, u) += stepped + beyond;
        narrow(-beyond, at(back.data(), u));
        overshoot -= stepped * move;
        moved.farthest = std::max(moved.farthest, size);
    }
    moved.overshoot = (overshoot[0] + overshoot[1]) + (overshoot[2] + overshoot[3]);
    return moved;
}

} // namespace
} // namespace bolster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if defined(__clang__)
#pragma clang optimize on
#endif

#if HWY_ONCE
namespace bolster {

HWY_EXPORT(FitFrames);
HWY_EXPORT(TurnFrames);
HWY_EXPORT(RingForces);
HWY_EXPORT(MovePositions);

namespace {

/// A collapsed ring, or a half turn: rare.
void fitSlowly(const SheetRings& rings, const Columns& positions, const Columns& frames, double poisson,
               double bending, int v, const SheetResults& to)
{
    const SheetRings::Vertex* const vertex = &rings.vertices[v];
    const Eigen::Vector4d frame = frames.col(v);
    Eigen::Matrix<double, 3, 2> covariance = Eigen::Matrix<double, 3, 2>::Zero();
    Eigen::Vector4d smoothing = Eigen::Vector4d::Zero();
    for (int k = vertex->firstEdge; k < vertex[1].firstEdge; ++k) {
        const SheetRings::Edge& ring = rings.edges[k];
        const Vec3 edge = (positions.col(ring.unknown) - positions.col(vertex->unknown)).head<3>();
        covariance += edge * Eigen::RowVector2f(ring.pull[0], ring.pull[1]).cast<double>();
        smoothing += static_cast<double>(ring.weight) * (frames.col(ring.vertex) - frame);
    }
    Eigen::Matrix2d inverse;
    inverse << rings.inverse[0][v], rings.inverse[1][v], rings.inverse[1][v], rings.inverse[2][v];
    const double area = rings.area[v];
    const Eigen::Matrix2d rest = inverse.inverse() - ringRegularisation * area * Eigen::Matrix2d::Identity();
    const LocalFit fit = fitVertex(covariance, rest, area, frame, poisson);
    using Four = Eigen::Map<Eigen::Vector4d>;
    using FourFloats = Eigen::Map<Eigen::Vector4f>;
    const auto column = [](auto* numbers, int i) { return numbers + 4 * static_cast<std::ptrdiff_t>(i); };
    FourFloats(column(to.turns, to.turnSlots[v])) =
        (area * (fit.frame - frame) + bending * smoothing).cast<float>();
    FourFloats(column(to.stretch, v)) =
        Eigen::Vector4d(fit.stretch(0, 0) - 1, fit.stretch(0, 1), fit.stretch(1, 1) - 1, 0).cast<float>();
    if (to.fitted)
        Four(column(to.fitted, v)) = area * fit.frame;
}

} // namespace

void SheetRings::measure(const SewnMesh& mesh, WorkerPool& pool)
{
    const auto& unknown = mesh.topology->unknown;
    const std::size_t padded = mesh.area.size() + 8; // whole registers are read
    edges.resize(mesh.ring.size());
    vertices.resize(mesh.area.size() + 1);
    area.resize(padded, 1);
    for (auto& numbers : inverse)
        numbers.resize(padded, 1);
    weight.resize(padded, 0);
    pull.resize(mesh.area.size());
    pool.forChunks(mesh.vertexCount(), [&](int, int begin, int end) {
        for (int v = begin; v < end; ++v) {
            vertices[v] = {static_cast<int>(unknown[v]), mesh.ringStart[v]};
            weight[v] = 0;
            pull[v] = Vec2::Zero();
            Eigen::Matrix2d rest = ringRegularisation * mesh.area[v] * Eigen::Matrix2d::Identity();
            for (int k = mesh.ringStart[v]; k < mesh.ringStart[v + 1]; ++k) {
                const SewnMesh::RingEdge& ring = mesh.ring[k];
                const Vec2 there = mesh.along(v, ring), towards = ring.weight * there;
                edges[k] = {ring.vertex,
                            static_cast<int>(unknown[ring.vertex]),
                            ring.weight,
                            {static_cast<float>(towards.x()), static_cast<float>(towards.y())}};
                // Of what was rounded, or a sum of differences is no longer the difference of sums.
                weight[v] += static_cast<double>(edges[k].weight);
                pull[v] += Eigen::Vector2f(edges[k].pull[0], edges[k].pull[1]).cast<double>();
                rest += towards * there.transpose();
            }
            const Eigen::Matrix2f inverted = rest.inverse().cast<float>();
            inverse[0][v] = inverted(0, 0);
            inverse[1][v] = inverted(0, 1);
            inverse[2][v] = inverted(1, 1);
            area[v] = static_cast<float>(mesh.area[v]);
        }
    });
    vertices.back() = {0, static_cast<int>(edges.size())};
}

bool fitFrames(const SheetRings& rings, const Columns& positions, const Columns& frames, double poisson,
               double bending, int begin, int end, const SheetResults& to)
{
    bool agree = true;
    const bool sound =
        HWY_DYNAMIC_DISPATCH(FitFrames)(rings, positions, frames, poisson, bending, begin, end, to, agree);
    for (int v = begin; !sound && v < end; ++v)
        if (to.stretch[4 * static_cast<std::ptrdiff_t>(v) + 3] < 0)
            fitSlowly(rings, positions, frames, poisson, bending, v, to);
    return agree;
}

void turnFrames(double beta, int begin, int end, const SheetResults& results, Columns& ahead,
                Eigen::Matrix4Xf& back, Eigen::Matrix4Xf& maps)
{
    HWY_DYNAMIC_DISPATCH(TurnFrames)(beta, begin, end, results, ahead, back, maps);
}

void ringForces(const SheetRings& rings, const Columns& positions, const Eigen::Matrix4Xf& maps, double stiffness,
                int begin, int end, const SheetResults& to)
{
    HWY_DYNAMIC_DISPATCH(RingForces)(rings, positions, maps, stiffness, begin, end, to);
}

Moved movePositions(const PositionSlots& unknowns, const float* moves, double step, double beta, int begin, int end,
                    Columns& ahead, Eigen::Matrix4Xf& back)
{
    return HWY_DYNAMIC_DISPATCH(MovePositions)(unknowns, moves, step, beta, begin, end, ahead, back);
}

} // namespace bolster
#endif
