#include <array>
#include <utility>

#include "city_db/city.hpp"

namespace vicus {
namespace {

template <class E>
using Names = std::initializer_list<std::pair<E, const char*>>;

constexpr Names<SectorKind> kSectorKinds = {{SectorKind::street, "street"},    {SectorKind::crossroads, "crossroads"},
                                            {SectorKind::square, "square"},    {SectorKind::yard, "yard"},
                                            {SectorKind::passage, "passage"},  {SectorKind::open, "open"},
                                            {SectorKind::interior, "interior"}};
constexpr Names<GateKind> kGateKinds = {{GateKind::street, "street"},
                                        {GateKind::yard, "yard"},
                                        {GateKind::kerb, "kerb"},
                                        {GateKind::passage, "passage"},
                                        {GateKind::end_of_city, "end_of_city"}};
constexpr Names<BorderKind> kBorderKinds = {{BorderKind::facade, "facade"},
                                            {BorderKind::wall, "wall"},
                                            {BorderKind::fence, "fence"},
                                            {BorderKind::bank, "bank"},
                                            {BorderKind::edge, "edge"}};
constexpr Names<ObstacleKind> kObstacleKinds = {{ObstacleKind::water, "water"}, {ObstacleKind::wall, "wall"},
                                                {ObstacleKind::fence, "fence"}, {ObstacleKind::island, "island"},
                                                {ObstacleKind::yard, "yard"},   {ObstacleKind::courtyard, "courtyard"}};
constexpr Names<HeightSource> kHeightSources = {
    {HeightSource::measured, "measured"}, {HeightSource::levels, "levels"}, {HeightSource::guessed, "guessed"}};
constexpr Names<RoofSource> kRoofSources = {
    {RoofSource::tagged, "tagged"}, {RoofSource::neighbours, "neighbours"},       {RoofSource::rule, "rule"},
    {RoofSource::preset, "preset"}, {RoofSource::flat_fallback, "flat_fallback"}, {RoofSource::model, "model"}};
constexpr Names<FacetKind> kFacetKinds = {
    {FacetKind::slope, "slope"}, {FacetKind::top, "top"}, {FacetKind::gable, "gable"}, {FacetKind::step, "step"}};
constexpr Names<VisibleReason> kVisibleReasons = {{VisibleReason::self, "self"},
                                                  {VisibleReason::gate, "gate"},
                                                  {VisibleReason::line_of_sight, "line_of_sight"},
                                                  {VisibleReason::over_roofs, "over_roofs"},
                                                  {VisibleReason::important, "important"}};
constexpr Names<Importance> kImportances = {
    {Importance::none, "none"}, {Importance::proposed, "proposed"}, {Importance::author, "author"}};
constexpr Names<FacadeStyle> kFacadeStyles = {{FacadeStyle::plaster, "plaster"}, {FacadeStyle::stone, "stone"},
                                              {FacadeStyle::brick, "brick"},     {FacadeStyle::modern, "modern"},
                                              {FacadeStyle::church, "church"},   {FacadeStyle::shed, "shed"}};
constexpr Names<SurfaceKind> kSurfaceKinds = {
    {SurfaceKind::pavement, "pavement"}, {SurfaceKind::carriageway, "carriageway"},
    {SurfaceKind::paving, "paving"},     {SurfaceKind::path, "path"},
    {SurfaceKind::grass, "grass"},       {SurfaceKind::earth, "earth"},
    {SurfaceKind::water, "water"},       {SurfaceKind::steps, "steps"},
    {SurfaceKind::rail, "rail"},         {SurfaceKind::kerb, "kerb"}};
constexpr Names<IssueCode> kIssueCodes = {{IssueCode::unreadable_feature, "unreadable_feature"},
                                          {IssueCode::outside_limits, "outside_limits"},
                                          {IssueCode::unknown_attribute_value, "unknown_attribute_value"},
                                          {IssueCode::unknown_place, "unknown_place"},
                                          {IssueCode::terrain_hole, "terrain_hole"},
                                          {IssueCode::unused_model, "unused_model"},
                                          {IssueCode::ring_open, "ring_open"},
                                          {IssueCode::ring_self_intersection, "ring_self_intersection"},
                                          {IssueCode::ring_too_few_points, "ring_too_few_points"},
                                          {IssueCode::duplicate, "duplicate"},
                                          {IssueCode::sliver, "sliver"},
                                          {IssueCode::overlap, "overlap"},
                                          {IssueCode::gap, "gap"},
                                          {IssueCode::building_in_street, "building_in_street"},
                                          {IssueCode::no_height, "no_height"},
                                          {IssueCode::absurd_height, "absurd_height"},
                                          {IssueCode::hole_outside, "hole_outside"},
                                          {IssueCode::incomplete_relation, "incomplete_relation"},
                                          {IssueCode::part_outside, "part_outside"},
                                          {IssueCode::roof_flattened, "roof_flattened"},
                                          {IssueCode::model_unused, "model_unused"},
                                          {IssueCode::unmapped_street, "unmapped_street"},
                                          {IssueCode::street_too_short, "street_too_short"},
                                          {IssueCode::unmapped_passage, "unmapped_passage"},
                                          {IssueCode::over_budget, "over_budget"},
                                          {IssueCode::yard_closed, "yard_closed"},
                                          {IssueCode::not_reached, "not_reached"},
                                          {IssueCode::sight_over_budget, "sight_over_budget"},
                                          {IssueCode::room_outside, "room_outside"},
                                          {IssueCode::room_too_small, "room_too_small"},
                                          {IssueCode::room_without_door, "room_without_door"},
                                          {IssueCode::door_off_wall, "door_off_wall"},
                                          {IssueCode::room_on_other_level, "room_on_other_level"}};

template <class E>
const char* find_name(const Names<E>& names, E value) {
  for (const auto& [v, n] : names)
    if (v == value) return n;
  return "?";
}

template <class E>
bool find_value(const Names<E>& names, const std::string& name, E& value) {
  for (const auto& [v, n] : names)
    if (name == n) return value = v, true;
  return false;
}

}  // namespace

const char* name_of(SectorKind k) { return find_name(kSectorKinds, k); }
const char* name_of(GateKind k) { return find_name(kGateKinds, k); }
const char* name_of(BorderKind k) { return find_name(kBorderKinds, k); }
const char* name_of(ObstacleKind k) { return find_name(kObstacleKinds, k); }
const char* name_of(HeightSource s) { return find_name(kHeightSources, s); }
const char* name_of(RoofSource s) { return find_name(kRoofSources, s); }
const char* name_of(FacetKind k) { return find_name(kFacetKinds, k); }
const char* name_of(VisibleReason r) { return find_name(kVisibleReasons, r); }
const char* name_of(Importance i) { return find_name(kImportances, i); }
const char* name_of(FacadeStyle s) { return find_name(kFacadeStyles, s); }
const char* name_of(SurfaceKind k) { return find_name(kSurfaceKinds, k); }
const char* name_of(IssueCode c) { return find_name(kIssueCodes, c); }
bool parse_name(const std::string& s, SectorKind& k) { return find_value(kSectorKinds, s, k); }
bool parse_name(const std::string& s, GateKind& k) { return find_value(kGateKinds, s, k); }
bool parse_name(const std::string& s, BorderKind& k) { return find_value(kBorderKinds, s, k); }
bool parse_name(const std::string& s, ObstacleKind& k) { return find_value(kObstacleKinds, s, k); }
bool parse_name(const std::string& s, HeightSource& k) { return find_value(kHeightSources, s, k); }
bool parse_name(const std::string& s, RoofSource& k) { return find_value(kRoofSources, s, k); }
bool parse_name(const std::string& s, FacetKind& k) { return find_value(kFacetKinds, s, k); }
bool parse_name(const std::string& s, VisibleReason& k) { return find_value(kVisibleReasons, s, k); }
bool parse_name(const std::string& s, Importance& k) { return find_value(kImportances, s, k); }
bool parse_name(const std::string& s, FacadeStyle& k) { return find_value(kFacadeStyles, s, k); }
bool parse_name(const std::string& s, SurfaceKind& k) { return find_value(kSurfaceKinds, s, k); }

}  // namespace vicus
