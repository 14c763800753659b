#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/measure_paths.hpp"
#include "cli/measure_representation.hpp"
#include "cli/measure_results.hpp"
#include "cli/measure_shared_city.hpp"
#include "sectorgen/bake/picture/flip.hpp"

/// The measurement itself: every representation along every path, against the truth.
namespace vicus::measure {

struct PictureSize {
  int width = 640, height = 480;
  std::size_t views = SIZE_MAX;  ///< of each path's key views, spread evenly; all where it has no more
};

struct RunOptions {
  std::size_t walk_views = 30, fly_views = 30;
  std::vector<PictureSize> sizes = {{}};
  int samples = 4;  ///< rays a pixel
  unsigned threads = 0;
  std::uint64_t seed = 1;
  std::string version, city_name;
  std::size_t switches = 2;  ///< of a path and representation at which popping is looked at
  std::size_t pictures = 2;  ///< of each path that are kept
};

struct KeptPicture {
  std::string path, family, setting;  ///< family "truth" for the truth
  int view = 0;
  Picture picture;
};

struct Measured {
  std::vector<ViewRow> views;
  std::vector<TimeRow> times;
  std::vector<PopRow> pops;
};

/// Key views and what is true there, made once for all representations.
class Course {
 public:
  Course(const Course&) = delete;
  Course& operator=(const Course&) = delete;
  Course(SharedCity& city, const RunOptions& options);

  /// Adds the rows of one representation; `keep` gets the pictures that a reader may see.
  /// What a family has shown already, with the same parts, is not drawn again.
  void run(Representation& form, Measured& out, const std::function<void(const KeptPicture&)>& keep);
  /// Pictures of the truth, kept as well.
  void keep_truth(const std::function<void(const KeptPicture&)>& keep) const;

  const Tour& tour() const { return tour_; }
  double fly_radius_m() const { return fly_.radius_m(); }

 private:
  struct KeyView {
    Pose pose;
    int number = 0;
    bool is_kept = false;
    std::vector<Camera> cameras;  ///< by size
    std::vector<View> truth;      ///< by size; without pixels: not looked at in this size
    std::vector<std::optional<FlipReference>> flip;
    std::vector<PixelGrid<std::uint8_t>> standing;
  };
  struct Way {
    Path path;
    double length_m = 0, step_m = 0, frame_m = 0;
    std::function<Pose(double)> at;
    std::vector<KeyView> views;
  };
  struct Drawn {
    ViewErrors errors;
    double cpu_ms = 0;
    Picture picture;  ///< where it is kept
  };
  struct Switch {
    double along_m;
    Parts before, after;
  };
  Camera camera_of(const Pose& pose, const PictureSize& size) const;
  View look(const Tracer& tracer, const Camera& camera, const PictureSize& size) const;
  void add_views(Way& way, std::size_t count);
  /// What a representation chooses at each key view, walking the way step by step; where it changes.
  std::vector<Parts> walk(Representation& form, const Way& way, const PictureSize& size,
                          std::vector<Switch>& switches) const;
  void measure_way(Representation& form, const Way& way, Measured& out,
                   const std::function<void(const KeptPicture&)>& keep);
  const Drawn& drawn(const KeyView& view, std::size_t size, const Parts& parts, const Shown& shown, Path path);
  void measure_pops(Representation& form, const Way& way, const std::vector<Switch>& switches, Measured& out) const;

  SharedCity& city_;
  RunOptions options_;
  Tour tour_;
  FlyPath fly_;
  std::shared_ptr<const Tracer> truth_;
  std::vector<Way> ways_;
  std::string family_;  ///< whose pictures these are
  std::map<std::string, Drawn> drawn_;
};

/// Pixels a radian in the middle of a picture of this height.
double pixels_per_radian(int height);

}  // namespace vicus::measure
