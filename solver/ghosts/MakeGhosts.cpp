#include "MakeGhosts.h"

#include "CushionGhosts.h"
#include "FrameWarnings.h"
#include "ScanGhosts.h"

namespace bolster {

std::shared_ptr<const ScanIndex> ScanIndexCache::index(ElementId id, const Scan& scan, const DesignFiles& files,
                                                       const std::stop_token& stop)
{
    const auto cloud = files.clouds.find(id);
    if (cloud == files.clouds.end())
        return nullptr;
    Entry& entry = m_entries[id];
    if (entry.cloud != cloud->second || entry.cuts != scan.cuts) {
        auto made = std::make_shared<const ScanIndex>(*cloud->second, scan.cuts, stop);
        if (stop.stop_requested())
            return nullptr;
        entry = {cloud->second, scan.cuts, std::move(made)};
    }
    return entry.index;
}

void ScanIndexCache::forgetOthers(const Design& design)
{
    std::erase_if(m_entries, [&](const auto& entry) { return !design.find<Scan>(entry.first); });
}

namespace {

void addScans(const SolveInput& input, const SewnMesh& mesh, GhostCache& cache, Problems& problems, Ghosts& ghosts,
              const std::stop_token& stop)
{
    cache.scans.forgetOthers(input.design);
    input.design.each<Scan>([&](ElementId id, const Scan& scan) {
        if (!scan.enabled || stop.stop_requested())
            return;
        auto index = cache.scans.index(id, scan, input.files, stop);
        if (!index)
            return;
        if (!index->empty())
            ghosts.push_back(std::make_unique<ScanGhosts>(scan, std::move(index), mesh));
        else
            problems.push_back(
                {id,
                 elementLabel(id, *input.design.element(id)),
                 "cuts",
                 {QT_TRANSLATE_NOOP("Message", "the cuts leave nothing of the scan; remove one of them")},
                 Severity::Warning});
    });
}

} // namespace

Ghosts makeGhosts(const SolveInput& input, const SewnMesh& mesh, GhostCache& cache, Problems& problems,
                  WorkerPool& pool, const std::stop_token& stop)
{
    Ghosts ghosts;
    addUnknownParts(input, problems);
    addCushionGhosts(input, mesh, cache.frames, pool, stop, ghosts, problems);
    addContactGhosts(input, mesh, cache.frames, pool, stop, ghosts, problems);
    addScans(input, mesh, cache, problems, ghosts, stop);
    if (!stop.stop_requested())
        cache.frames.endRound();
    return ghosts;
}

} // namespace bolster
