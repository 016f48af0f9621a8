// Parts of a frame's mesh that can be left out, and how fine voxels can be.
#include "FramePieces.h"
#include "CushionVoxels.h"
#include "Design.h"
#include "DesignCheck.h"
#include "DesignJson.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bolster {
namespace {

using Names = std::vector<std::string>;

/// Triangles of this size beside each other, each with points of its own.
void addTriangles(TriangleMesh& mesh, const std::string& part, const std::vector<double>& sizes)
{
    const auto first = static_cast<std::uint32_t>(mesh.triangles.size());
    for (const double size : sizes) {
        const auto point = static_cast<std::uint32_t>(mesh.points.size());
        const double x = 1000.0 * static_cast<double>(mesh.triangles.size());
        for (const Vec3& corner : {Vec3(x, 0, 0), Vec3(x + size, 0, 0), Vec3(x, size, 0)})
            mesh.points.push_back(corner);
        mesh.triangles.push_back({point, point + 1, point + 2});
    }
    mesh.parts.push_back({part, first, static_cast<std::uint32_t>(sizes.size())});
}

FrameMeshPtr sofa()
{
    TriangleMesh mesh;
    addTriangles(mesh, "Base", {500});
    addTriangles(mesh, "Cushions", {30, 90, 60});
    // A triangle that touches the largest cushion, with points of its own in the same places.
    const auto corners = mesh.triangles[2];
    const auto point = static_cast<std::uint32_t>(mesh.points.size());
    for (const std::uint32_t corner : {corners[1], corners[2]})
        mesh.points.emplace_back(mesh.points[corner]);
    mesh.points.emplace_back(mesh.points[corners[1]] + Vec3(0, 90, -0.0));
    mesh.triangles.push_back({point, point + 2, point + 1});
    mesh.parts.back().triangleCount = 4;
    return std::make_shared<const TriangleMesh>(std::move(mesh));
}

TEST(FramePieces, AreWhatHangsTogetherTheLargestFirst)
{
    const FramePieces pieces = framePieces(*sofa());
    Names names;
    for (const FramePiece& piece : pieces.pieces)
        names.push_back(piece.name);
    EXPECT_EQ(names, (Names{"Base", "Cushions#1", "Cushions#2", "Cushions#3"}));
    EXPECT_EQ(pieces.ofTriangle, (std::vector<std::uint32_t>{0, 3, 1, 2, 1}));
    EXPECT_EQ(pieces.pieces[1].triangleCount, 2u);
    EXPECT_DOUBLE_EQ(pieces.pieces[1].box.sizes().x(), 90);
}

TEST(FramePieces, AreHiddenByTheirNameAndByThatOfTheirPart)
{
    const FrameMeshPtr mesh = sofa();
    EXPECT_EQ(shownMesh(mesh, {}), mesh);
    EXPECT_EQ(shownMesh(mesh, {"Leg"}), mesh);
    const FrameMeshPtr base = shownMesh(mesh, {"Cushions"});
    EXPECT_EQ(base->triangles.size(), 1u);
    EXPECT_EQ(base->points.size(), 3u);
    ASSERT_EQ(base->parts.size(), 1u) << "a part of which nothing is left is none";
    EXPECT_EQ(base->parts[0].name, "Base");
    EXPECT_EQ(shownMesh(mesh, {"Cushions"}), base) << "made once";
    const FrameMeshPtr some = shownMesh(mesh, {"Cushions#1", "Base"});
    ASSERT_EQ(some->parts.size(), 1u);
    EXPECT_EQ(some->parts[0].triangleCount, 2u);
    EXPECT_EQ(some->points[some->triangles[0][0]].x(), 1000);
    EXPECT_TRUE(shownMesh(mesh, {"Cushions", "Base"})->triangles.empty());
    EXPECT_EQ(shownMesh(nullptr, {"Base"}), nullptr);
}

TEST(FramePieces, NamesSayWhatIsHidden)
{
    const FrameMeshPtr mesh = sofa();
    const auto pieces = piecesOf(mesh);
    const auto names = [&](std::vector<bool> hidden, const Names& before) {
        return pieces->namesFor(*mesh, hidden, before);
    };
    EXPECT_EQ(names({false, false, false, false}, {"Base"}), Names());
    EXPECT_EQ(names({false, true, true, true}, {}), Names{"Cushions"});
    EXPECT_EQ(names({true, false, true, false}, {"Leg"}), (Names{"Base", "Cushions#2", "Leg"}))
        << "what names nothing in this file may name something in the next one";
    EXPECT_EQ(pieces->hiddenBy(*mesh, {"Cushions", "Leg"}), (std::vector<bool>{false, true, true, true}));
    EXPECT_EQ(pieces->unknown(*mesh, {"Cushions", "Leg", "Cushions#4"}), (Names{"Leg", "Cushions#4"}));
}

TEST(FramePieces, AreFoundFromWhatIsShown)
{
    const FrameMeshPtr mesh = sofa();
    const auto pieces = piecesOf(mesh);
    const std::vector<bool> hidden = pieces->hiddenBy(*mesh, {"Base", "Cushions#2"});
    const FrameMeshPtr shown = shownMesh(mesh, {"Base", "Cushions#2"});
    ASSERT_EQ(shown->triangles.size(), 3U);
    EXPECT_EQ(pieces->ofShown(*mesh, hidden, 0), 3);
    EXPECT_EQ(pieces->ofShown(*mesh, hidden, 1), 1);
    EXPECT_EQ(pieces->ofShown(*mesh, hidden, 2), 1);
    EXPECT_EQ(pieces->ofShown(*mesh, hidden, 3), std::nullopt);
}

TEST(FramePieces, OfCrumbsMostAreTold)
{
    TriangleMesh crumbs;
    addTriangles(crumbs, "Crumbs", std::vector<double>(1000, 1));
    const FramePieces pieces = framePieces(crumbs);
    ASSERT_EQ(pieces.pieces.size(), 201u);
    EXPECT_EQ(pieces.pieces.back().triangleCount, 800u);
    EXPECT_EQ(std::ranges::count(pieces.ofTriangle, 200U), 800);
}

TEST(FramePieces, HiddenOnesAreWrittenWhenThereAreAny)
{
    const std::string head =
        R"({"format": "bolster-design", "version": 1, "unit": "mm", "settings": {"edge_length": 12},
        "elements": [{"id": 1, "kind": "frame", "name": "Sofa", "file": "sofa.obj")";
    const ReadDesign plain = readDesign(head + "}]}");
    EXPECT_EQ(writeDesign(plain.design).find("hidden_parts"), std::string::npos);
    const ReadDesign read = readDesign(head + R"(, "hidden_parts": ["Cushions#1", "\"Arm\""]}]})");
    EXPECT_TRUE(allProblems(read).empty());
    EXPECT_EQ(read.design.find<Frame>(ElementId{1})->hiddenParts, (Names{"Cushions#1", "\"Arm\""}));
    EXPECT_EQ(readDesign(writeDesign(read.design)).design, read.design);
    EXPECT_FALSE(read.design == plain.design);
    for (const char* wrong : {"[]", "[7]", "\"Arm\""})
        EXPECT_EQ(allProblems(readDesign(head + R"(, "hidden_parts": )" + wrong + "}]}")).size(), 1u) << wrong;
}

TEST(CushionVoxels, AreCoarserForALargeFrame)
{
    const auto finest = [](double size) {
        TriangleMesh mesh;
        mesh.points = {{0, 0, 0}, {size, size, size}, {size, 0, 0}};
        mesh.triangles = {{0, 1, 2}};
        mesh.parts = {{"Sofa", 0, 1}};
        Frame frame;
        frame.scale = 1000;
        return fittingVoxel({}, frame, mesh);
    };
    EXPECT_EQ(finest(0.9), 5);
    const double large = finest(2.7);
    EXPECT_GT(large, 5);
    const Box3 padded(Vec3::Constant(-30), Vec3::Constant(2730));
    EXPECT_LE(voxelCount(padded, large, cushionMargin), mostVoxels);
    EXPECT_GT(voxelCount(padded, large - 0.5, cushionMargin), mostVoxels);
    EXPECT_EQ(finest(1e4), 100) << "coarser ones are not allowed";
}

} // namespace
} // namespace bolster
