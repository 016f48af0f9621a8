#include "CoverOutputs.h"

#include "CoverFileWriting.h"
#include "FabricBaking.h"
#include "Output.h"
#include "Subcommands.h"
#include "ViewerParts.h"

#include <QFileInfo>

#include <algorithm>

namespace bolster::cli {

const std::vector<OptionRule> coverRules = {
    {"--glb", true},       {"--usdz", true},    {"--obj", true},  {"--html", true},
    {"--stl", true},       {"--3mf", true},     {"--foam", true}, {"--step", true},
    {"--thickness", true}, {"--density", true}, {"--no-frame"},
};

namespace {

constexpr const char* outputOptions[] = {"--glb", "--usdz", "--obj",  "--html",
                                         "--stl", "--3mf",  "--foam", "--step"};

bool endsWith(const QString& path, const char* ending)
{
    return path.endsWith(QLatin1String(ending), Qt::CaseInsensitive);
}

/// A name with another ending would not be read as what it is. Without any it may be a device or a pipe.
void requireEnding(const std::string& option, const QString& path)
{
    const std::string ending = "." + option.substr(2);
    if (!QFileInfo(path).suffix().isEmpty() && !endsWith(path, ending.c_str()) &&
        !(option == "--html" && endsWith(path, ".htm")) && !(option == "--step" && endsWith(path, ".stp")))
        throw UsageError(option + " must end in " + ending + ", and \"" + path.toStdString() + "\" does not");
}

CoverFormat formatOf(const std::string& option, const QString& path)
{
    static const std::map<std::string, CoverFormat> formats = {
        {"--glb", CoverFormat::Glb},   {"--usdz", CoverFormat::Usdz}, {"--obj", CoverFormat::Obj},
        {"--html", CoverFormat::Page}, {"--stl", CoverFormat::Stl},   {"--3mf", CoverFormat::ThreeMf},
        {"--step", CoverFormat::Step}};
    if (const auto found = formats.find(option); found != formats.end()) {
        requireEnding(option, path);
        return found->second;
    }
    if (endsWith(path, ".stl"))
        return CoverFormat::FoamStl;
    if (endsWith(path, ".3mf"))
        return CoverFormat::FoamThreeMf;
    if (endsWith(path, ".step"))
        return CoverFormat::FoamStep;
    throw UsageError(option + " must end in .stl, .3mf or .step, and \"" + path.toStdString() + "\" does not");
}

CoverFileOptions optionsOf(const Arguments& arguments)
{
    CoverFileOptions options;
    options.thickness = arguments.number("--thickness", options.thickness, 0.05, 100);
    options.foamDensity = arguments.number("--density", options.foamDensity, 1, 2000);
    options.frames = !arguments.has("--no-frame");
    options.title = QFileInfo(arguments.onlyFile("DESIGN")).completeBaseName().toStdString();
    options.stem = QFileInfo(arguments.path("--obj")).completeBaseName().toStdString();
    return options;
}

/// The files of the design, by their canonical paths.
std::vector<QString> inputsOf(const QString& designPath, const Design& design)
{
    std::vector<QString> inputs = {QFileInfo(designPath).canonicalFilePath()};
    const QString folder = QFileInfo(designPath).absolutePath();
    for (const auto& [id, element] : design.elements())
        if (const std::string* file = elementFile(*element))
            inputs.push_back(QFileInfo(folder + "/" + QString::fromStdString(*file)).canonicalFilePath());
    return inputs;
}

/// What was not said before, when the design was opened.
void printNewFindings(SolveResult result, const Problems& said)
{
    const auto known = [&](const Problem& problem) {
        return std::ranges::any_of(said, [&](const Problem& p) { return p.english() == problem.english(); });
    };
    if (std::erase_if(result.errors, known) > 0 && result.errors.empty())
        result.reason = {}; // which repeats them
    std::erase_if(result.warnings, known);
    printFindings(result);
}

} // namespace

CoverOutputs::CoverOutputs(const Arguments& arguments)
    : m_files(arguments, {"--glb", "--usdz", "--obj", "--html", "--stl", "--3mf", "--foam", "--step"})
    , m_options(optionsOf(arguments))
{
    for (const char* const option : outputOptions)
        if (arguments.has(option))
            m_wanted.push_back({option, formatOf(option, arguments.path(option))});
    // Nor may it be the file of an output of the pattern.
    const OutputFiles apart(arguments, {"--dxf", "--svg", "--pdf", "--hpgl", "--sheet", "--glb", "--usdz", "--obj",
                                        "--html", "--stl", "--3mf", "--foam", "--step"});
    if (arguments.has("--html"))
        m_options.page = viewerParts();
}

void CoverOutputs::protectInputs(const QString& designPath, const Design& design) const
{
    m_files.protectInputs(designPath, design);
}

int CoverOutputs::write(const QString& designPath, const OpenedDesign& opened, bool lenient, Interrupt& interrupt,
                        const std::function<bool()>& writeOthers) const
{
    SolveOptions options;
    options.lenient = lenient;
    const SolveResult solved = solveOpened(opened, options, interrupt.token());
    printNewFindings(solved, opened.problems);
    if (!solved.surface)
        return solved.status == SolveResult::Status::Failed && !solved.errors.empty() ? badInput : otherFailure;
    FabricBaking bake(designPath, opened.design, 0, interrupt.token());
    CoverFiles covers({solved.surface, opened.design, opened.files,
                       [&bake](ElementId id, const Fabric& fabric) { return bake(id, fabric); }},
                      m_options);
    const std::vector<QString> inputs = inputsOf(designPath, opened.design);
    std::vector<CoverFile> made;
    for (const Wanted& wanted : m_wanted)
        made.push_back(covers.make(wanted.format, interrupt.token()));
    interrupt.beginWriting();
    if (interrupt.token().stop_requested()) {
        printError("error: interrupted");
        return otherFailure;
    }
    bool written = writeOthers();
    for (std::size_t w = 0; w < m_wanted.size(); ++w) {
        const CoverFile& file = made[w];
        written &= m_files.write(m_wanted[w].option, [&](const QString& path) {
            return writeCoverFile(file, path, [&](const QString& name) {
                return std::ranges::count(inputs, QFileInfo(name).canonicalFilePath()) > 0;
            });
        });
        for (const Message& note : file.notes)
            printResult(note.english());
    }
    if (!written)
        return otherFailure;
    return solved.status == SolveResult::Status::NotConverged ? notConverged : done;
}

} // namespace bolster::cli
