// What the pattern costs must not grow with the square of what is in it.
#include "Growth.h"
#include "PatternPainter.h"
#include "ProblemSet.h"
#include "SeamColors.h"
#include "Selection.h"

#include <QGuiApplication>
#include <QImage>
#include <QPainter>

#include <gtest/gtest.h>

namespace bolster {
namespace {

/// Small squares, each sewn to the next.
Design sewnSquares(int count)
{
    constexpr int perRow = 100;
    Edit edit{{}, {{ElementId{1}, nullptr, makeElement(Fabric{})}}};
    for (int k = 0; k < count; ++k) {
        Patch patch;
        patch.fabric = ElementId{1};
        patch.position = Vec2(15 * (k % perRow), 15 * (k / perRow));
        patch.outline = BSpline2(1, true, {{0, 0}, {10, 0}, {10, 10}, {0, 10}});
        edit.changes.push_back({ElementId{2 + k}, nullptr, makeElement(std::move(patch))});
    }
    for (int k = 0; k + 1 < count; ++k)
        edit.changes.push_back({ElementId{2 + count + k}, nullptr,
                                makeElement(Seam{{ElementId{2 + k}, 1, 2}, {ElementId{3 + k}, 3, 4}})});
    return Design().with(edit);
}

void paintPattern(const Design& design)
{
    PatternScene scene;
    scene.reset(design);
    const PatternMesh mesh;
    const PatternMap map;
    const Selection selection;
    const ProblemSet problems;
    const std::set<ElementId> none;
    const std::map<ElementId, QColor> colors = seamColors(design, false);
    QImage image(1600, 1600, QImage::Format_ARGB32_Premultiplied);
    const auto transform = PatternTransform::fitting(Box2(Vec2(0, 0), Vec2(1600, 1600)), image.size(), 0);
    QPainter painter(&image);
    const PatternPainter::Input input{scene,
                                      mesh,
                                      map,
                                      selection,
                                      problems,
                                      none,
                                      colors,
                                      transform,
                                      PatternLayers(),
                                      ViewColors::of(QPalette()),
                                      QFont(),
                                      image.size(),
                                      none,
                                      none};
    PatternPainter(painter, input).paint();
}

TEST(Growth, SewnPatchesAreDrawn)
{
    EXPECT_LT(test::growth(1000, sewnSquares, paintPattern), test::nearlyLinear);
}

} // namespace
} // namespace bolster
