#include "cli/measure_results.hpp"

#include <charconv>
#include <map>
#include <sstream>

#include "city_db/issues.hpp"
#include "sectorgen/geo/csv_fields.hpp"

namespace vicus::measure {
namespace {

/// Visits every field of a row under its name: the one list that writer and reader share.
template <class Row, class Visit>
void each_field(Row& r, Visit visit) requires std::is_same_v<std::remove_const_t<Row>, ViewRow> {
  visit("city", r.city), visit("version", r.version), visit("seed", r.seed);
  visit("family", r.family), visit("setting", r.setting), visit("tau_px", r.tau_px);
  visit("path", r.path), visit("view", r.view), visit("along_m", r.along_m);
  visit("width", r.width), visit("height", r.height);
  visit("bytes", r.bytes), visit("requests", r.requests);
  visit("new_bytes", r.new_bytes), visit("new_requests", r.new_requests), visit("memory_bytes", r.memory_bytes);
  auto& e = r.errors;
  visit("depth_mean_px", e.depth_mean_px), visit("depth_p99_px", e.depth_p99_px), visit("depth_max_px", e.depth_max_px);
  visit("silhouette_iou", e.silhouette_iou);
  visit("skyline_mean_px", e.skyline_mean_px), visit("skyline_max_px", e.skyline_max_px);
  visit("psnr_db", e.psnr_db), visit("ssim", e.ssim);
  visit("flip", e.flip), visit("flip_p99", e.flip_p99), visit("flip_houses", e.flip_houses);
}

template <class Row, class Visit>
void each_field(Row& r, Visit visit) requires std::is_same_v<std::remove_const_t<Row>, TimeRow> {
  visit("family", r.family), visit("setting", r.setting), visit("path", r.path), visit("view", r.view);
  visit("width", r.width), visit("height", r.height);
  visit("decode_cpu_ms", r.decode_cpu_ms), visit("draw_cpu_ms", r.draw_cpu_ms);
}

template <class Row, class Visit>
void each_field(Row& r, Visit visit) requires std::is_same_v<std::remove_const_t<Row>, PopRow> {
  visit("family", r.family), visit("setting", r.setting), visit("path", r.path);
  visit("width", r.width), visit("height", r.height), visit("along_m", r.along_m), visit("switches", r.switches);
  visit("change", r.change), visit("true_change", r.true_change);
}

template <class Row, class Visit>
void each_field(Row& r, Visit visit) requires std::is_same_v<std::remove_const_t<Row>, CodecRow> {
  visit("content", r.content), visit("codec", r.codec), visit("setting", r.setting);
  visit("bytes", r.bytes), visit("flip", r.flip), visit("views", r.views);
}

std::string text_of(const std::string& value) {
  if (value.find_first_of(",\"\n") == std::string::npos) return value;
  std::string out = "\"";
  for (const char c : value) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}
std::string text_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.7g", value);
  return text;
}
template <class Whole>
requires std::is_integral_v<Whole> std::string text_of(Whole value) { return std::to_string(value); }

template <class Row>
std::string written(const std::vector<Row>& rows, const std::string& last_column = {}) {
  std::string out;
  const auto line = [&](const Row& row, bool is_head) {
    std::string text;
    bool is_first = true;
    each_field(row, [&](const char* name, const auto& value) {
      text += (is_first ? "" : ",") + (is_head ? std::string(name) : text_of(value));
      is_first = false;
    });
    if (!last_column.empty()) text += "," + (is_head ? last_column : "");
    out += text + "\n";
  };
  line(Row{}, true);
  for (const Row& row : rows) line(row, false);
  return out;
}

void read_value(const std::string& text, std::string& value) { value = text; }
template <class Number>
requires std::is_arithmetic_v<Number>
void read_value(const std::string& text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    throw CityError("measured CSV: expected a number, found '" + text + "'");
}

template <class Row>
std::vector<Row> read(const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  if (!std::getline(lines, line)) throw CityError("measured CSV: expected a line of names, found nothing");
  std::map<std::string, std::size_t> columns;
  const auto fields_of = [](const std::string& text) {
    auto fields = csv_fields(text);
    if (!fields) throw CityError("measured CSV: quotation marks do not match: " + text);
    return std::move(*fields);
  };
  const auto names = fields_of(line);
  for (std::size_t i = 0; i < names.size(); ++i) columns[names[i]] = i;
  std::vector<Row> rows;
  while (std::getline(lines, line)) {
    const auto fields = fields_of(line);
    rows.emplace_back();
    each_field(rows.back(), [&](const char* name, auto& value) {
      const auto at = columns.find(name);
      if (at == columns.end()) throw CityError(std::string("measured CSV: lacks the column ") + name);
      if (at->second >= fields.size()) throw CityError("measured CSV: a line is cut off: " + line);
      read_value(fields[at->second], value);
    });
  }
  return rows;
}

}  // namespace

std::string csv_of(const std::vector<ViewRow>& rows) { return written(rows); }
std::string csv_of(const std::vector<TimeRow>& rows) { return written(rows, "gpu_ms"); }
std::string csv_of(const std::vector<PopRow>& rows) { return written(rows); }
std::string csv_of(const std::vector<CodecRow>& rows) { return written(rows); }

std::vector<ViewRow> views_from_csv(const std::string& text) { return read<ViewRow>(text); }
std::vector<TimeRow> times_from_csv(const std::string& text) { return read<TimeRow>(text); }
std::vector<PopRow> pops_from_csv(const std::string& text) { return read<PopRow>(text); }
std::vector<CodecRow> codecs_from_csv(const std::string& text) { return read<CodecRow>(text); }

}  // namespace vicus::measure
