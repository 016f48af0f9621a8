#include "PackedKernels.h"

#include <algorithm>
#include <cstdlib>

// Debian's compiler has a bug in code that is not used here; without the emulation there is no four-lane fallback.
#define HWY_BROKEN_EMU128 0
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "PackedKernels.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace bolster::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Four = hn::FixedTag<float, 4>; // one unknown
using Wide = hn::CappedTag<float, 16>;
using Vector = hn::Vec<Wide>;
constexpr Four four;
constexpr Wide wide;
constexpr int lanes = static_cast<int>(hn::MaxLanes(Wide()));
constexpr int rowsInVector = lanes / 4;
constexpr int parts = 4 / rowsInVector;           // vectors that hold four rows
constexpr int chunksAtOnce = lanes == 16 ? 4 : 2; // so that additions needn't wait for each other

/// Turns four numbers, one per row, into vectors with each number once per right-hand side.
class Spread {
public:
    HWY_INLINE Spread()
    {
        for (int part = 0; part < parts; ++part) {
            HWY_ALIGN int from[lanes];
            for (int lane = 0; lane < lanes; ++lane)
                from[lane] = part * rowsInVector + lane / 4;
            m_indices[part] = hn::SetTableIndices(wide, from);
        }
    }

    HWY_INLINE Vector operator()(Vector fourNumbers, int part) const
    {
        return hn::TableLookupLanes(fourNumbers, m_indices[part]);
    }

private:
    decltype(hn::SetTableIndices(Wide(), static_cast<const int*>(nullptr))) m_indices[parts];
};

/// The rows of `Chunks` chunks, `stride` numbers apart, times x.
template <int Chunks>
HWY_INLINE void multiply(const Spread& spread, const float* HWY_RESTRICT block, std::size_t stride, int columns,
                         const float* HWY_RESTRICT x, Vector* HWY_RESTRICT sums)
{
    Vector sum[Chunks * parts];
    for (Vector& s : sum)
        s = hn::Zero(wide);
    for (int k = 0; k < columns; ++k) {
        const Vector factor = hn::LoadDup128(wide, x + 4 * k);
        for (int chunk = 0; chunk < Chunks; ++chunk) {
            const Vector rows = hn::LoadDup128(wide, block + chunk * stride + 4 * k);
            for (int part = 0; part < parts; ++part)
                sum[chunk * parts + part] = hn::MulAdd(spread(rows, part), factor, sum[chunk * parts + part]);
        }
    }
    std::copy(sum, sum + Chunks * parts, sums);
}

/// Calls visit(row, fourRightHandSides) for the four rows of a chunk.
template <class V, class Visit>
HWY_INLINE void eachRow(V sums, int row, Visit visit)
{
    constexpr auto count = hn::MaxLanes(hn::DFromV<V>());
    if constexpr (count == 4) {
        visit(row, sums);
    } else {
        constexpr hn::Half<hn::DFromV<V>> half;
        eachRow(hn::LowerHalf(half, sums), row, visit);
        eachRow(hn::UpperHalf(half, sums), row + static_cast<int>(count) / 8, visit);
    }
}

/// The same for a chunk of which only some rows are there.
template <class Visit>
HWY_INLINE void firstRows(const Vector* sums, int count, Visit visit)
{
    for (int part = 0; part < parts; ++part)
        eachRow(sums[part], part * rowsInVector, [&](int row, auto numbers) {
            if (row < count)
                visit(row, numbers);
        });
}

template <int Chunks>
HWY_INLINE void pushDown(const Spread& spread, const PackedNode& node, const float* panel,
                         const std::uint32_t* rows, int from, const float* own, float* x)
{
    Vector sums[Chunks * parts];
    multiply<Chunks>(spread, panel + static_cast<std::size_t>(from) * node.width,
                     4 * static_cast<std::size_t>(node.width), node.width, own, sums);
    for (int v = 0; v < Chunks * parts; ++v)
        eachRow(sums[v], from + v * rowsInVector, [&](int row, auto product) {
            float* const to = x + rows[row];
            hn::Store(hn::Sub(hn::Load(four, to), product), four, to);
        });
}

std::size_t chunkSize(const PackedNode& node, int chunk)
{
    return 4 * static_cast<std::size_t>(std::min(node.width, 4 * chunk + 4));
}

