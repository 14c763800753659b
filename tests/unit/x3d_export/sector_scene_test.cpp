#include "x3d_export/sector_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/support/sample_city.hpp"
#include "tests/support/x3d_text.hpp"
#include "x3d_export/house_body.hpp"
#include "x3d_export/objects.hpp"
#include "x3d_export/sector_mesh.hpp"

namespace vicus {
namespace {

using test::attributes_in;
using test::faces_in;
using test::ReadFace;
using test::ReadPoint;

struct Sample {
  City city = test::sample_city();
  CityIndex index{city};
  std::vector<ExportFile> near(const std::string& id, std::size_t limit = kFileLimit_bytes) const {
    return sector_files(index, *index.sector(id), Detail::near, SceneFormat::x3d, limit);
  }
};

/// The lattice point that a coordinate as read stands for, and how far it is from it.
PlanPoint plan_of(const ReadPoint& p, PlanPoint origin, double& error_mm) {
  const X3dPoint nearest{lattice_mm(p.x), lattice_mm(p.y), lattice_mm(p.z)};
  error_mm = std::max(
      {std::abs(p.x * 1000.0 - nearest.x), std::abs(p.y * 1000.0 - nearest.y), std::abs(p.z * 1000.0 - nearest.z)});
  return plan_from_x3d(nearest, origin);
}

bool is_inside(const Ring& ring, double x, double y) {
  bool inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    if ((ring[i].y > y) != (ring[j].y > y) &&
        x < ring[i].x + (y - ring[i].y) * (double(ring[j].x) - ring[i].x) / (double(ring[j].y) - ring[i].y))
      inside = !inside;
  return inside;
}

bool is_inside(const Polygon& polygon, double x, double y) {
  return is_inside(polygon.outer, x, y) &&
         std::none_of(polygon.holes.begin(), polygon.holes.end(), [&](const Ring& r) { return is_inside(r, x, y); });
}

/// Is there a house at this plan point (mm) and height (mm)?
bool is_in_house(const City& city, double x, double y, double up) {
  return std::any_of(city.buildings.begin(), city.buildings.end(), [&](const Building& b) {
    return up > b.base_m * 1000 && up < wall_top_m(b) * 1000 && is_inside(b.footprint, x, y);
  });
}

TEST(SectorFiles, GiveEveryVertexBackAsTheLatticeHasIt) {
  const Sample sample;
  std::set<PlanPoint> ground, houses;
  for (const auto& s : sample.city.sectors) {
    ground.insert(s.ground.outer.begin(), s.ground.outer.end());
    for (const auto& hole : s.ground.holes) ground.insert(hole.begin(), hole.end());
  }
  for (const auto& s : sample.city.surfaces)
    for (const auto& p : s.points) ground.insert(p.at);
  for (const auto& b : sample.city.buildings) {
    houses.insert(b.footprint.outer.begin(), b.footprint.outer.end());
    for (const auto& hole : b.footprint.holes) houses.insert(hole.begin(), hole.end());
  }
  std::size_t tested = 0;
  for (const auto& s : sample.city.sectors)
    for (const auto& face : faces_in(sample.near(s.id).front().text)) {
      if (face.shape != "GROUND" && face.shape != "HOUSES") continue;
      for (const auto& corner : face.corners) {
        double error_mm = 0;
        const PlanPoint p = plan_of(corner, s.origin, error_mm);
        EXPECT_LE(error_mm, 0.5);
        // A facade ends where its sector's ground does, which need not be a corner of the house.
        EXPECT_TRUE(ground.contains(p) || (face.shape == "HOUSES" && houses.contains(p))) << s.id << p.x << " " << p.y;
        ++tested;
      }
    }
  EXPECT_GT(tested, 200u);
}

TEST(SectorFiles, ShowHousesFromOutside) {
  const Sample sample;
  std::size_t walls = 0, roofs = 0;
  for (const auto& s : sample.city.sectors)
    for (const auto& face : faces_in(sample.near(s.id).front().text)) {
      if (face.shape != "HOUSES") continue;
      double x = 0, y = 0, low = 1e9, high = 0;
      for (const auto& c : face.corners) {
        const double n = static_cast<double>(face.corners.size());
        x += (s.origin.x + c.x * 1000.0) / n;
        y += (s.origin.y - c.z * 1000.0) / n;
        low = std::min(low, c.y * 1000.0);
        high = std::max(high, c.y * 1000.0);
      }
      const auto& [nx, ny, nz] = face.normal;
      const auto is_house_at = [&](double side, double up) {
        return is_in_house(sample.city, x + side * nx, y - side * nz, up + side * ny);
      };
      // A wall may be hidden in part: where a house hangs over a passage, or below a neighbour's roof.
      EXPECT_FALSE(is_house_at(10, low + 10) && is_house_at(10, high - 10)) << s.id << " in front";
      EXPECT_TRUE(is_house_at(-10, low < high ? high - 10 : high)) << s.id << " behind";
      (std::abs(ny) < 0.5 ? walls : roofs)++;
    }
  EXPECT_GT(walls, 40u);
  EXPECT_GT(roofs, 20u);
}

TEST(SectorFiles, ShowTheGroundFromAbove) {
  const Sample sample;
  for (const auto& s : sample.city.sectors)
    for (const auto& face : faces_in(sample.near(s.id).front().text))
      if (face.shape == "GROUND") {
        const bool is_kerb = s.id == "s-main-w" && std::abs(face.normal[1]) < 1e-6;
        EXPECT_TRUE(is_kerb || std::abs(face.normal[1] - 1) < 1e-6) << s.id << face.normal[1];
      }
}

TEST(SectorFiles, CloseTheCityAgainstItsEnds) {
  const Sample sample;
  for (const auto& s : sample.city.sectors) {
    const bool has_end = std::any_of(sample.city.gates.begin(), sample.city.gates.end(),
                                     [&](const Gate& g) { return g.sector_id == s.id && g.to_sector_id.empty(); });
    std::size_t backdrops = 0;
    for (const auto& face : faces_in(sample.near(s.id).front().text)) {
      if (face.shape != "BACKDROP") continue;
      ++backdrops;
      const auto& c = face.corners;
      const double x = s.origin.x + (c[0].x + c[1].x) * 500.0, y = s.origin.y - (c[0].z + c[1].z) * 500.0;
      EXPECT_TRUE(is_inside(s.ground, x + 10 * face.normal[0], y - 10 * face.normal[2])) << "seen from the sector";
    }
    EXPECT_EQ(backdrops > 0, has_end) << s.id;
    const std::string text = sample.near(s.id).front().text;
    EXPECT_EQ(text.find("<ColorRGBA color='0 0 0 1 0 0 0 1 0 0 0 1 0 0 0 1 0 0 0 0 0 0 0 0") != std::string::npos,
              has_end)
        << "its top fades";
  }
}

TEST(SectorFiles, HaveAllFacesWhateverTheLimit) {
  const Sample sample;
  std::size_t sliced = 0;
  for (const auto& s : sample.city.sectors)
    for (const Detail detail : {Detail::near, Detail::far, Detail::tall}) {
      std::map<std::string, std::size_t> expected;  // faces of each layer
      for (const Layer& layer : sector_layers(sample.index, s, detail))
        if (layer.name != "BACKDROP") expected[layer.name] = layer.faces.size();  // its faces are halved
      for (std::size_t limit = 600; limit <= 4'000; limit += 20) {
        std::map<std::string, std::size_t> found;
        for (const auto& file : sector_files(sample.index, s, detail, SceneFormat::x3d, limit)) {
          const auto faces = faces_in(file.text);  // throws at a Shape used again
          for (const auto& face : faces)
            if (const auto layer = face.shape.substr(0, face.shape.find('-')); expected.contains(layer)) ++found[layer];
          sliced += std::any_of(faces.begin(), faces.end(), [](const ReadFace& f) { return f.shape == "HOUSES-2"; });
        }
        EXPECT_EQ(found, expected) << s.id << ", limit " << limit;
      }
    }
  EXPECT_GT(sliced, 0u) << "no layer was cut";
}

TEST(SectorFiles, HaveFewShapes) {
  const Sample sample;
  for (const auto& s : sample.city.sectors) {
    const auto file = sample.near(s.id).front();
    EXPECT_LE(file.shapes, 9);
    int shapes = 0;
    for (std::size_t at = 0; (at = file.text.find("<Shape", at)) != std::string::npos; ++at) ++shapes;
    EXPECT_EQ(shapes, file.shapes);
    const auto far = sector_files(sample.index, s, Detail::far, SceneFormat::x3d);
    ASSERT_EQ(far.size(), 1u);
    EXPECT_EQ(far.front().shapes, 1);
    EXPECT_LT(far.front().text.size(), file.text.size());
  }
}

using FaceKey = std::vector<std::array<float, 3>>;

std::multiset<FaceKey> keys_of(const std::vector<ExportFile>& files) {
  std::multiset<FaceKey> keys;
  for (const auto& file : files)
    for (const auto& face : faces_in(file.text)) {
      FaceKey key;
      for (const auto& c : face.corners) key.push_back({c.x, c.y, c.z});
      keys.insert(key);
    }
  return keys;
}

TEST(SectorFiles, AreSplitWhereTheyAreTooLargeAndLoseNothing) {
  const Sample sample;
  const auto whole = sample.near("s-main-e"), split = sample.near("s-main-e", 5200);
  ASSERT_EQ(whole.size(), 1u);
  ASSERT_GT(split.size(), 1u);
  std::vector<std::string> urls;
  int shapes = split.front().shapes;
  for (std::size_t i = 1; i < split.size(); ++i) {
    EXPECT_LE(split[i].text.size(), 5200u);
    EXPECT_EQ(split[i].path, "sectors/s-main-e." + std::to_string(i) + ".x3d");
    urls.push_back("\"s-main-e." + std::to_string(i) + ".x3d\"");
    shapes += split[i].shapes;
  }
  EXPECT_EQ(attributes_in(split.front().text, "Inline", "url"), urls);
  EXPECT_EQ(keys_of(split), keys_of(whole));
  const auto counts = attributes_in(split.front().text, "MetadataInteger", "value");
  EXPECT_EQ(counts.front(), std::to_string(shapes)) << "the record counts the Shapes of all parts";
}

TEST(SectorFiles, HousesWithWindowsComeInFourLevels) {
  const City city = test::sample_city_with_facades();
  const CityIndex index(city);
  for (const auto& s : city.sectors) {
    const auto files = sector_files(index, s, Detail::near, SceneFormat::x3d);
    std::set<std::string> houses;
    for (const Facade* f : index.facades_of(s.id)) houses.insert(f->building_id);
    std::size_t lods = 0;
    std::map<std::string, int> images;
    for (const auto& file : files) {
      EXPECT_LE(file.text.size(), kFileLimit_bytes);
      for (const auto& range : attributes_in(file.text, "LOD", "range")) {
        EXPECT_EQ(range, "30 130 250");
        ++lods;
      }
      for (const auto& url : attributes_in(file.text, "ImageTexture", "url")) ++images[url];
    }
    EXPECT_GE(lods, houses.size());
    if (files.size() == 1) {
      for (const auto& [url, count] : images) EXPECT_EQ(count, 1) << url << " is held more than once in a file";
    }
    EXPECT_EQ(images.contains("\"../textures/a71a5.png\""), !houses.empty()) << s.id;
  }
}

TEST(SectorFiles, TooManyOpeningsForTheBudgetLeaveTheFourthLevelOut) {
  City city = test::sample_city_with_facades();
  const std::string id = city.facades.front().sector_id;
  const auto ranges = [&] {
    const CityIndex index(city);
    std::set<std::string> out;
    for (const auto& file : sector_files(index, *index.sector(id), Detail::near, SceneFormat::x3d))
      for (const auto& range : attributes_in(file.text, "LOD", "range")) out.insert(range);
    return out;
  };
  EXPECT_EQ(ranges(), std::set<std::string>{"30 130 250"});
  city.facades.front().floors = 150;
  city.facades.front().bays = 8;
  city.facades.front().repeats = 2;
  EXPECT_EQ(ranges(), std::set<std::string>{"130 250"});
}

TEST(SectorFiles, WithoutAnAtlasHousesArePlain) {
  City city = test::sample_city_with_facades();
  city.meta.erase("atlas");
  const City plain = test::sample_city();
  for (const auto& s : city.sectors)
    EXPECT_EQ(keys_of(sector_files(CityIndex(city), s, Detail::near, SceneFormat::x3d)),
              keys_of(sector_files(CityIndex(plain), *CityIndex(plain).sector(s.id), Detail::near, SceneFormat::x3d)));
}

/// The record inside a sector's X3D JSON, in the form of ID.json.
nlohmann::json record_in(const nlohmann::json& set) {
  nlohmann::json record = nlohmann::json::object();
  for (const auto& item : set.at("-value")) {
    const std::string type = item.begin().key();
    const auto& node = item.begin().value();
    const std::string name = node.at("@name");
    if (type == "MetadataSet")
      record[name].push_back(record_in(node));
    else
      record[name] = node.at("@value");
  }
  return record;
}

TEST(SectorFiles, CarryTheSameRecordAsTheJsonFile) {
  const Sample sample;
  for (const auto& s : sample.city.sectors) {
    const auto file = sector_files(sample.index, s, Detail::near, SceneFormat::x3dj).front();
    const auto json = nlohmann::json::parse(record_json(sector_record(source_of(sample.index), s, file.shapes)));
    const auto scene = nlohmann::json::parse(file.text);
    const auto carried = record_in(scene["X3D"]["Scene"]["-children"][0]["WorldInfo"]["-metadata"]["MetadataSet"]);
    EXPECT_EQ(carried["id"][0], json["id"]);
    EXPECT_EQ(carried["kind"][0], json["kind"]);
    EXPECT_EQ(carried.value("name", nlohmann::json{""})[0], json["name"]);
    EXPECT_EQ(carried.value("names", nlohmann::json::array()), json["names"]);
    EXPECT_EQ(carried["origin"], json["origin"]);
    EXPECT_EQ(carried["box"], json["box"]);
    EXPECT_EQ(carried["shapes"][0], json["shapes"]);
    EXPECT_EQ(carried["visible"], json["visible"]);
    EXPECT_EQ(carried.value("over_roofs", nlohmann::json::array()), json["over_roofs"]);
    ASSERT_EQ(carried["gate"].size(), json["gates"].size());
    for (std::size_t i = 0; i < json["gates"].size(); ++i) {
      EXPECT_EQ(carried["gate"][i].contains("to"), !json["gates"][i]["to"].is_null());
      EXPECT_EQ(carried["gate"][i]["line"].size(), 2 * json["gates"][i]["line"].size());
    }
    const std::size_t neighbours = json["neighbours"].size();
    ASSERT_EQ(carried["neighbour_ids"].size(), neighbours);
    ASSERT_EQ(carried["neighbour_origins"].size(), 2 * neighbours);
    ASSERT_EQ(carried["neighbour_boxes"].size(), 4 * neighbours);
    for (std::size_t i = 0; i < neighbours; ++i) {
      EXPECT_EQ(carried["neighbour_ids"][i], json["neighbours"][i]["id"]);
      for (std::size_t k = 0; k < 2; ++k)
        EXPECT_EQ(carried["neighbour_origins"][2 * i + k], json["neighbours"][i]["origin"][k]);
      for (std::size_t k = 0; k < 4; ++k)
        EXPECT_EQ(carried["neighbour_boxes"][4 * i + k], json["neighbours"][i]["box"][k]);
    }
    EXPECT_EQ(carried.value("bodies", nlohmann::json::array()).size(), 3 * json["bodies"].size());
    std::size_t points = 0;
    for (const auto& ring : json["ground"]) points += ring.size();
    EXPECT_EQ(carried["ground"].size(), 2 * points);
  }
}

TEST(SectorFiles, TellInFarOnesWhereTheyLeadAndInTallOnesNothing) {
  const Sample sample;
  for (const auto& s : sample.city.sectors) {
    const auto file = sector_files(sample.index, s, Detail::far, SceneFormat::x3dj).front();
    const auto json = nlohmann::json::parse(record_json(sector_record(source_of(sample.index), s, 1)));
    const auto scene = nlohmann::json::parse(file.text);
    const auto carried = record_in(scene["X3D"]["Scene"]["-children"][0]["WorldInfo"]["-metadata"]["MetadataSet"]);
    EXPECT_EQ(carried["id"][0], json["id"]);
    EXPECT_EQ(carried["box"], json["box"]);
    EXPECT_EQ(carried.value("over_roofs", nlohmann::json::array()), json["over_roofs"]);
    ASSERT_EQ(carried["neighbour_ids"].size(), json["neighbours"].size());
    for (std::size_t i = 0; i < json["neighbours"].size(); ++i)
      EXPECT_EQ(carried["neighbour_ids"][i], json["neighbours"][i]["id"]);
    EXPECT_FALSE(carried.contains("ground")) << "a near file tells that";
    for (const auto& tall : sector_files(sample.index, s, Detail::tall, SceneFormat::x3d))
      EXPECT_EQ(tall.text.find("RECORD"), std::string::npos);
  }
}

TEST(SectorRecord, ListsImportantSectorsAndPlacesThatBearAName) {
  Sample sample;
  const auto& yard = *sample.index.sector("s-yard");
  const auto node = record_node(sector_record(source_of(sample.index), yard, 1));
  bool has_important = false;
  for (const auto& field : node.nodes)
    for (const auto& item : field.nodes)
      for (const auto& value : item.fields)
        if (value.name == "name" && std::get<std::string>(value.value) == "important") has_important = true;
  EXPECT_TRUE(has_important);
  std::size_t named = 0;
  for (const auto& object : sample.city.objects) named += object.sector_id == "s-cross" && !object.name.empty();
  const auto cross = sector_record(source_of(sample.index), *sample.index.sector("s-cross"), 1);
  EXPECT_EQ(nlohmann::json::parse(record_json(cross))["places"].size(), named);
}

TEST(SectorRecord, NamesAShopOnceAndNotItsSignToo) {
  City city = test::sample_city();
  StandaloneObject shop;
  shop.id = "o-shop";
  shop.sector_id = "s-main-w";
  shop.kind = "shop";
  shop.name = "Bäckerei";
  city.objects.push_back(shop);
  const CityIndex index(city);
  const SectorRecord record = sector_record(source_of(index), *index.sector("s-main-w"), 0);
  ASSERT_EQ(record.places.size(), 1u) << "signs are no places";
  EXPECT_EQ(record.places.front().kind, "shop");
}

TEST(SectorFiles, HoldTheRecordInAnAnchorInVrml97) {
  const Sample sample;
  const auto text =
      sector_files(sample.index, *sample.index.sector("s-cross"), Detail::near, SceneFormat::vrml).front().text;
  EXPECT_NE(text.find("description \"vicus record\""), std::string::npos);
  const std::string key = "parameter [ \"";
  std::string json;
  for (std::size_t i = text.find(key) + key.size(); text[i] != '"'; ++i) json += text[i] == '\\' ? text[++i] : text[i];
  EXPECT_EQ(nlohmann::json::parse(json).at("name"), test::kAwkwardName);
}

TEST(SectorRecord, TellsWhyEachSectorIsListed) {
  const Sample sample;
  const auto json =
      nlohmann::json::parse(record_json(sector_record(source_of(sample.index), *sample.index.sector("s-yard"), 1)));
  EXPECT_EQ(json["visible"], (nlohmann::json{"s-cross", "s-main-w", "s-north", "s-passage", "s-yard"}));
  EXPECT_EQ(json["over_roofs"], (nlohmann::json{"s-main-w", "s-north"}));
  EXPECT_EQ(json["unresolved"], nlohmann::json::array({"s-north"}));
  EXPECT_EQ(json["visible_reasons"], (nlohmann::json{{"s-cross", "important"},
                                                     {"s-main-w", "over_roofs"},
                                                     {"s-north", "over_roofs"},
                                                     {"s-passage", "gate"},
                                                     {"s-yard", "self"}}));
  std::vector<std::string> boxes;
  for (const auto& n : json["neighbours"]) boxes.push_back(n["id"]);
  EXPECT_EQ(boxes, (std::vector<std::string>{"s-cross", "s-main-w", "s-north", "s-passage"}));
}

TEST(SectorRecord, KeepsGateNeighboursBesideImportantOnes) {
  Sample sample;
  std::erase_if(sample.city.visible, [](const Visible& v) { return v.reason != VisibleReason::important; });
  const CityIndex index(sample.city);
  const auto record = sector_record(source_of(index), *index.sector("s-yard"), 1);
  EXPECT_EQ(record.visible, (std::vector<std::string>{"s-cross", "s-passage", "s-yard"}));
}

TEST(SectorRecord, NamesGateNeighboursWhereNothingIsKnownToBeVisible) {
  Sample sample;
  sample.city.visible.clear();
  const CityIndex index(sample.city);
  const auto record = sector_record(source_of(index), *index.sector("s-passage"), 1);
  EXPECT_EQ(record.visible, (std::vector<std::string>{"s-main-e", "s-passage", "s-yard"}));
  ASSERT_EQ(record.neighbours.size(), 2u);
  EXPECT_EQ(record.neighbours[0].id, "s-main-e");
  EXPECT_EQ(record.neighbours[0].origin, index.sector("s-main-e")->origin);
}

std::vector<ExportFile> tall(const CityIndex& index, const std::string& id) {
  return sector_files(index, *index.sector(id), Detail::tall, SceneFormat::x3d);
}

/// Highest and lowest point, and the number of faces, of the only Shape.
struct Extent {
  double low_m = 1e9, high_m = -1e9;
  std::size_t faces = 0;
};
Extent extent_of(const std::string& text) {
  Extent extent;
  for (const auto& face : faces_in(text)) {
    ++extent.faces;
    for (const auto& p : face.corners) {
      extent.low_m = std::min<double>(extent.low_m, p.y);
      extent.high_m = std::max<double>(extent.high_m, p.y);
    }
  }
  return extent;
}

TEST(TallFiles, HoldTheHousesSeenOverRoofsAndNothingElse) {
  const Sample sample;
  for (const auto& s : sample.city.sectors)
    EXPECT_EQ(tall(sample.index, s.id).size(), s.id == "s-main-w" || s.id == "s-north" ? 1u : 0u) << s.id;
  const auto church = tall(sample.index, "s-main-w").front();
  EXPECT_EQ(church.path, "sectors/s-main-w.tall.x3d");
  EXPECT_EQ(church.shapes, 1);
  const Building& b10 = *sample.index.building("b-10");
  const auto extent = extent_of(church.text);
  EXPECT_DOUBLE_EQ(extent.high_m, wall_top_m(b10));
  EXPECT_DOUBLE_EQ(extent.low_m, 0);
  // Its roof, its side walls and its facade on this street; b-1 stands on the same street and is left out.
  EXPECT_EQ(extent.faces, b10.roof.facets[0].triangles.size() / 3 + b10.side_walls.size() + 1);
  EXPECT_EQ(church.text.find("RECORD"), std::string::npos);
}

TEST(TallFiles, GrowByEveryRowThatNamesAHouse) {
  Sample sample;
  sample.city.visible.push_back({"s-south", "s-main-w", VisibleReason::over_roofs, true, {"b-1", "b-10"}});
  const CityIndex index(sample.city);
  EXPECT_EQ(index.tall_houses_of("s-main-w"), (std::set<std::string>{"b-1", "b-10"}));
  EXPECT_GT(extent_of(tall(index, "s-main-w").front().text).faces,
            extent_of(tall(sample.index, "s-main-w").front().text).faces);
}

TEST(SectorRecord, HasEachObjectAsADiscAroundWhatIsDrawnOfIt) {
  const Sample sample;
  int bodies = 0;
  for (const auto& object : sample.city.objects) {
    if (object.kind == "sign") continue;  // above everybody's head
    const auto record = sector_record(source_of(sample.index), *sample.index.sector(object.sector_id), 1);
    ASSERT_EQ(record.bodies.size(), 1u) << object.id;
    EXPECT_EQ(record.bodies[0].at, object.at);
    double widest = 0;
    for (const auto& s : spindles_of(object))
      for (double up = 0.3; up <= 1.95; up += 0.01)
        if (up >= s.low_m && up <= s.high_m)
          widest = std::max(widest, std::lerp(s.radius_low_m, s.radius_high_m, (up - s.low_m) / (s.high_m - s.low_m)));
    EXPECT_NEAR(record.bodies[0].radius_m, widest, 0.02) << object.kind;
    ++bodies;
  }
  EXPECT_EQ(bodies, 3);
}

TEST(SectorRecord, KeepsAVisitorOutOfALowCrownAndLetsHimUnderAHighOne) {
  StandaloneObject tree{"t", "s", "tree", "", {}, 0, 4, 0, "", {}};
  EXPECT_GT(body_radius_m(tree), 0.8);
  tree.height_m = 10;
  EXPECT_DOUBLE_EQ(body_radius_m(tree), 0.2);
  tree.kind = "sign";
  EXPECT_EQ(body_radius_m(tree), 0);
}

TEST(SectorFiles, AreTheSameEachTime) {
  const Sample a, b;
  for (const auto& s : a.city.sectors) EXPECT_EQ(a.near(s.id).front().text, b.near(s.id).front().text);
}

}  // namespace
}  // namespace vicus
