// Files that somebody made to do harm: every command says no, with little memory, in little time, and touches
// nothing.
#include "../model/TestFiles.h"
#include "../project/CraftedProject.h"
#include "CurveEdits.h"
#include "DesignJson.h"
#include "ElementEdits.h"
#include "Journal.h"
#include "ProgramRun.h"
#include "Sanitizer.h"
#include "TestPaths.h"

#include <nlohmann/json.hpp>

#include <QDir>
#include <QFileInfo>

#include <cmath>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bolster::test {
namespace {

using Json = nlohmann::json;

bool contains(const std::string& text, std::string_view part)
{
    return text.find(part) != std::string::npos;
}

struct Cost {
    int exitCode = -1;
    double megabytes = 0; // most that were in memory at once, in the program or one that it started
    double seconds = 0;   // of processor time
};

/// Runs the program with its output thrown away.
Cost costOf(const QStringList& arguments)
{
    std::vector<std::string> words = {program()};
    for (const QString& argument : arguments)
        words.push_back(argument.toStdString());
    std::vector<char*> argv;
    for (std::string& word : words)
        argv.push_back(word.data());
    argv.push_back(nullptr);
    std::fflush(stdout); // else the child writes it, too
    const pid_t child = ::fork();
    if (child == 0) {
        ::freopen("/dev/null", "w", stdout);
        ::freopen("/dev/null", "w", stderr);
        ::execv(argv[0], argv.data());
        ::_exit(127);
    }
    int status = 0;
    rusage usage = {};
    if (::wait4(child, &status, 0, &usage) != child || !WIFEXITED(status))
        return {};
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return {WEXITSTATUS(status), static_cast<double>(usage.ru_maxrss) / 1'000,
            seconds(usage.ru_utime) + seconds(usage.ru_stime)};
}

class HostileFiles : public TestFiles {
protected:
    QString project(const QString& name, const std::function<void(CraftedProject&)>& fill) const
    {
        QFile::remove(path(name));
        CraftedProject crafted(path(name));
        fill(crafted);
        return path(name);
    }

    /// No command may need more for it than its size allows.
    void expectCheap(const QString& file) const
    {
        expectCheap(file, {{"check", file},
                           {"dump", file},
                           {"dump", file, "--history"},
                           {"history", file},
                           {"verify", file},
                           {"thumbnail", file, path("out.png")},
                           {"salvage", file, path("out.bolster")}});
    }

    /// Where all commands would take a minute together.
    void expectCheapToReadAndSalvage(const QString& file) const
    {
        expectCheap(file, {{"dump", file}, {"salvage", file, path("out.bolster")}});
    }

    void expectCheap(const QString& file, const std::vector<QStringList>& commands) const
    {
        const double size = static_cast<double>(QFileInfo(file).size()) / 1e6;
        for (const QStringList& command : commands) {
            QFile::remove(path("out.bolster"));
            const Cost cost = costOf(command);
            const std::string what = command.join(' ').toStdString();
            EXPECT_TRUE(cost.exitCode >= 0 && cost.exitCode <= 3) << what;
#ifndef BOLSTER_ADDRESS_SANITIZER
            EXPECT_LE(cost.megabytes, 512 + 20 * size) << what;
#endif
#ifdef NDEBUG
            EXPECT_LE(cost.seconds, 10) << what;
#endif
            std::printf("%4.0f MB, %4.1f s of %.1f MB: %s\n", cost.megabytes, cost.seconds, size,
                        command.front().toStdString().c_str());
        }
    }

