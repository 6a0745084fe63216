#include "app/molecule_run.h"

#include "app/command_table.h"
#include "commands/commands.h"
#include "commands/polarity.h"
#include "commands/unit_cell.h"

unsigned molecule_keeping(const struct request *request) {
  return (request->trajectory != NULL || request->index.count > 0 ? KEEP_PLACES : KEEP_NO_MORE) |
         (request->command == COMMAND_DRAW || request->measure.polar ? KEEP_EXTRAS : KEEP_NO_MORE);
}

bool molecule_prepare(const struct request *request, struct molecule *molecule, struct notes *notes,
                      struct failure *failure) {
  if (!index_file_suits(&request->index, request->index_file, molecule_atoms_of_file(molecule), failure)) return false;
  notes_look_at_file(notes, request, molecule);
  notes_look_among_all(notes, request, molecule);
  if (!selection_apply(&request->selection, molecule, failure)) return false;
  if (request->command == COMMAND_DRAW && !request->drawing.water) selection_hide_water(molecule);
  notes_look_among_chosen(notes, request, molecule);
  return molecule_take_radii(molecule, &request->radii, &request->table, failure) &&
         (!request->measure.polar || polarity_find(molecule, failure));
}

bool molecule_run(const struct request *request, uint32_t threads, struct molecule *molecule, struct geometry *geometry,
                  struct notes *notes, struct text_buffer *out, struct failure *failure) {
  if (!unit_cell_fill(request, molecule, failure)) return false;
  notes_look_at_symmetry(notes, request, &molecule->symmetry);
  geometry_share_work(geometry, threads, molecule->atoms);
  bool done = geometry_set_model(geometry, molecule, request_grown(request), 0.0, failure);
  if (done && molecule->number == 0 && !request_wants_places(request)) molecule_drop_balls(molecule);
  done = done && command_table[request->command].run(request, molecule, geometry, out, failure);
  if (geometry->misfit[0] != '\0') text_buffer_add(&notes->lines, "%s\n", geometry->misfit);
  if (done) notes_look_at_result(notes, request, molecule);
  return done;
}
