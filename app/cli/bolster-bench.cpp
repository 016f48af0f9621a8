// Beside Bolster: what "bolster bench" becomes.
#include "BenchOptions.h"
#include "BenchReport.h"
#include "Interrupt.h"
#include "Output.h"
#include "Reported.h"
#include "Subcommands.h"
#include "WholeFile.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace bolster::cli {
namespace {

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

int measure(std::span<const std::string> words)
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

} // namespace
} // namespace bolster::cli

int main(int argc, char** argv)
{
    const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    return bolster::cli::reported("bolster bench", [&] { return bolster::cli::measure(words); });
}
