#include "AssemblyImport.h"
#include "DesignJson.h"
#include "DistinctFiles.h"
#include "Division.h"
#include "FileFormats.h"
#include "FitTargetFiles.h"
#include "FormPattern.h"
#include "Interrupt.h"
#include "MeshImport.h"
#include "Output.h"
#include "OutputFiles.h"
#include "ProgressLine.h"
#include "RestingSolve.h"
#include "Solving.h"
#include "Subcommands.h"

#include <QDir>
#include <QFileInfo>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <set>
#include <sstream>

namespace bolster::cli {

const char* const flattenHelp = R"(Usage: bolster flatten SURFACE --out DESIGN.json [options]

Makes the pattern of a form: cuts a mesh (OBJ, PLY, STL, OFF) or the faces of a CAD file
(STEP, IGES) into pieces, lays each one flat with the least strain of the fabric, and
writes a design of them. What two pieces have in common becomes a seam, what lies at the
form's border is fixed.

Options:
  --out FILE.json       the design; never replaced when it is there already
  --by groups           cuts where groups of the mesh meet (the usual way)
  --by angle:DEG        cuts where the mesh bends by more than DEG degrees
  --by faces            cuts at the edges of the faces of a CAD file, also where these go
                        on smoothly in each other; a mesh, which knows none, where it
                        bends by more than the triangles of one face do (21 degrees)
  --along DESIGN        and along the fixation curves of this design
  --divide              and wherever it would not lie flat, or a hundredth of a piece be
                        strained by more than 8 %
  --fabric KEY=X,...    of poisson (0.3), stiffness (1), bending (6, mm)
  --grain DIRECTION     of the grain line: up (the usual way), back or side on the form,
                        or an angle in the pattern, degrees
  --edge MM             edges of the design's triangles (12)
  --frame               puts the form under its cover, as a frame that keeps the cover
                        outside; the design lies in the folder of SURFACE, or above it
  --unit mm|cm|m|in|ft  what the numbers in the file are (what it says, or mm)
  --up y|z              what points up in the file (what it says, or z)
  --report FILE.json    strain and area of each piece, lengths of seams

Exit code:
  0  done
  1  FILE.json is there already, an output cannot be written (the other one is
     nevertheless), or interrupted
  2  SURFACE cannot be read or laid flat, or wrong usage
  3  more than a ten-thousandth of it is left out; the design of the rest is
     written nevertheless
)";

