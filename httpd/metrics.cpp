#include "httpd/metrics.hpp"

#include <algorithm>
#include <charconv>

namespace vicus {
namespace {

std::string number(double value) {
  char text[400];  // the longest double in fixed notation
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed).ptr;
  return {text, end};
}

void head(std::string& out, const std::string& name, const char* type, const char* help) {
  out += "# HELP " + name + " " + help + "\n# TYPE " + name + " " + type + "\n";
}

}  // namespace

void Metrics::count_answer(const char* route, int status, std::uint64_t bytes, double seconds) {
  const auto bucket =
      static_cast<std::size_t>(std::lower_bound(kBounds.begin(), kBounds.end(), seconds) - kBounds.begin());
  const std::lock_guard lock(mutex_);
  auto& answers = answers_[{route, status}];
  ++answers.count;
  answers.bytes += bytes;
  ++within_[bucket];
  seconds_ += seconds;
}

std::string Metrics::text() const {
  const std::lock_guard lock(mutex_);
  std::string out;
  head(out, "vicus_requests_total", "counter", "Answers sent, by route and status.");
  const auto labels = [](const auto& key) {
    return "{route=\"" + key.first + "\",status=\"" + std::to_string(key.second) + "\"} ";
  };
  for (const auto& [key, answers] : answers_)
    out += "vicus_requests_total" + labels(key) + std::to_string(answers.count) + "\n";
  head(out, "vicus_sent_bytes_total", "counter", "Bytes sent, headers included, by route and status.");
  for (const auto& [key, answers] : answers_)
    out += "vicus_sent_bytes_total" + labels(key) + std::to_string(answers.bytes) + "\n";
  head(out, "vicus_request_seconds", "histogram", "From the end of the request's head to the last byte handed on.");
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < within_.size(); ++i) {
    sum += within_[i];
    const auto bound = i < kBounds.size() ? number(kBounds[i]) : "+Inf";
    out += "vicus_request_seconds_bucket{le=\"" + bound + "\"} " + std::to_string(sum) + "\n";
  }
  out +=
      "vicus_request_seconds_sum " + number(seconds_) + "\nvicus_request_seconds_count " + std::to_string(sum) + "\n";
  head(out, "vicus_open_connections", "gauge", "Connections open now.");
  out += "vicus_open_connections " + std::to_string(open_.load()) + "\n";
  head(out, "vicus_connections_total", "counter", "Connections accepted.");
  out += "vicus_connections_total " + std::to_string(opened_.load()) + "\n";
  head(out, "vicus_connections_refused_total", "counter", "Connections refused: too many open.");
  out += "vicus_connections_refused_total " + std::to_string(refused_.load()) + "\n";
  head(out, "vicus_city_reopened_total", "counter", "Times a thread opened a newly built city.");
  out += "vicus_city_reopened_total " + std::to_string(reopened_.load()) + "\n";
  return out;
}

}  // namespace vicus
