#include "periodic_tables.hpp"

#include <string>
#include <vector>

#include "growth.hpp"
#include "markdown.hpp"
#include "surfaces.hpp"

namespace report {

double box_ratio_per_contact(const Measurement &m) {
  return m.counter("box_ratio") / m.counter("contacts_ratio");
}

void write_periodic(std::ostream &out, const Run &run) {
  out << R"(## Periodic boxes

A molecule, or a tiling of it, in the box whose copies the tilings are made of; and waters, one in 30 cubic Angstrom,
that fill their box. us per atom, of model, boundary, contacts and cells together: in the box (hsp_periodic_compute),
and of the same balls in free space (hsp_model_set, hsp_boundary_compute, hsp_contacts_compute), by turns. There the
faces of the set lie bare, so that there is less to find: contacts are how many times as many as there, and the last
column is the ratio of the times by that of the contacts.

)";
  for (const Surface &surface : surfaces) {
    out << "### " << surface.heading << "\n\n";
    const std::string prefix = std::string("periodic/") + surface.name + '/';
    Table table({"balls", "n", "images per atom", "free space", "in the box", "box, ratio", "contacts, ratio",
                 "ratio per contact"});
    for (const std::string &molecule : molecules_by_size(run, prefix)) {
      const Measurement *m = run.find(prefix + molecule);
      if (m == nullptr) {
        table.row({molecule, run.benchmarks.at(prefix + molecule).error, "-", "-", "-", "-", "-", "-"});
        continue;
      }
      std::vector<std::string> cells{molecule, grouped(m->counter("atoms")), fixed(m->counter("images_per_atom"), 2)};
      for (const char *part : {"free_seconds", "box_seconds"}) {
        cells.push_back(three_digits(m->counter(part) / m->counter("atoms") * 1e6));
      }
      for (const char *ratio : {"box_ratio", "contacts_ratio"}) cells.push_back(fixed(m->counter(ratio), 2));
      cells.push_back(fixed(box_ratio_per_contact(*m), 2));
      table.row(cells);
    }
    table.write(out);
  }
}

}  // namespace report
