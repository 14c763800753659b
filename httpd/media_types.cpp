#include "httpd/media_types.hpp"

#include <array>
#include <utility>

#include "x3d_export/writers.hpp"

namespace vicus {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 20> kMediaTypes = {{
    {".html", "text/html; charset=utf-8"},
    {".css", "text/css; charset=utf-8"},
    {".js", "text/javascript; charset=utf-8"},
    {".mjs", "text/javascript; charset=utf-8"},
    {".json", "application/json"},
    {".xml", "application/xml"},
    {".h", "text/plain; charset=utf-8"},
    {".frag", "text/plain; charset=utf-8"},
    {".vert", "text/plain; charset=utf-8"},
    {".txt", "text/plain; charset=utf-8"},
    {".md", "text/markdown; charset=utf-8"},
    {".svg", "image/svg+xml"},
    {".png", "image/png"},
    {".jpg", "image/jpeg"},
    {".webp", "image/webp"},
    {".avif", "image/avif"},
    {".wasm", "application/wasm"},
    {".woff2", "font/woff2"},
    {".glb", "model/gltf-binary"},
    {".hdr", "image/vnd.radiance"},
}};

}  // namespace

std::string_view media_type_of_file(std::string_view file_name) {
  for (const auto format : {SceneFormat::x3d, SceneFormat::vrml, SceneFormat::x3dj})
    if (file_name.ends_with(suffix_of(format))) return media_type_of(format);
  for (const auto& [suffix, media_type] : kMediaTypes)
    if (file_name.ends_with(suffix)) return media_type;
  return "";
}

bool is_compressible(std::string_view media_type) {
  if (media_type.starts_with("text/") || media_type.starts_with("application/")) return true;
  return media_type.starts_with("model/") || media_type.ends_with("+xml");
}

}  // namespace vicus
