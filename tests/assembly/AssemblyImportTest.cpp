// Files of modelling programs come in as they are: parts, places, units, axes.
#include "../model/TestFiles.h"

#include "AssemblyImport.h"
#include "CloudImport.h"
#include "FileContent.h"
#include "FileFormats.h"
#include "FrameImport.h"
#include "MadeScenes.h"
#include "MeshImport.h"
#include "TestPaths.h"

#include <QDir>

#include <limits>
#include <set>

namespace bolster {
namespace {

using test::colladaText;
using test::fbxText;
using test::glbBytes;
using test::gltfBuffer;
using test::GltfScene;
using test::gltfText;

class AssemblyImportTest : public TestFiles {
protected:
    std::shared_ptr<const Assembly> import(const QString& file)
    {
        m_imported = importAssembly(file);
        EXPECT_TRUE(m_imported.assembly) << m_imported.problem.english();
        return m_imported.assembly ? m_imported.assembly : std::make_shared<const Assembly>();
    }

    static QString real(const char* name) { return QString::fromStdString(test::dataFolder() + "/frames/" + name); }

    ImportedAssembly m_imported;
};

const Assembly::Part* partNamed(const Assembly& assembly, const std::string& name)
{
    for (const Assembly::Part& part : assembly.parts)
        if (part.name == name && !part.triangles.empty())
            return &part;
    return nullptr;
}

Box3 boxOf(const Assembly::Part& part)
{
    Box3 box;
    for (const Vec3& point : part.points)
        box.extend(point);
    return box;
}

Vec3 sizeOf(const Assembly& assembly)
{
    return meshOf(assembly, [](std::uint32_t) { return true; }).boundingBox().sizes();
}

/// Positive where triangles are counter-clockwise seen from outside.
double volumeOf(const Assembly::Part& part)
{
    double six = 0;
    for (const auto& [a, b, c] : part.triangles)
        six += part.points[a].dot(part.points[b].cross(part.points[c]));
    return six / 6;
}

TEST_F(AssemblyImportTest, ReadsGlbInMetresWithYUp)
{
    GltfScene scene;
    scene.nodes = R"([{"name": "Chair", "children": [1], "translation": [0, 1, 0]},
                      {"name": "Seat", "mesh": 0, "scale": [0.25, 0.05, 0.2]}])";
    const auto assembly = import(write("chair.glb", glbBytes(scene)));
    EXPECT_EQ(assembly->said, (FileFacts{1000, UpAxis::Y}));
    const Assembly::Part* const seat = partNamed(*assembly, "Seat");
    ASSERT_TRUE(seat);
    EXPECT_EQ(seat->points.size(), 8u);
    EXPECT_EQ(seat->triangles.size(), 12u);
    EXPECT_TRUE(boxOf(*seat).min().isApprox(Vec3(-0.25, 0.95, -0.2), 1e-6)) << boxOf(*seat).min().transpose();
    EXPECT_TRUE(boxOf(*seat).max().isApprox(Vec3(0.25, 1.05, 0.2), 1e-6));
    ASSERT_TRUE(seat->parent);
    EXPECT_EQ(assembly->parts[*seat->parent].name, "Chair");
    EXPECT_EQ(seat->color, 0xFF8000u) << "what is half as bright to the eye is a fifth of the light";
    EXPECT_TRUE(m_imported.warnings.empty());
}

TEST_F(AssemblyImportTest, BuffersOfGltfLieInItsOwnFolder)
{
    GltfScene scene;
    scene.uri = "leg%20frame.bin";
    const QString file = write("chair.gltf", gltfText(scene));
    EXPECT_NE(importAssembly(file).problem.english().find("needs the file \"leg frame.bin\" in its own folder"),
              std::string::npos)
        << importAssembly(file).problem.english();
    write("leg frame.bin", gltfBuffer(scene));
    EXPECT_TRUE(partNamed(*import(file), "Cube"));
    const ImportedFile frame = importFile(FileKind::Mesh, file);
    EXPECT_FALSE(frame.content) << "a project would keep half of it";
    EXPECT_NE(frame.problem.english().find("export it as GLB"), std::string::npos) << frame.problem.english();
    const ImportedFile elsewhere = importFromElsewhere(FileKind::Mesh, file);
    EXPECT_TRUE(elsewhere.content.mesh);
    EXPECT_EQ(elsewhere.beside, "leg frame.bin");

    ASSERT_TRUE(QDir(m_folder.path()).mkdir("inner"));
    for (const char* outside : {"../leg frame.bin", "/etc/hostname", "inner/leg frame.bin"}) {
        scene.uri = outside;
        const ImportedAssembly refused = importAssembly(write("inner/chair.gltf", gltfText(scene)));
        EXPECT_FALSE(refused.assembly) << outside;
        EXPECT_NE(refused.problem.english().find("in its own folder"), std::string::npos)
            << refused.problem.english();
    }
}

