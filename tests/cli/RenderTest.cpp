#include "../model/TestFiles.h"
#include "ProgramRun.h"
#include "SavedViews.h"
#include "TestPaths.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>

#include <algorithm>
#include <csignal>
#include <sys/resource.h>

namespace bolster {
namespace {

using Json = nlohmann::json;

/// A square of cloth on two rails, with two colourways.
Json dressedHammock()
{
    return Json::parse(R"({"format": "bolster-design", "version": 1, "unit": "mm",
        "settings": {"edge_length": 25}, "elements": [
        {"id": 1, "kind": "fabric", "name": "Twill", "look": {"kind": "woven"}},
        {"id": 2, "kind": "patch", "name": "Seat", "fabric": 1,
         "outline": {"degree": 1, "closed": true, "points": [[0,0],[300,0],[300,300],[0,300]]}},
        {"id": 3, "kind": "fixation_curve", "name": "Front rail",
         "curve": {"degree": 1, "closed": false, "points": [[0,0,0],[300,0,0]]}},
        {"id": 4, "kind": "fixation_curve", "name": "Back rail",
         "curve": {"degree": 1, "closed": false, "points": [[0,315,0],[300,315,0]]}},
        {"id": 5, "kind": "fixation_seam", "patch": 2, "from": 0, "to": 1, "curve": 3},
        {"id": 6, "kind": "fixation_seam", "patch": 2, "from": 2, "to": 3, "curve": 4, "reversed": true},
        {"id": 7, "kind": "fabric", "name": "Green", "color": "#20a040"},
        {"id": 8, "kind": "colourway", "name": "Meadow", "fabrics": [{"patch": 2, "fabric": 7}]},
        {"id": 9, "kind": "colourway", "name": "Hide"}]})");
}

class Render : public TestFiles {
protected:
    void SetUp() override { m_design = write(QStringLiteral("hammock.json"), dressedHammock().dump()); }

    std::string bytes(const QString& name) const { return QFile::exists(path(name)) ? read(name) : std::string(); }
    ProgramRun run(const QString& image, const QStringList& more = {}) const
    {
        return callCommandLine(
            QStringList{"render", m_design, "--image", path(image), "--size", "64x48", "--samples", "4"} + more);
    }

