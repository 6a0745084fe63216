#include "commands/framework_units.h"

#include <math.h>
#include <stdio.h>

#include "read/atomic_masses.h"

/* Avogadro's number by 10^-24, which is how many cubic angstroms a cubic centimetre has: g/mol in a cubic angstrom. */
static const double per_gram = 0.602214076;

struct framework framework_of(const struct molecule *molecule, const double box[9]) {
  const double *const a = box, *const b = box + 3, *const c = box + 6;
  struct framework framework = {0.0, fabs(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                                          a[2] * (b[0] * c[1] - b[1] * c[0]))};
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    const struct atom_label *const label = &molecule->label[i];
    const double mass = label->element.text[0] == '\0' || label->bead ? 0.0 : element_mass(label->element);
    framework.mass += mass > 0.0 ? mass : (double)NAN;
  }
  return framework;
}

enum { DECIMALS = 4 };

/* Whether lengths are angstroms, and not in anybody's own unit. */
static bool has_unit(const struct record *record) {
  return record->molecule->format->sign[0] != '\0';
}

double framework_density(const struct framework *framework) {
  return framework->mass / (per_gram * framework->volume);
}

/* An area or a volume in the three units. */
struct quoted {
  const char *key, *title;
  double value;
  bool area;
};

static double by_volume(const struct framework *framework, const struct quoted *quoted) {
  return (quoted->area ? 1e4 : 1.0) * quoted->value / framework->volume;
}

static double by_mass(const struct framework *framework, const struct quoted *quoted) {
  return (quoted->area ? 1e4 : 1.0) * per_gram * quoted->value / framework->mass;
}

/* The subject of the table for persons. */
struct table_of_units {
  const struct framework *framework;
  const struct quoted *quoted;
};

static bool quoted_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct table_of_units *const table = of;
  const struct quoted *const quoted = &table->quoted[row];
  (void)text;
  cells[0].text = quoted->title;
  cells[1].quantity = quoted->value;
  cells[2].quantity = by_volume(table->framework, quoted);
  cells[3].quantity = by_mass(table->framework, quoted);
  return true;
}

static void print_units(struct record *record, const struct table_of_units *of, size_t first, bool areas) {
  const struct column columns[] = {
      {NULL, NULL, areas ? "area" : "volume", -14, COLUMN_TEXT, 0},
      {NULL, NULL, areas ? "@^2" : "@^3", 14, COLUMN_PLAIN, 4},
      {NULL, NULL, areas ? "m^2/cm^3" : "of the cell", 14, COLUMN_PLAIN, 4},
      {NULL, NULL, areas ? "m^2/g" : "cm^3/g", 14, COLUMN_PLAIN, 4},
  };
  const struct table_of_units part = {of->framework, of->quoted + first};
  const struct table table = {columns, 4, record->molecule->format, 3, &part, quoted_row, NULL};
  record_table(record, NULL, &table);
}

static void print_for_persons(struct record *record, const struct table_of_units *of) {
  record_line(record, "");
  record_number(record, NULL, "density", framework_density(of->framework), 4,
                "g/cm^3, of all atoms of the cell, whatever their occupancy");
  print_units(record, of, 0, true);
  print_units(record, of, 3, false);
  record_line(
      record,
      "  area: of the balls grown by the probe, the accessible surface: reached is ASA of Zeo++, blocked NASA\n"
      "  volume: of places of the probe's centre: reached is AV of Zeo++, blocked NAV; with --probe 0 all that\n"
      "  no ball covers, the geometric pore volume, whose part of the cell is the void fraction");
}

/* The titles for persons (NULL: a number is not for them), and the remarks behind the numbers. */
struct titles {
  const char *by_volume, *by_mass, *behind_volume, *behind_mass;
};