    Design fabric(const std::string& name) const
    {
        return readDesign(R"({"format": "bolster-design", "version": 1, "elements": [
            {"id": 1, "kind": "fabric", "name": ")" +
                          name + R"("}]})")
            .design;
    }

    QString hammock(const QString& name = "seat.json") const
    {
        return write(name, R"({"format": "bolster-design", "version": 1, "unit": "mm",
            "settings": {"edge_length": 60}, "elements": [
            {"id": 1, "kind": "fabric", "name": "Leather"},
            {"id": 2, "kind": "patch", "name": "Seat", "fabric": 1,
             "outline": {"degree": 1, "closed": true, "points": [[0,0],[300,0],[300,300],[0,300]]}},
            {"id": 3, "kind": "fixation_curve", "name": "Front rail",
             "curve": {"degree": 1, "closed": false, "points": [[0,0,0],[300,0,0]]}},
            {"id": 4, "kind": "fixation_curve", "name": "Back rail",
             "curve": {"degree": 1, "closed": false, "points": [[0,280,0],[300,280,0]]}},
            {"id": 5, "kind": "fixation_seam", "patch": 2, "from": 0, "to": 1, "curve": 3},
            {"id": 6, "kind": "fixation_seam", "patch": 2, "from": 2, "to": 3, "curve": 4, "reversed": true}]})");
    }

    QString pipe(const QString& name) const
    {
        QFile::remove(path(name));
        EXPECT_EQ(::mkfifo(path(name).toUtf8().constData(), 0600), 0);
        return path(name);
    }
};

TEST_F(HostileFiles, AnEditThatUnpacksToMuchIsRefusedByItsFirstBytes)
{
    std::string repeated = cborList(50'000'000);
    for (int i = 0; i < 50'000'000; ++i)
        repeated.append("\x84\x01\x60\xf6\xf6", 5);
    const std::string bomb = packed(repeated);
    expectCheap(project("edit.bolster", [&](CraftedProject& crafted) { crafted.node(-1, bomb, {}); }));
    expectCheap(project("snapshot.bolster", [&](CraftedProject& crafted) {
        crafted.node(-1, Design(), fabric("Wool"));
        crafted.snapshot(0, bomb);
    }));
}

TEST_F(HostileFiles, ManySmallChangesInOrderAreLimitedToo)
{
    for (const std::uint32_t count : {999'000U, 3'000'000U}) {
        const std::string bytes = packed(cborOfNewElements(count, "1"), 1);
        expectCheap(project("many.bolster", [&](CraftedProject& crafted) { crafted.node(-1, bytes, {}); }));
    }
    const std::string large = packed(cborOfNewElements(1'000, std::string(60'000, 'x')));
    expectCheap(project("large.bolster", [&](CraftedProject& crafted) { crafted.node(-1, large, {}); }));
}

