#pragma once
#include <string>

#include "httpd/message.hpp"
#include "httpd/routes.hpp"
#include "tests/support/sample_city.hpp"
#include "tests/support/scratch.hpp"
#include "x3d_export/coding.hpp"
#include "x3d_export/package.hpp"

/// The sample city in a file, with its artefacts, and routes over it.
namespace vicus::test {

inline void write_sample(const std::filesystem::path& path, const std::string& name_of_cross = "") {
  City city = sample_city();
  if (!name_of_cross.empty())
    for (auto& sector : city.sectors)
      if (sector.id == "s-cross") sector.name = name_of_cross;
  PackageOptions options;
  options.threads = 1;
  options.brotli_quality = 4;
  const auto next = export_artefacts(city, options);
  write_city(path, city, next);
}

/// A folder that looks like the package x_ite to those who look for it.
inline void write_x_ite(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder / "dist" / "assets");
  write_bytes(folder / "package.json", R"({"name": "x_ite", "version": "15.0.1"})");
  std::string script;
  for (int i = 0; i < 2000; ++i) script += "export const x" + std::to_string(i) + " = 1;\n";
  write_bytes(folder / "dist" / "x_ite.min.mjs", script);
  write_bytes(folder / "dist" / "assets" / "a.wasm", std::string("\0asm\1\0\0\0", 8));
  write_bytes(folder / "dist" / "x_ite.zip", "no business of browsers");
  write_bytes(folder / "secret.json", "{}");
}

struct ServedCity {
  ServedCity() {
    write_sample(path());
    write_x_ite(scratch / "x_ite");
  }
  std::filesystem::path path() const { return scratch / "city.gpkg"; }
  Routes routes() const {
    return Routes(path(), std::make_shared<const StaticFiles>(scratch / "x_ite"), std::make_shared<Metrics>());
  }

  ScratchDirectory scratch;
};

}  // namespace vicus::test
