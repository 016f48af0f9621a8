#include "ReliefJob.h"

#include "CoverMap.h"
#include "CoverPicture.h"
#include "SolveFailure.h"

#include <algorithm>
#include <map>
#include <optional>

namespace bolster {

namespace {

VertexMap strainMap(const SurfaceMesh& cover, const Design& design)
{
    CoverMap measured = coverMap(CoverMap::Kind::Strain, cover, design, {});
    VertexMap map;
    map.topology = cover.topology;
    map.values = std::move(measured.ofVertex);
    map.allowed = std::move(measured.allowed);
    map.kind = measured.scale.kind;
    map.limit = measured.scale.limit;
    return map;
}

/// Share of what is over the limit: what relieves nothing, or makes it worse, is not proposed however it was
/// predicted.
constexpr double leastGain = 0.005;

/// Of the cover as it is, and of those with a relief, each once.
class ReliefPictures {
public:
    explicit ReliefPictures(const ReliefWanted& wanted)
        : m_wanted(wanted)
    {}

    /// With the reliefs that have been solved, those first that gain most.
    ReliefFound of(const ReliefList& list)
    {
        ReliefFound found;
        found.number = m_wanted.number;
        found.list = list;
        std::erase_if(found.list.reliefs,
                      [](const Relief& relief) { return !relief.solved || relief.solved->energy < leastGain; });
        std::ranges::stable_sort(found.list.reliefs, std::ranges::greater(),
                                 [](const Relief& relief) { return relief.solved->energy; });
        const Design& design = m_wanted.input.design;
        if (m_now.isNull()) {
            VertexMap now = strainMap(*list.cover, design);
            m_limit = now.limit;
            m_now = picture(list.cover, design, std::move(now));
        }
        found.now = m_now;
        for (const Relief& relief : found.list.reliefs) {
            QImage& seen = m_seen[relief.element]; // one relief of each
            if (seen.isNull()) {
                const Design changed = design.with(relief.edit);
                seen = picture(relief.cover, changed, strainMap(*relief.cover, changed));
            }
            found.pictures.push_back(seen);
        }
        return found;
    }

private:
    QImage picture(const SurfaceMeshPtr& cover, const Design& shown, VertexMap map) const
    {
        if (m_wanted.order.limit)
            map.allowed.assign(map.values.size(), static_cast<float>(*m_wanted.order.limit));
        map.limit = m_limit; // the same colours in all of them
        Scene scene = coverScene(cover, shown);
        scene.map = std::make_shared<const VertexMap>(std::move(map));
        return coverPicture(scene, m_wanted.camera, m_wanted.pictureSize);
    }

    const ReliefWanted& m_wanted;
    double m_limit = 0;
    QImage m_now;
    std::map<ElementId, QImage> m_seen;
};

} // namespace

ReliefFound findReliefs(const ReliefWanted& wanted, const ReliefsSeen& news, const std::stop_token& stop)
{
    ReliefFound found;
    found.number = wanted.number;
    try {
        ReliefPictures pictures(wanted);
        const ReliefList list = proposeReliefs(
            wanted.input, wanted.order,
            [&](double share, const ReliefList* known) {
                const std::optional<ReliefFound> seen = known ? std::optional(pictures.of(*known)) : std::nullopt;
                news(share, seen ? &*seen : nullptr);
            },
            stop);
        if (list.cover && !stop.stop_requested())
            found = pictures.of(list);
        else
            found.list = list;
    } catch (const std::exception& error) {
        found.list.problem = failureMessage(error);
    }
    found.whole = true;
    return found;
}

} // namespace bolster
