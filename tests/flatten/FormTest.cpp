// Where forms are cut, and what hangs together then.
#include "DesignCheck.h"
#include "FormPattern.h"
#include "TestForms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster::test {
namespace {

/// An open box without its lid: bottom and four walls, each a part of its own.
TriangleMesh tray(double size, double height)
{
    const auto wall = [&](const Vec3& from, const Vec3& along, const std::string& name) {
        return gridMesh(
            4, 2, [=](double u, double v) { return Vec3(from + u * along + Vec3(0, 0, v * height)); }, name);
    };
    TriangleMesh mesh = gridMesh(
        4, 4, [=](double u, double v) { return Vec3(u * size, (1 - v) * size, 0); }, "Bottom");
    mesh = sideBySide(mesh, wall({0, 0, 0}, {size, 0, 0}, "Front"));
    mesh = sideBySide(mesh, wall({size, 0, 0}, {0, size, 0}, "Right"));
    mesh = sideBySide(mesh, wall({size, size, 0}, {-size, 0, 0}, "Back"));
    return sideBySide(mesh, wall({0, size, 0}, {0, -size, 0}, "Left"));
}

std::ptrdiff_t sewnEdges(const FormPiece& piece)
{
    return std::ranges::count_if(piece.mates, [](const EdgeMate& mate) { return !mate.none(); });
}

/// Each sewn edge has a mate that says the same of it, and lies between the same points the other way round.
void expectMatesAgree(const Form& form)
{
    for (int p = 0; p < std::ssize(form.pieces); ++p) {
        const FormPiece& piece = form.pieces[p];
        ASSERT_EQ(piece.mates.size(), piece.border.size());
        for (int k = 0; k < std::ssize(piece.border); ++k) {
            const EdgeMate mate = piece.mates[k];
            if (mate.none())
                continue;
            const FormPiece& other = form.pieces[mate.piece];
            EXPECT_EQ(other.mates[mate.edge], (EdgeMate{p, k}));
            EXPECT_EQ(other.points[other.border[mate.edge]], piece.points[piece.border[piece.after(k)]]);
        }
    }
}

TEST(Form, FallsApartWhereGroupsMeet)
{
    const Form form = cutForm(tray(200, 60), {});
    ASSERT_EQ(problemOf(form), "");
    ASSERT_EQ(form.pieces.size(), 5u);
    EXPECT_EQ(form.pieces[0].name, "Bottom");
    EXPECT_EQ(sewnEdges(form.pieces[0]), 16) << "all around";
    EXPECT_EQ(sewnEdges(form.pieces[1]), 4 + 2 + 2) << "below, and on both sides";
    expectMatesAgree(form);
}

TEST(Form, PointsThatNearlyCoincideAreOne)
{
    constexpr double edgeOfACell = 0.00005, apart = 0.00001; // mm
    TriangleMesh mesh = tray(200, 60);
    for (std::size_t k = 0; k < mesh.points.size(); ++k)
        mesh.points[k] += Vec3::Constant(edgeOfACell + (k % 2 == 0 ? apart / 2 : -apart / 2));
    const Form form = cutForm(mesh, {});
    ASSERT_EQ(form.pieces.size(), 5u);
    EXPECT_EQ(sewnEdges(form.pieces[0]), 16);
    expectMatesAgree(form);
}

TEST(Form, FallsApartWhereItBends)
{
    TriangleMesh mesh = tray(200, 60);
    mesh.parts = {{"Tray", 0, static_cast<std::uint32_t>(mesh.triangles.size())}};
    const Form form = cutForm(mesh, {false, 30});
    ASSERT_EQ(form.pieces.size(), 5u);
    EXPECT_EQ(form.pieces[0].name, "Tray");
    EXPECT_EQ(form.pieces[4].name, "Tray 5");
    expectMatesAgree(form);
    EXPECT_EQ(cutForm(mesh, {false, 120}).pieces.size(), 1u) << "a tray has one border and can be laid flat";
}

TEST(Form, TurnsFacesThatAreTheWrongWayRound)
{
    TriangleMesh mesh = tray(200, 60);
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 5)
        std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    const Form form = cutForm(mesh, {});
    ASSERT_EQ(form.pieces.size(), 5u);
    EXPECT_FALSE(form.notes.empty());
    expectMatesAgree(form);
}

