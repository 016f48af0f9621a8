#include "ContactSheet.h"
#include "PictureFile.h"
#include "PictureLegend.h"
#include "PreviewMeshes.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

namespace bolster::test {
namespace {

/// A tile of `size` mm: its left half white, its right half black; no relief.
FabricMapsPtr stripes(double size, int pixels = 64)
{
    auto maps = std::make_shared<FabricMaps>();
    maps->width = maps->height = pixels;
    maps->widthMm = maps->heightMm = size;
    for (int y = 0; y < pixels; ++y)
        for (int x = 0; x < pixels; ++x) {
            const std::uint8_t tone = x < pixels / 2 ? 255 : 0;
            maps->albedo.insert(maps->albedo.end(), {tone, tone, tone, 255});
            maps->normal.insert(maps->normal.end(), {128, 128, 255});
            maps->roughness.push_back(230);
        }
    return maps;
}

Scene striped(const SurfaceMeshPtr& surface, double size, double turn = 0)
{
    Scene scene;
    scene.surface = surface;
    scene.checker = false;
    scene.patches = {{surface->topology->patches.front().patch, "#808080", stripes(size), turn}};
    return scene;
}

PreviewOptions sized(int width, int height, int samples)
{
    PreviewOptions options;
    options.width = width;
    options.height = height;
    options.samples = samples;
    return options;
}

/// Where the brightness falls through the middle between its extremes, in pixels, between pixels' middles.
std::vector<double> fallingEdges(const PreviewImage& image, int y)
{
    std::vector<double> edges;
    int low = 255, high = 0;
    for (int x = 0; x < image.width; ++x) {
        low = std::min(low, brightness(image, x, y));
        high = std::max(high, brightness(image, x, y));
    }
    const double middle = 0.5 * (low + high);
    for (int x = 0; x + 1 < image.width; ++x) {
        const double here = brightness(image, x, y), next = brightness(image, x + 1, y);
        if (here >= middle && next < middle)
            edges.push_back(x + (here - middle) / (here - next));
    }
    return edges;
}

TEST(FabricPicture, TexturesHaveTheirRealSize)
{
    constexpr double repeat = 50, pixel = 0.8; // mm
    PreviewOptions options = sized(480, 60, 16);
    options.quick = true; // evenly lit
    const PreviewImage image =
        renderPreview(striped(flatPatch(400, 400), repeat), fromAbove({200, 200, 0}, pixel, 60), options);
    const std::vector<double> edges = fallingEdges(image, 30);
    ASSERT_EQ(edges.size(), 8U);
    const double measured = (edges.back() - edges.front()) * pixel / 7;
    EXPECT_NEAR(measured, repeat, 0.005 * repeat);
    EXPECT_NEAR(pixel * (edges.front() + 0.5 - 240) + 200, 25, 0.5 * pixel) << "x = 0 is where the tile begins";
}

TEST(FabricPicture, TexturesTurnAgainstThePattern)
{
    PreviewOptions options = sized(120, 120, 4);
    options.quick = true;
    const PreviewImage image = renderPreview(striped(flatPatch(400, 400), 50, std::numbers::pi / 2),
                                             fromAbove({200, 200, 0}, 1, 120), options);
    // The tile's x runs up now: stripes lie across.
    EXPECT_NEAR(brightness(image, 20, 60), brightness(image, 100, 60), 2);
    int least = 255, most = 0;
    for (int y = 10; y < 110; ++y) {
        least = std::min(least, brightness(image, 60, y));
        most = std::max(most, brightness(image, 60, y));
    }
    EXPECT_GT(most - least, 80);
}

TEST(FabricPicture, FarTexturesBecomeTheirMeanLight)
{
    PreviewOptions options = sized(60, 60, 4);
    options.quick = true;
    const PreviewImage image =
        renderPreview(striped(flatPatch(4000, 4000), 2), fromAbove({2000, 2000, 0}, 30, 60), options);
    int least = 255, most = 0;
    for (int x = 10; x < 50; ++x) {
        least = std::min(least, brightness(image, x, 30));
        most = std::max(most, brightness(image, x, 30));
    }
    EXPECT_LE(most - least, 3);
    EXPECT_GT(least, 60);
}

TEST(FabricPicture, IsTheSameOnAnyNumberOfThreads)
{
    const Scene scene = striped(corner(300), 7);
    const RayCamera view = threeQuarterView(scene, 4.0 / 3);
    PreviewOptions options = sized(160, 120, 4);
    options.light = true;
    options.threads = 1;
    const PreviewImage one = renderPreview(scene, view, options);
    options.threads = 5;
    const PreviewImage other = renderPreview(scene, view, options);
    EXPECT_EQ(one.rgba, other.rgba);
    EXPECT_EQ(one.light, other.light);
}

TEST(FabricPicture, TransparentPicturesKeepTheShadow)
{
    const Scene scene = striped(corner(300), 20);
    const RayCamera view = threeQuarterView(scene, 4.0 / 3);
    PreviewOptions options = sized(160, 120, 4);
    options.transparent = true;
    const PreviewImage image = renderPreview(scene, view, options);
    const auto alpha = [&](int x, int y) { return image.rgba[4 * static_cast<std::size_t>(y * 160 + x) + 3]; };
    EXPECT_EQ(alpha(0, 0), 0);
    EXPECT_EQ(alpha(80, 60), 255);
    std::size_t shadow = 0;
    for (std::size_t at = 0; at < image.rgba.size(); at += 4)
        shadow += image.rgba[at] == 0 && image.rgba[at + 3] > 20 && image.rgba[at + 3] < 235;
    EXPECT_GT(shadow, 50U);
}

TEST(FabricPicture, WritesEveryFormatWithNotes)
{
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "bolster-picture-file-test";
    std::filesystem::create_directories(folder);
    const Scene scene = striped(corner(300), 20);
    PreviewOptions options = sized(64, 48, 1);
    options.light = true;
    const PreviewImage image = renderPreview(scene, threeQuarterView(scene, 4.0 / 3), options);
    const PictureNotes notes{"seat.bolster", "0123abcd", "front"};
    for (const auto& [name, bits] : {std::pair("a.png", 8), std::pair("a.tif", 16), std::pair("a.exr", 16)}) {
        const std::string path = (folder / name).string();
        ASSERT_TRUE(pictureFormat(path));
        const EncodedPicture encoded = encodePicture(image, *pictureFormat(path), notes);
        ASSERT_EQ(encoded.problem.english(), "");
        std::ofstream(path, std::ios::binary) << encoded.bytes;
        const auto input = OIIO::ImageInput::open(path);
        ASSERT_TRUE(input) << name;
        EXPECT_EQ(input->spec().width, 64);
        EXPECT_EQ(input->spec().format.size() * 8, static_cast<std::size_t>(bits)) << name;
        EXPECT_EQ(input->spec().format.is_floating_point(), std::string(name) == "a.exr");
        EXPECT_EQ(input->spec().get_string_attribute("Software"), "Bolster") << name;
        const std::string text(input->spec().get_string_attribute("ImageDescription"));
        EXPECT_NE(text.find("seat.bolster"), std::string::npos) << name;
        EXPECT_NE(text.find("0123abcd"), std::string::npos) << name;
        EXPECT_NE(text.find("View: front"), std::string::npos) << name;
        input->close();
        EXPECT_EQ(encodePicture(image, *pictureFormat(path), notes).bytes, encoded.bytes) << name;
    }
    EXPECT_FALSE(pictureFormat("picture.jpg"));
    EXPECT_FALSE(pictureFormat("png"));
    std::filesystem::remove_all(folder);
}

TEST(FabricPicture, SheetsHaveAllPicturesAndTheirNames)
{
    const Scene scene = striped(corner(300), 20);
    const PreviewImage image = renderPreview(scene, threeQuarterView(scene, 4.0 / 3), sized(160, 120, 1));
    const std::vector<SheetPicture> pictures = {{image, "Cognac"}, {image, "Gr\u00fcn"}, {image, ""}};
    std::string problem;
    const PreviewImage sheet = contactSheet(pictures, false, problem);
    EXPECT_EQ(problem, "");
    EXPECT_EQ(sheet.width, 320);
    const int caption = sheetCaption(160, 120);
    EXPECT_EQ(sheet.height, 2 * (120 + caption));
    const auto darkest = [&](int left, int top) {
        int least = 255;
        for (int y = top; y < top + caption; ++y)
            for (int x = left; x < left + 160; ++x)
                least = std::min(least, brightness(sheet, x, y));
        return least;
    };
    EXPECT_LT(darkest(0, 120), 130) << "a name is written";
    EXPECT_LT(darkest(160, 120), 130);
    EXPECT_GT(darkest(0, 240 + caption), 240) << "no name, no writing";
    EXPECT_EQ(brightness(sheet, 80, 60), brightness(image, 80, 60));
}

TEST(FabricPicture, LegendsShowTheScaleInColoursAndLight)
{
    PreviewImage image;
    image.width = 640;
    image.height = 480;
    image.rgba.assign(4 * 640 * 480, 255);
    image.light.assign(4 * 640 * 480, 1.f);
    const PreviewImage before = image;
    const PictureLegend legend{{MapScale::Kind::Diverging, 10}, "Strain", "-10 %", "0", "10 %", "over the limit"};
    std::string problem;
    drawLegend(image, legend, problem);
    EXPECT_EQ(problem, "");
    const auto shows = [&](const MapScale::Rgba& color) { // where, nearly
        for (std::size_t at = 0; at < image.rgba.size(); at += 4) {
            int off = 0;
            for (std::size_t c = 0; c < 3; ++c)
                off = std::max(off, std::abs(image.rgba[at + c] - color[c]));
            if (off <= 3)
                return at;
        }
        return image.rgba.size();
    };
    for (const float value : {-9.9f, 0.f, 9.9f})
        EXPECT_LT(shows(legend.scale.color(value)), image.rgba.size()) << value;
    const std::size_t over = shows(MapScale::over);
    ASSERT_LT(over, image.rgba.size());
    EXPECT_LT(image.light[over], 0.1f) << "the light, too";
    EXPECT_LT(shows(MapScale::under), over) << "pressed stands on the left, as in the scale";
    EXPECT_EQ(brightness(image, 600, 20), brightness(before, 600, 20)) << "only a corner";

    PreviewImage small;
    small.width = small.height = 100;
    small.rgba.assign(4 * 100 * 100, 255);
    drawLegend(small, legend, problem);
    EXPECT_EQ(std::ranges::count(small.rgba, 255), std::ssize(small.rgba));
}

} // namespace
} // namespace bolster::test
