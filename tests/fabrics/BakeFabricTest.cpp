#include "BakeFabric.h"
#include "FabricCache.h"
#include "FabricPreview.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace bolster {
namespace {

using Kind = FabricLook::Kind;
using Shape = FabricPreviewOptions::Shape;

Fabric fabricOf(Kind kind, const std::string& color = "#7a4a2b")
{
    Fabric fabric;
    fabric.color = color;
    fabric.look = usualLook(kind);
    return fabric;
}

/// Nothing fits at its borders: brighter to the right and to the top, with a fine pattern.
ImagePixels slantedImage(int width, int height)
{
    ImagePixels image{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int light = 60 + 120 * x / width + 50 * (height - y) / height + ((x + y) % 3) * 6;
            for (int c = 0; c < 3; ++c)
                image.rgba.push_back(static_cast<std::uint8_t>(light));
            image.rgba.push_back(255);
        }
    return image;
}

struct Steps {
    double inside = 0;
    double border = 0;
};

/// Root mean square of the steps from pixel to pixel over the borders, and the largest of any row or column inside.
Steps stepsOf(const std::vector<std::uint8_t>& bytes, int width, int height, int channels)
{
    const auto at = [&](int x, int y, int c) {
        return static_cast<double>(bytes[static_cast<std::size_t>((y * width + x) * channels + c)]);
    };
    const auto column = [&](int x) {
        double sum = 0;
        for (int y = 0; y < height; ++y)
            for (int c = 0; c < std::min(3, channels); ++c)
                sum += std::pow(at((x + 1) % width, y, c) - at(x, y, c), 2);
        return std::sqrt(sum / height);
    };
    const auto row = [&](int y) {
        double sum = 0;
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < std::min(3, channels); ++c)
                sum += std::pow(at(x, (y + 1) % height, c) - at(x, y, c), 2);
        return std::sqrt(sum / width);
    };
    Steps steps;
    for (int x = 0; x + 1 < width; ++x)
        steps.inside = std::max(steps.inside, column(x));
    for (int y = 0; y + 1 < height; ++y)
        steps.inside = std::max(steps.inside, row(y));
    steps.border = std::max(column(width - 1), row(height - 1));
    return steps;
}

class EveryKind : public testing::TestWithParam<Kind> {
protected:
    FabricMapsPtr baked(const Fabric& fabric, int pixels = 512, int threads = 0)
    {
        static const ImagePixels image = slantedImage(300, 200);
        return bakeFabric(fabric, fabric.look.kind == Kind::Image ? &image : nullptr, {pixels, threads});
    }
};

TEST_P(EveryKind, HasNoVisibleBorder)
{
    const FabricMapsPtr maps = baked(fabricOf(GetParam()));
    ASSERT_TRUE(maps->complete());
    for (const auto& [bytes, channels] : {std::pair{&maps->albedo, 4}, {&maps->normal, 3}, {&maps->roughness, 1}}) {
        const Steps steps = stepsOf(*bytes, maps->width, maps->height, channels);
        EXPECT_LE(steps.border, steps.inside + 1e-9) << channels << " channels";
    }
}

TEST_P(EveryKind, IsTheSameOnEveryRunAndNumberOfThreads)
{
    const FabricMapsPtr one = baked(fabricOf(GetParam()), 256, 1), two = baked(fabricOf(GetParam()), 256, 3);
    EXPECT_EQ(one->albedo, two->albedo);
    EXPECT_EQ(one->normal, two->normal);
    EXPECT_EQ(one->roughness, two->roughness);
}

TEST_P(EveryKind, IsFlatWithoutRelief)
{
    Fabric fabric = fabricOf(GetParam());
    fabric.look.relief = 0;
    const FabricMapsPtr maps = baked(fabric, 128);
    for (std::size_t i = 0; i < maps->normal.size(); i += 3) {
        ASSERT_EQ(maps->normal[i], 128);
        ASSERT_EQ(maps->normal[i + 1], 128);
        ASSERT_EQ(maps->normal[i + 2], 255);
    }
}

