#include "AssemblyImport.h"

#include "AssemblyStream.h"
#include "FileFormats.h"
#include "PartNames.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <new>

namespace bolster {
namespace {

constexpr std::int64_t largestAssemblyFile = 2'000'000'000;

constexpr HelperSentences assemblySentences = {
    QT_TRANSLATE_NOOP("Message",
                      "the program \"%1\", which reads such files for Bolster, cannot be started; install "
                      "Bolster again"),
    QT_TRANSLATE_NOOP("Message", "\"%1\" takes too long to read; export fewer parts of it, or triangles (OBJ, STL) "
                                 "instead"),
    QT_TRANSLATE_NOOP("Message",
                      "\"%1\" could not be read: it is damaged, or needs too much memory; export it again, "
                      "or fewer parts of it, from the program that it comes from")};

struct AssemblyFormat {
    const char* ending;
    bool isCad;
    const char* word; ///< for the program
};

constexpr AssemblyFormat assemblyFormats[] = {
    {"step", true, "step"}, {"stp", true, "step"},   {"iges", true, "iges"},
    {"igs", true, "iges"},  {"gltf", false, "gltf"}, {"glb", false, "glb"},
    {"fbx", false, "fbx"},  {"dae", false, "dae"},   {"3mf", false, "3mf"}};

const AssemblyFormat* assemblyFormat(const QString& ending)
{
    for (const AssemblyFormat& format : assemblyFormats)
        if (ending == QLatin1String(format.ending))
            return &format;
    return nullptr;
}

HelperSpeech takeAssemblyWords(AssemblyStream& stream, std::string_view words)
{
    switch (stream.take(words)) {
    case AssemblyStream::State::Unfinished:
        return HelperSpeech::Unfinished;
    case AssemblyStream::State::Done:
        return HelperSpeech::Done;
    case AssemblyStream::State::Broken:
        break;
    }
    return HelperSpeech::Nonsense;
}

Message assemblyRefusal(AssemblyVerdict verdict, const std::string& text, const std::string& file)
{
    switch (verdict) {
    case AssemblyVerdict::NoFaces:
        return {QT_TRANSLATE_NOOP("Message",
                                  "\"%1\" holds no faces, and a frame needs some; export bodies or surfaces, "
                                  "not lines and points alone"),
                {file}};
    case AssemblyVerdict::TooLarge:
        return {
            QT_TRANSLATE_NOOP("Message", "\"%1\" has more than %2 triangles; export fewer parts of it, or coarser"),
            {file, std::to_string(mostAssemblyTriangles)}};
    case AssemblyVerdict::TooManyParts:
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" has more than %2 parts; export those that the cover touches"),
                {file, std::to_string(mostAssemblyParts)}};
    case AssemblyVerdict::TooFar:
        return {QT_TRANSLATE_NOOP("Message",
                                  "%1: the part \"%2\" reaches beyond 10,000,000; export it without that "
                                  "part, or near the origin"),
                {file, text}};
    case AssemblyVerdict::FileMissing:
        return {QT_TRANSLATE_NOOP("Message",
                                  "\"%1\" needs the file \"%2\" in its own folder; copy it there, or export "
                                  "as GLB, which is one file"),
                {file, text}};
    case AssemblyVerdict::TooMuchMemory:
        return {QT_TRANSLATE_NOOP("Message",
                                  "\"%1\" needs too much memory: it has too many parts, or places them too often; "
                                  "export those that the cover touches"),
                {file}};
    case AssemblyVerdict::DecimalCommas:
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" has decimal commas; export it with decimal points"), {file}};
    case AssemblyVerdict::Damaged:
    case AssemblyVerdict::Read:
        break;
    }
    return {QT_TRANSLATE_NOOP("Message",
                              "\"%1\" is damaged or incomplete, or not what its ending says; export it again "
                              "from the program that it comes from"),
            {file}};
}

Message oddityMessage(const AssemblyWarning& warning, const std::string& file)
{
    const std::string count = std::to_string(warning.count);
    switch (warning.oddity) {
    case AssemblyOddity::NotFinite:
        return {QT_TRANSLATE_NOOP("Message", "%1: %2 triangles are left out: their corners are no numbers"),
                {file, count}};
    case AssemblyOddity::NoSize:
        return {QT_TRANSLATE_NOOP("Message", "%1: parts are left out that are scaled to nothing: %2, the first is "
                                             "\"%3\""),
                {file, count, warning.text}};
    case AssemblyOddity::NotMeshed:
        return {QT_TRANSLATE_NOOP("Message", "%1: %2 faces could not be made triangles of, and leave holes"),
                {file, count}};
    case AssemblyOddity::TooDeep:
        return {QT_TRANSLATE_NOOP("Message", "%1: %2 parts are left out that lie too deep in the tree"),
                {file, count}};
    case AssemblyOddity::NoPoint:
        if (warning.count == 0)
            return {QT_TRANSLATE_NOOP("Message",
                                      "%1: triangles are left out that name points which are not in the file"),
                    {file}};
        return {QT_TRANSLATE_NOOP("Message",
                                  "%1: %2 triangles are left out: they name points that are not in the file"),
                {file, count}};
    case AssemblyOddity::FileElsewhere:
    case AssemblyOddity::FileBeside:
        break;
    }
    return {QT_TRANSLATE_NOOP("Message", "%1: the parts in the file \"%2\" are not read; export all in one file"),
            {file, warning.text}};
}

