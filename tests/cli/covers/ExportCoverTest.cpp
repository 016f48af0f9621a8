// Covers as files, read by readers that share nothing with the writers (check_*.py).
#include "../../model/TestFiles.h"
#include "../ProgramRun.h"
#include "MeshImport.h"
#include "TestPaths.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <QDir>
#include <QProcess>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace bolster {
namespace {

using Json = nlohmann::json;

/// The sample's cushion, half a metre wide and open below, on a board, coarse, with a row of stitches.
Json cushion()
{
    std::ifstream file(test::sourceFolder() + "/resources/samples/box-cushion/box-cushion.json");
    Json design = Json::parse(file);
    design["settings"]["edge_length"] = 40;
    for (Json& element : design["elements"])
        if (element["id"] == 16)
            element["trim"] = {{"stitch", "single"}, {"thread", "#ff0000"}};
    design["elements"].push_back({{"id", 40},
                                  {"kind", "frame"},
                                  {"name", "Board"},
                                  {"file", "board.obj"},
                                  {"material", {{"kind", "wood"}}}});
    return design;
}

/// From -200 to 200, 20 mm thick, its top 10 mm above the cushion's lower edge.
constexpr const char* board = "v -200 -200 -10\nv 200 -200 -10\nv 200 200 -10\nv -200 200 -10\n"
                              "v -200 -200 10\nv 200 -200 10\nv 200 200 10\nv -200 200 10\n"
                              "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

class ExportCover : public TestFiles {
protected:
    void SetUp() override
    {
        write(QStringLiteral("board.obj"), board);
        save(cushion());
    }

    void save(const Json& design) { m_design = write(QStringLiteral("cushion.json"), design.dump()); }

    ProgramRun run(const QStringList& more) const
    {
        return callCommandLine(QStringList{"export", m_design} + more);
    }

    /// What the reader for such files prints.
    Json checked(const char* reader, const QString& name) const
    {
        const QString tool = QString::fromStdString(test::sourceFolder() + "/tests/cli/covers/" + reader);
        QProcess process;
        process.start("/usr/bin/python3", {tool, path(name)});
        EXPECT_TRUE(process.waitForFinished(60000));
        const std::string text = process.readAllStandardOutput().toStdString();
        EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
        const Json found = Json::parse(text.empty() ? R"({"errors": ["nothing read"]})" : text);
        EXPECT_EQ(found["errors"], Json::array()) << name.toStdString();
        return found;
    }

