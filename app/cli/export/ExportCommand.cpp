#include "CoverOutputs.h"
#include "CutCheck.h"
#include "DesignCheck.h"
#include "DxfWriter.h"
#include "ExportOrder.h"
#include "FabricBaking.h"
#include "HpglWriter.h"
#include "Interrupt.h"
#include "Output.h"
#include "OutputFiles.h"
#include "PatternPdf.h"
#include "PictureStudio.h"
#include "ProgressLine.h"
#include "RestingSolve.h"
#include "SewingSheet.h"
#include "Solving.h"
#include "Subcommands.h"
#include "SvgWriter.h"
#include "WholeFile.h"

#include <QDateTime>
#include <QFileInfo>
#include <QGuiApplication>
#include <QLoggingCategory>

#include <algorithm>
#include <array>
#include <cmath>

namespace bolster::cli {

const char* const exportHelp = R"(Usage: bolster export DESIGN [options]

Writes the pattern of a design (JSON or a project) as it is cut: with seam
allowances, notches, grain lines, labels, drill holes and lines inside; and the
cover, as others look at it or make it.

Outputs of the pattern:
  --dxf FILE            DXF for cutters and pattern programs
  --svg FILE            SVG, 1:1 in millimetres
  --pdf FILE            pages to print at 100 %, to be put together
  --hpgl FILE           HPGL for plotters
  --sheet FILE.pdf      the sewing sheet: the cover, pieces, seams in order,
                        materials

Outputs of the cover, which is solved for them:
  --glb FILE            glTF: fabrics, stitches, piping, all colourways
  --usdz FILE           the same for the room view of phones
  --obj FILE            OBJ with materials and pictures beside it
  --html FILE           a page that turns, zooms, switches colourways, measures
  --stl FILE            the cover as thick as its material, closed
  --3mf FILE            the same as 3MF
  --foam FILE           the body between frame and cover, .stl, .3mf or .step
  --step FILE           fixation curves and seams as curves

Options of the cover:
  --thickness MM        of the material (1.2)
  --density KG          of the foam, for its weight, per cubic metre (35)
  --no-frame            the cover alone, without its frames and foam

Options of the pattern:
  --standard WORD       of the DXF: aama (the usual one), astm, or plain (R12)
  --splines             the plain DXF as R2000: sewing lines and lines inside as
                        curves; cut lines stay within --chord of theirs
  --paper WORD          A4 (the usual one), A3, A2, A1, A0, letter, tabloid, or
                        roll:WIDTH in mm; of the PDF, and the width of the HPGL
  --landscape           pages of the PDF lie on their long side
  --lines WORDS         some of cut,sew,notches,grain,labels,internal,holes
  --allowance MM        the seam allowance where the design says none (10)
  --notch-spacing MM    notches along seams so far apart, in place of the design's
  --chord MM            how far a line may be from its curve (0.05)
  --unfold              mirrored pairs as two pieces
  --piece NAME          this piece alone; several times for several pieces
  --lenient             leave bad elements out instead of refusing the design

Exit code:
  0  done
  1  an output cannot be written, or interrupted; then nothing is written
     (of a disk that becomes full meanwhile, what was finished before)
  2  the design is bad (see "bolster check"), or wrong usage; nothing is written
  3  the cover has not converged; its outputs are written nevertheless
)";