namespace {

constexpr double bendOfFaces =
    21; // degrees: CAD files are read with triangles that bend by 20 at most within a face

constexpr double smallestForm = 50;                     // mm
constexpr double countsForNothing = 1e-4;               // of a form's area: splinters that nobody could sew
constexpr double leastInMetres = 0.2, mostInMetres = 5; // what a form in metres may measure

constexpr std::array flattenRules = {
    OptionRule{"--out", true},     OptionRule{"--by", true},    OptionRule{"--fabric", true},
    OptionRule{"--edge", true},    OptionRule{"--unit", true},  OptionRule{"--up", true},
    OptionRule{"--report", true},  OptionRule{"--along", true}, OptionRule{"--grain", true},
    OptionRule{"--divide", false}, OptionRule{"--frame", false}};

double numberIn(const std::string& text, const std::string& what, double least, double most)
{
    bool ok = false;
    const double value = QString::fromStdString(text).toDouble(&ok);
    if (!ok || !(value >= least && value <= most))
        throw UsageError(what + " is a number from " + numberText(least) + " to " + numberText(most) + ", not \"" +
                         text + "\"");
    return value;
}

/// What --by says. The edges of a CAD file's faces come with its triangles.
FormCuts cutsOf(const QString& surface, const std::string& word)
{
    if (word.empty() || word == "groups")
        return {};
    if (word == "faces")
        return {false, isCadEnding(endingOf(surface)) ? std::nullopt : std::optional(bendOfFaces)};
    if (word.starts_with("angle:"))
        return {false, numberIn(word.substr(6), "the angle of --by", 1, 179)};
    throw UsageError("--by is groups, faces or angle:DEG, not \"" + word + "\"");
}

Fabric fabricOf(const Arguments& arguments)
{
    Fabric fabric;
    fabric.name = "Fabric";
    std::istringstream words(arguments.path("--fabric").toStdString());
    std::set<std::string> known;
    for (std::string word; std::getline(words, word, ',');) {
        const std::size_t equals = word.find('=');
        const std::string key = word.substr(0, equals),
                          value = equals == std::string::npos ? "" : word.substr(equals + 1);
        if (!known.insert(key).second)
            throw UsageError("--fabric: " + key + " stands there twice");
        if (key == "poisson")
            fabric.poisson = numberIn(value, key, -0.5, 0.5);
        else if (key == "stiffness")
            fabric.stiffness = numberIn(value, key, 1e-3, 1e3);
        else if (key == "bending")
            fabric.bendingLength = numberIn(value, key, 0, 1000);
        else
            throw UsageError("--fabric knows poisson, stiffness and bending, not \"" + key + "\"");
    }
    return fabric;
}

FormGrain grainOf(const Arguments& arguments)
{
    const std::string word = arguments.path("--grain").toStdString();
    if (word.empty() || word == "up")
        return FormGrain::up();
    if (word == "back")
        return FormGrain::back();
    if (word == "side")
        return FormGrain::side();
    bool ok = false;
    const double angle = QString::fromStdString(word).toDouble(&ok);
    if (!ok || !(std::abs(angle) <= 360))
        throw UsageError("--grain is up, back, side or an angle from -360 to 360, not \"" + word + "\"");
    return {Vec3::Zero(), angle};
}

std::vector<FormLine> linesAlong(const Arguments& arguments)
{
    const QString design = arguments.path("--along");
    const OpenedDesign lines = openedShown(design);
    OutputFiles(arguments, {"--report"}).protectInputs(design, lines.design);
    if (!lines.readable)
        throw UsageError("--along: " + (lines.problems.empty() ? design.toStdString() + " cannot be read"
                                                               : lines.problems.front().english()));
    for (const Problem& problem : lines.problems)
        if (problem.severity == Severity::Error && problem.element != settingsId)
            printError("warning: --along: " + problem.english());
    return linesOf(lines.design);
}

void printWarnings(const std::vector<Message>& notes)
{
    for (const Message& note : notes)
        printError("warning: " + note.english());
}

/// Of a form that is too small; `number`: how large it is in the numbers of its file.
std::string otherUnitText(double number)
{
    if (number < leastInMetres)
        return "--unit says what the numbers in the file are";
    const std::string unit = number <= mostInMetres ? "m" : "cm";
    return "with --unit " + unit + " it would be " + numberText(number, 2) + " " + unit;
}

/// Where a design that is written to `out` finds the form.
std::string fileOfFrame(const QString& surface, const QString& out)
{
    const QDir folder(QFileInfo(out).absoluteDir().canonicalPath()); // links lead elsewhere
    const std::string file = folder.relativeFilePath(QFileInfo(surface).canonicalFilePath()).toStdString();
    if (file.starts_with("..") || QDir::isAbsolutePath(QString::fromStdString(file)))
        throw UsageError("--frame: a design finds its files in its own folder or below: write it to where " +
                         surface.toStdString() + " is");
    if (const std::optional<Message> problem = elementFileProblem(file))
        throw UsageError("--frame: " + surface.toStdString() + ": " + problem->english());
    return file;
}

/// That keeps the cover outside.
Design withFrame(const Design& design, const std::string& file, const Placement& placement)
{
    Frame frame;
    static_cast<Placement&>(frame) = placement;
    frame.name = QFileInfo(QString::fromStdString(file)).completeBaseName().toStdString();
    frame.file = file;
    frame.contact = true;
    return design.with({{}, {{design.nextId(), nullptr, makeElement(std::move(frame))}}});
}

struct ReadForm {
    Form form;
    Placement placement;
    int failure = done;   ///< else the exit code; why was said
    bool isSmall = false; ///< its unit may be another one, which was said, too
};

ReadForm formOf(const QString& surface, FormCuts cuts, const FormPatternOrder& order, const Arguments& arguments,
                const std::stop_token& stop)
{
    ReadForm read;
    ImportedMesh imported;
    {
        ProgressLine line("reading the form");
        imported = importMesh(surface, {stop, {}, {}}, arguments.path("--by") == "faces");
    }
    if (!imported.mesh) {
        printError("error: " + (imported.problem.empty() ? "interrupted" : imported.problem.english()));
        return {{}, {}, imported.problem.empty() ? otherFailure : badInput};
    }
    if (!imported.warning.empty())
        printWarnings({imported.warning});
    const Placement placement = read.placement = placementOf(arguments, surface, imported.said);
    const auto place = [&](std::vector<Vec3>& points) {
        for (Vec3& point : points)
            point = placement.placed(point);
    };
    for (const FrameEdge& edge : imported.edges)
        place(cuts.edges.emplace_back(edge.points));
    TriangleMesh mesh = *imported.mesh;
    place(mesh.points);
    const Vec3 size = mesh.boundingBox().sizes();
    printResult("the form is " + numberText(size.x(), 3) + " x " + numberText(size.y(), 3) + " x " +
                numberText(size.z(), 3) + " mm large");
    read.isSmall = size.maxCoeff() < smallestForm;
    if (read.isSmall)
        printError("warning: --unit first: that is small for a cover; " +
                   otherUnitText(size.maxCoeff() / placement.scale));
    {
        ProgressLine line("cutting the form");
        cuts.divides = arguments.has("--divide");
        read.form = cutForm(mesh, cuts, stop);
    }
    if (arguments.has("--divide")) {
        ProgressLine line("dividing the form");
        read.form = divided(read.form, order, stop, [&](int pieces) {
            line.say("dividing the form (" + counted(pieces, "piece") + " so far)");
        });
    }
    if (!cuts.divides)
        read.form = withoutClosedSlits(read.form, order, stop);
    if (stop.stop_requested()) {
        printError("error: interrupted");
        return {{}, {}, otherFailure};
    }
    printWarnings(read.form.notes);
    printWarnings(read.form.undivided);
    if (!read.form.problem.empty()) {
        printError("error: " + surface.toStdString() + ": " + read.form.problem.english());
        read.failure = badInput;
    }
    return read;
}

nlohmann::ordered_json reportOf(const Form& form, const std::vector<FlatPiece>& flat, const FormPattern& made)
{
    nlohmann::ordered_json pieces = nlohmann::ordered_json::array(), seams = nlohmann::ordered_json::array();
    for (std::size_t p = 0; p < flat.size(); ++p)
        pieces.push_back(
            {{"name", form.pieces[p].name},
             {"patch", number(made.patches[p])},
             {"area_mm2", flat[p].area},
             {"strain", {{"rms", flat[p].strainRms}, {"p99", flat[p].strainP99}, {"max", flat[p].strainMost}}},
             {"most_strained_at", {flat[p].strainedAt.x(), flat[p].strainedAt.y(), flat[p].strainedAt.z()}},
             {"turned_over", flat[p].turnedOver}});
    for (const FormSeam& seam : made.seams)
        seams.push_back({{"element", number(seam.seam)}, {"first_mm", seam.first}, {"second_mm", seam.second}});
    return {{"pieces", std::move(pieces)}, {"seams", std::move(seams)}};
}

/// mm^2
double formArea(const Form& form, const FormPiece& piece)
{
    double area = 0;
    for (const auto& [a, b, c] : piece.triangles) {
        const auto at = [&](int vertex) { return form.points[piece.points[vertex]]; };
        area += (at(b) - at(a)).cross(at(c) - at(a)).norm() / 2;
    }
    return area;
}

/// Of the form's area, 1.
double shareLeftOut(const Form& form, const FormPattern& made)
{
    double all = 0, leftOut = 0;
    for (std::size_t p = 0; p < form.pieces.size(); ++p) {
        const double area = formArea(form, form.pieces[p]);
        all += area;
        leftOut += made.patches[p] == noElement ? area : 0;
    }
    return leftOut / std::max(all, 1e-300);
}

/// Of a form of which nothing can be laid flat.
void printNoPattern(bool divided, bool isSmall)
{
    printError("error: none of it can be laid flat, so there is no pattern");
    if (divided && isSmall)
        return; // shorter edges would not help: its unit is another one
    printError(divided ? "(pieces less than five edges across are not divided: a shorter --edge lets them be)"
                       : "(--divide finds where to divide it, --by angle:DEG cuts where it bends by more than DEG "
                         "degrees, --along DESIGN along its fixation curves)");
}

void printPieces(const Form& form, const std::vector<FlatPiece>& flat, const FormPattern& made, bool divided,
                 double limit)
{
    for (std::size_t p = 0; p < flat.size(); ++p) {
        std::string line = form.pieces[p].name;
        if (made.patches[p] == noElement) {
            printResult(line + ": left out");
            continue;
        }
        line.append(": ").append(numberText(flat[p].area / 1e6, 3)).append(" m2, strain ");
        line.append(percentText(flat[p].strainRms, 2)).append(" rms, ");
        line.append(percentText(flat[p].strainP99, 2)).append(" within 99 % of it, ");
        line.append(percentText(flat[p].strainMost, 2)).append(" at most");
        printResult(line);
    }
    std::int64_t over = 0;
    for (std::size_t p = 0; p < flat.size(); ++p)
        over += made.patches[p] != noElement && flat[p].strainP99 > limit;
    if (const double leftOut = shareLeftOut(form, made); leftOut > 0)
        printError("warning: " + numberText(100 * leftOut, 3) + " % of the form's area are left out" +
                   (leftOut < countsForNothing ? ""
                    : divided                  ? "; a shorter --edge lets smaller pieces be divided"
                                               : "; --divide finds where to divide it"));
    if (over > 0)
        printError("warning: " + counted(over, "piece") + " strained by more than " + percentText(limit, 2) +
                   " in more than a hundredth of the area");
    double widest = 0;
    for (const FormSeam& seam : made.seams)
        widest = std::max(widest, std::abs(seam.first - seam.second));
    printResult(counted(static_cast<std::int64_t>(made.seams.size()), "seam") +
                (made.seams.empty() ? std::string()
                 : widest < FormPattern::equallyLong
                     ? std::string(", whose sides are equally long")
                     : ", whose sides differ by " + numberText(widest, 2) + " mm at most"));
}

} // namespace

