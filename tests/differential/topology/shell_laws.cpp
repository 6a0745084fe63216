#include <algorithm>
#include <cmath>
#include <set>

#include "finding.hpp"
#include "structure_laws.hpp"

namespace {

bool near(double a, double b, double tolerance) {
  return std::abs(a - b) <= tolerance;
}

class Shells {
 public:
  Shells(const LibraryTopology &topology, const oracle::Balls &balls)
      : topology_(topology),
        balls_(balls),
        counts_(topology.counts()),
        shells_(topology.shells()),
        components_(topology.components()),
        cells_(topology.cells()),
        edges_(topology.edges()),
        faces_(topology.faces()) {}

  std::string first_broken() {
    check_sizes();
    check_components();
    check_cells();
    if (finding_.any()) return finding_.text();
    check_nesting();
    check_start();
    for (std::uint32_t shell = 0; shell < shells_.size() && !finding_.any(); ++shell) check_scan(shell);
    check_measures();
    return finding_.text();
  }

 private:
  void check_sizes() {
    const std::size_t n = shells_.size();
    std::vector<std::uint32_t> maximal(n, 0);
    std::vector<std::uint32_t> simple(n, 0);
    std::vector<std::uint32_t> edges(n, 0);
    std::vector<std::uint32_t> vertices(n, 0);
    std::vector<std::int64_t> euler(n, 0);
    const std::vector<hsp_face> boundary_faces = topology_.boundary().faces();
    for (const hsp_face &face : boundary_faces) {
      ++maximal[face.shell];
      euler[face.shell] += 2 - std::int64_t{face.loops};
    }
    // Vertices and arcs of the boundary: 3 arcs at each vertex; every vertex belongs to the shell of its faces.
    std::vector<std::uint32_t> shell_of_vertex(counts_.vertices, HSP_NONE);
    for (const hsp_topology_edge &edge : edges_) {
      const std::uint32_t shell = faces_[edge.face[0]].shell;
      finding_.require(shell == faces_[edge.face[1]].shell, "an edge between two shells");
      ++edges[shell];
      for (const std::uint32_t v : edge.vertex) {
        finding_.require(shell_of_vertex[v] == HSP_NONE || shell_of_vertex[v] == shell, "a vertex of two shells");
        shell_of_vertex[v] = shell;
      }
    }
    for (const hsp_arc &arc : topology_.boundary().arcs()) --euler[boundary_faces[arc.face[0]].shell];
    for (std::uint32_t v = 0; v < topology_.boundary().counts().vertices; ++v) ++euler[shell_of_vertex[v]];
    for (const std::uint32_t shell : shell_of_vertex) ++vertices[shell];
    for (const hsp_simple_face &face : faces_) ++simple[face.shell];
    for (std::uint32_t s = 0; s < n; ++s) {
      const hsp_shell &shell = shells_[s];
      finding_.require(shell.faces == maximal[s] && shell.simple_faces == simple[s], "faces of shell", s);
      finding_.require(shell.edges == edges[s] && shell.vertices == vertices[s], "edges or vertices of shell", s);
      const std::int64_t own = std::int64_t{shell.vertices} - shell.edges + shell.simple_faces;
      finding_.require(shell.euler == own, "shell", s, "has an Euler characteristic of", own, "not", shell.euler);
      finding_.require(shell.euler == euler[s], "shell", s, "has, by its maximal faces,", euler[s]);
      finding_.require(shell.euler % 2 == 0 && shell.euler <= 2, "Euler characteristic of shell", s);
      finding_.require(std::int64_t{shell.genus} == 1 - shell.euler / 2, "genus of shell", s);
    }
  }

