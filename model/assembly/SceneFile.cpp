#include "SceneFile.h"

#include "GivenIO.h"
#include "SceneParts.h"
#include "ThreeMfUnit.h"

#include <assimp/BaseImporter.h>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <assimp/ProgressHandler.hpp>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/scene.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>

namespace bolster {
namespace {

class ReadingProgress : public Assimp::ProgressHandler {
public:
    explicit ReadingProgress(AssemblyWriter& writer)
        : m_writer(writer)
    {}

    bool Update(float share) override
    {
        m_writer.progress(shareOfSceneReading * static_cast<double>(share));
        return true;
    }

private:
    AssemblyWriter& m_writer;
};

/// Hears whether the library has left faces out, which it tells nobody else.
class DroppedFaces : public Assimp::LogStream {
public:
    /// For as long as the program runs: the logger keeps it.
    static const DroppedFaces& listening()
    {
        auto* const stream = new DroppedFaces;
        Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0)->attachStream(stream, Assimp::Logger::Warn);
        return *stream;
    }

    void write(const char* message) override
    {
        m_some = m_some || std::string_view(message).find("out-of-range indices") != std::string_view::npos;
    }
    bool some() const { return m_some; }

private:
    bool m_some = false;
};

/// None but those for this ending: by its first bytes a file could choose any of fifty.
void keepReadersOf(const std::string& ending, Assimp::Importer& importer)
{
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
        const std::string endings = std::string(" ") + importer.GetImporterInfo(i)->mFileExtensions + " ";
        if (endings.find(" " + ending + " ") == std::string::npos)
            importer.UnregisterLoader(importer.GetImporter(i)); // it stays in memory: the program is short
    }
}

void choose(Assimp::Importer& importer)
{
    for (const char* useless : {AI_CONFIG_IMPORT_FBX_READ_TEXTURES, AI_CONFIG_IMPORT_FBX_READ_CAMERAS,
                                AI_CONFIG_IMPORT_FBX_READ_LIGHTS, AI_CONFIG_IMPORT_FBX_READ_ANIMATIONS,
                                AI_CONFIG_IMPORT_FBX_READ_WEIGHTS, AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS})
        importer.SetPropertyBool(useless, false);
    for (const char* wanted : {AI_CONFIG_IMPORT_NO_SKELETON_MESHES, AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES})
        importer.SetPropertyBool(wanted, true);
}

/// 0.01 and not 0.00999999977648.
double asWritten(float number)
{
    std::array<char, 32> text;
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number);
    double exact = static_cast<double>(number);
    std::from_chars(text.data(), end, exact);
    return exact;
}

FileFacts colladaFacts(const Eigen::Matrix4d& root)
{
    // The root is the unit in metres times what turns the file's up axis to y.
    FileFacts said;
    const double metres = asWritten(static_cast<float>(root.block<3, 1>(0, 0).norm()));
    if (!std::isfinite(metres) || metres <= 0)
        return said;
    said.millimetresPerUnit = 1000 * metres;
    const auto isUp = [&](int column) { return root(1, column) > 0.5 * metres; };
    said.up = isUp(2) ? UpAxis::Z : isUp(0) ? UpAxis::X : UpAxis::Y;
    return said;
}

double fbxNumber(const aiMetadata* data, const char* key, double fallback)
{
    double number = 0;
    float single = 0;
    std::int32_t whole = 0;
    if (!data)
        return fallback;
    if (data->Get(key, number))
        return number;
    if (data->Get(key, single))
        return asWritten(single);
    return data->Get(key, whole) ? whole : fallback;
}

FileFacts fbxFacts(const aiMetadata* data)
{
    FileFacts said;
    const double centimetres = fbxNumber(data, "UnitScaleFactor", 1);
    if (std::isfinite(centimetres) && centimetres > 0)
        said.millimetresPerUnit = 10 * centimetres;
    constexpr UpAxis axes[] = {UpAxis::X, UpAxis::Y, UpAxis::Z};
    const double axis = fbxNumber(data, "UpAxis", 1);
    if (axis >= 0 && axis <= 2 && fbxNumber(data, "UpAxisSign", 1) > 0)
        said.up = axes[static_cast<std::size_t>(axis)];
    return said;
}

/// Where the reader has turned the file's axes or unit in the root of the tree, takes that back: the numbers are to
/// be those of the file.
FileFacts factsOf(std::string_view bytes, const std::string& ending, aiScene& scene)
{
    aiMatrix4x4& root = scene.mRootNode->mTransformation;
    if (ending == "dae") {
        const FileFacts said = colladaFacts(matrixOf(root));
        root = aiMatrix4x4();
        return said;
    }
    if (ending == "fbx") {
        root = aiMatrix4x4();
        return fbxFacts(scene.mMetaData);
    }
    if (ending == "3mf")
        return {threeMfUnit(bytes), UpAxis::Z};
    return {1000, UpAxis::Y}; // glTF: metres
}

/// What the library would read as something else, or take for ever to read.
ThreeMfObjects checkedObjects(std::string_view bytes)
{
    ThreeMfObjects objects = threeMfObjects(bytes);
    if (objects.placed > static_cast<double>(mostAssemblyParts))
        throw AssemblyRefused{AssemblyVerdict::TooManyParts, {}};
    if (objects.hasDecimalCommas)
        throw AssemblyRefused{AssemblyVerdict::DecimalCommas, {}};
    if (objects.hasWrongIndices)
        throw AssemblyRefused{};
    return objects;
}

/// The library makes room for what the header of the first chunk promises.
void checkGlb(std::string_view bytes)
{
    constexpr std::size_t lengthAt = 12, header = 20;
    std::uint32_t length = 0;
    if (bytes.size() >= header)
        std::memcpy(&length, bytes.data() + lengthAt, sizeof length);
    if (bytes.starts_with("glTF") && length > bytes.size())
        throw AssemblyRefused{};
}

} // namespace

/// Nothing of the library is ever put away: its tidying up may crash on what it has read, and the program is short.
void readScene(std::string_view bytes, const SceneOrder& order, AssemblyWriter& writer)
{
    const std::string name = "scene." + order.ending;
    const ThreeMfObjects objects = order.ending == "3mf" ? checkedObjects(bytes) : ThreeMfObjects();
    if (order.ending == "glb")
        checkGlb(bytes);
    auto* const files = new GivenIO(name, bytes, order);
    auto& importer = *new Assimp::Importer;
    importer.SetIOHandler(files);
    importer.SetProgressHandler(new ReadingProgress(writer));
    const DroppedFaces& dropped = DroppedFaces::listening();
    keepReadersOf(order.ending, importer);
    choose(importer);
    const bool read = importer.ReadFile(name, 0) != nullptr;
    if (!read && !files->missing().empty())
        throw AssemblyRefused{AssemblyVerdict::FileMissing, files->missing()};
    if (!read)
        throw AssemblyRefused{};
    aiScene& scene = *importer.GetOrphanedScene();
    if (!scene.mRootNode)
        throw AssemblyRefused{};
    if (dropped.some())
        writer.warn(AssemblyOddity::NoPoint, 0);
    if (!files->beside().empty())
        writer.warn(AssemblyOddity::FileBeside, 1, files->beside());
    writer.facts(factsOf(bytes, order.ending, scene));
    writeSceneParts(scene, order, objects.names, writer);
}

} // namespace bolster
