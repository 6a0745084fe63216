#include "update_tables.hpp"

#include <string>
#include <utility>

#include "growth.hpp"
#include "markdown.hpp"
#include "surfaces.hpp"

namespace report {
namespace {

constexpr std::pair<const char *, const char *> kinds[] = {{"move_1", "one atom"},
                                                           {"move_10", "10 atoms that lie together"},
                                                           {"move_100", "100 atoms that lie together"},
                                                           {"undo", "one atom, taken back"}};

double seconds_a_move(const Measurement &m) {
  return m.median() / m.counter("moves");
}

}  // namespace

void write_updates(std::ostream &out, const Run &run) {
  out << R"(## Atoms that move

Moves by 0.3 Angstrom along each axis, with all that is known of the balls that change: areas, terms of the volume and
derivatives, and the energy of all (hsp_moving_move, _gradient, _get_changed, _get_balls). Each number has the bits of a
new computation. us a move; anew: model, boundary, areas, volumes and gradient from the coordinates, and how many moves
that is. changed: balls of which anything may have changed, on average.

)";
  Table table({"molecule", "n", "surface", "move", "changed", "us", "anew, us", "moves"});
  constexpr const char *names[] = {"van der Waals", "solvent-accessible"};
  for (size_t s = 0; s < 2; ++s) {
    const std::string prefix = std::string("updates/") + surfaces[s].name + '/';
    for (const std::string &molecule : molecules_by_size(run, prefix + "move_1/")) {
      const Measurement *anew = run.find(prefix + "anew/" + molecule);
      for (const auto &[kind, heading] : kinds) {
        const Measurement *m = run.find(prefix + kind + '/' + molecule);
        if (m == nullptr) continue;
        const double seconds = seconds_a_move(*m);
        table.row({molecule, grouped(m->counter("atoms")), names[s], heading,
                   three_digits(m->counter("changed_per_move")), three_digits(seconds * 1e6),
                   anew == nullptr ? "-" : three_digits(anew->median() * 1e6),
                   anew == nullptr ? "-" : three_digits(anew->median() / seconds)});
      }
    }
  }
  table.write(out);
}

}  // namespace report
