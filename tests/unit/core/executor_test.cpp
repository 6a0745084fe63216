#include "core/executor.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace {

using hsp::Executor;

bool in_order(void *, uint32_t tasks, Executor::Task *task, void *data) {
  for (uint32_t k = 0; k < tasks; ++k) task(data, k);
  return true;
}
bool last_first(void *, uint32_t tasks, Executor::Task *task, void *data) {
  while (tasks-- > 0) task(data, tasks);
  return true;
}
bool forgets_one(void *context, uint32_t tasks, Executor::Task *task, void *data) {
  for (uint32_t k = 0; k < tasks; ++k) {
    if (k != *static_cast<uint32_t *>(context)) task(data, k);
  }
  return true;
}
bool does_one_twice(void *context, uint32_t tasks, Executor::Task *task, void *data) {
  for (uint32_t k = 0; k < tasks; ++k) {
    task(data, k);
    if (k == *static_cast<uint32_t *>(context)) task(data, k);
  }
  return true;
}
// The first instead of the last.
bool does_one_for_another(void *, uint32_t tasks, Executor::Task *task, void *data) {
  for (uint32_t k = 0; k + 1 < tasks; ++k) task(data, k);
  task(data, 0);
  return true;
}
bool adds_one(void *, uint32_t tasks, Executor::Task *task, void *data) {
  for (uint32_t k = 0; k <= tasks; ++k) task(data, k);
  return true;
}

struct Outcome {
  bool each;
  std::vector<int> times;
};

Outcome outcome_of(const Executor &executor, uint32_t tasks) {
  std::vector<int> times(tasks);
  const bool each = executor.for_each(tasks, [&times](uint32_t task) { ++times[task]; });
  return {each, times};
}

TEST(Executor, OneWorkerTakesNoLoop) {
  for (const Executor &executor : {Executor(), Executor(0, nullptr, nullptr), Executor(1, nullptr, nullptr)}) {
    EXPECT_EQ(executor.workers(), 1U);
    const Outcome outcome = outcome_of(executor, 5);
    EXPECT_TRUE(outcome.each);
    EXPECT_EQ(outcome.times, std::vector<int>(5, 1));
  }
}

TEST(Executor, EachTaskIsDoneOnceInAnyOrder) {
  for (Executor::Run *run : {in_order, last_first}) {
    for (const uint32_t tasks : {0U, 1U, 2U, 17U, hsp::max_tasks}) {
      const Outcome outcome = outcome_of(Executor(3, run, nullptr), tasks);
      EXPECT_TRUE(outcome.each);
      EXPECT_EQ(outcome.times, std::vector<int>(tasks, 1));
    }
  }
  EXPECT_EQ(Executor(UINT32_MAX, in_order, nullptr).workers(), hsp::max_tasks);
}

TEST(Executor, WrongLoopsAreRefused) {
  constexpr uint32_t tasks = 6;
  for (uint32_t which = 0; which < tasks; ++which) {
    Outcome outcome = outcome_of(Executor(2, forgets_one, &which), tasks);
    EXPECT_FALSE(outcome.each);
    EXPECT_EQ(outcome.times[which], 0);
    outcome = outcome_of(Executor(2, does_one_twice, &which), tasks);
    EXPECT_FALSE(outcome.each);
    EXPECT_EQ(outcome.times, std::vector<int>(tasks, 1));
  }
  const Outcome more = outcome_of(Executor(2, adds_one, nullptr), tasks);
  EXPECT_FALSE(more.each);
  EXPECT_EQ(more.times, std::vector<int>(tasks, 1));
  EXPECT_FALSE(outcome_of(Executor(2, does_one_for_another, nullptr), tasks).each);
}

TEST(Executor, ALoopThatSaysItFailedHasFailed) {
  const auto all_and_fails = [](void *, uint32_t count, Executor::Task *task, void *data) {
    for (uint32_t k = 0; k < count; ++k) task(data, k);
    return false;
  };
  const Executor executor(2, all_and_fails, nullptr);
  EXPECT_FALSE(executor.for_each(3, [](uint32_t) {}));
  EXPECT_EQ(executor.failure(), hsp::Status::executor);
}

TEST(Executor, TasksThatThreadsCallTogetherAreDoneOnce) {
  constexpr uint32_t threads = 4, tasks = 40;
  const auto all_by_each = [](void *, uint32_t count, Executor::Task *task, void *data) {
    std::vector<std::thread> others;
    for (uint32_t t = 0; t < threads; ++t) {
      others.emplace_back([=] {
        for (uint32_t k = 0; k < count; ++k) task(data, k);
      });
    }
    for (std::thread &other : others) other.join();
    return true;
  };
  for (int round = 0; round < 50; ++round) {
    std::vector<std::atomic<int>> times(tasks);
    EXPECT_FALSE(Executor(threads, all_by_each, nullptr).for_each(tasks, [&times](uint32_t task) { ++times[task]; }));
    for (const std::atomic<int> &own : times) EXPECT_EQ(own, 1);
  }
}

}  // namespace
