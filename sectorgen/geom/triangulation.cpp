#include "sectorgen/geom/triangulation.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cassert>
#include <numeric>

#include "city_db/issues.hpp"
#include "sectorgen/geom/predicates.hpp"

namespace vicus {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<std::uint32_t, Kernel,
                                                           CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Cdt =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

/// Sorted unique points, the mesh's own numbering, independent of input order; and each input point's number in it.
struct Numbering {
  std::vector<PlanPoint> points;
  std::vector<std::uint32_t> of;
};

Numbering number_points(const std::vector<PlanPoint>& points) {
  std::vector<std::pair<PlanPoint, std::uint32_t>> sorted(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) sorted[i] = {points[i], i};
  std::sort(sorted.begin(), sorted.end());
  Numbering out;
  out.of.resize(points.size());
  for (const auto& [p, i] : sorted) {
    if (out.points.empty() || out.points.back() != p) out.points.push_back(p);
    out.of[i] = static_cast<std::uint32_t>(out.points.size() - 1);
  }
  return out;
}

Mesh flatten(const Cdt& cdt, const std::vector<PlanPoint>& points) {
  Mesh mesh;
  mesh.points = points;
  mesh.triangles.resize(cdt.number_of_faces());
  std::uint32_t count = 0;
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f) f->info() = count++;
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f) {
    Triangle& t = mesh.triangles[f->info()];
    for (int k = 0; k < 3; ++k) {
      const auto s = static_cast<std::size_t>(k);
      t.corner[s] = f->vertex(k)->info();
      t.neighbour[s] = cdt.is_infinite(f->neighbor(k)) ? kNone : f->neighbor(k)->info();
      t.edge[s] = f->is_constrained(k) ? 0 : kNone;
    }
  }
  return mesh;
}

/// Turns the diagonal bd between t = (a,b,d) and its neighbour (c,d,b) into ac: t = (a,b,c), neighbour = (a,c,d).
///
///        d                 d
///      / | \             /   \.
///     a  |  c    ->     a-----c
///      \ | /             \   /
///        b                 b
void flip(Mesh& mesh, std::uint32_t t, int k) {
  const std::uint32_t n = mesh.triangles[t].neighbour[static_cast<std::size_t>(k)];
  const int m = mesh.twin_side(t, k);
  Triangle& left = mesh.triangles[t];
  Triangle& right = mesh.triangles[n];
  const auto i = [](int v) { return static_cast<std::size_t>(v % 3); };
  const std::uint32_t a = left.corner[i(k)], b = left.corner[i(k + 1)], d = left.corner[i(k + 2)],
                      c = right.corner[i(m)];
  const std::uint32_t left_b = left.neighbour[i(k + 1)], left_d = left.neighbour[i(k + 2)];
  const std::uint32_t edge_b = left.edge[i(k + 1)], edge_d = left.edge[i(k + 2)];
  const std::uint32_t right_d = right.neighbour[i(m + 1)], right_b = right.neighbour[i(m + 2)];
  const std::uint32_t redge_d = right.edge[i(m + 1)], redge_b = right.edge[i(m + 2)];
  left.corner = {a, b, c};
  left.neighbour = {right_d, n, left_d};
  left.edge = {redge_d, kNone, edge_d};
  right.corner = {a, c, d};
  right.neighbour = {right_b, left_b, t};
  right.edge = {redge_b, edge_b, kNone};
  const auto relink = [&](std::uint32_t outer, std::uint32_t was, std::uint32_t now) {
    if (outer == kNone || was == now) return;
    for (auto& x : mesh.triangles[outer].neighbour)
      if (x == was) {
        x = now;
        return;
      }
  };
  relink(right_d, n, t);
  relink(left_b, t, n);
}

/// Among cocircular quadrilaterals takes the diagonal at the smallest vertex. Ends: each flip gives the smallest vertex
/// of a cocircular set one more diagonal, and only the fan at that vertex is at rest.
void canonicalise(Mesh& mesh) {
  std::vector<std::uint32_t> queue(mesh.triangles.size());
  std::iota(queue.begin(), queue.end(), 0u);
  while (!queue.empty()) {
    const std::uint32_t t = queue.back();
    queue.pop_back();
    for (int k = 0; k < 3; ++k) {
      const auto s = static_cast<std::size_t>(k);
      const std::uint32_t n = mesh.triangles[t].neighbour[s];
      if (n == kNone || mesh.triangles[t].edge[s] != kNone) continue;
      const std::uint32_t a = mesh.corner(t, k), b = mesh.corner(t, k + 1), d = mesh.corner(t, k + 2);
      const std::uint32_t c = mesh.corner(n, mesh.twin_side(t, k));
      if (std::min(a, c) > std::min(b, d)) continue;
      const auto& p = mesh.points;
      if (in_circle(p[a], p[b], p[d], p[c]) != 0 || orient(p[a], p[b], p[c]) <= 0 || orient(p[a], p[c], p[d]) <= 0)
        continue;
      flip(mesh, t, k);
      queue.push_back(t);
      queue.push_back(n);
      break;
    }
  }
}

