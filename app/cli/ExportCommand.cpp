#include "CoverOutputs.h"
#include "CutCheck.h"
#include "DxfWriter.h"
#include "FabricBaking.h"
#include "HpglWriter.h"
#include "Interrupt.h"
#include "Output.h"
#include "OutputFiles.h"
#include "PatternPdf.h"
#include "PictureStudio.h"
#include "SewingSheet.h"
#include "Solving.h"
#include "Subcommands.h"
#include "SvgWriter.h"
#include "WholeFile.h"

#include <QDateTime>
#include <QFileInfo>
#include <QGuiApplication>

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
  --foam FILE           the body between frame and cover, .stl or .3mf
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

Exit code:
  0  done
  1  an output cannot be written, or interrupted
  2  the design is bad (see "bolster check"), or wrong usage
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
};

DxfStandard standardOf(const Arguments& arguments)
{
    const std::string word = arguments.path("--standard").toLower().toStdString();
    if (arguments.has("--splines")) {
        if (word == "plain" || word.empty())
            return DxfStandard::Splines;
        throw UsageError("--splines is of the plain DXF: AAMA and ASTM know no curves");
    }
    if (word.empty() || word == "aama")
        return DxfStandard::Aama;
    if (word == "astm")
        return DxfStandard::Astm;
    if (word == "plain")
        return DxfStandard::Plain;
    throw UsageError("--standard is aama, astm or plain, not \"" + word + "\"");
}

PaperSize paperOf(const Arguments& arguments)
{
    if (!arguments.has("--paper"))
        return {};
    if (const auto paper = paperSize(arguments.path("--paper")))
        return *paper;
    throw UsageError("--paper is " + paperNames().join(", ").toStdString() +
                     " or roll:WIDTH (150 to 5000), not \"" + arguments.path("--paper").toStdString() + "\"");
}

CutLayers layersOf(const Arguments& arguments)
{
    if (!arguments.has("--lines"))
        return {};
    std::string unknown;
    if (const auto layers = cutLayers(arguments.path("--lines").toStdString(), unknown))
        return *layers;
    throw UsageError("--lines does not know \"" + unknown +
                     "\": it takes cut, sew, notches, grain, labels, internal, holes");
}

CutOptions cutOptionsOf(const Arguments& arguments)
{
    CutOptions options;
    if (arguments.has("--allowance"))
        options.allowance = arguments.number("--allowance", 10, 0, 200);
    if (arguments.has("--notch-spacing"))
        options.notchSpacing = arguments.number("--notch-spacing", 0, 0, 10000);
    options.chord = arguments.number("--chord", options.chord, 0.001, 10);
    options.unfold = arguments.has("--unfold");
    return options;
}

/// The patches of these names; throws UsageError for one that there is not.
std::optional<std::set<ElementId>> chosenPieces(const Arguments& arguments, const Design& design)
{
    const std::vector<std::string> names = arguments.values("--piece");
    if (names.empty())
        return std::nullopt;
    std::set<ElementId> chosen;
    for (const std::string& name : names) {
        bool found = false;
        design.each<Patch>([&](ElementId id, const Patch& patch) {
            if (patch.name == name)
                chosen.insert(id), found = true;
        });
        if (!found)
            throw UsageError("there is no piece \"" + name + "\"");
    }
    return chosen;
}

/// Letters need an application, but no display.
template <class Make>
std::string withLetters(const Make& make)
{
    int count = 3;
    char name[] = "bolster", option[] = "-platform", platform[] = "offscreen";
    char* words[] = {name, option, platform, nullptr};
    const QGuiApplication application(count, words);
    return make().toStdString();
}

