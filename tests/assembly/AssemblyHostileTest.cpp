// Whatever a file does to a reader, it does it in a process of its own: here it is a message, and soon.
#include "../model/TestFiles.h"

#include "AssemblyImport.h"
#include "CadFiles.h"
#include "MadeScenes.h"
#include "Sanitizer.h"
#include "TestPaths.h"

#include <QProcess>
#include <QRegularExpression>

#include <chrono>
#include <random>

namespace bolster {
namespace {

using test::colladaText;
using test::fbxText;
using test::glbBytes;
using test::GltfScene;

class AssemblyHostileTest : public TestFiles {
protected:
    /// A reader that does this instead.
    AssemblyReaders doing(const std::string& script) const
    {
        const QString program = write("reader", "#!/bin/sh\n" + script + "\n");
        QFile::setPermissions(program, QFile::ReadOwner | QFile::ExeOwner);
        AssemblyReaders readers;
        readers.cad = readers.scene = program;
        return readers;
    }

    void expectProblem(const ImportedAssembly& imported, const std::string& why) const
    {
        EXPECT_FALSE(imported.assembly);
        EXPECT_NE(imported.problem.english().find(why), std::string::npos) << imported.problem.english();
    }

    static QString real(const char* name) { return QString::fromStdString(test::dataFolder() + "/frames/" + name); }

    std::string bytesOf(const char* name)
    {
        QFile file(QString::fromStdString(test::dataFolder() + "/frames/" + name));
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        return file.readAll().toStdString();
    }