    QString m_design;
};

TEST_F(Render, WritesTheSameBytesOnAnyNumberOfThreads)
{
    for (const QString& name : {QStringLiteral("a.png"), QStringLiteral("a.exr")}) {
        const ProgramRun one = run(name, {"--threads", "1"});
        ASSERT_EQ(one.exitCode, 0) << one.err;
        const std::string first = bytes(name);
        ASSERT_GT(first.size(), 100U);
        ASSERT_EQ(run(name, {"--threads", "3"}).exitCode, 0);
        EXPECT_EQ(bytes(name), first) << name.toStdString();
    }
}

TEST_F(Render, DrawsEveryColourwayFromEveryViewAndGoesOnWhereItWasEnded)
{
    const auto all = [this](const QString& folder, const QStringList& more = {}) {
        return callCommandLine(QStringList{"render", m_design, "--all", path(folder), "--size", "64x48",
                                           "--samples", "4", "--views", "front,top"} +
                               more);
    };
    ASSERT_EQ(all("whole").exitCode, 0);
    const QStringList names{"01-Meadow-front.png", "01-Meadow-top.png", "02-Hide-front.png", "02-Hide-top.png"};
    EXPECT_EQ(QDir(path("whole")).entryList({"*.png"}, QDir::Files, QDir::Name), names);
    ASSERT_EQ(run("one.png", {"--fabric", "Meadow", "--view", "top"}).exitCode, 0);
    EXPECT_EQ(bytes("whole/01-Meadow-top.png"), bytes("one.png")) << "the same picture as by itself";

    ASSERT_EQ(all("parts", {"--part", "1/2"}).exitCode, 0);
    EXPECT_EQ(QDir(path("parts")).entryList({"*.png"}, QDir::Files, QDir::Name), (QStringList{names[1], names[3]}));
    ASSERT_EQ(all("parts").exitCode, 0);
    for (const QString& name : names)
        EXPECT_EQ(bytes("parts/" + name), bytes("whole/" + name)) << name.toStdString();
    const ProgramRun again = all("parts");
    EXPECT_EQ(again.exitCode, 0);
    EXPECT_NE(again.out.find("all pictures are there"), std::string::npos);

    write("parts/" + names[0], "");
    EXPECT_EQ(all("parts").exitCode, 0);
    EXPECT_EQ(bytes("parts/" + names[0]), bytes("whole/" + names[0])) << "an empty file is no picture";

    const ProgramRun other = all("parts", {"--transparent"});
    EXPECT_EQ(other.exitCode, 1);
    EXPECT_NE(other.err.find("other options"), std::string::npos) << other.err;
    EXPECT_EQ(all("maps", {"--map", "strain"}).exitCode, 0);
    EXPECT_EQ(QDir(path("maps")).entryList({"*.png"}, QDir::Files, QDir::Name),
              (QStringList{"front.png", "top.png"}));
    for (const QStringList& wrong :
         {QStringList{"--image", path("x.png")}, QStringList{"--fabric", "Hide"}, QStringList{"--format", "gif"},
          QStringList{"--part", "2/2"}, QStringList{"--views", "nowhere"}})
        EXPECT_EQ(callCommandLine(QStringList{"render", m_design, "--all", path("wrong")} + wrong).exitCode, 2)
            << wrong.join(' ').toStdString();
    EXPECT_FALSE(QFile::exists(path("wrong")));
    EXPECT_EQ(run("x.png", {"--jobs", "3"}).exitCode, 2) << "that is of a series";
}

TEST_F(Render, ShowsAColourwayAndAMap)
{
    ASSERT_EQ(run("own.png").exitCode, 0);
    ASSERT_EQ(run("hide.png", {"--fabric", "Hide"}).exitCode, 0);
    ASSERT_EQ(run("meadow.png", {"--fabric", "Meadow"}).exitCode, 0);
    EXPECT_EQ(bytes("own.png"), bytes("hide.png"));
    EXPECT_NE(bytes("own.png"), bytes("meadow.png"));
    for (const char* const map : {"strain", "along", "across", "shear", "curvature", "thickness", "checker"}) {
        const ProgramRun drawn = run("map.png", {"--map", map});
        EXPECT_EQ(drawn.exitCode, 0) << map << drawn.err;
        EXPECT_NE(bytes("map.png"), bytes("own.png")) << map;
    }
    const ProgramRun strain = run("map.png", {"--map", "along"});
    EXPECT_NE(strain.out.find("Seat"), std::string::npos) << strain.out;
}

TEST_F(Render, ShowsTheFrameInItsMaterialUnlessToldNotTo)
{
    Json design = dressedHammock();
    write("posts.obj", "v 310 0 -200\nv 340 0 -200\nv 340 0 100\nv 310 0 100\nf 1 2 3 4\n");
    design["elements"].push_back({{"id", 10}, {"kind", "frame"}, {"name", "Posts"}, {"file", "posts.obj"}});
    ASSERT_EQ(run("alone.png").exitCode, 0);
    m_design = write(QStringLiteral("hammock.json"), design.dump());
    ASSERT_EQ(run("plain.png").exitCode, 0);
    ASSERT_EQ(run("without.png", {"--no-frame"}).exitCode, 0);
    const auto pixels = [&](const QString& name) { // without the words in the file, which tell the designs apart
        const std::string all = bytes(name);
        return all.substr(std::min(all.find("IDAT"), all.size()));
    };
    EXPECT_EQ(pixels("without.png"), pixels("alone.png"));
    EXPECT_NE(pixels("plain.png"), pixels("alone.png"));
    design["elements"].back()["material"] = {{"kind", "wood"}};
    m_design = write(QStringLiteral("hammock.json"), design.dump());
    ASSERT_EQ(run("wood.png").exitCode, 0);
    EXPECT_NE(pixels("wood.png"), pixels("plain.png"));
    ASSERT_EQ(run("map.png", {"--map", "strain"}).exitCode, 0);
    ASSERT_EQ(run("map-without.png", {"--map", "strain", "--no-frame"}).exitCode, 0);
    EXPECT_NE(pixels("map.png"), pixels("map-without.png"));
}

TEST_F(Render, WritesATurntableAndASheet)
{
    ASSERT_EQ(run("turn.png", {"--turntable", "3"}).exitCode, 0);
    for (const char* const name : {"turn-001.png", "turn-002.png", "turn-003.png"})
        EXPECT_GT(bytes(name).size(), 100U) << name;
    EXPECT_NE(bytes("turn-001.png"), bytes("turn-002.png"));
    const ProgramRun sheet = run("sheet.png", {"--sheet"});
    EXPECT_EQ(sheet.exitCode, 0) << sheet.err;
    EXPECT_GT(bytes("sheet.png").size(), 100U);
}

TEST_F(Render, LooksFromAViewThatTheWindowHasSaved)
{
    Viewpoint above;
    above.target = {150, 157, 0};
    above.distance = 900;
    above.azimuth = 0.2;
    above.elevation = 1.2;
    SavedViews::save("Low & left", above);
    ASSERT_EQ(run("own.png").exitCode, 0);
    const ProgramRun saved = run("saved.png", {"--view", "Low & left"});
    EXPECT_EQ(saved.exitCode, 0) << saved.err;
    EXPECT_NE(bytes("own.png"), bytes("saved.png"));
    SavedViews::remove("Low & left");
    EXPECT_EQ(run("gone.png", {"--view", "Low & left"}).exitCode, 2);
}

/// With a limit on the size of files, which stops writing in the middle as a full disk does, and needs no rights.
ProgramRun runWithSmallFiles(const QStringList& arguments)
{
    QProcess process;
    process.setChildProcessModifier([] {
        const rlimit limit = {4096, 4096};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        std::signal(SIGXFSZ, SIG_IGN);
    });
    process.start(QString::fromStdString(test::program()), arguments);
    const bool ended = process.waitForFinished(120'000) && process.exitStatus() == QProcess::NormalExit;
    return {ended ? process.exitCode() : -1, process.readAllStandardOutput().toStdString(),
            process.readAllStandardError().toStdString()};
}

TEST_F(Render, WhereNoPictureCanBeIsSaidBeforeItIsDrawn)
{
    const ProgramRun got =
        runProgram({"render", m_design, "--image", path("none/a.png"), "--size", "8000x8000", "--samples", "256"});
    EXPECT_EQ(got.exitCode, 1);
    EXPECT_NE(got.err.find("none/a.png\" lies in a folder that is not there"), std::string::npos) << got.err;
}

TEST_F(Render, APictureThatDoesNotFitLeavesTheOlderOneAndIsAFailure)
{
    const auto keepsTheOld = [this](const QString& name, const QStringList& words) {
        write(name, "an older picture");
        const ProgramRun got = runWithSmallFiles(words);
        EXPECT_EQ(got.exitCode, 1) << words.join(' ').toStdString() << got.out;
        EXPECT_EQ(got.out.find("wrote"), std::string::npos) << got.out;
        EXPECT_NE(got.err.find(path(name).toStdString()), std::string::npos) << got.err;
        EXPECT_NE(got.err.find("cannot be written"), std::string::npos) << got.err;
        EXPECT_EQ(got.err.find("bolster-"), std::string::npos) << "a name that the user does not know: " << got.err;
        EXPECT_EQ(read(name), "an older picture");
    };
    for (const QString& name : {QStringLiteral("a.png"), QStringLiteral("a.tif"), QStringLiteral("a.exr")})
        keepsTheOld(name, {"render", m_design, "--image", path(name), "--size", "320x240", "--samples", "1"});
    keepsTheOld("turn-001.png", {"render", m_design, "--image", path("turn.png"), "--size", "320x240", "--samples",
                                 "1", "--turntable", "2"});
    keepsTheOld("solved.png", {"solve", m_design, "--image", path("solved.png")});
    EXPECT_EQ(QDir(m_folder.path()).entryList({".bolster*"}, QDir::Files | QDir::Hidden), QStringList());
}

TEST_F(Render, SaysWhatIsWrong)
{
    const auto refused = [this](const QStringList& words, const char* part) {
        const ProgramRun got = callCommandLine(QStringList{"render", m_design} + words);
        EXPECT_EQ(got.exitCode, 2) << words.join(' ').toStdString();
        EXPECT_NE(got.err.find(part), std::string::npos) << got.err;
    };
    const QString image = path("a.png");
    refused({}, "--image is missing");
    refused({"--image", path("a.jpg")}, ".png, .tif or .exr");
    refused({"--image", image, "--size", "9000x9000"}, "81 million pixels");
    refused({"--image", image, "--size", "20000x10"}, "16384 pixels a side");
    refused({"--image", image, "--size", "big"}, "like 1280x960");
    refused({"--image", image, "--view", "behind"}, "unknown view \"behind\"; there are three-quarter");
    refused({"--image", image, "--view", "30,95"}, "unknown view");
    refused({"--image", image, "--fabric", "Sky"}, "no colourway \"Sky\"; there are \"Meadow\", \"Hide\"");
    refused({"--image", image, "--map", "heat"}, "unknown map \"heat\"");
    refused({"--image", image, "--map", "deviation"}, "needs a scan");
    refused({"--image", image, "--sheet", "--map", "strain"}, "--sheet");
    refused({"--image", image, "--sheet", "--size", "6000x6000"}, "64 million pixels");
    EXPECT_FALSE(QFile::exists(image));
    const ProgramRun unwritable = run("missing/a.png");
    EXPECT_EQ(unwritable.exitCode, 1);
    EXPECT_NE(unwritable.err.find("missing/a.png"), std::string::npos) << unwritable.err;
}

} // namespace
} // namespace bolster
