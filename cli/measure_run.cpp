#include "cli/measure_run.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "city_db/surroundings.hpp"
#include "cli/measure_memory.hpp"
#include "cli/measure_sector_forms.hpp"
#include "sectorgen/bake/picture/flip.hpp"

namespace vicus::measure {
namespace {

constexpr double kFrames_per_s = 30;
constexpr double kWalkStep_m = 0.25, kFlyStep_m = 5;  // between two looks at what is chosen

/// Of `count` things the i-th of `wanted`, spread evenly.
std::set<std::size_t> spread(std::size_t count, std::size_t wanted) {
  std::set<std::size_t> out;
  wanted = std::min(wanted, count);
  for (std::size_t i = 0; i < wanted; ++i) out.insert((2 * i + 1) * count / (2 * wanted));
  return out;
}

}  // namespace

double pixels_per_radian(int height) { return height / 2.0 / std::tan(kFieldOfView / 2); }

Course::Course(SharedCity& city, const RunOptions& options)
    : city_(city),
      options_(options),
      tour_(walk_tour(city.guide(), city.city(), options.seed)),
      fly_(city.city()),
      truth_(truth_of(city)) {
  Way walk{Path::walk,
           tour_.length_m,
           kWalkStep_m,
           kWalkingSpeed_m_s / kFrames_per_s,
           [this](double s) { return walk_pose(tour_, s); },
           {}};
  Way fly{Path::fly, kFly_m, kFlyStep_m, kFlySpeed_m_s / kFrames_per_s, [this](double s) { return fly_.at(s); }, {}};
  Way overview{Path::overview, 0, 1, 0, [this](double) { return overview_pose(city_.city(), kFieldOfView); }, {}};
  add_views(walk, options.walk_views);
  add_views(fly, options.fly_views);
  add_views(overview, options.fly_views > 0 ? 1 : 0);
}

Camera Course::camera_of(const Pose& pose, const PictureSize& size) const {
  return camera_at(pose.eye, pose.look, kFieldOfView, size.width, size.height);
}

View Course::look(const Tracer& tracer, const Camera& camera, const PictureSize& size) const {
  View view = render(tracer, camera, {size.width, size.height, options_.samples, 0.05, options_.threads});
  view.cut_out = {};  // nobody asks for it, and it is the largest part
  return view;
}

void Course::add_views(Way& way, std::size_t count) {
  if (count == 0) return;
  const auto places = key_places(way.length_m, count);
  const auto kept = spread(places.size(), options_.pictures);
  std::vector<std::set<std::size_t>> seen;
  for (const PictureSize& size : options_.sizes) seen.push_back(spread(places.size(), size.views));
  for (std::size_t i = 0; i < places.size(); ++i) {
    KeyView view{way.at(places[i]), static_cast<int>(i), kept.contains(i), {}, {}, {}, {}};
    for (std::size_t s = 0; s < options_.sizes.size(); ++s) {
      const PictureSize& size = options_.sizes[s];
      view.cameras.push_back(camera_of(view.pose, size));
      view.truth.emplace_back();
      view.flip.emplace_back();
      view.standing.emplace_back();
      if (!seen[s].contains(i)) continue;
      view.truth.back() = look(*truth_, view.cameras.back(), size);
      view.flip.back().emplace(view.truth.back().colour);
      view.standing.back() = standing(view.truth.back(), view.cameras.back(), city_.city().terrain);
    }
    way.views.push_back(std::move(view));
  }
  ways_.push_back(std::move(way));
}

void Course::keep_truth(const std::function<void(const KeptPicture&)>& keep) const {
  for (const Way& way : ways_)
    for (const KeyView& view : way.views)
      if (view.is_kept && !view.truth.front().colour.pixels.empty())
        keep({name_of(way.path), "truth", {}, view.number, view.truth.front().colour});
}

void Course::run(Representation& form, Measured& out, const std::function<void(const KeptPicture&)>& keep) {
  if (form.name().family != family_) drawn_.clear();
  family_ = form.name().family;
  for (const Way& way : ways_)
    if (form.shows(way.path)) measure_way(form, way, out, keep);
}

std::vector<Parts> Course::walk(Representation& form, const Way& way, const PictureSize& size,
                                std::vector<Switch>& switches) const {
  std::vector<Parts> at_views;
  Parts now;
  double along = 0;
  const double unit = pixels_per_radian(size.height);
  const auto go_to = [&](double place) {
    Parts next = form.choose(way.at(place), unit, now);
    if (!now.empty() && next != now) switches.push_back({place, now, next});
    now = std::move(next);
    along = place;
  };
  for (const KeyView& view : way.views) {
    while (along + way.step_m < view.pose.along_m) go_to(along + way.step_m);
    go_to(view.pose.along_m);
    at_views.push_back(now);
  }
  return at_views;
}

void Course::measure_way(Representation& form, const Way& way, Measured& out,
                         const std::function<void(const KeptPicture&)>& keep) {
  const FormName& name = form.name();
  std::vector<Switch> switches;
  for (std::size_t s = 0; s < options_.sizes.size(); ++s) {
    const PictureSize& size = options_.sizes[s];
    std::vector<Switch> ignored;
    const auto chosen = walk(form, way, size, s == 0 ? switches : ignored);
    std::set<std::string> had;
    for (std::size_t v = 0; v < way.views.size(); ++v) {
      const KeyView& view = way.views[v];
      if (view.truth[s].colour.pixels.empty()) continue;
      const Shown shown = form.show(chosen[v]);
      ViewRow row;
      row.city = options_.city_name, row.version = options_.version, row.seed = options_.seed;
      row.family = name.family, row.setting = name.setting, row.tau_px = name.tau_px;
      row.path = name_of(way.path), row.view = view.number, row.along_m = view.pose.along_m;
      row.width = size.width, row.height = size.height;
      for (const SentFile& file : shown.files) {
        row.bytes += file.bytes;
        ++row.requests;
        if (!had.insert(file.path).second) continue;
        row.new_bytes += file.bytes;
        ++row.new_requests;
      }
      row.memory_bytes = shown.memory_bytes;
      const Drawn& seen = drawn(view, s, chosen[v], shown, way.path);
      out.times.push_back(
          {name.family, name.setting, row.path, row.view, size.width, size.height, shown.decode_cpu_ms, seen.cpu_ms});
      row.errors = seen.errors;
      if (!seen.picture.pixels.empty()) keep({row.path, name.family, name.setting, view.number, seen.picture});
      out.views.push_back(std::move(row));
    }
  }
  measure_pops(form, way, switches, out);
}

const Course::Drawn& Course::drawn(const KeyView& view, std::size_t size, const Parts& parts, const Shown& shown,
                                   Path path) {
  std::string key = std::string(name_of(path)) + " " + std::to_string(view.number) + " " + std::to_string(size);
  for (const std::string& part : parts) key += "\n" + part;
  const auto [at, is_new] = drawn_.emplace(std::move(key), Drawn{});
  if (!is_new) return at->second;
  const double start = cpu_ms();
  View picture = look(*shown.tracer, view.cameras[size], options_.sizes[size]);
  at->second.cpu_ms = cpu_ms() - start;
  at->second.errors = errors_of(view.truth[size], *view.flip[size], picture, view.standing[size]);
  if (size == 0 && view.is_kept) at->second.picture = std::move(picture.colour);
  return at->second;
}

void Course::measure_pops(Representation& form, const Way& way, const std::vector<Switch>& switches,
                          Measured& out) const {
  const PictureSize& size = options_.sizes.front();
  for (const std::size_t i : spread(switches.size(), options_.switches)) {
    const Switch& at = switches[i];
    const Camera before = camera_of(way.at(std::max(0.0, at.along_m - way.frame_m)), size),
                 after = camera_of(way.at(at.along_m), size);
    const Picture truth_before = look(*truth_, before, size).colour, truth_after = look(*truth_, after, size).colour;
    const Picture shown_before = look(*form.show(at.before).tracer, before, size).colour,
                  shown_after = look(*form.show(at.after).tracer, after, size).colour;
    out.pops.push_back({form.name().family, form.name().setting, name_of(way.path), size.width, size.height, at.along_m,
                        static_cast<int>(switches.size()), flip_mean(shown_before, shown_after),
                        flip_mean(truth_before, truth_after)});
  }
}

}  // namespace vicus::measure