    QString m_design;
};

const Json* mesh(const Json& read, const std::string& kind)
{
    for (const Json& each : read["meshes"])
        if (each["kind"] == kind)
            return &each;
    return nullptr;
}

const Json* material(const Json& read, const std::string& name)
{
    for (const Json& each : read["materials"])
        if (each["name"] == name)
            return &each;
    return nullptr;
}

/// Nothing would read it by that name.
TEST_F(ExportCover, RefusesOtherEndings)
{
    const ProgramRun exported = run({"--glb", path("c.gltf")});
    EXPECT_EQ(exported.exitCode, 2);
    EXPECT_NE(exported.err.find("--glb must end in .glb"), std::string::npos) << exported.err;
    EXPECT_EQ(run({"--stl", path("c.obj")}).exitCode, 2);
    EXPECT_FALSE(QFile::exists(path("c.gltf")));
}

TEST_F(ExportCover, WritesGltfThatKeepsToTheSpecification)
{
    const ProgramRun exported = run({"--glb", path("c.glb")});
    ASSERT_EQ(exported.exitCode, 0) << exported.err;
    const Json read = checked("check_glb.py", "c.glb");
    EXPECT_EQ(read["variants"], Json({"Own fabrics", "Blue", "Cognac leather"}));
    EXPECT_EQ(std::ranges::count_if(read["meshes"], [](const Json& m) { return m["kind"] == "patch"; }), 5);
    for (const Json& each : read["meshes"]) {
        EXPECT_LT(each["facing_in"].get<double>(), 0.02) << each["name"];
        EXPECT_EQ(each["flat_places"], 0) << each["name"] << ": no direction for the slopes of its fabric";
    }
    ASSERT_TRUE(mesh(read, "trim"));
    EXPECT_TRUE(mesh(read, "seam"));
    EXPECT_TRUE(mesh(read, "frame"));
    EXPECT_EQ(run({"--glb", path("again.glb"), "--no-frame"}).exitCode, 0);
    EXPECT_FALSE(mesh(checked("check_glb.py", "again.glb"), "frame"));
}

TEST_F(ExportCover, StandsOnTheFloorInMetres)
{
    ASSERT_EQ(run({"--glb", path("c.glb"), "--no-frame"}).exitCode, 0);
    const Json read = checked("check_glb.py", "c.glb");
    const auto at = [&](const char* end, int axis) { return read[end][axis].get<double>(); };
    EXPECT_NEAR(at("low", 1), 0, 1e-6);
    EXPECT_NEAR(at("low", 0), -at("high", 0), 1e-6);
    EXPECT_NEAR(at("low", 2), -at("high", 2), 1e-6);
    EXPECT_GT(at("high", 0) - at("low", 0), 0.5);
    EXPECT_LT(at("high", 0) - at("low", 0), 0.65);
    EXPECT_GT(at("high", 1), 0.09);
    EXPECT_LT(at("high", 1), 0.25);
}

TEST_F(ExportCover, LaysFabricsInTheirRealSize)
{
    ASSERT_EQ(run({"--glb", path("c.glb")}).exitCode, 0);
    const Json read = checked("check_glb.py", "c.glb");
    const Json *own = material(read, "Weave, sand"), *blue = material(read, "Weave, blue");
    ASSERT_TRUE(own && blue);
    EXPECT_FALSE((*own)["pbrMetallicRoughness"]["baseColorTexture"].contains("extensions"))
        << "who knows no transforms sees the first colourway as it is";
    // Weaves of 4 and 3 mm: tiles of both hold whole repeats.
    const Json scale =
        (*blue)["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"]["scale"];
    for (const Json& each : read["meshes"]) {
        if (each["name"] != "Top")
            continue;
        const double tiles = each["tiles"][0];
        EXPECT_NEAR(500 / tiles, std::round(500 / tiles / 4) * 4, 0.5);
        EXPECT_NEAR(500 / tiles / scale[0].get<double>(), std::round(500 / tiles / scale[0].get<double>() / 3) * 3,
                    0.5);
    }
    EXPECT_GE(read["images"].size(), 6u);
}

TEST_F(ExportCover, GivesEachDirectionItsOwnCoordinates)
{
    Json design = cushion();
    for (Json& element : design["elements"])
        if (element["id"] == 20)
            element["look"]["rotation"] = 30;
    save(design);
    ASSERT_EQ(run({"--glb", path("c.glb"), "--usdz", path("c.usdz")}).exitCode, 0);
    const Json read = checked("check_glb.py", "c.glb");
    EXPECT_EQ((*mesh(read, "patch"))["sets"], 2);
    EXPECT_EQ((*material(read, "Weave, blue"))["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"], 1);
    checked("check_usdz.py", "c.usdz");
}

TEST_F(ExportCover, WritesTheSameBytesAgain)
{
    const QStringList kinds = {"glb", "usdz", "stl", "3mf", "obj", "step", "html"};
    QStringList first, second;
    for (const QString& kind : kinds) {
        first << "--" + kind << path("a." + kind);
        second << "--" + kind << path("b." + kind);
    }
    ASSERT_EQ(run(first).exitCode, 0);
    ASSERT_EQ(run(second).exitCode, 0);
    for (const QString& kind : kinds)
        if (kind != "obj") { // it names its materials' file
            EXPECT_EQ(read("a." + kind), read("b." + kind)) << kind.toStdString();
        }
    EXPECT_EQ(read("a-fabric-1-weave-sand-color.jpg"), read("b-fabric-1-weave-sand-color.jpg"));
}

TEST_F(ExportCover, WritesClosedBodies)
{
    const ProgramRun exported = run({"--stl", path("c.stl"), "--3mf", path("c.3mf"), "--thickness", "2"});
    ASSERT_EQ(exported.exitCode, 0) << exported.err;
    for (const char* const name : {"c.stl", "c.3mf"}) {
        const Json read = checked("check_solid.py", name);
        // A top of 0.25 m2 and sides of 0.2 m2, a little stretched, 2 mm thick.
        EXPECT_GT(read["volume"].get<double>(), 0.85 * 450'000 * 2) << name;
        EXPECT_LT(read["volume"].get<double>(), 1.35 * 450'000 * 2) << name;
    }
    EXPECT_NE(exported.out.find("2 mm thick"), std::string::npos) << exported.out;
}

TEST_F(ExportCover, WritesTheFoamBetweenFrameAndCover)
{
    const ProgramRun exported = run({"--foam", path("f.stl"), "--density", "40"});
    ASSERT_EQ(exported.exitCode, 0) << exported.err;
    const Json read = checked("check_solid.py", "f.stl");
    const double volume = read["volume"];
    EXPECT_GT(volume, 500 * 500 * 100 * 0.95);
    EXPECT_NE(exported.out.find("kg/m"), std::string::npos) << exported.out;
    ASSERT_EQ(run({"--foam", path("f.3mf")}).exitCode, 0);
    checked("check_solid.py", "f.3mf");

    const ProgramRun step = run({"--foam", path("f.step"), "--density", "40"});
    ASSERT_EQ(step.exitCode, 0) << step.err;
    const Json body = checked("check_step.py", "f.step");
    EXPECT_NEAR(body["volume"].get<double>(), volume, 0.002 * volume);
    EXPECT_LE(body["faces"].get<int>(), 10'500);
    EXPECT_NE(step.out.find("of its surface is within"), std::string::npos) << step.out;

    Json alone = cushion();
    alone["elements"].erase(alone["elements"].size() - 1);
    save(alone);
    ASSERT_EQ(run({"--foam", path("whole.stl")}).exitCode, 0);
    // The board's upper half lies in it.
    EXPECT_NEAR(checked("check_solid.py", "whole.stl")["volume"].get<double>() - volume, 400 * 400 * 10, 400 * 400);
    EXPECT_NE(run({"--foam", path("f.obj")}).err.find(".3mf"), std::string::npos);
}

TEST_F(ExportCover, WritesObjWithItsMaterials)
{
    ASSERT_EQ(run({"--obj", path("my chair.obj"), "--no-frame"}).exitCode, 0);
    const std::string obj = read("my chair.obj"), mtl = read("my_chair.mtl");
    EXPECT_NE(obj.find("mtllib my_chair.mtl\n"), std::string::npos);
    EXPECT_NE(mtl.find("map_Kd my_chair-fabric-1-weave-sand-color.jpg\n"), std::string::npos) << mtl;
    EXPECT_FALSE(read("my_chair-fabric-1-weave-sand-color.jpg").empty());
    const ImportedMesh again = importMesh(path("my chair.obj"));
    EXPECT_EQ(again.said.up, UpAxis::Z) << "its first line says it";
    EXPECT_EQ(again.said.millimetresPerUnit, 1);
    ASSERT_TRUE(again.mesh) << again.problem.english();
    EXPECT_GE(again.mesh->parts.size(), 7u);
    EXPECT_NEAR(again.mesh->boundingBox().sizes().x(), 540, 60) << "millimetres";
}

TEST_F(ExportCover, WritesUsdzThatKeepsToTheSpecification)
{
    ASSERT_EQ(run({"--usdz", path("c.usdz")}).exitCode, 0);
    const Json read = checked("check_usdz.py", "c.usdz");
    EXPECT_EQ(read["variants"].size(), 3u);
    EXPECT_GE(read["textures"].size(), 6u);
}

TEST_F(ExportCover, WritesCurvesForCad)
{
    Json design = cushion();
    for (Json& element : design["elements"])
        if (element["id"] == 7)
            element["name"] = "B\u00f6den \\ 'x'";
    save(design);
    ASSERT_EQ(run({"--step", path("c.step")}).exitCode, 0);
    const Json read = checked("check_step.py", "c.step");
    EXPECT_EQ(read["sets"], Json({{"fixation curves", 1}, {"seams", 8}}));
    const Json& edge = read["curves"][0];
    EXPECT_EQ(edge["name"], "fixation curve 7 \"B\\X2\\00F6\\X0\\den \\\\ ''x''\"");
    EXPECT_EQ(edge["closed"], true);
    EXPECT_EQ(edge["points"].front(), edge["points"].back());
    EXPECT_EQ(edge["points"][1], Json({250.0, -250.0, 0.0}));
}

TEST_F(ExportCover, WritesAPageThatIsWhole)
{
    Json design = cushion();
    for (Json& element : design["elements"])
        if (element["id"] == 2)
            element["name"] = "</script><b>Top";
    save(design);
    ASSERT_EQ(run({"--html", path("c.html")}).exitCode, 0);
    const std::string page = read("c.html");
    EXPECT_LT(page.size(), 10'000'000u);
    EXPECT_EQ(checked("check_glb.py", "c.html")["variants"].size(), 3u);
    EXPECT_NE(page.find("three.js authors"), std::string::npos) << "the licence";
    EXPECT_EQ(page.find("</script><b>"), std::string::npos);
    EXPECT_EQ(page.find("{{"), std::string::npos);
    EXPECT_EQ(page.find(" src=\"http"), std::string::npos);
    EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
}

TEST_F(ExportCover, RefusesWhatThereIsNotWithoutAFile)
{
    Json empty = cushion();
    std::erase_if(empty["elements"].get_ref<Json::array_t&>(), [](const Json& e) { return e["kind"] != "fabric"; });
    save(empty);
    const ProgramRun none = run({"--glb", path("c.glb")});
    EXPECT_EQ(none.exitCode, 2);
    EXPECT_NE(none.err.find("no patch"), std::string::npos) << none.err;
    EXPECT_FALSE(QFile::exists(path("c.glb")));

    save(cushion());
    EXPECT_EQ(run({"--obj", path("board.obj")}).exitCode, 2) << "the design's frame";
    EXPECT_EQ(read("board.obj"), board);
    EXPECT_EQ(run({"--glb", path("x"), "--usdz", path("x")}).exitCode, 2);
    EXPECT_EQ(run({"--dxf", path("x"), "--usdz", path("x")}).exitCode, 2);
    EXPECT_EQ(run({"--stl", path("none/c.stl")}).exitCode, 1);
    EXPECT_EQ(run({"--stl", path("c.stl"), "--thickness", "0"}).exitCode, 2);
    EXPECT_EQ(QDir(m_folder.path()).entryList(QDir::Files).size(), 2) << "the design and its frame";
}

TEST_F(ExportCover, WritesPatternAndCoverAtOnce)
{
    const ProgramRun both = run({"--dxf", path("c.dxf"), "--stl", path("c.stl")});
    EXPECT_EQ(both.exitCode, 0) << both.err;
    EXPECT_TRUE(QFile::exists(path("c.dxf")));
    checked("check_solid.py", "c.stl");
}

} // namespace
} // namespace bolster
