// One run of a mesh reader: it returns a sound mesh or refuses, whatever the bytes.
#pragma once

#include "FileRefused.h"
#include "MeshReaders.h"

#include <cstdint>
#include <cstdlib>

namespace bolster {

inline int fuzzMesh(TriangleMesh (*read)(std::string_view), const std::uint8_t* bytes, std::size_t size)
{
    try {
        const TriangleMesh mesh = read({reinterpret_cast<const char*>(bytes), size});
        for (const auto& triangle : mesh.triangles)
            for (const std::uint32_t index : triangle)
                if (index >= mesh.points.size() || !mesh.points[index].allFinite())
                    std::abort();
    } catch (const FileRefused&) {
    }
    return 0;
}

} // namespace bolster