TEST(Form, ARingIsCutOpenAlongTheShortestWay)
{
    const Form form = cutForm(ringMesh(100, 100, 150, 40, 10), {});
    ASSERT_EQ(problemOf(form), "");
    ASSERT_EQ(form.pieces.size(), 1u);
    EXPECT_EQ(sewnEdges(form.pieces[0]), 20) << "both sides of the cut";
    ASSERT_EQ(form.notes.size(), 1u);
    double length = 0;
    const FormPiece& piece = form.pieces[0];
    for (std::size_t k = 0; k < piece.border.size(); ++k)
        if (!piece.mates[k].none())
            length += (form.points[piece.points[piece.border[piece.after(k)]]] -
                       form.points[piece.points[piece.border[k]]])
                          .norm();
    EXPECT_NEAR(length, 300, 1e-6) << "straight up, there and back";
    expectMatesAgree(form);
}

TriangleMesh closedBoxNamedBox()
{
    TriangleMesh mesh =
        sideBySide(tray(200, 60), gridMesh(
                                      4, 4, [](double u, double v) { return Vec3(u * 200, v * 200, 60); }, "Lid"));
    mesh.parts = {{"Box", 0, static_cast<std::uint32_t>(mesh.triangles.size())}};
    return mesh;
}

TEST(Form, WhatHasNoBorderIsRefusedByName)
{
    const Form form = cutForm(closedBoxNamedBox(), {});
    ASSERT_EQ(form.pieces.size(), 1u);
    EXPECT_EQ(form.pieces[0].refusal.english().find("Box is left out: it is closed all around"), 0u)
        << form.pieces[0].refusal.english();
}

/// The others become pieces, rings among them too, and patches; it becomes none.
TEST(Form, WhatIsClosedIsLeftOutAlone)
{
    const TriangleMesh mesh = sideBySide(sideBySide(halfPipe(100, 200), closedBoxNamedBox()), ringMesh(80, 60, 50));
    const Form form = cutForm(mesh, {});
    EXPECT_TRUE(form.problem.empty()) << form.problem.english();
    ASSERT_EQ(form.pieces.size(), 3u);
    const FormPattern pattern = formPattern(form, flatten(form, {}), {});
    for (std::size_t p = 0; p < 3; ++p) {
        const bool isBox = form.pieces[p].name == "Box";
        EXPECT_EQ(form.pieces[p].isSheet(), !isBox) << form.pieces[p].name;
        EXPECT_EQ(pattern.patches[p] == noElement, isBox) << form.pieces[p].name;
    }
    ASSERT_EQ(pattern.notes.size(), 1u);
    EXPECT_NE(pattern.notes[0].english().find("Box is left out"), std::string::npos) << pattern.notes[0].english();
    EXPECT_FALSE(hasErrors(checkDesign(pattern.design)));
}

/// A box with a hole of few millimetres that somebody forgot: nothing but its rim would hold the cover.
TEST(Form, WhatIsHeldAtASmallHoleAloneSaysSo)
{
    for (const auto& [share, says] : {std::pair(0.1, true), std::pair(0.9, false)}) {
        TriangleMesh box = closedBoxNamedBox();
        const auto last = box.triangles.back(); // of the lid
        const auto inner = static_cast<std::uint32_t>(box.points.size());
        box.triangles.pop_back();
        const Vec3 middle = (box.points[last[0]] + box.points[last[1]] + box.points[last[2]]) / 3;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t next = (k + 1) % 3;
            box.points.push_back(middle + share * (box.points[last[k]] - middle));
            box.triangles.push_back({last[k], last[next], inner + next});
            box.triangles.push_back({last[k], inner + next, inner + k});
        }
        box.parts = {{"Box", 0, static_cast<std::uint32_t>(box.triangles.size())}};
        const Form form = cutForm(box, {true, 30});
        ASSERT_EQ(form.pieces.size(), 6u);
        const FormPattern pattern = formPattern(form, flatten(form, {}), {});
        const bool isSaid = std::ranges::any_of(pattern.advice, [](const Message& advice) {
            return advice.english().find("is held only at a border of") != std::string::npos;
        });
        EXPECT_EQ(isSaid, says) << share;
    }
}

