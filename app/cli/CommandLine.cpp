#include "CommandLine.h"

#include "Output.h"
#include "Reported.h"
#include "Subcommands.h"

#include <QFileInfo>

#include <algorithm>
#include <cstdio>

namespace bolster {
namespace {

const char* const help = R"(Usage: bolster [DESIGN ...]         open the workbench, a window for each
       bolster solve DESIGN ...     solve a design and write the cover
       bolster render DESIGN ...    draw pictures of the cover
       bolster export DESIGN ...    write the pattern for cutting, the cover for others
       bolster convert FILE OUT     make a plain mesh of a frame (STEP, glTF, FBX ...)
       bolster check DESIGN         report everything that is wrong with a design
       bolster dump FILE            write a project's design as text
       bolster import DESIGN FILE   make a project of a design
       bolster import-pattern FILE DESIGN.json
                                    make a design of a pattern (DXF, SVG)
       bolster flatten SURFACE --out DESIGN.json
                                    make the pattern of a form (a mesh)
       bolster fit-pattern DESIGN --to GOAL --out DESIGN.json
                                    change a pattern until its cover fits a goal
       bolster sweep DESIGN ...     say where the cover varies when tolerances do
       bolster explain DESIGN ...   say why a piece that was scanned is as it is
       bolster relieve DESIGN       say where to change a pattern that strains its cloth
       bolster history FILE         list the edits of a project
       bolster verify FILE          look for damage in a project
       bolster salvage FILE OUT     get out what is left of a damaged project
       bolster thumbnail PROJECT OUT.png
                                    copy the small picture kept in a project
       bolster bench                measure the solver against other libraries
       bolster COMMAND --help       explain a command
       bolster --portable ...       keep settings and work beside the program
       bolster --version            print the version

Bolster turns a sewing pattern, its seams and the curves that hold it on a frame
into a 3D cover.
)";

struct Command {
    std::string_view name;
    const char* help;
    int (*run)(std::span<const std::string> words);
};

const Command commands[] = {{"solve", cli::solveHelp, cli::solve},
                            {"render", cli::renderHelp, cli::render},
                            {"check", cli::checkHelp, cli::check},
                            {"dump", cli::dumpHelp, cli::dump},
                            {"import", cli::importHelp, cli::importDesign},
                            {"import-pattern", cli::importPatternHelp, cli::importPattern},
                            {"history", cli::historyHelp, cli::history},
                            {"verify", cli::verifyHelp, cli::verify},
                            {"salvage", cli::salvageHelp, cli::salvage},
                            {"thumbnail", cli::thumbnailHelp, cli::thumbnail},
                            {"export", cli::exportHelp, cli::exportPattern},
                            {"flatten", cli::flattenHelp, cli::flattenForm},
                            {"fit-pattern", cli::fitPatternHelp, cli::fitPattern},
                            {"sweep", cli::sweepHelp, cli::sweep},
                            {"explain", cli::explainHelp, cli::explain},
                            {"relieve", cli::relieveHelp, cli::relieve},
                            {"convert", cli::convertHelp, cli::convert},
                            {"bench", cli::benchHelp, cli::bench}};

int run(const Command& command, std::span<const std::string> words)
{
    const std::string name = "bolster " + std::string(command.name);
    for (const std::string& word : words) {
        if (word == "--help" || word == "-h") {
            std::fputs(command.help, stdout);
            return cli::done;
        }
    }
    return cli::reported(name, [&] { return command.run(words); });
}

/// A word that is neither a file nor looks like one is a mistyped command, not a design to open.
bool looksLikeCommand(const std::string& word)
{
    return word.find_first_of("-./\\:") == std::string::npos && !QFileInfo::exists(QString::fromStdString(word));
}

/// Nothing when the window can open all of them.
std::optional<int> windowProblem(const std::vector<std::string>& words)
{
    constexpr std::size_t mostWindows = 20;
    try {
        std::ranges::for_each(words, cli::exactText);
        if (words.size() > mostWindows)
            throw cli::UsageError("each design gets a window of its own, and " + std::to_string(words.size()) +
                                  " are too many: open " + std::to_string(mostWindows) + " at most at once");
    } catch (const cli::UsageError& error) {
        cli::printError(std::string("bolster: ") + error.what());
        return cli::badInput;
    }
    return std::nullopt;
}

} // namespace

std::optional<int> runCommandLine(int argc, char** argv)
{
    const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    if (words.empty())
        return std::nullopt;
    const std::string& first = words.front();
    if (first == "--help" || first == "-h" || (first == "help" && looksLikeCommand(first))) {
        std::fputs(help, stdout);
        return cli::done;
    }
    if (first == "--version") {
        std::puts("bolster " BOLSTER_VERSION);
        return cli::done;
    }
    for (const Command& command : commands)
        if (command.name == first)
            return run(command, std::span(words).subspan(1));
    const bool option = first.starts_with('-');
    if (!option && !looksLikeCommand(first))
        return windowProblem(words);
    cli::printError((option ? "bolster: unknown option \"" : "bolster: unknown command \"") + first + "\"");
    cli::printError("Try \"bolster --help\".");
    return cli::badInput;
}

} // namespace bolster