TEST_F(AssemblyImportTest, WhatIsMirroredKeepsItsOutside)
{
    GltfScene scene;
    scene.nodes = R"([{"name": "Left", "mesh": 0}, {"name": "Right", "mesh": 0, "scale": [-1, 1, 1]},
                      {"name": "Inside out twice", "mesh": 0, "scale": [-1, -1, 1]}])";
    scene.roots = "[0, 1, 2]";
    const auto assembly = import(write("pair.glb", glbBytes(scene)));
    for (const char* name : {"Left", "Right", "Inside out twice"}) {
        const Assembly::Part* const part = partNamed(*assembly, name);
        ASSERT_TRUE(part) << name;
        EXPECT_NEAR(volumeOf(*part), 8, 1e-6) << name;
    }
}

TEST_F(AssemblyImportTest, WhatIsScaledToNothingIsLeftOutAndSaid)
{
    GltfScene scene;
    scene.nodes = R"([{"name": "Cube", "mesh": 0}, {"name": "Gone", "mesh": 0, "scale": [0, 1, 1]}])";
    scene.roots = "[0, 1]";
    const auto assembly = import(write("a.glb", glbBytes(scene)));
    EXPECT_FALSE(partNamed(*assembly, "Gone"));
    ASSERT_EQ(m_imported.warnings.size(), 1u);
    EXPECT_EQ(m_imported.warnings[0].english(),
              "a.glb: parts are left out that are scaled to nothing: 1, the first is \"Gone\"");
}

TEST_F(AssemblyImportTest, CornersThatAreNoNumbersAreLeftOutAndSaid)
{
    GltfScene scene;
    scene.points[0] = std::numeric_limits<float>::quiet_NaN();
    const auto assembly = import(write("a.glb", glbBytes(scene)));
    const Assembly::Part* const cube = partNamed(*assembly, "Cube");
    ASSERT_TRUE(cube);
    EXPECT_LT(cube->triangles.size(), 12u);
    ASSERT_EQ(m_imported.warnings.size(), 1u);
    EXPECT_NE(m_imported.warnings[0].english().find("their corners are no numbers"), std::string::npos);

    scene = {};
    scene.nodes = R"([{"name": "Far", "mesh": 0, "translation": [1e9, 0, 0]}])";
    const ImportedAssembly far = importAssembly(write("far.glb", glbBytes(scene)));
    EXPECT_NE(far.problem.english().find("the part \"Far\" reaches beyond 10,000,000"), std::string::npos)
        << far.problem.english();
}

TEST_F(AssemblyImportTest, FbxSaysItsUnitAndAxes)
{
    for (const auto& [factor, up] : {std::pair(1.0, 1), std::pair(100.0, 2), std::pair(2.54, 1)}) {
        const auto assembly = import(write("box.fbx", fbxText(factor, up)));
        ASSERT_TRUE(assembly->said.millimetresPerUnit);
        EXPECT_NEAR(*assembly->said.millimetresPerUnit, 10 * factor, 1e-5);
        EXPECT_EQ(assembly->said.up, up == 1 ? UpAxis::Y : UpAxis::Z);
        const Assembly::Part* const box = partNamed(*assembly, "Box");
        ASSERT_TRUE(box);
        EXPECT_TRUE(boxOf(*box).min().isApprox(Vec3(100, 0, 0))) << "the numbers are those of the file";
        EXPECT_TRUE(boxOf(*box).max().isApprox(Vec3(110, 10, 10)));
        EXPECT_NEAR(volumeOf(*box), 1000, 1e-6);
        ASSERT_TRUE(box->parent);
        EXPECT_EQ(assembly->parts[*box->parent].name, "Group");
    }
}

TEST_F(AssemblyImportTest, ColladaSaysItsUnitAndAxes)
{
    const std::pair<const char*, UpAxis> axes[] = {{"<up_axis>Z_UP</up_axis>", UpAxis::Z},
                                                   {"<up_axis>Y_UP</up_axis>", UpAxis::Y},
                                                   {"<up_axis>X_UP</up_axis>", UpAxis::X}};
    for (const auto& [word, up] : axes) {
        const auto assembly = import(write("box.dae", colladaText(R"(<unit meter="0.0254" name="inch"/>)", word)));
        ASSERT_TRUE(assembly->said.millimetresPerUnit);
        EXPECT_NEAR(*assembly->said.millimetresPerUnit, 25.4, 1e-5) << word;
        EXPECT_EQ(assembly->said.up, up) << word;
        EXPECT_TRUE(sizeOf(*assembly).isApprox(Vec3(10, 10, 10), 1e-6)) << "the numbers are those of the file";
    }
    const auto plain = import(write("plain.dae", colladaText("", "")));
    EXPECT_EQ(plain->said, (FileFacts{1000, UpAxis::Y})) << "as the format has it";
}