namespace {

constexpr std::array exportRules = {
    OptionRule{"--dxf", true},
    OptionRule{"--svg", true},
    OptionRule{"--pdf", true},
    OptionRule{"--hpgl", true},
    OptionRule{"--standard", true},
    OptionRule{"--paper", true},
    OptionRule{"--landscape"},
    OptionRule{"--lines", true},
    OptionRule{"--allowance", true},
    OptionRule{"--unfold"},
    OptionRule{"--notch-spacing", true},
    OptionRule{"--chord", true},
    OptionRule{"--piece", true, true},
    OptionRule{"--sheet", true},
    OptionRule{"--splines"},
    OptionRule{"--lenient"},
};

/// The design, or of a lenient export what is usable of it; nothing when it has errors. Files of frames and scans
/// have nothing to do with what is cut, and what stops a cover alone is told only: its pieces can be cut.
std::optional<Design> exportedDesign(const OpenedDesign& opened, bool lenient)
{
    Problems problems = opened.problems;
    for (Problem& problem : problems)
        if (opened.readable && problem.field == "file")
            problem.severity = Severity::Warning;
    const auto known = static_cast<std::ptrdiff_t>(problems.size());
    if (opened.readable)
        addNew(problems, checkSolvable(opened.design));
    // What is no error says something of the cover alone.
    problems.erase(std::remove_if(problems.begin() + known, problems.end(),
                                  [](const Problem& problem) { return problem.severity != Severity::Error; }),
                   problems.end());
    std::for_each(problems.begin() + known, problems.end(),
                  [](Problem& problem) { problem.severity = Severity::Warning; });
    addMissingPatch(problems, opened.design);
    const auto firstWarning = std::stable_partition(problems.begin(), problems.end(), [](const Problem& problem) {
        return problem.severity == Severity::Error;
    });
    const Problems errors(problems.begin(), firstWarning), warnings(firstWarning, problems.end());
    if (errors.empty() || !opened.readable || !lenient) {
        printProblems(errors);
        printProblems(warnings);
        return errors.empty() && opened.readable ? std::optional(opened.design) : std::nullopt;
    }
    Problems missing;
    Design usable = usablePart(opened.design, errors, &missing);
    for (const Problem& problem : allLeftOut(errors, missing))
        printError("left out: " + problem.english());
    printProblems(warnings);
    return usable;
}

/// Letters need an application, but no display.
template <class Make>
QByteArray withLetters(const Make& make)
{
    int count = 3;
    char name[] = "bolster", option[] = "-platform", platform[] = "offscreen";
    char* words[] = {name, option, platform, nullptr};
    QLoggingCategory::setFilterRules(QStringLiteral("default.warning=false")); // it would miss a desktop
    const QGuiApplication application(count, words);
    return make();
}

/// From the front and from behind; none when there is no cover.
std::vector<QImage> coverPictures(const QString& path, const OpenedDesign& opened, const Design& design,
                                  bool lenient, const std::stop_token& stop)
{
    SolveOptions options;
    options.lenient = lenient;
    const SolveResult solved = solveOpened(opened, options, stop);
    if (!solved.surface) {
        printError("note: the sewing sheet has no pictures: there is no cover yet");
        return {};
    }
    FabricBaking bake(path, design, 0, stop);
    PictureStudio studio({solved.surface, design, opened.files,
                          [&bake](ElementId id, const Fabric& fabric) { return bake(id, fabric); }, nullptr,
                          nullptr});
    std::vector<QImage> pictures;
    for (const char* const view : {"three-quarter", "front", "back"}) {
        PictureOrder order;
        order.look.colourway = design.settings().colourway;
        order.from = *pictureDirection(view);
        order.options.width = 640;
        order.options.height = 560;
        const PreviewImage image = studio.draw(order, stop).image;
        if (!image.empty())
            pictures.push_back(
                QImage(image.rgba.data(), image.width, image.height, QImage::Format_RGBA8888).copy());
    }
    return pictures;
}

/// What to mend before anybody cuts.
void printFindings(const CutPattern& pattern, const Design& design)
{
    Problems problems;
    for (const CutFinding& finding : checkCutting(design, pattern))
        problems.push_back(finding.problem);
    printProblems(problems);
}

void printLeftOut(const CutPattern& pattern, const Design& design)
{
    for (const ElementId id : pattern.leftOut)
        printError("warning: " + elementLabel(id, *design.element(id)) +
                   " is left out: its outline crosses itself or encloses nothing");
}

/// All that is written, before anything is: who interrupts it leaves nothing behind.
class ExportedBytes {
public:
    ExportedBytes(const OutputFiles& files, const CutPattern& pattern, const ExportOrder& order,
                  Interrupt& interrupt)
        : m_files(files)
        , m_pattern(pattern)
        , m_order(order)
        , m_interrupt(interrupt)
    {}

    void makeDrawings()
    {
        const QDateTime now = QDateTime::currentDateTime();
        const CutLayers& layers = m_order.pdf.layers;
        make("--dxf", [&] {
            return dxfText(m_pattern,
                           {m_order.standard, layers, now.toString(QStringLiteral("dd-MM-yyyy")).toStdString(),
                            now.toString(QStringLiteral("HH:mm")).toStdString()});
        });
        make("--svg", [&] { return svgText(m_pattern, layers); });
        make("--hpgl",
             [&] { return hpglText(m_pattern, layers, tableWidth(m_order.pdf.paper, m_order.pdf.landscape)); });
    }

