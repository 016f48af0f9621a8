// Only the newest request counts, whoever asks and however fast.
#include "LatestThread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <semaphore>
#include <vector>

namespace bolster {
namespace {

/// Results in the order in which they came.
struct Came {
    void operator()(int result)
    {
        const std::lock_guard lock(mutex);
        results.push_back(result);
        wake.notify_all();
    }
    void waitFor(int result)
    {
        std::unique_lock lock(mutex);
        wake.wait(lock, [&] { return !results.empty() && results.back() == result; });
    }

    std::mutex mutex;
    std::condition_variable wake;
    std::vector<int> results;
};

using Thread = LatestThread<int, int>;

TEST(LatestThread, TakesTheNewestOfWhatWaits)
{
    Came came;
    std::binary_semaphore begun{0}, goOn{0};
    Thread thread(
        [&](int request, const std::stop_token&) {
            begun.release();
            goOn.acquire();
            return request;
        },
        std::ref(came));
    thread.request(1);
    begun.acquire();
    for (int later = 2; later <= 9; ++later)
        thread.request(later);
    goOn.release();
    begun.acquire();
    goOn.release();
    came.waitFor(9);
    EXPECT_EQ(came.results, (std::vector<int>{1, 9}));
}

TEST(LatestThread, StopsWhatRunsIfToldTo)
{
    Came came;
    std::binary_semaphore begun{0};
    Thread thread(
        [&](int request, const std::stop_token& stop) {
            begun.release();
            while (request < 2 && !stop.stop_requested())
                std::this_thread::yield();
            return request;
        },
        std::ref(came));
    thread.request(1);
    begun.acquire();
    thread.request(2, true);
    came.waitFor(2);
    EXPECT_EQ(came.results, std::vector<int>{2}) << "nobody wants the first one any more";
}

TEST(LatestThread, EndsWithItsOwner)
{
    std::atomic<int> running = 0;
    Came came;
    auto held = std::make_shared<int>(0);
    const std::weak_ptr<int> watched = held;
    for (int round = 0; round < 200; ++round) {
        Thread thread(
            [&running, held](int request, const std::stop_token& stop) {
                ++running;
                while (!stop.stop_requested())
                    std::this_thread::yield();
                --running;
                return request;
            },
            std::ref(came));
        thread.request(round);
        if (round % 2 == 0)
            thread.request(round, true);
    }
    EXPECT_EQ(running, 0);
    EXPECT_TRUE(came.results.empty());
    held.reset();
    EXPECT_TRUE(watched.expired()) << "and so does what the work holds";
}

TEST(LatestThread, ServesSeveralThreads)
{
    constexpr int askers = 4, each = 500;
    Came came;
    std::size_t worked = 0; // only the thread counts
    {
        Thread thread(
            [&](int request, const std::stop_token&) {
                ++worked;
                return request;
            },
            std::ref(came));
        {
            std::vector<std::jthread> threads;
            for (int a = 0; a < askers; ++a)
                threads.emplace_back([&, a] {
                    for (int i = 1; i <= each; ++i)
                        thread.request(a * each + i, i % 3 == 0);
                });
        }
        thread.request(-1);
        came.waitFor(-1);
    }
    EXPECT_LE(worked, std::size_t{askers * each + 1});
    EXPECT_LE(came.results.size(), worked);
}

} // namespace
} // namespace bolster