TEST_F(HostileFiles, AHistoryThatUnpacksToMuchIsWrittenAPieceAtATime)
{
    const std::string large = packed(cborOfNewElements(1'000, std::string(30'000, 'x')));
    expectCheap(project("history.bolster", [&](CraftedProject& crafted) {
        crafted.node(-1, Design(), fabric("Wool"));
        for (int i = 0; i < 60; ++i)
            crafted.node(0, large, {});
        crafted.stand(0);
    }));
    // What is just not refused.
    const std::string most = packed(cborOfNewElements(400, std::string(30'000, 'x')));
    expectCheap(project("most.bolster", [&](CraftedProject& crafted) {
        crafted.node(-1, Design(), fabric("Wool"));
        for (int i = 0; i < 11; ++i)
            crafted.node(0, most, {});
        crafted.stand(0);
    }));
}

TEST_F(HostileFiles, AHugeDesignThatIsWhatItSaysIsCheapToo)
{
    const auto changes = decodeChanges(cborOfNewElements(10'000, R"({"kind": "sofa"})"));
    ASSERT_TRUE(changes);
    const auto design = replayed({}, *changes);
    ASSERT_TRUE(design);
    expectCheap(project("sofas.bolster", [&](CraftedProject& crafted) {
        crafted.node(-1, packChanges(*changes), hashOf(design->design));
        crafted.snapshot(0, encodeDesign(design->design));
    }));
}

/// The name of a patch with as many points as there may be, over and over. Nothing is wrong with it.
TEST_F(HostileFiles, ManySmallEditsOfAHugeElementAreNotReplayedForEver)
{
    Design design = fabric("Wool");
    Patch patch;
    patch.fabric = ElementId{1};
    std::vector<Vec2> points;
    constexpr int count = 10'000;
    for (int i = 0; i < count; ++i)
        points.push_back(1000 * Vec2(std::cos(2 * M_PI * i / count), std::sin(2 * M_PI * i / count)));
    patch.outline = BSpline2(1, true, points);
    const auto renamed = [&](const Design& before, int i) {
        patch.name = std::to_string(i);
        return before.with({{}, {{ElementId{2}, nullptr, makeElement(patch)}}});
    };
    constexpr int edits = 1'000; // about twice what is looked at
    DesignHash hash;
    std::vector<Hash> hashes;
    for (int i = 0; i < edits; ++i)
        hashes.push_back(hash.follow(renamed(design, i)));
    const auto write = [&](const QString& name, int most, bool lastIsWrong) {
        return project(name, [&](CraftedProject& crafted) {
            crafted.node(-1, Design(), design);
            crafted.node(0, design, renamed(design, 0));
            for (int i = 1; i < most; ++i) {
                const FieldChanges change = {
                    {ElementId{2}, "name", '"' + std::to_string(i - 1) + '"', '"' + std::to_string(i) + '"'}};
                const bool wrong = lastIsWrong && i == most - 2;
                crafted.node(i, packChanges(change), wrong ? Hash{} : hashes[static_cast<std::size_t>(i)]);
            }
        });
    };
    const QString huge = write("huge.bolster", edits, false);
    expectCheapToReadAndSalvage(huge);
    ProgramRun run = callCommandLine({"verify", huge});
    EXPECT_EQ(run.exitCode, 3) << run.err;
    EXPECT_TRUE(run.out.starts_with("sound as far as was looked: 1000 edits")) << run.out;
    EXPECT_EQ(callCommandLine({"check", huge}).exitCode, 0) << "and it can be opened";

    EXPECT_EQ(callCommandLine({"verify", write("few.bolster", 40, false)}).exitCode, 0);
    EXPECT_EQ(callCommandLine({"verify", write("wrong.bolster", 40, true)}).exitCode, 2);
    const QString late = write("late.bolster", edits, true);
    EXPECT_EQ(callCommandLine({"verify", late}).exitCode, 3) << "not far enough";
    EXPECT_EQ(callCommandLine({"verify", late, "--all"}).exitCode, 2);
}

TEST_F(HostileFiles, PipesAreRefusedWhereverTheyComeIn)
{
    const QString seat = hammock();
    const QString fifo = pipe("pipe");
    for (const QStringList& command :
         std::initializer_list<QStringList>{{"check", fifo},
                                            {"solve", fifo},
                                            {"render", fifo, "--image", path("a.png")},
                                            {"dump", fifo},
                                            {"history", fifo},
                                            {"verify", fifo},
                                            {"thumbnail", fifo, path("a.png")},
                                            {"import", fifo, path("a.bolster")},
                                            {"salvage", fifo, path("a.bolster")},
                                            {"solve", seat, "--obj", fifo},
                                            {"solve", seat, "--ply", fifo},
                                            {"solve", seat, "--image", fifo},
                                            {"solve", seat, "--report", fifo},
                                            {"render", seat, "--image", pipe("p.png"), "--size", "64x48"}}) {
        const ProgramRun run = runProgram(command);
        const std::string what = command.join(' ').toStdString();
        EXPECT_TRUE(run.exitCode == 1 || run.exitCode == 2) << what << " " << run.exitCode;
        EXPECT_TRUE(contains(run.err, "not an ordinary file")) << what << ": " << run.err;
    }
    for (const char* element : {R"({"id": 7, "kind": "frame", "name": "Chair", "file": "pipe.obj"})",
                                R"({"id": 7, "kind": "scan", "name": "Room", "file": "pipe.ply"})"}) {
        pipe("pipe.obj");
        pipe("pipe.ply");
        Json design = Json::parse(read("seat.json"));
        design["elements"].push_back(Json::parse(element));
        const QString file = write("with.json", design.dump());
        for (const QStringList& command : std::initializer_list<QStringList>{{"check", file}, {"solve", file}}) {
            const ProgramRun run = runProgram(command);
            EXPECT_GT(run.exitCode, 0) << element;
            EXPECT_TRUE(contains(run.err, "not an ordinary file")) << run.err;
        }
        QFile::remove(path("b.bolster"));
        const ProgramRun run = runProgram({"import", file, path("b.bolster")});
        EXPECT_EQ(run.exitCode, 0) << "the element stays, without its file";
        EXPECT_TRUE(contains(run.err, "7 \"")) << run.err;
        EXPECT_TRUE(contains(run.err, "not an ordinary file")) << run.err;
    }
}

/// Each names its element and stays in the project.
TEST_F(HostileFiles, ImportKeepsElementsWhoseFilesCannotBeRead)
{
    write("points.obj", "v 0 0 0\nv 1 0 0\n");
    write("cloud.xyz", "0 0 0\n1 0 0\n0 1 0\n");
    QDir(m_folder.path()).mkdir("folder.obj");
    QFile::link(path("loop.obj"), path("loop.obj"));
    Json design = Json::parse(read(QFileInfo(hammock()).fileName()));
    const std::vector<std::string> names = {"points.obj", "cloud.xyz", "folder.obj", "loop.obj",
                                            std::string(5000, 'x') + ".obj"};
    for (std::size_t i = 0; i < names.size(); ++i)
        design["elements"].push_back({{"id", 70 + i}, {"kind", "frame"}, {"name", "Chair"}, {"file", names[i]}});
    const QString text = write("odd.json", design.dump());
    const ProgramRun run = callCommandLine({"import", text, path("odd.bolster")});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    for (std::size_t i = 0; i < names.size(); ++i)
        EXPECT_TRUE(contains(run.err, std::to_string(70 + i) + " \"Chair\", file: ")) << run.err;
    EXPECT_EQ(callCommandLine({"dump", path("odd.bolster")}).out, callCommandLine({"dump", text}).out);
}

TEST_F(HostileFiles, ManyElementsMayNameOneFile)
{
    write("cube.obj", "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    Json design = Json::parse(read(QFileInfo(hammock()).fileName()));
    for (int i = 0; i < 5000; ++i)
        design["elements"].push_back({{"id", 100 + i}, {"kind", "frame"}, {"name", "C"}, {"file", "cube.obj"}});
    const Cost cost = costOf({"import", write("many.json", design.dump()), path("many.bolster")});
    EXPECT_EQ(cost.exitCode, 0);
#ifdef NDEBUG
    EXPECT_LE(cost.seconds, 10);
#endif
    EXPECT_EQ(openProject(path("many.bolster")).assets.size(), 1U);
}

TEST_F(HostileFiles, OnlySoManyCushionsPush)
{
    write("cube.obj", "v 0 0 -90\nv 90 0 -90\nv 0 90 -90\nv 0 0 -20\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    Json design = Json::parse(read(QFileInfo(hammock()).fileName()));
    design["elements"].push_back({{"id", 99}, {"kind", "frame"}, {"name", "Cube"}, {"file", "cube.obj"}});
    for (int i = 0; i < 20'000; ++i)
        design["elements"].push_back({{"id", 100 + i}, {"kind", "cushion"}, {"name", "Pad"}, {"frame", 99}});
    const QString file = write("many.json", design.dump());
    for (const char* const command : {"check", "solve"}) {
        const ProgramRun run = callCommandLine({command, file});
        EXPECT_EQ(run.exitCode, 0) << run.err;
        EXPECT_TRUE(contains(run.err, "cushion 200 \"Pad\", enabled: at most 100 cushions push")) << run.err;
    }
    [[maybe_unused]] const Cost cost = costOf({"solve", file});
#ifdef NDEBUG
    EXPECT_LE(cost.seconds, 20);
#endif
}

TEST_F(HostileFiles, AFaceWithTooManyCornersIsRefused)
{
    constexpr int corners = 100'000;
    std::string text, face = "f";
    for (int i = 0; i < corners; ++i) {
        text.append("v ").append(std::to_string(i)).append(i % 2 == 0 ? " 0 0\n" : " 500 0\n");
        face.append(" ").append(std::to_string(i + 1));
    }
    write("comb.obj", text + face + "\n");
    Json design = Json::parse(read(QFileInfo(hammock()).fileName()));
    design["elements"].push_back({{"id", 99}, {"kind", "frame"}, {"name", "Comb"}, {"file", "comb.obj"}});
    const ProgramRun run = callCommandLine({"check", write("comb.json", design.dump())});
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_TRUE(contains(run.err, "comb.obj:100001: a face has 100000 corners, and at most 10000 are read"))
        << run.err;
}

TEST_F(HostileFiles, CheckLooksAtThePicturesOfFabrics)
{
    Json design = Json::parse(read(QFileInfo(hammock()).fileName()));
    const std::string png = "\x89PNG\r\n\x1a\n";
    for (const auto& [name, bytes] :
         {std::pair("empty.png", std::string()),
          {"cut.png", png + "IHDR"},
          {"drawing.png", std::string("<svg xmlns=\"http://www.w3.org/2000/svg\"/>")}}) {
        write(name, bytes);
        design["elements"][0]["look"] = {{"kind", "image"}, {"file", name}};
        const QString text = write("dressed.json", design.dump());
        QFile::remove(path("dressed.bolster"));
        ASSERT_EQ(callCommandLine({"import", text, path("dressed.bolster")}).exitCode, 0);
        for (const QString& file : {text, path("dressed.bolster")}) {
            const ProgramRun run = callCommandLine({"check", file});
            EXPECT_EQ(run.exitCode, 0) << run.err;
            EXPECT_TRUE(contains(run.err, "warning: fabric 1 \"Leather\", look.file: \"")) << run.err;
            EXPECT_TRUE(contains(run.err, name)) << run.err;
            EXPECT_TRUE(contains(run.out, "0 errors, ")) << run.out;
        }
    }
}

TEST_F(HostileFiles, PicturesAreNotWrittenThroughLinksThatSomebodyLaid)
{
    write("precious", "1");
    const QString image = path("seat.png");
    ASSERT_TRUE(QFile::link(path("precious"), image + ".part"));
    ASSERT_EQ(runProgram({"render", hammock(), "--image", image, "--size", "64x48"}).exitCode, 0);
    EXPECT_EQ(read("precious"), "1");
    EXPECT_EQ(read("seat.png").substr(1, 3), "PNG");
    EXPECT_EQ(QDir(m_folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 4) << "and nothing else is left";
}

TEST_F(HostileFiles, DumpingAssetsOverwritesNothing)
{
    write("chair.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Journal::Opened opened = Journal::create(path("journal"), fabric("Wool"));
    for (std::string name : {"chair.obj", "more/second.obj"})
        ASSERT_TRUE(opened.journal->addAsset(name, path("chair.obj")).empty());
    ASSERT_TRUE(opened.journal->save(path("a.bolster")).empty());
    QDir().mkpath(path("out/more"));
    write("out/more/second.obj", "precious");
    const ProgramRun run = callCommandLine({"dump", path("a.bolster"), "--assets", path("out")});
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_TRUE(contains(run.err, "second.obj\" already")) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(read("out/more/second.obj"), "precious");
    EXPECT_FALSE(QFileInfo::exists(path("out/chair.obj"))) << "all or nothing";
    QFile::remove(path("out/more/second.obj"));
    EXPECT_EQ(callCommandLine({"dump", path("a.bolster"), "--assets", path("out")}).exitCode, 0);
    EXPECT_EQ(read("out/more/second.obj"), read("chair.obj"));
}

TEST_F(HostileFiles, WhatSteersATerminalIsEscaped)
{
    // Escape, delete, the one-byte escape of ECMA-48, a right-to-left override.
    const std::string name = "\x1b[2JWool\x7f\xc2\x9b\xe2\x80\xae";
    Fabric evil;
    evil.name = name;
    const Design before = fabric("Wool");
    const Design design = before.with({{}, {{ElementId{1}, before.element(ElementId{1}), makeElement(evil)}}});
    const QString file = project("a.bolster", [&](CraftedProject& crafted) {
        crafted.node(-1, Design(), before);
        crafted.node(0, before, design, {"Rename \"%1\"", {name}});
    });
    const auto isTame = [](const std::string& text) {
        return !contains(text, "\x1b") && !contains(text, "\x7f") && !contains(text, "\xc2\x9b") &&
               !contains(text, "\xe2\x80\xae");
    };
    for (const QStringList& command :
         std::initializer_list<QStringList>{{"dump", file}, {"dump", file, "--history"}, {"history", file}}) {
        const ProgramRun run = callCommandLine(command);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        EXPECT_TRUE(isTame(run.out)) << run.out;
        EXPECT_TRUE(contains(run.out, "\\u001b[2JWool\\u007f\\u009b\\u202e")) << run.out;
    }
    const Json dumped = Json::parse(callCommandLine({"dump", file}).out);
    EXPECT_EQ(dumped["elements"][0]["name"], name) << "it is the same design";
    const ProgramRun history = callCommandLine({"history", file});
    EXPECT_EQ(std::count(history.out.begin(), history.out.end(), '\n'), 2);
}

TEST_F(HostileFiles, ADumpIsJsonWhateverIsQuarantined)
{
    const std::string deep = std::string(63, '[') + std::string(63, ']');
    for (const std::string& text : {std::string("no JSON\x1b"), std::string("1], \"elements\": [2"), std::string(),
                                    std::string("\"\xff\""), deep, std::string("{\"kind\": \"sofa\"}")}) {
        const Design design = Design().with({{}, {{ElementId{3}, nullptr, makeElement(Quarantined{text, {}})}}});
        const QString file =
            project("a.bolster", [&](CraftedProject& crafted) { crafted.node(-1, Design(), design); });
        const ProgramRun run = callCommandLine({"dump", file});
        EXPECT_EQ(run.exitCode, 0) << run.err;
        ASSERT_TRUE(Json::accept(run.out)) << run.out;
        EXPECT_EQ(Json::parse(run.out)["elements"].size(), 1u);
        EXPECT_TRUE(Json::accept(callCommandLine({"dump", file, "--history"}).out));
        QFile::remove(path("again.bolster"));
        ASSERT_EQ(callCommandLine({"import", write("a.json", run.out), path("again.bolster")}).exitCode, 0) << text;
        EXPECT_EQ(callCommandLine({"dump", path("again.bolster")}).out, run.out);
    }
}

TEST_F(HostileFiles, CheckAndSolveAgreeThatADesignWithoutPatchesCannotBeSolved)
{
    const QString file = write("empty.json", writeDesign(fabric("Wool")));
    for (const char* command : {"check", "solve"}) {
        const ProgramRun run = callCommandLine({command, file});
        EXPECT_EQ(run.exitCode, 2) << command;
        EXPECT_TRUE(contains(run.err, "the design has no patch yet")) << run.err;
    }
}

TEST_F(HostileFiles, AssetsThatCollideAndNumbersThatOverflowAreDamage)
{
    const auto verified = [&](const std::vector<std::pair<std::string, std::int64_t>>& assets) {
        const QString file = project("a.bolster", [&](CraftedProject& crafted) {
            crafted.node(-1, Design(), fabric("Wool"));
            std::int64_t id = 0;
            for (const auto& [name, blob] : assets)
                crafted.asset(++id, name, blob, "");
        });
        return callCommandLine({"verify", file}).exitCode;
    };
    EXPECT_EQ(verified({{"a/b", 1}, {"a/c", 1}}), 0);
    EXPECT_EQ(verified({{"a/b", 1}, {"a/./b", 1}}), 2);
    EXPECT_EQ(verified({{"a/b", 1}, {"a//b", 2}}), 2);
    EXPECT_EQ(verified({{"a\xff", 1}}), 2);
    EXPECT_EQ(verified({{"a", (std::int64_t{1} << 43) - 3}}), 0);
    for (const std::int64_t blob :
         {std::int64_t{1} << 43, std::numeric_limits<std::int64_t>::max(), std::int64_t{-1}})
        EXPECT_EQ(verified({{"a", blob}}), 2) << blob;
}

} // namespace
} // namespace bolster::test
