#include "BenchReport.h"
#include "Commands.h"
#include "Interrupt.h"
#include "Output.h"
#include "WholeFile.h"

#include <nlohmann/json.hpp>

#include <array>

namespace bolster::cli {

const char* const benchHelp = R"(Usage: bolster bench [options]

Measures Bolster's solver against other libraries (CGAL, CHOLMOD, Eigen) on the
same meshes, and prints a table: times in milliseconds, ratio = peer / ours.
Takes up to five minutes; the machine should have nothing else to do.

Options:
  --quick               one minute, without the largest meshes
  --json FILE           the table as JSON: a list of rows
  --markdown FILE       the table as Markdown, with the machine

Exit code:
  0  done
  1  a benchmark failed, an output cannot be written, or interrupted
  2  wrong usage
)";

namespace {

constexpr std::array benchOptions = {
    OptionRule{"--json", true}, OptionRule{"--markdown", true}, OptionRule{"--quick", false},
    OptionRule{"--smoke", false}, // for tests: tiny meshes, figures that say nothing
};

bench::Extent extentOf(const Arguments& arguments)
{
    if (arguments.has("--smoke"))
        return bench::Extent::Smoke;
    return arguments.has("--quick") ? bench::Extent::Quick : bench::Extent::Full;
}

std::string json(const std::vector<bench::Row>& rows)
{
    using Json = nlohmann::ordered_json;
    Json list = Json::array();
    for (const bench::Row& row : rows)
        if (row.listed)
            list.push_back({{"name", row.name},
                            {"ours_ms", row.ours},
                            {"peer", row.peer ? Json(*row.peer) : Json()},
                            {"peer_ms", row.peer ? Json(row.peerTime) : Json()},
                            {"ratio", row.peer ? Json(row.ratio()) : Json()}});
    return list.dump(2) + "\n";
}

/// False when the file cannot be written.
bool write(const Arguments& arguments, const char* option, const std::string& text)
{
    if (!arguments.has(option))
        return true;
    const Message problem = replaceWholeFile(arguments.path(option), text);
    if (problem.empty())
        printResult("wrote " + arguments.path(option).toStdString());
    else
        printError("error: " + problem.english());
    return problem.empty();
}

} // namespace

int bench(std::span<const std::string> words)
{
    const Arguments arguments(words, benchOptions);
    arguments.expectNoFile();
    const bench::Extent extent = extentOf(arguments);

    Interrupt interrupt;
    std::vector<bench::Row> rows;
    printResult(bench::tableHead());
    for (const bench::Benchmark& benchmark : bench::benchmarks(extent)) {
        const std::vector<bench::Row> measured = bench::run(benchmark, extent, interrupt.token());
        for (const bench::Row& row : measured)
            printResult(bench::tableLine(row));
        rows.insert(rows.end(), measured.begin(), measured.end());
    }
    if (interrupt.token().stop_requested()) {
        printError("error: interrupted");
        return otherFailure;
    }
    interrupt.beginWriting();
    const bool jsonWritten = write(arguments, "--json", json(rows));
    return write(arguments, "--markdown", bench::markdown(rows)) && jsonWritten ? done : otherFailure;
}

} // namespace bolster::cli
