// `bolster sweep`, as a script calls it.
#include "../model/TestFiles.h"
#include "ProgramRun.h"
#include "TestPaths.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <QDir>

namespace bolster {
namespace {

using Json = nlohmann::json;

Json cushion()
{
    QFile file(QString::fromStdString(test::samplesFolder() + "/box-cushion/box-cushion.json"));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    Json design = Json::parse(file.readAll().toStdString());
    design["settings"]["edge_length"] = 40;
    return design;
}

constexpr const char* usualSpec =
    R"({"tolerances": {"cut_mm": 1, "stiffness_percent": 10}, "limits": {"distance_mm": 0.5}, "seed": 3})";

class SweepCommand : public TestFiles {
protected:
    void SetUp() override
    {
        write("design.json", cushion().dump());
        write("spec.json", usualSpec);
    }

    ProgramRun sweep(const QString& folder, const QStringList& more = {}, const QString& design = "design.json",
                     const QString& spec = "spec.json") const
    {
        return callCommandLine(QStringList{"sweep", path(design), "--spec", path(spec), "--samples", "50",
                                           "--linear", "200", "--out", path(folder)} +
                               more);
    }

    void expectSame(const QString& a, const QString& b) const
    {
        for (const char* name : {"report.json", "samples.csv", "p95.ply", "parts/000000.part", "parts/000001.part",
                                 "parts/000002.part"})
            EXPECT_EQ(read(a + "/" + name), read(b + "/" + name)) << name;
    }