  void check_components() {
    std::vector<std::uint32_t> members(components_.size(), 0);
    std::vector<std::int64_t> top(components_.size(), INT64_MIN);
    const std::vector<hsp_ball> balls = topology_.boundary().balls();
    for (std::size_t i = 0; i < balls.size(); ++i) {
      ++members[balls[i].component];
      top[balls[i].component] = std::max(top[balls[i].component], balls_[i].z + balls_[i].radius);
    }
    for (std::uint32_t c = 0; c < components_.size(); ++c) {
      const hsp_component &component = components_[c];
      finding_.require(component.balls == members[c], "balls of component", c);
      finding_.require(component.reserved == 0, "reserved field of component", c);
      if (finding_.require(component.top_ball < balls_.size(), "top ball of component", c)) {
        const oracle::LatticeBall &ball = balls_[component.top_ball];
        finding_.require(balls[component.top_ball].component == c, "the top ball of component", c, "is another's");
        finding_.require(ball.z + ball.radius == top[c], "the top ball of component", c, "is not the highest");
        finding_.require(balls[component.top_ball].faces > 0, "the top ball of component", c, "is buried");
      }
      std::uint32_t own = 0;
      std::uint32_t outer = 0;
      for (std::uint32_t s = 0; s < shells_.size(); ++s) {
        if (shells_[s].component != c) continue;
        ++own;
        if (shells_[s].kind != HSP_SHELL_OUTER) continue;
        ++outer;
        finding_.require(component.outer_shell == s, "outer shell of component", c);
        finding_.require(component.cell == shells_[s].cell, "cell of component", c);
      }
      finding_.require(outer == 1, "component", c, "has", outer, "outer shells");
      finding_.require(component.shells == own, "number of shells of component", c);
    }
    // The shells of faces belong to the components of their balls.
    for (const hsp_simple_face &face : faces_)
      finding_.require(shells_[face.shell].component == balls[face.ball].component, "component of a shell");
  }

  void check_cells() {
    finding_.require(!cells_.empty() && cells_.front().wall == HSP_NONE, "cell 0 has a wall");
    std::vector<std::set<std::uint32_t>> shells_of(cells_.size());
    std::vector<std::uint32_t> components_in(cells_.size(), 0);
    std::uint32_t last_wall = 0;
    for (std::uint32_t s = 0; s < shells_.size(); ++s) {
      const hsp_shell &shell = shells_[s];
      if (!finding_.require(shell.cell < cells_.size(), "cell of shell", s)) return;
      shells_of[shell.cell].insert(s);
      if (shell.kind == HSP_SHELL_OUTER) {
        ++components_in[shell.cell];
        continue;
      }
      finding_.require(shell.kind == HSP_SHELL_VOID, "kind of shell", s);
      finding_.require(cells_[shell.cell].wall == s, "shell", s, "is not the wall of its void");
      // Voids are numbered in the order of their shells.
      finding_.require(shell.cell > last_wall, "order of the voids at shell", s);
      last_wall = shell.cell;
    }
    for (std::uint32_t c = 0; c < cells_.size(); ++c) {
      finding_.require(cells_[c].shells == shells_of[c].size(), "number of shells of cell", c);
      finding_.require(cells_[c].components == components_in[c], "number of components in cell", c);
      finding_.require(cells_[c].reserved == 0, "reserved field of cell", c);
      const std::vector<std::uint32_t> listed = topology_.cell_shells(c);
      finding_.require(std::equal(listed.begin(), listed.end(), shells_of[c].begin(), shells_of[c].end()),
                       "shells of cell", c);
      if (c > 0 && finding_.require(cells_[c].wall < shells_.size(), "wall of cell", c))
        finding_.require(shells_[cells_[c].wall].kind == HSP_SHELL_VOID && shells_[cells_[c].wall].cell == c,
                         "wall of cell", c);
    }
  }

  /// From every component outward one comes to cell 0.
  void check_nesting() {
    for (std::uint32_t c = 0; c < components_.size(); ++c) {
      std::uint32_t cell = components_[c].cell;
      for (std::size_t steps = 0; cell != 0; ++steps) {
        if (!finding_.require(steps <= components_.size(), "component", c, "lies inside itself")) return;
        cell = components_[shells_[cells_[cell].wall].component].cell;
      }
    }
  }

  void check_start() {
    if (balls_.empty()) {
      finding_.require(counts_.start_face == HSP_NONE, "a start without balls");
      return;
    }
    std::int64_t top = INT64_MIN;
    for (const oracle::LatticeBall &ball : balls_) top = std::max(top, ball.z + ball.radius);
    if (!finding_.require(counts_.start_face < faces_.size(), "start face")) return;
    const hsp_simple_face &start = faces_[counts_.start_face];
    finding_.require(balls_[start.ball].z + balls_[start.ball].radius == top, "the start is not on the highest ball");
    finding_.require(shells_[start.shell].kind == HSP_SHELL_OUTER && shells_[start.shell].cell == 0,
                     "the start is not on the outside");
    finding_.require(shells_[start.shell].start_face == counts_.start_face, "the shell of the start begins elsewhere");
    for (const hsp_component &component : components_) {
      const hsp_shell &outer = shells_[component.outer_shell];
      if (!finding_.require(outer.start_face < faces_.size(), "start face of a shell")) return;
      finding_.require(faces_[outer.start_face].ball == component.top_ball, "an outer shell does not start on top");
    }
  }

