#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "city_db/city.hpp"

/// A city on disk: one GeoPackage (DESIGN §4, city_db/FORMAT.md).
namespace vicus {

/// Writes the whole city into a temporary file beside `path`, then renames it into place, so that a broken build
/// leaves the old city whole. Artefacts are pulled one by one (`next_artefact` returns nullopt at the end), before any
/// record is written: what pulling changes in `city` (bytes of sectors, issues) is written, too.
/// Fails   CityError: cannot create, disk full, rename refused.
void write_city(const std::filesystem::path& path, const City& city,
                const std::function<std::optional<Artefact>()>& next_artefact);

/// Reads every record (not the artefacts).
/// Fails   CityError: no such file, not a Vicus city, damaged record; OtherVersionError: other format version.
City read_city(const std::filesystem::path& path);
/// Reads the records of some tables only (FORMAT.md has their names) and meta; none named: all.
City read_city(const std::filesystem::path& path, const std::set<std::string>& tables);

/// Number and bytes of the artefacts of one media type and coding.
struct ArtefactTotal {
  std::string media_type, coding;
  std::uint64_t count = 0, bytes = 0;
};

/// A city opened immutable, for serving: single records and artefacts by key. One per thread.
class CityReader {
 public:
  explicit CityReader(const std::filesystem::path& path);  ///< Fails  CityError as read_city.
  ~CityReader();
  CityReader(CityReader&&) noexcept;
  CityReader& operator=(CityReader&&) noexcept;

  /// Best row of `path` whose coding is listed in `codings`, in the order of that list.
  std::optional<Artefact> artefact(const std::string& path, const std::vector<std::string>& codings) const;
  /// All codings stored for the path, without bodies.
  std::vector<Artefact> artefact_codings(const std::string& path) const;
  /// By media type, then coding.
  std::vector<ArtefactTotal> artefact_totals() const;
  std::optional<std::string> meta(const std::string& key) const;
  std::vector<std::string> sector_ids() const;  ///< in id order
  std::optional<Sector> sector(const std::string& id) const;
  std::optional<Gate> gate(const std::string& id) const;
  std::optional<Building> building(const std::string& id) const;
  std::vector<Gate> gates_of(const std::string& sector_id) const;
  std::vector<Border> borders_of(const std::string& sector_id) const;
  std::vector<Building> buildings_of(const std::string& sector_id) const;  ///< whose roofs it sends
  std::vector<Facade> facades_of(const std::string& sector_id) const;
  std::vector<StandaloneObject> objects_of(const std::string& sector_id) const;
  std::vector<Surface> surfaces_of(const std::string& sector_id) const;
  std::vector<Ride> rides_of(const std::string& sector_id) const;
  Terrain terrain() const;                    ///< no nodes where the ground is flat
  std::vector<Prototype> prototypes() const;  ///< of the whole city
  std::vector<Viewpoint> viewpoints_of(const std::string& sector_id) const;
  std::optional<Interior> interior(const std::string& id) const;
  std::vector<Door> doors_of(const std::string& sector_id) const;
  std::vector<Visible> visible_from(const std::string& sector_id) const;
  std::vector<GateImpostor> impostors_of(const std::string& sector_id) const;
  std::optional<Panorama> panorama_of(const std::string& sector_id) const;
  /// Ids of the sectors whose box meets `box`, in id order, at most `limit`, after skipping `offset`.
  std::vector<std::string> sectors_in(const PlanBox& box, std::size_t limit, std::size_t offset) const;
  std::vector<Gate> gates_in(const PlanBox& box, std::size_t limit, std::size_t offset) const;
  std::vector<Building> buildings_in(const PlanBox& box, std::size_t limit, std::size_t offset) const;
  std::vector<Interior> interiors_in(const PlanBox& box, std::size_t limit, std::size_t offset) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace vicus
