#include "IsoSurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace bolster {

namespace {

/// A corner of a cube, 0 to 7: x + 2 y + 4 z. Each tetrahedron goes along the axes from 0 to 7 in one of the six
/// orders (Kuhn), so that cubes meet in the same diagonals.
constexpr int tetrahedra[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7},
                                  {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};

class Marching {
public:
    Marching(const VoxelGrid& grid, const std::vector<float>& values)
        : m_grid(grid)
        , m_values(values)
    {}

    void cube(int x, int y, int z);
    TriangleMesh take() { return std::move(m_mesh); }

private:
    struct Corner {
        std::size_t node = 0;
        Vec3 place = Vec3::Zero();
        float value = 0;
    };

    std::uint32_t crossing(const Corner& a, const Corner& b);
    void tetrahedron(const std::array<Corner, 4>& corners);
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { m_mesh.triangles.push_back({a, b, c}); }

    const VoxelGrid& m_grid;
    const std::vector<float>& m_values;
    std::unordered_map<std::uint64_t, std::uint32_t> m_crossings;
    TriangleMesh m_mesh;
};

/// Never quite at a node, where several would be one place.
std::uint32_t Marching::crossing(const Corner& a, const Corner& b)
{
    constexpr double least = 0.04;
    const Corner &low = a.node < b.node ? a : b, &high = a.node < b.node ? b : a;
    // Seven kinds of edges leave a node towards higher ones.
    const Vec3 step = (high.place - low.place) / m_grid.edge;
    const auto kind =
        static_cast<std::uint64_t>(std::lround(step.x()) + 2 * std::lround(step.y()) + 4 * std::lround(step.z()));
    const auto [at, isNew] = m_crossings.try_emplace(8 * std::uint64_t{low.node} + kind,
                                                     static_cast<std::uint32_t>(m_mesh.points.size()));
    if (isNew) {
        const double share =
            std::clamp(static_cast<double>(low.value / (low.value - high.value)), least, 1 - least);
        m_mesh.points.emplace_back(low.place + share * (high.place - low.place));
    }
    return at->second;
}

/// The corners span a positive volume in their order: (b - a) x (c - a) looks to d.
void Marching::tetrahedron(const std::array<Corner, 4>& corners)
{
    std::array<int, 4> in{}, out{};
    std::size_t ins = 0, outs = 0;
    for (int i = 0; i < 4; ++i)
        (corners[static_cast<std::size_t>(i)].value > 0 ? in[ins++] : out[outs++]) = i;
    if (ins == 0 || outs == 0)
        return;
    const auto cut = [&](int a, int b) {
        return crossing(corners[static_cast<std::size_t>(a)], corners[static_cast<std::size_t>(b)]);
    };
    // Whether the order of inside corners before outside ones turns the tetrahedron over.
    const std::array<int, 4> order = ins == 1   ? std::array{in[0], out[0], out[1], out[2]}
                                     : ins == 3 ? std::array{out[0], in[0], in[1], in[2]}
                                                : std::array{in[0], in[1], out[0], out[1]};
    int swaps = 0;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = i + 1; k < 4; ++k)
            swaps += order[i] > order[k] ? 1 : 0;
    const bool turned = swaps % 2 == 1;
    const auto [a, b, c, d] = order;
    if (ins == 2) {
        const std::uint32_t ac = cut(a, c), ad = cut(a, d), bc = cut(b, c), bd = cut(b, d);
        turned ? triangle(ac, bc, bd) : triangle(ac, bd, bc);
        turned ? triangle(ac, bd, ad) : triangle(ac, ad, bd);
        return;
    }
    const std::uint32_t ab = cut(a, b), ac = cut(a, c), ad = cut(a, d);
    turned != (ins == 3) ? triangle(ab, ad, ac) : triangle(ab, ac, ad);
}

void Marching::cube(int x, int y, int z)
{
    std::array<Corner, 8> corners;
    bool any = false, all = true;
    for (int c = 0; c < 8; ++c) {
        const int i = x + (c & 1), j = y + (c >> 1 & 1), k = z + (c >> 2);
        Corner& corner = corners[static_cast<std::size_t>(c)];
        corner.node = m_grid.index(i, j, k);
        corner.value = m_values[corner.node];
        any = any || corner.value > 0;
        all = all && corner.value > 0;
    }
    if (!any || all)
        return;
    for (int c = 0; c < 8; ++c)
        corners[static_cast<std::size_t>(c)].place = m_grid.centre(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2));
    for (const auto& t : tetrahedra) {
        std::array<Corner, 4> four;
        for (std::size_t i = 0; i < 4; ++i)
            four[i] = corners[static_cast<std::size_t>(t[i])];
        tetrahedron(four);
    }
}

} // namespace

TriangleMesh isoSurface(const VoxelGrid& grid, const std::vector<float>& values, const std::stop_token& stop)
{
    Marching marching(grid, values);
    for (int z = 0; z + 1 < grid.size[2] && !stop.stop_requested(); ++z)
        for (int y = 0; y + 1 < grid.size[1]; ++y)
            for (int x = 0; x + 1 < grid.size[0]; ++x)
                marching.cube(x, y, z);
    return marching.take();
}

} // namespace bolster
