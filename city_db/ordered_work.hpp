#pragma once
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

namespace vicus {

/// Items 0 ... count - 1, made by threads of its own while whoever takes them in order does something else with those
/// he has: nobody waits for the slowest of a batch.
template <class Item>
class OrderedWork {
 public:
  /// `ahead`: at most so many items are made, or in the making, and not taken.   Needs   threads, ahead >= 1.
  OrderedWork(std::size_t count, unsigned threads, std::size_t ahead, std::function<Item(std::size_t)> make)
      : count_(count), make_(std::move(make)), slots_(ahead) {
    for (unsigned t = 0; t < threads && t < count; ++t) threads_.emplace_back([this] { run(); });
  }
  OrderedWork(const OrderedWork&) = delete;
  OrderedWork& operator=(const OrderedWork&) = delete;
  /// Waits for what is in the making, no more.
  ~OrderedWork() {
    {
      const std::lock_guard lock(mutex_);
      begun_ = count_;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  bool is_done() const { return taken_ == count_; }
  /// The next one.   Needs   !is_done().   Fails   as making it did.
  Item take() {
    std::unique_lock lock(mutex_);
    Slot& slot = slots_[taken_ % slots_.size()];
    changed_.wait(lock, [&] { return slot.index() != 0; });
    Slot made = std::exchange(slot, std::monostate());
    ++taken_;
    changed_.notify_all();
    if (const auto* failure = std::get_if<std::exception_ptr>(&made)) std::rethrow_exception(*failure);
    return std::move(std::get<Item>(made));
  }

 private:
  using Slot = std::variant<std::monostate, Item, std::exception_ptr>;

  void run() {
    std::unique_lock lock(mutex_);
    for (;;) {
      changed_.wait(lock, [&] { return begun_ >= count_ || begun_ < taken_ + slots_.size(); });
      if (begun_ >= count_) return;
      const std::size_t i = begun_++;
      lock.unlock();
      Slot made = attempt(i);
      lock.lock();
      slots_[i % slots_.size()] = std::move(made);
      changed_.notify_all();
    }
  }

  Slot attempt(std::size_t i) const {
    try {
      return make_(i);
    } catch (...) {
      return std::current_exception();
    }
  }

  const std::size_t count_;
  const std::function<Item(std::size_t)> make_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Slot> slots_;  // item i in slot i % size, from when it is made until it is taken
  std::size_t begun_ = 0, taken_ = 0;
  std::vector<std::thread> threads_;
};

}  // namespace vicus
