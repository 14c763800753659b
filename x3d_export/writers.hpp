#pragma once
#include <string>

#include "x3d_export/scene.hpp"

/// A scene tree as a file: three formats, one table of fields.
namespace vicus {

enum class SceneFormat { x3d, vrml, x3dj };

inline constexpr const char* kGenerator = "Vicus";

/// X3D 4.0 XML, Interchange profile and the components the nodes need (ISO/IEC 19776-1).
/// Valid against the X3D 4.0 XSD and DTD.
std::string write_x3d(const Scene& scene);
std::size_t size_in_x3d(const Node& node);

/// VRML97 (ISO/IEC 14772-1). Nodes and fields that VRML97 does not have are left out, an Inline whose `load` is FALSE
/// too: there an unloaded Inline is one that is not there (paper 004 §5).
std::string write_vrml(const Scene& scene);
std::size_t size_in_vrml(const Node& node);

/// X3D JSON (ISO/IEC 19776-5).
std::string write_x3dj(const Scene& scene);
std::size_t size_in_x3dj(const Node& node);

std::string write_scene(const Scene& scene, SceneFormat format);
/// Bytes that a node takes among a scene's nodes.
std::size_t written_size(const Node& node, SceneFormat format);
/// The same of a node that is written in this format alone from now on: the text of its numbers is kept in it.
std::size_t settled_size(Node& node, SceneFormat format);
/// ".x3d", ".wrl", ".x3dj".
const char* suffix_of(SceneFormat format);
const char* media_type_of(SceneFormat format);

}  // namespace vicus
