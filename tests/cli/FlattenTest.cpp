// `bolster flatten`, as a script calls it.
#include "../model/TestFiles.h"
#include "ProgramRun.h"
#include "TestPaths.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <QDir>

#include <algorithm>
#include <cmath>

namespace bolster {
namespace {

using Json = nlohmann::json;

class FlattenTest : public TestFiles {
protected:
    void SetUp() override
    {
        // A seat and a back that stand on each other, 400 wide, 300 and 500 mm large; centimetres, y upwards.
        write("chair.obj", "v 0 0 0\nv 40 0 0\nv 40 0 -30\nv 0 0 -30\nv 40 50 -30\nv 0 50 -30\n"
                           "g Seat\nf 1 2 3 4\ng Back\nf 4 3 5 6\n");
    }

    ProgramRun flatten(const QString& file, const QStringList& more = {}) const
    {
        return callCommandLine(QStringList{"flatten", file, "--out", path("out.json")} + more);
    }

    Json made() const { return Json::parse(read("out.json")); }

    std::size_t count(const std::string& kind) const
    {
        const Json design = made();
        return static_cast<std::size_t>(std::ranges::count_if(
            design["elements"], [&](const Json& element) { return element["kind"] == kind; }));
    }

    void expectRefused(const QStringList& more, const std::string& words, int code = 2) const
    {
        const ProgramRun run = flatten(path("chair.obj"), more);
        EXPECT_EQ(run.exitCode, code) << more.join(' ').toStdString();
        EXPECT_NE(run.err.find(words), std::string::npos) << more.join(' ').toStdString() << "\n" << run.err;
        EXPECT_FALSE(QFile::exists(path("out.json")));
    }
};

TEST_F(FlattenTest, GroupsBecomePatchesOfTheirNames)
{
    const ProgramRun run =
        flatten(path("chair.obj"), {"--unit", "cm", "--up", "y", "--report", path("report.json")});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(count("patch"), 2u);
    EXPECT_EQ(count("seam"), 1u);
    const Json report = Json::parse(read("report.json"));
    ASSERT_EQ(report["pieces"].size(), 2u);
    EXPECT_EQ(report["pieces"][0]["name"], "Seat");
    EXPECT_NEAR(report["pieces"][0]["area_mm2"], 400 * 300, 1);
    EXPECT_NEAR(report["pieces"][1]["area_mm2"], 400 * 500, 1);
    EXPECT_NEAR(report["seams"][0]["first_mm"], 400, 0.2);
    EXPECT_EQ(callCommandLine({"check", path("out.json")}).exitCode, 0);
    // What is there is never replaced.
    const std::string kept = read("out.json");
    EXPECT_EQ(flatten(path("chair.obj")).exitCode, 1);
    EXPECT_EQ(read("out.json"), kept);
}

TEST_F(FlattenTest, TheDesignIsWrittenAlsoWhenTheReportCannotBe)
{
    const ProgramRun run = flatten(path("chair.obj"), {"--unit", "cm", "--report", "/dev/full"});
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_NE(run.out.find("wrote " + path("out.json").toStdString()), std::string::npos) << run.out;
    EXPECT_NE(run.err.find("/dev/full\" cannot be written"), std::string::npos) << run.err;
    EXPECT_EQ(count("patch"), 2u);
}

TEST_F(FlattenTest, BendsPartWhatGroupsDoNot)
{
    ASSERT_EQ(flatten(path("chair.obj"), {"--by", "angle:80"}).exitCode, 0);
    EXPECT_EQ(count("patch"), 2u);
    ASSERT_TRUE(QFile::remove(path("out.json")));
    ASSERT_EQ(flatten(path("chair.obj"), {"--by", "angle:100"}).exitCode, 0);
    EXPECT_EQ(count("patch"), 1u);
}

TEST_F(FlattenTest, FacesOfCadFilesAreParted)
{
    const QString seat = QString::fromStdString(test::dataFolder() + "/frames/two-faces.step");
    ASSERT_EQ(flatten(seat, {"--by", "faces"}).exitCode, 0);
    EXPECT_EQ(count("patch"), 2u);
    EXPECT_EQ(count("seam"), 1u);
    ASSERT_TRUE(QFile::remove(path("out.json")));
    ASSERT_EQ(flatten(seat).exitCode, 0);
    EXPECT_EQ(count("patch"), 1u) << "it is one part, and flat";
    ASSERT_TRUE(QFile::remove(path("out.json")));
    ASSERT_EQ(flatten(path("chair.obj"), {"--by", "faces"}).exitCode, 0) << "a mesh is cut where it bends";
    EXPECT_EQ(count("patch"), 2u);
}

TEST_F(FlattenTest, AFileInInchesIsInInches)
{
    const QString part = QString::fromStdString(test::dataFolder() + "/frames/featuretype.STEP");
    ASSERT_EQ(flatten(part, {"--by", "faces", "--report", path("report.json")}).exitCode, 0);
    const Json pieces = Json::parse(read("report.json"))["pieces"];
    EXPECT_EQ(pieces.size(), 96u) << "as many as it has faces";
    for (const Json& piece : pieces)
        EXPECT_GT(piece["area_mm2"], 20) << piece["name"];
}

TEST_F(FlattenTest, WrongWordsAreSaidBeforeAnythingIsDone)
{
    expectRefused({"--by", "colour"}, "--by is groups, faces or angle:DEG, not \"colour\"");
    expectRefused({"--by", "angle:x"}, "the angle of --by");
    expectRefused({"--fabric", "colour=1"}, "--fabric knows poisson, stiffness and bending");
    expectRefused({"--grain", "left"}, "--grain is up, back, side or an angle");
    expectRefused({"--along", path("missing.json")}, "missing.json");
    expectRefused({"--report", path("nowhere/report.json")}, "nowhere", 1);
}

/// As CAD leaves them between two faces.
TEST_F(FlattenTest, WhatIsTooNarrowToBeSewnIsLeftOut)
{
    write("sliver.obj", "v 0 0 0\nv 100 0 0\nv 100.001 0 0\nv 200 0 0\nv 0 100 0\nv 100 100 0\nv 100.001 100 0\n"
                        "v 200 100 0\ng Left\nf 1 2 6 5\ng Sliver\nf 2 3 7 6\ng Right\nf 3 4 8 7\n");
    const ProgramRun run = flatten(path("sliver.obj"), {"--by", "groups"});
    EXPECT_EQ(run.exitCode, 0) << "a millionth of the form counts for nothing; " << run.err;
    EXPECT_NE(run.err.find("Sliver is left out: it is too narrow"), std::string::npos) << run.err;
    EXPECT_EQ(count("patch"), 2u);
    EXPECT_EQ(callCommandLine({"check", path("out.json")}).exitCode, 0);
}

TEST_F(FlattenTest, WhatIsClosedDividesItselfWhenAsked)
{
    write("box.obj",
          "g Box\nv 0 0 0\nv 400 0 0\nv 400 300 0\nv 0 300 0\nv 0 0 120\nv 400 0 120\n"
          "v 400 300 120\nv 0 300 120\nf 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    const ProgramRun refused = flatten(path("box.obj"));
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_NE(refused.err.find("--divide"), std::string::npos) << refused.err;

    const ProgramRun small = flatten(path("box.obj"), {"--divide", "--edge", "300"});
    EXPECT_EQ(small.exitCode, 2);
    EXPECT_NE(small.err.find("a shorter --edge"), std::string::npos) << small.err;

    // In metres it would have to be divided into pieces far below any edge.
    write("metres.obj",
          "g Box\nv 0 0 0\nv .4 0 0\nv .4 .3 0\nv 0 .3 0\nv 0 0 .12\nv .4 0 .12\n"
          "v .4 .3 .12\nv 0 .3 .12\nf 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    const ProgramRun metres = flatten(path("metres.obj"), {"--divide"});
    EXPECT_EQ(metres.exitCode, 2);
    EXPECT_TRUE(metres.err.starts_with("warning: --unit first")) << metres.err;
    EXPECT_NE(metres.err.find("with --unit m it would be 0.4 m"), std::string::npos) << metres.err;
    EXPECT_EQ(metres.err.find("a shorter --edge"), std::string::npos) << metres.err;
    EXPECT_EQ(metres.err.find("divide it"), std::string::npos) << "that would not help: " << metres.err;

    const ProgramRun run = flatten(path("box.obj"), {"--divide", "--report", path("report.json")});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_LE(count("patch"), 6u);
    double area = 0;
    const Json report = Json::parse(read("report.json"));
    for (const Json& piece : report["pieces"])
        area += piece["area_mm2"].get<double>();
    EXPECT_NEAR(area, 2 * (400 * 300 + 400 * 120 + 300 * 120), 500);
    EXPECT_EQ(callCommandLine({"check", path("out.json")}).exitCode, 0);
}

TEST_F(FlattenTest, TheFormKeepsItsCoverOutside)
{
    write("box.obj", "g Box\nv 0 0 0\nv .4 0 0\nv .4 .3 0\nv 0 .3 0\nv 0 0 .12\nv .4 0 .12\n"
                     "v .4 .3 .12\nv 0 .3 .12\nf 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    const QStringList words{"--divide", "--unit", "m", "--up", "y"};
    const ProgramRun without = flatten(path("box.obj"), words);
    ASSERT_EQ(without.exitCode, 0) << without.err;
    EXPECT_NE(without.err.find("--frame puts the form under it"), std::string::npos) << without.err;
    EXPECT_EQ(count("frame"), 0u);
    ASSERT_TRUE(QFile::remove(path("out.json")));

    const ProgramRun run = flatten(path("box.obj"), words + QStringList{"--frame"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(run.err.find("--frame"), std::string::npos) << run.err;
    const Json design = made();
    const auto frame =
        std::ranges::find_if(design["elements"], [](const Json& element) { return element["kind"] == "frame"; });
    ASSERT_NE(frame, design["elements"].end());
    EXPECT_EQ((*frame)["file"], "box.obj");
    EXPECT_EQ((*frame)["contact"], true);
    EXPECT_EQ((*frame)["scale"], 1000);
    EXPECT_NEAR((*frame)["rotation"][1].get<double>(), std::sqrt(0.5), 1e-6) << "y points up in the file";
    EXPECT_EQ(callCommandLine({"solve", path("out.json")}).exitCode, 0);

    ASSERT_TRUE(QDir(path("")).mkdir("elsewhere"));
    const ProgramRun elsewhere = callCommandLine(
        QStringList{"flatten", path("box.obj"), "--out", path("elsewhere/out.json"), "--frame"} + words);
    EXPECT_EQ(elsewhere.exitCode, 2);
    EXPECT_NE(elsewhere.err.find("a design finds its files in its own folder or below"), std::string::npos)
        << elsewhere.err;

    // A link leads out of the folder, where designs do not look; one that leads to where the form is does no harm.
    ASSERT_TRUE(QFile::link(path("box.obj"), path("elsewhere/link.obj")));
    const ProgramRun linked = callCommandLine(
        QStringList{"flatten", path("elsewhere/link.obj"), "--out", path("elsewhere/out.json"), "--frame"} + words);
    EXPECT_EQ(linked.exitCode, 2) << linked.err;
    ASSERT_TRUE(QFile::link(path("elsewhere"), path("door")));
    ASSERT_TRUE(QFile::copy(path("box.obj"), path("elsewhere/box.obj")));
    const ProgramRun through = callCommandLine(
        QStringList{"flatten", path("door/box.obj"), "--out", path("elsewhere/out.json"), "--frame"} + words);
    EXPECT_EQ(through.exitCode, 0) << through.err;
    EXPECT_EQ(callCommandLine({"check", path("elsewhere/out.json")}).exitCode, 0);
}

TEST_F(FlattenTest, WhatCannotBeLaidFlatIsSaid)
{
    write("box.obj", "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nv 0 0 9\nv 9 0 9\nv 9 9 9\nv 0 9 9\n"
                     "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    const ProgramRun run = flatten(path("box.obj"));
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_NE(run.err.find("closed all around"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("--by angle:DEG"), std::string::npos) << run.err;
    EXPECT_FALSE(QFile::exists(path("out.json")));
}

} // namespace
} // namespace bolster