TEST_P(EveryKind, BakesNonsenseIntoSomethingUsable)
{
    Fabric fabric = fabricOf(GetParam(), "no colour");
    fabric.look.secondColor = "#12";
    for (const double scale : {0.0, -3.0, 1e300, 1e-300, std::nan("")}) {
        fabric.look.scale = scale;
        fabric.look.roughness = scale;
        fabric.look.relief = 50;
        EXPECT_TRUE(baked(fabric, 64)->complete()) << scale;
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryKind,
                         testing::Values(Kind::Plain, Kind::Checker, Kind::SmoothLeather, Kind::GrainedLeather,
                                         Kind::Woven, Kind::Velvet, Kind::Image));

TEST(BakeFabric, CheckerSquaresAreAsLargeAsTheirScale)
{
    Fabric fabric = fabricOf(Kind::Checker, "#000000");
    fabric.look.secondColor = "#ffffff";
    fabric.look.scale = 25;
    const FabricMapsPtr maps = bakeFabric(fabric);
    EXPECT_DOUBLE_EQ(maps->widthMm, 50);
    EXPECT_DOUBLE_EQ(maps->heightMm, 50);
    int white = 0, changes = 0;
    for (int x = 0; x < maps->width; ++x) {
        const auto here = maps->albedo[static_cast<std::size_t>(4 * x)];
        const auto next = maps->albedo[static_cast<std::size_t>(4 * ((x + 1) % maps->width))];
        white += here == 255;
        changes += here != next;
    }
    EXPECT_EQ(2 * white, maps->width);
    EXPECT_EQ(changes, 2);
}

TEST(BakeFabric, WeaveRepeatsAsOftenAsItsScaleSays)
{
    Fabric fabric = fabricOf(Kind::Woven, "#000000");
    fabric.look.secondColor = "#ffffff";
    const FabricMapsPtr maps = bakeFabric(fabric);
    // Along a row warp and weft, black and white, alternate once a repeat.
    int best = 0;
    double most = 0;
    for (int waves = 4; waves < maps->width / 4; ++waves) {
        double strength = 0;
        for (int y = 0; y < maps->height; y += 64) {
            double re = 0, im = 0;
            for (int x = 0; x < maps->width; ++x) {
                const double value = maps->albedo[static_cast<std::size_t>(4 * (y * maps->width + x))];
                const double angle = 2 * 3.14159265358979 * waves * x / maps->width;
                re += value * std::cos(angle);
                im += value * std::sin(angle);
            }
            strength += re * re + im * im;
        }
        if (strength > most) {
            most = strength;
            best = waves;
        }
    }
    EXPECT_NEAR(maps->widthMm / best, fabric.look.scale, 0.01);
}

TEST(BakeFabric, ShowsTheColourOfTheFabric)
{
    for (const Kind kind : {Kind::Plain, Kind::SmoothLeather, Kind::GrainedLeather, Kind::Woven, Kind::Velvet}) {
        const std::string mean = meanColor(*bakeFabric(fabricOf(kind, "#9c5a2c"), nullptr, {256, 0}));
        const auto byte = [&](std::size_t i) { return std::stoi(mean.substr(i, 2), nullptr, 16); };
        EXPECT_NEAR(byte(1), 0x9c, 30) << mean;
        EXPECT_NEAR(byte(3), 0x5a, 22) << mean;
        EXPECT_NEAR(byte(5), 0x2c, 18) << mean;
    }
}

TEST(BakeFabric, LeatherHasCreasesDarkerThanItsGrain)
{
    Fabric fabric = fabricOf(Kind::GrainedLeather, "#c0c0c0");
    fabric.look.secondColor = "#000000";
    const FabricMapsPtr maps = bakeFabric(fabric, nullptr, {512, 0});
    int dark = 0, bright = 0;
    for (std::size_t i = 0; i < maps->albedo.size(); i += 4) {
        dark += maps->albedo[i] < 0xa0;
        bright += maps->albedo[i] > 0xa8;
    }
    EXPECT_GT(dark, maps->width * maps->height / 100);
    EXPECT_GT(bright, maps->width * maps->height / 3);
}

TEST(BakeFabric, ImageKeepsItsShapeAndColours)
{
    // Wider than high, the same left and right, top and bottom: nothing has to be taken out of its borders.
    ImagePixels image{400, 200, {}};
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 400; ++x) {
            const bool red = x >= 100 && x < 300;
            for (const int value : {red ? 200 : 20, 40, red ? 10 : 160, 255})
                image.rgba.push_back(static_cast<std::uint8_t>(value));
        }
    Fabric fabric = fabricOf(Kind::Image);
    fabric.look.scale = 300;
    const FabricMapsPtr maps = bakeFabric(fabric, &image);
    EXPECT_EQ(maps->width, 400);
    EXPECT_EQ(maps->height, 200);
    EXPECT_DOUBLE_EQ(maps->widthMm, 300);
    EXPECT_DOUBLE_EQ(maps->heightMm, 150);
    const auto* middle = &maps->albedo[static_cast<std::size_t>(4 * (100 * 400 + 200))];
    EXPECT_NEAR(middle[0], 200, 1);
    EXPECT_NEAR(middle[1], 40, 1);
    EXPECT_NEAR(middle[2], 10, 1);
}

