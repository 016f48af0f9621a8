// Work beside the windows, and those who wait for it.
#include "Background.h"

#include <QSemaphore>
#include <QTest>

#include <gtest/gtest.h>

namespace bolster {
namespace {

TEST(Background, BringsWhatWasMadeToItsReceiver)
{
    QObject receiver;
    int came = 0;
    inBackground<int>([] { return 7; }).then(&receiver, [&](int made) { came = made; });
    EXPECT_TRUE(QTest::qWaitFor([&] { return came == 7; }, 20000));
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_TRUE(receiver.children().isEmpty());
}

TEST(Background, LeavesAloneWhoDoesNotWaitAnyMore)
{
    QSemaphore goOn;
    bool called = false;
    auto receiver = std::make_unique<QObject>();
    inBackground<int>([&] {
        goOn.acquire();
        return 7;
    }).then(receiver.get(), [&](int) { called = true; });
    receiver.reset();
    goOn.release();
    backgroundPool().waitForDone();
    QCoreApplication::processEvents();
    EXPECT_FALSE(called);
}

} // namespace
} // namespace bolster
