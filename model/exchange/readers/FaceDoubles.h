// Faces with more than three corners that a file lists more than once.
#pragma once

#include "Geometry.h"

#include <cstdint>
#include <span>
#include <vector>

namespace bolster {

class FaceDoubles {
public:
    explicit FaceDoubles(std::uint64_t seed)
        : m_seed(seed)
    {}

    struct Order {
        std::size_t first = 0; ///< after turning
        bool backwards = false;
    };
    /// How to list the corners of a face so that they come in the order of the first face with the same ones.
    Order meet(std::span<const Vec3> corners);

private:
    /// Known by the hashes of its corners: of all, of the first and of the second one.
    struct Face {
        std::uint64_t all = 0; ///< 0: a free slot
        std::uint64_t first = 0;
        std::uint64_t second = 0;
    };

    Face& slotOf(std::uint64_t all);
    void grow();

    std::uint64_t m_seed;
    std::vector<Face> m_faces; // open addressing
    std::size_t m_count = 0;
    std::vector<std::uint64_t> m_hashes; // scratch
};

} // namespace bolster
