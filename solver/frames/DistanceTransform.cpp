#include "DistanceTransform.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr float far = 1e6f;

/// A run of voxels along an axis, copied together.
struct Line {
    explicit Line(int length)
        : values(length)
        , result(length)
        , places(length)
        , borders(length + 1)
    {}

    std::vector<float> values;
    std::vector<float> result;
    std::vector<int> places;     // of the parabolas of the lower envelope
    std::vector<double> borders; // between them
};

void sweepCityBlock(Line& line)
{
    auto& v = line.values;
    for (std::size_t i = 1; i < v.size(); ++i)
        v[i] = std::min(v[i], v[i - 1] + 1);
    for (std::size_t i = v.size() - 1; i-- > 0;)
        v[i] = std::min(v[i], v[i + 1] + 1);
    line.result = v;
}

/// The lower envelope of parabolas over squared distances.
void envelope(Line& line)
{
    const auto& v = line.values;
    int last = -1;
    for (int i = 0; i < std::ssize(v); ++i) {
        if (v[i] >= far * far)
            continue;
        double border = -1e30;
        for (; last >= 0; --last) {
            const double j = line.places[last];
            border = (v[i] + double(i) * i - v[line.places[last]] - j * j) / (2 * (i - j));
            if (border > line.borders[last])
                break;
            border = -1e30;
        }
        line.places[++last] = i;
        line.borders[last] = border;
    }
    if (last < 0) {
        line.result = v;
        return;
    }
    for (int i = 0, k = 0; i < std::ssize(v); ++i) {
        while (k < last && line.borders[k + 1] < i)
            ++k;
        const auto way = static_cast<float>(i - line.places[k]);
        line.result[i] = way * way + v[line.places[k]];
    }
}

/// Calls sweep(line) for every line of voxels along the axis.
void sweepAxis(std::vector<float>& values, const VoxelGrid& grid, int axis, void (*sweep)(Line&), WorkerPool& pool,
               const std::stop_token& stop)
{
    const std::array<std::size_t, 3> strides = {1, grid.index(0, 1, 0), grid.index(0, 0, 1)};
    const int across = axis == 0 ? 1 : 0, layers = axis == 2 ? 1 : 2;
    pool.forTasks(grid.size[layers], [&](int layer) {
        Line line(grid.size[axis]);
        for (int row = 0; row < grid.size[across] && !stop.stop_requested(); ++row) {
            float* first = values.data() + layer * strides[layers] + row * strides[across];
            for (int i = 0; i < grid.size[axis]; ++i)
                line.values[i] = first[i * strides[axis]];
            sweep(line);
            for (int i = 0; i < grid.size[axis]; ++i)
                first[i * strides[axis]] = line.result[i];
        }
    });
}

} // namespace

std::vector<float> distancesTo(std::uint8_t goal, const Voxels& voxels, VoxelMetric metric, WorkerPool& pool,
                               const std::stop_token& stop)
{
    const bool cityBlock = metric == VoxelMetric::CityBlock;
    std::vector<float> values(voxels.inside.size());
    std::transform(voxels.inside.begin(), voxels.inside.end(), values.begin(), [&](std::uint8_t value) {
        return value == goal ? 0 : cityBlock ? far : far * far;
    });
    for (int axis = 0; axis < 3; ++axis)
        sweepAxis(values, voxels.grid, axis, cityBlock ? sweepCityBlock : envelope, pool, stop);
    if (!cityBlock)
        for (float& value : values)
            value = std::sqrt(value);
    return values;
}

} // namespace bolster
