// `bolster convert`, as a script calls it.
#include "../model/TestFiles.h"
#include "MeshImport.h"
#include "ProgramRun.h"
#include "TestPaths.h"

namespace bolster {
namespace {

class Convert : public TestFiles {
protected:
    ProgramRun run(const QStringList& words) const { return callCommandLine(QStringList{"convert"} + words); }

    void expectWrong(const QStringList& words, const std::string& why) const
    {
        const ProgramRun wrong = run(words);
        EXPECT_EQ(wrong.exitCode, 2) << wrong.out;
        EXPECT_NE(wrong.err.find(why), std::string::npos) << wrong.err;
    }

    Vec3 sizeOf(const QString& name) const
    {
        const ImportedMesh mesh = importMesh(path(name));
        EXPECT_TRUE(mesh.mesh) << mesh.problem.english();
        return mesh.mesh ? mesh.mesh->boundingBox().sizes() : Vec3::Zero().eval();
    }

    /// 1 x 2 x 3: a leg, and a seat on it.
    QString stool() const
    {
        return write("stool.obj", "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 1 2 3\n"
                                  "g Leg\nf 1 2 3\nf 2 4 3\ng Seat, wide\nf 1 3 4\nf 1 4 2\n");
    }

    static QString real(const char* name) { return QString::fromStdString(test::dataFolder() + "/frames/" + name); }
};

TEST_F(Convert, MakesMillimetresWithZUp)
{
    for (const char* out : {"out.obj", "out.ply", "out.stl"}) {
        const ProgramRun converted = run({stool(), path(out), "--unit", "in", "--up", "y"});
        EXPECT_EQ(converted.exitCode, 0) << converted.err;
        EXPECT_NE(converted.out.find("4 triangles"), std::string::npos) << converted.out;
        EXPECT_TRUE(sizeOf(out).isApprox(Vec3(25.4, 76.2, 50.8), 1e-6)) << out << ": " << sizeOf(out).transpose();
    }
    const ImportedMesh obj = importMesh(path("out.obj"));
    ASSERT_EQ(obj.mesh->parts.size(), 2u);
    EXPECT_EQ(obj.mesh->parts[1].name, "Seat__wide");
    EXPECT_TRUE(obj.mesh->points[3].isApprox(Vec3(25.4, -76.2, 50.8))) << "what pointed to the viewer is the front";
}

TEST_F(Convert, WhatTheFileSaysCountsUntilSomebodySaysOtherwise)
{
    ProgramRun converted = run({real("featuretype.3mf"), path("a.stl")});
    EXPECT_EQ(converted.exitCode, 0) << converted.err;
    EXPECT_NE(converted.out.find("unit: inches\n"), std::string::npos) << converted.out;
    EXPECT_TRUE(sizeOf("a.stl").isApprox(25.4 * Vec3(5, 2.5, 1.375), 1e-3)) << sizeOf("a.stl").transpose();
    converted = run({real("featuretype.3mf"), path("b.stl"), "--unit", "mm"});
    EXPECT_TRUE(sizeOf("b.stl").isApprox(Vec3(5, 2.5, 1.375), 1e-3));
    converted = run({stool(), path("c.stl")});
    EXPECT_NE(converted.out.find("unit: millimetres (the file does not say it; see --unit)"), std::string::npos)
        << converted.out;
    EXPECT_TRUE(sizeOf("c.stl").isApprox(Vec3(1, 2, 3)));
}

TEST_F(Convert, StepIsAsFineAsIsWanted)
{
    const auto triangles = [&](const char* tolerance) {
        const ProgramRun converted = run({real("featuretype.STEP"), path("a.obj"), "--tolerance", tolerance});
        EXPECT_EQ(converted.exitCode, 0) << converted.err;
        return importMesh(path("a.obj")).mesh->triangles.size();
    };
    EXPECT_GT(triangles("0.01"), 2 * triangles("1"));
    EXPECT_TRUE(sizeOf("a.obj").isApprox(25.4 * Vec3(5, 2.5, 1.375), 1e-3)) << sizeOf("a.obj").transpose();
}

TEST_F(Convert, IsAsCoarseAsIsWanted)
{
    const ProgramRun converted = run({real("cube_and_sphere_same_name.3mf"), path("a.obj"), "--triangles", "500"});
    EXPECT_EQ(converted.exitCode, 0) << converted.err;
    EXPECT_NE(converted.out.find("simplified: from "), std::string::npos) << converted.out;
    const ImportedMesh mesh = importMesh(path("a.obj"));
    ASSERT_TRUE(mesh.mesh);
    EXPECT_LE(mesh.mesh->triangles.size(), 550u);
    EXPECT_EQ(mesh.mesh->parts.size(), 2u);
}

TEST_F(Convert, ListsPartsAndTakesSome)
{
    ProgramRun listed = run({stool(), "--list"});
    EXPECT_EQ(listed.exitCode, 0) << listed.err;
    EXPECT_NE(listed.out.find("Leg: 2 triangles\nSeat, wide: 2 triangles\n"), std::string::npos) << listed.out;
    EXPECT_EQ(run({stool(), path("leg.ply"), "--parts", "Leg"}).exitCode, 0);
    EXPECT_EQ(importMesh(path("leg.ply")).mesh->triangles.size(), 2u);
    EXPECT_EQ(run({stool(), path("seat.ply"), "--parts", "Seat, wide"}).exitCode, 0) << "a comma in a name";
    EXPECT_EQ(run({stool(), path("both.ply"), "--parts", "Leg", "--parts=Seat, wide"}).exitCode, 0);
    EXPECT_EQ(importMesh(path("both.ply")).mesh->triangles.size(), 4u);
    expectWrong({stool(), path("none.ply"), "--parts", "Leg,Arm"}, "there is no part \"Arm\"");
    EXPECT_FALSE(QFile::exists(path("none.ply")));

    listed = run({real("cube_and_sphere_same_name.3mf"), "--list"});
    EXPECT_NE(listed.out.find(" (2): "), std::string::npos) << listed.out;
}

TEST_F(Convert, BadInputIsNamed)
{
    expectWrong({path("none.step"), path("a.obj")}, "there is no file");
    expectWrong({write("bad.step", "ISO"), path("a.obj")}, "\"bad.step\" is damaged or incomplete");
    expectWrong({write("a.doc", "x"), path("a.obj")},
                "these can: OBJ, PLY, STL, OFF, STEP, IGES, glTF, FBX, COLLADA, 3MF");
    expectWrong({stool()}, "OUT");
    expectWrong({stool(), path("a.doc")}, "OUT ends in .obj, .ply or .stl");
    expectWrong({stool(), stool()}, "OUT would overwrite FILE");
    expectWrong({stool(), path("a.obj"), "--unit", "yd"}, "--unit is mm, cm, m, in or ft");
    expectWrong({stool(), path("a.obj"), "--up", "x"}, "--up is y or z");
    expectWrong({stool(), path("a.obj"), "--tolerance", "0"}, "--tolerance cannot be 0");
    EXPECT_EQ(run({stool(), "/nowhere/a.obj"}).exitCode, 1);
}

} // namespace
} // namespace bolster
