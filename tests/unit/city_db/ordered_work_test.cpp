#include "city_db/ordered_work.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <stdexcept>

namespace vicus {
namespace {

TEST(OrderedWork, GivesEveryItemInOrderWhateverItsTimeTakes) {
  for (const unsigned threads : {1u, 2u, 5u}) {
    OrderedWork<std::size_t> work(200, threads, 7, [](std::size_t i) {
      if (i % 13 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
      return i * i;
    });
    for (std::size_t i = 0; i < 200; ++i) {
      ASSERT_FALSE(work.is_done());
      EXPECT_EQ(work.take(), i * i);
    }
    EXPECT_TRUE(work.is_done());
  }
  EXPECT_TRUE(OrderedWork<int>(0, 4, 1, [](std::size_t) { return 0; }).is_done());
}

TEST(OrderedWork, IsNeverFartherAheadThanItMayBe) {
  std::atomic<int> begun{0};
  OrderedWork<std::unique_ptr<int>> work(100, 4, 6, [&](std::size_t i) {
    ++begun;
    return std::make_unique<int>(static_cast<int>(i));
  });
  for (int taken = 0; taken < 100; ++taken) {
    if (taken % 20 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_LE(begun.load(), taken + 6);
    EXPECT_EQ(*work.take(), taken);
  }
  EXPECT_EQ(begun.load(), 100);
}

TEST(OrderedWork, FailsWhereMakingAnItemFailedAndEndsBeforeAllAreTaken) {
  std::atomic<int> made{0};
  {
    OrderedWork<int> work(1000, 3, 4, [&](std::size_t i) {
      ++made;
      if (i == 5) throw std::runtime_error("the sixth");
      return static_cast<int>(i);
    });
    for (int i = 0; i < 5; ++i) EXPECT_EQ(work.take(), i);
    EXPECT_THROW(work.take(), std::runtime_error);
    EXPECT_EQ(work.take(), 6) << "the others are as they were";
  }
  EXPECT_LE(made.load(), 7 + 4);
}

}  // namespace
}  // namespace vicus