TEST_F(AssemblyImportTest, ReadsARealSofa)
{
    const auto assembly = import(real("sofa.dae"));
    ASSERT_TRUE(assembly->said.millimetresPerUnit);
    EXPECT_NEAR(*assembly->said.millimetresPerUnit, 10, 1e-6);
    EXPECT_EQ(assembly->said.up, UpAxis::Z);
    const Vec3 size = *assembly->said.millimetresPerUnit * sizeOf(*assembly);
    EXPECT_GT(size.minCoeff(), 500);
    EXPECT_LT(size.maxCoeff(), 1500);
    std::size_t triangles = 0;
    for (const Assembly::Part& part : assembly->parts)
        triangles += part.triangles.size();
    EXPECT_EQ(triangles, 654u);
}

TEST_F(AssemblyImportTest, BodiesOfOneNameAreToldApart)
{
    const auto assembly = import(real("cube_and_sphere_same_name.3mf"));
    EXPECT_EQ(assembly->said, (FileFacts{1, UpAxis::Z}));
    std::vector<std::string> names;
    for (const Assembly::Part& part : assembly->parts)
        if (!part.triangles.empty())
            names.push_back(part.name);
    ASSERT_EQ(names.size(), 2u);
    EXPECT_EQ(names[1], names[0] + " (2)");
    const ImportedMesh mesh = importMesh(real("cube_and_sphere_same_name.3mf"));
    ASSERT_TRUE(mesh.mesh);
    EXPECT_EQ(mesh.mesh->parts.size(), 2u);
}

TEST_F(AssemblyImportTest, ThreeMfSaysItsUnit)
{
    const auto assembly = import(real("featuretype.3mf"));
    EXPECT_EQ(assembly->said, (FileFacts{25.4, UpAxis::Z}));
    EXPECT_TRUE(sizeOf(*assembly).isApprox(Vec3(5, 2.5, 1.375), 1e-3)) << sizeOf(*assembly).transpose();
}

TEST_F(AssemblyImportTest, NamesArePlainAndDifferent)
{
    GltfScene scene;
    std::string nodes;
    for (const char* const name : {"  Leg\\n front ", "Leg front", "Leg front (2)", ""})
        nodes += std::string(nodes.empty() ? "[" : ",") + R"({"mesh": 0, "name": ")" + name + "\"}";
    scene.nodes = nodes + "]";
    scene.roots = "[0, 1, 2, 3]";
    const auto assembly = import(write("legs.glb", glbBytes(scene)));
    std::vector<std::string> names;
    for (const Assembly::Part& part : assembly->parts)
        if (!part.triangles.empty())
            names.push_back(part.name);
    ASSERT_EQ(names.size(), 4u);
    EXPECT_EQ(names[0], "Leg front");
    EXPECT_EQ(names[1], "Leg front (2)");
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), 4u);
}

TEST_F(AssemblyImportTest, EveryListedFormatHasAReader)
{
    for (const QString& ending : endingsOf(FileUse::Frame)) {
        const std::string problem = importMesh(write("empty." + ending, "x")).problem.english();
        EXPECT_FALSE(problem.empty()) << ending.toStdString();
        EXPECT_EQ(problem.find("is not a frame that can be read"), std::string::npos) << problem;
    }
    for (const QString& ending : endingsOf(FileUse::Scan))
        EXPECT_EQ(importCloud(write("empty." + ending, "x")).problem.english().find("is not a scan"),
                  std::string::npos)
            << ending.toStdString();
}

TEST_F(AssemblyImportTest, GroupsOfPlainMeshesAreParts)
{
    const ImportedAssembly imported = importFrameParts(
        write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng one\nf 1 2 3\ng two\nf 1 2 4\nf 2 3 4\n"));
    ASSERT_TRUE(imported.assembly);
    ASSERT_EQ(imported.assembly->parts.size(), 2u);
    EXPECT_EQ(imported.assembly->parts[0].points.size(), 3u);
    EXPECT_EQ(imported.assembly->parts[1].points.size(), 4u);
    EXPECT_EQ(imported.assembly->said, FileFacts{}) << "the format says nothing";
}

} // namespace
} // namespace bolster