    /// The exit code, and what is said.
    void expectRefused(const std::string& spec, const std::string& words) const
    {
        write("bad.json", spec);
        const ProgramRun run = sweep("refused", {}, "design.json", "bad.json");
        EXPECT_EQ(run.exitCode, 2) << spec;
        EXPECT_NE(run.err.find(words), std::string::npos) << spec << "\n" << run.err;
        EXPECT_FALSE(QFile::exists(path("refused"))) << spec;
    }
};

TEST_F(SweepCommand, WritesFigures)
{
    const ProgramRun run = sweep("out");
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const Json report = Json::parse(read("out/report.json"));
    EXPECT_EQ(report["linear"]["samples"], 200);
    EXPECT_EQ(report["solved"]["samples"], 50);
    EXPECT_EQ(report["solved"]["without_cover"], 0);
    const double linear = report["linear"]["p95"]["rms_mm"], solved = report["solved"]["p95"]["rms_mm"];
    EXPECT_NEAR(linear, solved, 0.15 * solved);
    double shares = 0;
    for (const Json& one : report["influence"])
        shares += one["share"].get<double>();
    EXPECT_NEAR(shares, 1, 1e-9);
    const std::string csv = read("out/samples.csv");
    EXPECT_EQ(std::ranges::count(csv, '\n'), 51);
    EXPECT_TRUE(csv.starts_with("sample,rms_mm,p95_mm,max_mm,strain_p99,out\n0,"));
    EXPECT_NE(run.out.find("of 50 solved pieces are out of limits; of many, "), std::string::npos) << run.out;
    EXPECT_LT(run.out.find("as if covers were linear"), run.out.find("by 50 solved pieces"));
    const Json ofMany = report["solved"]["out_of_limits_of_many"];
    const double out = report["solved"]["out_of_limits"].get<double>() / 50;
    EXPECT_LT(ofMany[0], out);
    EXPECT_GE(ofMany[1], out);
}

TEST_F(SweepCommand, GoesOnWhereItWas)
{
    ASSERT_EQ(sweep("whole").exitCode, 0);
    ASSERT_EQ(sweep("again").exitCode, 0);
    expectSame("whole", "again");
    for (const char* name : {"parts/000001.part", "report.json", "samples.csv"})
        ASSERT_TRUE(QFile::remove(path("again/" + QString(name))));
    ASSERT_EQ(sweep("again", {"--threads", "3"}).exitCode, 0);
    expectSame("whole", "again");
}

TEST_F(SweepCommand, TakesMoreSamplesAndOtherLimits)
{
    const auto samples = [&](const char* count, const QString& spec) {
        return callCommandLine({"sweep", path("design.json"), "--spec", path(spec), "--samples", count, "--linear",
                                "200", "--out", path("out")});
    };
    ASSERT_EQ(sweep("whole").exitCode, 0);
    ASSERT_EQ(samples("30", "spec.json").exitCode, 0);
    const std::string first = read("out/parts/000000.part");
    ASSERT_EQ(samples("50", "spec.json").exitCode, 0);
    EXPECT_EQ(read("out/parts/000000.part"), first);
    expectSame("whole", "out");
    const std::string last = read("out/parts/000002.part");
    ASSERT_EQ(samples("45", "spec.json").exitCode, 0) << "fewer";
    EXPECT_EQ(Json::parse(read("out/report.json"))["solved"]["samples"], 45);
    write("wide.json",
          R"({"tolerances": {"cut_mm": 1, "stiffness_percent": 10}, "limits": {"distance_mm": 50}, "seed": 3})");
    ASSERT_EQ(samples("50", "wide.json").exitCode, 0);
    EXPECT_EQ(Json::parse(read("out/report.json"))["solved"]["out_of_limits"], 0);
    EXPECT_EQ(read("out/parts/000002.part"), last) << "nothing is solved again";
}

TEST_F(SweepCommand, MakesDamagedPartsAnew)
{
    ASSERT_EQ(sweep("whole").exitCode, 0);
    ASSERT_EQ(sweep("again").exitCode, 0);
    std::string flipped = read("again/parts/000000.part");
    flipped[flipped.size() / 2] = static_cast<char>(flipped[flipped.size() / 2] ^ 1);
    write("again/parts/000000.part", flipped);
    const std::string second = read("again/parts/000001.part");
    write("again/parts/000001.part", second.substr(0, second.size() / 3));
    write("again/parts/000002.part", second); // which has a right sum, and other samples
    ASSERT_EQ(sweep("again").exitCode, 0);
    expectSame("whole", "again");
    write("again/parts/000001.part", "");
    write("again/parts/000002.part", second + "more");
    ASSERT_EQ(sweep("again").exitCode, 0);
    expectSame("whole", "again");
}

TEST_F(SweepCommand, PartsOfSeveralMachinesAreTheSameAsInOneGo)
{
    ASSERT_EQ(sweep("whole").exitCode, 0);
    const ProgramRun run = sweep("parts", {"--part", "1/2"});
    ASSERT_EQ(run.exitCode, 0);
    EXPECT_FALSE(QFile::exists(path("parts/report.json")));
    EXPECT_NE(run.out.find("portions 1, 3 ... of 3 portions are solved"), std::string::npos) << run.out;
    EXPECT_FALSE(QFile::exists(path("parts/parts/000000.part"))) << "which is the other one's";
    EXPECT_TRUE(QFile::exists(path("parts/parts/000001.part")));
    ASSERT_EQ(sweep("parts", {"--part", "0/2", "--threads", "1"}).exitCode, 0);
    EXPECT_TRUE(QFile::exists(path("parts/parts/000002.part")));
    ASSERT_EQ(sweep("parts").exitCode, 0);
    expectSame("whole", "parts");
    for (const char* wrong : {"2/2", "-1/2", "1", "1/0", "a/b", "1/2/3", "/"})
        EXPECT_EQ(sweep("parts", {"--part", wrong}).exitCode, 2) << wrong;
}

TEST_F(SweepCommand, RefusesTheFolderOfAnotherDesign)
{
    ASSERT_EQ(sweep("out").exitCode, 0);
    const std::string before = read("out/report.json");
    Json other = cushion();
    other["elements"][1]["pressure"] = 0.31;
    write("other.json", other.dump());
    write("other-spec.json", R"({"tolerances": {"cut_mm": 2}})");
    for (const ProgramRun& run :
         {sweep("out", {}, "other.json"), sweep("out", {}, "design.json", "other-spec.json"),
          sweep("out", {"--samples", "40"})}) {
        EXPECT_EQ(run.exitCode, run.err.find("--samples") == std::string::npos ? 1 : 2) << run.err;
        EXPECT_TRUE(run.out.empty()) << run.out;
    }
    EXPECT_NE(sweep("out", {}, "other.json").err.find("choose another folder"), std::string::npos);
    EXPECT_EQ(read("out/report.json"), before);
}

/// What foam is made of lies in another file.
TEST_F(SweepCommand, RefusesTheFolderOfAnotherFrame)
{
    const QString folder = QString::fromStdString(test::samplesFolder()) + "/trapezoid-cushion/";
    QFile design(folder + "trapezoid-cushion.json"), cube(folder + "cube.obj");
    ASSERT_TRUE(design.open(QIODevice::ReadOnly) && cube.open(QIODevice::ReadOnly));
    Json coarse = Json::parse(design.readAll().toStdString());
    coarse["settings"]["edge_length"] = 25;
    write("seat.json", coarse.dump());
    write("spec.json", R"({"tolerances": {"foam_mm": 10}})");
    const QByteArray frame = cube.readAll();
    write("cube.obj", frame.toStdString());
    ASSERT_EQ(sweep("out", {}, "seat.json").exitCode, 0);
    EXPECT_EQ(sweep("out", {}, "seat.json").exitCode, 0);
    write("cube.obj", frame.toStdString() + "v 0 0 1\nf 1 2 -1\n");
    const ProgramRun run = sweep("out", {}, "seat.json");
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_NE(run.err.find("choose another folder"), std::string::npos) << run.err;
}

TEST_F(SweepCommand, SaysWhatIsWrongWithASpec)
{
    expectRefused("{\"tolerances\": {\"cut_mm\": 1}", "bad.json");
    expectRefused("", "bad.json");
    expectRefused("[1, 2]", "tolerances: an object");
    expectRefused("{}", "tolerances: an object");
    expectRefused(R"({"tolerances": {}})", "nothing varies");
    expectRefused(R"({"tolerances": {"foam_mm": 5}})", "nothing varies");
    expectRefused(R"({"tolerances": {"cut": 1}})", "tolerances.cut: unknown");
    expectRefused(R"({"tolerances": {"cut_mm": 1}, "sead": 1})", "sead: unknown");
    expectRefused(R"({"tolerances": {"cut_mm": -1}})", "tolerances.cut_mm: a number above 0");
    expectRefused(R"({"tolerances": {"cut_mm": 0}})", "tolerances.cut_mm");
    expectRefused(R"({"tolerances": {"cut_mm": 1e-300}})", "tolerances.cut_mm: a number above 0 (at least");
    expectRefused(R"({"tolerances": {"cut_mm": "1"}})", "tolerances.cut_mm");
    expectRefused(R"({"tolerances": {"cut_mm": 1e99}})", "tolerances.cut_mm");
    expectRefused(R"({"tolerances": {"cut_mm": 1}, "seed": -1})", "seed");
    expectRefused(R"({"tolerances": {"cut_mm": 1}, "distribution": "even"})", "distribution");
    expectRefused(R"({"tolerances": {"cut_mm": 1}, "limits": {"distance_mm": -1}})", "limits.distance_mm");
    expectRefused(R"({"tolerances": {"cut_mm": 1}, "limits": {"far": 1}})", "limits.far: unknown");
    expectRefused(R"({"tolerances": {"cut_mm": 1, "cut_mm": 2}})", "cut_mm: stands there twice");
}

TEST_F(SweepCommand, SaysWhatIsWrongWithAField)
{
    const auto field = [](const std::string& text) { return R"({"tolerances": {"fields": [)" + text + "]}}"; };
    expectRefused(R"({"tolerances": {"fields": 3}})", "tolerances.fields: a list");
    expectRefused(field("3"), "tolerances.fields[0]");
    expectRefused(field(R"({"element": 999, "field": "pressure", "by": 1})"), "no element 999");
    expectRefused(field(R"({"element": 4294967298, "field": "pressure", "by": 1})"), "no element 4294967298");
    expectRefused(field(R"({"element": 2, "field": "presure", "by": 1})"), "no number \"presure\"");
    expectRefused(field(R"({"element": 2, "field": "pressure", "by": -0.1})"), "tolerances.fields[0].by");
    expectRefused(field(R"({"element": 2, "field": "pressure"})"), "tolerances.fields[0]");
    expectRefused(field(R"({"element": 2, "field": "pressure", "by": 0.1},
                           {"element": 2, "field": "pressure", "by": 0.1, "percent": true})"),
                  "tolerances.fields[1].percent: unknown");
    expectRefused(field(R"({"element": 2, "field": "pressure", "by": 0.1},
                           {"element": 2, "field": "pressure", "by": 0.2})"),
                  "tolerances.fields[1]: the pressure of element 2 stands there twice");
    write("spec.json", field(R"({"element": 2, "field": "pressure", "by": 0.05})"));
    EXPECT_EQ(sweep("out", {"--samples", "1"}).exitCode, 2) << "--samples twice";
    const ProgramRun run = sweep("out");
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_NE(run.out.find("pressure of element 2"), std::string::npos) << run.out;
}

TEST_F(SweepCommand, FailsWhereNoSampleComesToRest)
{
    write("spec.json", R"({"tolerances": {"stiffness_percent": 5000, "size_percent": 300}})");
    const ProgramRun run = callCommandLine({"sweep", path("design.json"), "--spec", path("spec.json"), "--samples",
                                            "3", "--linear", "200", "--out", path("out")});
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_NE(run.err.find("not one of the samples has a cover at rest"), std::string::npos) << run.err;
    const Json solved = Json::parse(read("out/report.json"))["solved"];
    EXPECT_EQ(solved["without_cover"], solved["samples"]);
    EXPECT_TRUE(solved["p95"].is_null()) << "what is not known is not nothing";
}

/// A tolerance as large as a piece makes no pattern that can be solved.
TEST_F(SweepCommand, NamesTolerancesThatAreTooLarge)
{
    write("spec.json", R"({"tolerances": {"cut_mm": 300, "stiffness_percent": 10}})");
    const ProgramRun run = sweep("out");
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_NE(run.err.find("no cover is found, such as"), std::string::npos) << run.err;
    const Json linear = Json::parse(read("out/report.json"))["linear"];
    EXPECT_GT(linear["without_cover"].size(), 0u);
}

TEST_F(SweepCommand, NeedsItsOptions)
{
    const QString design = path("design.json"), spec = path("spec.json"), out = path("out");
    for (const QStringList& words :
         {QStringList{"sweep", design}, QStringList{"sweep", design, "--spec", spec, "--samples", "5"},
          QStringList{"sweep", design, "--spec", spec, "--out", out},
          QStringList{"sweep", design, "--samples", "5", "--out", out},
          QStringList{"sweep", design, "--spec", spec, "--samples", "-5", "--out", out},
          QStringList{"sweep", design, "--spec", path("missing.json"), "--samples", "5", "--out", out},
          QStringList{"sweep", path("missing.json"), "--spec", spec, "--samples", "5", "--out", out}})
        EXPECT_EQ(callCommandLine(words).exitCode, 2) << words.join(' ').toStdString();
    write("file", "no folder");
    EXPECT_EQ(sweep("file").exitCode, 1);
}

} // namespace
} // namespace bolster
