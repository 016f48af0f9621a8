// Ends of seams that move along their outlines.
#include "SeamEnds.h"

#include "CoverMove.h"
#include "TestFreedoms.h"
#include "WarmCover.h"

#include <gtest/gtest.h>

namespace bolster::test {
namespace {

/// A wide strip, held at its lower edge; two squares are sewn beside each other to its upper edge and held above.
struct TwoOnOne {
    ElementId strip{}, first{}, second{}, firstSeam{}, secondSeam{};
    Design design;

    TwoOnOne()
    {
        DesignBuilder b(20);
        const ElementId fabric = b.fabric(0.3, 5);
        strip = b.patch(rectangle(400, 100), fabric);
        first = b.patch(rectangle(200, 100), fabric);
        second = b.patch(rectangle(200, 100), fabric);
        firstSeam = b.seam({strip, 2.5, 3}, {first, 0, 1});
        secondSeam = b.seam({strip, 2, 2.5}, {second, 0, 1});
        const auto line = [](double from, double to, double y) {
            return BSpline3(1, false, {Vec3(from, y, 0), Vec3(to, y, 30)});
        };
        b.fix({strip, 0, 1}, line(0, 400, 0));
        b.fix({first, 2, 3}, line(200, 0, 205));
        b.fix({second, 2, 3}, line(400, 200, 205));
        design = b.design();
    }
};

TEST(SeamEnds, AreFreeOnSmoothEdgesOnly)
{
    const TwoOnOne two;
    const std::vector<Freedom> freedoms = seamEndFreedoms(two.design);
    ASSERT_EQ(freedoms.size(), 1u) << "all others are at corners";
    EXPECT_EQ(freedoms.front().element, two.strip);
    EXPECT_NEAR(freedoms.front().from, 2.5, 1e-12);
}

TEST(SeamEnds, BothSeamsGoAlong)
{
    const TwoOnOne two;
    const Design moved = changedBy(two.design, seamEndFreedoms(two.design).front(), 8);
    const auto &first = *moved.find<Seam>(two.firstSeam), &second = *moved.find<Seam>(two.secondSeam);
    EXPECT_NEAR(first.a.from, 2.52, 1e-9) << "8 of 400 mm";
    EXPECT_EQ(first.a.to, 3);
    EXPECT_EQ(second.a.to, first.a.from);
    EXPECT_EQ(first.b, two.design.find<Seam>(two.firstSeam)->b);
    EXPECT_EQ(moved.element(two.strip), two.design.element(two.strip)) << "no outline changes";
    EXPECT_EQ(changedBy(two.design, seamEndFreedoms(two.design).front(), 0), two.design);
}

/// The cover found on slid triangles is that of the changed design on its own.
TEST(SeamEnds, SlideWithoutNewTriangles)
{
    const TwoOnOne two;
    const Design moved = changedBy(two.design, seamEndFreedoms(two.design).front(), 8);
    WarmCover cover(two.design, {});
    ASSERT_TRUE(cover.follow(moved)) << cover.problem().english();
    const SurfaceMeshPtr slid = cover.surface(), own = WarmCover(moved, {}).surface();
    ASSERT_TRUE(slid && own);
    const CoverMove before = moveBetween(*WarmCover(two.design, {}).surface(), *own),
                    after = moveBetween(*slid, *own);
    ASSERT_TRUE(before.from && after.from);
    const auto rms = [&](const CoverMove& move) {
        double sum = 0;
        for (std::size_t v = 0; v < own->positions.size(); ++v)
            sum += (own->positions[v] - move.from->positions[v]).squaredNorm();
        return std::sqrt(sum / static_cast<double>(own->positions.size()));
    };
    EXPECT_GT(rms(before), 0.5) << "mm: it is another cover";
    EXPECT_LT(rms(after), 0.15 * rms(before));
    ASSERT_TRUE(cover.follow(two.design));
    EXPECT_LT((cover.state().positions - cover.home().positions).colwise().norm().maxCoeff(), 1e-3);
}

TEST(SeamEnds, DoNotPassEachOther)
{
    const TwoOnOne two;
    const Freedom end = seamEndFreedoms(two.design).front();
    const std::vector<double> even{0, 1, 2, 2.25, 2.5, 2.75, 3};
    const auto slid = slidSamples(even, two.design, changedBy(two.design, end, 40), two.strip);
    ASSERT_TRUE(slid);
    EXPECT_NEAR((*slid)[3], 2.3, 1e-9);
    EXPECT_NEAR((*slid)[4], 2.6, 1e-9);
    EXPECT_NEAR((*slid)[5], 2.8, 1e-9);
    EXPECT_EQ((*slid)[1], 1);
    EXPECT_FALSE(slidSamples(even, two.design, changedBy(two.design, end, 250), two.strip)) << "past the corner";
    WarmCover cover(two.design, {});
    EXPECT_FALSE(cover.follow(changedBy(two.design, end, 250)));
    EXPECT_TRUE(cover.follow(two.design));
}

} // namespace
} // namespace bolster::test
