// `bolster fit-pattern`, as a script calls it.
#include "../model/TestFiles.h"
#include "ProgramRun.h"
#include "TestPaths.h"

#include <QDir>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace bolster {
namespace {

using Json = nlohmann::json;

class FitPattern : public TestFiles {
protected:
    void SetUp() override
    {
        QFile file(QString::fromStdString(test::samplesFolder() + "/box-cushion/box-cushion.json"));
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        right = Json::parse(file.readAll().toStdString());
        right["settings"]["edge_length"] = 40;
        wrong = right;
        wrong["elements"][1]["outline"]["points"] = Json::parse("[[-4, 3], [506, 2], [497, 505], [3, 496]]");
        write("right.json", right.dump());
        write("wrong.json", wrong.dump());
    }

    ProgramRun fit(const QStringList& more) const
    {
        return callCommandLine(QStringList{"fit-pattern", path("wrong.json")} + more);
    }

    void expectRefused(const QStringList& more, const std::string& words, int code = 2) const
    {
        const ProgramRun run = fit(more + QStringList{"--out", path("refused.json")});
        EXPECT_EQ(run.exitCode, code) << more.join(' ').toStdString();
        EXPECT_NE(run.err.find(words), std::string::npos) << more.join(' ').toStdString() << "\n" << run.err;
        EXPECT_FALSE(QFile::exists(path("refused.json")));
    }