/// Those of the same name first: they are most likely its own.
std::vector<HelperFile> buffersBeside(const QString& path)
{
    const QFileInfo file(path);
    QStringList names = file.dir().entryList({QStringLiteral("*.bin")}, QDir::Files | QDir::NoSymLinks, QDir::Name);
    std::stable_sort(names.begin(), names.end(),
                     [own = file.completeBaseName()](const QString& a, const QString& b) {
                         return a.startsWith(own) && !b.startsWith(own);
                     });
    std::vector<HelperFile> files;
    for (const QString& name : names.mid(0, static_cast<qsizetype>(mostHelperFiles))) {
        Message unreadable; // then it is missing, and that is said if it is needed
        if (auto opened = DiskFile::open(file.dir().filePath(name), largestAssemblyFile, unreadable))
            files.push_back({std::move(*opened), name.toStdString()});
    }
    return files;
}

HelperOrder helperOrder(const AssemblyFormat& format, const AssemblyOrder& order, const AssemblyReaders& readers)
{
    HelperOrder helper{
        format.isCad ? readers.cad : readers.scene, {QLatin1String(format.word)}, readers.limits, readers.time};
    if (format.isCad) {
        const double micrometres = 1000 * std::clamp(order.tolerance, finestTolerance, coarsest);
        helper.arguments << QString::number(std::lround(micrometres));
        if (order.edges)
            helper.arguments << QStringLiteral("edges");
    }
    return helper;
}

/// Faces that are there, as opposed to files.
bool leavesOut(const AssemblyWarning& warning)
{
    return warning.oddity != AssemblyOddity::FileBeside && warning.oddity != AssemblyOddity::FileElsewhere;
}

ImportedAssembly assemblyOutcome(AssemblyStream& stream, const std::string& name)
{
    if (stream.verdict() == AssemblyVerdict::NoFaces)
        if (const auto why = std::ranges::find_if(stream.warnings(), leavesOut); why != stream.warnings().end())
            return {nullptr, oddityMessage({why->oddity, why->count, cleanName(why->text)}, name)};
    if (stream.verdict() != AssemblyVerdict::Read)
        return {nullptr, assemblyRefusal(stream.verdict(), cleanName(stream.text()), name)};
    ImportedAssembly imported;
    for (AssemblyWarning warning : stream.warnings()) {
        warning.text = cleanName(warning.text);
        if (warning.oddity == AssemblyOddity::FileBeside) {
            imported.beside = warning.text;
            continue;
        }
        imported.warnings.push_back(oddityMessage(warning, name));
    }
    auto assembly = std::make_shared<Assembly>(stream.takeAssembly());
    namePartsApart(*assembly);
    imported.assembly = std::move(assembly);
    return imported;
}

} // namespace

QString AssemblyReaders::usualCad()
{
    return helperProgram("bolster-cad", "model/assembly");
}

QString AssemblyReaders::usualScene()
{
    return helperProgram("bolster-scene", "model/assembly");
}

bool isAssemblyEnding(const QString& ending)
{
    return assemblyFormat(ending) != nullptr;
}

bool isCadEnding(const QString& ending)
{
    const AssemblyFormat* const format = assemblyFormat(ending);
    return format && format->isCad;
}

ImportedAssembly importAssembly(const QString& path, const ImportWatch& watch, const AssemblyOrder& order,
                                const AssemblyReaders& readers)
{
    const AssemblyFormat* const format = assemblyFormat(endingOf(path));
    if (!format)
        return {nullptr,
                {QT_TRANSLATE_NOOP("Message", "\"%1\" is not a frame that can be read; these can: %2"),
                 {path.toStdString(), namesOf(FileUse::Frame)}}};
    Message problem;
    const auto file = DiskFile::open(path, largestAssemblyFile, problem);
    if (!file)
        return {nullptr, std::move(problem)};
    const std::string name = QFileInfo(path).fileName().toStdString();
    try {
        const HelperOrder helper = helperOrder(*format, order, readers);
        std::vector<HelperFile> beside;
        if (format->word == std::string_view("gltf"))
            beside = buffersBeside(path);
        AssemblyStream stream;
        const HelperEnd end = runHelper(helper, *file, beside, watch.stop, [&](std::string_view words) {
            const HelperSpeech heard = takeAssemblyWords(stream, words);
            if (watch.progress)
                watch.progress(stream.progress());
            return heard;
        });
        if (end == HelperEnd::Done)
            return assemblyOutcome(stream, name);
        const std::string program = format->isCad ? "bolster-cad" : "bolster-scene";
        return {nullptr, helperProblem(end, assemblySentences,
                                       helper.program.isEmpty() ? program : helper.program.toStdString(), name)};
    } catch (const std::bad_alloc&) {
        return {nullptr, {QT_TRANSLATE_NOOP("Message", "%1: there is not enough memory for this file"), {name}}};
    }
}

TriangleMesh meshOf(const Assembly& assembly, const std::function<bool(std::uint32_t part)>& wanted)
{
    TriangleMesh mesh;
    std::vector<std::uint32_t> taken;
    std::size_t points = 0, triangles = 0;
    for (std::uint32_t i = 0; i < assembly.parts.size(); ++i)
        if (!assembly.parts[i].triangles.empty() && wanted(i)) {
            taken.push_back(i);
            points += assembly.parts[i].points.size();
            triangles += assembly.parts[i].triangles.size();
        }
    mesh.points.reserve(points);
    mesh.triangles.reserve(triangles);
    for (const std::uint32_t i : taken) {
        const Assembly::Part& part = assembly.parts[i];
        const auto first = static_cast<std::uint32_t>(mesh.points.size());
        mesh.parts.push_back({part.name, static_cast<std::uint32_t>(mesh.triangles.size()),
                              static_cast<std::uint32_t>(part.triangles.size())});
        mesh.points.insert(mesh.points.end(), part.points.begin(), part.points.end());
        for (const auto& [a, b, c] : part.triangles)
            mesh.triangles.push_back({first + a, first + b, first + c});
    }
    return mesh;
}

} // namespace bolster