int flattenForm(std::span<const std::string> words)
{
    const Arguments arguments(words, flattenRules);
    const QString surface = arguments.onlyFile("SURFACE");
    const QString out = arguments.path("--out"), report = arguments.path("--report");
    if (out.isEmpty())
        throw UsageError("where to? --out DESIGN.json");
    FormCuts cuts = cutsOf(surface, arguments.path("--by").toStdString());
    FormPatternOrder order;
    order.fabric = fabricOf(arguments);
    order.grain = grainOf(arguments);
    order.edgeLength = arguments.number("--edge", order.edgeLength, 0.5, 1000);
    expectDistinct({surface, arguments.path("--along")}, {out, report});
    if (!canBeWritten({out, report}))
        return otherFailure;
    if (isThere(out)) {
        printError("error: \"" + out.toStdString() + "\" is there already; choose another name");
        return otherFailure;
    }
    const std::string frameFile = arguments.has("--frame") ? fileOfFrame(surface, out) : "";
    Interrupt interrupt;
    if (arguments.has("--along"))
        cuts.lines = linesAlong(arguments);
    const auto [form, placement, failure, isSmall] =
        formOf(surface, std::move(cuts), order, arguments, interrupt.token());
    if (failure != done)
        return failure;
    std::vector<FlatPiece> flat;
    {
        ProgressLine line("laying it flat");
        flat = flatten(form, {order.fabric.poisson}, interrupt.token());
    }
    FormPattern made;
    if (!interrupt.token().stop_requested())
        made = formPattern(form, flat, order, interrupt.token());
    Message narrow;
    if (!interrupt.token().stop_requested() && !made.isEmpty())
        narrow = tooNarrowForEdges(made.design, interrupt.token());
    if (interrupt.token().stop_requested()) {
        printError("error: interrupted");
        return otherFailure;
    }
    printWarnings(made.notes);
    printWarnings(made.advice);
    if (!narrow.empty())
        printWarnings({narrow});
    if (made.isEmpty()) {
        printNoPattern(arguments.has("--divide"), isSmall);
        return badInput;
    }
    if (made.hasClosed && frameFile.empty())
        printError(
            "warning: where nothing else holds it the cover may turn inside out; --frame puts the form under "
            "it, which keeps it outside");
    if (!frameFile.empty())
        made.design = withFrame(made.design, frameFile, placement);
    printPieces(form, flat, made, arguments.has("--divide"), bearableStrain(order.fabric));
    interrupt.beginWriting();
    if (!writeWithReport(out, writeDesign(made.design), report, reportOf(form, flat, made).dump(1) + "\n"))
        return otherFailure;
    return shareLeftOut(form, made) > countsForNothing ? partLeftOut : done;
}

} // namespace bolster::cli
