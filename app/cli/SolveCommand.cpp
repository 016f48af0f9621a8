#include "CoverFindings.h"
#include "Interrupt.h"
#include "Output.h"
#include "Project.h"
#include "SolveOutputs.h"
#include "Solving.h"
#include "Subcommands.h"

#include <array>
#include <limits>

namespace bolster::cli {

const char* const solveHelp = R"(Usage: bolster solve DESIGN [options]

Sews and stretches the pattern of a design (JSON or a project) and writes the
cover at rest: a function of the design alone, the same on every run and number
of threads.

Outputs:
  --obj FILE            the cover as OBJ: millimetres, z up, a group per patch
  --ply FILE            the cover as binary PLY
  --image FILE.png      a picture of the cover with a checker
  --report FILE.json    what the solver did, in numbers

Options:
  --tolerance X         distance to the limit at which the solve ends, relative to
                        the size of the pattern (default 1e-6)
  --max-iterations N    give up after N iterations (default 5000)
  --threads N           use N threads (default 0: as many as the machine has)
  --lenient             leave bad elements out instead of refusing the design

Exit code:
  0  solved
  1  other failures: an output cannot be written, not enough memory, interrupted
  2  the design is bad (see "bolster check"), or wrong usage
  3  not converged; the outputs are written nevertheless
)";

namespace {

constexpr std::array solveRules = {
    OptionRule{"--obj", true},     OptionRule{"--ply", true},       OptionRule{"--image", true},
    OptionRule{"--report", true},  OptionRule{"--tolerance", true}, OptionRule{"--max-iterations", true},
    OptionRule{"--threads", true}, OptionRule{"--lenient", false},
};

SolveOptions solveOptions(const Arguments& arguments)
{
    SolveOptions options;
    constexpr double smallest = std::numeric_limits<double>::min();
    options.tolerance = arguments.number("--tolerance", options.tolerance, smallest, 1);
    options.maxIterations =
        arguments.integer("--max-iterations", options.maxIterations, 1, std::numeric_limits<int>::max());
    options.threads = arguments.integer("--threads", options.threads, 0, 1024);
    options.lenient = arguments.has("--lenient");
    return options;
}

void printSummary(const SolveResult& result)
{
    const SolveReport& report = result.report;
    const bool solved = result.status == SolveResult::Status::Solved;
    printResult((solved ? "solved in " : "not converged after ") + counted(report.iterations, "iteration") + ", " +
                numberText(report.time.total / 1000, 3) + " s");
    printResult(std::to_string(report.patches) + (report.patches == 1 ? " patch, " : " patches, ") +
                counted(report.seams, "seam") + ", " + std::to_string(report.vertices) + " vertices, " +
                counted(report.triangles, "triangle"));
    printResult("strain " + numberText(100 * report.strain.rms, 3) + " % rms, " +
                numberText(100 * report.strain.max, 3) + " % at most; fixation error " +
                numberText(report.fixationError.max, 3) + " mm, seam gap " + numberText(report.seamGap.max, 3) +
                " mm, " + counted(report.flippedTriangles, "flipped triangle"));
    for (const SolveReport::ScanFit& scan : report.scans) {
        if (scan.figures.coverage == 0) {
            printResult("scan \"" + scan.name + "\": no point of it is near the cover");
            continue;
        }
        printResult("scan \"" + scan.name + "\": " + numberText(scan.figures.rms, 3) + " mm rms, " +
                    numberText(scan.figures.p95, 3) + " mm within 95 %, over " +
                    numberText(100 * scan.figures.coverage, 3) + " % of the cover");
    }
}

/// What the workbench says beside "Solved".
void printWorries(const SurfaceMesh& surface, const OpenedDesign& opened)
{
    constexpr std::size_t mostSaid = 10;
    FrameDistance frames;
    const std::vector<CoverFinding> findings = coverFindings(surface, opened.design, opened.files, frames);
    const std::size_t said = findings.size() > mostSaid ? mostSaid - 1 : findings.size();
    for (std::size_t k = 0; k < said; ++k)
        printResult(findings[k].text.english());
    if (said < findings.size())
        printResult("and " + std::to_string(findings.size() - said) + " more of that kind");
}

} // namespace

int solve(std::span<const std::string> words)
{
    const Arguments arguments(words, solveRules);
    const QString path = arguments.onlyFile("DESIGN");
    const SolveOptions options = solveOptions(arguments);
    const SolveOutputs outputs(arguments, options.threads);

    Interrupt interrupt;
    const OpenedDesign opened = openedShown(path);
    outputs.files().protectInputs(path, opened.design);
    interrupt.whenEnded([&] { outputs.write(interruptedResult(), {}, {}); });
    const SolveResult result = solveOpened(opened, options, interrupt.token());
    printFindings(result);
    if (result.surface) {
        printSummary(result);
        printWorries(*result.surface, opened);
    }
    interrupt.beginWriting();
    const bool written = outputs.write(result, opened.design, interrupt.token());

    switch (result.status) {
    case SolveResult::Status::Solved:
        return written ? done : otherFailure;
    case SolveResult::Status::NotConverged:
        return written ? notConverged : otherFailure;
    case SolveResult::Status::Cancelled:
        return otherFailure;
    case SolveResult::Status::Failed:
        break;
    }
    return result.errors.empty() ? otherFailure : badInput;
}

} // namespace bolster::cli