/* Write a quantity per cell or per cm^3, and per mass. */
static void record_in_units(struct record *record, const struct framework *framework, const struct quoted *quoted,
                            struct titles titles) {
  const bool unit = has_unit(record), area = quoted->area;
  char key[64];
  snprintf(key, sizeof key, "%s%s", quoted->key, area ? "_m2_per_cm3" : "_fraction");
  record_number(record, key, titles.by_volume, unit || !area ? by_volume(framework, quoted) : (double)NAN, DECIMALS,
                titles.behind_volume);
  snprintf(key, sizeof key, "%s%s", quoted->key, area ? "_m2_per_g" : "_cm3_per_g");
  record_number(record, key, titles.by_mass, unit ? by_mass(framework, quoted) : (double)NAN, DECIMALS,
                titles.behind_mass);
}

void framework_record(struct record *record, const struct framework *framework, struct pore_sizes reached,
                      struct pore_sizes blocked) {
  const struct quoted all[] = {
      {"accessible_area", "reached", reached.area, true},
      {"blocked_area", "blocked", blocked.area, true},
      {"total_area", "total", reached.area + blocked.area, true},
      {"accessible_volume", "reached", reached.volume, false},
      {"blocked_volume", "blocked", blocked.volume, false},
      {"total_volume", "total", reached.volume + blocked.volume, false},
  };
  enum { COUNT = sizeof all / sizeof all[0], TOTAL_AREA = 2, TOTAL_VOLUME = 5 };
  const struct table_of_units of = {framework, all};
  const bool unit = has_unit(record);
  if (record->form == FOR_PERSONS) {
    if (unit) print_for_persons(record, &of);
    return;
  }
  const double density = unit ? framework_density(framework) : (double)NAN;
  if (record->aligned) {
    record_number(record, "density", NULL, density, 0, "");
    record_number(record, "ASA, m^2/cm^3", NULL, unit ? by_volume(framework, &all[0]) : (double)NAN, 0, "");
    record_number(record, "ASA, m^2/g", NULL, unit ? by_mass(framework, &all[0]) : (double)NAN, 0, "");
    record_number(record, "AV, cm^3/g", NULL, unit ? by_mass(framework, &all[3]) : (double)NAN, 0, "");
    record_number(record, "AV, of cell", NULL, by_volume(framework, &all[3]), 0, "");
    record_number(record, "all, of cell", NULL, by_volume(framework, &all[TOTAL_VOLUME]), 0, "");
    return;
  }
  record_number(record, "total_area", NULL, all[TOTAL_AREA].value, 0, "");
  record_number(record, "total_volume", NULL, all[TOTAL_VOLUME].value, 0, "");
  record_number(record, "mass", NULL, framework->mass, 0, "");
  record_number(record, "density", NULL, density, 0, "");
  for (int k = 0; k < COUNT; ++k) record_in_units(record, framework, &all[k], (struct titles){NULL, NULL, "", ""});
}

void framework_record_union(struct record *record, const double box[9], double area, double free_volume) {
  const struct framework framework = framework_of(record->molecule, box);
  const struct quoted quoted[2] = {{"total_area", NULL, area, true}, {"total_volume", NULL, free_volume, false}};
  const bool unit = has_unit(record), weighed = unit && !isnan(framework.mass), of_all = unit && !isnan(area);
  const double density = unit ? framework_density(&framework) : (double)NAN;
  if (!record->aligned) record_number(record, "mass", NULL, framework.mass, 0, "");
  record_number(record, "density", weighed ? "density" : NULL, density, DECIMALS,
                "g/cm^3, of all atoms of the cell, whatever their occupancy");
  if (!record->aligned) {
    record_in_units(record, &framework, &quoted[0],
                    (struct titles){of_all ? "area by volume" : NULL, of_all && weighed ? "area by mass" : NULL,
                                    "m^2/cm^3, ASA and NASA of Zeo++ together: pores --regions tells them apart",
                                    "m^2/g, likewise"});
  }
  record_in_units(record, &framework, &quoted[1],
                  (struct titles){"void fraction", weighed ? "void by mass" : NULL,
                                  "of the cell, AV and NAV together; with --probe 0 the geometric one",
                                  "cm^3/g, with --probe 0 the geometric pore volume"});
}
