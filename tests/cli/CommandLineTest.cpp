#include "CommandLine.h"
#include "../model/TestFiles.h"
#include "MeshImport.h"
#include "Output.h"
#include "ProgramRun.h"
#include "TestPaths.h"

#include <nlohmann/json.hpp>

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include <algorithm>
#include <csignal>
#include <ctime>
#include <fcntl.h>
#include <set>
#include <sstream>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace bolster {
namespace {

using Json = nlohmann::json;
using Strings = std::vector<std::string>;

/// A square of cloth, fixed along two opposite edges to rails that are a little closer together.
Json hammock()
{
    return Json::parse(R"({"format": "bolster-design", "version": 1, "unit": "mm",
        "settings": {"edge_length": 25}, "elements": [
        {"id": 1, "kind": "fabric", "name": "Leather", "bending_length": 30},
        {"id": 2, "kind": "patch", "name": "Seat", "fabric": 1,
         "outline": {"degree": 1, "closed": true, "points": [[0,0],[300,0],[300,300],[0,300]]}},
        {"id": 3, "kind": "fixation_curve", "name": "Front rail",
         "curve": {"degree": 1, "closed": false, "points": [[0,0,0],[300,0,0]]}},
        {"id": 4, "kind": "fixation_curve", "name": "Back rail",
         "curve": {"degree": 1, "closed": false, "points": [[0,280,0],[300,280,0]]}},
        {"id": 5, "kind": "fixation_seam", "patch": 2, "from": 0, "to": 1, "curve": 3},
        {"id": 6, "kind": "fixation_seam", "patch": 2, "from": 2, "to": 3, "curve": 4, "reversed": true}]})");
}

/// With a side sewn to it.
Json sewnHammock()
{
    Json design = hammock();
    design["elements"].push_back(Json::parse(
        R"({"id": 7, "kind": "patch", "name": "Side flap", "fabric": 1, "position": [400, 0],
            "outline": {"degree": 1, "closed": true, "points": [[0,0],[60,0],[60,300],[0,300]]}})"));
    design["elements"].push_back(Json::parse(
        R"({"id": 8, "kind": "seam", "a": {"patch": 2, "from": 1, "to": 2},
            "b": {"patch": 7, "from": 3, "to": 4}, "reversed": true})"));
    return design;
}

Json badPatch()
{
    return Json::parse(R"({"id": 20, "kind": "patch", "name": "Bow tie", "fabric": 1,
        "outline": {"degree": 1, "closed": true, "points": [[0,0],[100,100],[100,0],[0,100]]}})");
}

Json with(Json design, const Json& element)
{
    design["elements"].push_back(element);
    return design;
}

