#include "cli/measure_sector_parts.hpp"

#include <algorithm>

#include "cli/measure_memory.hpp"
#include "x3d_export/house_nodes.hpp"

namespace vicus::measure {
namespace {

const char* suffix(Detail detail) { return detail == Detail::near ? "" : detail == Detail::far ? ".far" : ".tall"; }

}  // namespace

std::string part_text(const SectorPart& part) {
  if (part.detail != Detail::near) return part.sector->id + (part.detail == Detail::far ? " far" : " tall");
  std::string text = part.sector->id + " near ";
  if (part.levels.empty()) return text + std::to_string(part.level);
  text += std::to_string(part.level) + ":";
  for (const int level : part.levels) text += static_cast<char>('0' + level);
  return text;
}

SectorPart part_of(const SharedCity& city, const std::string& text) {
  SectorPart part;
  const auto end = text.find(' ');
  part.sector = city.index().sector(text.substr(0, end));
  const std::string rest = text.substr(end + 1);
  if (rest == "far" || rest == "tall") {
    part.detail = rest == "far" ? Detail::far : Detail::tall;
    return part;
  }
  part.level = rest.at(5) - '0';
  for (std::size_t i = 7; i < rest.size(); ++i) part.levels.push_back(rest[i] - '0');
  return part;
}

std::vector<std::string> images_of(const SharedCity& city, const Sector& sector, int level) {
  std::set<std::string> ids;
  for (const LevelPiece& piece : sector_pieces(city.index(), sector)) {
    const LevelFaces& faces = piece.levels[level - 1];
    if (!faces.atlas.empty()) ids.insert(city.city().meta.at("atlas"));
    for (const auto& [id, list] : faces.own_images) ids.insert(id);
  }
  return {ids.begin(), ids.end()};
}

std::vector<SentFile> stored_files(SharedCity& city, const SectorPart& part) {
  std::vector<SentFile> out;
  const std::string stem = "sectors/" + part.sector->id + suffix(part.detail);
  for (int i = 0;; ++i) {
    const std::string path = stem + (i == 0 ? "" : "." + std::to_string(i)) + ".x3d";
    const auto bytes = city.stored_bytes(path);
    if (!bytes) break;
    out.push_back({path, *bytes});
  }
  if (part.detail != Detail::near) return out;
  for (int level = 1; level <= finest_level(city.index(), *part.sector); ++level)
    for (const std::string& id : images_of(city, *part.sector, level))
      out.push_back({"textures/" + id + ".png", city.stored_bytes("textures/" + id + ".png").value_or(0)});
  if (const auto grain = city.city().meta.find("grain"); grain != city.city().meta.end())
    out.push_back(
        {"textures/" + grain->second + ".png", city.stored_bytes("textures/" + grain->second + ".png").value_or(0)});
  return once_each(std::move(out));
}

PartsScene scene_of(const SharedCity& city, const std::vector<SectorPart>& parts, RenderMesh more) {
  RenderMesh mesh = parts_mesh(city.index(), city.images(), parts, false);
  const auto points = static_cast<std::uint32_t>(mesh.points.size()),
             images = static_cast<std::uint32_t>(mesh.images.size()),
             places = static_cast<std::uint32_t>(mesh.places.size());
  const Vec3 moved = more.origin - mesh.origin;
  for (const auto& p : more.points)
    mesh.points.push_back({static_cast<float>(p[0] + moved[0]), static_cast<float>(p[1] + moved[1]),
                           static_cast<float>(p[2] + moved[2])});
  for (RenderTriangle t : more.triangles) {
    for (auto& corner : t.corners) corner += points;
    if (t.image != kNoImage) t.image += images, t.places += places;
    mesh.triangles.push_back(t);
  }
  mesh.images.insert(mesh.images.end(), more.images.begin(), more.images.end());
  mesh.places.insert(mesh.places.end(), more.places.begin(), more.places.end());
  PartsScene out;
  out.memory_bytes = memory_of(mesh);
  city.add_sheet(mesh);
  out.tracer = std::make_shared<MeshTracer>(std::move(mesh));
  return out;
}

std::vector<SentFile> once_each(std::vector<SentFile> files) {
  std::stable_sort(files.begin(), files.end(), [](const SentFile& a, const SentFile& b) { return a.path < b.path; });
  files.erase(
      std::unique(files.begin(), files.end(), [](const SentFile& a, const SentFile& b) { return a.path == b.path; }),
      files.end());
  return files;
}

}  // namespace vicus::measure
