#include "FaceDoubles.h"

#include "PlaceHash.h"

#include <algorithm>

namespace bolster {

FaceDoubles::Face& FaceDoubles::slotOf(std::uint64_t all)
{
    const std::size_t mask = m_faces.size() - 1; // the size is a power of two
    std::size_t slot = all & mask;
    while (m_faces[slot].all != 0 && m_faces[slot].all != all)
        slot = (slot + 1) & mask;
    return m_faces[slot];
}

void FaceDoubles::grow()
{
    std::vector<Face> before(std::max<std::size_t>(1024, 2 * m_faces.size()));
    before.swap(m_faces);
    for (const Face& face : before)
        if (face.all != 0)
            slotOf(face.all) = face;
}

FaceDoubles::Order FaceDoubles::meet(std::span<const Vec3> corners)
{
    m_hashes.clear();
    std::uint64_t all = mixedBits(m_seed ^ corners.size());
    for (const Vec3& corner : corners) {
        m_hashes.push_back(placeHash(corner + Vec3::Zero(), m_seed)); // -0 is the same place as 0
        all += m_hashes.back();                                       // in whatever order they come
    }
    all = std::max<std::uint64_t>(all, 1);
    if (2 * m_count >= m_faces.size())
        grow();
    Face& known = slotOf(all);
    if (known.all == 0) {
        known = {all, m_hashes[0], m_hashes[1]};
        ++m_count;
        return {};
    }
    const std::size_t n = m_hashes.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (m_hashes[i] != known.first)
            continue;
        if (m_hashes[(i + 1) % n] == known.second)
            return {i, false};
        if (m_hashes[(i + n - 1) % n] == known.second)
            return {n - 1 - i, true};
    }
    return {};
}

} // namespace bolster