    Json right, wrong;
};

TEST_F(FitPattern, ComesNearerToAForm)
{
    ASSERT_EQ(callCommandLine({"solve", path("right.json"), "--obj", path("form.obj")}).exitCode, 0);
    const ProgramRun run = fit({"--to", path("form.obj"), "--out", path("fitted.json"), "--report",
                                path("report.json"), "--threads", "2"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const Json report = Json::parse(read("report.json"));
    const double before = report["before"]["distance_mm"]["rms"], after = report["after"]["distance_mm"]["rms"];
    EXPECT_LT(after, 0.5 * before);
    EXPECT_GT(report["changes"].size(), 0u);
    EXPECT_NE(run.out.find("mm rms from the form"), std::string::npos) << run.out;
    const Json fitted = Json::parse(read("fitted.json"));
    EXPECT_EQ(fitted["elements"].size(), wrong["elements"].size());
    EXPECT_EQ(callCommandLine({"check", path("fitted.json")}).exitCode, 0);
    // What is there is never replaced.
    const std::string kept = read("fitted.json");
    const ProgramRun again = fit({"--to", path("form.obj"), "--out", path("fitted.json")});
    EXPECT_EQ(again.exitCode, 1);
    EXPECT_NE(again.err.find("is there already"), std::string::npos) << again.err;
    EXPECT_EQ(read("fitted.json"), kept);
    ASSERT_TRUE(QFile::link(path("nowhere.json"), path("link.json")));
    EXPECT_EQ(fit({"--to", path("form.obj"), "--out", path("link.json")}).exitCode, 1);
    EXPECT_FALSE(QFile::exists(path("nowhere.json")));
}

TEST_F(FitPattern, SaysWhatItCostsInStrainAndWhichGoalIsHardlyNearer)
{
    const ProgramRun smaller =
        fit({"--to", "size:Top=90%", "--limit", "5", "--lock", "none,patch:Front,patch:Rear,patch:Left,patch:Right",
             "--out", path("smaller.json"), "--report", path("report.json"), "--threads", "2"});
    ASSERT_EQ(smaller.exitCode, 0) << smaller.err;
    const Json report = Json::parse(read("report.json"));
    EXPECT_GT(report["after"]["over_limit"].get<double>(), report["before"]["over_limit"].get<double>() + 0.01);
    EXPECT_NE(smaller.out.find("of the cover over the limit"), std::string::npos) << smaller.out;
    EXPECT_NE(smaller.err.find("warning: more of the cloth is strained over its limits"), std::string::npos)
        << smaller.err;
    EXPECT_EQ(smaller.err.find("hardly nearer"), std::string::npos) << smaller.err;

    const ProgramRun stays = fit({"--to", "strain", "--limit", "1", "--area", "Top:250,240,120", "--max-change",
                                  "0.1", "--out", path("stays.json"), "--threads", "2"});
    ASSERT_EQ(stays.exitCode, 0) << stays.err;
    EXPECT_NE(stays.err.find("warning: it comes hardly nearer to the limit of strain: 100 % before, 100 % now"),
              std::string::npos)
        << stays.out << stays.err;
}

TEST_F(FitPattern, SaysWhichFilesAreMissingWhereItWrites)
{
    ASSERT_EQ(callCommandLine({"solve", path("right.json"), "--obj", path("form.obj")}).exitCode, 0);
    Json withFrame = wrong;
    withFrame["elements"].push_back({{"id", 900}, {"kind", "frame"}, {"name", "Box"}, {"file", "form.obj"}});
    write("framed.json", withFrame.dump());
    ASSERT_TRUE(QDir(path("")).mkdir("elsewhere"));
    const auto fitTo = [&](const QString& out) {
        return callCommandLine(
            {"fit-pattern", path("framed.json"), "--to", "size:Top=99%", "--out", path(out), "--threads", "2"});
    };
    const ProgramRun beside = fitTo("beside.json"), away = fitTo("elsewhere/away.json");
    ASSERT_EQ(beside.exitCode, 0) << beside.err;
    ASSERT_EQ(away.exitCode, 0) << away.err;
    EXPECT_EQ(beside.err.find("form.obj"), std::string::npos) << beside.err;
    EXPECT_NE(away.err.find("copy form.obj from"), std::string::npos) << away.err;
}

TEST_F(FitPattern, RefusesWordsThatItDoesNotKnow)
{
    expectRefused({"--to", "strain", "--freedom", "outline"}, "not \"outline\"");
    expectRefused({"--to", "strain", "--freedom", "outlines,"}, "--freedom");
    expectRefused({"--to", "strain", "--freedom", ""}, "--freedom");
    expectRefused({"--to", "strain", "--lock", "length"}, "not \"length\"");
    expectRefused({"--to", "strain", "--lock", "none,lengths"}, "none without lengths");
    expectRefused({"--to", "strain", "--lock", "patch:Bottom"}, "no patch \"Bottom\"");
    expectRefused({"--to", "strain", "--patch", "Bottom"}, "no patch \"Bottom\"");
    expectRefused({"--to", "strian"}, "strian");
    expectRefused({"--to", path("missing.obj")}, "missing.obj");
    expectRefused({"--to", "scan"}, "no scan");
    expectRefused({}, "--to");
    expectRefused({"--to", "strain", "--freedom", "foam"}, "nothing of what --freedom names");
    expectRefused({"--to", "strain", "--max-change", "-1"}, "--max-change");
    expectRefused({"--to", "strain", "--limit", "0"}, "--limit");
    expectRefused({"--to", "size:Top=50%", "--to", "size:Top=150%"}, "a size already");
    expectRefused({"--to", "strain", "--area", "Top:900,100,50"}, "nothing of the patch is there");
    expectRefused({"--to", "strain", "--lock", "patch:Top,patch:Front,patch:Rear,patch:Left,patch:Right"},
                  "holds all of what --freedom names");
    EXPECT_EQ(fit({"--to", "strain"}).exitCode, 2) << "where to?";
    EXPECT_EQ(
        callCommandLine({"fit-pattern", path("missing.json"), "--to", "strain", "--out", path("x.json")}).exitCode,
        2);
}

TEST_F(FitPattern, SaysWhenTheFormIsElsewhere)
{
    write("far.obj", "v 0 0 5000\nv 500 0 5000\nv 0 500 5000\nf 1 2 3\n");
    expectRefused({"--to", path("far.obj")}, "near the form", 1);
    expectRefused({"--to", path("far.obj"), "--to", path("far.obj")}, "one form alone");
}

TEST_F(FitPattern, HoldsPatchesThatAreLocked)
{
    ASSERT_EQ(callCommandLine({"solve", path("right.json"), "--obj", path("form.obj")}).exitCode, 0);
    const ProgramRun run = fit({"--to", path("form.obj"), "--out", path("fitted.json"), "--lock",
                                "lengths,patch:Front,patch:Rear,patch:Left,patch:Right", "--max-change", "2"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const Json fitted = Json::parse(read("fitted.json"));
    for (const Json& element : fitted["elements"])
        for (const Json& before : wrong["elements"])
            if (element["kind"] == "patch" && element["id"] == before["id"] && element["name"] != "Top") {
                EXPECT_EQ(element["outline"]["points"], before["outline"]["points"]) << element["name"];
            }
}

} // namespace
} // namespace bolster
