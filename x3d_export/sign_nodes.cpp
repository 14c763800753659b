#include <cmath>
#include <numbers>

#include "city_db/steady_hash.hpp"
#include "x3d_export/mesh.hpp"
#include "x3d_export/object_nodes.hpp"
#include "x3d_export/sign_letters.hpp"
#include "x3d_export/text.hpp"

namespace vicus {
namespace {

constexpr double kUnit_m = 0.05;  // of a letter's grid: letters are 0.3 m high
constexpr int kAdvance = 6;       // of a letter, in units
constexpr double kStroke_m = 0.045;
constexpr double kBoard_m = 0.5, kMargin_m = 0.18, kDepth_m = 0.07, kProud_m = 0.012;
constexpr std::size_t kMostLetters = 22;

struct BoardColours {
  Colour board, letters;
};
constexpr BoardColours kBoards[] = {{{46, 66, 58}, {236, 226, 196}},
                                    {{122, 38, 36}, {244, 234, 214}},
                                    {{38, 54, 82}, {238, 238, 230}},
                                    {{64, 52, 44}, {232, 206, 140}},
                                    {{232, 226, 210}, {58, 46, 40}}};

/// Places on a sign: x to the right seen from before it, z upwards, out towards the viewer; metres.
class SignFrame {
 public:
  SignFrame(const StandaloneObject& sign, PlanPoint origin) : sign_(sign), origin_(origin) {
    const double turn = sign.heading_deg * std::numbers::pi / 180;
    east_ = std::sin(turn);
    north_ = std::cos(turn);
  }
  X3dPoint at(double x, double z, double out) const {
    const PlanPoint p{sign_.at.x + lattice_mm(-north_ * x + east_ * out),
                      sign_.at.y + lattice_mm(east_ * x + north_ * out)};
    return x3d_from_plan(p, height_mm(sign_.ground_m + sign_.height_m + z), origin_);
  }

 private:
  const StandaloneObject& sign_;
  PlanPoint origin_;
  double east_ = 0, north_ = 1;
};

void add_letters(std::vector<Face>& faces, const SignFrame& frame, const std::string& text, double left_m,
                 Colour colour) {
  for (std::size_t i = 0; i < text.size(); ++i)
    for (const Stroke4x6& s : strokes_of(text[i])) {
      const double x0 = left_m + (static_cast<double>(i) * kAdvance + s.x0) * kUnit_m, z0 = (s.y0 - 3) * kUnit_m;
      const double x1 = left_m + (static_cast<double>(i) * kAdvance + s.x1) * kUnit_m, z1 = (s.y1 - 3) * kUnit_m;
      const double length = std::hypot(x1 - x0, z1 - z0), ux = (x1 - x0) / length, uz = (z1 - z0) / length;
      const double h = kStroke_m / 2, ax = x0 - ux * h, az = z0 - uz * h, bx = x1 + ux * h, bz = z1 + uz * h;
      const double out = kDepth_m + kProud_m;
      faces.push_back({{frame.at(ax + uz * h, az - ux * h, out), frame.at(bx + uz * h, bz - ux * h, out),
                        frame.at(bx - uz * h, bz + ux * h, out), frame.at(ax - uz * h, az + ux * h, out)},
                       4,
                       colour});
    }
}

std::vector<Face> board_of(const StandaloneObject& sign, const std::string& text, PlanPoint origin) {
  const SignFrame frame(sign, origin);
  const BoardColours& colours = kBoards[steady_hash(sign.id) % std::size(kBoards)];
  const double wide = (static_cast<double>(text.size()) * kAdvance - 2) * kUnit_m, x = wide / 2 + kMargin_m,
               z = kBoard_m / 2, d = kDepth_m;
  std::vector<Face> faces;
  const auto add = [&](X3dPoint a, X3dPoint b, X3dPoint c, X3dPoint e) {
    faces.push_back({{a, b, c, e}, 4, colours.board});
  };
  add(frame.at(-x, -z, d), frame.at(x, -z, d), frame.at(x, z, d), frame.at(-x, z, d));
  add(frame.at(-x, z, d), frame.at(x, z, d), frame.at(x, z, 0), frame.at(-x, z, 0));
  add(frame.at(-x, -z, 0), frame.at(x, -z, 0), frame.at(x, -z, d), frame.at(-x, -z, d));
  add(frame.at(x, -z, d), frame.at(x, -z, 0), frame.at(x, z, 0), frame.at(x, z, d));
  add(frame.at(-x, -z, 0), frame.at(-x, -z, d), frame.at(-x, z, d), frame.at(-x, z, 0));
  add_letters(faces, frame, text, -wide / 2, colours.letters);
  return faces;
}

}  // namespace

std::vector<std::pair<const StandaloneObject*, std::vector<Face>>> sign_faces(const CityIndex& index,
                                                                              const Sector& sector) {
  std::vector<std::pair<const StandaloneObject*, std::vector<Face>>> signs;
  for (const StandaloneObject* sign : index.objects_of(sector.id)) {
    if (sign->kind != "sign") continue;
    const std::string text = sign_text(sign->name, kMostLetters);
    if (!text.empty()) signs.emplace_back(sign, board_of(*sign, text, sector.origin));
  }
  return signs;
}

std::vector<Node> sign_nodes(const CityIndex& index, const Sector& sector) {
  std::vector<Node> nodes;
  std::vector<Face> plain;
  for (const auto& [sign, faces] : sign_faces(index, sector)) {
    if (sign->url.empty()) {
      plain.insert(plain.end(), faces.begin(), faces.end());
      continue;
    }
    Node anchor("Anchor");
    anchor.set("description", FieldValue(caption_of(sign->name)))
        .set("url", std::vector<std::string>{sign->url})
        .set("parameter", std::vector<std::string>{"target=_blank"});
    nodes.push_back(anchor.add(shape_of("", Shading::solid, faces)));
  }
  if (!plain.empty()) nodes.push_back(shape_of("SIGNS", Shading::solid, plain));
  return nodes;
}

}  // namespace vicus
