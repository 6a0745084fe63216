// Parts of pieces of facets on the side between two cubes (facet_overlay.hpp), and the cells that they belong to.
//
// Parts of one facet that share a corner at which three facets of the other cube meet belong to one cell. Known cells
// are handed on from part to part until all are known.
#pragma once

#include "cells/cell_contacts.hpp"
#include "cells/cube_frame.hpp"
#include "core/fixed_vector.hpp"
#include "core/id_range.hpp"

namespace hsp {

class FacetParts {
 public:
  // The name of a corner, the same in all pieces around it: its three balls, ascending.
  struct Name {
    uint32_t ball[3];
    friend constexpr bool operator==(const Name &, const Name &) = default;
  };

  // Takes memory for power cells of so many planes.
  void carve(Workspace &workspace, uint64_t planes);
  void clear() {
    parts_.clear();
    names_.clear();
  }
  // Adds a part of the piece of two facets, with its cells in the lower and the upper cube; no_id for an unknown cell.
  void add(uint32_t below, uint32_t above, uint32_t lower_cell, uint32_t upper_cell, const Vec3 &portal = {}) {
    parts_.push({{below, above}, {lower_cell, upper_cell}, clamped_count(names_.required()), portal});
  }
  // Adds a corner of the last part.
  void add_name(const Name &name) { names_.push(name); }

  uint64_t required() const { return parts_.required(); }
  bool overflowed() const { return parts_.overflowed() || names_.overflowed(); }
  // For how many balls the memory of planes would have sufficed.
  uint32_t needed_balls() const;
  // Adds the contacts of all parts, each once. Status::check if a cell stays unknown, which cannot happen.
  Status resolve(const CubeFrame &frame, CellContacts &contacts);

 private:
  struct Part {
    uint32_t facet[2];
    uint32_t cell[2];
    uint32_t first_name;  // names of a part are consecutive, those of the next part follow
    Vec3 portal;
  };

  IdRange names_of(uint32_t part) const {
    return {parts_[part].first_name, part + 1 < parts_.size() ? parts_[part + 1].first_name : names_.size()};
  }
  bool touch(uint32_t a, uint32_t b) const;
  bool is_new(uint32_t part) const;

  FixedVector<Part> parts_;
  FixedVector<Name> names_;
};

}  // namespace hsp