Strings keysOf(const Json& object)
{
    Strings keys;
    for (const auto& item : object.items())
        keys.push_back(item.key());
    std::sort(keys.begin(), keys.end());
    return keys;
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

class CommandLine : public TestFiles {
protected:
    QString design(const QString& name, const Json& content) const { return write(name, content.dump()); }

    Json report(const QString& name = "report.json") const
    {
        const Json parsed = Json::parse(read(name), nullptr, false);
        EXPECT_FALSE(parsed.is_discarded());
        return parsed;
    }

    static void expectUsageError(const QStringList& arguments, const std::string& why)
    {
        const ProgramRun run = callCommandLine(arguments);
        EXPECT_EQ(run.exitCode, 2) << arguments.join(' ').toStdString();
        EXPECT_TRUE(contains(run.err, why)) << run.err;
        EXPECT_EQ(run.out, "");
    }
};

TEST_F(CommandLine, ExplainsItself)
{
    const ProgramRun version = runProgram({"--version"});
    EXPECT_EQ(version.exitCode, 0);
    EXPECT_TRUE(version.out.starts_with("bolster ")) << version.out;
    EXPECT_TRUE(contains(runProgram({"--help"}).out, "bolster solve"));
    EXPECT_TRUE(contains(runProgram({"check", "--help"}).out, "bolster check DESIGN"));
    const ProgramRun solve = runProgram({"solve", "--help"});
    EXPECT_EQ(solve.exitCode, 0);
    for (const char* option :
         {"--obj", "--ply", "--image", "--report", "--tolerance", "--max-iterations", "--threads", "--lenient"})
        EXPECT_TRUE(contains(solve.out, option)) << option;
}

TEST_F(CommandLine, RefusesWrongUsage)
{
    const QString file = design("a.json", hammock());
    EXPECT_EQ(runProgram({"solve", file, "--fast"}).exitCode, 2);
    EXPECT_EQ(callCommandLine({file}).exitCode, -1); // a design: the window's business
    EXPECT_EQ(callCommandLine({}).exitCode, -1);
    expectUsageError({"solv", file}, "unknown command \"solv\"");
    expectUsageError({"solve"}, "DESIGN is missing");
    expectUsageError({"check"}, "DESIGN is missing");
    expectUsageError({"solve", file, "other.json"}, "unexpected argument \"other.json\"");
    expectUsageError({"solve", file, "--fast"}, "unknown option \"--fast\"");
    expectUsageError({"solve", file, "--lenient=yes"}, "unknown option");
    expectUsageError({"check", file, "--lenient"}, "unknown option");
    expectUsageError({"solve", file, "--obj"}, "--obj needs a value");
    expectUsageError({"solve", file, "--obj="}, "--obj needs a value");
    expectUsageError({"solve", file, "--lenient", "--lenient"}, "given twice");
    for (const char* number : {"1,5", "abc", "1e-6x", "", " "})
        expectUsageError({"solve", file, "--tolerance", number}, "--tolerance needs");
    for (const char* number : {"0", "-1", "nan", "inf", "2"})
        expectUsageError({"solve", file, "--tolerance", number}, "--tolerance cannot be");
    expectUsageError({"solve", file, "--max-iterations", "2.5"}, "--max-iterations needs a whole number");
    expectUsageError({"solve", file, "--max-iterations", "0"}, "--max-iterations cannot be");
    expectUsageError({"solve", file, "--threads", "-1"}, "--threads cannot be");
    expectUsageError({"solve", file, "--threads", "99999999999"}, "--threads cannot be");
    expectUsageError({"--foo"}, "unknown option \"--foo\"");
    expectUsageError({"solve", file, "--obj", path("x"), "--ply", path("x")}, "the same file");
    ASSERT_TRUE(QFile::link("x", path("link"))); // to a file that is not there yet
    expectUsageError({"solve", file, "--obj", path("x"), "--ply", path("link")}, "the same file");
}

TEST_F(CommandLine, NeverOverwritesWhatItReads)
{
    write("chair.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const QString file = design(
        "chair.json", with(hammock(), {{"id", 9}, {"kind", "frame"}, {"name", "Chair"}, {"file", "chair.obj"}}));
    expectUsageError({"solve", file, "--obj", path("chair.obj")},
                     "--obj would overwrite the file \"chair.obj\" of frame 9 \"Chair\"");
    expectUsageError({"solve", file, "--report", path("chair.json")}, "--report would overwrite the design");
    write("form.obj", "v 0 0 0\nv 100 0 0\nv 0 100 0\nf 1 2 3\n");
    const QString frame = path("chair.obj");
    const std::string why = "--report would overwrite the file \"chair.obj\" of frame 9 \"Chair\"";
    expectUsageError({"relieve", file, "--report", frame}, why);
    expectUsageError({"explain", file, "--scan", frame, "--report", frame}, "is read, or written twice");
    expectUsageError({"explain", file, "--report", frame}, why);
    expectUsageError({"fit-pattern", file, "--to", "strain", "--out", path("new.json"), "--report", frame}, why);
    expectUsageError({"flatten", path("form.obj"), "--along", file, "--out", path("new.json"), "--report", frame},
                     why);
    EXPECT_TRUE(importMesh(frame).mesh);
}

TEST_F(CommandLine, ChecksAGoodDesign)
{
    const ProgramRun run = runProgram({"check", design("a.json", sewnHammock())});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_EQ(run.out, "0 errors, 0 warnings\n");
    EXPECT_EQ(run.err, "");
}

TEST_F(CommandLine, CheckSaysOfAFrameThatItIsImported)
{
    const ProgramRun run =
        runProgram({"check", QString::fromStdString(bolster::test::samplesFolder() + "/pillow/pillow.obj")});
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_TRUE(run.err.find("is no design, but what one is made of: import it") != std::string::npos) << run.err;
}

TEST_F(CommandLine, CheckTellsWarningsFromErrors)
{
    Json loose = sewnHammock();
    loose["elements"][6]["outline"]["points"] = {{0, 0}, {60, 0}, {60, 340}, {0, 340}}; // 13 % longer
    const ProgramRun run = runProgram({"check", design("a.json", loose)});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_EQ(run.out, "0 errors, 1 warning\n");
    EXPECT_TRUE(run.err.starts_with("warning: seam 8")) << run.err;
}

TEST_F(CommandLine, CheckNamesElementAndFieldOfEveryProblemInOneLine)
{
    Json bad = with(hammock(), badPatch());
    bad["elements"].push_back({{"id", 21}, {"kind", "fabric"}, {"name", "Rub\nber"}, {"poisson", 0.9}});
    bad["elements"].push_back({{"id", 22}, {"kind", "frame"}, {"name", "Chair"}, {"file", "none.obj"}});
    const ProgramRun run = runProgram({"check", design("a.json", bad)});
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_TRUE(run.out.starts_with("3 errors, ")) << run.out;
    std::istringstream lines(run.err);
    Strings found;
    for (std::string line; std::getline(lines, line);) {
        EXPECT_TRUE(line.starts_with("error: ") || line.starts_with("warning: ")) << line;
        if (line.starts_with("error: "))
            found.push_back(line);
    }
    ASSERT_EQ(found.size(), 3u) << run.err;
    EXPECT_TRUE(found[0].starts_with("error: patch 20 \"Bow tie\", outline")) << found[0];
    EXPECT_TRUE(found[1].starts_with("error: fabric 21 \"Rub\\u000aber\", poisson")) << found[1];
    EXPECT_TRUE(found[2].starts_with("error: frame 22 \"Chair\", file")) << found[2];
}

TEST_F(CommandLine, RefusesWhatIsNoDesign)
{
    for (const QString& file :
         {path("none.json"), m_folder.path(), write("empty.json", ""), write("text.json", "Seat"),
          write("list.json", "[]"), write("newer.json", R"({"format": "bolster-design", "version": 99})"),
          write("deep.json", std::string(200'000, '['))}) {
        for (const QStringList& options : {QStringList{}, QStringList{"--lenient"}}) {
            const ProgramRun run =
                callCommandLine(QStringList{"solve", file, "--report", path("report.json")} + options);
            EXPECT_EQ(run.exitCode, 2) << file.toStdString();
            EXPECT_TRUE(run.err.starts_with("error: ")) << run.err;
            EXPECT_EQ(report()["status"], "failed");
            EXPECT_NE(report()["reason"], "");
        }
        EXPECT_EQ(callCommandLine({"check", file}).exitCode, 2);
    }
}

/// As in the workbench.
TEST_F(CommandLine, SaysWhatACoverSuffers)
{
    const std::string folder = test::samplesFolder();
    const auto solved = [&](const char* sample) {
        return callCommandLine({"solve", QString::fromStdString(folder + "/" + sample + "/" + sample + ".json")});
    };
    const ProgramRun folded = solved("trapezoid"), calm = solved("cylinder");
    EXPECT_EQ(folded.exitCode, 0);
    EXPECT_NE(folded.out.find("folds"), std::string::npos) << folded.out;
    EXPECT_EQ(calm.exitCode, 0);
    EXPECT_EQ(calm.out.find("allows"), std::string::npos) << calm.out;
}

TEST_F(CommandLine, SolvesAndWritesEverything)
{
    const ProgramRun run =
        runProgram({"solve", design("a.json", sewnHammock()), "--obj", path("a.obj"), "--ply=" + path("a.ply"),
                    "--image", path("a.png"), "--report", path("report.json"), "--threads", "2"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_TRUE(run.out.starts_with("solved in ")) << run.out;
    EXPECT_EQ(read("a.png").substr(1, 3), "PNG");

    const ImportedMesh obj = importMesh(path("a.obj"));
    const ImportedMesh ply = importMesh(path("a.ply"));
    ASSERT_TRUE(obj.mesh && ply.mesh) << obj.problem.english() << ply.problem.english();
    EXPECT_EQ(obj.mesh->points, ply.mesh->points);
    EXPECT_EQ(obj.mesh->triangles, ply.mesh->triangles);
    ASSERT_EQ(obj.mesh->parts.size(), 2u);
    EXPECT_EQ(obj.mesh->parts[0].name, "Seat");
    EXPECT_EQ(obj.mesh->parts[1].name, "Side_flap");
    EXPECT_NEAR(obj.mesh->boundingBox().max().y(), 280, 10); // between the rails

    const Json numbers = report();
    EXPECT_EQ(numbers["status"], "solved");
    EXPECT_EQ(numbers["patches"], 2);
    EXPECT_EQ(numbers["seams"], 1);
    EXPECT_EQ(numbers["triangles"], obj.mesh->triangles.size());
    // Every sewn pair is two vertices of the file in one place, and one vertex of the report.
    std::set<std::array<double, 3>> places;
    for (const Vec3& p : obj.mesh->points)
        places.insert({p.x(), p.y(), p.z()});
    EXPECT_EQ(numbers["vertices"], places.size());
    EXPECT_EQ(numbers["constraints"]["sewn"], obj.mesh->points.size() - places.size());
    EXPECT_EQ(numbers["seam_gap_mm"]["max"], 0.0);
    EXPECT_LT(numbers["fixation_error_mm"]["max"], 1e-6);
    EXPECT_DOUBLE_EQ(numbers["rest_area_mm2"], 300 * 360.0);
}

TEST_F(CommandLine, AScanThatIsNowhereNearHasNoFigures)
{
    write("room.xyz", "90000 0 0\n90000 10 0\n90000 0 10\n");
    const Json scanned = with(hammock(), {{"id", 40}, {"kind", "scan"}, {"name", "Room"}, {"file", "room.xyz"}});
    const ProgramRun run = runProgram({"solve", design("far.json", scanned), "--report", path("report.json")});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_TRUE(contains(run.out, "scan \"Room\": no point of it is near the cover")) << run.out;
    const Json scan = report()["scans"][0];
    EXPECT_EQ(scan["coverage"], 0.0);
    EXPECT_TRUE(scan["deviation_mm"]["rms"].is_null());
}

TEST_F(CommandLine, ReportsExactlyTheDocumentedKeys)
{
    const auto expectKeys = [&] {
        const Json numbers = report();
        EXPECT_EQ(keysOf(numbers), (Strings{"area_mm2",
                                            "constraints",
                                            "cushions",
                                            "fancy_seams",
                                            "fixation_deviation_mm",
                                            "fixation_error_mm",
                                            "flipped_triangles",
                                            "handles",
                                            "iterations",
                                            "left_out",
                                            "movement",
                                            "patches",
                                            "reason",
                                            "rest_area_mm2",
                                            "scans",
                                            "seam_gap_mm",
                                            "seams",
                                            "status",
                                            "strain",
                                            "time_ms",
                                            "triangles",
                                            "vertices",
                                            "warnings"}));
        EXPECT_EQ(keysOf(numbers["constraints"]), (Strings{"fixed", "ghost", "orientation", "sewn"}));
        EXPECT_EQ(keysOf(numbers["seam_gap_mm"]), (Strings{"max", "mean"}));
        EXPECT_EQ(keysOf(numbers["fixation_error_mm"]), (Strings{"max", "mean"}));
        EXPECT_EQ(keysOf(numbers["fixation_deviation_mm"]), (Strings{"max"}));
        EXPECT_EQ(keysOf(numbers["strain"]), (Strings{"max", "p99", "rms"}));
        EXPECT_EQ(keysOf(numbers["time_ms"]),
                  (Strings{"assemble", "factor", "iterate", "per_iteration", "total", "triangulate"}));
        EXPECT_TRUE(numbers["warnings"].is_array() && numbers["left_out"].is_array());
    };
    EXPECT_EQ(runProgram({"solve", design("a.json", hammock()), "--report", path("report.json")}).exitCode, 0);
    expectKeys();
    EXPECT_EQ(runProgram({"solve", path("none.json"), "--report", path("report.json")}).exitCode, 2);
    expectKeys();
}

TEST_F(CommandLine, IsStrictUnlessAskedToBeLenient)
{
    const QString file = design("a.json", with(sewnHammock(), badPatch()));
    const QStringList arguments = {"solve", file, "--obj", path("a.obj"), "--report", path("report.json")};
    const ProgramRun strict = runProgram(arguments);
    EXPECT_EQ(strict.exitCode, 2);
    EXPECT_TRUE(contains(strict.err, "error: patch 20 \"Bow tie\", outline")) << strict.err;
    EXPECT_FALSE(QFileInfo::exists(path("a.obj")));
    EXPECT_EQ(report()["status"], "failed");
    EXPECT_TRUE(contains(report()["reason"], "Bow tie"));

    const ProgramRun lenient = runProgram(arguments + QStringList{"--lenient"});
    EXPECT_EQ(lenient.exitCode, 0);
    EXPECT_TRUE(contains(lenient.err, "left out: patch 20 \"Bow tie\"")) << lenient.err;
    ASSERT_EQ(report()["left_out"].size(), 1u);
    EXPECT_EQ(report()["left_out"][0]["element"], 20);
    EXPECT_EQ(report()["patches"], 2);
    EXPECT_TRUE(importMesh(path("a.obj")).mesh);
}

TEST_F(CommandLine, ReportsNoNumberForElementsThatHaveNoneOfTheirOwn)
{
    Json bad = with(hammock(), badPatch());
    bad["elements"].back()["id"] = 2;
    runProgram({"solve", design("a.json", bad), "--lenient", "--report", path("report.json")});
    const Json leftOut = report()["left_out"];
    ASSERT_EQ(leftOut.size(), 1U);
    EXPECT_TRUE(leftOut[0]["element"].is_null());
    EXPECT_EQ(leftOut[0]["label"], "patch 2 \"Bow tie\"");
}

TEST_F(CommandLine, LenientLeavesOutWhatDependsOnBadElements)
{
    Json bad = sewnHammock();
    bad["elements"][6]["colour"] = "red"; // the flap: its seam must go, too
    bad["elements"].push_back({{"id", 9}, {"kind", "frame"}, {"name", "Chair"}, {"file", "none.obj"}});
    const ProgramRun run =
        runProgram({"solve", design("a.json", bad), "--lenient", "--report", path("report.json")});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    std::set<int> leftOut;
    const Json numbers = report();
    for (const Json& item : numbers["left_out"])
        leftOut.insert(item["element"].get<int>());
    EXPECT_EQ(leftOut, (std::set<int>{7, 8, 9}));
    EXPECT_EQ(numbers["left_out"][0]["field"], "colour");
    EXPECT_EQ(numbers["patches"], 1);

    Json nothing = hammock();
    nothing["elements"][1]["colour"] = "red";
    EXPECT_EQ(runProgram({"solve", design("b.json", nothing), "--lenient"}).exitCode, 2);
}

TEST_F(CommandLine, WritesWhatItHasWhenNotConverged)
{
    const ProgramRun run = runProgram({"solve", design("a.json", hammock()), "--max-iterations", "3", "--obj",
                                       path("a.obj"), "--report", path("report.json")});
    EXPECT_EQ(run.exitCode, 3);
    EXPECT_TRUE(contains(run.out, "not converged after 3 iterations")) << run.out;
    EXPECT_TRUE(importMesh(path("a.obj")).mesh);
    EXPECT_EQ(report()["status"], "not_converged");
    EXPECT_EQ(report()["iterations"], 3);
    EXPECT_NE(report()["reason"], "");
}

TEST_F(CommandLine, SaysWhatCannotBeWrittenAndWritesTheRest)
{
    const ProgramRun run =
        runProgram({"solve", design("a.json", hammock()), "--obj", path("none/a.obj"), "--image",
                    path("none/a.png"), "--ply", path("a.ply"), "--report", path("report.json")});
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_TRUE(contains(run.err, "none/a.obj\" cannot be written: there is no folder")) << run.err;
    EXPECT_TRUE(contains(run.err, "none/a.png\" cannot be written")) << run.err;
    EXPECT_TRUE(importMesh(path("a.ply")).mesh);
    EXPECT_EQ(report()["status"], "solved");
}

TEST_F(CommandLine, IsTheSameOnEveryRunAndNumberOfThreads)
{
    const QString file = design("a.json", sewnHammock());
    std::set<std::string> results;
    for (const char* threads : {"1", "2", "7", "2"}) {
        EXPECT_EQ(callCommandLine({"solve", file, "--threads", threads, "--obj", path("a.obj")}).exitCode, 0);
        results.insert(read("a.obj"));
    }
    EXPECT_EQ(runProgram({"solve", file, "--obj", path("a.obj")}).exitCode, 0);
    results.insert(read("a.obj"));
    EXPECT_EQ(results.size(), 1u);
}

TEST_F(CommandLine, UsesPointsWhateverTheLocale)
{
    QProcessEnvironment german = bareEnvironment();
    const QString localedef = QStandardPaths::findExecutable("localedef");
    if (!localedef.isEmpty()) // else the C locale is what there is
        QProcess::execute(localedef, {"-i", "de_DE", "-f", "UTF-8", path("de_DE.UTF-8")});
    german.insert("LOCPATH", m_folder.path());
    german.insert("LC_ALL", "de_DE.UTF-8");
    german.insert("LANGUAGE", "de");
    const QString file = design("a.json", hammock());
    ASSERT_EQ(runProgram({"solve", file, "--obj", path("c.obj")}).exitCode, 0);
    const ProgramRun run = runProgram(
        {"solve", file, "--tolerance", "0.000001", "--obj", path("de.obj"), "--report", path("report.json")},
        german);
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_TRUE(run.out.starts_with("solved in ")) << run.out;
    EXPECT_EQ(read("de.obj"), read("c.obj"));
    EXPECT_DOUBLE_EQ(report()["rest_area_mm2"], 90'000);
    EXPECT_EQ(runProgram({"check", file}, german).exitCode, 0);
}

/// A comb with as many points as an outline may have: preparing it takes a while, in the middle of which nobody
/// looks whether to stop.
TEST_F(CommandLine, EndsAtOnceWhenInterruptedInTheMiddleOfPreparing)
{
    Json comb = hammock();
    Json points = Json::array({{0, -50}, {100'000, -50}});
    for (int tooth = 2497; tooth >= 0; --tooth)
        for (const auto& [x, y] : {std::pair(20, 0), {15, 2000}, {5, 2000}, {0, 0}})
            points.push_back({40 * tooth + x, y});
    comb["elements"].push_back({{"id", 30},
                                {"kind", "patch"},
                                {"name", "Comb"},
                                {"fabric", 1},
                                {"outline", {{"degree", 1}, {"closed", true}, {"points", points}}}});
    comb["settings"]["edge_length"] = 12;
    const QString file = design("comb.json", comb);
    const auto interrupt = [&](int signal, int after) {
        QProcess process;
        process.setProcessEnvironment(bareEnvironment());
        process.start(QString::fromStdString(test::program()),
                      {"solve", file, "--obj", path("a.obj"), "--report", path("report.json")});
        ASSERT_TRUE(process.waitForStarted());
        EXPECT_FALSE(process.waitForFinished(after)); // it is at work, or only getting there: both must end well
        ::kill(static_cast<pid_t>(process.processId()), signal);
        ASSERT_TRUE(process.waitForFinished(60'000)) << "less than preparing would still take";
        EXPECT_EQ(process.exitStatus(), QProcess::NormalExit);
        EXPECT_EQ(process.exitCode(), 1);
        EXPECT_TRUE(contains(process.readAllStandardError().toStdString(), "interrupted"));
        EXPECT_FALSE(QFileInfo::exists(path("a.obj")));
    };
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        int after = 2000; // ms; on a busy machine it is still reading then, and knows of no report
        do
            interrupt(signal, after);
        while (!HasFailure() && !QFileInfo::exists(path("report.json")) && (after *= 2) < 20'000);
        EXPECT_EQ(report()["reason"], "interrupted");
        QFile::remove(path("report.json"));
    }
}

/// SketchUp writes every face twice, once for each side.
TEST_F(CommandLine, CushionsADoubleSidedFrameAndSaysWhenThereIsNothingToCushion)
{
    const std::string points = "v 0 0 -80\nv 300 0 -80\nv 300 280 -80\nv 0 280 -80\n"
                               "v 0 0 -20\nv 300 0 -20\nv 300 280 -20\nv 0 280 -20\n";
    const std::string faces = "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 1 5 8 4\nf 2 3 7 6\n";
    const std::string backs = "f 4 1 2 3\nf 8 7 6 5\nf 6 2 1 5\nf 8 4 3 7\nf 4 8 5 1\nf 7 3 2 6\n";
    write("twice.obj", points + faces + backs);
    write("sheet.obj", points + "f 5 6 7 8\nf 7 6 5 8\n");
    const auto cushioned = [&](const char* mesh) {
        Json design = with(hammock(), {{"id", 40}, {"kind", "frame"}, {"name", "Chair"}, {"file", mesh}});
        return this->design("chair.json",
                            with(design, {{"id", 41}, {"kind", "cushion"}, {"name", "Padding"}, {"frame", 40}}));
    };
    QString file = cushioned("twice.obj");
    ProgramRun run = callCommandLine({"solve", file, "--report", path("report.json")});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_GT(report()["cushions"][0]["voxels"], 10'000);
    EXPECT_EQ(callCommandLine({"check", file}).err, "");

    file = cushioned("sheet.obj");
    for (const char* command : {"solve", "check"}) {
        run = callCommandLine({command, file});
        EXPECT_EQ(run.exitCode, 0);
        EXPECT_TRUE(contains(run.err, "warning: cushion 41 \"Padding\", voxel_mm: it pushes nothing")) << run.err;
    }
}

/// Each of them is told once; to compare each with each would take minutes.
TEST_F(CommandLine, CheckCopesWithThousandsOfBadElements)
{
    Json design = hammock();
    constexpr int count = 30'000;
    for (int i = 0; i < count; ++i)
        design["elements"].push_back({{"id", 100 + i}, {"kind", "frame"}, {"name", "F"}, {"file", "none.obj"}});
    const ProgramRun run = callCommandLine({"check", this->design("a.json", design)});
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_TRUE(contains(run.out, std::to_string(count) + " errors")) << run.out;
}

TEST_F(CommandLine, MessagesNameTheFileAndThePlace)
{
    const QString bad = write("bad.json", "{,");
    for (const QStringList& command : std::initializer_list<QStringList>{
             {"check", bad}, {"solve", bad}, {"dump", bad}, {"import", bad, path("b.bolster")}}) {
        const ProgramRun run = callCommandLine(command);
        EXPECT_EQ(run.exitCode, 2);
        EXPECT_TRUE(contains(run.err, bad.toStdString() + ": Line 1, column 2: ")) << run.err;
    }
    const QString project = path("seat.bolster");
    ASSERT_EQ(callCommandLine({"import", design("seat.json", hammock()), project}).exitCode, 0);
    std::string bytes = read("seat.bolster");
    for (std::size_t at = 100; at < bytes.size(); ++at)
        bytes[at] = static_cast<char>(bytes[at] ^ (at > 3000 ? 0x55 : 0));
    write("seat.bolster", bytes);
    for (const char* const command : {"check", "solve", "dump", "history"}) {
        const ProgramRun run = callCommandLine({command, project});
        EXPECT_EQ(run.exitCode, 2);
        EXPECT_TRUE(contains(run.err, project.toStdString() + "\" OUT")) << run.err;
    }
    const ProgramRun nowhere = callCommandLine({"solve", design("seat.json", hammock()), "--obj", "/proc/a.obj"});
    EXPECT_EQ(nowhere.exitCode, 1);
    EXPECT_TRUE(contains(nowhere.err, "no file can be made in \"/proc\"")) << nowhere.err;
    write("far.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -9223372036854775808\n");
    Json far = with(hammock(), {{"id", 40}, {"kind", "frame"}, {"name", "Far"}, {"file", "far.obj"}});
    const ProgramRun index = callCommandLine({"check", design("far.json", far)});
    EXPECT_TRUE(contains(index.err, "a face refers to point -9223372036854775808, but there are 3 points"))
        << index.err;
}

/// Qt would take them for other names, and write there.
TEST_F(CommandLine, RefusesNamesThatAreNotUtf8)
{
    const std::string seat = design("seat.json", hammock()).toStdString();
    const std::string odd = path("caf").toStdString() + "\xe9.json";
    for (const std::vector<std::string>& words : {std::vector<std::string>{"check", odd},
                                                  {"solve", seat, "--obj", odd},
                                                  {"render", seat, "--image=" + odd},
                                                  {"import", seat, odd},
                                                  {odd},
                                                  {seat, odd}}) {
        std::vector<std::string> all = {"bolster"};
        all.insert(all.end(), words.begin(), words.end());
        std::vector<char*> argv;
        for (std::string& word : all)
            argv.push_back(word.data());
        ::testing::internal::CaptureStderr();
        const std::optional<int> code = runCommandLine(static_cast<int>(argv.size()), argv.data());
        const std::string err = ::testing::internal::GetCapturedStderr();
        EXPECT_EQ(code, 2) << err;
        EXPECT_TRUE(contains(err, "caf\\u00e9.json\" is not UTF-8")) << err;
    }
    EXPECT_EQ(QDir(m_folder.path()).entryList(QDir::Files | QDir::Hidden), QStringList("seat.json"));
}

/// The programs that have this among their arguments.
std::vector<pid_t> programsWith(const QString& argument)
{
    std::vector<pid_t> found;
    for (const QString& process : QDir("/proc").entryList(QDir::Dirs))
        if (QFile file("/proc/" + process + "/cmdline"); process.toInt() > 0 && file.open(QIODevice::ReadOnly))
            if (file.readAll().split('\0').mid(1) == QByteArrayList{argument.toUtf8(), QByteArray()})
                found.push_back(process.toInt());
    return found;
}

TEST_F(CommandLine, OpensAWindowForEachDesign)
{
    const QString first = design("first.json", hammock()), second = design("second.json", hammock());
    QProcess process;
    QProcessEnvironment environment = bareEnvironment();
    environment.insert("QT_QPA_PLATFORM", "offscreen");
    for (const char* const place : {"XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"}) // nothing of the user's
        environment.insert(place, path("home"));
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(m_folder.path());
    process.start(QString::fromStdString(test::program()), {first, "second.json"});
    std::vector<pid_t> other;
    for (int tries = 0; tries < 600 && other.empty(); ++tries) {
        EXPECT_FALSE(process.waitForFinished(100)) << process.readAllStandardError().toStdString();
        other = programsWith(second);
    }
    EXPECT_EQ(other.size(), 1U);
    for (const pid_t program : other)
        ::kill(program, SIGKILL);
    process.kill();
    process.waitForFinished();
    EXPECT_EQ(callCommandLine(QStringList(30, first)).exitCode, 2) << "too many windows";
}

TEST_F(CommandLine, WorkFoldersOfKilledProgramsAreRemovedAfterADay)
{
    const QDir temporary(m_folder.path());
    for (const char* const name : {"bolster-work-abcdef", "bolster-work-locked", "bolster-work-recent", "others"}) {
        ASSERT_TRUE(temporary.mkpath(QString(name) + "/inside"));
        const timespec twoDaysAgo[] = {{::time(nullptr) - 172'800, 0}, {::time(nullptr) - 172'800, 0}};
        if (std::string_view(name) != "bolster-work-recent")
            ::utimensat(AT_FDCWD, path(name).toUtf8().constData(), twoDaysAgo, 0);
    }
    const int locked = ::open(path("bolster-work-locked").toUtf8().constData(), O_RDONLY | O_DIRECTORY);
    ASSERT_EQ(::flock(locked, LOCK_EX), 0);
    QProcessEnvironment environment = bareEnvironment();
    environment.insert("TMPDIR", m_folder.path());
    EXPECT_EQ(runProgram({"import", design("seat.json", hammock()), path("seat.bolster")}, environment).exitCode,
              0);
    EXPECT_EQ(temporary.entryList(QDir::Dirs | QDir::NoDotAndDotDot),
              QStringList({"bolster-work-locked", "bolster-work-recent", "others"}));
    ::close(locked);
}

TEST_F(CommandLine, AnInterruptedImportLeavesNothing)
{
    std::string cloud;
    for (int i = 0; i < 4'000'000; ++i)
        cloud += std::to_string(i % 1000) + " " + std::to_string(i / 1000) + " 0\n";
    write("room.xyz", cloud);
    const Json scanned = with(hammock(), {{"id", 40}, {"kind", "scan"}, {"name", "Room"}, {"file", "room.xyz"}});
    const QString text = design("scanned.json", scanned);
    QDir(m_folder.path()).mkdir("temporary");
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        for (const int milliseconds : {50, 300, 900, 1500}) {
            QProcess process;
            QProcessEnvironment environment = bareEnvironment();
            environment.insert("TMPDIR", path("temporary"));
            process.setProcessEnvironment(environment);
            process.start(QString::fromStdString(test::program()), {"import", text, path("scanned.bolster")});
            ASSERT_TRUE(process.waitForStarted());
            // Before it looks after signals, in the middle, or at the end.
            if (!process.waitForFinished(milliseconds)) {
                ::kill(static_cast<pid_t>(process.processId()), signal);
                ASSERT_TRUE(process.waitForFinished(60'000));
            }
            QFile::remove(path("scanned.bolster"));
            EXPECT_EQ(QDir(m_folder.path()).entryList(QDir::Files | QDir::Hidden),
                      QStringList({"room.xyz", "scanned.json"}));
            EXPECT_TRUE(QDir(path("temporary")).isEmpty());
        }
    }
}

TEST_F(CommandLine, EndsCleanlyWhenInterrupted)
{
    Json large = hammock();
    large["settings"]["edge_length"] = 2;
    QProcess process;
    process.setProcessEnvironment(bareEnvironment());
    process.start(QString::fromStdString(test::program()),
                  {"solve", design("a.json", large), "--tolerance", "1e-300", "--max-iterations", "2000000000",
                   "--obj", path("a.obj"), "--report", path("report.json")});
    ASSERT_TRUE(process.waitForStarted());
    EXPECT_FALSE(process.waitForFinished(2000)); // it is at work, or only getting there: both must end well
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    ASSERT_TRUE(process.waitForFinished(60'000));
    EXPECT_EQ(process.exitStatus(), QProcess::NormalExit);
    EXPECT_EQ(process.exitCode(), 1);
    EXPECT_TRUE(contains(process.readAllStandardError().toStdString(), "interrupted"));
    EXPECT_FALSE(QFileInfo::exists(path("a.obj")));
    EXPECT_EQ(report()["reason"], "interrupted");
}

/// A pipe that has a reader who never reads.
class StuckPipe {
public:
    explicit StuckPipe(const QString& path)
    {
        EXPECT_EQ(::mkfifo(path.toUtf8().constData(), 0600), 0);
        m_reader = ::open(path.toUtf8().constData(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
        ::fcntl(m_reader, F_SETPIPE_SZ, room);
    }
    ~StuckPipe() { ::close(m_reader); }

    bool waitUntilFull() const
    {
        for (int round = 0; round < 600; ++round) {
            int there = 0;
            if (::ioctl(m_reader, FIONREAD, &there) == 0 && there > room - longestLine)
                return true;
            ::usleep(100'000);
        }
        return false;
    }

private:
    static constexpr int room = 4096;
    static constexpr int longestLine = 1024; // one for which there is no room waits as a whole
    int m_reader = -1;
};

TEST_F(CommandLine, OneSignalEndsItWhenNobodyReadsWhatItWrites)
{
    const QString file = design("a.json", hammock());
    Json many = hammock();
    for (int i = 0; i < 200; ++i)
        many["elements"].push_back({{"id", 100 + i}, {"kind", "sofa"}});
    const QString bad = design("bad.json", many);
    const QStringList onlyInputs = {"a.json", "bad.json"};
    struct Case {
        QStringList arguments;
        bool errors; ///< it is stderr that nobody reads
    };
    const QString obj = path("pipe.png"); // as pictures must be called
    for (const Case& given : {Case{{"solve", file, "--obj", obj}, false},
                              Case{{"render", file, "--image", obj, "--size", "640x480"}, false},
                              Case{{"solve", bad, "--report", path("report.json"), "--lenient"}, true}}) {
        const StuckPipe pipe(obj);
        QProcess process;
        process.setProcessEnvironment(bareEnvironment());
        if (given.errors)
            process.setStandardErrorFile(obj);
        process.start(QString::fromStdString(test::program()), given.arguments);
        ASSERT_TRUE(process.waitForStarted());
        ASSERT_TRUE(pipe.waitUntilFull()) << given.arguments.join(' ').toStdString();
        ::kill(static_cast<pid_t>(process.processId()), SIGTERM);
        ASSERT_TRUE(process.waitForFinished(60'000)) << "ended by one signal";
        EXPECT_EQ(process.exitStatus(), QProcess::NormalExit);
        EXPECT_EQ(process.exitCode(), 1);
        QFile::remove(obj);
        QFile::remove(path("report.json"));
        EXPECT_EQ(QDir(m_folder.path()).entryList(QDir::Files | QDir::Hidden | QDir::System), onlyInputs);
    }
}

TEST(Output, SharesThatAreRoundingAloneAreNothing)
{
    EXPECT_EQ(cli::percentText(0.1234), "12.3 %");
    EXPECT_EQ(cli::percentText(-0.5), "-50 %");
    EXPECT_EQ(cli::percentText(1.44e-15), "0 %");
    EXPECT_EQ(cli::percentText(-1e-6), "0 %");
    EXPECT_EQ(cli::percentText(0.0007), "0.07 %");
}

/// As "| head -1" leaves it.
ProgramRun runWithoutReader(const QStringList& arguments)
{
    int ends[2] = {-1, -1};
    if (::pipe(ends) != 0)
        return {};
    ::close(ends[0]);
    QProcess process;
    process.setProcessEnvironment(bareEnvironment());
    process.setChildProcessModifier([out = ends[1]] {
        ::dup2(out, STDOUT_FILENO);
        std::signal(SIGPIPE, SIG_DFL);
    });
    process.start(QString::fromStdString(test::program()), arguments);
    const bool ended = process.waitForFinished(120'000) && process.exitStatus() == QProcess::NormalExit;
    ::close(ends[1]);
    return {ended ? process.exitCode() : -1, {}, process.readAllStandardError().toStdString()};
}

TEST_F(CommandLine, FilesAreWrittenAlsoWhenNobodyReadsWhatIsPrinted)
{
    const QString file = design("a.json", hammock());
    write("box.obj", "v 0 0 0\nv 300 0 0\nv 300 200 0\nv 0 200 0\nf 1 2 3 4\n");
    for (const auto& [words, out] :
         {std::pair(QStringList{"solve", file, "--obj", path("cover.obj")}, "cover.obj"),
          std::pair(QStringList{"export", file, "--dxf", path("cut.dxf")}, "cut.dxf"),
          std::pair(QStringList{"convert", path("box.obj"), path("box.stl")}, "box.stl"),
          std::pair(QStringList{"flatten", path("box.obj"), "--out", path("flat.json")}, "flat.json"),
          std::pair(QStringList{"relieve", file, "--report", path("reliefs.json")}, "reliefs.json")}) {
        const ProgramRun run = runWithoutReader(words);
        EXPECT_EQ(run.exitCode, 0) << words.join(' ').toStdString() << run.err;
        EXPECT_TRUE(QFileInfo::exists(path(out))) << out;
    }
    EXPECT_EQ(runWithoutReader({"dump", file}).exitCode, 1) << "what is printed was all that was wanted";
}

} // namespace
} // namespace bolster