  /// The order of the paper's recursion: around each face counter-clockwise from the edge by which it was entered, into
  /// every neighbour that was not visited before.
  void check_scan(std::uint32_t shell) {
    const std::vector<std::uint32_t> scan = topology_.scan(shell);
    finding_.require(scan.size() == shells_[shell].simple_faces, "length of the scan of shell", shell);
    const std::uint32_t start = shells_[shell].start_face;
    if (!finding_.require(start < faces_.size() && faces_[start].shell == shell, "start of shell", shell)) return;
    struct Visit {
      std::uint32_t entered;
      std::uint32_t at;
    };
    std::vector<Visit> recursion = {{faces_[start].q, faces_[start].q}};
    std::vector<bool> seen(faces_.size(), false);
    std::vector<std::uint32_t> expected = {start};
    seen[start] = true;
    while (!recursion.empty()) {
      const std::uint32_t across = hsp_quad_sym(recursion.back().at);
      const std::uint32_t face = hsp_topology_left(topology_.handle(), across);
      Visit &visit = recursion.back();
      visit.at = hsp_topology_lnext(topology_.handle(), visit.at);
      const bool done = visit.at == visit.entered;
      if (done) recursion.pop_back();
      if (seen[face]) continue;
      seen[face] = true;
      expected.push_back(face);
      recursion.push_back({across, across});
    }
    finding_.require(scan == expected, "the scan of shell", shell, "is not that of the recursion");
    for (const std::uint32_t face : expected)
      finding_.require(faces_[face].shell == shell, "the scan of shell", shell, "leaves it");
    finding_.require(expected.size() == shells_[shell].simple_faces, "the scan of shell", shell, "misses faces");
  }

  void check_measures() {
    const hsp_totals totals = topology_.boundary().measure().totals;
    double area = 0;
    double volume = 0;
    std::vector<double> cell_area(cells_.size(), 0);
    std::vector<double> cell_volume(cells_.size(), 0);
    double scale = 0;  // of volumes
    for (const oracle::LatticeBall &ball : balls_) scale += std::pow(static_cast<double>(ball.radius), 3.0);
    for (const hsp_shell &shell : shells_) {
      const bool outer = shell.kind == HSP_SHELL_OUTER;
      finding_.require(shell.area >= 0 && shell.volume >= -1e-9 * scale, "area or volume of a shell");
      area += shell.area;
      volume += outer ? shell.volume : -shell.volume;
      cell_area[shell.cell] += shell.area;
      cell_volume[shell.cell] += outer ? -shell.volume : shell.volume;
    }
    finding_.require(near(area, totals.area, 1e-12 * totals.area), "areas of shells:", area, "and", totals.area);
    finding_.require(near(volume, totals.volume, 1e-9 * scale), "volumes of shells:", volume, "and", totals.volume);
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      finding_.require(near(cell_area[c], cells_[c].area, 1e-12 * totals.area), "area of cell", c);
      finding_.require(near(c == 0 ? 0 : cell_volume[c], cells_[c].volume, 1e-9 * scale), "volume of cell", c);
    }
  }

  const LibraryTopology &topology_;
  const oracle::Balls &balls_;
  hsp_topology_counts counts_;
  std::vector<hsp_shell> shells_;
  std::vector<hsp_component> components_;
  std::vector<hsp_cell> cells_;
  std::vector<hsp_topology_edge> edges_;
  std::vector<hsp_simple_face> faces_;
  Finding finding_;
};

}  // namespace

std::string shells_broken(const LibraryTopology &topology, const oracle::Balls &balls) {
  return Shells(topology, balls).first_broken();
}

std::string laws_broken_by(const LibraryTopology &topology, const oracle::Balls &balls) {
  // The later ones read along what the earlier ones have found sound.
  std::string broken = algebra_broken(topology);
  if (broken.empty()) broken = records_disagree(topology);
  if (broken.empty()) broken = pieces_broken(topology);
  if (broken.empty()) broken = geometry_broken(topology, balls);
  if (broken.empty()) broken = shells_broken(topology, balls);
  if (!broken.empty()) return broken;
  std::uint32_t law = 99;
  std::uint32_t where = 0;
  const std::int32_t status = hsp_topology_check(topology.handle(), &law, &where);
  if (status == HSP_OK && law == 0) return "";
  return std::string("hsp_topology_check: ") + hsp_status_text(status) + ": law " + std::to_string(law) + " at " +
         std::to_string(where);
}

std::string topology_laws_broken(const oracle::Balls &balls) {
  return laws_broken_by(LibraryTopology(balls), balls);
}
