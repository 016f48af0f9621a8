// Widgets without a screen: what they draw is looked at as an image.
#include <QApplication>

#include <gtest/gtest.h>

int main(int argc, char* argv[])
{
    if (qEnvironmentVariableIsEmpty("BOLSTER_TEST_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    testing::InitGoogleTest(&argc, argv);
    if (GTEST_FLAG_GET(list_tests))
        return RUN_ALL_TESTS(); // at build time, when there may be no screen
    const QApplication application(argc, argv);
    return RUN_ALL_TESTS();
}