    /// False when there are too many sheets.
    bool makePdf()
    {
        if (!m_files.has("--pdf"))
            return true;
        const PatternPdf pdf(m_pattern, m_order.pdf, m_interrupt.token());
        if (pdf.plan().tooMany()) {
            printError("error: the PDF would have " + std::to_string(std::llround(pdf.plan().wanted)) +
                       " sheets, and " + std::to_string(std::llround(SheetPlan::mostSheets)) +
                       " is the most: is the design's unit right? Larger --paper needs fewer");
            return false;
        }
        makeSheets("--pdf", "PDF", [&](const SheetWatch& watch) { return pdf.bytes(watch); });
        return true;
    }

    void makeSewingSheet(const Design& design, const CutOptions& options, const std::vector<QImage>& pictures)
    {
        const QString today = QDate::currentDate().toString(Qt::ISODate);
        makeSheets("--sheet", "sewing sheet", [&](const SheetWatch& watch) {
            const SewingPlan plan = sewingPlan(design, options, watch.stop);
            return SewingSheet(design, plan, pictures, today).pdf(m_order.pdf.paper, watch);
        });
    }

    bool write() const
    {
        bool written = true;
        for (const auto& [option, bytes] : m_made)
            written &= m_files.write(
                option, [&content = bytes](const QString& file) { return replaceWholeFile(file, content); });
        return written;
    }

private:
    template <class Make>
    void make(const char* option, const Make& text)
    {
        if (m_files.has(option) && !m_interrupt.token().stop_requested())
            m_made.emplace_back(option, text());
    }

    template <class Make>
    void makeSheets(const char* option, const std::string& what, const Make& bytes)
    {
        make(option, [&] {
            ProgressLine line("drawing the " + what);
            const SheetWatch watch{m_interrupt.token(), [&](double share) {
                                       line.say("drawing the " + what + ", " +
                                                std::to_string(std::lround(100 * share)) + " %");
                                   }};
            return withLetters([&] { return bytes(watch); }).toStdString();
        });
    }

    const OutputFiles& m_files;
    const CutPattern& m_pattern;
    const ExportOrder& m_order;
    Interrupt& m_interrupt;
    std::vector<std::pair<const char*, std::string>> m_made;
};

int interrupted()
{
    printError("error: interrupted");
    return otherFailure;
}

} // namespace

int exportPattern(std::span<const std::string> words)
{
    std::vector<OptionRule> rules(exportRules.begin(), exportRules.end());
    rules.insert(rules.end(), coverRules.begin(), coverRules.end());
    const Arguments arguments(words, rules);
    const QString path = arguments.onlyFile("DESIGN");
    const OutputFiles files(arguments, {"--dxf", "--svg", "--hpgl", "--pdf", "--sheet"});
    const CoverOutputs covers(arguments);
    if (files.empty() && covers.empty())
        throw UsageError(
            "nothing to write: give --dxf, --svg, --pdf, --hpgl or --sheet with a file, or an output of "
            "the cover: --glb, --usdz, --obj, --html, --stl, --3mf, --foam or --step");
    const ExportOrder order = exportOrder(arguments);

    Interrupt interrupt;
    const OpenedDesign opened = openedShown(path);
    files.protectInputs(path, opened.design);
    covers.protectInputs(path, opened.design);
    const bool writable = files.canBeWritten();
    if (!covers.canBeWritten() || !writable)
        return otherFailure;
    if (files.empty())
        return covers.write(path, opened, order.lenient, interrupt, [] { return true; });
    const std::optional<Design> design = exportedDesign(opened, order.lenient);
    if (!design)
        return badInput;
    CutOptions options = order.cutting;
    options.only = chosenPieces(arguments, *design);
    options.style = QFileInfo(path).completeBaseName().toStdString();
    const CutPattern pattern = cutPattern(*design, options, interrupt.token());
    if (interrupt.token().stop_requested())
        return interrupted();
    printLeftOut(pattern, *design);
    printFindings(pattern, *design);
    if (pattern.pieces.empty()) {
        printError("error: there is no piece to cut");
        return badInput;
    }
    ExportedBytes bytes(files, pattern, order, interrupt);
    bytes.makeDrawings();
    if (!bytes.makePdf())
        return badInput;
    if (files.has("--sheet"))
        bytes.makeSewingSheet(*design, options,
                              coverPictures(path, opened, *design, order.lenient, interrupt.token()));
    const auto write = [&] {
        const bool written = bytes.write();
        if (written)
            printResult(counted(static_cast<std::int64_t>(pattern.pieces.size()), "piece"));
        return written;
    };
    if (!covers.empty())
        return covers.write(path, opened, order.lenient, interrupt, write);
    interrupt.beginWriting();
    if (interrupt.token().stop_requested())
        return interrupted();
    return write() ? done : otherFailure;
}

} // namespace bolster::cli
