// What the mouse does to the views, by preset.
#include "MouseStyle.h"
#include "CoverSetup.h"
#include "CoverView.h"
#include "Document.h"
#include "PatternView.h"
#include "ProblemSet.h"
#include "Selection.h"

#include <QApplication>
#include <QWheelEvent>

#include <gtest/gtest.h>

namespace bolster {
namespace {

class MouseStyleTest : public testing::Test {
protected:
    MouseStyleTest()
    {
        document.reset(test::twoSquares());
        cover.setSoftwareRenderer(std::make_unique<test::StubRenderer>(log));
        cover.resize(800, 600);
        pattern.resize(800, 600);
        cover.show();
        pattern.show();
        cover.shown().setSurface(test::twoSquaresCover());
        QApplication::processEvents();
        cover.navigation().setAnimated(false);
        cover.navigation().fitAll();
        pattern.navigation().fitAll();
    }
    ~MouseStyleTest() override { MouseStyles::instance().set({}); }

    static void use(const QString& id, bool invertZoom = false)
    {
        for (const MousePreset& preset : mousePresets())
            if (id == QLatin1String(preset.id))
                MouseStyles::instance().set({&preset, invertZoom});
    }

    /// What a drag does to the camera.
    ViewMove inCover(Qt::MouseButton button, Qt::KeyboardModifiers keys = {})
    {
        cover.navigation().setStandardView(CoverView::StandardView::ThreeQuarter);
        const Camera before = cover.navigation().camera();
        test::Mouse(cover).drag({400, 300}, {440, 340}, button, keys);
        const Camera& now = cover.navigation().camera();
        if (now.azimuth != before.azimuth || now.elevation != before.elevation)
            return ViewMove::Turn;
        if (std::abs(now.distance - before.distance) > 1e-9)
            return ViewMove::Zoom;
        return now.target.isApprox(before.target) ? ViewMove::None : ViewMove::Pan;
    }

    ViewMove inPattern(Qt::MouseButton button, Qt::KeyboardModifiers keys = {})
    {
        const PatternTransform before = pattern.navigation().transform();
        test::Mouse(pattern).drag({400, 300}, {440, 340}, button, keys);
        const PatternTransform now = pattern.navigation().transform();
        if (now.scale() != before.scale())
            return ViewMove::Zoom;
        return now.toPixels({0, 0}) == before.toPixels({0, 0}) ? ViewMove::None : ViewMove::Pan;
    }

    static void wheel(QWidget& view, QPoint by, Qt::KeyboardModifiers keys = {})
    {
        const QPointF at(300, 300);
        QWheelEvent event(at, view.mapToGlobal(at), {}, by, Qt::NoButton, keys, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&view, &event);
    }

