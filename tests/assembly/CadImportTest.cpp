// STEP and IGES files come in as trees of parts, as fine as is wanted, in the unit of the file.
#include "../model/TestFiles.h"

#include "AssemblyImport.h"
#include "CadFiles.h"
#include "TestPaths.h"

#include <QFile>

#include <cmath>
#include <numbers>

namespace bolster {
namespace {

class CadImportTest : public TestFiles {
protected:
    std::shared_ptr<const Assembly> import(const QString& file, const AssemblyOrder& order = {})
    {
        const ImportedAssembly imported = importAssembly(file, {}, order);
        EXPECT_TRUE(imported.assembly) << imported.problem.english();
        for (const Message& warning : imported.warnings)
            ADD_FAILURE() << warning.english();
        return imported.assembly ? imported.assembly : std::make_shared<const Assembly>();
    }

    QString chair(const char* unit = "MM") const
    {
        test::writeStepChair(path("chair.step").toStdString(), unit);
        return path("chair.step");
    }
};

const Assembly::Part* shapeNamed(const Assembly& assembly, const std::string& name)
{
    for (const Assembly::Part& part : assembly.parts)
        if (part.name == name && !part.triangles.empty())
            return &part;
    return nullptr;
}

Box3 boxAround(const Assembly::Part& part)
{
    Box3 box;
    for (const Vec3& point : part.points)
        box.extend(point);
    return box;
}

double volumeIn(const Assembly::Part& part)
{
    double six = 0;
    for (const auto& [a, b, c] : part.triangles)
        six += part.points[a].dot(part.points[b].cross(part.points[c]));
    return six / 6;
}

std::string parentOf(const Assembly& assembly, const Assembly::Part& part)
{
    return part.parent ? assembly.parts[*part.parent].name : std::string();
}

TEST_F(CadImportTest, ReadsTheTreeOfAStepFile)
{
    const auto assembly = import(chair());
    EXPECT_EQ(assembly->said, (FileFacts{1, std::nullopt}));
    const Assembly::Part* const seat = shapeNamed(*assembly, "Seat");
    const Assembly::Part* const left = shapeNamed(*assembly, "Leg");
    const Assembly::Part* const right = shapeNamed(*assembly, "Leg (2)");
    const Assembly::Part* const rail = shapeNamed(*assembly, "Rail");
    ASSERT_TRUE(seat && left && right && rail);
    EXPECT_EQ(parentOf(*assembly, *seat), "Chair");
    EXPECT_EQ(parentOf(*assembly, *rail), "Back");
    EXPECT_EQ(seat->color, 0xFF0000u);
    EXPECT_FALSE(rail->color);
    EXPECT_TRUE(boxAround(*seat).isApprox(Box3(Vec3(0, 0, 400), Vec3(500, 400, 450)), 1e-9));
    EXPECT_NEAR(boxAround(*right).center().x() - boxAround(*left).center().x(), 400, 1e-9);
    EXPECT_TRUE(boxAround(*rail).isApprox(Box3(Vec3(-20, 0, 0), Vec3(0, 500, 300)), 1e-9))
        << boxAround(*rail).min().transpose() << " to " << boxAround(*rail).max().transpose();
    EXPECT_NEAR(volumeIn(*seat), 500 * 400 * 50, 1e-3) << "counter-clockwise from outside, and closed";
    EXPECT_EQ(seat->points.size(), 8u) << "faces meet in the same points";
}

TEST_F(CadImportTest, NumbersAreInTheUnitOfTheFile)
{
    const auto assembly = import(chair("INCH"));
    ASSERT_TRUE(assembly->said.millimetresPerUnit);
    EXPECT_NEAR(*assembly->said.millimetresPerUnit, 25.4, 1e-9);
    const Assembly::Part* const seat = shapeNamed(*assembly, "Seat");
    ASSERT_TRUE(seat);
    EXPECT_NEAR(boxAround(*seat).sizes().x(), 500 / 25.4, 1e-6);
}

TEST_F(CadImportTest, RoundFacesAreAsFineAsIsWanted)
{
    std::size_t before = 0;
    for (const double tolerance : {5.0, 0.5, 0.02}) {
        const auto assembly = import(chair(), {tolerance, false});
        const Assembly::Part* const leg = shapeNamed(*assembly, "Leg");
        ASSERT_TRUE(leg);
        EXPECT_GE(leg->triangles.size(), before); // round ones turn by at most 20 degrees from one to the next
        before = leg->triangles.size();
        for (const auto& triangle : leg->triangles) {
            Vec3 middle = Vec3::Zero();
            for (const std::uint32_t corner : triangle)
                middle += leg->points[corner] / 3;
            const bool onSide = middle.z() > 1 && middle.z() < 399;
            if (onSide) {
                EXPECT_GT((middle - Vec3(50, 0, middle.z())).norm(), 20 - 1.05 * tolerance);
            }
        }
        const double whole = std::numbers::pi * 20 * 20 * 400;
        EXPECT_NEAR(volumeIn(*leg), whole, whole * std::min(0.01, tolerance / 8)) << tolerance;
    }
    EXPECT_GT(before, 200u);
}

TEST_F(CadImportTest, EdgesComeWithTheirKinds)
{
    EXPECT_TRUE(import(chair())->edges.empty()) << "nobody has asked for them";
    const auto assembly = import(chair(), {0.2, true});
    std::size_t lines = 0, circles = 0;
    for (const Assembly::Edge& edge : assembly->edges) {
        const std::string& part = assembly->parts[edge.part].name;
        if (part == "Seat") {
            EXPECT_EQ(edge.kind, Assembly::Edge::Kind::Line);
            EXPECT_EQ(edge.points.size(), 2u);
            ++lines;
        }
        if (part == "Leg" && edge.kind == Assembly::Edge::Kind::Circle) {
            ++circles;
            for (std::size_t i = 1; i < edge.points.size(); ++i) {
                const Vec3 middle = (edge.points[i] + edge.points[i - 1]) / 2;
                EXPECT_GT((middle - Vec3(50, 0, middle.z())).norm(), 20 - 0.05);
            }
        }
    }
    EXPECT_EQ(lines, 12u);
    EXPECT_EQ(circles, 2u);
}

TEST_F(CadImportTest, ReadsARealPartInInches)
{
    const auto assembly = import(QString::fromStdString(test::dataFolder() + "/frames/featuretype.STEP"));
    ASSERT_TRUE(assembly->said.millimetresPerUnit);
    EXPECT_NEAR(*assembly->said.millimetresPerUnit, 25.4, 1e-9);
    const Vec3 size = meshOf(*assembly, [](std::uint32_t) { return true; }).boundingBox().sizes();
    EXPECT_TRUE(size.isApprox(Vec3(5, 2.5, 1.375), 1e-3)) << size.transpose();
}

TEST_F(CadImportTest, WhatIsNoNumberIsRefusedAtOnce)
{
    QFile file(QString::fromStdString(test::dataFolder() + "/frames/two-faces.step"));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    QByteArray step = file.readAll();
    step.replace("'Seat'", "'Seat (NAN, inf)'");
    EXPECT_TRUE(importAssembly(write("named.step", step.toStdString())).assembly) << "in quotes it is a name";
    step.replace("(300.,", "( -NAN ,");
    const ImportedAssembly imported = importAssembly(write("nan.step", step.toStdString()));
    EXPECT_FALSE(imported.assembly);
    EXPECT_NE(imported.problem.english().find("nan.step"), std::string::npos);
}

/// The library leaves them out without a word.
TEST_F(CadImportTest, FacesThatCannotBeReadAreCounted)
{
    QFile file(QString::fromStdString(test::dataFolder() + "/frames/two-faces.step"));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    QByteArray step = file.readAll();
    EXPECT_TRUE(importAssembly(write("whole.step", step.toStdString())).warnings.empty());
    ASSERT_TRUE(step.contains("(#70),#72,"));
    step.replace("(#70),#72,", "(#70),#99999,"); // a surface that is not there
    const ImportedAssembly imported = importAssembly(write("hole.step", step.toStdString()));
    ASSERT_TRUE(imported.assembly);
    ASSERT_EQ(imported.warnings.size(), 1U);
    EXPECT_NE(imported.warnings[0].english().find("1 faces could not be made triangles of"), std::string::npos)
        << imported.warnings[0].english();
}

TEST_F(CadImportTest, ReadsIges)
{
    test::writeIgesBox(path("box.igs").toStdString());
    const auto box = import(path("box.igs"));
    EXPECT_EQ(box->said, (FileFacts{1, std::nullopt}));
    const TriangleMesh mesh = meshOf(*box, [](std::uint32_t) { return true; });
    EXPECT_TRUE(mesh.boundingBox().sizes().isApprox(Vec3(100, 200, 300), 1e-6))
        << mesh.boundingBox().sizes().transpose();

    test::writeIgesBox(path("inches.iges").toStdString(), "IN");
    const auto inches = import(path("inches.iges"));
    ASSERT_TRUE(inches->said.millimetresPerUnit);
    EXPECT_NEAR(*inches->said.millimetresPerUnit, 25.4, 1e-9);
}

} // namespace
} // namespace bolster