    /// One good file of each kind, by ending.
    std::vector<std::pair<QString, std::string>> goodFiles()
    {
        test::writeStepChair(path("good.step").toStdString());
        test::writeIgesBox(path("good.igs").toStdString());
        return {{"step", read("good.step")}, {"igs", read("good.igs")},    {"glb", glbBytes({})},
                {"fbx", fbxText(1, 1)},      {"dae", colladaText("", "")}, {"3mf", bytesOf("featuretype.3mf")}};
    }
};

TEST_F(AssemblyHostileTest, WhatEndsTooSoonIsRefused)
{
    for (const auto& [ending, bytes] : goodFiles()) {
        for (const double share : {0.0, 0.1, 0.5, 0.9}) {
            const QString file =
                write("cut." + ending,
                      bytes.substr(0, static_cast<std::size_t>(share * static_cast<double>(bytes.size()))));
            const ImportedAssembly imported = importAssembly(file);
            EXPECT_FALSE(imported.assembly) << ending.toStdString() << " " << share;
            EXPECT_NE(imported.problem.english().find("cut." + ending.toStdString()), std::string::npos)
                << imported.problem.english();
        }
    }
}

TEST_F(AssemblyHostileTest, DamagedBytesAreNoAccident)
{
    std::mt19937 random(17);
    for (const auto& [ending, good] : goodFiles()) {
        for (int run = 0; run < 6; ++run) {
            std::string bytes = good;
            for (int i = 0; i <= run; ++i)
                bytes[random() % bytes.size()] = static_cast<char>(random());
            const ImportedAssembly imported = importAssembly(write("bad." + ending, bytes));
            EXPECT_NE(imported.assembly == nullptr, imported.problem.empty()) << ending.toStdString();
        }
    }
}

TEST_F(AssemblyHostileTest, OneFormatIsNotReadAsAnother)
{
    for (const auto& [ending, bytes] : goodFiles())
        for (const char* other : {"step", "igs", "glb", "fbx", "dae", "3mf"})
            if (ending.left(3) != QString(other).left(3)) {
                EXPECT_FALSE(importAssembly(write(QString("other.") + other, bytes)).assembly)
                    << ending.toStdString() << " as " << other;
            }
}

TEST_F(AssemblyHostileTest, DeepTreesAndLoopsEndInAMessage)
{
    std::string deep = "[";
    constexpr int depth = 20'000;
    for (int i = 0; i < depth; ++i)
        deep += R"({"name": "n", "children": [)" + std::to_string(i + 1) + "]},";
    GltfScene scene;
    scene.nodes = deep + R"({"name": "Leaf", "mesh": 0}])";
    const ImportedAssembly leaf = importAssembly(write("deep.glb", glbBytes(scene)));
    EXPECT_FALSE(leaf.assembly);
    EXPECT_FALSE(leaf.problem.empty());

    scene.nodes = R"([{"name": "Loop", "mesh": 0, "children": [0]}])";
    EXPECT_FALSE(importAssembly(write("loop.glb", glbBytes(scene))).assembly);
    scene.nodes = R"([{"name": "A", "mesh": 0, "children": [1]}, {"name": "B", "children": [0]}])";
    EXPECT_FALSE(importAssembly(write("loops.glb", glbBytes(scene))).assembly);

    const std::string loop = R"(<node id="l"><instance_geometry url="#g"/><instance_node url="#l"/></node>)";
    EXPECT_FALSE(
        importAssembly(write("loop.dae", colladaText("", "", R"(<node><instance_node url="#l"/></node>)", loop)))
            .assembly);
}

/// Beside the four of its body.
TEST_F(AssemblyHostileTest, TrianglesOfPointsThatAreNotThereAreTold)
{
    const ImportedAssembly imported = importAssembly(real("wrong-index.3mf"));
    ASSERT_TRUE(imported.assembly) << imported.problem.english();
    ASSERT_EQ(imported.warnings.size(), 1U);
    EXPECT_EQ(imported.warnings[0].english(),
              "wrong-index.3mf: 2 triangles are left out: they name points that are not in the file");
}

TEST_F(AssemblyHostileTest, TrianglesThatTheLibraryLeavesOutAreTold)
{
    std::string bytes = glbBytes({});
    const std::size_t corner = bytes.size() - 2; // of the last triangle
    bytes[corner] = '\x40';
    const ImportedAssembly imported = importAssembly(write("beyond.glb", bytes));
    ASSERT_TRUE(imported.assembly) << imported.problem.english();
    ASSERT_EQ(imported.warnings.size(), 1U);
    EXPECT_EQ(imported.warnings[0].english(),
              "beyond.glb: triangles are left out that name points which are not in the file");
}

/// Then it is not said that there are no faces.
TEST_F(AssemblyHostileTest, WhatIsLeftOutIsToldWhereNothingElseIsThere)
{
    GltfScene scene;
    scene.nodes = R"([{"name": "Flat", "mesh": 0, "scale": [1, 0, 1]}])";
    expectProblem(importAssembly(write("flat.glb", glbBytes(scene))),
                  "flat.glb: parts are left out that are scaled to nothing: 1, the first is \"Flat\"");
    std::string nodes;
    for (int i = 0; i < 1100; ++i)
        nodes += "<node>";
    nodes += R"(<instance_geometry url="#g"/>)";
    for (int i = 0; i < 1100; ++i)
        nodes += "</node>";
    expectProblem(importAssembly(write("deep.dae", colladaText("", "", nodes, {}))), "too deep in the tree");
}

/// The files are those of tests/data/frames, with another model in them.
TEST_F(AssemblyHostileTest, ThreeMfThatWouldBeReadAsSomethingElseIsRefused)
{
    expectProblem(importAssembly(real("decimal-commas.3mf")), "has decimal commas; export it with decimal points");
    expectProblem(importAssembly(real("index-beyond.3mf")), "damaged or incomplete");
    expectProblem(importAssembly(real("placed-often.3mf")), "has more than 100000 parts");
}

TEST_F(AssemblyHostileTest, ThreeMfOfOrdinarySizeIsRead)
{
    const ImportedAssembly imported = importAssembly(real("cube_and_sphere_same_name.3mf"));
    ASSERT_TRUE(imported.assembly) << imported.problem.english();
    EXPECT_TRUE(imported.warnings.empty());
}

/// The library would make room for 2 GB.
TEST_F(AssemblyHostileTest, AGlbThatPromisesMoreThanItHoldsIsRefused)
{
    std::string bytes = glbBytes({});
    for (std::size_t i = 12; i < 16; ++i)
        bytes[i] = i == 15 ? '\x7f' : '\xff';
    AssemblyReaders readers;
    readers.limits.memory = 400'000'000;
    expectProblem(importAssembly(write("promises.glb", bytes), {}, {}, readers), "damaged or incomplete");
}

TEST_F(AssemblyHostileTest, AColladaUnitOfNothingSaysNothing)
{
    const ImportedAssembly imported =
        importAssembly(write("unit.dae", colladaText("<unit meter=\"0\"/>", "<up_axis>Z_UP</up_axis>")));
    ASSERT_TRUE(imported.assembly) << imported.problem.english();
    EXPECT_FALSE(imported.assembly->said.millimetresPerUnit);
    EXPECT_FALSE(imported.assembly->said.up);
}

/// A chair that is a part of itself.
TEST_F(AssemblyHostileTest, AssembliesInThemselvesEnd)
{
    test::writeStepChair(path("chair.step").toStdString());
    QString text = QString::fromStdString(read("chair.step"));
    const QRegularExpression use("(NEXT_ASSEMBLY_USAGE_OCCURRENCE\\s*\\([^#;]*)(#\\d+)(\\s*,\\s*)(#\\d+)");
    ASSERT_TRUE(text.contains(use));
    text.replace(use, "\\1\\2\\3\\2");
    AssemblyReaders readers;
    readers.limits.processor = std::chrono::seconds(20);
    const ImportedAssembly imported = importAssembly(write("loop.step", text.toStdString()), {}, {}, readers);
    EXPECT_NE(imported.assembly == nullptr, imported.problem.empty());
}

TEST_F(AssemblyHostileTest, AReaderThatHangsIsEnded)
{
    AssemblyReaders readers = doing("sleep 1000");
    readers.time = std::chrono::milliseconds(200);
    expectProblem(importAssembly(write("a.step", "x"), {}, {}, readers), "takes too long to read");
}

TEST_F(AssemblyHostileTest, AReaderThatEndsOrTalksNonsenseIsAMessage)
{
    const QString file = write("a.glb", "x");
    expectProblem(importAssembly(file, {}, {}, doing("exit 0")),
                  "could not be read: it is damaged, or needs too much");
    expectProblem(importAssembly(file, {}, {}, doing("kill -SEGV $$")), "could not be read");
    expectProblem(importAssembly(file, {}, {}, doing("yes nonsense")), "could not be read");
    AssemblyReaders none;
    none.scene = path("none");
    expectProblem(importAssembly(file, {}, {}, none), "which reads such files for Bolster, cannot be started");
}

#ifndef BOLSTER_ADDRESS_SANITIZER // which has no limit on memory
/// 2 to the power of 30 cubes in a file of a few KB.
TEST_F(AssemblyHostileTest, PartsThatMultiplyAreTooMany)
{
    std::string library;
    for (int i = 0; i < 30; ++i) {
        const std::string below = "#l" + std::to_string(i + 1);
        library += "<node id=\"l" + std::to_string(i) + "\"><instance_node url=\"" + below +
                   "\"/><instance_node url=\"" + below + "\"/></node>";
    }
    library += R"(<node id="l30"><instance_geometry url="#g"/></node>)";
    const QString file =
        write("many.dae", colladaText("", "", R"(<node><instance_node url="#l0"/></node>)", library));
    AssemblyReaders readers;
    readers.limits.memory = 1'000'000'000;
    readers.limits.processor = std::chrono::seconds(20);
    expectProblem(importAssembly(file, {}, {}, readers), "many.dae\" needs too much memory: it has too many parts");
}

TEST_F(AssemblyHostileTest, MemoryIsLimited)
{
    AssemblyReaders readers = doing("exec cat /dev/zero | tail");
    readers.limits.memory = 50'000'000;
    readers.time = std::chrono::milliseconds(20'000);
    expectProblem(importAssembly(write("a.glb", "x"), {}, {}, readers), "needs too much memory");
}

#endif

TEST_F(AssemblyHostileTest, WhoWaitsCanStopIt)
{
    std::stop_source stop;
    const auto waits = [&stop](double) { stop.request_stop(); };
    const ImportedAssembly imported =
        importAssembly(write("a.step", "x"), {stop.get_token(), waits, {}}, {}, doing("sleep 1000"));
    EXPECT_FALSE(imported.assembly);
    EXPECT_TRUE(imported.problem.empty());
}

/// The one file and what lies beside it are open, and there is no environment.
TEST_F(AssemblyHostileTest, AReaderHasNothingButItsFiles)
{
    qputenv("BOLSTER_SECRET", "1");
    write("mine.bin", "buffer");
    write("said", "");
    const QString said = path("said");
    AssemblyReaders readers = doing("{ env; echo \"$@\"; cat; cat /proc/self/fd/1000; } > " + said.toStdString());
    readers.limits.writesFiles = true;
    importAssembly(write("a.gltf", "the file"), {}, {}, readers);
    const std::string seen = read("said");
    EXPECT_EQ(seen.find("BOLSTER_SECRET"), std::string::npos);
    EXPECT_NE(seen.find("gltf 1000=mine.bin"), std::string::npos) << seen;
    EXPECT_NE(seen.find("the file"), std::string::npos);
    EXPECT_NE(seen.find("buffer"), std::string::npos);
    qunsetenv("BOLSTER_SECRET");
}

/// It has more to say than fits into the pipe, and waits for somebody who listens.
TEST_F(AssemblyHostileTest, ReadersAreInTheSandboxWhileTheyRead)
{
    GltfScene scene;
    std::string nodes = "[";
    for (int i = 0; i < 8000; ++i)
        nodes += std::string(i > 0 ? "," : "") + R"({"mesh": 0, "name": "n"})";
    scene.nodes = nodes + "]";
    scene.roots = "[0";
    for (int i = 1; i < 8000; ++i)
        scene.roots += "," + std::to_string(i);
    scene.roots += "]";
    QProcess reader;
    reader.setStandardInputFile(write("many.glb", glbBytes(scene)));
    reader.start(AssemblyReaders::usualScene(), {"glb"}, QIODevice::ReadOnly);
    reader.setReadChannel(QProcess::StandardOutput);
    ASSERT_TRUE(reader.waitForReadyRead(60'000));
    QFile status(QString("/proc/%1/status").arg(reader.processId()));
    ASSERT_TRUE(status.open(QIODevice::ReadOnly));
    EXPECT_TRUE(status.readAll().contains("Seccomp:\t2"));
    reader.kill();
    reader.waitForFinished();
}

} // namespace
} // namespace bolster

#ifdef BOLSTER_ADDRESS_SANITIZER
// OpenCASCADE keeps what it has written STEP with.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions()
{
    return "leak:libTK\n";
}
#endif
