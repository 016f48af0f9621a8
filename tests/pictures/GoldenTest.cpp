#include "BakeFabric.h"
#include "ContactSheet.h"
#include "DesignFile.h"
#include "PictureDirection.h"
#include "PictureFile.h"
#include "PictureScene.h"
#include "RestingSolve.h"
#include "TestPaths.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace bolster {
namespace {

constexpr int width = 320;
constexpr int height = 240;

struct Sample {
    Design design;
    DesignFiles files;
    SurfaceMeshPtr surface;
    CoverMeshPtr cover;
};

/// Solved, in fabrics of this look.
Sample sample(const std::string& path, const FabricLook& look = {})
{
    const OpenedDesign opened = openDesign(QString::fromStdString(test::samplesFolder() + "/" + path));
    Sample made{opened.design, opened.files, nullptr, nullptr};
    Edit edit;
    made.design.each<Fabric>([&](ElementId id, Fabric fabric) {
        const ElementPtr before = made.design.element(id);
        fabric.look = look;
        edit.changes.push_back({id, before, makeElement(fabric)});
    });
    made.design = made.design.with(edit);
    const SolveResult solved = solveResting({made.design, made.files}, {});
    EXPECT_TRUE(solved.surface) << path;
    made.surface = solved.surface;
    made.cover = refinedForPicture(made.surface);
    EXPECT_TRUE(made.cover) << path;
    return made;
}

FabricMapsPtr baked(ElementId, const Fabric& fabric)
{
    return bakeFabric(fabric);
}

PreviewImage drawn(const Scene& scene, int pictureWidth = width, int pictureHeight = height)
{
    PreviewOptions options;
    options.width = pictureWidth;
    options.height = pictureHeight;
    options.samples = 9;
    const double aspect = static_cast<double>(pictureWidth) / pictureHeight;
    return renderPreview(scene, pictureView(scene, *pictureDirection("three-quarter"), aspect), options);
}

std::vector<std::uint8_t> pixelsOf(const std::string& path)
{
    const auto input = OIIO::ImageInput::open(path);
    if (!input)
        return {};
    std::vector<std::uint8_t> pixels(4 * input->spec().image_pixels());
    input->read_image(0, 0, 0, 4, OIIO::TypeDesc::UINT8, pixels.data());
    return pixels;
}

bool writePng(const PreviewImage& image, const std::string& path)
{
    std::ofstream file(path, std::ios::binary);
    return static_cast<bool>(file << encodePicture(image, PictureFormat::Png).bytes << std::flush);
}

/// Pictures differ a little from machine to machine: a surface is solved to 1e-6, and a pixel at its silhouette
/// jumps. What the eye sees is what 8 x 8 pixels have in common: no such block may differ by more than 6 of 255 in
/// any colour, nor the whole by more than 1 on average.
void expectLike(const PreviewImage& image, const std::string& name)
{
    const std::string golden = test::goldenFolder() + "/" + name + ".png";
    if (std::getenv("BOLSTER_REMAKE_GOLDEN") != nullptr) {
        ASSERT_TRUE(writePng(image, golden));
        return;
    }
    const std::vector<std::uint8_t> expected = pixelsOf(golden);
    ASSERT_EQ(expected.size(), image.rgba.size()) << golden;
    constexpr int block = 8;
    double worst = 0, all = 0;
    for (int y0 = 0; y0 < image.height; y0 += block)
        for (int x0 = 0; x0 < image.width; x0 += block)
            for (std::size_t c = 0; c < 4; ++c) {
                double difference = 0;
                int count = 0;
                for (int y = y0; y < std::min(image.height, y0 + block); ++y)
                    for (int x = x0; x < std::min(image.width, x0 + block); ++x, ++count) {
                        const std::size_t at = 4 * static_cast<std::size_t>(y * image.width + x) + c;
                        difference += image.rgba[at] - expected[at];
                        all += std::abs(image.rgba[at] - expected[at]);
                    }
                worst = std::max(worst, std::abs(difference) / count);
            }
    const bool alike = worst <= 6 && all / static_cast<double>(expected.size()) <= 1;
    const std::string seen = testing::TempDir() + name + ".png";
    if (!alike)
        writePng(image, seen);
    EXPECT_TRUE(alike) << "differs from " << golden << " by up to " << worst << " in a block; see " << seen;
}

TEST(Golden, CheckerTrapezoid)
{
    const Sample made = sample("trapezoid/trapezoid.json");
    expectLike(drawn(sceneWithChecker(made.surface, made.cover, made.design, noElement)), "checker-trapezoid");
}

TEST(Golden, LeatherCushion)
{
    const Sample made = sample("box-cushion/box-cushion.json", usualLook(FabricLook::Kind::GrainedLeather));
    expectLike(drawn(sceneInFabrics(made.surface, made.cover, made.design, noElement, baked)), "leather-cushion");
}

TEST(Golden, StrainOfTheArmchair)
{
    const Sample made = sample("armchair/armchair.json");
    const CoverMap map = coverMap(CoverMap::Kind::Strain, *made.surface, made.design, made.files);
    expectLike(drawn(sceneWithMap(made.surface, made.cover, map)), "strain-armchair");
}

TEST(Golden, ColourwaySheet)
{
    const Sample made = sample("box-cushion/box-cushion.json");
    const struct {
        FabricLook::Kind kind;
        const char* color;
        const char* name;
    } ways[] = {{FabricLook::Kind::SmoothLeather, "#8a4b2a", "Cognac"},
                {FabricLook::Kind::Woven, "#5c6b73", "Slate"},
                {FabricLook::Kind::Velvet, "#2f5d50", "Moss"}};
    std::vector<SheetPicture> pictures;
    for (const auto& [kind, color, name] : ways) {
        Fabric fabric;
        fabric.color = color;
        fabric.look = usualLook(kind);
        const ElementId cloth = made.design.nextId();
        Design design = made.design.with({{}, {{cloth, nullptr, makeElement(fabric)}}});
        Colourway colourway{name, {}};
        design.each<Patch>([&](ElementId patch, const Patch&) { colourway.fabrics.push_back({patch, cloth}); });
        const ElementId way = design.nextId();
        design = design.with({{}, {{way, nullptr, makeElement(colourway)}}});
        pictures.push_back({drawn(sceneInFabrics(made.surface, made.cover, design, way, baked), 160, 120), name});
    }
    std::string problem;
    expectLike(contactSheet(pictures, false, problem), "colourway-sheet");
    EXPECT_EQ(problem, "");
}

} // namespace
} // namespace bolster
