#include "FileFormats.h"
#include "FileGuess.h"
#include "FrameImport.h"
#include "Interrupt.h"
#include "LengthUnits.h"
#include "MeshExport.h"
#include "Output.h"
#include "ProgressLine.h"
#include "SimplifyMesh.h"
#include "Subcommands.h"

#include <QFileInfo>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace bolster::cli {

const char* const convertHelp = R"(Usage: bolster convert FILE OUT.obj|ply|stl [options]
       bolster convert FILE --list [options]

Makes a plain mesh of a frame: millimetres, z up. FILE is STEP, IGES, glTF, GLB,
FBX, COLLADA, 3MF, OBJ, PLY, STL or OFF, as its ending says.

Options:
  --list                the parts as a tree, with their triangles and colours, the
                        unit, the axis that points up, and the size; with OUT, too,
                        both
  --unit mm|cm|m|in|ft  what the numbers in the file are; without it what the file
                        says, else millimetres
  --up y|z              which axis of the file points up; without it what the file
                        says, else z
  --tolerance MM        how far triangles may be from the faces of STEP and IGES
                        (0.2)
  --parts NAME,...      these parts alone, with all that belongs to them
  --triangles N         simplified to about so many triangles

Exit code:
  0  done
  1  OUT cannot be written, or interrupted
  2  FILE cannot be read, a part is not there, or wrong usage
)";

namespace {

constexpr std::array convertRules = {OptionRule{"--list", false},       OptionRule{"--unit", true},
                                     OptionRule{"--up", true},          OptionRule{"--tolerance", true},
                                     OptionRule{"--parts", true, true}, OptionRule{"--triangles", true}};

/// How the numbers of the file become millimetres, and who says so.
struct FrameReading {
    double unit = 1; ///< mm
    bool unitIsSaid = false;
    UpAxis up = UpAxis::Z;
    bool upIsSaid = false;
};

/// What the options say; they are looked at before the file.
FileFacts askedFor(const Arguments& arguments)
{
    FileFacts asked;
    asked.millimetresPerUnit = saidUnit(arguments);
    if (const std::optional<bool> y = saysUpIsY(arguments))
        asked.up = *y ? UpAxis::Y : UpAxis::Z;
    return asked;
}

FrameReading readingOf(const FileFacts& asked, const FileFacts& said)
{
    FrameReading reading;
    const auto unit = asked.millimetresPerUnit ? asked.millimetresPerUnit : said.millimetresPerUnit;
    const auto up = asked.up ? asked.up : said.up;
    reading.unitIsSaid = unit.has_value();
    reading.unit = unit.value_or(1);
    reading.upIsSaid = up.has_value();
    reading.up = up.value_or(UpAxis::Z);
    return reading;
}

/// A name may have a comma in it: then it is given alone.
std::set<std::string> namesAskedFor(const Arguments& arguments, const Assembly& assembly)
{
    std::set<std::string> known, wanted;
    for (const Assembly::Part& part : assembly.parts)
        known.insert(part.name);
    for (const std::string& value : arguments.values("--parts")) {
        if (known.contains(value)) {
            wanted.insert(value);
            continue;
        }
        for (const QString& name : exactText(value).split(u','))
            wanted.insert(name.trimmed().toStdString());
    }
    return wanted;
}

std::vector<bool> wantedParts(const Arguments& arguments, const Assembly& assembly)
{
    if (!arguments.has("--parts"))
        return std::vector<bool>(assembly.parts.size(), true);
    std::set<std::string> names = namesAskedFor(arguments, assembly);
    const std::vector<bool> wanted = partsNamed(assembly, names);
    if (!names.empty())
        throw UsageError("there is no part \"" + *names.begin() + "\"; --list says which there are");
    return wanted;
}

TriangleMesh convertedMesh(const Assembly& assembly, const std::vector<bool>& wanted, const FrameReading& reading)
{
    TriangleMesh mesh = meshOf(assembly, [&](std::uint32_t part) { return wanted[part]; });
    const Eigen::Matrix3d turn =
        rotationFor(reading.up).toRotationMatrix().array().round().matrix(); // by a right angle: exact
    for (Vec3& point : mesh.points)
        point = reading.unit * (turn * point);
    return mesh;
}

std::string lengthFigure(double value)
{
    return QString::number(value, 'f', value < 100 ? 1 : 0).toStdString();
}

std::string unitLine(const FrameReading& reading)
{
    const std::string unit =
        unitName(reading.unit).value_or(QString::number(reading.unit, 'g', 10).toStdString() + " mm");
    return "unit: " + unit + (reading.unitIsSaid ? "" : " (the file does not say it; see --unit)");
}

std::string upLine(const FrameReading& reading)
{
    constexpr const char* axes[] = {"z", "y", "x"};
    return std::string("up: ") + axes[static_cast<std::size_t>(reading.up)] +
           (reading.upIsSaid ? "" : " (the file does not say it; see --up)");
}

std::string sizeLine(const TriangleMesh& mesh)
{
    const Vec3 size = mesh.boundingBox().isEmpty() ? Vec3::Zero().eval() : mesh.boundingBox().sizes().eval();
    return "size: " + lengthFigure(size.x()) + " x " + lengthFigure(size.y()) + " x " + lengthFigure(size.z()) +
           " mm";
}

/// Where a file says nothing the usual is taken, which may be wrong.
void warnOfUsual(const FrameReading& reading, const TriangleMesh& mesh, const QString& file)
{
    const Box3 box = mesh.boundingBox();
    const FileUnit likely = guessUnit({box.min() / reading.unit, box.max() / reading.unit}, largestFurniture);
    const auto unit = std::ranges::find(lengthUnits, millimetresPer(likely), &LengthUnit::millimetres);
    if (!reading.unitIsSaid && unit != lengthUnits.end() && unit->millimetres != reading.unit) {
        const double size = box.sizes().maxCoeff();
        printError("warning: that is " + lengthFigure(size) + " mm large; with --unit " + unit->word +
                   " it would be " + lengthFigure(size * unit->millimetres / reading.unit) + " mm");
    }
    if (!reading.upIsSaid && guessUpAxis(endingOf(file)) == UpAxis::Y)
        printError("warning: in files like this y mostly points up: then it needs --up y");
}

void printPartTree(const Assembly& assembly, const std::vector<bool>& wanted)
{
    const std::vector<std::size_t> depths = depthsOf(assembly);
    for (std::size_t i = 0; i < assembly.parts.size(); ++i) {
        const Assembly::Part& part = assembly.parts[i];
        if (!wanted[i])
            continue;
        std::string line(2 * std::min<std::size_t>(depths[i], 40), ' ');
        line += part.name.empty() ? "-" : part.name;
        if (!part.triangles.empty())
            line += ": " + counted(static_cast<std::int64_t>(part.triangles.size()), "triangle");
        if (part.color && !part.triangles.empty())
            line += QStringLiteral(", #%1").arg(*part.color, 6, 16, QLatin1Char('0')).toStdString();
        printResult(line);
    }
}

/// Says how far it is from what it was.
TriangleMesh withFewerTriangles(const Arguments& arguments, TriangleMesh mesh)
{
    const auto most = static_cast<std::size_t>(arguments.number("--triangles", mostAssemblyTriangles, 4, 1e8));
    if (!arguments.has("--triangles") || mesh.triangles.size() <= most)
        return mesh;
    SimplifiedMesh fewer = simplified(mesh, {}, most);
    printResult("simplified: from " + counted(static_cast<std::int64_t>(mesh.triangles.size()), "triangle") +
                ", about " + QString::number(fewer.off, 'g', 2).toStdString() + " mm off");
    if (fewer.mesh.triangles.size() > most + most / 10)
        printError("warning: it keeps " +
                   counted(static_cast<std::int64_t>(fewer.mesh.triangles.size()), "triangle") +
                   ": the borders of its parts stay as they are");
    return std::move(fewer.mesh);
}

ImportedAssembly readParts(const QString& file, const AssemblyOrder& order, const std::stop_token& stop)
{
    const ProgressLine progress("reading " + QFileInfo(file).fileName().toStdString());
    return importFrameParts(file, {stop, {}, {}}, order);
}

/// The file and, if it is to be written, what it is to become.
std::vector<QString> convertFiles(const Arguments& arguments)
{
    if (arguments.has("--list") && arguments.fileCount() == 1)
        return {arguments.onlyFile("FILE")};
    std::vector<QString> files = arguments.files({"FILE", "OUT"});
    if (!isMeshExport(endingOf(files[1])))
        throw UsageError("OUT ends in .obj, .ply or .stl, not \"" + files[1].toStdString() + "\"");
    if (QFileInfo(files[0]).exists() &&
        QFileInfo(files[0]).canonicalFilePath() == QFileInfo(files[1]).canonicalFilePath())
        throw UsageError("OUT would overwrite FILE");
    return files;
}

} // namespace

