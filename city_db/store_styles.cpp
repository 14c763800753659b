#include <cstdint>
#include <string>
#include <vector>

#include "city_db/store_schema.hpp"
#include "city_db/store_sqlite.hpp"

/// Default styles for QGIS (QML 3), so that a city opens as a readable map.
namespace vicus {
namespace {

/// One symbol, for the rows whose `attribute` has `value`, or for all rows.
struct Symbol {
  const char* value;
  const char* label;
  const char* fill;    ///< r,g,b,a; the stroke of a line
  const char* stroke;  ///< outline; unused for lines
  const char* size;    ///< mm: stroke width, or a marker's diameter
};

struct Style {
  const char* table;
  const char* type;       ///< fill, line, marker
  const char* attribute;  ///< column or expression that chooses; nullptr: the first symbol for all
  const char* label;      ///< QGIS expression; nullptr: none
  std::vector<Symbol> symbols;
};

constexpr const char* kGrey = "110,110,110,255";

const std::vector<Style>& styles() {
  static const std::vector<Style> kStyles = {
      {"domain", "fill", nullptr, nullptr, {{"", "domain", "250,248,242,255", kGrey, "0.3"}}},
      {"obstacle",
       "fill",
       "kind",
       nullptr,
       {{"water", "water", "166,200,230,255", "120,160,200,255", "0.1"},
        {"wall", "wall", "90,80,75,255", "90,80,75,255", "0.1"},
        {"fence", "fenced ground", "214,220,190,255", "150,160,110,255", "0.1"},
        {"island", "island", "190,190,185,255", kGrey, "0.1"},
        {"yard", "closed yard", "226,226,206,255", "190,190,160,255", "0.1"},
        {"courtyard", "closed courtyard", "232,226,214,255", "200,190,170,255", "0.1"}}},
      {"sector",
       "fill",
       "kind",
       "\"id\" || CASE WHEN \"name\" &lt;&gt; '' THEN '\\n' || \"name\" ELSE '' END",
       {{"street", "street", "255,232,160,200", "150,120,40,255", "0.2"},
        {"crossroads", "crossroads", "250,178,100,200", "170,100,30,255", "0.2"},
        {"square", "square", "244,160,160,200", "160,70,70,255", "0.2"},
        {"yard", "yard", "196,222,160,200", "100,130,60,255", "0.2"},
        {"passage", "passage", "200,180,230,200", "110,80,150,255", "0.2"},
        {"open", "open ground", "180,226,196,200", "80,140,100,255", "0.2"}}},
      {"building",
       "fill",
       "height_source",
       nullptr,
       {{"measured", "measured height", "139,94,60,255", "80,50,30,255", "0.1"},
        {"levels", "height from levels", "164,120,84,255", "80,50,30,255", "0.1"},
        {"guessed", "guessed height", "196,162,130,255", "80,50,30,255", "0.1"}}},
      {"interior", "fill", nullptr, "\"name\"", {{"", "room", "255,246,214,255", "150,120,60,255", "0.2"}}},
      {"door", "line", nullptr, nullptr, {{"", "door", "200,90,20,255", "", "0.8"}}},
      {"street", "line", nullptr, nullptr, {{"", "centre line", "130,130,130,160", "", "0.15"}}},
      {"facade",
       "line",
       "style",
       nullptr,
       {{"plaster", "plaster", "200,170,120,255", "", "0.6"},
        {"stone", "stone", "170,160,140,255", "", "0.6"},
        {"brick", "brick", "160,80,60,255", "", "0.6"},
        {"modern", "modern", "110,130,150,255", "", "0.6"},
        {"church", "church", "120,90,140,255", "", "0.6"},
        {"shed", "shed", "120,120,110,255", "", "0.6"}}},
      {"border",
       "line",
       "kind",
       nullptr,
       {{"facade", "facade", "92,58,33,255", "", "0.3"},
        {"wall", "wall", "60,60,60,255", "", "0.5"},
        {"fence", "fence", "120,140,60,255", "", "0.3"},
        {"bank", "bank", "50,110,180,255", "", "0.4"},
        {"edge", "edge", "150,150,150,255", "", "0.2"}}},
      {"gate",
       "line",
       "CASE WHEN \"to_sector_id\" IS NULL THEN 'out' ELSE 'in' END",
       nullptr,
       {{"in", "gate to another sector", "20,160,60,255", "", "0.7"},
        {"out", "end of the city", "220,30,30,255", "", "0.7"}}},
      {"impostor", "line", nullptr, nullptr, {{"", "picture beyond a gate", "200,120,220,255", "", "0.3"}}},
      {"panorama", "marker", nullptr, nullptr, {{"", "panorama", "200,120,220,255", "110,50,130,255", "1.6"}}},
      {"object", "marker", nullptr, nullptr, {{"", "object", "60,150,80,255", "30,80,40,255", "1.4"}}},
      {"viewpoint", "marker", nullptr, "\"name\"", {{"", "viewpoint", "60,100,220,255", "20,40,110,255", "1.8"}}},
      {"issue", "marker", nullptr, "\"code\"", {{"", "issue", "230,20,20,255", "120,0,0,255", "2.2"}}}};
  return kStyles;
}

std::string escaped(const std::string& s) {
  std::string out;
  for (const char c : s) {
    if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

std::string property(const char* key, const std::string& value) {
  return std::string("<prop k=\"") + key + "\" v=\"" + value + "\"/>";
}

std::string symbol_xml(const Style& style, const Symbol& symbol, std::size_t i) {
  std::string layer;
  const std::string type = style.type;
  if (type == "fill")
    layer = "<layer class=\"SimpleFill\" enabled=\"1\" pass=\"0\" locked=\"0\">" + property("color", symbol.fill) +
            property("style", "solid") + property("outline_color", symbol.stroke) + property("outline_style", "solid") +
            property("outline_width", symbol.size) + property("outline_width_unit", "MM");
  else if (type == "line")
    layer = "<layer class=\"SimpleLine\" enabled=\"1\" pass=\"0\" locked=\"0\">" + property("line_color", symbol.fill) +
            property("line_style", "solid") + property("line_width", symbol.size) + property("line_width_unit", "MM") +
            property("capstyle", "flat");
  else
    layer = "<layer class=\"SimpleMarker\" enabled=\"1\" pass=\"0\" locked=\"0\">" + property("name", "circle") +
            property("color", symbol.fill) + property("outline_color", symbol.stroke) + property("size", symbol.size) +
            property("size_unit", "MM");
  return "<symbol type=\"" + type + "\" name=\"" + std::to_string(i) + "\" alpha=\"1\" clip_to_extent=\"1\">" + layer +
         "</layer></symbol>";
}

std::string qml_from(const Style& style) {
  const bool is_categorized = style.attribute != nullptr;
  std::string categories, symbols;
  for (std::size_t i = 0; i < style.symbols.size(); ++i) {
    const Symbol& s = style.symbols[i];
    symbols += symbol_xml(style, s, i);
    categories += std::string("<category render=\"true\" value=\"") + s.value + "\" label=\"" + s.label +
                  "\" symbol=\"" + std::to_string(i) + "\"/>";
  }
  std::string qml =
      "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"
      "<qgis version=\"3.22\" styleCategories=\"Symbology|Labeling\" labelsEnabled=\"" +
      std::string(style.label != nullptr ? "1" : "0") + "\">\n<renderer-v2 symbollevels=\"0\" enableorderby=\"0\" " +
      (is_categorized ? "type=\"categorizedSymbol\" attr=\"" + escaped(style.attribute) + "\""
                      : "type=\"singleSymbol\"") +
      ">";
  if (is_categorized) qml += "<categories>" + categories + "</categories>";
  qml += "<symbols>" + symbols + "</symbols></renderer-v2>\n";
  if (style.label != nullptr)
    qml += "<labeling type=\"simple\"><settings calloutType=\"simple\"><text-style fieldName=\"" +
           escaped(style.label) +
           "\" isExpression=\"1\" fontSize=\"7\" fontSizeUnit=\"Point\" textColor=\"40,40,40,255\" fontFamily=\"Sans\">"
           "<text-buffer bufferDraw=\"1\" bufferSize=\"0.7\" bufferSizeUnits=\"MM\" bufferColor=\"255,255,255,255\"/>"
           "</text-style><rendering obstacle=\"1\" drawLabels=\"1\"/></settings></labeling>\n";
  return qml + "</qgis>\n";
}

}  // namespace

void create_styles(Database& db) {
  db.execute(
      "CREATE TABLE layer_styles (id INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, f_table_catalog TEXT(256),"
      "f_table_schema TEXT(256), f_table_name TEXT(256), f_geometry_column TEXT(256), styleName TEXT(30),"
      "styleQML TEXT, styleSLD TEXT, useAsDefault BOOLEAN, description TEXT(256), owner TEXT(30), ui TEXT(30),"
      "update_time DATETIME DEFAULT CURRENT_TIMESTAMP)");
  db.execute(
      "INSERT INTO gpkg_contents (table_name, data_type, identifier, description, last_change)"
      "VALUES ('layer_styles', 'attributes', 'layer_styles', 'styles for QGIS', '2000-01-01T00:00:00.000Z')");
  auto insert = db.prepare(
      "INSERT INTO layer_styles (f_table_catalog, f_table_schema, f_table_name, f_geometry_column, styleName, styleQML,"
      "styleSLD, useAsDefault, description, owner, update_time)"
      "VALUES ('', '', ?1, 'geom', 'vicus', ?2, '', 1, 'default style', 'vicus', '2000-01-01T00:00:00.000Z')");
  for (const auto& style : styles()) {
    insert.bind(0, style.table);
    insert.bind(1, qml_from(style));
    insert.run();
  }
}

}  // namespace vicus
