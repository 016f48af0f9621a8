#include "PackedKernels.h"

#include <algorithm>

// Debian's compiler has a bug in code that is not used here; without the emulation there is no four-lane fallback.
#define HWY_BROKEN_EMU128 0
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "PackedKernels.cpp"
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

HWY_INLINE void store(const Vector* sums, float* fourRows)
{
    for (int part = 0; part < parts; ++part)
        hn::Store(sums[part], wide, fourRows + part * lanes);
}

template <int Chunks>
HWY_INLINE void pushDown(const Spread& spread, const PackedNode& node, const float* panel, const int* rows,
                         int from, const float* own, float* x, int outside, float* spill)
{
    Vector sums[Chunks * parts];
    multiply<Chunks>(spread, panel + static_cast<std::size_t>(from) * node.width,
                     4 * static_cast<std::size_t>(node.width), node.width, own, sums);
    HWY_ALIGN float products[16];
    for (int chunk = 0; chunk < Chunks; ++chunk) {
        store(sums + chunk * parts, products);
        const int* at = rows + from + 4 * chunk;
        const int count = std::min(4, node.below - from - 4 * chunk);
        for (int r = 0; r < count; ++r) {
            float* to = spill && at[r] >= outside ? spill + 4 * static_cast<std::size_t>(at[r] - outside)
                                                  : x + 4 * static_cast<std::size_t>(at[r]);
            hn::Store(hn::Sub(hn::Load(four, to), hn::Load(four, products + 4 * r)), four, to);
        }
    }
}

std::size_t chunkSize(const PackedNode& node, int chunk)
{
    return 4 * static_cast<std::size_t>(std::min(node.width, 4 * chunk + 4));
}

void Forward(const PackedView& factor, std::span<const PackedNode> nodes, float* x, int outside, float* spill)
{
    const Spread spread;
    HWY_ALIGN float products[16];
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
            store(sums, products);
            const int count = std::min(4, node.width - 4 * chunk);
            for (int r = 0; r < count; ++r)
                hn::Store(hn::Load(four, products + 4 * r), four, own + 16 * chunk + 4 * r);
        }
        const float* const panel = factor.values + node.panel;
        const int* const rows = factor.rows + node.rows;
        int from = 0;
        for (; from + 4 * chunksAtOnce < node.below + 4; from += 4 * chunksAtOnce)
            pushDown<chunksAtOnce>(spread, node, panel, rows, from, own, x, outside, spill);
        for (; from < node.below; from += 4)
            pushDown<1>(spread, node, panel, rows, from, own, x, outside, spill);
    }
}

/// Columns column .. column + Columns - 1 of some chunks, transposed, times y: replaces or lessens `out`.
template <int Columns, bool Lessen, class Offset>
HWY_INLINE void multiplyTransposed(const Spread& spread, const float* HWY_RESTRICT block, Offset offset,
                                   int firstChunk, int lastChunk, int column, const float* HWY_RESTRICT y,
                                   float* out)
{
    Vector sum[Columns];
    for (Vector& s : sum)
        s = hn::Zero(wide);
    for (int chunk = firstChunk; chunk < lastChunk; ++chunk) {
        const float* const numbers = block + offset(chunk) + 4 * column;
        for (int part = 0; part < parts; ++part) {
            const Vector rows = hn::LoadU(wide, y + 16 * chunk + part * lanes);
            for (int k = 0; k < Columns; ++k)
                sum[k] = hn::MulAdd(spread(hn::LoadDup128(wide, numbers + 4 * k), part), rows, sum[k]);
        }
    }
    HWY_ALIGN float rows[16];
    for (int k = 0; k < Columns; ++k) {
        hn::Store(sum[k], wide, rows);
        auto total = hn::Load(four, rows);
        for (int row = 1; row < rowsInVector; ++row)
            total = hn::Add(total, hn::Load(four, rows + 4 * row));
        if (Lessen)
            total = hn::Sub(hn::Load(four, out + 4 * k), total);
        hn::Store(total, four, out + 4 * k);
    }
}

void Backward(const PackedView& factor, std::span<const PackedNode> nodes, float* x, float* scratch)
{
    const Spread spread;
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
        float* const own = x + 4 * static_cast<std::size_t>(node->first);
        if (node->below > 0) {
            const int* const rows = factor.rows + node->rows;
            for (int r = 0; r < node->below; ++r)
                hn::Store(hn::Load(four, x + 4 * static_cast<std::size_t>(rows[r])), four, scratch + 4 * r);
            std::fill_n(scratch + 4 * static_cast<std::size_t>(node->below), 16, 0.0F);
            const float* const panel = factor.values + node->panel;
            const int chunks = (node->below + 3) / 4;
            const auto offset = [&](int chunk) { return 4 * static_cast<std::size_t>(chunk) * node->width; };
            int k = 0;
            for (; k + 8 <= node->width; k += 8)
                multiplyTransposed<8, true>(spread, panel, offset, 0, chunks, k, scratch, own + 4 * k);
            for (; k + 4 <= node->width; k += 4)
                multiplyTransposed<4, true>(spread, panel, offset, 0, chunks, k, scratch, own + 4 * k);
            for (; k < node->width; ++k)
                multiplyTransposed<1, true>(spread, panel, offset, 0, chunks, k, scratch, own + 4 * k);
        }
        std::copy_n(own, 4 * static_cast<std::size_t>(node->width), scratch);
        std::fill_n(scratch + 4 * static_cast<std::size_t>(node->width), 16, 0.0F);
        const float* const block = factor.values + node->diagonal;
        const int chunks = (node->width + 3) / 4;
        const auto offset = [](int chunk) { return 8 * static_cast<std::size_t>(chunk) * (chunk + 1); };
        int k = 0;
        for (; k + 4 <= node->width; k += 4)
            multiplyTransposed<4, false>(spread, block, offset, k / 4, chunks, k, scratch, own + 4 * k);
        for (; k < node->width; ++k)
            multiplyTransposed<1, false>(spread, block, offset, k / 4, chunks, k, scratch, own + 4 * k);
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

void solveForward(const PackedView& factor, std::span<const PackedNode> nodes, float* x, int outside, float* spill)
{
    HWY_DYNAMIC_DISPATCH(Forward)(factor, nodes, x, outside, spill);
}

void solveBackward(const PackedView& factor, std::span<const PackedNode> nodes, float* x, float* scratch)
{
    HWY_DYNAMIC_DISPATCH(Backward)(factor, nodes, x, scratch);
}

const char* packedInstructions()
{
    return HWY_DYNAMIC_DISPATCH(Instructions)();
}

} // namespace bolster
#endif
