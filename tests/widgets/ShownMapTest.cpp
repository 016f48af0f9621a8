#include "CoverSetup.h"
#include "MapLegend.h"
#include "PatternMap.h"
#include "ScanPoints.h"

#include <gtest/gtest.h>

#include <limits>

namespace bolster::test {
namespace {

ShownMapPtr mapOf(const SurfaceMeshPtr& cover, const std::function<float(const Vec3&)>& value)
{
    auto map = std::make_shared<ShownMap>();
    map->topology = cover->topology;
    map->limit = 2;
    for (const Vec3& p : cover->positions)
        map->values.push_back(value(p));
    return map;
}

TEST(ShownMap, RunsFromBlueOverNearlyWhiteToRed)
{
    ShownMap map;
    map.limit = 2;
    const auto [lowRed, lowGreen, lowBlue, lowAlpha] = map.color(-5);
    EXPECT_GT(lowBlue, lowRed + 50);
    EXPECT_EQ(lowAlpha, 255);
    EXPECT_EQ(map.color(-5), map.color(-2));
    const auto [red, green, blue, alpha] = map.color(1.5);
    EXPECT_GT(red, blue + 50);
    const auto middle = map.color(0);
    EXPECT_GT(std::min({middle[0], middle[1], middle[2]}), 230);
    EXPECT_EQ(map.color(std::numeric_limits<float>::quiet_NaN())[3], 0) << "nothing is known: nothing is drawn";
}

TEST(ShownMap, HasARoundLimit)
{
    EXPECT_FLOAT_EQ(ShownMap::usualLimit(1.4), 2);
    EXPECT_FLOAT_EQ(ShownMap::usualLimit(0.03), 0.05F);
    EXPECT_FLOAT_EQ(ShownMap::usualLimit(100), 100);
}

TEST(PatternMap, PaintsEachPatchInItsOwnCoordinates)
{
    const SurfaceMeshPtr cover = twoSquaresCover();
    PatternMap pictures;
    pictures.setMap(mapOf(cover, [](const Vec3& p) { return p.x() < 199 ? -2.F : 2.F; }));
    for (const SurfaceTopology::PatchRange& range : cover->topology->patches) {
        const PatternMap::Picture* picture = pictures.picture(range.patch);
        ASSERT_TRUE(picture);
        EXPECT_NEAR(picture->box.width(), 200, 3);
        EXPECT_NEAR(picture->box.height(), 200, 3);
    }
    const auto middle = [&](const SurfaceTopology::PatchRange& range) {
        const QImage& image = pictures.picture(range.patch)->image;
        return image.pixelColor(image.width() / 4, image.height() / 2);
    };
    EXPECT_GT(middle(cover->topology->patches[0]).blue(), middle(cover->topology->patches[0]).red());
    EXPECT_GT(middle(cover->topology->patches[1]).red(), middle(cover->topology->patches[1]).blue());
    pictures.setMap(nullptr);
    EXPECT_FALSE(pictures.picture(cover->topology->patches[0].patch));
}

TEST(MapLegendTest, HasNoEmptySpace)
{
    QWidget view;
    view.resize(600, 400);
    MapLegend legend(&view);
    const SurfaceMeshPtr cover = twoSquaresCover();
    auto map = std::make_shared<ShownMap>(*mapOf(cover, [](const Vec3&) { return 1.F; }));
    map->title = QStringLiteral("Strain along the grain");
    map->unit = QStringLiteral(" %");
    const auto space = [&] { // below what is written
        const QImage seen = legend.grab().toImage();
        int last = 0;
        for (int y = 0; y < seen.height(); ++y)
            for (int x = 10; x < seen.width() - 10; ++x)
                if (seen.pixel(x, y) != seen.pixel(seen.width() / 2, 2))
                    last = y;
        return seen.height() - last;
    };
    for (const bool limits : {false, true}) {
        map->allowed.assign(limits ? map->values.size() : 0, 1.F);
        legend.setMap(std::make_shared<ShownMap>(*map));
        EXPECT_LT(space(), 20) << limits;
        const QSize before = legend.size();
        const QImage silent = legend.grab().toImage();
        legend.setReading(QStringLiteral("Here: -12.3 %"));
        EXPECT_NE(legend.grab().toImage(), silent);
        EXPECT_EQ(legend.size(), before) << "it does not jump with the pointer";
        EXPECT_LT(space(), 20) << limits;
        legend.setReading({});
    }
}

TEST(ScanPoints, ShowsWhatIsCutAwayOfASelectedScanOnly)
{
    const ElementId id{7};
    Scan scan;
    scan.scale = 10;
    scan.position = {0, 0, 5};
    scan.cuts = {{{{Vec3::UnitX(), 0.5}}, false}};
    const Design design = Design().with({{}, {{id, nullptr, makeElement(scan)}}});
    DesignFiles files;
    files.clouds[id] = std::make_shared<const PointCloud>(PointCloud{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}});
    ScanPoints points;
    points.update(design, files);
    EXPECT_TRUE(points.box(id).min().isApprox(Vec3(10, 0, 5)));
    const ViewColors colors = ViewColors::of(QPalette());
    const auto plain = points.looks({}, colors, {}, true);
    ASSERT_EQ(plain.size(), 1U);
    EXPECT_EQ(plain[0].points->size(), 2U);
    const auto selected = points.looks({id}, colors, {}, true);
    ASSERT_EQ(selected.size(), 2U);
    EXPECT_EQ(selected[1].points->size(), 1U);
    EXPECT_LT(selected[1].color.alphaF(), 1);
    EXPECT_FALSE(points.hasColors());
    ASSERT_TRUE(plain[0].own) << "the file has none: one colour, shaded";
    EXPECT_EQ(plain[0].own->size(), 2U);
    EXPECT_EQ(points.looks({}, colors, {}, true)[0].own, plain[0].own) << "made once";
    EXPECT_EQ(selected[0].own->size(), 2U);
    points.update(Design(), files);
    EXPECT_TRUE(points.looks({}, colors, {}, true).empty());
}

TEST(ScanPoints, HaveTheirOwnColoursIfTheyAreWanted)
{
    const ElementId id{7};
    Scan scan;
    scan.cuts = {{{{Vec3::UnitX(), 0.5}}, false}};
    const Design design = Design().with({{}, {{id, nullptr, makeElement(scan)}}});
    DesignFiles files;
    files.clouds[id] = std::make_shared<const PointCloud>(
        PointCloud{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {0x102030, 0x405060, 0x708090}});
    ScanPoints points;
    points.update(design, files);
    EXPECT_TRUE(points.hasColors());
    const ViewColors colors = ViewColors::of(QPalette());
    for (const std::set<ElementId>& selected : {std::set<ElementId>{}, {id}}) {
        const auto look = points.looks(selected, colors, {}, true).front();
        ASSERT_TRUE(look.own);
        EXPECT_EQ(*look.own, (std::vector<std::uint32_t>{0x405060, 0x708090})) << "of those that are there";
        EXPECT_FALSE(points.looks(selected, colors, {}, false).front().own);
    }
}

} // namespace
} // namespace bolster::test