constexpr std::ptrdiff_t prefetched = 2048; // numbers

/// Asks for as much as a node has, so far ahead of it: the processor itself sees nothing coming where a solve goes
/// backwards.
HWY_INLINE void prefetchBefore(const PackedSpans& factor, const PackedNode& node)
{
    if (!factor.streamed)
        return;
    constexpr std::ptrdiff_t line = 16;
    const std::ptrdiff_t size = static_cast<std::ptrdiff_t>(node.panel - node.diagonal) +
                                static_cast<std::ptrdiff_t>(node.width) * node.below;
    const float* const from = factor.values + node.diagonal - prefetched;
    for (std::ptrdiff_t i = 0; i < std::min(size, prefetched); i += line)
        hwy::Prefetch(from + i);
}

void Forward(const PackedSpans& factor, std::span<const PackedNode> nodes, float* x)
{
    const Spread spread;
    for (const PackedNode& node : nodes) {
        float* const own = x + 4 * static_cast<std::size_t>(node.first);
        // The last rows first: what they need of the others is still there.
        const int chunks = (node.width + 3) / 4;
        const float* block = factor.values + node.panel;
        for (int chunk = chunks - 1; chunk >= 0; --chunk) {
            const std::size_t size = chunkSize(node, chunk);
            block -= size;
            Vector sums[parts];
            multiply<1>(spread, block, 0, static_cast<int>(size / 4), own, sums);
            firstRows(sums, node.width - 4 * chunk,
                      [&](int row, auto numbers) { hn::Store(numbers, four, own + 16 * chunk + 4 * row); });
        }
        const float* const panel = factor.values + node.panel;
        const std::uint32_t* const rows = factor.rows + node.rows;
        int from = 0;
        for (; from + 4 * chunksAtOnce < node.below + 4; from += 4 * chunksAtOnce)
            pushDown<chunksAtOnce>(spread, node, panel, rows, from, own, x);
        for (; from + 4 < node.below; from += 8)
            pushDown<2>(spread, node, panel, rows, from, own, x);
        if (from < node.below)
            pushDown<1>(spread, node, panel, rows, from, own, x);
    }
}

using FourVector = hn::Vec<Four>;

/// The rows of a vector added up.
template <class V>
HWY_INLINE FourVector sumOfRows(V rows)
{
    if constexpr (hn::MaxLanes(hn::DFromV<V>()) == 4) {
        return rows;
    } else {
        constexpr hn::Half<hn::DFromV<V>> half;
        return sumOfRows(hn::Add(hn::LowerHalf(half, rows), hn::UpperHalf(half, rows)));
    }
}

/// `Count` unknowns side by side; get(i) has the i-th.
template <int Count, class Get>
HWY_INLINE auto sideBySide(Get get, int first = 0)
{
    if constexpr (Count == 1) {
        return get(first);
    } else {
        const auto lower = sideBySide<Count / 2>(get, first), upper = sideBySide<Count / 2>(get, first + Count / 2);
        return hn::Combine(hn::FixedTag<float, 4 * Count>(), upper, lower);
    }
}

/// Columns column .. column + Columns - 1 of some chunks, transposed, times y: replaces or lessens `out`.
/// y(chunk, part) has `rowsInVector` rows of it.
template <int Columns, bool Lessen, class Offset, class Load>
HWY_INLINE void multiplyTransposed(const Spread& spread, const float* HWY_RESTRICT block, Offset offset,
                                   int firstChunk, int lastChunk, int column, const Load& y, float* out)
{
    Vector sum[Columns];
    for (Vector& s : sum)
        s = hn::Zero(wide);
    for (int chunk = firstChunk; chunk < lastChunk; ++chunk) {
        const float* const numbers = block + offset(chunk) + 4 * column;
        for (int part = 0; part < parts; ++part) {
            const Vector rows = y(chunk, part);
            for (int k = 0; k < Columns; ++k)
                sum[k] = hn::MulAdd(spread(hn::LoadDup128(wide, numbers + 4 * k), part), rows, sum[k]);
        }
    }
    // What is stored together can be loaded together at once.
    constexpr int together = std::min(Columns, rowsInVector);
    constexpr hn::FixedTag<float, 4 * together> tag;
    for (int k = 0; k < Columns; k += together) {
        const auto total = sideBySide<together>([&](int i) { return sumOfRows(sum[k + i]); });
        hn::StoreU(Lessen ? hn::Sub(hn::LoadU(tag, out + 4 * k), total) : total, tag, out + 4 * k);
    }
}