TEST(BakeFabric, ColourShowsThroughAnImage)
{
    ImagePixels image{64, 64, std::vector<std::uint8_t>(std::size_t{4} * 64 * 64, 0)};
    const FabricMapsPtr maps = bakeFabric(fabricOf(Kind::Image, "#3c78a0"), &image);
    EXPECT_EQ(meanColor(*maps), "#3c78a0");
}

TEST(BakeFabric, LargeImagesAreMadeSmaller)
{
    const ImagePixels image = slantedImage(3000, 1500);
    const FabricMapsPtr maps = bakeFabric(fabricOf(Kind::Image), &image);
    EXPECT_EQ(maps->width, 1024);
    EXPECT_EQ(maps->height, 512);
}

TEST(BakeFabric, MissingImageIsMarkedAndNeverBlack)
{
    const ImagePixels broken{10, 10, {1, 2, 3}};
    for (const ImagePixels* image : {static_cast<const ImagePixels*>(nullptr), &broken}) {
        const FabricMapsPtr maps = bakeFabric(fabricOf(Kind::Image), image);
        int magenta = 0;
        for (std::size_t i = 0; i < maps->albedo.size(); i += 4) {
            ASSERT_GT(std::max({maps->albedo[i], maps->albedo[i + 1], maps->albedo[i + 2]}), 100);
            magenta += maps->albedo[i] > 2 * maps->albedo[i + 1];
        }
        EXPECT_EQ(2 * magenta, maps->width * maps->height);
    }
}

TEST(FabricCache, BakesOnceWhateverTheNameAndTheRotation)
{
    FabricCache cache;
    Fabric fabric = fabricOf(Kind::Plain);
    EXPECT_EQ(cache.find(fabric, nullptr), nullptr);
    const FabricMapsPtr first = cache.get(fabric, nullptr);
    fabric.name = "Another";
    fabric.look.rotation = 45;
    fabric.stiffness = 3;
    EXPECT_EQ(cache.get(fabric, nullptr), first);
    fabric.color = "#ffffff";
    EXPECT_NE(cache.get(fabric, nullptr), first);
}

TEST(FabricCache, ForgetsWhatWasNotAskedForTheLongest)
{
    FabricCache cache(3 * 64 * 64 * 8);
    const BakeOptions options{64, 1};
    const auto colored = [](const char* color) { return fabricOf(Kind::Velvet, color); };
    for (const char* color : {"#000001", "#000002", "#000003"})
        cache.get(colored(color), nullptr, options);
    EXPECT_TRUE(cache.find(colored("#000001"), nullptr, options));
    cache.get(colored("#000004"), nullptr, options);
    EXPECT_TRUE(cache.find(colored("#000001"), nullptr, options));
    EXPECT_FALSE(cache.find(colored("#000002"), nullptr, options));
}

class FabricPreviewTest : public testing::Test {
protected:
    static constexpr int size = 220; ///< pixels
    static constexpr double widthMm = 110;

    static ImagePixelsPtr drawn(const Fabric& fabric, Shape shape)
    {
        const ImagePixelsPtr picture = fabricPreview(*bakeFabric(fabric), {shape, size, widthMm, 0});
        EXPECT_TRUE(picture->complete());
        return picture;
    }
    static const std::uint8_t* pixel(const ImagePixels& picture, int x, int y)
    {
        return &picture.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + x)];
    }
    static int brightness(const ImagePixels& picture, int x, int y)
    {
        const std::uint8_t* rgb = pixel(picture, x, y);
        return rgb[0] + rgb[1] + rgb[2];
    }
};

TEST_F(FabricPreviewTest, TheMiddleHasTheColourOfTheFabric)
{
    for (const Shape shape : {Shape::Ball, Shape::Cushion, Shape::Flat}) {
        const ImagePixelsPtr picture = drawn(fabricOf(Kind::Plain, "#2050c0"), shape);
        const std::uint8_t* middle = pixel(*picture, size / 2, size / 2);
        EXPECT_NEAR(middle[0], 0x20, 40);
        EXPECT_NEAR(middle[1], 0x50, 40);
        EXPECT_NEAR(middle[2], 0xc0, 40);
        EXPECT_EQ(middle[3], 255);
    }
}

TEST_F(FabricPreviewTest, ABallIsRoundAndSeeThroughBesideIt)
{
    const ImagePixelsPtr picture = drawn(fabricOf(Kind::Plain), Shape::Ball);
    const double radius = 0.94 * size / 2;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const double r = std::hypot(x + 0.5 - size / 2.0, y + 0.5 - size / 2.0);
            const int opacity = pixel(*picture, x, y)[3];
            ASSERT_TRUE(r > radius - 1.8 || opacity == 255) << x << ", " << y;
            ASSERT_TRUE(r < radius + 1.8 || opacity == 0) << x << ", " << y;
        }
    EXPECT_GT(brightness(*picture, size * 3 / 8, size / 4), brightness(*picture, size * 5 / 8, size * 7 / 8))
        << "lit from above, from the left";
}

