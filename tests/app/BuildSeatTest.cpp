// A small seat with two bolsters from an empty project: every step by pointer and keys.
#include "BuildTest.h"
#include "TestPaths.h"

namespace bolster {
namespace {

class BuildSeatTest : public BuildTest {
protected:
    bool has(const char* name)
    {
        bool found = false;
        design().each<Frame>([&](ElementId, const Frame& frame) { found = found || frame.name == name; });
        return found;
    }

    void importFrame()
    {
        designer.answerFileDialog(QString::fromStdString(test::dataFolder() + "/designs/seat-pan.obj"));
        designer.key(Qt::Key_I, Qt::ControlModifier);
        ASSERT_TRUE(QTest::qWaitFor([this] { return has("seat-pan"); }, 20000));
    }

    /// The insert is its own mirror image; the bolster has a bulging side.
    void drawPatches()
    {
        designer.drawRectangle({-150, -200}, QStringLiteral("300 x 400"));
        designer.rename(QStringLiteral("Insert"));
        designer.key(Qt::Key_O);
        designer.click({-310, -200});
        designer.click({-190, -200});
        designer.click({-190, 200});
        designer.click({-310, 200});
        designer.drag({-330, 0}, {-330, -80});
        designer.key(Qt::Key_Return);
        designer.rename(QStringLiteral("Left bolster"));
    }

    void sewBolster()
    {
        designer.key(Qt::Key_W);
        designer.sew({-190, 0}, {-150, 0});
        designer.key(Qt::Key_Escape);
        designer.choose({QStringLiteral("Seam"), QStringLiteral("G1 \u2013 rounded")});
    }

    void fix(const QString& name, const QString& from, const QString& to, const Vec2& edge)
    {
        designer.typeFixation({from, to}, false);
        designer.rename(name);
        ASSERT_TRUE(waitUntilSolved());
        designer.key(Qt::Key_A, Qt::ShiftModifier);
        designer.click(edge);
        designer.key(Qt::Key_Escape); // else the next click would fix another edge
    }

    void decorate()
    {
        designer.key(Qt::Key_N);
        designer.click({-100, -140});
        designer.click({-100, 140});
        designer.key(Qt::Key_Return);
        designer.setField(QStringLiteral("Width"), QStringLiteral("1 cm"));
    }
};

TEST_F(BuildSeatTest, FromNothingByPointerAndKeys)
{
    importFrame();
    drawPatches();
    sewBolster();
    ASSERT_TRUE(waitUntilAtRest()); // edges are fixed to what they are near
    fix(QStringLiteral("Left rail"), QStringLiteral("-230, 200, 10"), QStringLiteral("-230, -200"), {-330, 0});
    fix(QStringLiteral("Front rail"), QStringLiteral("-145, -205, 90"), QStringLiteral("145, -205"), {0, -200});
    fix(QStringLiteral("Rear rail"), QStringLiteral("-145, 195, 90"), QStringLiteral("145, 195"), {0, 200});
    designer.pick(QStringLiteral("Left bolster"));
    designer.choose(
        {QStringLiteral("Pattern"), QStringLiteral("Mirror twins"), QStringLiteral("Make mirror twin")});
    decorate();
    designer.choose({QStringLiteral("Insert"), QStringLiteral("Cushion")});
    designer.setField(QStringLiteral("Padding"), QStringLiteral("40"));
    expectBuilt(QStringLiteral("built-seat.json"));
}

} // namespace
} // namespace bolster
