#include "commands/group_table.h"

#include <inttypes.h>
#include <string.h>

#include "read/relative_areas.h"
#include "write/csv.h"
#include "write/report.h"

static const struct residue_label *label_of(const struct molecule *molecule, const struct atom_group *group) {
  return &molecule->label[group->first].residue;
}

/* NaN where there is nothing to compare with. */
static double relative_area(const struct molecule *molecule, const struct atom_group *group) {
  return group->area / largest_residue_area(label_of(molecule, group)->name);
}

void group_table_print(const struct molecule *molecule, const struct atom_groups *groups, bool relative,
                       struct text_buffer *out) {
  const bool residues = groups->grouping == GROUPING_RESIDUE;
  char value[NUMBER_BYTES];
  text_buffer_add(out, "\n");
  report_row_count(out, residues ? "residues" : "chains", groups->count, "");
  text_buffer_add(out, "\n  %-5s", "chain");
  if (residues) text_buffer_add(out, "  %-7s  %7s", "residue", "number");
  text_buffer_add(out, "  %9s  %16s", "atoms", "free area");
  text_buffer_add(out, relative ? "  %8s\n" : "%s\n", relative ? "relative" : "");
  for (uint32_t i = 0; i < groups->count; ++i) {
    const struct atom_group *group = &groups->group[i];
    const struct residue_label *label = label_of(molecule, group);
    text_buffer_add(out, "  %-5s", label->chain);
    /* Insertion codes have a column of their own, so that the numbers stand under each other. */
    if (residues) text_buffer_add(out, "  %-7s  %6s%-1s", label->name, label->number, label->insertion);
    text_buffer_add(out, "  %9s", count_text(value, group->atoms));
    text_buffer_add(out, "  %16s", column_text(value, molecule->format, group->area, 4));
    if (relative)
      text_buffer_add(out, "  %8s", column_text(value, molecule->format, relative_area(molecule, group), 3));
    text_buffer_add(out, "\n");
  }
  if (relative) text_buffer_add(out, "\n  relative to the %s\n", relative_areas_source);
}

void group_table_json(const struct molecule *molecule, const struct atom_groups *groups, bool relative,
                      struct text_buffer *out) {
  text_buffer_add(out, "[");
  for (uint32_t i = 0; i < groups->count; ++i) {
    const struct atom_group *group = &groups->group[i];
    const struct residue_label *label = label_of(molecule, group);
    text_buffer_add(out, "%s{\"chain\": ", i == 0 ? "" : ", ");
    json_text(out, label->chain);
    if (groups->grouping == GROUPING_RESIDUE) {
      text_buffer_add(out, ", \"name\": ");
      json_text(out, label->name);
      text_buffer_add(out, ", \"number\": ");
      json_residue_number(out, label->number);
      text_buffer_add(out, ", \"insertion\": ");
      json_text(out, label->insertion);
    }
    text_buffer_add(out, ", \"atoms\": %" PRIu32 ", \"area\": ", group->atoms);
    json_number(out, group->area);
    if (relative) {
      text_buffer_add(out, ", \"relative\": ");
      json_number(out, relative_area(molecule, group));
    }
    text_buffer_add(out, "}");
  }
  text_buffer_add(out, "]");
}

void group_table_csv(const struct molecule *molecule, const struct atom_groups *groups, bool relative,
                     struct text_buffer *out) {
  const bool residues = groups->grouping == GROUPING_RESIDUE;
  text_buffer_add(out, "%s%s\n", residues ? "chain,residue,number,insertion,atoms,area" : "chain,atoms,area",
                  relative ? ",relative" : "");
  for (uint32_t i = 0; i < groups->count; ++i) {
    const struct atom_group *group = &groups->group[i];
    const struct residue_label *label = label_of(molecule, group);
    const char *const texts[] = {label->chain, label->name, label->number, label->insertion};
    for (int k = 0; k < (residues ? 4 : 1); ++k) {
      csv_text(out, texts[k]);
      text_buffer_add(out, ",");
    }
    text_buffer_add(out, "%" PRIu32 ",", group->atoms);
    csv_number(out, group->area);
    if (relative) {
      text_buffer_add(out, ",");
      csv_number(out, relative_area(molecule, group));
    }
    text_buffer_add(out, "\n");
  }
}
