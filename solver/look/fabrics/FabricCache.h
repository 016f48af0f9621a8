// Maps that were baked, kept for whoever asks next.
#pragma once

#include "BakeFabric.h"

#include <list>
#include <mutex>

namespace bolster {

/// Usable from several threads. Forgets what was not asked for the longest.
class FabricCache {
public:
    explicit FabricCache(std::size_t bytes = 400'000'000);

    /// The maps if they are there; never bakes.
    FabricMapsPtr find(const Fabric& fabric, const ImagePixelsPtr& image, const BakeOptions& options = {});
    /// Bakes if need be.
    FabricMapsPtr get(const Fabric& fabric, const ImagePixelsPtr& image, const BakeOptions& options = {});

private:
    struct Entry {
        Fabric fabric;
        ImagePixelsPtr image;
        int pixels;
        FabricMapsPtr maps;
    };

    std::mutex m_mutex;
    std::size_t m_bytes;
    std::list<Entry> m_entries; ///< newest first
};

} // namespace bolster