/// All columns of a node.
template <bool Lessen, class Offset, class First, class Load>
HWY_INLINE void multiplyColumns(const Spread& spread, const float* block, int width, Offset offset,
                                First firstChunk, int chunks, const Load& y, float* own)
{
    int k = 0;
    if (Lessen)
        for (; k + 8 <= width; k += 8)
            multiplyTransposed<8, Lessen>(spread, block, offset, firstChunk(k), chunks, k, y, own + 4 * k);
    for (; k + 4 <= width; k += 4)
        multiplyTransposed<4, Lessen>(spread, block, offset, firstChunk(k), chunks, k, y, own + 4 * k);
    if (k + 2 <= width) {
        multiplyTransposed<2, Lessen>(spread, block, offset, firstChunk(k), chunks, k, y, own + 4 * k);
        k += 2;
    }
    if (k < width)
        multiplyTransposed<1, Lessen>(spread, block, offset, firstChunk(k), chunks, k, y, own + 4 * k);
}

void Backward(const PackedSpans& factor, std::span<const PackedNode> nodes, float* x, float* scratch)
{
    const Spread spread;
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
        float* const own = x + 4 * static_cast<std::size_t>(node->first);
        prefetchBefore(factor, *node);
        if (node->below > 0) {
            const std::uint32_t* const rows = factor.rows + node->rows;
            const auto gathered = [&](int from) {
                return sideBySide<rowsInVector>([&](int i) { return hn::Load(four, x + rows[from + i]); });
            };
            const int chunks = (node->below + 3) / 4;
            const float* const panel = factor.values + node->panel;
            const auto offset = [&](int chunk) { return 4 * static_cast<std::size_t>(chunk) * node->width; };
            const auto all = [](int) { return 0; };
            constexpr int narrow = 8;
            if (node->width <= narrow) {
                const auto gather = [&](int chunk, int part) { return gathered(4 * chunk + part * rowsInVector); };
                multiplyColumns<true>(spread, panel, node->width, offset, all, chunks, gather, own);
            } else {
                for (int row = 0; row < 4 * chunks; row += rowsInVector)
                    hn::Store(gathered(row), wide, scratch + 4 * row);
                const auto load = [&](int chunk, int part) {
                    return hn::Load(wide, scratch + 16 * chunk + part * lanes);
                };
                multiplyColumns<true>(spread, panel, node->width, offset, all, chunks, load, own);
            }
        }
        // The first columns first: what they need of the others is still there.
        const auto offset = [](int chunk) { return 8 * static_cast<std::size_t>(chunk) * (chunk + 1); };
        const auto load = [&](int chunk, int part) {
            const int row = 4 * chunk + part * rowsInVector;
            return row + rowsInVector <= node->width
                       ? hn::LoadU(wide, own + 4 * row)
                       : sideBySide<rowsInVector>([&](int i) {
                             return row + i < node->width ? hn::Load(four, own + 4 * (row + i)) : hn::Zero(four);
                         });
        };
        multiplyColumns<false>(
            spread, factor.values + node->diagonal, node->width, offset, [](int k) { return k / 4; },
            (node->width + 3) / 4, load, own);
    }
}

const char* Instructions()
{
    return hwy::TargetName(HWY_TARGET);
}

} // namespace
} // namespace bolster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bolster {

HWY_EXPORT(Forward);
HWY_EXPORT(Backward);
HWY_EXPORT(Instructions);

void solveForward(const PackedSpans& factor, std::span<const PackedNode> nodes, float* x)
{
    HWY_DYNAMIC_DISPATCH(Forward)(factor, nodes, x);
}

void solveBackward(const PackedSpans& factor, std::span<const PackedNode> nodes, float* x, float* scratch)
{
    HWY_DYNAMIC_DISPATCH(Backward)(factor, nodes, x, scratch);
}

const char* packedInstructions()
{
    return HWY_DYNAMIC_DISPATCH(Instructions)();
}

} // namespace bolster
#endif