    std::shared_ptr<test::StubRenderer::Log> log = std::make_shared<test::StubRenderer::Log>();
    Document document;
    Selection selection;
    ProblemSet problems;
    CoverView cover{document, selection};
    PatternView pattern{document, selection, problems};
};

constexpr auto ctrl = Qt::ControlModifier, shift = Qt::ShiftModifier, alt = Qt::AltModifier;

TEST_F(MouseStyleTest, ThePresetsMoveTheCamera)
{
    const struct {
        const char* preset;
        Qt::MouseButton button;
        Qt::KeyboardModifiers keys;
        ViewMove move;
    } rows[] = {
        {"bolster", Qt::MiddleButton, {}, ViewMove::Turn},
        {"bolster", Qt::RightButton, {}, ViewMove::Turn},
        {"bolster", Qt::MiddleButton, shift, ViewMove::Pan},
        {"bolster", Qt::LeftButton, alt, ViewMove::Turn},
        {"cad", Qt::MiddleButton, {}, ViewMove::Turn},
        {"cad", Qt::MiddleButton, ctrl, ViewMove::Pan},
        {"cad", Qt::MiddleButton, shift, ViewMove::Zoom},
        {"cad", Qt::RightButton, {}, ViewMove::None},
        {"blender", Qt::MiddleButton, {}, ViewMove::Turn},
        {"blender", Qt::MiddleButton, shift, ViewMove::Pan},
        {"blender", Qt::MiddleButton, ctrl, ViewMove::Zoom},
        {"blender", Qt::LeftButton, alt | ctrl, ViewMove::Zoom},
        {"clo", Qt::RightButton, {}, ViewMove::Turn},
        {"clo", Qt::MiddleButton, {}, ViewMove::Pan},
        {"touchpad", Qt::LeftButton, alt, ViewMove::Turn},
        {"touchpad", Qt::LeftButton, alt | shift, ViewMove::Pan},
    };
    for (const auto& row : rows) {
        use(QString::fromLatin1(row.preset));
        EXPECT_EQ(inCover(row.button, row.keys), row.move)
            << row.preset << ", button " << row.button << ", keys " << row.keys.toInt();
    }
}

TEST_F(MouseStyleTest, ThePresetsMoveThePattern)
{
    for (const MousePreset& preset : mousePresets()) {
        use(QString::fromLatin1(preset.id));
        EXPECT_EQ(inPattern(Qt::MiddleButton), ViewMove::Pan) << preset.id;
        EXPECT_EQ(inPattern(Qt::RightButton), ViewMove::None) << preset.id;
    }
    use(QStringLiteral("cad"));
    EXPECT_EQ(inPattern(Qt::MiddleButton, shift), ViewMove::Zoom);
    use(QStringLiteral("blender"));
    EXPECT_EQ(inPattern(Qt::MiddleButton, ctrl), ViewMove::Zoom);
    EXPECT_EQ(inPattern(Qt::MiddleButton, shift), ViewMove::Pan);
}

TEST_F(MouseStyleTest, TheWheelZoomsOrPans)
{
    const auto distance = [&] { return cover.navigation().camera().distance; };
    const auto scale = [&] { return pattern.navigation().transform().scale(); };
    for (const bool inverted : {false, true}) {
        use(QStringLiteral("bolster"), inverted);
        const double far = distance(), large = scale();
        wheel(cover, {0, 120});
        wheel(pattern, {0, 120});
        EXPECT_EQ(distance() < far, !inverted);
        EXPECT_EQ(scale() > large, !inverted);
    }
    use(QStringLiteral("touchpad"));
    const double far = distance(), large = scale();
    const Vec3 target = cover.navigation().camera().target;
    const QPointF origin = pattern.navigation().transform().toPixels({0, 0});
    wheel(cover, {60, 120});
    wheel(pattern, {60, 120});
    EXPECT_DOUBLE_EQ(distance(), far);
    EXPECT_FALSE(cover.navigation().camera().target.isApprox(target));
    EXPECT_DOUBLE_EQ(scale(), large);
    EXPECT_EQ(pattern.navigation().transform().toPixels({0, 0}), origin + QPointF(30, 60));
    wheel(cover, {0, 120}, ctrl);
    wheel(pattern, {0, 120}, ctrl);
    EXPECT_LT(distance(), far);
    EXPECT_GT(scale(), large);
}

TEST_F(MouseStyleTest, WhatIsToldFollows)
{
    EXPECT_TRUE(cover.prompt().contains(QStringLiteral("Shift+middle button pans, wheel zooms")));
    EXPECT_TRUE(pattern.prompt().contains(QStringLiteral("middle button or Space pans, wheel zooms")));
    use(QStringLiteral("clo"));
    EXPECT_TRUE(cover.prompt().contains(QStringLiteral(" middle button pans"))) << cover.prompt().toStdString();
    use(QStringLiteral("touchpad"));
    EXPECT_TRUE(pattern.prompt().contains(QStringLiteral("two fingers or Space pans")));
    for (const MousePreset& preset : mousePresets()) {
        use(QString::fromLatin1(preset.id));
        for (const ViewMove move : {ViewMove::Turn, ViewMove::Pan, ViewMove::Zoom})
            EXPECT_FALSE(mouseText(MouseView::Cover, move).isEmpty()) << preset.id;
    }
}

TEST(MousePresets, NoDragMeansTwoThings)
{
    for (const MousePreset& preset : mousePresets())
        for (const auto* table : {&preset.cover, &preset.pattern})
            for (std::size_t i = 0; i < table->size(); ++i)
                for (std::size_t k = 0; k < i; ++k)
                    EXPECT_FALSE((*table)[i].button == (*table)[k].button && (*table)[i].keys == (*table)[k].keys)
                        << preset.id << ": " << i << " and " << k;
}

} // namespace
} // namespace bolster
