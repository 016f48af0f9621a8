#include "FrameImportDialog.h"

#include <QCheckBox>

#include <gtest/gtest.h>

namespace bolster {
namespace {

std::shared_ptr<const TriangleMesh> box(double width, double height, double depth)
{
    TriangleMesh mesh;
    for (const double x : {0.0, width})
        for (const double y : {0.0, height})
            for (const double z : {0.0, depth})
                mesh.points.emplace_back(x, y, z);
    mesh.triangles = {{0, 1, 2}};
    return std::make_shared<const TriangleMesh>(std::move(mesh));
}

TEST(FrameImport, GuessesTheUnitFromTheSize)
{
    EXPECT_EQ(guessUnit(box(820, 870, 910)->boundingBox()), FileUnit::Millimetre);
    EXPECT_EQ(guessUnit(box(82, 87, 91)->boundingBox()), FileUnit::Centimetre);
    EXPECT_EQ(guessUnit(box(0.82, 0.87, 0.91)->boundingBox()), FileUnit::Metre);
    EXPECT_EQ(guessUnit(box(20, 20, 25)->boundingBox()), FileUnit::Inch);
    EXPECT_EQ(guessUnit(box(1e6, 1, 1)->boundingBox()), FileUnit::Custom);
    EXPECT_EQ(guessUnit(Box3()), FileUnit::Custom);
}

TEST(FrameImport, TurnsWhatPointsUp)
{
    FrameImportDialog dialog(QStringLiteral("seat.obj"), box(0.8, 1.0, 0.9));
    Frame frame = dialog.frame();
    EXPECT_EQ(frame.name, "seat");
    EXPECT_EQ(frame.scale, 1000);
    EXPECT_TRUE(frame.placed({0, 1, 0}).isApprox(Vec3(0, 0, 1000)));
    EXPECT_TRUE(frame.placed({0, 0, 1}).isApprox(Vec3(0, -1000, 0))); // what points to the viewer is the front

    dialog.setUpAxis(UpAxis::Z);
    dialog.setUnit(FileUnit::Inch);
    frame = dialog.frame();
    EXPECT_TRUE(frame.placed({0, 0, 1}).isApprox(Vec3(0, 0, 25.4)));
}

TEST(FrameImport, KeepsThePlacementOfAReplacedFrame)
{
    Frame before;
    before.name = "Old";
    before.scale = 437.5;
    before.position = {1, 2, 3};
    FrameImportDialog dialog(QStringLiteral("seat.obj"), box(0.8, 1.0, 0.9), before);
    EXPECT_EQ(dialog.frame(), before);
    dialog.findChildren<QCheckBox*>().front()->setChecked(false);
    EXPECT_EQ(dialog.frame().scale, 1000);
}

} // namespace
} // namespace bolster
