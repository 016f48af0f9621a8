// A box cushion from an empty project: every step by pointer and keys.
#include "BuildTest.h"

namespace bolster {
namespace {

class BuildCushionTest : public BuildTest {
protected:
    void drawPatches()
    {
        designer.pressButton(QStringLiteral("Rectangle")); // of the start page
        designer.click({0, 0});
        designer.enter(QStringLiteral("500 x 500"));
        designer.rename(QStringLiteral("Top"));
        const struct {
            const char* name;
            Vec2 corner;
            const char* size;
        } sides[] = {{"Front", {0, -140}, "500 x 100"},
                     {"Right", {540, 0}, "100 x 500"},
                     {"Rear", {0, 540}, "500 x 100"},
                     {"Left", {-140, 0}, "100 x 500"}};
        for (const auto& side : sides) {
            showAll();
            designer.zoom(-2); // room beside it
            designer.drawRectangle(side.corner, QString::fromLatin1(side.size));
            designer.rename(QString::fromLatin1(side.name));
        }
    }

    void showAll() { designer.choose({QStringLiteral("View"), QStringLiteral("Show all")}); }

    void sewSides()
    {
        showAll();
        designer.key(Qt::Key_W);
        designer.sew({250, 0}, {250, -40});
        designer.sew({500, 250}, {540, 250});
        designer.sew({250, 500}, {250, 540});
        designer.sew({0, 250}, {-40, 250});
        designer.sew({500, -90}, {590, 0});
        designer.sew({590, 500}, {500, 590});
        designer.sew({0, 590}, {-90, 500});
        designer.sew({-90, 0}, {0, -90});
        designer.key(Qt::Key_Escape);
    }

    void fixBottom()
    {
        designer.typeFixation({QStringLiteral("-250, -250, 0"), QStringLiteral("250, -250"),
                               QStringLiteral("250, 250"), QStringLiteral("-250, 250")},
                              true);
        designer.rename(QStringLiteral("Bottom edge"));
        designer.key(Qt::Key_A, Qt::ShiftModifier);
        designer.click({250, -140}, Qt::ShiftModifier);
        designer.click({640, 250}, Qt::ShiftModifier);
        designer.click({250, 640}, Qt::ShiftModifier);
        designer.click({-140, 250});
        designer.key(Qt::Key_Escape);
    }

    void setMaterial()
    {
        designer.choose({QStringLiteral("Edit"), QStringLiteral("Select all patches")});
        designer.setField(QStringLiteral("Pressure"), QStringLiteral("0.3"));
        designer.pick(QStringLiteral("Fabric"));
        designer.setField(QStringLiteral("Bending length"), QStringLiteral("10"));
    }
};

TEST_F(BuildCushionTest, FromNothingByPointerAndKeys)
{
    drawPatches();
    sewSides();
    ASSERT_TRUE(waitUntilAtRest()); // edges are fixed to what they are near
    fixBottom();
    setMaterial();
    expectBuilt(QStringLiteral("built-box-cushion.json"));
}

} // namespace
} // namespace bolster
