// One run of a scan reader: it returns finite points or refuses, whatever the bytes.
#pragma once

#include "CloudReaders.h"
#include "FileRefused.h"

#include <cstdint>
#include <cstdlib>

namespace bolster {

inline int fuzzCloud(PointCloud (*read)(std::string_view), const std::uint8_t* bytes, std::size_t size)
{
    try {
        const PointCloud cloud = read({reinterpret_cast<const char*>(bytes), size});
        for (const Vec3& point : cloud.points)
            if (!point.allFinite())
                std::abort();
    } catch (const FileRefused&) {
    }
    return 0;
}

} // namespace bolster
