#include "FabricCache.h"

namespace bolster {

namespace {

std::size_t sizeOf(const FabricMaps& maps)
{
    return maps.albedo.size() + maps.normal.size() + maps.roughness.size();
}

} // namespace

FabricCache::FabricCache(std::size_t bytes)
    : m_bytes(bytes)
{}

FabricMapsPtr FabricCache::find(const Fabric& fabric, const ImagePixelsPtr& image, const BakeOptions& options)
{
    const std::lock_guard lock(m_mutex);
    for (auto entry = m_entries.begin(); entry != m_entries.end(); ++entry)
        if (entry->pixels == options.pixels && entry->image == image && looksAlike(entry->fabric, fabric)) {
            m_entries.splice(m_entries.begin(), m_entries, entry);
            return entry->maps;
        }
    return nullptr;
}

FabricMapsPtr FabricCache::get(const Fabric& fabric, const ImagePixelsPtr& image, const BakeOptions& options)
{
    if (FabricMapsPtr found = find(fabric, image, options))
        return found;
    FabricMapsPtr baked = bakeFabric(fabric, image.get(), options);
    const std::lock_guard lock(m_mutex);
    m_entries.push_front({fabric, image, options.pixels, baked});
    std::size_t kept = 0;
    auto entry = m_entries.begin();
    for (; entry != m_entries.end(); ++entry) {
        kept += sizeOf(*entry->maps);
        if (kept > m_bytes && entry != m_entries.begin())
            break;
    }
    m_entries.erase(entry, m_entries.end());
    return baked;
}

} // namespace bolster
