// Workers and the bounded cache.
#include "engine/core/jobs.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>

#include "engine/core/lru_cache.h"

namespace luftpost::core {
namespace {
TEST(Jobs, RunTheMostUrgentFirst) {
    Jobs jobs{0};
    std::string order;
    jobs.submit(2.0, [&] { order += 'c'; });
    jobs.submit(1.0, [&] { order += 'a'; });
    jobs.submit(1.0, [&] { order += 'b'; });
    jobs.submit(-5.0, [&] { order += 'x'; });
    jobs.finish();
    EXPECT_EQ(order, "xabc");
    EXPECT_FALSE(jobs.help());
}

TEST(Jobs, ForgetWhatIsCancelledBeforeItBegins) {
    Jobs jobs{0};
    int ran = 0;
    Jobs::Ticket const first = jobs.submit(1.0, [&] { ran += 1; });
    Jobs::Ticket const second = jobs.submit(2.0, [&] { ran += 10; });
    EXPECT_TRUE(jobs.cancel(second));
    jobs.finish();
    EXPECT_EQ(ran, 1);
    EXPECT_FALSE(jobs.cancel(first));
}

TEST(Jobs, AreAllDoneOnceWhenFinished) {
    Jobs jobs{3};
    std::atomic<int> sum = 0;
    for (int i = 1; i <= 1000; ++i) jobs.submit(i % 7, [&sum, i] { sum += i; });
    jobs.finish();
    EXPECT_EQ(sum, 500500);
}

TEST(Jobs, MayQueueFurtherJobs) {
    Jobs jobs{2};
    std::atomic<int> ran = 0;
    for (int i = 0; i < 20; ++i) jobs.submit(0.0, [&] { jobs.submit(1.0, [&] { ++ran; }); });
    jobs.finish();
    EXPECT_EQ(ran, 20);
}

TEST(LruCache, ForgetsWhatWasUsedLongestAgo) {
    LruCache<int, std::string> cache{30};
    cache.insert(1, "one", 10);
    cache.insert(2, "two", 10);
    cache.insert(3, "three", 10);
    ASSERT_NE(cache.find(1), nullptr);
    std::string gone;
    cache.insert(4, "four", 10, [&](int, std::string& value) { gone = value; });
    EXPECT_EQ(gone, "two");
    EXPECT_TRUE(cache.contains(1));
    EXPECT_FALSE(cache.contains(2));
    EXPECT_EQ(cache.evicted(), 1u);
}

TEST(LruCache, NeverHoldsMoreThanItsCapacity) {
    LruCache<int, int> cache{1000};
    for (int i = 0; i < 500; ++i) {
        cache.insert(i, i, static_cast<std::size_t>(37 + i * 13 % 211));
        EXPECT_LE(cache.bytes(), 1000u);
    }
    EXPECT_LE(cache.peakBytes(), 1000u);
    EXPECT_GT(cache.peakBytes(), 700u);
    EXPECT_FALSE(cache.insert(1000, 1, 1001));
    EXPECT_GT(cache.size(), 0u);
}

TEST(LruCache, CountsAnEntryOnceWhenItIsReplaced) {
    LruCache<int, int> cache{100};
    cache.insert(7, 1, 60);
    cache.insert(7, 2, 70);
    EXPECT_EQ(cache.bytes(), 70u);
    EXPECT_EQ(*cache.peek(7), 2);
    EXPECT_EQ(cache.evicted(), 0u);
    EXPECT_TRUE(cache.erase(7));
    EXPECT_EQ(cache.bytes(), 0u);
}
}  // namespace
}  // namespace luftpost::core