TEST(Form, OfNothingThereIsNothing)
{
    EXPECT_FALSE(cutForm({}, {}).problem.empty());
    TriangleMesh line;
    line.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    line.triangles = {{0, 1, 2}};
    EXPECT_FALSE(cutForm(line, {}).problem.empty());
}

/// As faces of CAD files that go on smoothly in each other.
TEST(Form, FallsApartAlongEdgesThatDoNotBend)
{
    const TriangleMesh pipe = halfPipe(100, 200, 60, 24);
    FormCuts cuts;
    for (const double angle : {std::numbers::pi / 3, std::numbers::pi / 2}) // columns of the mesh
        cuts.edges.push_back({{-100 * std::cos(angle), -100 * std::sin(angle), 0},
                              {-100 * std::cos(angle), -100 * std::sin(angle), 200}});
    EXPECT_EQ(cutForm(pipe, cuts).pieces.size(), 3U);
    cuts.edges.push_back({{-100, 0, 50}, {100, 0, 50}}); // touches it at its border only
    EXPECT_EQ(cutForm(pipe, cuts).pieces.size(), 3U);
    FormLine across{"Across", {}, false};
    for (int k = 0; k <= 60; ++k)
        across.points.emplace_back(-100 * std::cos(std::numbers::pi * k / 60),
                                   -100 * std::sin(std::numbers::pi * k / 60), 77);
    cuts.lines = {across};
    EXPECT_EQ(cutForm(pipe, cuts).pieces.size(), 6U);
}

TEST(Form, EdgesOfThreeFacesAreBorders)
{
    TriangleMesh mesh = tray(200, 60);
    mesh = sideBySide(mesh, gridMesh(
                                4, 2, [](double u, double v) { return Vec3(200, 200 * u, 60 * v - 60); }, "Skirt"));
    const Form form = cutForm(mesh, {});
    ASSERT_EQ(form.pieces.size(), 6u);
    EXPECT_EQ(sewnEdges(form.pieces[0]), 12) << "one side of four is a border";
    expectMatesAgree(form);
}

TEST(Form, SaysWhereBodiesGoThroughEachOther)
{
    const auto noted = [](const Vec3& offset) {
        TriangleMesh moved = tray(100, 60);
        for (Vec3& point : moved.points)
            point += offset;
        const Form form = cutForm(sideBySide(tray(200, 60), moved), {});
        const auto note = std::ranges::find_if(form.notes, [](const Message& each) {
            return each.english().find("go through each other") != std::string::npos;
        });
        return note != form.notes.end() ? note->english() : std::string();
    };
    const std::string through = noted({150, 50, 20});
    EXPECT_NE(through.find("(200, "), std::string::npos) << through << ": its wall at x = 200";
    EXPECT_NE(through.find("such pairs: 1"), std::string::npos) << through;
    EXPECT_EQ(noted({50, 50, -0.5}), "") << "by less than a mm";
    EXPECT_NE(noted({50, 50, -5}), "");
    EXPECT_EQ(noted({250, 0, 0}), "") << "beside";
    EXPECT_EQ(noted({200, 50, 0}), "") << "it only touches it";
    EXPECT_EQ(noted({200, 150, 0}), "") << "it only touches it, and stands out beside it";
    EXPECT_EQ(noted({200, 163, 17}), "");
    EXPECT_EQ(noted({63, 41, 60}), "") << "it stands on it";
    EXPECT_EQ(noted({50, 50, -80}), "") << "below";
}

} // namespace
} // namespace bolster::test
