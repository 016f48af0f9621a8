// "bolster bench" with tiny meshes: what it measures is no use, but everything runs and is reported.
#include "../model/TestFiles.h"
#include "ProgramRun.h"
#include "TestPaths.h"

#include <nlohmann/json.hpp>

#include <map>
#include <set>

namespace bolster {
namespace {

using Json = nlohmann::json;

class Bench : public TestFiles {};

TEST_F(Bench, ReportsEveryBenchmarkAgainstItsPeers)
{
    const ProgramRun run = runProgram({"bench", "--smoke", "--json", path("b.json"), "--markdown", path("b.md")});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(run.err, "");

    std::map<std::string, std::set<std::string>> peers;
    const Json rows = Json::parse(read("b.json"));
    for (const Json& row : rows) {
        const std::string name = row["name"];
        const bool alone = row["peer"].is_null();
        EXPECT_TRUE(peers[name].insert(alone ? "" : row["peer"].get<std::string>()).second) << name << " twice";
        EXPECT_EQ(row.size(), 5U) << name;
        for (const char* key : {"ours_ms", "peer_ms", "ratio"}) {
            if (alone && std::string(key) != "ours_ms") {
                EXPECT_TRUE(row[key].is_null()) << name << " " << key;
                continue;
            }
            ASSERT_TRUE(row[key].is_number()) << name << " " << key;
            EXPECT_GT(row[key].get<double>(), 0) << name << " " << key; // infinities are written as null
        }
        if (!alone) {
            EXPECT_DOUBLE_EQ(row["ratio"].get<double>(),
                             row["peer_ms"].get<double>() / row["ours_ms"].get<double>())
                << name;
        }
        EXPECT_NE(run.out.find(name), std::string::npos) << name;
        EXPECT_NE(read("b.md").find(name), std::string::npos) << name;
    }
    const std::set<std::string> cgal = {"CGAL SRE_ARAP", "CGAL ORIGINAL_ARAP"};
    const std::set<std::string> allOfCgal = {"CGAL SRE_ARAP", "CGAL ORIGINAL_ARAP", "CGAL SRE_ARAP with UMFPACK"};
    const std::set<std::string> factors = {"CHOLMOD simplicial", "CHOLMOD supernodal", "Eigen LDLT"};
    const std::set<std::string> paper = {"paper, GeForce 8800 (2008)"}, nobody = {""};
    const std::map<std::string, std::set<std::string>> expected = {
        {"iteration_11k", allOfCgal},
        {"iteration_45k", allOfCgal},
        {"converge_bend_11k", cgal},
        {"solve_11k", factors},
        {"solve_45k", factors},
        {"table1_basic", paper},
        {"table1_cushion", paper},
        {"table1_g1", paper},
        {"table1_fit", paper},
        {"setup_11k", nobody},
        {"drag_11k", nobody},
        {"drag_45k", nobody},
        {"drag_180k", nobody},
        {"release_11k", nobody},
        {"rest_11k", nobody},
        {"release_45k", nobody},
        {"release_180k", nobody},
        {"rest_45k", nobody},
        {"rest_180k", nobody},
        {"cold_armchair_12", {"one level"}},
        {"cold_car_seat", {"one level"}},
        {"cold_car_seat_cushioned", {"one level"}},
        {"floor_fraction_45k", {"two reads of the factor"}},
        {"growth_11k_45k", {"iteration at 45k"}},
        {"growth_45k_180k", {"iteration at 180k"}},
    };
    EXPECT_EQ(peers, expected);
}

TEST_F(Bench, RefusesWrongUsage)
{
    EXPECT_EQ(callCommandLine({"bench", "chair.json"}).exitCode, 2);
    EXPECT_EQ(callCommandLine({"bench", "--json"}).exitCode, 2);
    EXPECT_EQ(callCommandLine({"bench", "--fast"}).exitCode, 2);
}

TEST_F(Bench, SaysWhatCannotBeWritten)
{
    const ProgramRun run = runProgram({"bench", "--smoke", "--json", path("none/b.json")});
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_NE(run.err.find("none/b.json\" cannot be written"), std::string::npos) << run.err;
}

/// What it is compared with is not loaded by those who design.
TEST_F(Bench, IsAProgramOfItsOwn)
{
    QProcess process;
    process.start("readelf", {"--wide", "--dynamic", QString::fromStdString(test::program())});
    ASSERT_TRUE(process.waitForFinished(60'000));
    const QByteArray elf = process.readAllStandardOutput();
    EXPECT_TRUE(elf.contains("libQt6Core"));
    for (const char* peer : {"libcholmod", "libumfpack"})
        EXPECT_FALSE(elf.contains(peer)) << peer;
}

} // namespace
} // namespace bolster
