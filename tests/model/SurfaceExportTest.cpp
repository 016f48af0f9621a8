#include "SurfaceExport.h"
#include "MeshImport.h"
#include "TestFiles.h"

#include <clocale>
#include <set>
#include <sstream>

namespace bolster {
namespace {

/// Two triangles of two patches, sewn along one edge.
SurfaceMesh twoPatches()
{
    auto topology = std::make_shared<SurfaceTopology>();
    topology->triangles = {{0, 1, 2}, {4, 3, 5}};
    topology->pattern = {{0, 0}, {100.5, 0}, {0, 100}, {0, 0}, {0.1, -20}, {30, 0}};
    topology->unknown = {0, 1, 2, 1, 2, 3};
    topology->unknownCount = 4;
    topology->patches = {{ElementId{2}, ElementId{1}, 0, 3, 0, 1}, {ElementId{5}, ElementId{1}, 3, 3, 1, 1}};
    SurfaceMesh surface;
    surface.topology = topology;
    const Vec3 seamStart(1.0 / 3, -0.0, 1e-7), seamEnd(-2.0 / 3, 1234.56789012345, 0);
    surface.positions = {Vec3(0, 0, 0), seamStart, seamEnd, seamStart, seamEnd, Vec3(9e6, -1, 0.1)};
    surface.normals.assign(6, Eigen::Vector3f(0, 0.6f, 0.8f));
    return surface;
}

Design twoNames()
{
    Design design;
    return design.with({{},
                        {{ElementId{2}, nullptr, makeElement(Patch{.name = "Inside back", .outline = {}})},
                         {ElementId{5}, nullptr, makeElement(Patch{.name = "Inside back", .outline = {}})}}});
}

class SurfaceExportTest : public TestFiles {};

TEST_F(SurfaceExportTest, WritesObjThatSewsTextually)
{
    const SurfaceMesh surface = twoPatches();
    EXPECT_TRUE(exportObj(surface, twoNames(), path("a.obj")).empty());
    std::istringstream lines(read("a.obj"));
    std::vector<std::string> v, vt, vn, g, f;
    for (std::string line; std::getline(lines, line);)
        for (const auto& [keyword, list] :
             {std::pair{"v ", &v}, {"vt ", &vt}, {"vn ", &vn}, {"g ", &g}, {"f ", &f}})
            if (line.starts_with(keyword))
                list->push_back(line);
    ASSERT_EQ(v.size(), 6u);
    EXPECT_EQ(v[1], v[3]);
    EXPECT_EQ(v[2], v[4]);
    EXPECT_EQ(vt[1], "vt 100.5 0");
    EXPECT_EQ(vn[0], "vn 0 0.6 0.8");
    EXPECT_EQ(f, (std::vector<std::string>{"f 1/1/1 2/2/2 3/3/3", "f 5/5/5 4/4/4 6/6/6"}));
    EXPECT_EQ(g, (std::vector<std::string>{"g Inside_back", "g Inside_back_patch_5"}));

    const ImportedMesh again = importMesh(path("a.obj"));
    ASSERT_TRUE(again.mesh) << again.problem.english();
    EXPECT_EQ(again.mesh->points, surface.positions); // to the last bit
}

TEST_F(SurfaceExportTest, WritesPlyWithEverything)
{
    const SurfaceMesh surface = twoPatches();
    EXPECT_TRUE(exportPly(surface, twoNames(), path("a.ply")).empty());
    const ImportedMesh again = importMesh(path("a.ply"));
    ASSERT_TRUE(again.mesh) << again.problem.english();
    EXPECT_EQ(again.mesh->points, surface.positions);
    EXPECT_EQ(again.mesh->triangles, surface.topology->triangles);
    const std::string bytes = read("a.ply");
    EXPECT_EQ(bytes.substr(bytes.size() - 4), std::string("\5\0\0\0", 4)); // the last face's patch
}

TEST_F(SurfaceExportTest, GivesEveryPatchASafeNameOfItsOwn)
{
    const SurfaceMesh surface = twoPatches();
    for (const char* name : {"", "# no comment", "a\nf 1 1 1", "Kopfst\xc3\xbctze / links", "patch_5"}) {
        const Design design =
            Design().with({{}, {{ElementId{2}, nullptr, makeElement(Patch{.name = name, .outline = {}})}}});
        EXPECT_TRUE(exportObj(surface, design, path("a.obj")).empty());
        const ImportedMesh again = importMesh(path("a.obj"));
        ASSERT_TRUE(again.mesh);
        ASSERT_EQ(again.mesh->parts.size(), 2u);
        EXPECT_EQ(again.mesh->parts[0].name.find_first_of(" \n#/"), std::string::npos);
        EXPECT_NE(again.mesh->parts[0].name, again.mesh->parts[1].name);
    }
}

TEST_F(SurfaceExportTest, ReportsWhatCannotBeWritten)
{
    EXPECT_FALSE(exportObj(twoPatches(), Design(), path("none/a.obj")).empty());
    EXPECT_FALSE(exportPly(twoPatches(), Design(), path("none/a.ply")).empty());
}

} // namespace
} // namespace bolster
