// What other programs write: tests/data/patterns.
#include "DesignCheck.h"
#include "Drawn.h"
#include "PatternDesign.h"
#include "TestPaths.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <numbers>
#include <sstream>

namespace bolster {

using namespace test;

namespace {

struct RealExport {
    const char* file;
    bool hasNames;  ///< of blocks
    bool hasGrain;  ///< as such, and not among the lines inside
    bool saysStrip; ///< how the strip is spelled
    int depthOfV;   ///< mm: as it is drawn, or as it is called
};

void PrintTo(const RealExport& tested, std::ostream* out)
{
    *out << tested.file;
}

std::string contentOf(const std::string& name)
{
    std::ifstream file(dataFolder() + "/patterns/" + name, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    EXPECT_FALSE(text.str().empty()) << name;
    return text.str();
}

Drawing readExport(const std::string& name)
{
    return drawn(contentOf(name), name.ends_with(".svg") ? readSvg : readDxf);
}

/// Of the panel: a rectangle, and what its front bows out.
double panelArea()
{
    const double out = 160 * std::sin(std::numbers::pi / 18), in = 160 * std::cos(std::numbers::pi / 18);
    const Vec2 a(0, 0), b(in, -out), c(500 - in, -out), d(500, 0);
    double area = 0;
    Vec2 before = a;
    for (int k = 1; k <= 1000; ++k) {
        const double t = k / 1000.0, s = 1 - t;
        const Vec2 at = s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
        area += cross(before, at) / 2;
        before = at;
    }
    return 500 * 400 + std::abs(area);
}

class RealExports : public testing::TestWithParam<RealExport> {};

TEST_P(RealExports, AreWhatWasDrawn)
{
    const Drawing drawing = readExport(GetParam().file);
    EXPECT_TRUE(drawing.unknown.empty()) << drawing.unknown.begin()->first;
    EXPECT_TRUE(drawing.notes.empty());
    EXPECT_EQ(guessedUnit(drawing), 1);
    const FoundPattern found = findPieces(drawing, {});
    EXPECT_TRUE(found.open.empty());
    EXPECT_TRUE(found.outside.empty()) << found.outside.begin()->first;
    EXPECT_TRUE(found.ignored.empty()) << found.ignored.begin()->first;
    const ImportedPattern made = patternEdit(Design(), found);
    EXPECT_TRUE(made.notes.empty()) << made.notes.front().english();
    const Design design = Design().with(made.edit);
    ASSERT_EQ(made.patches.size(), 2u);
    std::vector<const Patch*> patches;
    for (const ElementId id : made.patches)
        patches.push_back(design.find<Patch>(id));
    std::ranges::sort(patches, std::greater(), [](const Patch* patch) { return patch->outline.signedArea(); });
    const auto& [panel, strip] = std::pair(*patches[0], *patches[1]);
    // Curves are written as polygons, so coarsely that the program may be 0.3 mm off them.
    EXPECT_NEAR(panel.outline.signedArea(), panelArea(), 60);
    EXPECT_NEAR(strip.outline.signedArea(), 450 * 80, 1);
    EXPECT_LE(panel.outline.pointCount(), 20);
    EXPECT_NEAR(panel.allowance->width, 10, 0.05);
    EXPECT_NEAR(strip.allowance->width, 12, 0.05);
    EXPECT_EQ(panel.name, "Top panel");
    EXPECT_EQ(panel.cutting.quantity, 2);
    if (GetParam().hasNames) {
        EXPECT_EQ(strip.name, GetParam().saysStrip ? "Strip" : "STRIP");
    }
    if (GetParam().hasGrain) {
        EXPECT_NEAR(std::abs(std::remainder(panel.grain, 180)), 90, 0.1);
        EXPECT_NEAR(std::remainder(strip.grain, 180), 0, 0.1);
    }
    EXPECT_EQ(found.pieces[0].inner.size() + found.pieces[1].inner.size(), GetParam().hasGrain ? 1u : 3u);
    design.each<EdgeAllowance>([](ElementId, const EdgeAllowance& edge) { ADD_FAILURE() << edge.width; });
}

TEST_P(RealExports, HaveTheirNotches)
{
    const FoundPattern found = findPieces(readExport(GetParam().file), {});
    std::vector<std::string> notches;
    for (const FoundPiece& piece : found.pieces)
        for (const FoundNotch& notch : piece.notches) {
            constexpr const char* kinds[] = {"slit", "v", "t", "castle", "u"};
            const Box2 box = piece.cut.box();
            const Vec2 at = (notch.at - box.min()).cwiseQuotient(box.sizes());
            notches.push_back(std::string(kinds[static_cast<int>(notch.shape.kind)]) + " " +
                              numberText(std::round(notch.shape.depth)) + (at.y() > 0.999 ? " above" : " aside"));
            EXPECT_LT(piece.cut.distance(notch.at), 0.05);
        }
    std::ranges::sort(notches);
    EXPECT_EQ(notches, (std::vector<std::string>{
                           "slit 5 above", "t 6 above",
                           std::string("v ").append(std::to_string(GetParam().depthOfV)).append(" aside")}));
}

INSTANTIATE_TEST_SUITE_P(Valentina, RealExports,
                         testing::Values(RealExport{"cushion-aama-r12.dxf", true, true, false, 4},
                                         RealExport{"cushion-aama-2013.dxf", true, true, true, 4},
                                         RealExport{"cushion-aama-binary.dxf", true, true, false, 4},
                                         RealExport{"cushion-astm-r12.dxf", true, true, true, 5},
                                         RealExport{"cushion-flat-r12.dxf", false, false, false, 4},
                                         RealExport{"cushion-flat-2000.dxf", false, false, false, 4},
                                         RealExport{"cushion.svg", false, false, false, 4}),
                         [](const auto& tested) {
                             std::string name = tested.param.file;
                             std::ranges::replace_if(
                                 name, [](char c) { return c == '-' || c == '.'; }, '_');
                             return name;
                         });

TEST(RealExport, OtherNotches)
{
    for (const char* file : {"cushion-notches-aama.dxf", "cushion-notches-astm.dxf"}) {
        const FoundPattern found = findPieces(readExport(file), {});
        std::set<NotchShape::Kind> kinds;
        for (const FoundPiece& piece : found.pieces)
            for (const FoundNotch& notch : piece.notches) {
                kinds.insert(notch.shape.kind);
                EXPECT_NEAR(notch.shape.depth, notch.shape.kind == NotchShape::Kind::Castle ? 6 : 5, 0.05) << file;
            }
        EXPECT_EQ(kinds, (std::set{NotchShape::Kind::Slit, NotchShape::Kind::U, NotchShape::Kind::Castle})) << file;
        EXPECT_TRUE(found.ignored.empty()) << file;
    }
}

} // namespace
} // namespace bolster
