#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/measure_errors.hpp"

/// What was measured, as records and as CSV files of one line of names and one line a record.
namespace vicus::measure {

/// One picture of one representation.
struct ViewRow {
  std::string city, version;
  std::uint64_t seed = 0;
  std::string family, setting;  ///< of the representation
  double tau_px = 0;            ///< 0: none
  std::string path;             ///< walk, fly, overview
  int view = 0;
  double along_m = 0;
  int width = 0, height = 0;
  std::uint64_t bytes = 0, requests = 0;          ///< of all files that show this view
  std::uint64_t new_bytes = 0, new_requests = 0;  ///< of those that no earlier view of the path had
  double memory_bytes = 0;
  ViewErrors errors;
};

/// CPU time of it, which no two runs have in common. GPU time: measured nowhere yet, the column stays empty.
struct TimeRow {
  std::string family, setting, path;
  int view = 0, width = 0, height = 0;
  double decode_cpu_ms = 0, draw_cpu_ms = 0;
};

/// One moment of a path at which a representation changes what it shows: the last frame before and the first after.
struct PopRow {
  std::string family, setting, path;
  int width = 0, height = 0;
  double along_m = 0;
  int switches = 0;        ///< of the whole path
  double change = 0;       ///< FLIP between the two frames
  double true_change = 0;  ///< the same of the truth: the visitor's own movement
  double excess() const { return change > true_change ? change - true_change : 0; }
};

/// One way of coding the same content.
struct CodecRow {
  std::string content, codec, setting;
  double bytes = 0;
  double flip = 0;  ///< against the content not coded
  int views = 0;
};

std::string csv_of(const std::vector<ViewRow>& rows);
std::string csv_of(const std::vector<TimeRow>& rows);
std::string csv_of(const std::vector<PopRow>& rows);
std::string csv_of(const std::vector<CodecRow>& rows);

/// Columns may stand in any order; others are passed over.
/// Fails   CityError: a column is missing, a field is no number, a line is cut off.
std::vector<ViewRow> views_from_csv(const std::string& text);
std::vector<TimeRow> times_from_csv(const std::string& text);
std::vector<PopRow> pops_from_csv(const std::string& text);
std::vector<CodecRow> codecs_from_csv(const std::string& text);

}  // namespace vicus::measure