/// Smallest corner first, triangles in lexicographic order.
void sort_triangles(Mesh& mesh) {
  for (auto& t : mesh.triangles) {
    const auto first = std::min_element(t.corner.begin(), t.corner.end()) - t.corner.begin();
    std::rotate(t.corner.begin(), t.corner.begin() + first, t.corner.end());
    std::rotate(t.neighbour.begin(), t.neighbour.begin() + first, t.neighbour.end());
    std::rotate(t.edge.begin(), t.edge.begin() + first, t.edge.end());
  }
  std::vector<std::uint32_t> order(mesh.triangles.size()), place(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return mesh.triangles[a].corner < mesh.triangles[b].corner; });
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  std::vector<Triangle> sorted(mesh.triangles.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    sorted[i] = mesh.triangles[order[i]];
    for (auto& n : sorted[i].neighbour)
      if (n != kNone) n = place[n];
  }
  mesh.triangles = std::move(sorted);
}

/// Numbers of the input edges into the mesh; throws when one is missing, that is, was not noded.
void number_edges(Mesh& mesh, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& keys,
                  const std::vector<std::uint32_t>& numbers) {
  for (auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      if (t.edge[k] == kNone) continue;
      const std::uint32_t u = t.corner[(k + 1) % 3], v = t.corner[(k + 2) % 3];
      const auto key = std::make_pair(std::min(u, v), std::max(u, v));
      const auto it = std::lower_bound(keys.begin(), keys.end(), key);
      if (it == keys.end() || *it != key) throw CityError("triangulation: an edge passes through a point (not noded)");
      t.edge[k] = numbers[static_cast<std::size_t>(it - keys.begin())];
    }
}

}  // namespace

int Mesh::twin_side(std::uint32_t t, int k) const {
  const std::uint32_t n = triangles[t].neighbour[static_cast<std::size_t>(k)];
  const std::uint32_t b = corner(t, k + 1);
  // Two triangles share at most one edge in a valid triangulation of more than two points.
  for (int m = 0; m < 3; ++m)
    if (triangles[n].neighbour[static_cast<std::size_t>(m)] == t && corner(n, m + 2) == b) return m;
  assert(false);
  return 0;
}

Mesh triangulate_edges(const std::vector<PlanPoint>& points, const std::vector<Edge>& edges) {
  Numbering numbering = number_points(points);
  const std::vector<PlanPoint>& unique = numbering.points;
  std::vector<std::pair<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>> keyed;
  keyed.reserve(edges.size());
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    const std::uint32_t a = numbering.of[edges[i].a], b = numbering.of[edges[i].b];
    if (a != b) keyed.push_back({{std::min(a, b), std::max(a, b)}, i});
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> keys;
  std::vector<std::uint32_t> numbers;
  for (const auto& [key, number] : keyed)
    if (keys.empty() || keys.back() != key) {
      keys.push_back(key);
      numbers.push_back(number);
    }

  Cdt cdt;
  std::vector<std::pair<Kernel::Point_2, std::uint32_t>> with_info;
  with_info.reserve(unique.size());
  for (std::uint32_t i = 0; i < unique.size(); ++i)
    with_info.emplace_back(Kernel::Point_2(unique[i].x, unique[i].y), i);
  cdt.insert(with_info.begin(), with_info.end());
  std::vector<Cdt::Vertex_handle> handles(unique.size());
  for (auto v = cdt.finite_vertices_begin(); v != cdt.finite_vertices_end(); ++v) handles[v->info()] = v;
  try {
    for (const auto& [a, b] : keys) cdt.insert_constraint(handles[a], handles[b]);
  } catch (const std::exception&) {
    throw CityError("triangulation: two edges cross (not noded)");
  }
  if (cdt.dimension() < 2) return {unique, {}};
  Mesh mesh = flatten(cdt, unique);
  canonicalise(mesh);
  sort_triangles(mesh);
  number_edges(mesh, keys, numbers);
  return mesh;
}

}  // namespace vicus
