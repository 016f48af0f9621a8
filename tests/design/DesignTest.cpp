#include "Design.h"

#include <gtest/gtest.h>

#include <numbers>

namespace bolster {
namespace {

ElementPtr fabric(const std::string& name)
{
    Fabric value;
    value.name = name;
    return makeElement(value);
}

Edit put(int id, ElementPtr element)
{
    return {{"Put"}, {{ElementId{id}, nullptr, std::move(element)}}};
}

TEST(Design, BeginsEmptyWithSettings)
{
    const Design design;
    EXPECT_TRUE(design.elements().empty());
    EXPECT_EQ(design.settings().edgeLength, 12);
    EXPECT_EQ(design.nextId(), ElementId{1});
    EXPECT_NE(design.element(settingsId), nullptr);
    EXPECT_EQ(design.element(ElementId{1}), nullptr);
}

TEST(Design, EditsMakeNewDesignsThatShareTheRest)
{
    const Design first = Design().with(put(3, fabric("Leather")));
    const Design second = first.with(put(5, fabric("Wool")));
    EXPECT_EQ(first.elements().size(), 1u);
    EXPECT_EQ(second.elements().size(), 2u);
    EXPECT_EQ(first.element(ElementId{3}), second.element(ElementId{3}));
    EXPECT_EQ(second.nextId(), ElementId{6});
    EXPECT_EQ(second.find<Fabric>(ElementId{5})->name, "Wool");
    EXPECT_EQ(second.find<Patch>(ElementId{5}), nullptr);
    std::vector<std::string> names;
    second.each<Fabric>([&](ElementId, const Fabric& value) { names.push_back(value.name); });
    EXPECT_EQ(names, (std::vector<std::string>{"Leather", "Wool"}));
}

TEST(Design, InverseEditsLeadBack)
{
    const Design first = Design().with(put(3, fabric("Leather")));
    Design second = first.with(put(5, fabric("Wool")));
    second = second.with(put(3, fabric("Cord")));
    Settings settings;
    settings.edgeLength = 20;
    second = second.with({{"Set"}, {{settingsId, nullptr, makeElement(settings)}}});
    const Edit edit = editBetween(first, second, {"Change"});
    EXPECT_EQ(differences(first, second), (std::set<ElementId>{settingsId, ElementId{3}, ElementId{5}}));
    EXPECT_EQ(first.with(edit), second);
    EXPECT_EQ(second.with(edit.inverse()), first);
    EXPECT_EQ(edit.inverse().verb, edit.verb);
    EXPECT_FALSE(first == second);
}

TEST(Design, ComparesByContent)
{
    EXPECT_EQ(Design().with(put(3, fabric("Leather"))), Design().with(put(3, fabric("Leather"))));
    EXPECT_TRUE(differences(Design().with(put(3, fabric("A"))), Design().with(put(3, fabric("A")))).empty());
    EXPECT_FALSE(Design().with(put(3, fabric("Leather"))) == Design().with(put(4, fabric("Leather"))));
}

TEST(Design, FindsAFreeIdBelowTheLargest)
{
    const Design design = Design().with(put(largestElementId, fabric("Last"))).with(put(1, fabric("First")));
    EXPECT_EQ(design.nextId(), ElementId{2});
}

TEST(Design, NamesElements)
{
    Patch patch;
    patch.name = "Seat";
    EXPECT_EQ(elementLabel(ElementId{2}, patch), "patch 2 \"Seat\"");
    EXPECT_EQ(elementLabel(ElementId{4}, FixationSeam{}), "fixation seam 4");
    EXPECT_EQ(elementLabel(settingsId, Settings{}), "settings");
    EXPECT_EQ(elementLabel(ElementId{9}, Quarantined{}), "element 9");
    EXPECT_STREQ(kindName(FixationCurve{}), "fixation_curve");
}

TEST(Patch, TurnsAndMovesIntoTheLayout)
{
    Patch patch;
    patch.position = Vec2(100, 50);
    patch.rotation = 90;
    EXPECT_LT((toLayout(patch, Vec2(10, 0)) - Vec2(100, 60)).norm(), 1e-12);
    EXPECT_LT((fromLayout(patch, toLayout(patch, Vec2(3, 4))) - Vec2(3, 4)).norm(), 1e-12);
}

TEST(Frame, PlacesFilePoints)
{
    Frame frame;
    frame.scale = 2;
    frame.position = Vec3(0, 0, 5);
    frame.rotation = Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX()));
    EXPECT_LT((frame.placed(Vec3(1, 1, 0)) - Vec3(2, 0, 7)).norm(), 1e-12);
}

TEST(Scan, CutsAwayWhatLiesInsideOrOutside)
{
    Scan scan;
    EXPECT_FALSE(scan.isCutAway(Vec3(0, 0, 0)));
    const ScanCut floor{{{Vec3::UnitZ(), 5}}, false};
    const ScanCut slab{{{Vec3(2, 0, 0), 20}, {Vec3(-2, 0, 0), 20}}, true};
    scan.cuts = {floor, slab};
    EXPECT_TRUE(scan.isCutAway(Vec3(0, 0, 5)));
    EXPECT_FALSE(scan.isCutAway(Vec3(0, 0, 5.1)));
    EXPECT_FALSE(scan.isCutAway(Vec3(-10, 99, 6)));
    EXPECT_TRUE(scan.isCutAway(Vec3(10.1, 0, 6)));
}

TEST(Frame, FilesStayInTheDesignsFolder)
{
    for (const char* good :
         {"armchair.obj", "meshes/armchair.obj", "a b.obj", "..a.obj", "St\xC3\xBChle/x.ply", "./a.obj"})
        EXPECT_FALSE(elementFileProblem(good)) << good;
    for (const char* bad : {"", "/etc/passwd", "../a.obj", "a/../../b.obj", "a/..", "..", "C:\\a.obj", "c:a.obj",
                            "..\\a.obj", "\\\\host\\a.obj", "a\nb.obj"})
        EXPECT_TRUE(elementFileProblem(bad)) << bad;
    EXPECT_TRUE(elementFileProblem(std::string("a\0b", 3)));
}

TEST(Stretch, EndsBehindItsBeginning)
{
    EXPECT_EQ(unwrappedEnd(1, 2, 0, 4), 2);
    EXPECT_EQ(unwrappedEnd(3, 1, 0, 4), 5);
    EXPECT_EQ(unwrappedEnd(2, 2, 0, 4), 6);
    EXPECT_EQ(unwrappedEnd(3, 0, 0, 4), 4);
}

} // namespace
} // namespace bolster
