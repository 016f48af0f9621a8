#include "CoverMesh.h"

#include <algorithm>

namespace bolster {

std::vector<std::uint32_t> CoverTopology::along(std::span<const std::uint32_t> run) const
{
    std::vector<std::uint32_t> all;
    for (std::size_t i = 0; i < run.size(); ++i) {
        if (i > 0) {
            const std::pair key = std::minmax(run[i - 1], run[i]);
            const auto edge = std::ranges::lower_bound(edges, std::pair<std::uint32_t, std::uint32_t>(key), {},
                                                       [](const Edge& e) { return std::pair(e.a, e.b); });
            if (edge != edges.end() && edge->a == key.first && edge->b == key.second) {
                std::vector<std::uint32_t> between(edge->between.begin(),
                                                   edge->between.begin() + (1 << levels) - 1);
                if (run[i - 1] != edge->a)
                    std::ranges::reverse(between);
                all.insert(all.end(), between.begin(), between.end());
            }
        }
        all.push_back(run[i]);
    }
    return all;
}

} // namespace bolster
