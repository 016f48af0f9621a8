#include "FileImportDialog.h"
#include "NumberBox.h"
#include "PartsTree.h"
#include "SimplifyChoice.h"

#include <QCheckBox>
#include <QLabel>
#include <QLocale>

#include <gtest/gtest.h>

namespace bolster {
namespace {

FileContent box(double width, double height, double depth)
{
    TriangleMesh mesh;
    for (const double x : {0.0, width})
        for (const double y : {0.0, height})
            for (const double z : {0.0, depth})
                mesh.points.emplace_back(x, y, z);
    mesh.triangles = {{0, 1, 2}};
    return {std::make_shared<const TriangleMesh>(std::move(mesh)), nullptr};
}

TEST(FileImport, GuessesTheUnitFromTheSize)
{
    EXPECT_EQ(guessUnit(box(820, 870, 910).boundingBox(), largestFurniture), FileUnit::Millimetre);
    EXPECT_EQ(guessUnit(box(82, 87, 91).boundingBox(), largestFurniture), FileUnit::Centimetre);
    EXPECT_EQ(guessUnit(box(0.82, 0.87, 0.91).boundingBox(), largestFurniture), FileUnit::Metre);
    EXPECT_EQ(guessUnit(box(20, 20, 25).boundingBox(), largestFurniture), FileUnit::Inch);
    EXPECT_EQ(guessUnit(box(1e6, 1, 1).boundingBox(), largestFurniture), FileUnit::Custom);
    EXPECT_EQ(guessUnit(box(5000, 2, 1).boundingBox(), largestFurniture), FileUnit::Millimetre) << "a long bench";
    EXPECT_EQ(guessUnit(box(0.2, 0.1, 0.2).boundingBox(), largestFurniture), FileUnit::Metre) << "a small cushion";
    EXPECT_EQ(guessUnit(box(5, 2.5, 4).boundingBox(), largestScan), FileUnit::Metre) << "a room";
    EXPECT_EQ(guessUnit(Box3(), largestFurniture), FileUnit::Custom);
}

TEST(FileImport, ScannersFormatsAreInMetresWhateverTheirSize)
{
    for (const char* ending : {"e57", "las", "PTX"})
        EXPECT_EQ(unitOf(QLatin1String(ending)), FileUnit::Metre) << ending;
    EXPECT_EQ(unitOf(QStringLiteral("ply")), std::nullopt);
    FileContent hall = box(60, 40, 20);
    EXPECT_EQ(FileImportDialog(QStringLiteral("hall.e57"), hall).placement().scale, 1000);
    EXPECT_EQ(FileImportDialog(QStringLiteral("hall.obj"), hall).placement().scale, 10);
}

TEST(FileImport, WhatTheFileSaysIsTakenAsSaidAndElseMillimetres)
{
    const Placement inches = saidPlacement({25.4, UpAxis::Y}, QStringLiteral("step"));
    EXPECT_TRUE(inches.placed({0, 2, 0}).isApprox(Vec3(0, 0, 50.8)));
    EXPECT_TRUE(saidPlacement({}, QStringLiteral("e57")).placed({1, 2, 3}).isApprox(Vec3(1000, 2000, 3000)));
    EXPECT_TRUE(saidPlacement({}, QStringLiteral("obj")).placed({1, 2, 3}).isApprox(Vec3(1, 2, 3)));
}

TEST(FileImport, GuessesAFactorWhereNoUnitFits)
{
    for (const double size : {1e-9, 4e-7, 2e-4, 3e5, 1e6, 9e6}) {
        const FileContent content = box(size, size / 2, size / 3);
        EXPECT_EQ(guessUnit(content.boundingBox(), largestFurniture), FileUnit::Custom) << size;
        FileImportDialog dialog(QStringLiteral("seat.obj"), content);
        const double large = size * dialog.placement().scale;
        EXPECT_GE(large, 250) << size;
        EXPECT_LE(large, 3500) << size;
    }
    FileImportDialog point(QStringLiteral("seat.obj"), box(0, 0, 0));
    EXPECT_GT(point.placement().scale, 0);
}

TEST(FileImport, TurnsWhatPointsUp)
{
    FileImportDialog dialog(QStringLiteral("seat.obj"), box(0.8, 1.0, 0.9));
    Placement frame = dialog.placement();
    EXPECT_EQ(frame.scale, 1000);
    EXPECT_TRUE(frame.placed({0, 1, 0}).isApprox(Vec3(0, 0, 1000)));
    EXPECT_TRUE(frame.placed({0, 0, 1}).isApprox(Vec3(0, -1000, 0))); // what points to the viewer is the front

    dialog.setUpAxis(UpAxis::Z);
    dialog.setUnit(FileUnit::Inch);
    frame = dialog.placement();
    EXPECT_TRUE(frame.placed({0, 0, 1}).isApprox(Vec3(0, 0, 25.4)));
}

TEST(FileImport, BelievesWhatTheFileSays)
{
    FileImportDialog dialog(QStringLiteral("seat.step"), box(30, 40, 35), {}, {25.4, UpAxis::Y});
    Placement frame = dialog.placement();
    EXPECT_EQ(frame.scale, 25.4);
    EXPECT_TRUE(frame.placed({0, 1, 0}).isApprox(Vec3(0, 0, 25.4)));
    FileImportDialog odd(QStringLiteral("seat.fbx"), box(30, 40, 35), {}, {17, UpAxis::X});
    frame = odd.placement();
    EXPECT_EQ(frame.scale, 17);
    EXPECT_TRUE(frame.placed({1, 0, 0}).isApprox(Vec3(0, 0, 17)));
    FileImportDialog half(QStringLiteral("seat.step"), box(0.8, 1.0, 0.9), {}, {1000, std::nullopt});
    EXPECT_EQ(half.placement().scale, 1000);
    EXPECT_TRUE(half.placement().placed({0, 0, 1}).isApprox(Vec3(0, 0, 1000)));
}

TEST(FileImport, PartsThatAreNotWantedAreNotMeasured)
{
    TriangleMesh mesh;
    mesh.points = {{0, 0, 0}, {500, 0, 0}, {0, 400, 0}, {0, 0, 0}, {900, 0, 0}, {0, 900, 800}};
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
    mesh.parts = {{"Seat", 0, 1}, {"Plinth", 1, 1}};
    FileImportDialog dialog(QStringLiteral("seat.step"), {std::make_shared<const TriangleMesh>(mesh), nullptr}, {},
                            {1, UpAxis::Z});
    EXPECT_EQ(dialog.placement().position, Vec3(0, 0, 0));
    dialog.findChildren<QCheckBox*>().back()->setChecked(true); // on the floor, in the middle
    EXPECT_EQ(dialog.placement().position, Vec3(-450, -450, 0));
    dialog.offerParts({{"Chair", {}, 0}, {"Seat", 0, 1}, {"Plinth", 0, 1}, {"Empty", 0, 0}}, {"Plinth"});
    EXPECT_EQ(dialog.unwantedParts(), std::vector<std::string>{"Plinth"});
    EXPECT_EQ(dialog.placement().position, Vec3(-250, -200, 0));
    auto* const tree = dialog.findChild<PartsTree*>();
    ASSERT_TRUE(tree);
    ASSERT_EQ(tree->topLevelItemCount(), 1);
    QTreeWidgetItem* const chair = tree->topLevelItem(0);
    EXPECT_EQ(chair->childCount(), 2) << "what has no triangles is not there";
    EXPECT_EQ(chair->checkState(0), Qt::PartiallyChecked);
    chair->setCheckState(0, Qt::Unchecked);
    EXPECT_EQ(dialog.unwantedParts().size(), 2u);
}

TEST(FileImport, LargeMeshesCanBeSimplified)
{
    FileImportDialog small(QStringLiteral("seat.obj"), box(800, 900, 1000));
    EXPECT_FALSE(small.findChild<SimplifyChoice*>());
    EXPECT_FALSE(small.wantedTriangles());
    TriangleMesh mesh = *box(800, 900, 1000).mesh;
    mesh.triangles.resize(1'000'000, {0, 0, 0});
    FileImportDialog dialog(QStringLiteral("seat.obj"), {std::make_shared<const TriangleMesh>(mesh), nullptr});
    auto* const choice = dialog.findChild<SimplifyChoice*>();
    ASSERT_TRUE(choice);
    EXPECT_FALSE(dialog.wantedTriangles()) << "on wish";
    choice->findChild<QCheckBox*>()->setChecked(true);
    EXPECT_EQ(dialog.wantedTriangles(), 100'000u);
    choice->findChild<NumberBox*>()->setValue(5000);
    EXPECT_EQ(dialog.wantedTriangles(), 5000u);
}

TEST(FileImport, KeepsThePlacementOfAReplacedFrame)
{
    Placement before;
    before.scale = 437.5;
    before.position = {1, 2, 3};
    FileImportDialog dialog(QStringLiteral("seat.obj"), box(0.8, 1.0, 0.9), before);
    EXPECT_EQ(dialog.placement(), before);
    dialog.findChildren<QCheckBox*>().front()->setChecked(false);
    EXPECT_EQ(dialog.placement().scale, 1000);
}

/// One of inches is replaced by one of millimetres.
TEST(FileImport, AReplacedFrameOfAnotherUnitKeepsItsSize)
{
    Placement before;
    before.scale = 25.4;
    before.position = {1, 2, 3};
    FileImportDialog dialog(QStringLiteral("seat.obj"), box(127, 64, 35), before, {1.0, UpAxis::Z});
    dialog.replaces(127);
    EXPECT_EQ(dialog.placement().scale, 1);
    EXPECT_EQ(dialog.placement().position, before.position);

    FileImportDialog silent(QStringLiteral("seat.obj"), box(127, 64, 35), before);
    silent.replaces(127);
    EXPECT_EQ(silent.placement(), before) << "nobody says a unit";
    const auto labels = silent.findChildren<QLabel*>();
    EXPECT_TRUE(std::ranges::any_of(labels, [](const QLabel* label) {
        return label->text().startsWith("It was 127 mm large and becomes 3226 mm");
    }));
}

TEST(FileImport, TellsWhatIsOddAboutAFile)
{
    FileImportDialog dialog(QStringLiteral("seat.obj"), box(127, 64, 35));
    dialog.warn(QStringLiteral("2 points are left out."));
    const auto labels = dialog.findChildren<QLabel*>();
    EXPECT_TRUE(std::ranges::any_of(labels, [](const QLabel* label) {
        return label->text() == "2 points are left out." && !label->isHidden();
    }));
}

TEST(FileImport, SaysThatAScanWasThinnedOutAndHowMuch)
{
    auto cloud = std::make_shared<PointCloud>();
    cloud->points = {{0, 0, 0}, {5, 4, 2.5}};
    FileImportDialog small(QStringLiteral("room.ply"), {nullptr, cloud});
    const auto about = [](const FileImportDialog& dialog) {
        QString text;
        for (const QLabel* label : dialog.findChildren<QLabel*>())
            if (!label->isHidden())
                text += label->text();
        return text;
    };
    EXPECT_FALSE(about(small).contains(QStringLiteral("thinned")));

    auto large = std::make_shared<PointCloud>(*cloud);
    large->thinnedFrom = 12'000'000;
    large->spacing = 0.0025;
    FileImportDialog dialog(QStringLiteral("room.ply"), {nullptr, large});
    EXPECT_TRUE(about(dialog).contains(QLocale().toString(12'000'000)));
    EXPECT_TRUE(about(dialog).contains(QStringLiteral("every 2.5 mm"))) << about(dialog).toStdString();
    dialog.setUnit(FileUnit::Millimetre);
    EXPECT_FALSE(about(dialog).contains(QStringLiteral("every 2.5 mm"))) << "the unit is another one";
}

} // namespace
} // namespace bolster
