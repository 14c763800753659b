#include "cli/measure_report.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "city_db/issues.hpp"
#include "cli/measure_pareto.hpp"
#include "cli/measure_summary.hpp"

namespace vicus::measure {
namespace {

using Json = nlohmann::ordered_json;

/// Letters and digits as they are, all else as one dash.
std::string plain(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+')
      out += c;
    else if (!out.empty() && out.back() != '-')
      out += '-';
  }
  return out;
}

}  // namespace

RunFacts facts_of_machine() {
  RunFacts facts;
  facts.cores = std::thread::hardware_concurrency();
  std::ifstream processors("/proc/cpuinfo");
  for (std::string line; std::getline(processors, line);)
    if (line.starts_with("model name")) {
      const auto at = line.find(": ");
      if (at != std::string::npos) facts.processor = line.substr(at + 2);
      break;
    }
  double load[1] = {};
  if (getloadavg(load, 1) == 1) facts.load = load[0];
  return facts;
}

std::string json_of(const RunFacts& f) {
  return Json{{"city", f.city},           {"version", f.version}, {"seed", f.seed},
              {"samples", f.samples},     {"houses", f.houses},   {"sectors", f.sectors},
              {"walk_name", f.walk_name}, {"walk_m", f.walk_m},   {"fly_radius_m", f.fly_radius_m},
              {"processor", f.processor}, {"cores", f.cores},     {"load", f.load}}
             .dump(1, ' ', false, Json::error_handler_t::replace) +
         "\n";
}

RunFacts facts_from_json(const std::string& text) {
  try {
    const Json json = Json::parse(text);
    RunFacts f;
    json.at("city").get_to(f.city);
    json.at("version").get_to(f.version);
    json.at("seed").get_to(f.seed);
    json.at("samples").get_to(f.samples);
    json.at("houses").get_to(f.houses);
    json.at("sectors").get_to(f.sectors);
    json.at("walk_name").get_to(f.walk_name);
    json.at("walk_m").get_to(f.walk_m);
    json.at("fly_radius_m").get_to(f.fly_radius_m);
    json.at("processor").get_to(f.processor);
    json.at("cores").get_to(f.cores);
    json.at("load").get_to(f.load);
    return f;
  } catch (const nlohmann::json::exception& e) {
    throw CityError(std::string("run.json is not as vicus measure writes it: ") + e.what());
  }
}

std::string picture_path(const std::string& path, int view, const std::string& family, const std::string& setting) {
  return "pictures/" + path + "-" + std::to_string(view) + "-" + plain(family + " " + setting) + ".webp";
}

std::string best_json(const Results& results) {
  Json out = Json::object();
  const auto all = summaries_of(results);
  for (const char* path : {"walk", "fly", "overview"}) {
    const auto rows = of_path(all, path);
    std::vector<CostError> points;
    for (const Summary& s : rows) points.emplace_back(s.bytes, s.errors.flip);
    Json list = Json::array();
    for (const std::size_t i : pareto_front(points))
      list.push_back({{"representation", rows[i].full()}, {"bytes", rows[i].bytes}, {"flip", rows[i].errors.flip}});
    if (!list.empty()) out[path] = std::move(list);
  }
  return out.dump();
}

}  // namespace vicus::measure
