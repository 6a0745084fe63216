// The two surfaces that the tables over size are made for.
#pragma once

namespace report {

struct Surface {
  const char *name;     // in the benchmarks
  const char *heading;  // in the report
};

constexpr Surface surfaces[] = {{"van_der_waals", "Van der Waals balls"},
                                {"solvent_accessible", "Solvent-accessible balls (probe 1.4)"}};

}  // namespace report
