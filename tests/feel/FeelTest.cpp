// A few of the gestures of bolster_feel: whatever somebody does, the design is what its history says.
#include "FeelRecorder.h"
#include "FeelWindow.h"

#include "Document.h"

#include <gtest/gtest.h>

namespace bolster {
namespace {

TEST(Feel, AfterAnyGesturesTheDesignEqualsItsReplay)
{
    const std::unique_ptr<MainWindow> window = openCarSeat(false, 200000);
    ASSERT_TRUE(window);
    FeelPlayer player(*static_cast<FeelApplication*>(qApp), *window);
    FeelRecorder recorder(*window, player, 1);
    recorder.makeGestures(12);
    EXPECT_GT(window->document().history().count(), 5);
    EXPECT_TRUE(equalsItsReplay(window->document()));
    for (const FeelEvent& event : recorder.script()) {
        const std::optional<FeelEvent> again = FeelEvent::read(event.line());
        ASSERT_TRUE(again) << event.line().toStdString();
        EXPECT_EQ(again->line(), event.line());
    }
    window->document().markSaved(); // no question on the way out
    window->close();
}

} // namespace
} // namespace bolster

int main(int argc, char* argv[])
{
    const bolster::FeelHome home;
    testing::InitGoogleTest(&argc, argv);
    if (GTEST_FLAG_GET(list_tests))
        return RUN_ALL_TESTS(); // at build time, when there may be no screen
    bolster::FeelApplication application(argc, argv);
    return RUN_ALL_TESTS();
}
