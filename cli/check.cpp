#include <algorithm>
#include <cstdarg>

#include "city_db/rules.hpp"
#include "city_db/shape.hpp"
#include "city_db/store.hpp"
#include "cli/check_models.hpp"
#include "cli/command.hpp"

/// `vicus check`: the rules and figures of DESIGN §3, from the stored records.
namespace vicus::cli {
namespace {

using Json = nlohmann::json;

struct Checked {
  City city;
  RuleReport rules;
  ShapeReport shape;
  ModelFigures models;
};

Json json_of(const Spread& s) {
  if (s.count == 0) return {{"count", 0}, {"median", nullptr}, {"p05", nullptr}, {"p95", nullptr}, {"mean", nullptr}};
  return {{"count", s.count}, {"median", s.median}, {"p05", s.p05}, {"p95", s.p95}, {"mean", s.mean}};
}

Json json_of(const SectorFigures& f) {
  return {{"gates_per_sector", json_of(f.gates_per_sector)},
          {"convexity", json_of(f.convexity)},
          {"convexity_by_area", f.convexity_by_area},
          {"sector_length_m", json_of(f.sector_length_m)}};
}

Json shape_json(const ShapeReport& shape) {
  Json json = json_of(shape.streets);
  const auto& named = shape.named_streets;
  json["gate_width_ratio"] = json_of(shape.gate_width_ratio);
  json["named_street_share"] = named.outside_cores_m > 0 ? Json(named.share) : Json();
  json["named_street_share_strict"] = named.length_m > 0 ? Json(named.share_strict) : Json();
  json["named_street_share_all_names"] = named.length_m > 0 ? Json(named.share_all_names) : Json();
  json["named_street_share_by_street"] = json_of(named.by_street);
  json["named_street_m"] = named.length_m;
  json["named_street_outside_cores_m"] = named.outside_cores_m;
  return json;
}

Json shape_all_json(const ShapeReport& shape) {
  Json json = json_of(shape.all);
  json["yard_gate_width_ratio"] = json_of(shape.yard_gate_width_ratio);
  json["kerb_gate_width_ratio"] = json_of(shape.kerb_gate_width_ratio);
  return json;
}

template <class T>
Json kinds_json(const std::vector<T>& records) {
  Json json = Json::object();
  for (const auto& r : records) json[name_of(r.kind)] = json.value(name_of(r.kind), 0) + 1;
  return json;
}

Json counts_json(const City& city) {
  return {{"sectors", city.sectors.size()},     {"sectors_by_kind", kinds_json(city.sectors)},
          {"gates", city.gates.size()},         {"gates_by_kind", kinds_json(city.gates)},
          {"borders", city.borders.size()},     {"buildings", city.buildings.size()},
          {"obstacles", city.obstacles.size()}, {"streets", city.streets.size()},
          {"objects", city.objects.size()},     {"viewpoints", city.viewpoints.size()},
          {"interiors", city.interiors.size()}, {"doors", city.doors.size()},
          {"issues", city.issues.size()}};
}

Json bytes_json(const City& city) {
  std::vector<double> bytes;
  for (const auto& s : city.sectors) bytes.push_back(static_cast<double>(s.bytes));
  const double most = bytes.empty() ? 0 : *std::max_element(bytes.begin(), bytes.end());
  return {{"sector_median", spread_of(bytes).median}, {"sector_max", most}};
}

Json visibility_json(const City& city) {
  Json json = {{"self", 0}, {"gate", 0}, {"line_of_sight", 0}, {"over_roofs", 0}, {"important", 0}, {"unresolved", 0}};
  for (const auto& v : city.visible) {
    json[name_of(v.reason)] = json[name_of(v.reason)].get<int>() + 1;
    if (!v.is_proven) json["unresolved"] = json["unresolved"].get<int>() + 1;
  }
  int important = 0;
  for (const auto& s : city.sectors) important += s.importance != Importance::none;
  json["important_sectors"] = important;
  json["per_sector_mean"] =
      city.sectors.empty() ? 0.0 : static_cast<double>(city.visible.size()) / static_cast<double>(city.sectors.size());
  return json;
}

Json heights_json(const City& city) {
  Json json = {{"measured", 0}, {"levels", 0}, {"guessed", 0}};
  for (const auto& b : city.buildings) json[name_of(b.height_source)] = json[name_of(b.height_source)].get<int>() + 1;
  return json;
}

Json roofs_json(const ModelFigures& figures) {
  return {{"sound", figures.sound}, {"unsound", figures.unsound.size()}, {"without", figures.without}};
}

Json textures_json(const ModelFigures& figures) {
  return {{"sector_kb_median", figures.texture_kb.median}, {"sector_kb_max", figures.texture_max_kb}};
}

Json check_json(const Checked& c) {
  Json holds, counts, violations = Json::array();
  for (std::size_t r = 0; r < kRuleCount; ++r) {
    holds[name_of(static_cast<Rule>(r))] = c.rules.holds(static_cast<Rule>(r));
    counts[name_of(static_cast<Rule>(r))] = c.rules.violation_counts[r];
  }
  for (const auto& v : c.rules.violations)
    violations.push_back({{"rule", name_of(v.rule)},
                          {"id", v.id},
                          {"east_m", metres(v.at.x)},
                          {"north_m", metres(v.at.y)},
                          {"message", v.message}});
  return {{"holds", holds},
          {"violation_counts", counts},
          {"violations", violations},
          {"area",
           {{"is_noded", c.rules.is_noded},
            {"error_mm2", c.rules.area_error_mm2 ? Json(*c.rules.area_error_mm2) : Json()},
            {"walkable_m2", c.rules.walkable_mm2 ? Json(*c.rules.walkable_mm2 / 1e6) : Json()},
            {"sectors_m2", c.rules.sectors_mm2 / 1e6},
            {"components", c.rules.components}}},
          {"counts", counts_json(c.city)},
          {"shape", shape_json(c.shape)},
          {"shape_all", shape_all_json(c.shape)},
          {"bytes", bytes_json(c.city)},
          {"visibility", visibility_json(c.city)},
          {"heights", heights_json(c.city)},
          {"roofs", roofs_json(c.models)},
          {"textures", textures_json(c.models)}};
}

/// printf onto the end of a text.
[[gnu::format(printf, 2, 3)]] void add_line(std::string& text, const char* format, ...) {
  char line[1024];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(line, sizeof line, format, arguments);
  va_end(arguments);
  text += line;
  text += '\n';
}

void add_rules(std::string& text, const RuleReport& report) {
  for (std::size_t r = 0; r < kRuleCount; ++r) {
    const Rule rule = static_cast<Rule>(r);
    add_line(text, "%zu %-13s %-7s %s", r + 1, name_of(rule), report.holds(rule) ? "holds" : "BROKEN",
             sentence_of(rule));
    std::uint64_t listed = 0;
    for (const auto& v : report.violations) {
      if (v.rule != rule) continue;
      ++listed;
      add_line(text, "    %s at %.3f E %.3f N: %s", v.id.empty() ? "-" : v.id.c_str(), metres(v.at.x), metres(v.at.y),
               v.message.c_str());
    }
    if (report.violation_counts[r] > listed)
      add_line(text, "    and %llu more", static_cast<unsigned long long>(report.violation_counts[r] - listed));
  }
  if (report.area_error_mm2)
    add_line(text, "area error %.1f mm2; walkable ground %.0f m2 in %llu connected parts", *report.area_error_mm2,
             *report.walkable_mm2 / 1e6, static_cast<unsigned long long>(report.components));
  else
    add_line(text, "area error unknown: rings cross each other");
}

void add_spread(std::string& text, const char* what, const Spread& s, const char* aim) {
  if (s.count == 0) return add_line(text, "  %-36s %8s", what, "none");
  add_line(text, "  %-36s %8.3f %8.3f %8.3f %8zu  %s", what, s.median, s.p05, s.p95, s.count, aim);
}

void add_shape(std::string& text, const ShapeReport& shape) {
  add_line(text, "  %-36s %8s %8s %8s %8s  %s", "", "median", "p05", "p95", "count", "aim");
  add_line(text, "streets, crossroads and squares");
  add_spread(text, "gates per sector (street, passage)", shape.streets.gates_per_sector, "median 2..4");
  add_spread(text, "convexity", shape.streets.convexity, "median >= 0.85");
  add_spread(text, "sector length, m", shape.streets.sector_length_m, "<= 160 but in open ground");
  add_spread(text, "gate width / street width", shape.gate_width_ratio, "<= 1.1");
  add_line(text, "all sectors");
  add_spread(text, "gates per sector", shape.all.gates_per_sector, "");
  add_spread(text, "convexity", shape.all.convexity, "");
  add_spread(text, "sector length, m", shape.all.sector_length_m, "");
  add_spread(text, "yard gate width / width there", shape.yard_gate_width_ratio, "");
  add_spread(text, "kerb gate width / width there", shape.kerb_gate_width_ratio, "");
  const auto& named = shape.named_streets;
  add_line(text,
           "named streets' centre lines in sectors that bear their name (%.0f m, %.0f m outside of junction cores)",
           named.length_m, named.outside_cores_m);
  add_line(text,
           "  outside of junction cores %.1f %% (aim >= 95 %%); strictly %.1f %%; crossroads bearing all names %.1f %%",
           100 * named.share, 100 * named.share_strict, 100 * named.share_all_names);
}

void add_roofs(std::string& text, const ModelFigures& figures, std::size_t listed) {
  for (std::size_t i = 0; i < std::min(listed, figures.unsound.size()); ++i)
    add_line(text, "roof of %s is not sound: %s", figures.unsound[i].building_id.c_str(),
             figures.unsound[i].fault.c_str());
}

std::string check_text(const Checked& c, std::size_t listed) {
  std::string text;
  add_rules(text, c.rules);
  add_roofs(text, c.models, listed);
  text += '\n';
  add_shape(text, c.shape);
  text += '\n';
  for (const auto& [what, json] : {std::pair<const char*, Json>{"counts", counts_json(c.city)},
                                   {"bytes", bytes_json(c.city)},
                                   {"visibility", visibility_json(c.city)},
                                   {"heights", heights_json(c.city)},
                                   {"roofs", roofs_json(c.models)},
                                   {"textures", textures_json(c.models)}}) {
    text += what;
    for (const auto& [key, value] : json.items()) text += (" " + key + " ").append(value.dump());
    text += '\n';
  }
  return text;
}

}  // namespace

void add_check(CLI::App& app, Context& context) {
  struct Arguments {
    std::string city;
    RuleOptions options;
  };
  auto arguments = std::make_shared<Arguments>();
  auto* command = new_command(app, context, "check", "Prove the rules of a city and judge its shape",
                              "vicus check graz.gpkg --json");
  command->add_option("CITY", arguments->city, "city file, as vicus build writes it")->required();
  command->add_option("--list", arguments->options.listed_per_rule, "violations listed per rule")
      ->capture_default_str();
  command->callback([arguments, &context] {
    Checked checked;
    checked.city = read_city(arguments->city);
    checked.rules = check_rules(checked.city, arguments->options);
    checked.shape = measure_shape(checked.city);
    checked.models = check_models(checked.city, CityReader(arguments->city));
    context.exit_code = checked.rules.all_hold() && checked.models.unsound.empty() ? kDone : kRuleBroken;
    print_result(context, context.json ? std::string() : check_text(checked, arguments->options.listed_per_rule),
                 check_json(checked));
  });
}

}  // namespace vicus::cli
