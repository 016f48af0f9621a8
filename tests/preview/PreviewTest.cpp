#include "PreviewMeshes.h"

#include "PictureFile.h"

#include "CoverRefiner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>

namespace bolster::test {
namespace {

PreviewOptions small(int samples = 4)
{
    PreviewOptions options;
    options.width = 160;
    options.height = 120;
    options.samples = samples;
    return options;
}

Scene sceneOf(SurfaceMeshPtr surface)
{
    Scene scene;
    scene.surface = std::move(surface);
    return scene;
}

TEST(Preview, IsTheSameOnAnyNumberOfThreads)
{
    const Scene scene = sceneOf(corner(300));
    const RayCamera view = threeQuarterView(scene, 4.0 / 3);
    PreviewOptions options = small();
    options.depth = true;
    options.threads = 1;
    const PreviewImage one = renderPreview(scene, view, options);
    for (const int threads : {2, 3, 7}) {
        options.threads = threads;
        const PreviewImage other = renderPreview(scene, view, options);
        EXPECT_EQ(one.rgba, other.rgba);
        EXPECT_EQ(one.depth, other.depth);
    }
}

TEST(Preview, TheRefinedCoverIsDrawnInPlaceOfTheSolvers)
{
    Scene scene = sceneOf(corner(300));
    const RayCamera view = threeQuarterView(scene, 4.0 / 3);
    PreviewOptions options = small();
    options.depth = true;
    const PreviewImage coarse = renderPreview(scene, view, options);
    scene.cover = CoverRefiner().refine(scene.surface, 2);
    const PreviewImage fine = renderPreview(scene, view, options);
    int different = 0;
    for (std::size_t i = 0; i < coarse.rgba.size(); i += 4)
        different += std::abs(coarse.rgba[i] - fine.rgba[i]) > 12;
    EXPECT_LT(different, 160 * 120 / 50) << "flat walls with a checker look the same";
    auto raised = std::make_shared<CoverMesh>(*scene.cover);
    for (Eigen::Vector3f& p : raised->points)
        p.z() += 10;
    scene.cover = raised;
    const RayCamera above = fromAbove({150, 150, 0}, 1, options.height);
    const auto middle = static_cast<std::size_t>(options.height / 2 * options.width + options.width / 2);
    const float near = renderPreview(scene, above, options).depth[middle];
    scene.cover.reset();
    EXPECT_NEAR(renderPreview(scene, above, options).depth[middle] - near, 10, 0.01);
}

TEST(Preview, ASectionShowsWhatLiesBehindIt)
{
    Scene scene = sceneOf(corner(300));
    const Box3 box = scene.boundingBox();
    const RayCamera view = threeQuarterView(scene, 4.0 / 3);
    PreviewOptions options = small();
    options.depth = true;
    const auto seen = [&] {
        const PreviewImage image = renderPreview(scene, view, options);
        return std::count_if(image.depth.begin(), image.depth.end(), [](float d) { return std::isfinite(d); });
    };
    const auto whole = seen();
    scene.section = SectionPlane{Vec3::UnitX(), box.center().x()};
    const auto half = seen();
    EXPECT_GT(half, 0);
    EXPECT_LT(half, whole);
    scene.section = SectionPlane{Vec3::UnitX(), box.max().x() + 1};
    EXPECT_EQ(seen(), whole);
    scene.section = SectionPlane{Vec3::UnitX(), box.min().x() - 1};
    EXPECT_EQ(seen(), 0);
}

TEST(Preview, CancelledIsEmpty)
{
    std::stop_source stop;
    stop.request_stop();
    const Scene scene = sceneOf(corner(300));
    EXPECT_TRUE(renderPreview(scene, {}, small(), stop.get_token()).empty());
    EXPECT_TRUE(PreviewRenderer(scene).render({}, small(), stop.get_token()).empty());
}

TEST(Preview, RefusesImpossibleSizes)
{
    PreviewOptions options = small();
    options.width = 0;
    EXPECT_TRUE(renderPreview({}, {}, options).empty());
    options.width = 1 << 20;
    EXPECT_TRUE(renderPreview({}, {}, options).empty());
}

TEST(Preview, DrawsTheBackgroundOfAnEmptyScene)
{
    const PreviewImage image = renderPreview({}, {}, small());
    ASSERT_EQ(image.rgba.size(), 4u * 160 * 120);
    EXPECT_NEAR(brightness(image, 80, 119), 250, 3);
    EXPECT_LT(brightness(image, 80, 0), brightness(image, 80, 119));
    EXPECT_EQ(image.rgba[3], 255);
}

TEST(Preview, SurvivesPointsThatAreNoNumbers)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const SurfaceMeshPtr mesh = changed(flatPatch(100, 100), [&](SurfaceMesh& m) {
        m.positions[3] = {nan, 0, 0};
        m.positions[17] = {1e300, 0, 0};
        m.normals[40] = Eigen::Vector3f::Constant(std::nanf(""));
    });
    const Scene scene = sceneOf(mesh);
    EXPECT_NEAR(scene.boundingBox().sizes().x(), 100, 1e-9);
    const PreviewImage image = renderPreview(scene, fromAbove({50, 50, 0}, 1, 120), small());
    EXPECT_LT(brightness(image, 80, 40), 200); // the other triangles are there
    const SurfaceMeshPtr nothing = changed(flatPatch(100, 100), [&](SurfaceMesh& m) {
        for (Vec3& p : m.positions)
            p.setConstant(nan);
    });
    EXPECT_FALSE(renderPreview(sceneOf(nothing), {}, small()).empty());
}

TEST(Preview, IgnoresAMeshWhoseArraysDoNotFit)
{
    const SurfaceMeshPtr mesh = changed(flatPatch(100, 100), [](SurfaceMesh& m) { m.normals.pop_back(); });
    EXPECT_FALSE(renderPreview(sceneOf(mesh), fromAbove({50, 50, 0}, 1, 120), small()).empty());
}

TEST(Preview, CheckerHasItsRealSize)
{
    Scene scene = sceneOf(flatPatch(400, 400));
    scene.checkerSize = 20;
    PreviewOptions options = small();
    options.width = 400;
    options.height = 300;
    const PreviewImage image = renderPreview(scene, fromAbove({200, 200, 0}, 1, options.height), options);
    // Pixel x shows 0 mm + x, pixel row 150 lies at y = 200 - 0.5, one square's upper border.
    int changes = 0, last = 0, first = 0;
    const int row = 140;
    for (int x = 11; x < 390; ++x) {
        const bool was = brightness(image, x - 1, row) > 125, is = brightness(image, x, row) > 125;
        if (was != is) {
            if (changes++ == 0)
                first = x;
            last = x;
        }
    }
    ASSERT_GT(changes, 10);
    EXPECT_NEAR(static_cast<double>(last - first) / (changes - 1), 20, 0.1);
    EXPECT_EQ(first % 20, 0);
}

TEST(Preview, FarCheckerBecomesItsMean)
{
    Scene scene = sceneOf(flatPatch(8000, 8000));
    const PreviewImage image = renderPreview(scene, fromAbove({4000, 4000, 0}, 47, 120), small());
    int lowest = 255, highest = 0;
    for (int x = 40; x < 120; ++x) {
        lowest = std::min(lowest, brightness(image, x, 60));
        highest = std::max(highest, brightness(image, x, 60));
    }
    EXPECT_LT(highest - lowest, 8);
}

TEST(Preview, ShowsPatchColorsAndTheLining)
{
    Scene scene = sceneOf(flatPatch(400, 400));
    scene.patches = {{ElementId{2}, "#c02020"}};
    scene.checker = false;
    const auto redness = [&](double elevation) {
        RayCamera view = fromAbove({200, 200, 0}, 1, 120);
        view.elevation = elevation;
        const PreviewImage image = renderPreview(scene, view, small());
        const std::size_t middle = 4 * (60 * 160 + 80);
        return static_cast<double>(image.rgba[middle]) / std::max<int>(1, image.rgba[middle + 2]);
    };
    EXPECT_GT(redness(std::numbers::pi / 2), 2.5);
    EXPECT_LT(redness(-std::numbers::pi / 2), 1.8);
}

TEST(Preview, CornersAreDarkerThanOpenPlaces)
{
    Scene scene = sceneOf(corner(300));
    scene.checker = false;
    RayCamera view = fromAbove({150, 200, 0}, 3, 120);
    view.azimuth = 2.5; // the key light comes from behind the back
    const PreviewImage shadowed = renderPreview(scene, view, small(16));
    PreviewOptions quick = small(16);
    quick.quick = true;
    const PreviewImage flat = renderPreview(scene, view, quick);
    EXPECT_LT(brightness(shadowed, 80, 60), brightness(flat, 80, 60) - 15);
}

TEST(Preview, SeamsAreDarkLines)
{
    Scene scene = sceneOf(corner(300));
    scene.checker = false;
    const PreviewImage image = renderPreview(scene, fromAbove({150, 290, 0}, 0.5, 120), small());
    // The seam runs along y = 300, 20 pixels above the middle.
    const int darkest = std::min({brightness(image, 80, 39), brightness(image, 80, 40), brightness(image, 80, 41)});
    EXPECT_LT(darkest, brightness(image, 80, 100) - 25);
}

TEST(Preview, GivesDepths)
{
    const Scene scene = sceneOf(flatPatch(40, 40));
    PreviewOptions options = small();
    options.depth = true;
    const RayCamera view = fromAbove({20, 20, 0}, 1, 120);
    const PreviewImage image = renderPreview(scene, view, options);
    EXPECT_NEAR(image.depth[60 * 160 + 80], view.distance, 0.1);
    EXPECT_TRUE(std::isinf(image.depth[0]));
}

TEST(Preview, ShowsFramesInGrey)
{
    auto frame = std::make_shared<TriangleMesh>();
    frame->points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    frame->triangles = {{0, 1, 2}};
    Scene scene;
    scene.frames.push_back({frame, {100, {5, 0, 0}}});
    EXPECT_NEAR(scene.boundingBox().max().x(), 105, 1e-9);
    const PreviewImage image = renderPreview(scene, fromAbove({30, 30, 0}, 1, 120), small());
    const std::size_t middle = 4 * (60 * 160 + 80);
    EXPECT_LT(brightness(image, 80, 60), 235);
    EXPECT_NEAR(image.rgba[middle], image.rgba[middle + 2], 25);
}

TEST(Preview, FramesAreSolidUnlessTheyShallBeSeenThrough)
{
    auto frame = std::make_shared<TriangleMesh>();
    frame->points = {{0, 0, 0}, {400, 0, 0}, {400, 400, 0}, {0, 400, 0}};
    frame->triangles = {{0, 1, 2}, {0, 2, 3}};
    Scene scene = sceneOf(flatPatch(400, 400));
    scene.ground = scene.checker = false;
    const RayCamera view = fromAbove({200, 200, 0}, 1, 120);
    const auto redness = [&] {
        const PreviewImage image = renderPreview(scene, view, small());
        const std::size_t middle = 4 * (60 * 160 + 80);
        return image.rgba[middle] - image.rgba[middle + 2];
    };
    const int alone = redness();
    scene.frames = {{frame, {1, {0, 0, 20}}}};
    EXPECT_LT(redness(), 10) << "the cover is behind it";
    scene.frames[0].opacity = 0.4;
    EXPECT_LT(redness(), alone - 10);
    EXPECT_GT(redness(), 10);
    scene.frames[0].opacity = 1;
    scene.frames[0].placement.position.z() = -20;
    EXPECT_NEAR(redness(), alone, 2) << "it is behind the cover";
}

TEST(Preview, FramesHaveTheLookOfTheirMaterial)
{
    auto frame = std::make_shared<TriangleMesh>();
    frame->points = {{-200, -200, 0}, {200, -200, 0}, {200, 200, 0}, {-200, 200, 0}};
    frame->triangles = {{0, 1, 2}, {0, 2, 3}};
    frame->parts = {{"plate", 0, 2}};
    Scene scene;
    scene.ground = false;
    const auto pixels = [&](const FrameMaterial& material) {
        scene.frames = {{frame, {}, material}};
        return renderPreview(scene, fromAbove({0, 0, 0}, 1, 120), small()).rgba;
    };
    const auto spread = [](const std::vector<std::uint8_t>& rgba) { // from the darkest to the brightest red
        std::uint8_t low = 255, high = 0;
        for (int x = 40; x < 120; ++x) {
            const std::uint8_t red = rgba[static_cast<std::size_t>(4 * (60 * 160 + x))];
            low = std::min(low, red);
            high = std::max(high, red);
        }
        return high - low;
    };
    const std::size_t middle = 4 * (60 * 160 + 80);
    const auto plain = pixels({}), wood = pixels({FrameMaterial::Kind::Wood, {}}),
               black = pixels({FrameMaterial::Kind::Plastic, {}}),
               blue = pixels({FrameMaterial::Kind::Plastic, "#2040c0"});
    EXPECT_GT(spread(wood), spread(plain) + 8) << "its grain is seen";
    EXPECT_GT(wood[middle], wood[middle + 2] + 30) << "and it is brown";
    EXPECT_LT(black[middle] + 40, plain[middle]);
    EXPECT_GT(blue[middle + 2], blue[middle] + 60);
    EXPECT_NE(pixels({FrameMaterial::Kind::Metal, {}}), plain);
}

TEST(Preview, ThreeQuarterViewShowsTheWholeBox)
{
    const Box3 box(Vec3(-400, 100, 30), Vec3(500, 700, 1200));
    for (const double aspect : {0.5, 1.0, 4.0 / 3, 3.0}) {
        const RayCamera view = RayCamera::threeQuarter(box, aspect);
        const Vec3 backward = (view.eye() - view.target).normalized();
        const Vec3 right(std::cos(view.azimuth), std::sin(view.azimuth), 0);
        const Vec3 up = backward.cross(right);
        double widest = 0;
        for (int i = 0; i < 8; ++i) {
            const Vec3 p = box.corner(static_cast<Box3::CornerType>(i)) - view.eye();
            const double half = -p.dot(backward) * std::tan(view.fieldOfView / 2);
            widest = std::max({widest, std::abs(p.dot(up)) / half, std::abs(p.dot(right)) / (half * aspect)});
        }
        EXPECT_LE(widest, 1);
        EXPECT_GT(widest, 0.8);
    }
}

TEST(Preview, EncodesPng)
{
    const EncodedPicture encoded = encodePicture(renderPreview({}, {}, small()), PictureFormat::Png);
    EXPECT_EQ(encoded.problem.english(), "");
    EXPECT_TRUE(encoded.bytes.starts_with("\x89PNG\r\n\x1a\n"));
    EXPECT_NE(encodePicture({}, PictureFormat::Png).problem.english(), "");
}

} // namespace
} // namespace bolster::test
