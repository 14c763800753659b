#pragma once
#include <array>
#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <utility>

/// What operators watch: Prometheus text exposition format 0.0.4. Shared by all threads.
namespace vicus {

class Metrics {
 public:
  void count_answer(const char* route, int status, std::uint64_t bytes, double seconds);
  void connection_opened() { ++opened_, ++open_; }
  void connection_closed() { --open_; }
  void connection_refused() { ++refused_; }
  void city_reopened() { ++reopened_; }
  std::int64_t open_connections() const { return open_; }
  std::string text() const;

  /// Upper bounds of the latency histogram, seconds; +Inf follows.
  static constexpr std::array<double, 10> kBounds = {0.0005, 0.001, 0.0025, 0.005, 0.01, 0.025, 0.1, 0.25, 1, 5};

 private:
  struct Answers {
    std::uint64_t count = 0, bytes = 0;
  };
  mutable std::mutex mutex_;
  std::map<std::pair<std::string, int>, Answers> answers_;
  std::array<std::uint64_t, kBounds.size() + 1> within_{};
  double seconds_ = 0;
  std::atomic<std::int64_t> open_ = 0;
  std::atomic<std::uint64_t> opened_ = 0, refused_ = 0, reopened_ = 0;
};

}  // namespace vicus