int convert(std::span<const std::string> words)
{
    const Arguments arguments(words, convertRules);
    const std::vector<QString> files = convertFiles(arguments);
    const FileFacts asked = askedFor(arguments);
    const AssemblyOrder order{arguments.number("--tolerance", usualTolerance, finestTolerance, coarsest), false};
    Interrupt interrupt(std::chrono::milliseconds(10)); // nothing is to be tidied up before it writes
    ImportedAssembly imported = readParts(files[0], order, interrupt.token());
    if (!imported.assembly) {
        printError("error: " + (imported.problem.empty() ? "interrupted" : imported.problem.english()));
        return imported.problem.empty() ? otherFailure : badInput;
    }
    for (const Message& warning : imported.warnings)
        printError("warning: " + warning.english());
    const std::vector<bool> wanted = wantedParts(arguments, *imported.assembly);
    const FrameReading reading = readingOf(asked, imported.assembly->said);
    TriangleMesh mesh = convertedMesh(*imported.assembly, wanted, reading);
    if (mesh.triangles.empty())
        throw UsageError("the parts that --parts names have no triangles");
    if (arguments.has("--list"))
        printPartTree(*imported.assembly, wanted);
    for (const std::string& line : {unitLine(reading), upLine(reading), sizeLine(mesh)})
        printResult(line);
    warnOfUsual(reading, mesh, files[0]);
    if (files.size() < 2)
        return done;
    imported.assembly.reset(); // it may be large, and so is what is written
    mesh = withFewerTriangles(arguments, std::move(mesh));
    interrupt.beginWriting();
    if (const Message problem = writeMesh(mesh, files[1]); !problem.empty()) {
        printError("error: " + problem.english());
        return otherFailure;
    }
    printResult("wrote " + files[1].toStdString() + ": " +
                counted(static_cast<std::int64_t>(mesh.parts.size()), "part") + ", " +
                counted(static_cast<std::int64_t>(mesh.triangles.size()), "triangle"));
    return done;
}

} // namespace bolster::cli
