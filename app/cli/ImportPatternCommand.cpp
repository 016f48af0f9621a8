#include "DesignJson.h"
#include "Interrupt.h"
#include "LengthUnits.h"
#include "Output.h"
#include "PatternDesign.h"
#include "PatternImport.h"
#include "ProgressLine.h"
#include "Subcommands.h"
#include "Unfinished.h"
#include "WholeFile.h"

#include <QFileInfo>

#include <array>
#include <cmath>
#include <map>

namespace bolster::cli {

const char* const importPatternHelp = R"(Usage: bolster import-pattern FILE DESIGN.json [options]

Makes a design of a pattern in a file: DXF (AAMA, ASTM, or as drawn) or SVG. Each
piece becomes a patch, with its seam allowance, notches, grain line, drill holes,
lines inside, quantity and fabric, as far as the file has them. Seams are not made.

Options:
  --unit mm|cm|in|m|px|pt
                        what the numbers in the file are (px: 1/96 inch, pt: 1/72);
                        without it, what the file and the size of the pieces say
  --size NAME           of a graded pattern; without it, the sample size
  --layers sew|cut      which line becomes the outline of a patch: the sewing line
                        (the usual one; where there is one), or the cut line
  --close MM            closes outlines whose ends are so far apart (0)

Exit code:
  0  done
  1  DESIGN.json is there already, or cannot be written, or interrupted
  2  FILE cannot be read, holds no piece, or wrong usage
)";

namespace {

constexpr std::array importPatternRules = {OptionRule{"--unit", true}, OptionRule{"--size", true},
                                           OptionRule{"--layers", true}, OptionRule{"--close", true}};

std::string figure(double value, int digits = 1)
{
    return QString::number(value, 'f', value < 100 ? digits : 0).toStdString();
}

constexpr std::array<LengthUnit, 6> drawingUnits{{{"mm", "mm", 1},
                                                  {"cm", "cm", 10},
                                                  {"in", "inches", 25.4},
                                                  {"m", "metres", 1000},
                                                  {"px", "pixels of 1/96 inch", 25.4 / 96},
                                                  {"pt", "points of 1/72 inch", 25.4 / 72}}};

PatternLines linesOf(const Arguments& arguments)
{
    const QString word = arguments.path("--layers");
    if (word.isEmpty() || word == QLatin1String("sew"))
        return PatternLines::Sew;
    if (word == QLatin1String("cut"))
        return PatternLines::Cut;
    throw UsageError("--layers is sew or cut, not \"" + word.toStdString() + "\"");
}

void printByLayer(const std::map<std::string, int>& counts, const char* level, const char* what)
{
    for (const auto& [layer, count] : counts)
        printError(std::string(level) + ": left out: " + counted(count, "shape") +
                   (layer.empty() ? " without a layer" : " on layer \"" + layer + "\"") + what);
}

/// What is said several times is said once, with the count.
void printNotes(const std::vector<Message>& notes)
{
    std::map<std::string, int> counts;
    for (const Message& note : notes)
        ++counts[note.english()];
    for (const Message& note : notes)
        if (const auto found = counts.find(note.english()); found != counts.end()) {
            printError("warning: " + found->first +
                       (found->second > 1 ? " (" + std::to_string(found->second) + " times)" : std::string()));
            counts.erase(found);
        }
}

/// Nothing is left out silently.
void printUnread(const Drawing& drawing, const FoundPattern& pattern)
{
    printNotes(drawing.notes);
    for (const auto& [what, count] : drawing.unknown)
        printError("warning: not read: " + std::to_string(count) + " x " + what);
    for (const Contour& line : pattern.open)
        printError("warning: an outline is open, its ends are " + figure(line.gap) + " mm apart (see --close)");
    if (pattern.doubled > 0)
        printError("warning: " + counted(pattern.doubled, "line") +
                   (pattern.doubled == 1 ? " lay twice on itself and is taken once"
                                         : " lay twice on themselves and are taken once"));
    printByLayer(pattern.outside, "warning", ", in no piece");
    printByLayer(pattern.ignored, "note", ", of grading, stripes or nothing that is known");
}

/// Of what became a patch: another piece may be drawn in another scale, or be a frame around the sheet.
void printMeasures(const Drawing& drawing, const FoundPattern& pattern, const ImportedPattern& made, double unit,
                   bool asked)
{
    Vec2 size = Vec2::Zero();
    for (const std::size_t place : made.taken)
        if (const Vec2 sizes = pattern.pieces[place].cut.box().sizes(); sizes.prod() > size.prod())
            size = sizes;
    std::string line("largest piece: ");
    line.append(figure(size.x())).append(" x ").append(figure(size.y())).append(" mm");
    if (!asked && !drawing.unit)
        line.append(" (the file does not say its unit; taken for ")
            .append(unitName(unit, drawingUnits).value_or(figure(unit, 4) + " mm each"))
            .append(", see --unit)");
    printResult(line);
}

} // namespace

int importPattern(std::span<const std::string> words)
{
    const Arguments arguments(words, importPatternRules);
    const std::vector<QString> files = arguments.files({"FILE", "DESIGN.json"});
    if (QFileInfo::exists(files[1])) {
        printError("error: \"" + files[1].toStdString() + "\" is there already; choose another name");
        return otherFailure;
    }
    const PatternChoice choice{linesOf(arguments), {}};
    Interrupt interrupt;
    const ImportedDrawing imported = importDrawing(files[0], {interrupt.token(), {}, {}});
    if (!imported.drawing) {
        printError("error: " + (imported.problem.empty() ? "interrupted" : imported.problem.english()));
        return imported.problem.empty() ? otherFailure : badInput;
    }
    const std::optional<double> said = saidUnit(arguments, drawingUnits);
    const double unit = said ? *said : guessedUnit(*imported.drawing);
    const PieceOrder order{unit, arguments.path("--size").toStdString(), arguments.number("--close", 0, 0, 1000)};
    const FoundPattern pattern = findPieces(*imported.drawing, order);
    if (!order.size.empty() && std::ranges::find(pattern.sizes, order.size) == pattern.sizes.end()) {
        std::string sizes;
        for (const std::string& size : pattern.sizes)
            sizes.append(sizes.empty() ? "" : ", ").append(size);
        throw UsageError("there is no size \"" + order.size + "\"; there are: " + (sizes.empty() ? "none" : sizes));
    }
    printUnread(*imported.drawing, pattern);
    const ImportedPattern made = patternEdit(Design(), pattern, choice);
    printNotes(made.notes);
    if (made.patches.empty()) {
        printError("error: there is no piece that can be taken in \"" + files[0].toStdString() + "\"");
        return badInput;
    }
    printMeasures(*imported.drawing, pattern, made, unit, arguments.has("--unit"));
    interrupt.beginWriting();
    if (const Message problem = replaceWholeFile(files[1], writeDesign(Design().with(made.edit)));
        !problem.empty()) {
        printError("error: " + problem.english());
        return otherFailure;
    }
    const std::size_t found = pattern.pieces.size();
    printResult("wrote " + files[1].toStdString() + ": " +
                counted(static_cast<std::int64_t>(made.patches.size()), "piece") +
                (found > made.patches.size() ? std::string(" of ").append(std::to_string(found)) : ""));
    return done;
}

} // namespace bolster::cli
