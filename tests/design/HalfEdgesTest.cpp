// Sides of triangles by edge, where any number of them may meet.
#include "HalfEdges.h"

#include <gtest/gtest.h>

#include <map>
#include <utility>

namespace bolster {
namespace {

TEST(HalfEdges, AreTogetherByEdgeHoweverManyMeet)
{
    const std::vector<std::array<std::uint32_t, 3>> pages{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}; // of a book
    std::map<std::pair<int, int>, int> count;
    int forward = 0;
    eachEdge(halfEdges(pages), [&](const HalfEdge* first, const HalfEdge* last) {
        EXPECT_TRUE(count.try_emplace({first->low, first->high}, static_cast<int>(last - first)).second);
        for (const HalfEdge* half = first; half != last; ++half) {
            const auto& corners = pages[half->triangle];
            const auto from = static_cast<int>(corners[half->side]),
                       to = static_cast<int>(corners[(half->side + 1) % 3]);
            EXPECT_EQ(std::minmax(from, to), std::minmax(half->low, half->high));
            EXPECT_EQ(half->forward, from < to);
            forward += half->low == 0 && half->high == 1 && half->forward ? 1 : 0;
        }
    });
    EXPECT_EQ(count.size(), 7U);
    EXPECT_EQ((count[{0, 1}]), 3);
    EXPECT_EQ((count[{1, 2}]), 1);
    EXPECT_EQ(forward, 2);
}

TEST(HalfEdges, OfNothingAreNone)
{
    EXPECT_TRUE(halfEdges(std::vector<std::array<int, 3>>{}).empty());
}

} // namespace
} // namespace bolster