/// From the front and from behind; none when there is no cover.
std::vector<QImage> coverPictures(const QString& path, const OpenedDesign& opened, const std::stop_token& stop)
{
    const SolveResult solved = solveOpened(opened, {}, stop);
    if (!solved.surface) {
        printError("note: the sewing sheet has no pictures: there is no cover yet");
        return {};
    }
    FabricBaking bake(path, opened.design, 0, stop);
    PictureStudio studio({solved.surface, opened.design, opened.files,
                          [&bake](ElementId id, const Fabric& fabric) { return bake(id, fabric); }, nullptr,
                          nullptr});
    std::vector<QImage> pictures;
    for (const char* const view : {"three-quarter", "front", "back"}) {
        PictureOrder order;
        order.look.colourway = opened.design.settings().colourway;
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

} // namespace

int exportPattern(std::span<const std::string> words)
{
    std::vector<OptionRule> rules(exportRules.begin(), exportRules.end());
    rules.insert(rules.end(), coverRules.begin(), coverRules.end());
    const Arguments arguments(words, rules);
    const QString path = arguments.onlyFile("DESIGN");
    const OutputFiles files(arguments, {"--dxf", "--svg", "--pdf", "--hpgl", "--sheet"});
    const CoverOutputs covers(arguments);
    if (files.empty() && covers.empty())
        throw UsageError(
            "nothing to write: give --dxf, --svg, --pdf, --hpgl or --sheet with a file, or an output of "
            "the cover: --glb, --usdz, --obj, --html, --stl, --3mf, --foam or --step");
    const DxfStandard standard = standardOf(arguments);
    const PdfOrder pdf{paperOf(arguments), arguments.has("--landscape"), layersOf(arguments)};
    CutOptions options = cutOptionsOf(arguments);

    Interrupt interrupt;
    const OpenedDesign opened = openedShown(path);
    printProblems(opened.problems);
    if (!opened.readable)
        return badInput;
    files.protectInputs(path, opened.design);
    covers.protectInputs(path, opened.design);
    if (files.empty())
        return covers.write(path, opened, interrupt);
    options.only = chosenPieces(arguments, opened.design);
    options.style = QFileInfo(path).completeBaseName().toStdString();
    const CutPattern pattern = cutPattern(opened.design, options);
    printLeftOut(pattern, opened.design);
    printFindings(pattern, opened.design);
    if (pattern.pieces.empty()) {
        printError("error: there is no piece to cut");
        return badInput;
    }
    const double sheets = arguments.has("--pdf") ? PatternPdf(pattern, pdf).sheets() : 0;
    if (sheets > PatternPdf::mostSheets) {
        printError("error: the PDF would have " + std::to_string(std::llround(sheets)) + " sheets, and " +
                   std::to_string(std::llround(PatternPdf::mostSheets)) +
                   " is the most: is the design's unit right? Larger --paper needs fewer");
        return badInput;
    }
    const QDateTime now = QDateTime::currentDateTime();
    const DxfOrder dxf{standard, pdf.layers, now.toString(QStringLiteral("dd-MM-yyyy")).toStdString(),
                       now.toString(QStringLiteral("HH:mm")).toStdString()};
    const std::vector<QImage> pictures =
        arguments.has("--sheet") ? coverPictures(path, opened, interrupt.token()) : std::vector<QImage>();
    interrupt.beginWriting();
    bool written = true;
    written &= files.write("--dxf", [&](const QString& f) { return replaceWholeFile(f, dxfText(pattern, dxf)); });
    written &=
        files.write("--svg", [&](const QString& f) { return replaceWholeFile(f, svgText(pattern, pdf.layers)); });
    written &= files.write("--hpgl", [&](const QString& f) {
        return replaceWholeFile(f, hpglText(pattern, pdf.layers, tableWidth(pdf.paper, pdf.landscape)));
    });
    written &= files.write("--pdf", [&](const QString& f) {
        return replaceWholeFile(f, withLetters([&] { return PatternPdf(pattern, pdf).bytes(); }));
    });
    written &= files.write("--sheet", [&](const QString& f) {
        const SewingPlan plan = sewingPlan(opened.design, options);
        return replaceWholeFile(f, withLetters([&] {
                                    return SewingSheet(opened.design, plan, pictures,
                                                       now.toString(QStringLiteral("yyyy-MM-dd")))
                                        .pdf(pdf.paper);
                                }));
    });
    if (written)
        printResult(counted(static_cast<std::int64_t>(pattern.pieces.size()), "piece"));
    const int ofCover = covers.empty() ? done : covers.write(path, opened, interrupt);
    return written ? ofCover : otherFailure;
}

} // namespace bolster::cli
