#include "VertexMap.h"

namespace bolster {

std::vector<VertexMap::Rgba> VertexMap::colors() const
{
    const MapScale scale{kind, limit};
    std::vector<Rgba> all;
    all.reserve(values.size());
    for (std::size_t v = 0; v < values.size(); ++v)
        all.push_back(allowed.size() == values.size() ? scale.color(values[v], allowed[v])
                                                      : scale.color(values[v]));
    return all;
}

} // namespace bolster