TEST_F(FabricPreviewTest, ACushionReachesIntoItsCorners)
{
    const ImagePixelsPtr picture = drawn(fabricOf(Kind::Plain), Shape::Cushion);
    constexpr int corner = size * 5 / 100; // beside a ball
    EXPECT_EQ(pixel(*picture, corner, corner)[3], 255);
    EXPECT_EQ(pixel(*picture, size - 1 - corner, size - 1 - corner)[3], 255);
    EXPECT_EQ(pixel(*picture, 1, size / 2)[3], 0) << "its sides are drawn in";
}

TEST_F(FabricPreviewTest, WhatFacesTheEyeHasItsRealSizeOnAnyShape)
{
    Fabric squares = fabricOf(Kind::Checker);
    squares.look.secondColor = "#f0f0f0";
    squares.look.scale = 20; // mm: 40 pixels
    for (const Shape shape : {Shape::Ball, Shape::Cushion, Shape::Flat}) {
        const ImagePixelsPtr picture = drawn(squares, shape);
        const int y = size / 2 + 8;
        int x = size / 2 + 4;
        const int square = brightness(*picture, x, y);
        while (std::abs(brightness(*picture, x, y) - square) < 100 && x < size - 1)
            ++x;
        EXPECT_NEAR(x - size / 2, 40, 3);
    }
}

/// What is as fine as the pixels must not beat against them.
TEST_F(FabricPreviewTest, AFinePatternMakesNoBands)
{
    Fabric squares = fabricOf(Kind::Checker, "#404040");
    squares.look.secondColor = "#e0e0e0";
    squares.look.scale = 0.55; // 1.1 pixels
    const ImagePixelsPtr picture = drawn(squares, Shape::Flat);
    double darkest = 1e9, brightest = 0;
    for (int y = 4; y < size - 4; ++y) {
        double row = 0;
        for (int x = 0; x < size; ++x)
            row += brightness(*picture, x, y) / 3.0 / size;
        darkest = std::min(darkest, row);
        brightest = std::max(brightest, row);
    }
    EXPECT_LT(brightest - darkest, 6);
}

/// Pictures to look at, with BOLSTER_TILES=folder; times are printed for the record.
/// BOLSTER_TILES names a folder for pictures of them.
TEST(BakeFabric, MapsOfEveryKindAreComplete)
{
    const char* folder = std::getenv("BOLSTER_TILES");
    const ImagePixels image = slantedImage(1500, 1000);
    const std::pair<const char*, Fabric> all[] = {{"plain", fabricOf(Kind::Plain, "#6d7178")},
                                                  {"checker", fabricOf(Kind::Checker)},
                                                  {"smooth", fabricOf(Kind::SmoothLeather, "#8a4f2a")},
                                                  {"grained", fabricOf(Kind::GrainedLeather, "#8a4f2a")},
                                                  {"woven", fabricOf(Kind::Woven, "#6d7178")},
                                                  {"velvet", fabricOf(Kind::Velvet, "#1f5b43")},
                                                  {"image", fabricOf(Kind::Image)}};
    for (const auto& [name, fabric] : all) {
        const FabricMapsPtr maps = bakeFabric(fabric, fabric.look.kind == Kind::Image ? &image : nullptr);
        EXPECT_TRUE(maps->complete()) << name;
        if (!folder)
            continue;
        const auto write = [&, name = name](const std::string& what, int width, int height, int channels,
                                            const void* bytes) {
            const std::string path = std::string(folder) + "/" + name + "-" + what + ".png";
            const auto output = OIIO::ImageOutput::create(path);
            ASSERT_TRUE(output &&
                        output->open(path, OIIO::ImageSpec(width, height, channels, OIIO::TypeDesc::UINT8)) &&
                        output->write_image(OIIO::TypeDesc::UINT8, bytes) && output->close());
        };
        write("albedo", maps->width, maps->height, 4, maps->albedo.data());
        write("normal", maps->width, maps->height, 3, maps->normal.data());
        const auto preview = [&](const char* what, Shape shape, int pixels, double mm) {
            const ImagePixelsPtr picture = fabricPreview(*maps, {shape, pixels, mm, 0});
            write(what, pixels, pixels, 4, picture->rgba.data());
        };
        preview("flat", Shape::Flat, 400, 60);
        preview("ball", Shape::Ball, 200, 70);
        preview("cushion", Shape::Cushion, 200, 120);
    }
}

} // namespace
} // namespace bolster
