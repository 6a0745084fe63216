/* Generated from include/hardsphere/: bash capi/interface/generate.sh */
/* clang-format off */
#include "registry.h"

static int64_t call_hsp_version(const value *v) {
  (void)v;
  return (int64_t)hsp_version();
}

static int64_t call_hsp_abi(const value *v) {
  (void)v;
  return (int64_t)hsp_abi();
}

static int64_t call_hsp_provisional(const value *v) {
  (void)v;
  return (int64_t)hsp_provisional();
}

static int64_t call_hsp_numerics(const value *v) {
  (void)v;
  return (int64_t)hsp_numerics();
}

static int64_t call_hsp_provisional_numerics(const value *v) {
  (void)v;
  return (int64_t)hsp_provisional_numerics();
}

static const argument of_hsp_status_text[] = {
  {"status", "int32_t", .kind = KIND_value, .size = sizeof(int32_t)},
};
static int64_t call_hsp_status_text(const value *v) {
  return (int64_t)(intptr_t)hsp_status_text(v[0].i);
}

static const argument of_hsp_element_radius[] = {
  {"set", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"atomic_number", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"radius", "double", .kind = KIND_value_out, .size = sizeof(double)},
  {"flags", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_element_radius(const value *v) {
  return (int64_t)hsp_element_radius(v[0].u, v[1].u, v[2].p, v[3].p);
}

static const argument of_hsp_element_number[] = {
  {"symbol", "char", .kind = KIND_string, .is_const = 1},
  {"atomic_number", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_element_number(const value *v) {
  return (int64_t)hsp_element_number(v[0].p, v[1].p);
}

static const argument of_hsp_element_symbol[] = {
  {"atomic_number", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_element_symbol(const value *v) {
  return (int64_t)(intptr_t)hsp_element_symbol(v[0].u);
}

static const argument of_hsp_residue_radius[] = {
  {"set", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"residue", "char", .kind = KIND_string, .is_const = 1},
  {"atom", "char", .kind = KIND_string, .is_const = 1},
  {"radius", "double", .kind = KIND_value_out, .size = sizeof(double)},
};
static int64_t call_hsp_residue_radius(const value *v) {
  return (int64_t)hsp_residue_radius(v[0].u, v[1].p, v[2].p, v[3].p);
}

static const argument of_hsp_residue_get_atoms[] = {
  {"set", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"out", "hsp_residue_atom", .kind = KIND_array_out, .size = sizeof(hsp_residue_atom), .extent = "needed", .null =
      NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_residue_get_atoms(const value *v) {
  return (int64_t)hsp_residue_get_atoms(v[0].u, v[1].p, v[2].u, v[3].p);
}

static int64_t call_hsp_model_max_balls(const value *v) {
  (void)v;
  return (int64_t)hsp_model_max_balls();
}

static const argument of_hsp_model_bytes[] = {
  {"balls", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"bytes", "size_t", .kind = KIND_value_out, .size = sizeof(size_t)},
};
static int64_t call_hsp_model_bytes(const value *v) {
  return (int64_t)hsp_model_bytes(v[0].u, v[1].p);
}

static const argument of_hsp_model_init[] = {
  {"memory", "void", .kind = KIND_memory},
  {"bytes", "size_t", .kind = KIND_value, .size = sizeof(size_t)},
  {"balls", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"model", "hsp_model", .kind = KIND_handle_out, .noun = NOUN_model},
};
static int64_t call_hsp_model_init(const value *v) {
  return (int64_t)hsp_model_init(v[0].p, v[1].z, v[2].u, v[3].p);
}

static const argument of_hsp_model_options_init[] = {
  {"options", "hsp_model_options", .kind = KIND_sized, .size = sizeof(hsp_model_options)},
  {"struct_size", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_model_options_init(const value *v) {
  return (int64_t)hsp_model_options_init(v[0].p, v[1].u);
}

static const argument of_hsp_model_set[] = {
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model},
  {"n", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"xyz", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "n", .row = 3, .null = NULL_empty,
      .is_const = 1},
  {"radius", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "n", .null = NULL_empty, .is_const = 1},
  {"options", "hsp_model_options", .kind = KIND_sized_in, .size = sizeof(hsp_model_options), .null = NULL_always,
      .is_const = 1},
  {"first_bad", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_model_set(const value *v) {
  return (int64_t)hsp_model_set(v[0].p, v[1].u, v[2].p, v[3].p, v[4].p, v[5].p);
}

static const argument of_hsp_model_set_with[] = {
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model},
  {"n", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"xyz", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "n", .row = 3, .null = NULL_empty,
      .is_const = 1},
  {"radius", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "n", .null = NULL_empty, .is_const = 1},
  {"request", "hsp_model_request", .kind = KIND_sized_in, .size = sizeof(hsp_model_request), .null = NULL_always,
      .is_const = 1},
  {"options", "hsp_model_options", .kind = KIND_sized_in, .size = sizeof(hsp_model_options), .null = NULL_always, .of =
      4, .offset = offsetof(hsp_model_request, options), .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 4,
      .offset = offsetof(hsp_model_request, executor), .is_const = 1},
  {"first_bad", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_model_set_with(const value *v) {
  return (int64_t)hsp_model_set_with(v[0].p, v[1].u, v[2].p, v[3].p, v[4].p, v[7].p);
}

static const argument of_hsp_model_get_info[] = {
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
  {"info", "hsp_model_info", .kind = KIND_struct_out, .size = sizeof(hsp_model_info)},
};
static int64_t call_hsp_model_get_info(const value *v) {
  return (int64_t)hsp_model_get_info(v[0].p, v[1].p);
}

static const argument of_hsp_model_get_balls[] = {
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
  {"xyz", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .row = 3, .null = NULL_always, .held
      = 1},
  {"radius", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_model_get_balls(const value *v) {
  return (int64_t)hsp_model_get_balls(v[0].p, v[1].p, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_model_get_packing[] = {
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model},
  {"figures", "hsp_packing", .kind = KIND_struct_out, .size = sizeof(hsp_packing)},
};
static int64_t call_hsp_model_get_packing(const value *v) {
  return (int64_t)hsp_model_get_packing(v[0].p, v[1].p);
}

static const argument of_hsp_query_point[] = {
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
  {"xyz", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "3", .is_const = 1},
  {"ids", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "needed", .null = NULL_empty, .held =
      1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_query_point(const value *v) {
  return (int64_t)hsp_query_point(v[0].p, v[1].p, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_query_ball[] = {
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
  {"xyz", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "3", .is_const = 1},
  {"radius", "double", .kind = KIND_value, .size = sizeof(double)},
  {"ids", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "needed", .null = NULL_empty, .held =
      1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_query_ball(const value *v) {
  return (int64_t)hsp_query_ball(v[0].p, v[1].p, v[2].d, v[3].p, v[4].u, v[5].p);
}

static const argument of_hsp_query_meets[] = {
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
  {"xyz", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "3", .is_const = 1},
  {"radius", "double", .kind = KIND_value, .size = sizeof(double)},
  {"meets", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_query_meets(const value *v) {
  return (int64_t)hsp_query_meets(v[0].p, v[1].p, v[2].d, v[3].p);
}

static const argument of_hsp_query_neighbours[] = {
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
  {"ball", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"ids", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "needed", .null = NULL_empty, .held =
      1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_query_neighbours(const value *v) {
  return (int64_t)hsp_query_neighbours(v[0].p, v[1].u, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_query_pairs[] = {
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
  {"flags", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"first", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "n + 1"},
  {"ids", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "needed", .null = NULL_empty, .held =
      1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_query_pairs(const value *v) {
  return (int64_t)hsp_query_pairs(v[0].p, v[1].u, v[2].p, v[3].p, v[4].u, v[5].p);
}

static const argument of_hsp_query_pairs_with[] = {
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
  {"request", "hsp_pairs_request", .kind = KIND_sized_in, .size = sizeof(hsp_pairs_request), .null = NULL_always,
      .is_const = 1},
  {"flags", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t), .of = 1, .offset = offsetof(hsp_pairs_request,
      flags)},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_pairs_request, executor), .is_const = 1},
  {"first", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "n + 1"},
  {"ids", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "needed", .null = NULL_empty, .held =
      1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_query_pairs_with(const value *v) {
  return (int64_t)hsp_query_pairs_with(v[0].p, v[1].p, v[4].p, v[5].p, v[6].u, v[7].p);
}

static const argument of_hsp_query_ray[] = {
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
  {"origin", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "3", .is_const = 1},
  {"direction", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "3", .is_const = 1},
  {"hit", "hsp_ray_hit", .kind = KIND_struct_out, .size = sizeof(hsp_ray_hit)},
};
static int64_t call_hsp_query_ray(const value *v) {
  return (int64_t)hsp_query_ray(v[0].p, v[1].p, v[2].p, v[3].p);
}

static const argument of_hsp_body_bytes[] = {
  {"balls", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"bytes", "size_t", .kind = KIND_value_out, .size = sizeof(size_t)},
};
static int64_t call_hsp_body_bytes(const value *v) {
  return (int64_t)hsp_body_bytes(v[0].u, v[1].p);
}

static const argument of_hsp_body_init[] = {
  {"memory", "void", .kind = KIND_memory},
  {"bytes", "size_t", .kind = KIND_value, .size = sizeof(size_t)},
  {"balls", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"body", "hsp_body", .kind = KIND_handle_out, .noun = NOUN_body},
};
static int64_t call_hsp_body_init(const value *v) {
  return (int64_t)hsp_body_init(v[0].p, v[1].z, v[2].u, v[3].p);
}

static const argument of_hsp_body_set[] = {
  {"body", "hsp_body", .kind = KIND_handle, .noun = NOUN_body},
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
};
static int64_t call_hsp_body_set(const value *v) {
  return (int64_t)hsp_body_set(v[0].p, v[1].p);
}

static const argument of_hsp_body_set_with[] = {
  {"body", "hsp_body", .kind = KIND_handle, .noun = NOUN_body},
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
  {"request", "hsp_body_request", .kind = KIND_sized_in, .size = sizeof(hsp_body_request), .null = NULL_always,
      .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 2,
      .offset = offsetof(hsp_body_request, executor), .is_const = 1},
};
static int64_t call_hsp_body_set_with(const value *v) {
  return (int64_t)hsp_body_set_with(v[0].p, v[1].p, v[2].p);
}

static const argument of_hsp_pose_from_matrix[] = {
  {"matrix", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "9", .is_const = 1},
  {"translation", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "3", .is_const = 1},
  {"pose", "hsp_pose", .kind = KIND_struct_out, .size = sizeof(hsp_pose)},
};
static int64_t call_hsp_pose_from_matrix(const value *v) {
  return (int64_t)hsp_pose_from_matrix(v[0].p, v[1].p, v[2].p);
}

static const argument of_hsp_body_hits[] = {
  {"fixed", "hsp_body", .kind = KIND_handle, .noun = NOUN_body, .is_const = 1},
  {"posed", "hsp_body", .kind = KIND_handle, .noun = NOUN_body, .is_const = 1},
  {"poses", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"pose", "hsp_pose", .kind = KIND_array_in, .size = sizeof(hsp_pose), .extent = "poses", .null = NULL_empty, .is_const
      = 1},
  {"hit", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "poses", .null = NULL_empty},
  {"first_bad", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_body_hits(const value *v) {
  return (int64_t)hsp_body_hits(v[0].p, v[1].p, v[2].u, v[3].p, v[4].p, v[5].p);
}

static const argument of_hsp_body_hits_along[] = {
  {"fixed", "hsp_body", .kind = KIND_handle, .noun = NOUN_body, .is_const = 1},
  {"posed", "hsp_body", .kind = KIND_handle, .noun = NOUN_body, .is_const = 1},
  {"poses", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"pose", "hsp_pose", .kind = KIND_array_in, .size = sizeof(hsp_pose), .extent = "poses", .null = NULL_empty, .is_const
      = 1},
  {"margin", "double", .kind = KIND_value, .size = sizeof(double)},
  {"hit", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "poses", .null = NULL_empty},
  {"first_bad", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_body_hits_along(const value *v) {
  return (int64_t)hsp_body_hits_along(v[0].p, v[1].p, v[2].u, v[3].p, v[4].d, v[5].p, v[6].p);
}

static const argument of_hsp_body_gaps[] = {
  {"fixed", "hsp_body", .kind = KIND_handle, .noun = NOUN_body, .is_const = 1},
  {"posed", "hsp_body", .kind = KIND_handle, .noun = NOUN_body, .is_const = 1},
  {"poses", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"pose", "hsp_pose", .kind = KIND_array_in, .size = sizeof(hsp_pose), .extent = "poses", .null = NULL_empty, .is_const
      = 1},
  {"gap", "hsp_body_gap", .kind = KIND_array_out, .size = sizeof(hsp_body_gap), .extent = "poses", .null = NULL_empty},
  {"first_bad", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_body_gaps(const value *v) {
  return (int64_t)hsp_body_gaps(v[0].p, v[1].p, v[2].u, v[3].p, v[4].p, v[5].p);
}

static const argument of_hsp_body_overlaps[] = {
  {"fixed", "hsp_body", .kind = KIND_handle, .noun = NOUN_body, .is_const = 1},
  {"posed", "hsp_body", .kind = KIND_handle, .noun = NOUN_body, .is_const = 1},
  {"poses", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"pose", "hsp_pose", .kind = KIND_array_in, .size = sizeof(hsp_pose), .extent = "poses", .null = NULL_empty, .is_const
      = 1},
  {"overlap", "hsp_body_overlap", .kind = KIND_array_out, .size = sizeof(hsp_body_overlap), .extent = "poses", .null =
      NULL_empty},
  {"first_bad", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_body_overlaps(const value *v) {
  return (int64_t)hsp_body_overlaps(v[0].p, v[1].p, v[2].u, v[3].p, v[4].p, v[5].p);
}

static const argument of_hsp_body_pairs[] = {
  {"fixed", "hsp_body", .kind = KIND_handle, .noun = NOUN_body, .is_const = 1},
  {"posed", "hsp_body", .kind = KIND_handle, .noun = NOUN_body, .is_const = 1},
  {"pose", "hsp_pose", .kind = KIND_struct_in, .size = sizeof(hsp_pose), .is_const = 1},
  {"pair", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "needed", .row = 2, .null =
      NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_body_pairs(const value *v) {
  return (int64_t)hsp_body_pairs(v[0].p, v[1].p, v[2].p, v[3].p, v[4].u, v[5].p);
}

static const argument of_hsp_body_rational_hits[] = {
  {"fixed", "hsp_body", .kind = KIND_handle, .noun = NOUN_body, .is_const = 1},
  {"posed", "hsp_body", .kind = KIND_handle, .noun = NOUN_body, .is_const = 1},
  {"poses", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"pose", "hsp_rational_pose", .kind = KIND_array_in, .size = sizeof(hsp_rational_pose), .extent = "poses", .null =
      NULL_empty, .is_const = 1},
  {"hit", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "poses", .null = NULL_empty},
  {"first_bad", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_body_rational_hits(const value *v) {
  return (int64_t)hsp_body_rational_hits(v[0].p, v[1].p, v[2].u, v[3].p, v[4].p, v[5].p);
}

static const argument of_hsp_body_rational_hits_along[] = {
  {"fixed", "hsp_body", .kind = KIND_handle, .noun = NOUN_body, .is_const = 1},
  {"posed", "hsp_body", .kind = KIND_handle, .noun = NOUN_body, .is_const = 1},
  {"poses", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"pose", "hsp_rational_pose", .kind = KIND_array_in, .size = sizeof(hsp_rational_pose), .extent = "poses", .null =
      NULL_empty, .is_const = 1},
  {"margin", "double", .kind = KIND_value, .size = sizeof(double)},
  {"hit", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "poses", .null = NULL_empty},
  {"first_bad", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_body_rational_hits_along(const value *v) {
  return (int64_t)hsp_body_rational_hits_along(v[0].p, v[1].p, v[2].u, v[3].p, v[4].d, v[5].p, v[6].p);
}

static const argument of_hsp_body_rational_gaps[] = {
  {"fixed", "hsp_body", .kind = KIND_handle, .noun = NOUN_body, .is_const = 1},
  {"posed", "hsp_body", .kind = KIND_handle, .noun = NOUN_body, .is_const = 1},
  {"poses", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"pose", "hsp_rational_pose", .kind = KIND_array_in, .size = sizeof(hsp_rational_pose), .extent = "poses", .null =
      NULL_empty, .is_const = 1},
  {"gap", "hsp_body_gap", .kind = KIND_array_out, .size = sizeof(hsp_body_gap), .extent = "poses", .null = NULL_empty},
  {"first_bad", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_body_rational_gaps(const value *v) {
  return (int64_t)hsp_body_rational_gaps(v[0].p, v[1].p, v[2].u, v[3].p, v[4].p, v[5].p);
}

static const argument of_hsp_body_rational_pairs[] = {
  {"fixed", "hsp_body", .kind = KIND_handle, .noun = NOUN_body, .is_const = 1},
  {"posed", "hsp_body", .kind = KIND_handle, .noun = NOUN_body, .is_const = 1},
  {"pose", "hsp_rational_pose", .kind = KIND_struct_in, .size = sizeof(hsp_rational_pose), .is_const = 1},
  {"pair", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "needed", .row = 2, .null =
      NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_body_rational_pairs(const value *v) {
  return (int64_t)hsp_body_rational_pairs(v[0].p, v[1].p, v[2].p, v[3].p, v[4].u, v[5].p);
}

static const argument of_hsp_boundary_limits_init[] = {
  {"limits", "hsp_boundary_limits", .kind = KIND_sized, .size = sizeof(hsp_boundary_limits)},
  {"struct_size", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"balls", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_boundary_limits_init(const value *v) {
  return (int64_t)hsp_boundary_limits_init(v[0].p, v[1].u, v[2].u);
}

static const argument of_hsp_boundary_bytes[] = {
  {"limits", "hsp_boundary_limits", .kind = KIND_sized_in, .size = sizeof(hsp_boundary_limits), .is_const = 1},
  {"bytes", "size_t", .kind = KIND_value_out, .size = sizeof(size_t)},
};
static int64_t call_hsp_boundary_bytes(const value *v) {
  return (int64_t)hsp_boundary_bytes(v[0].p, v[1].p);
}

static const argument of_hsp_boundary_init[] = {
  {"memory", "void", .kind = KIND_memory},
  {"bytes", "size_t", .kind = KIND_value, .size = sizeof(size_t)},
  {"limits", "hsp_boundary_limits", .kind = KIND_sized_in, .size = sizeof(hsp_boundary_limits), .is_const = 1},
  {"boundary", "hsp_boundary", .kind = KIND_handle_out, .noun = NOUN_boundary},
};
static int64_t call_hsp_boundary_init(const value *v) {
  return (int64_t)hsp_boundary_init(v[0].p, v[1].z, v[2].p, v[3].p);
}

static const argument of_hsp_boundary_compute[] = {
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary},
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
  {"limits", "hsp_boundary_limits", .kind = KIND_sized, .size = sizeof(hsp_boundary_limits), .null = NULL_always},
};
static int64_t call_hsp_boundary_compute(const value *v) {
  return (int64_t)hsp_boundary_compute(v[0].p, v[1].p, v[2].p);
}

static const argument of_hsp_boundary_compute_with[] = {
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary},
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
  {"request", "hsp_boundary_request", .kind = KIND_sized_in, .size = sizeof(hsp_boundary_request), .null = NULL_always,
      .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 2,
      .offset = offsetof(hsp_boundary_request, executor), .is_const = 1},
  {"selected", "uint8_t", .kind = KIND_array_in, .size = sizeof(uint8_t), .extent = "n", .null = NULL_always, .of = 2,
      .offset = offsetof(hsp_boundary_request, selected), .is_const = 1},
  {"limits", "hsp_boundary_limits", .kind = KIND_sized, .size = sizeof(hsp_boundary_limits), .null = NULL_always},
};
static int64_t call_hsp_boundary_compute_with(const value *v) {
  return (int64_t)hsp_boundary_compute_with(v[0].p, v[1].p, v[2].p, v[5].p);
}

static const argument of_hsp_boundary_get_counts[] = {
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"counts", "hsp_boundary_counts", .kind = KIND_struct_out, .size = sizeof(hsp_boundary_counts)},
};
static int64_t call_hsp_boundary_get_counts(const value *v) {
  return (int64_t)hsp_boundary_get_counts(v[0].p, v[1].p);
}

static const argument of_hsp_boundary_get_vertices[] = {
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"out", "hsp_vertex", .kind = KIND_array_out, .size = sizeof(hsp_vertex), .extent = "needed", .null = NULL_empty,
      .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_boundary_get_vertices(const value *v) {
  return (int64_t)hsp_boundary_get_vertices(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_boundary_get_arcs[] = {
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"out", "hsp_arc", .kind = KIND_array_out, .size = sizeof(hsp_arc), .extent = "needed", .null = NULL_empty, .held =
      1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_boundary_get_arcs(const value *v) {
  return (int64_t)hsp_boundary_get_arcs(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_boundary_get_circles[] = {
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"out", "hsp_circle", .kind = KIND_array_out, .size = sizeof(hsp_circle), .extent = "needed", .null = NULL_empty,
      .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_boundary_get_circles(const value *v) {
  return (int64_t)hsp_boundary_get_circles(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_boundary_get_faces[] = {
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"out", "hsp_face", .kind = KIND_array_out, .size = sizeof(hsp_face), .extent = "needed", .null = NULL_empty, .held =
      1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_boundary_get_faces(const value *v) {
  return (int64_t)hsp_boundary_get_faces(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_boundary_get_loops[] = {
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"out", "hsp_loop", .kind = KIND_array_out, .size = sizeof(hsp_loop), .extent = "needed", .null = NULL_empty, .held =
      1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_boundary_get_loops(const value *v) {
  return (int64_t)hsp_boundary_get_loops(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_boundary_get_loop_arcs[] = {
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"out", "hsp_loop_arc", .kind = KIND_array_out, .size = sizeof(hsp_loop_arc), .extent = "needed", .null = NULL_empty,
      .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_boundary_get_loop_arcs(const value *v) {
  return (int64_t)hsp_boundary_get_loop_arcs(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_boundary_get_balls[] = {
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"out", "hsp_ball", .kind = KIND_array_out, .size = sizeof(hsp_ball), .extent = "needed", .null = NULL_empty, .held =
      1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_boundary_get_balls(const value *v) {
  return (int64_t)hsp_boundary_get_balls(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_boundary_check[] = {
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary},
  {"invariant", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
  {"id", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_boundary_check(const value *v) {
  return (int64_t)hsp_boundary_check(v[0].p, v[1].p, v[2].p);
}

static const argument of_hsp_areas_bytes[] = {
  {"n", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"bytes", "size_t", .kind = KIND_value_out, .size = sizeof(size_t)},
};
static int64_t call_hsp_areas_bytes(const value *v) {
  return (int64_t)hsp_areas_bytes(v[0].u, v[1].p);
}

static const argument of_hsp_areas[] = {
  {"n", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"xyz", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "n", .row = 3, .null = NULL_empty,
      .is_const = 1},
  {"radius", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "n", .null = NULL_empty, .is_const = 1},
  {"probe", "double", .kind = KIND_value, .size = sizeof(double)},
  {"memory", "void", .kind = KIND_memory},
  {"bytes", "size_t", .kind = KIND_value_out, .size = sizeof(size_t)},
  {"totals", "hsp_totals", .kind = KIND_struct_out, .size = sizeof(hsp_totals), .null = NULL_always},
  {"area", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always},
};
static int64_t call_hsp_areas(const value *v) {
  return (int64_t)hsp_areas(v[0].u, v[1].p, v[2].p, v[3].d, v[4].p, v[5].p, v[6].p, v[7].p);
}

static const argument of_hsp_boundary_measure[] = {
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"selected", "uint8_t", .kind = KIND_array_in, .size = sizeof(uint8_t), .extent = "n", .null = NULL_always, .is_const
      = 1},
  {"totals", "hsp_totals", .kind = KIND_struct_out, .size = sizeof(hsp_totals), .null = NULL_always},
  {"area", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .held = 1},
  {"volume_term", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .held =
      1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_boundary_measure(const value *v) {
  return (int64_t)hsp_boundary_measure(v[0].p, v[1].p, v[2].p, v[3].p, v[4].p, v[5].u, v[6].p);
}

static const argument of_hsp_boundary_get_measures[] = {
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"request", "hsp_measure_request", .kind = KIND_sized_in, .size = sizeof(hsp_measure_request), .null = NULL_always,
      .is_const = 1},
  {"selected", "uint8_t", .kind = KIND_array_in, .size = sizeof(uint8_t), .extent = "n", .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_measure_request, selected), .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_measure_request, executor), .is_const = 1},
  {"outputs", "hsp_measure_outputs", .kind = KIND_outputs, .size = sizeof(hsp_measure_outputs)},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t), .of = 4, .offset =
      offsetof(hsp_measure_outputs, capacity)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .of = 4, .offset = offsetof(hsp_measure_outputs,
      needed)},
  {"totals", "hsp_totals", .kind = KIND_struct_out, .size = sizeof(hsp_totals), .null = NULL_always, .of = 4, .offset =
      offsetof(hsp_measure_outputs, totals)},
  {"area", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .of = 4,
      .offset = offsetof(hsp_measure_outputs, area), .held = 1},
  {"volume_term", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .of = 4,
      .offset = offsetof(hsp_measure_outputs, volume_term), .held = 1},
};
static int64_t call_hsp_boundary_get_measures(const value *v) {
  return (int64_t)hsp_boundary_get_measures(v[0].p, v[1].p, v[4].p);
}

static const argument of_hsp_boundary_measure_faces[] = {
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"area", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "faces", .null = NULL_always, .held = 1},
  {"volume_term", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "faces", .null = NULL_always,
      .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_boundary_measure_faces(const value *v) {
  return (int64_t)hsp_boundary_measure_faces(v[0].p, v[1].p, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_gradient_request_init[] = {
  {"request", "hsp_gradient_request", .kind = KIND_sized, .size = sizeof(hsp_gradient_request)},
  {"struct_size", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_gradient_request_init(const value *v) {
  return (int64_t)hsp_gradient_request_init(v[0].p, v[1].u);
}

static const argument of_hsp_boundary_get_gradient[] = {
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"request", "hsp_gradient_request", .kind = KIND_sized_in, .size = sizeof(hsp_gradient_request), .null = NULL_always,
      .is_const = 1},
  {"tangency", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t), .of = 1, .offset =
      offsetof(hsp_gradient_request, tangency)},
  {"tension", "double", .kind = KIND_value, .size = sizeof(double), .of = 1, .offset = offsetof(hsp_gradient_request,
      tension)},
  {"pressure", "double", .kind = KIND_value, .size = sizeof(double), .of = 1, .offset = offsetof(hsp_gradient_request,
      pressure)},
  {"sigma", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "n", .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_gradient_request, sigma), .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_gradient_request, executor), .is_const = 1},
  {"outputs", "hsp_gradient_outputs", .kind = KIND_outputs, .size = sizeof(hsp_gradient_outputs)},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t), .of = 7, .offset =
      offsetof(hsp_gradient_outputs, capacity)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .of = 7, .offset =
      offsetof(hsp_gradient_outputs, needed)},
  {"first_bad", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .of = 7, .offset =
      offsetof(hsp_gradient_outputs, first_bad)},
  {"energy", "hsp_energy", .kind = KIND_struct_out, .size = sizeof(hsp_energy), .null = NULL_always, .of = 7, .offset =
      offsetof(hsp_gradient_outputs, energy)},
  {"d_centre", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .row = 3, .null = NULL_always,
      .of = 7, .offset = offsetof(hsp_gradient_outputs, d_centre), .held = 1},
  {"d_radius", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .of = 7,
      .offset = offsetof(hsp_gradient_outputs, d_radius), .held = 1},
  {"flags", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "n", .null = NULL_always, .of = 7,
      .offset = offsetof(hsp_gradient_outputs, flags), .held = 1},
  {"area", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .of = 7,
      .offset = offsetof(hsp_gradient_outputs, area), .held = 1},
};
static int64_t call_hsp_boundary_get_gradient(const value *v) {
  return (int64_t)hsp_boundary_get_gradient(v[0].p, v[1].p, v[7].p);
}

static const argument of_hsp_boundary_get_derivatives[] = {
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"request", "hsp_derivatives_request", .kind = KIND_sized_in, .size = sizeof(hsp_derivatives_request), .null =
      NULL_always, .is_const = 1},
  {"tangency", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t), .of = 1, .offset =
      offsetof(hsp_derivatives_request, tangency)},
  {"sigma", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "n", .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_derivatives_request, sigma), .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_derivatives_request, executor), .is_const = 1},
  {"outputs", "hsp_derivatives_outputs", .kind = KIND_outputs, .size = sizeof(hsp_derivatives_outputs)},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t), .of = 5, .offset =
      offsetof(hsp_derivatives_outputs, capacity)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .of = 5, .offset =
      offsetof(hsp_derivatives_outputs, needed)},
  {"first_bad", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .of = 5, .offset =
      offsetof(hsp_derivatives_outputs, first_bad)},
  {"area_centre", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .row = 3, .null =
      NULL_always, .of = 5, .offset = offsetof(hsp_derivatives_outputs, area_centre), .held = 1},
  {"area_radius", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .of = 5,
      .offset = offsetof(hsp_derivatives_outputs, area_radius), .held = 1},
  {"volume_centre", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .row = 3, .null =
      NULL_always, .of = 5, .offset = offsetof(hsp_derivatives_outputs, volume_centre), .held = 1},
  {"volume_radius", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .of =
      5, .offset = offsetof(hsp_derivatives_outputs, volume_radius), .held = 1},
  {"flags", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "n", .null = NULL_always, .of = 5,
      .offset = offsetof(hsp_derivatives_outputs, flags), .held = 1},
};
static int64_t call_hsp_boundary_get_derivatives(const value *v) {
  return (int64_t)hsp_boundary_get_derivatives(v[0].p, v[1].p, v[5].p);
}

static const argument of_hsp_boundary_get_area_row[] = {
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"ball", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"tangency", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"out", "hsp_area_derivative", .kind = KIND_array_out, .size = sizeof(hsp_area_derivative), .extent = "needed", .null
      = NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_boundary_get_area_row(const value *v) {
  return (int64_t)hsp_boundary_get_area_row(v[0].p, v[1].u, v[2].u, v[3].p, v[4].u, v[5].p);
}

static const argument of_hsp_boundary_get_area_rows[] = {
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"request", "hsp_derivatives_request", .kind = KIND_sized_in, .size = sizeof(hsp_derivatives_request), .null =
      NULL_always, .is_const = 1},
  {"tangency", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t), .of = 1, .offset =
      offsetof(hsp_derivatives_request, tangency)},
  {"sigma", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "n", .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_derivatives_request, sigma), .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_derivatives_request, executor), .is_const = 1},
  {"first", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "n + 1"},
  {"ball", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "needed", .null = NULL_empty, .held =
      1},
  {"d_centre", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "needed", .row = 3, .null =
      NULL_empty, .held = 1},
  {"d_radius", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "needed", .null = NULL_always, .held
      = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_boundary_get_area_rows(const value *v) {
  return (int64_t)hsp_boundary_get_area_rows(v[0].p, v[1].p, v[5].p, v[6].p, v[7].p, v[8].p, v[9].u, v[10].p);
}

static const argument of_hsp_moving_limits_init[] = {
  {"limits", "hsp_moving_limits", .kind = KIND_sized, .size = sizeof(hsp_moving_limits)},
  {"struct_size", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"balls", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_moving_limits_init(const value *v) {
  return (int64_t)hsp_moving_limits_init(v[0].p, v[1].u, v[2].u);
}

static const argument of_hsp_moving_bytes[] = {
  {"limits", "hsp_moving_limits", .kind = KIND_sized_in, .size = sizeof(hsp_moving_limits), .is_const = 1},
  {"bytes", "size_t", .kind = KIND_value_out, .size = sizeof(size_t)},
};
static int64_t call_hsp_moving_bytes(const value *v) {
  return (int64_t)hsp_moving_bytes(v[0].p, v[1].p);
}

static const argument of_hsp_moving_init[] = {
  {"memory", "void", .kind = KIND_memory},
  {"bytes", "size_t", .kind = KIND_value, .size = sizeof(size_t)},
  {"limits", "hsp_moving_limits", .kind = KIND_sized_in, .size = sizeof(hsp_moving_limits), .is_const = 1},
  {"moving", "hsp_moving", .kind = KIND_handle_out, .noun = NOUN_moving},
};
static int64_t call_hsp_moving_init(const value *v) {
  return (int64_t)hsp_moving_init(v[0].p, v[1].z, v[2].p, v[3].p);
}

static const argument of_hsp_moving_set[] = {
  {"moving", "hsp_moving", .kind = KIND_handle, .noun = NOUN_moving},
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
  {"sigma", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "n", .null = NULL_always, .is_const = 1},
  {"tension", "double", .kind = KIND_value, .size = sizeof(double)},
  {"pressure", "double", .kind = KIND_value, .size = sizeof(double)},
  {"tangency", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"limits", "hsp_moving_limits", .kind = KIND_sized, .size = sizeof(hsp_moving_limits), .null = NULL_always},
  {"first_bad", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_moving_set(const value *v) {
  return (int64_t)hsp_moving_set(v[0].p, v[1].p, v[2].p, v[3].d, v[4].d, v[5].u, v[6].p, v[7].p);
}

static const argument of_hsp_moving_set_with[] = {
  {"moving", "hsp_moving", .kind = KIND_handle, .noun = NOUN_moving},
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
  {"request", "hsp_gradient_request", .kind = KIND_sized_in, .size = sizeof(hsp_gradient_request), .null = NULL_always,
      .is_const = 1},
  {"tangency", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t), .of = 2, .offset =
      offsetof(hsp_gradient_request, tangency)},
  {"tension", "double", .kind = KIND_value, .size = sizeof(double), .of = 2, .offset = offsetof(hsp_gradient_request,
      tension)},
  {"pressure", "double", .kind = KIND_value, .size = sizeof(double), .of = 2, .offset = offsetof(hsp_gradient_request,
      pressure)},
  {"sigma", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "n", .null = NULL_always, .of = 2,
      .offset = offsetof(hsp_gradient_request, sigma), .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 2,
      .offset = offsetof(hsp_gradient_request, executor), .is_const = 1},
  {"limits", "hsp_moving_limits", .kind = KIND_sized, .size = sizeof(hsp_moving_limits), .null = NULL_always},
  {"first_bad", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_moving_set_with(const value *v) {
  return (int64_t)hsp_moving_set_with(v[0].p, v[1].p, v[2].p, v[8].p, v[9].p);
}

static const argument of_hsp_moving_move[] = {
  {"moving", "hsp_moving", .kind = KIND_handle, .noun = NOUN_moving},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"ball", "uint32_t", .kind = KIND_array_in, .size = sizeof(uint32_t), .extent = "count", .null = NULL_empty, .is_const
      = 1},
  {"xyz", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "count", .row = 3, .null = NULL_always,
      .is_const = 1},
  {"radius", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "count", .null = NULL_always, .is_const
      = 1},
  {"limits", "hsp_moving_limits", .kind = KIND_sized, .size = sizeof(hsp_moving_limits), .null = NULL_always},
  {"first_bad", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_moving_move(const value *v) {
  return (int64_t)hsp_moving_move(v[0].p, v[1].u, v[2].p, v[3].p, v[4].p, v[5].p, v[6].p);
}

static const argument of_hsp_moving_move_with[] = {
  {"moving", "hsp_moving", .kind = KIND_handle, .noun = NOUN_moving},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"ball", "uint32_t", .kind = KIND_array_in, .size = sizeof(uint32_t), .extent = "count", .null = NULL_empty, .is_const
      = 1},
  {"xyz", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "count", .row = 3, .null = NULL_always,
      .is_const = 1},
  {"radius", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "count", .null = NULL_always, .is_const
      = 1},
  {"request", "hsp_moving_request", .kind = KIND_sized_in, .size = sizeof(hsp_moving_request), .null = NULL_always,
      .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 5,
      .offset = offsetof(hsp_moving_request, executor), .is_const = 1},
  {"limits", "hsp_moving_limits", .kind = KIND_sized, .size = sizeof(hsp_moving_limits), .null = NULL_always},
  {"first_bad", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_moving_move_with(const value *v) {
  return (int64_t)hsp_moving_move_with(v[0].p, v[1].u, v[2].p, v[3].p, v[4].p, v[5].p, v[7].p, v[8].p);
}

static const argument of_hsp_moving_undo[] = {
  {"moving", "hsp_moving", .kind = KIND_handle, .noun = NOUN_moving},
};
static int64_t call_hsp_moving_undo(const value *v) {
  return (int64_t)hsp_moving_undo(v[0].p);
}

static const argument of_hsp_moving_get_info[] = {
  {"moving", "hsp_moving", .kind = KIND_handle, .noun = NOUN_moving, .is_const = 1},
  {"info", "hsp_moving_info", .kind = KIND_struct_out, .size = sizeof(hsp_moving_info)},
};
static int64_t call_hsp_moving_get_info(const value *v) {
  return (int64_t)hsp_moving_get_info(v[0].p, v[1].p);
}

static const argument of_hsp_moving_measure[] = {
  {"moving", "hsp_moving", .kind = KIND_handle, .noun = NOUN_moving, .is_const = 1},
  {"totals", "hsp_totals", .kind = KIND_struct_out, .size = sizeof(hsp_totals), .null = NULL_always},
  {"area", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .held = 1},
  {"volume_term", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .held =
      1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_moving_measure(const value *v) {
  return (int64_t)hsp_moving_measure(v[0].p, v[1].p, v[2].p, v[3].p, v[4].u, v[5].p);
}

static const argument of_hsp_moving_gradient[] = {
  {"moving", "hsp_moving", .kind = KIND_handle, .noun = NOUN_moving, .is_const = 1},
  {"energy", "hsp_energy", .kind = KIND_struct_out, .size = sizeof(hsp_energy), .null = NULL_always},
  {"d_centre", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .row = 3, .null = NULL_always,
      .held = 1},
  {"d_radius", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .held = 1},
  {"flags", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "n", .null = NULL_always, .held =
      1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_moving_gradient(const value *v) {
  return (int64_t)hsp_moving_gradient(v[0].p, v[1].p, v[2].p, v[3].p, v[4].p, v[5].u, v[6].p);
}

static const argument of_hsp_moving_get_balls[] = {
  {"moving", "hsp_moving", .kind = KIND_handle, .noun = NOUN_moving, .is_const = 1},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"ball", "uint32_t", .kind = KIND_array_in, .size = sizeof(uint32_t), .extent = "count", .null = NULL_empty, .is_const
      = 1},
  {"out", "hsp_moving_ball", .kind = KIND_array_out, .size = sizeof(hsp_moving_ball), .extent = "count", .null =
      NULL_empty},
};
static int64_t call_hsp_moving_get_balls(const value *v) {
  return (int64_t)hsp_moving_get_balls(v[0].p, v[1].u, v[2].p, v[3].p);
}

static const argument of_hsp_moving_get_changed[] = {
  {"moving", "hsp_moving", .kind = KIND_handle, .noun = NOUN_moving, .is_const = 1},
  {"balls", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "needed", .null = NULL_empty, .held
      = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_moving_get_changed(const value *v) {
  return (int64_t)hsp_moving_get_changed(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_moving_get_model[] = {
  {"moving", "hsp_moving", .kind = KIND_handle, .noun = NOUN_moving, .is_const = 1},
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model},
};
static int64_t call_hsp_moving_get_model(const value *v) {
  return (int64_t)hsp_moving_get_model(v[0].p, v[1].p);
}

static const argument of_hsp_boundary_curvature[] = {
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"totals", "hsp_curvatures", .kind = KIND_struct_out, .size = sizeof(hsp_curvatures), .null = NULL_always},
  {"mean", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .held = 1},
  {"gauss_thirds", "int32_t", .kind = KIND_array_out, .size = sizeof(int32_t), .extent = "n", .null = NULL_always, .held
      = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_boundary_curvature(const value *v) {
  return (int64_t)hsp_boundary_curvature(v[0].p, v[1].p, v[2].p, v[3].p, v[4].u, v[5].p);
}

static const argument of_hsp_boundary_curvature_with[] = {
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"request", "hsp_curvature_request", .kind = KIND_sized_in, .size = sizeof(hsp_curvature_request), .null =
      NULL_always, .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_curvature_request, executor), .is_const = 1},
  {"totals", "hsp_curvatures", .kind = KIND_struct_out, .size = sizeof(hsp_curvatures), .null = NULL_always},
  {"mean", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .held = 1},
  {"gauss_thirds", "int32_t", .kind = KIND_array_out, .size = sizeof(int32_t), .extent = "n", .null = NULL_always, .held
      = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_boundary_curvature_with(const value *v) {
  return (int64_t)hsp_boundary_curvature_with(v[0].p, v[1].p, v[3].p, v[4].p, v[5].p, v[6].u, v[7].p);
}

static const argument of_hsp_boundary_get_morphometry[] = {
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"request", "hsp_morphometry_request", .kind = KIND_sized_in, .size = sizeof(hsp_morphometry_request), .null =
      NULL_always, .is_const = 1},
  {"pressure", "double", .kind = KIND_value, .size = sizeof(double), .of = 1, .offset =
      offsetof(hsp_morphometry_request, pressure)},
  {"tension", "double", .kind = KIND_value, .size = sizeof(double), .of = 1, .offset = offsetof(hsp_morphometry_request,
      tension)},
  {"bending", "double", .kind = KIND_value, .size = sizeof(double), .of = 1, .offset = offsetof(hsp_morphometry_request,
      bending)},
  {"gaussian", "double", .kind = KIND_value, .size = sizeof(double), .of = 1, .offset =
      offsetof(hsp_morphometry_request, gaussian)},
  {"sigma", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "n", .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_morphometry_request, sigma), .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_morphometry_request, executor), .is_const = 1},
  {"outputs", "hsp_morphometry_outputs", .kind = KIND_outputs, .size = sizeof(hsp_morphometry_outputs)},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t), .of = 8, .offset =
      offsetof(hsp_morphometry_outputs, capacity)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .of = 8, .offset =
      offsetof(hsp_morphometry_outputs, needed)},
  {"first_bad", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .of = 8, .offset =
      offsetof(hsp_morphometry_outputs, first_bad)},
  {"energy", "hsp_morphometric_energy", .kind = KIND_struct_out, .size = sizeof(hsp_morphometric_energy), .null =
      NULL_always, .of = 8, .offset = offsetof(hsp_morphometry_outputs, energy)},
  {"d_centre", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .row = 3, .null = NULL_always,
      .of = 8, .offset = offsetof(hsp_morphometry_outputs, d_centre), .held = 1},
  {"d_radius", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .of = 8,
      .offset = offsetof(hsp_morphometry_outputs, d_radius), .held = 1},
  {"flags", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "n", .null = NULL_always, .of = 8,
      .offset = offsetof(hsp_morphometry_outputs, flags), .held = 1},
  {"area", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .of = 8,
      .offset = offsetof(hsp_morphometry_outputs, area), .held = 1},
};
static int64_t call_hsp_boundary_get_morphometry(const value *v) {
  return (int64_t)hsp_boundary_get_morphometry(v[0].p, v[1].p, v[8].p);
}

static const argument of_hsp_boundary_get_hessian_rows[] = {
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"request", "hsp_gradient_request", .kind = KIND_sized_in, .size = sizeof(hsp_gradient_request), .null = NULL_always,
      .is_const = 1},
  {"tangency", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t), .of = 1, .offset =
      offsetof(hsp_gradient_request, tangency)},
  {"tension", "double", .kind = KIND_value, .size = sizeof(double), .of = 1, .offset = offsetof(hsp_gradient_request,
      tension)},
  {"pressure", "double", .kind = KIND_value, .size = sizeof(double), .of = 1, .offset = offsetof(hsp_gradient_request,
      pressure)},
  {"sigma", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "n", .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_gradient_request, sigma), .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_gradient_request, executor), .is_const = 1},
  {"first", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "n + 1"},
  {"ball", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "needed", .null = NULL_empty, .held =
      1},
  {"block", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "needed", .row = 3 * 3, .null =
      NULL_empty, .held = 1},
  {"flags", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "n + 1", .null = NULL_always},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_boundary_get_hessian_rows(const value *v) {
  return (int64_t)hsp_boundary_get_hessian_rows(v[0].p, v[1].p, v[7].p, v[8].p, v[9].p, v[10].p, v[11].u, v[12].p);
}

static const argument of_hsp_boundary_get_hessian_product[] = {
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"request", "hsp_gradient_request", .kind = KIND_sized_in, .size = sizeof(hsp_gradient_request), .null = NULL_always,
      .is_const = 1},
  {"tangency", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t), .of = 1, .offset =
      offsetof(hsp_gradient_request, tangency)},
  {"tension", "double", .kind = KIND_value, .size = sizeof(double), .of = 1, .offset = offsetof(hsp_gradient_request,
      tension)},
  {"pressure", "double", .kind = KIND_value, .size = sizeof(double), .of = 1, .offset = offsetof(hsp_gradient_request,
      pressure)},
  {"sigma", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "n", .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_gradient_request, sigma), .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_gradient_request, executor), .is_const = 1},
  {"direction", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "n", .row = 3, .is_const = 1},
  {"product", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .row = 3, .null = NULL_empty,
      .held = 1},
  {"flags", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "n", .null = NULL_always, .held =
      1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_boundary_get_hessian_product(const value *v) {
  return (int64_t)hsp_boundary_get_hessian_product(v[0].p, v[1].p, v[7].p, v[8].p, v[9].p, v[10].u, v[11].p);
}

static const argument of_hsp_brick_summarise[] = {
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"request", "hsp_brick_request", .kind = KIND_sized_in, .size = sizeof(hsp_brick_request), .is_const = 1},
  {"brick", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t), .of = 1, .offset = offsetof(hsp_brick_request,
      brick)},
  {"bricks", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t), .of = 1, .offset = offsetof(hsp_brick_request,
      bricks)},
  {"flags", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t), .of = 1, .offset = offsetof(hsp_brick_request,
      flags)},
  {"id", "uint64_t", .kind = KIND_array_in, .size = sizeof(uint64_t), .extent = "n", .of = 1, .offset =
      offsetof(hsp_brick_request, id), .is_const = 1},
  {"owner", "uint32_t", .kind = KIND_array_in, .size = sizeof(uint32_t), .extent = "n", .of = 1, .offset =
      offsetof(hsp_brick_request, owner), .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_brick_request, executor), .is_const = 1},
  {"summary", "void", .kind = KIND_memory},
  {"bytes", "size_t", .kind = KIND_value_out, .size = sizeof(size_t)},
  {"first_bad", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_brick_summarise(const value *v) {
  return (int64_t)hsp_brick_summarise(v[0].p, v[1].p, v[8].p, v[9].p, v[10].p);
}

static const argument of_hsp_brick_merge[] = {
  {"a", "uint8_t", .kind = KIND_array_in, .size = sizeof(uint8_t), .extent = "a_bytes", .is_const = 1},
  {"a_bytes", "size_t", .kind = KIND_value, .size = sizeof(size_t)},
  {"b", "uint8_t", .kind = KIND_array_in, .size = sizeof(uint8_t), .extent = "b_bytes", .is_const = 1},
  {"b_bytes", "size_t", .kind = KIND_value, .size = sizeof(size_t)},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .is_const = 1},
  {"summary", "void", .kind = KIND_memory},
  {"bytes", "size_t", .kind = KIND_value_out, .size = sizeof(size_t)},
  {"brick", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_brick_merge(const value *v) {
  return (int64_t)hsp_brick_merge(v[0].p, v[1].z, v[2].p, v[3].z, v[4].p, v[5].p, v[6].p, v[7].p);
}

static const argument of_hsp_brick_get_totals[] = {
  {"summary", "uint8_t", .kind = KIND_array_in, .size = sizeof(uint8_t), .extent = "bytes", .is_const = 1},
  {"bytes", "size_t", .kind = KIND_value, .size = sizeof(size_t)},
  {"totals", "hsp_brick_totals", .kind = KIND_struct_out, .size = sizeof(hsp_brick_totals)},
  {"brick", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_brick_get_totals(const value *v) {
  return (int64_t)hsp_brick_get_totals(v[0].p, v[1].z, v[2].p, v[3].p);
}

static const argument of_hsp_brick_get_shells[] = {
  {"summary", "uint8_t", .kind = KIND_array_in, .size = sizeof(uint8_t), .extent = "bytes", .is_const = 1},
  {"bytes", "size_t", .kind = KIND_value, .size = sizeof(size_t)},
  {"out", "hsp_brick_shell", .kind = KIND_array_out, .size = sizeof(hsp_brick_shell), .extent = "needed", .null =
      NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
  {"brick", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_brick_get_shells(const value *v) {
  return (int64_t)hsp_brick_get_shells(v[0].p, v[1].z, v[2].p, v[3].u, v[4].p, v[5].p);
}

static const argument of_hsp_contacts_limits_init[] = {
  {"limits", "hsp_contacts_limits", .kind = KIND_sized, .size = sizeof(hsp_contacts_limits)},
  {"struct_size", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
};
static int64_t call_hsp_contacts_limits_init(const value *v) {
  return (int64_t)hsp_contacts_limits_init(v[0].p, v[1].u, v[2].p);
}

static const argument of_hsp_contacts_bytes[] = {
  {"limits", "hsp_contacts_limits", .kind = KIND_sized_in, .size = sizeof(hsp_contacts_limits), .is_const = 1},
  {"bytes", "size_t", .kind = KIND_value_out, .size = sizeof(size_t)},
};
static int64_t call_hsp_contacts_bytes(const value *v) {
  return (int64_t)hsp_contacts_bytes(v[0].p, v[1].p);
}

static const argument of_hsp_contacts_init[] = {
  {"memory", "void", .kind = KIND_memory},
  {"bytes", "size_t", .kind = KIND_value, .size = sizeof(size_t)},
  {"limits", "hsp_contacts_limits", .kind = KIND_sized_in, .size = sizeof(hsp_contacts_limits), .is_const = 1},
  {"contacts", "hsp_contacts", .kind = KIND_handle_out, .noun = NOUN_contacts},
};
static int64_t call_hsp_contacts_init(const value *v) {
  return (int64_t)hsp_contacts_init(v[0].p, v[1].z, v[2].p, v[3].p);
}

static const argument of_hsp_contacts_compute[] = {
  {"contacts", "hsp_contacts", .kind = KIND_handle, .noun = NOUN_contacts},
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"limits", "hsp_contacts_limits", .kind = KIND_sized, .size = sizeof(hsp_contacts_limits), .null = NULL_always},
};
static int64_t call_hsp_contacts_compute(const value *v) {
  return (int64_t)hsp_contacts_compute(v[0].p, v[1].p, v[2].p);
}

static const argument of_hsp_contacts_compute_with[] = {
  {"contacts", "hsp_contacts", .kind = KIND_handle, .noun = NOUN_contacts},
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"request", "hsp_contacts_request", .kind = KIND_sized_in, .size = sizeof(hsp_contacts_request), .null = NULL_always,
      .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 2,
      .offset = offsetof(hsp_contacts_request, executor), .is_const = 1},
  {"limits", "hsp_contacts_limits", .kind = KIND_sized, .size = sizeof(hsp_contacts_limits), .null = NULL_always},
};
static int64_t call_hsp_contacts_compute_with(const value *v) {
  return (int64_t)hsp_contacts_compute_with(v[0].p, v[1].p, v[2].p, v[4].p);
}

static const argument of_hsp_contacts_get_pairs[] = {
  {"contacts", "hsp_contacts", .kind = KIND_handle, .noun = NOUN_contacts, .is_const = 1},
  {"out", "hsp_contact", .kind = KIND_array_out, .size = sizeof(hsp_contact), .extent = "needed", .null = NULL_empty,
      .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_contacts_get_pairs(const value *v) {
  return (int64_t)hsp_contacts_get_pairs(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_contacts_get_row[] = {
  {"contacts", "hsp_contacts", .kind = KIND_handle, .noun = NOUN_contacts, .is_const = 1},
  {"ball", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"out", "hsp_contact", .kind = KIND_array_out, .size = sizeof(hsp_contact), .extent = "needed", .null = NULL_empty,
      .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_contacts_get_row(const value *v) {
  return (int64_t)hsp_contacts_get_row(v[0].p, v[1].u, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_contacts_measure[] = {
  {"contacts", "hsp_contacts", .kind = KIND_handle, .noun = NOUN_contacts, .is_const = 1},
  {"totals", "hsp_totals", .kind = KIND_struct_out, .size = sizeof(hsp_totals), .null = NULL_always},
  {"share_volume", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .held =
      1},
  {"contact_area", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .held =
      1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_contacts_measure(const value *v) {
  return (int64_t)hsp_contacts_measure(v[0].p, v[1].p, v[2].p, v[3].p, v[4].u, v[5].p);
}

static const argument of_hsp_contacts_group[] = {
  {"contacts", "hsp_contacts", .kind = KIND_handle, .noun = NOUN_contacts},
  {"group", "uint32_t", .kind = KIND_array_in, .size = sizeof(uint32_t), .extent = "n", .is_const = 1},
  {"out", "hsp_group_contact", .kind = KIND_array_out, .size = sizeof(hsp_group_contact), .extent = "needed", .null =
      NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_contacts_group(const value *v) {
  return (int64_t)hsp_contacts_group(v[0].p, v[1].p, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_contacts_get_complex[] = {
  {"contacts", "hsp_contacts", .kind = KIND_handle, .noun = NOUN_contacts, .is_const = 1},
  {"counts", "hsp_complex", .kind = KIND_struct_out, .size = sizeof(hsp_complex)},
};
static int64_t call_hsp_contacts_get_complex(const value *v) {
  return (int64_t)hsp_contacts_get_complex(v[0].p, v[1].p);
}

static const argument of_hsp_contacts_get_simplices[] = {
  {"contacts", "hsp_contacts", .kind = KIND_handle, .noun = NOUN_contacts, .is_const = 1},
  {"dimension", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"out", "hsp_simplex", .kind = KIND_array_out, .size = sizeof(hsp_simplex), .extent = "needed", .null = NULL_empty,
      .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_contacts_get_simplices(const value *v) {
  return (int64_t)hsp_contacts_get_simplices(v[0].p, v[1].u, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_contacts_check[] = {
  {"contacts", "hsp_contacts", .kind = KIND_handle, .noun = NOUN_contacts},
  {"invariant", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
  {"id", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_contacts_check(const value *v) {
  return (int64_t)hsp_contacts_check(v[0].p, v[1].p, v[2].p);
}

static const argument of_hsp_periodic_limits_init[] = {
  {"limits", "hsp_periodic_limits", .kind = KIND_sized, .size = sizeof(hsp_periodic_limits)},
  {"struct_size", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"balls", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_periodic_limits_init(const value *v) {
  return (int64_t)hsp_periodic_limits_init(v[0].p, v[1].u, v[2].u);
}

static const argument of_hsp_periodic_bytes[] = {
  {"limits", "hsp_periodic_limits", .kind = KIND_sized_in, .size = sizeof(hsp_periodic_limits), .is_const = 1},
  {"bytes", "size_t", .kind = KIND_value_out, .size = sizeof(size_t)},
};
static int64_t call_hsp_periodic_bytes(const value *v) {
  return (int64_t)hsp_periodic_bytes(v[0].p, v[1].p);
}

static const argument of_hsp_periodic_init[] = {
  {"memory", "void", .kind = KIND_memory},
  {"bytes", "size_t", .kind = KIND_value, .size = sizeof(size_t)},
  {"limits", "hsp_periodic_limits", .kind = KIND_sized_in, .size = sizeof(hsp_periodic_limits), .is_const = 1},
  {"periodic", "hsp_periodic", .kind = KIND_handle_out, .noun = NOUN_periodic},
};
static int64_t call_hsp_periodic_init(const value *v) {
  return (int64_t)hsp_periodic_init(v[0].p, v[1].z, v[2].p, v[3].p);
}

static const argument of_hsp_periodic_compute[] = {
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic},
  {"n", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"xyz", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "n", .row = 3, .null = NULL_empty,
      .is_const = 1},
  {"radius", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "n", .null = NULL_empty, .is_const = 1},
  {"box", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "9", .is_const = 1},
  {"options", "hsp_model_options", .kind = KIND_sized_in, .size = sizeof(hsp_model_options), .null = NULL_always,
      .is_const = 1},
  {"limits", "hsp_periodic_limits", .kind = KIND_sized, .size = sizeof(hsp_periodic_limits), .null = NULL_always},
  {"first_bad", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_periodic_compute(const value *v) {
  return (int64_t)hsp_periodic_compute(v[0].p, v[1].u, v[2].p, v[3].p, v[4].p, v[5].p, v[6].p, v[7].p);
}

static const argument of_hsp_periodic_compute_with[] = {
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic},
  {"n", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"xyz", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "n", .row = 3, .null = NULL_empty,
      .is_const = 1},
  {"radius", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "n", .null = NULL_empty, .is_const = 1},
  {"box", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "9", .is_const = 1},
  {"request", "hsp_periodic_request", .kind = KIND_sized_in, .size = sizeof(hsp_periodic_request), .null = NULL_always,
      .is_const = 1},
  {"areas_alone", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t), .of = 5, .offset =
      offsetof(hsp_periodic_request, areas_alone)},
  {"options", "hsp_model_options", .kind = KIND_sized_in, .size = sizeof(hsp_model_options), .null = NULL_always, .of =
      5, .offset = offsetof(hsp_periodic_request, options), .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 5,
      .offset = offsetof(hsp_periodic_request, executor), .is_const = 1},
  {"limits", "hsp_periodic_limits", .kind = KIND_sized, .size = sizeof(hsp_periodic_limits), .null = NULL_always},
  {"first_bad", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_periodic_compute_with(const value *v) {
  return (int64_t)hsp_periodic_compute_with(v[0].p, v[1].u, v[2].p, v[3].p, v[4].p, v[5].p, v[9].p, v[10].p);
}

static const argument of_hsp_periodic_get_counts[] = {
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic, .is_const = 1},
  {"counts", "hsp_periodic_counts", .kind = KIND_struct_out, .size = sizeof(hsp_periodic_counts)},
};
static int64_t call_hsp_periodic_get_counts(const value *v) {
  return (int64_t)hsp_periodic_get_counts(v[0].p, v[1].p);
}

static const argument of_hsp_periodic_measure[] = {
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic, .is_const = 1},
  {"totals", "hsp_periodic_totals", .kind = KIND_struct_out, .size = sizeof(hsp_periodic_totals), .null = NULL_always},
  {"area", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .held = 1},
  {"share_volume", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .held =
      1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_periodic_measure(const value *v) {
  return (int64_t)hsp_periodic_measure(v[0].p, v[1].p, v[2].p, v[3].p, v[4].u, v[5].p);
}

static const argument of_hsp_periodic_curvature[] = {
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic, .is_const = 1},
  {"totals", "hsp_curvatures", .kind = KIND_struct_out, .size = sizeof(hsp_curvatures), .null = NULL_always},
  {"mean", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .held = 1},
  {"gauss_thirds", "int32_t", .kind = KIND_array_out, .size = sizeof(int32_t), .extent = "n", .null = NULL_always, .held
      = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_periodic_curvature(const value *v) {
  return (int64_t)hsp_periodic_curvature(v[0].p, v[1].p, v[2].p, v[3].p, v[4].u, v[5].p);
}

static const argument of_hsp_periodic_get_morphometry[] = {
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic, .is_const = 1},
  {"request", "hsp_morphometry_request", .kind = KIND_sized_in, .size = sizeof(hsp_morphometry_request), .null =
      NULL_always, .is_const = 1},
  {"pressure", "double", .kind = KIND_value, .size = sizeof(double), .of = 1, .offset =
      offsetof(hsp_morphometry_request, pressure)},
  {"tension", "double", .kind = KIND_value, .size = sizeof(double), .of = 1, .offset = offsetof(hsp_morphometry_request,
      tension)},
  {"bending", "double", .kind = KIND_value, .size = sizeof(double), .of = 1, .offset = offsetof(hsp_morphometry_request,
      bending)},
  {"gaussian", "double", .kind = KIND_value, .size = sizeof(double), .of = 1, .offset =
      offsetof(hsp_morphometry_request, gaussian)},
  {"sigma", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "n", .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_morphometry_request, sigma), .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_morphometry_request, executor), .is_const = 1},
  {"outputs", "hsp_periodic_morphometry_outputs", .kind = KIND_outputs, .size =
      sizeof(hsp_periodic_morphometry_outputs)},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t), .of = 8, .offset =
      offsetof(hsp_periodic_morphometry_outputs, capacity)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .of = 8, .offset =
      offsetof(hsp_periodic_morphometry_outputs, needed)},
  {"first_bad", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .of = 8, .offset =
      offsetof(hsp_periodic_morphometry_outputs, first_bad)},
  {"energy", "hsp_morphometric_energy", .kind = KIND_struct_out, .size = sizeof(hsp_morphometric_energy), .null =
      NULL_always, .of = 8, .offset = offsetof(hsp_periodic_morphometry_outputs, energy)},
  {"d_centre", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .row = 3, .null = NULL_always,
      .of = 8, .offset = offsetof(hsp_periodic_morphometry_outputs, d_centre), .held = 1},
  {"d_radius", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .of = 8,
      .offset = offsetof(hsp_periodic_morphometry_outputs, d_radius), .held = 1},
  {"flags", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "n", .null = NULL_always, .of = 8,
      .offset = offsetof(hsp_periodic_morphometry_outputs, flags), .held = 1},
  {"d_strain", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "9", .null = NULL_always, .of = 8,
      .offset = offsetof(hsp_periodic_morphometry_outputs, d_strain)},
  {"d_box", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "9", .null = NULL_always, .of = 8,
      .offset = offsetof(hsp_periodic_morphometry_outputs, d_box)},
  {"area", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .of = 8,
      .offset = offsetof(hsp_periodic_morphometry_outputs, area), .held = 1},
};
static int64_t call_hsp_periodic_get_morphometry(const value *v) {
  return (int64_t)hsp_periodic_get_morphometry(v[0].p, v[1].p, v[8].p);
}

static const argument of_hsp_periodic_get_contacts[] = {
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic, .is_const = 1},
  {"out", "hsp_periodic_contact", .kind = KIND_array_out, .size = sizeof(hsp_periodic_contact), .extent = "needed",
      .null = NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_periodic_get_contacts(const value *v) {
  return (int64_t)hsp_periodic_get_contacts(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_periodic_group_contacts[] = {
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic},
  {"group", "uint32_t", .kind = KIND_array_in, .size = sizeof(uint32_t), .extent = "n", .is_const = 1},
  {"out", "hsp_group_contact", .kind = KIND_array_out, .size = sizeof(hsp_group_contact), .extent = "needed", .null =
      NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_periodic_group_contacts(const value *v) {
  return (int64_t)hsp_periodic_group_contacts(v[0].p, v[1].p, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_periodic_get_windings[] = {
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic, .is_const = 1},
  {"out", "hsp_winding", .kind = KIND_array_out, .size = sizeof(hsp_winding), .extent = "needed", .null = NULL_empty,
      .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_periodic_get_windings(const value *v) {
  return (int64_t)hsp_periodic_get_windings(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_periodic_get_components[] = {
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic, .is_const = 1},
  {"component", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "n", .null = NULL_empty, .held =
      1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_periodic_get_components(const value *v) {
  return (int64_t)hsp_periodic_get_components(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_periodic_get_gradient[] = {
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic, .is_const = 1},
  {"request", "hsp_gradient_request", .kind = KIND_sized_in, .size = sizeof(hsp_gradient_request), .null = NULL_always,
      .is_const = 1},
  {"tangency", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t), .of = 1, .offset =
      offsetof(hsp_gradient_request, tangency)},
  {"tension", "double", .kind = KIND_value, .size = sizeof(double), .of = 1, .offset = offsetof(hsp_gradient_request,
      tension)},
  {"pressure", "double", .kind = KIND_value, .size = sizeof(double), .of = 1, .offset = offsetof(hsp_gradient_request,
      pressure)},
  {"sigma", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "n", .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_gradient_request, sigma), .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_gradient_request, executor), .is_const = 1},
  {"outputs", "hsp_periodic_gradient_outputs", .kind = KIND_outputs, .size = sizeof(hsp_periodic_gradient_outputs)},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t), .of = 7, .offset =
      offsetof(hsp_periodic_gradient_outputs, capacity)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .of = 7, .offset =
      offsetof(hsp_periodic_gradient_outputs, needed)},
  {"first_bad", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .of = 7, .offset =
      offsetof(hsp_periodic_gradient_outputs, first_bad)},
  {"energy", "hsp_energy", .kind = KIND_struct_out, .size = sizeof(hsp_energy), .null = NULL_always, .of = 7, .offset =
      offsetof(hsp_periodic_gradient_outputs, energy)},
  {"d_centre", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .row = 3, .null = NULL_always,
      .of = 7, .offset = offsetof(hsp_periodic_gradient_outputs, d_centre), .held = 1},
  {"d_radius", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .of = 7,
      .offset = offsetof(hsp_periodic_gradient_outputs, d_radius), .held = 1},
  {"flags", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "n", .null = NULL_always, .of = 7,
      .offset = offsetof(hsp_periodic_gradient_outputs, flags), .held = 1},
  {"d_strain", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "9", .null = NULL_always, .of = 7,
      .offset = offsetof(hsp_periodic_gradient_outputs, d_strain)},
  {"d_box", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "9", .null = NULL_always, .of = 7,
      .offset = offsetof(hsp_periodic_gradient_outputs, d_box)},
  {"area", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .of = 7,
      .offset = offsetof(hsp_periodic_gradient_outputs, area), .held = 1},
};
static int64_t call_hsp_periodic_get_gradient(const value *v) {
  return (int64_t)hsp_periodic_get_gradient(v[0].p, v[1].p, v[7].p);
}

static const argument of_hsp_periodic_get_hessian_rows[] = {
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic, .is_const = 1},
  {"request", "hsp_gradient_request", .kind = KIND_sized_in, .size = sizeof(hsp_gradient_request), .null = NULL_always,
      .is_const = 1},
  {"tangency", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t), .of = 1, .offset =
      offsetof(hsp_gradient_request, tangency)},
  {"tension", "double", .kind = KIND_value, .size = sizeof(double), .of = 1, .offset = offsetof(hsp_gradient_request,
      tension)},
  {"pressure", "double", .kind = KIND_value, .size = sizeof(double), .of = 1, .offset = offsetof(hsp_gradient_request,
      pressure)},
  {"sigma", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "n", .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_gradient_request, sigma), .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_gradient_request, executor), .is_const = 1},
  {"first", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "n + 1"},
  {"ball", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "needed", .null = NULL_empty, .held =
      1},
  {"block", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "needed", .row = 3 * 3, .null =
      NULL_empty, .held = 1},
  {"flags", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "n + 1", .null = NULL_always},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_periodic_get_hessian_rows(const value *v) {
  return (int64_t)hsp_periodic_get_hessian_rows(v[0].p, v[1].p, v[7].p, v[8].p, v[9].p, v[10].p, v[11].u, v[12].p);
}

static const argument of_hsp_periodic_query_point[] = {
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic, .is_const = 1},
  {"xyz", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "3", .is_const = 1},
  {"out", "hsp_image", .kind = KIND_array_out, .size = sizeof(hsp_image), .extent = "needed", .null = NULL_empty, .held
      = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_periodic_query_point(const value *v) {
  return (int64_t)hsp_periodic_query_point(v[0].p, v[1].p, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_periodic_query_ball[] = {
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic, .is_const = 1},
  {"xyz", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "3", .is_const = 1},
  {"radius", "double", .kind = KIND_value, .size = sizeof(double)},
  {"out", "hsp_image", .kind = KIND_array_out, .size = sizeof(hsp_image), .extent = "needed", .null = NULL_empty, .held
      = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_periodic_query_ball(const value *v) {
  return (int64_t)hsp_periodic_query_ball(v[0].p, v[1].p, v[2].d, v[3].p, v[4].u, v[5].p);
}

static const argument of_hsp_periodic_query_neighbours[] = {
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic, .is_const = 1},
  {"ball", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"out", "hsp_image", .kind = KIND_array_out, .size = sizeof(hsp_image), .extent = "needed", .null = NULL_empty, .held
      = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_periodic_query_neighbours(const value *v) {
  return (int64_t)hsp_periodic_query_neighbours(v[0].p, v[1].u, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_periodic_query_pairs[] = {
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic, .is_const = 1},
  {"flags", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"first", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "n + 1"},
  {"out", "hsp_image", .kind = KIND_array_out, .size = sizeof(hsp_image), .extent = "needed", .null = NULL_empty, .held
      = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_periodic_query_pairs(const value *v) {
  return (int64_t)hsp_periodic_query_pairs(v[0].p, v[1].u, v[2].p, v[3].p, v[4].u, v[5].p);
}

static const argument of_hsp_periodic_check[] = {
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic},
  {"invariant", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
  {"id", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_periodic_check(const value *v) {
  return (int64_t)hsp_periodic_check(v[0].p, v[1].p, v[2].p);
}

static const argument of_hsp_periodic_get_vertices[] = {
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic, .is_const = 1},
  {"out", "hsp_periodic_vertex", .kind = KIND_array_out, .size = sizeof(hsp_periodic_vertex), .extent = "needed", .null
      = NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_periodic_get_vertices(const value *v) {
  return (int64_t)hsp_periodic_get_vertices(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_periodic_get_arcs[] = {
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic, .is_const = 1},
  {"out", "hsp_periodic_arc", .kind = KIND_array_out, .size = sizeof(hsp_periodic_arc), .extent = "needed", .null =
      NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_periodic_get_arcs(const value *v) {
  return (int64_t)hsp_periodic_get_arcs(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_periodic_get_circles[] = {
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic, .is_const = 1},
  {"out", "hsp_periodic_circle", .kind = KIND_array_out, .size = sizeof(hsp_periodic_circle), .extent = "needed", .null
      = NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_periodic_get_circles(const value *v) {
  return (int64_t)hsp_periodic_get_circles(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_periodic_get_faces[] = {
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic, .is_const = 1},
  {"out", "hsp_periodic_face", .kind = KIND_array_out, .size = sizeof(hsp_periodic_face), .extent = "needed", .null =
      NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_periodic_get_faces(const value *v) {
  return (int64_t)hsp_periodic_get_faces(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_periodic_get_loops[] = {
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic, .is_const = 1},
  {"out", "hsp_periodic_loop", .kind = KIND_array_out, .size = sizeof(hsp_periodic_loop), .extent = "needed", .null =
      NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_periodic_get_loops(const value *v) {
  return (int64_t)hsp_periodic_get_loops(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_periodic_get_loop_arcs[] = {
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic, .is_const = 1},
  {"out", "hsp_periodic_loop_arc", .kind = KIND_array_out, .size = sizeof(hsp_periodic_loop_arc), .extent = "needed",
      .null = NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_periodic_get_loop_arcs(const value *v) {
  return (int64_t)hsp_periodic_get_loop_arcs(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_periodic_get_balls[] = {
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic, .is_const = 1},
  {"out", "hsp_ball", .kind = KIND_array_out, .size = sizeof(hsp_ball), .extent = "needed", .null = NULL_empty, .held =
      1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_periodic_get_balls(const value *v) {
  return (int64_t)hsp_periodic_get_balls(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_surface_limits_init[] = {
  {"limits", "hsp_surface_limits", .kind = KIND_sized, .size = sizeof(hsp_surface_limits)},
  {"struct_size", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
};
static int64_t call_hsp_surface_limits_init(const value *v) {
  return (int64_t)hsp_surface_limits_init(v[0].p, v[1].u, v[2].p);
}

static const argument of_hsp_surface_bytes[] = {
  {"limits", "hsp_surface_limits", .kind = KIND_sized_in, .size = sizeof(hsp_surface_limits), .is_const = 1},
  {"bytes", "size_t", .kind = KIND_value_out, .size = sizeof(size_t)},
};
static int64_t call_hsp_surface_bytes(const value *v) {
  return (int64_t)hsp_surface_bytes(v[0].p, v[1].p);
}

static const argument of_hsp_surface_init[] = {
  {"memory", "void", .kind = KIND_memory},
  {"bytes", "size_t", .kind = KIND_value, .size = sizeof(size_t)},
  {"limits", "hsp_surface_limits", .kind = KIND_sized_in, .size = sizeof(hsp_surface_limits), .is_const = 1},
  {"surface", "hsp_surface", .kind = KIND_handle_out, .noun = NOUN_surface},
};
static int64_t call_hsp_surface_init(const value *v) {
  return (int64_t)hsp_surface_init(v[0].p, v[1].z, v[2].p, v[3].p);
}

static const argument of_hsp_surface_compute[] = {
  {"surface", "hsp_surface", .kind = KIND_handle, .noun = NOUN_surface},
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"limits", "hsp_surface_limits", .kind = KIND_sized, .size = sizeof(hsp_surface_limits), .null = NULL_always},
};
static int64_t call_hsp_surface_compute(const value *v) {
  return (int64_t)hsp_surface_compute(v[0].p, v[1].p, v[2].p);
}

static const argument of_hsp_surface_compute_shells[] = {
  {"surface", "hsp_surface", .kind = KIND_handle, .noun = NOUN_surface},
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"shells", "uint32_t", .kind = KIND_array_in, .size = sizeof(uint32_t), .extent = "count", .null = NULL_empty,
      .is_const = 1},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"limits", "hsp_surface_limits", .kind = KIND_sized, .size = sizeof(hsp_surface_limits), .null = NULL_always},
};
static int64_t call_hsp_surface_compute_shells(const value *v) {
  return (int64_t)hsp_surface_compute_shells(v[0].p, v[1].p, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_surface_compute_with[] = {
  {"surface", "hsp_surface", .kind = KIND_handle, .noun = NOUN_surface},
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"request", "hsp_surface_request", .kind = KIND_sized_in, .size = sizeof(hsp_surface_request), .null = NULL_always,
      .is_const = 1},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t), .of = 2, .offset = offsetof(hsp_surface_request,
      count)},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 2,
      .offset = offsetof(hsp_surface_request, executor), .is_const = 1},
  {"shells", "uint32_t", .kind = KIND_array_in, .size = sizeof(uint32_t), .extent = "count", .null = NULL_always, .of =
      2, .offset = offsetof(hsp_surface_request, shells), .is_const = 1},
  {"limits", "hsp_surface_limits", .kind = KIND_sized, .size = sizeof(hsp_surface_limits), .null = NULL_always},
};
static int64_t call_hsp_surface_compute_with(const value *v) {
  return (int64_t)hsp_surface_compute_with(v[0].p, v[1].p, v[2].p, v[6].p);
}

static const argument of_hsp_surface_get_counts[] = {
  {"surface", "hsp_surface", .kind = KIND_handle, .noun = NOUN_surface, .is_const = 1},
  {"counts", "hsp_surface_counts", .kind = KIND_struct_out, .size = sizeof(hsp_surface_counts)},
};
static int64_t call_hsp_surface_get_counts(const value *v) {
  return (int64_t)hsp_surface_get_counts(v[0].p, v[1].p);
}

static const argument of_hsp_surface_measure[] = {
  {"surface", "hsp_surface", .kind = KIND_handle, .noun = NOUN_surface, .is_const = 1},
  {"totals", "hsp_surface_totals", .kind = KIND_struct_out, .size = sizeof(hsp_surface_totals), .null = NULL_always},
  {"balls", "hsp_surface_totals", .kind = KIND_array_out, .size = sizeof(hsp_surface_totals), .extent = "needed", .null
      = NULL_always, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_surface_measure(const value *v) {
  return (int64_t)hsp_surface_measure(v[0].p, v[1].p, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_surface_measure_with[] = {
  {"surface", "hsp_surface", .kind = KIND_handle, .noun = NOUN_surface, .is_const = 1},
  {"request", "hsp_surface_measure_request", .kind = KIND_sized_in, .size = sizeof(hsp_surface_measure_request), .null =
      NULL_always, .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_surface_measure_request, executor), .is_const = 1},
  {"totals", "hsp_surface_totals", .kind = KIND_struct_out, .size = sizeof(hsp_surface_totals), .null = NULL_always},
  {"balls", "hsp_surface_totals", .kind = KIND_array_out, .size = sizeof(hsp_surface_totals), .extent = "needed", .null
      = NULL_always, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_surface_measure_with(const value *v) {
  return (int64_t)hsp_surface_measure_with(v[0].p, v[1].p, v[3].p, v[4].p, v[5].u, v[6].p);
}

static const argument of_hsp_surface_get_gradient[] = {
  {"surface", "hsp_surface", .kind = KIND_handle, .noun = NOUN_surface, .is_const = 1},
  {"request", "hsp_gradient_request", .kind = KIND_sized_in, .size = sizeof(hsp_gradient_request), .null = NULL_always,
      .is_const = 1},
  {"tangency", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t), .of = 1, .offset =
      offsetof(hsp_gradient_request, tangency)},
  {"tension", "double", .kind = KIND_value, .size = sizeof(double), .of = 1, .offset = offsetof(hsp_gradient_request,
      tension)},
  {"pressure", "double", .kind = KIND_value, .size = sizeof(double), .of = 1, .offset = offsetof(hsp_gradient_request,
      pressure)},
  {"sigma", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "n", .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_gradient_request, sigma), .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 1,
      .offset = offsetof(hsp_gradient_request, executor), .is_const = 1},
  {"outputs", "hsp_gradient_outputs", .kind = KIND_outputs, .size = sizeof(hsp_gradient_outputs)},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t), .of = 7, .offset =
      offsetof(hsp_gradient_outputs, capacity)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .of = 7, .offset =
      offsetof(hsp_gradient_outputs, needed)},
  {"first_bad", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .of = 7, .offset =
      offsetof(hsp_gradient_outputs, first_bad)},
  {"energy", "hsp_energy", .kind = KIND_struct_out, .size = sizeof(hsp_energy), .null = NULL_always, .of = 7, .offset =
      offsetof(hsp_gradient_outputs, energy)},
  {"d_centre", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .row = 3, .null = NULL_always,
      .of = 7, .offset = offsetof(hsp_gradient_outputs, d_centre), .held = 1},
  {"d_radius", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .of = 7,
      .offset = offsetof(hsp_gradient_outputs, d_radius), .held = 1},
  {"flags", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "n", .null = NULL_always, .of = 7,
      .offset = offsetof(hsp_gradient_outputs, flags), .held = 1},
  {"area", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "n", .null = NULL_always, .of = 7,
      .offset = offsetof(hsp_gradient_outputs, area), .held = 1},
};
static int64_t call_hsp_surface_get_gradient(const value *v) {
  return (int64_t)hsp_surface_get_gradient(v[0].p, v[1].p, v[7].p);
}

static const argument of_hsp_surface_get_part_counts[] = {
  {"surface", "hsp_surface", .kind = KIND_handle, .noun = NOUN_surface, .is_const = 1},
  {"counts", "hsp_surface_part_counts", .kind = KIND_struct_out, .size = sizeof(hsp_surface_part_counts)},
};
static int64_t call_hsp_surface_get_part_counts(const value *v) {
  return (int64_t)hsp_surface_get_part_counts(v[0].p, v[1].p);
}

static const argument of_hsp_surface_next[] = {
  {"surface", "hsp_surface", .kind = KIND_handle, .noun = NOUN_surface, .is_const = 1},
  {"h", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_surface_next(const value *v) {
  return (int64_t)hsp_surface_next(v[0].p, v[1].u);
}

static const argument of_hsp_surface_previous[] = {
  {"surface", "hsp_surface", .kind = KIND_handle, .noun = NOUN_surface, .is_const = 1},
  {"h", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_surface_previous(const value *v) {
  return (int64_t)hsp_surface_previous(v[0].p, v[1].u);
}

static const argument of_hsp_surface_next_loop[] = {
  {"surface", "hsp_surface", .kind = KIND_handle, .noun = NOUN_surface, .is_const = 1},
  {"h", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_surface_next_loop(const value *v) {
  return (int64_t)hsp_surface_next_loop(v[0].p, v[1].u);
}

static const argument of_hsp_surface_origin[] = {
  {"surface", "hsp_surface", .kind = KIND_handle, .noun = NOUN_surface, .is_const = 1},
  {"h", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_surface_origin(const value *v) {
  return (int64_t)hsp_surface_origin(v[0].p, v[1].u);
}

static const argument of_hsp_surface_left[] = {
  {"surface", "hsp_surface", .kind = KIND_handle, .noun = NOUN_surface, .is_const = 1},
  {"h", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_surface_left(const value *v) {
  return (int64_t)hsp_surface_left(v[0].p, v[1].u);
}

static const argument of_hsp_surface_get_patches[] = {
  {"surface", "hsp_surface", .kind = KIND_handle, .noun = NOUN_surface, .is_const = 1},
  {"first", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"out", "hsp_surface_patch", .kind = KIND_array_out, .size = sizeof(hsp_surface_patch), .extent = "count", .null =
      NULL_empty},
};
static int64_t call_hsp_surface_get_patches(const value *v) {
  return (int64_t)hsp_surface_get_patches(v[0].p, v[1].u, v[2].u, v[3].p);
}

static const argument of_hsp_surface_get_edges[] = {
  {"surface", "hsp_surface", .kind = KIND_handle, .noun = NOUN_surface, .is_const = 1},
  {"first", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"out", "hsp_surface_edge", .kind = KIND_array_out, .size = sizeof(hsp_surface_edge), .extent = "count", .null =
      NULL_empty},
};
static int64_t call_hsp_surface_get_edges(const value *v) {
  return (int64_t)hsp_surface_get_edges(v[0].p, v[1].u, v[2].u, v[3].p);
}

static const argument of_hsp_surface_get_corners[] = {
  {"surface", "hsp_surface", .kind = KIND_handle, .noun = NOUN_surface, .is_const = 1},
  {"first", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"out", "hsp_surface_corner", .kind = KIND_array_out, .size = sizeof(hsp_surface_corner), .extent = "count", .null =
      NULL_empty},
};
static int64_t call_hsp_surface_get_corners(const value *v) {
  return (int64_t)hsp_surface_get_corners(v[0].p, v[1].u, v[2].u, v[3].p);
}

static const argument of_hsp_surface_get_shells[] = {
  {"surface", "hsp_surface", .kind = KIND_handle, .noun = NOUN_surface, .is_const = 1},
  {"out", "hsp_surface_shell", .kind = KIND_array_out, .size = sizeof(hsp_surface_shell), .extent = "needed", .null =
      NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_surface_get_shells(const value *v) {
  return (int64_t)hsp_surface_get_shells(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_surface_check[] = {
  {"surface", "hsp_surface", .kind = KIND_handle, .noun = NOUN_surface},
  {"invariant", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
  {"id", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_surface_check(const value *v) {
  return (int64_t)hsp_surface_check(v[0].p, v[1].p, v[2].p);
}

static const argument of_hsp_mesh_limits_init[] = {
  {"limits", "hsp_mesh_limits", .kind = KIND_sized, .size = sizeof(hsp_mesh_limits)},
  {"struct_size", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"edge_length", "double", .kind = KIND_value, .size = sizeof(double)},
};
static int64_t call_hsp_mesh_limits_init(const value *v) {
  return (int64_t)hsp_mesh_limits_init(v[0].p, v[1].u, v[2].p, v[3].d);
}

static const argument of_hsp_mesh_limits_init_surface[] = {
  {"limits", "hsp_mesh_limits", .kind = KIND_sized, .size = sizeof(hsp_mesh_limits)},
  {"struct_size", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"surface", "hsp_surface", .kind = KIND_handle, .noun = NOUN_surface, .is_const = 1},
  {"edge_length", "double", .kind = KIND_value, .size = sizeof(double)},
};
static int64_t call_hsp_mesh_limits_init_surface(const value *v) {
  return (int64_t)hsp_mesh_limits_init_surface(v[0].p, v[1].u, v[2].p, v[3].d);
}

static const argument of_hsp_mesh_bytes[] = {
  {"limits", "hsp_mesh_limits", .kind = KIND_sized_in, .size = sizeof(hsp_mesh_limits), .is_const = 1},
  {"bytes", "size_t", .kind = KIND_value_out, .size = sizeof(size_t)},
};
static int64_t call_hsp_mesh_bytes(const value *v) {
  return (int64_t)hsp_mesh_bytes(v[0].p, v[1].p);
}

static const argument of_hsp_mesh_init[] = {
  {"memory", "void", .kind = KIND_memory},
  {"bytes", "size_t", .kind = KIND_value, .size = sizeof(size_t)},
  {"limits", "hsp_mesh_limits", .kind = KIND_sized_in, .size = sizeof(hsp_mesh_limits), .is_const = 1},
  {"mesh", "hsp_mesh", .kind = KIND_handle_out, .noun = NOUN_mesh},
};
static int64_t call_hsp_mesh_init(const value *v) {
  return (int64_t)hsp_mesh_init(v[0].p, v[1].z, v[2].p, v[3].p);
}

static const argument of_hsp_mesh_compute[] = {
  {"mesh", "hsp_mesh", .kind = KIND_handle, .noun = NOUN_mesh},
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"edge_length", "double", .kind = KIND_value, .size = sizeof(double)},
  {"limits", "hsp_mesh_limits", .kind = KIND_sized, .size = sizeof(hsp_mesh_limits), .null = NULL_always},
};
static int64_t call_hsp_mesh_compute(const value *v) {
  return (int64_t)hsp_mesh_compute(v[0].p, v[1].p, v[2].d, v[3].p);
}

static const argument of_hsp_mesh_compute_surface[] = {
  {"mesh", "hsp_mesh", .kind = KIND_handle, .noun = NOUN_mesh},
  {"surface", "hsp_surface", .kind = KIND_handle, .noun = NOUN_surface, .is_const = 1},
  {"edge_length", "double", .kind = KIND_value, .size = sizeof(double)},
  {"limits", "hsp_mesh_limits", .kind = KIND_sized, .size = sizeof(hsp_mesh_limits), .null = NULL_always},
};
static int64_t call_hsp_mesh_compute_surface(const value *v) {
  return (int64_t)hsp_mesh_compute_surface(v[0].p, v[1].p, v[2].d, v[3].p);
}

static const argument of_hsp_mesh_compute_with[] = {
  {"mesh", "hsp_mesh", .kind = KIND_handle, .noun = NOUN_mesh},
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"edge_length", "double", .kind = KIND_value, .size = sizeof(double)},
  {"request", "hsp_mesh_request", .kind = KIND_sized_in, .size = sizeof(hsp_mesh_request), .null = NULL_always,
      .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 3,
      .offset = offsetof(hsp_mesh_request, executor), .is_const = 1},
  {"limits", "hsp_mesh_limits", .kind = KIND_sized, .size = sizeof(hsp_mesh_limits), .null = NULL_always},
};
static int64_t call_hsp_mesh_compute_with(const value *v) {
  return (int64_t)hsp_mesh_compute_with(v[0].p, v[1].p, v[2].d, v[3].p, v[5].p);
}

static const argument of_hsp_mesh_compute_surface_with[] = {
  {"mesh", "hsp_mesh", .kind = KIND_handle, .noun = NOUN_mesh},
  {"surface", "hsp_surface", .kind = KIND_handle, .noun = NOUN_surface, .is_const = 1},
  {"edge_length", "double", .kind = KIND_value, .size = sizeof(double)},
  {"request", "hsp_mesh_request", .kind = KIND_sized_in, .size = sizeof(hsp_mesh_request), .null = NULL_always,
      .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 3,
      .offset = offsetof(hsp_mesh_request, executor), .is_const = 1},
  {"limits", "hsp_mesh_limits", .kind = KIND_sized, .size = sizeof(hsp_mesh_limits), .null = NULL_always},
};
static int64_t call_hsp_mesh_compute_surface_with(const value *v) {
  return (int64_t)hsp_mesh_compute_surface_with(v[0].p, v[1].p, v[2].d, v[3].p, v[5].p);
}

static const argument of_hsp_mesh_get_counts[] = {
  {"mesh", "hsp_mesh", .kind = KIND_handle, .noun = NOUN_mesh, .is_const = 1},
  {"counts", "hsp_mesh_counts", .kind = KIND_struct_out, .size = sizeof(hsp_mesh_counts)},
};
static int64_t call_hsp_mesh_get_counts(const value *v) {
  return (int64_t)hsp_mesh_get_counts(v[0].p, v[1].p);
}

static const argument of_hsp_mesh_get_vertices[] = {
  {"mesh", "hsp_mesh", .kind = KIND_handle, .noun = NOUN_mesh, .is_const = 1},
  {"xyz", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "vertices", .row = 3, .null = NULL_always,
      .held = 1},
  {"normals", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "vertices", .row = 3, .null =
      NULL_always, .held = 1},
  {"areas", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "vertices", .null = NULL_always, .held =
      1},
  {"balls", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "vertices", .null = NULL_always,
      .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_mesh_get_vertices(const value *v) {
  return (int64_t)hsp_mesh_get_vertices(v[0].p, v[1].p, v[2].p, v[3].p, v[4].p, v[5].u, v[6].p);
}

static const argument of_hsp_mesh_get_weights[] = {
  {"mesh", "hsp_mesh", .kind = KIND_handle, .noun = NOUN_mesh, .is_const = 1},
  {"area", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "patches", .is_const = 1},
  {"patches", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"weights", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "vertices", .null = NULL_empty, .held
      = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_mesh_get_weights(const value *v) {
  return (int64_t)hsp_mesh_get_weights(v[0].p, v[1].p, v[2].u, v[3].p, v[4].u, v[5].p);
}

static const argument of_hsp_mesh_get_triangles[] = {
  {"mesh", "hsp_mesh", .kind = KIND_handle, .noun = NOUN_mesh, .is_const = 1},
  {"corners", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "triangles", .row = 3, .null =
      NULL_always, .held = 1},
  {"kinds", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "triangles", .null = NULL_always,
      .held = 1},
  {"patches", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "triangles", .null = NULL_always,
      .held = 1},
  {"balls", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "triangles", .null = NULL_always,
      .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_mesh_get_triangles(const value *v) {
  return (int64_t)hsp_mesh_get_triangles(v[0].p, v[1].p, v[2].p, v[3].p, v[4].p, v[5].u, v[6].p);
}

static const argument of_hsp_mesh_get_patch[] = {
  {"mesh", "hsp_mesh", .kind = KIND_handle, .noun = NOUN_mesh, .is_const = 1},
  {"patch", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"first", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
  {"count", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_mesh_get_patch(const value *v) {
  return (int64_t)hsp_mesh_get_patch(v[0].p, v[1].u, v[2].p, v[3].p);
}

static const argument of_hsp_topology_limits_init[] = {
  {"limits", "hsp_topology_limits", .kind = KIND_sized, .size = sizeof(hsp_topology_limits)},
  {"struct_size", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
};
static int64_t call_hsp_topology_limits_init(const value *v) {
  return (int64_t)hsp_topology_limits_init(v[0].p, v[1].u, v[2].p);
}

static const argument of_hsp_topology_bytes[] = {
  {"limits", "hsp_topology_limits", .kind = KIND_sized_in, .size = sizeof(hsp_topology_limits), .is_const = 1},
  {"bytes", "size_t", .kind = KIND_value_out, .size = sizeof(size_t)},
};
static int64_t call_hsp_topology_bytes(const value *v) {
  return (int64_t)hsp_topology_bytes(v[0].p, v[1].p);
}

static const argument of_hsp_topology_init[] = {
  {"memory", "void", .kind = KIND_memory},
  {"bytes", "size_t", .kind = KIND_value, .size = sizeof(size_t)},
  {"limits", "hsp_topology_limits", .kind = KIND_sized_in, .size = sizeof(hsp_topology_limits), .is_const = 1},
  {"topology", "hsp_topology", .kind = KIND_handle_out, .noun = NOUN_topology},
};
static int64_t call_hsp_topology_init(const value *v) {
  return (int64_t)hsp_topology_init(v[0].p, v[1].z, v[2].p, v[3].p);
}

static const argument of_hsp_topology_compute[] = {
  {"topology", "hsp_topology", .kind = KIND_handle, .noun = NOUN_topology},
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"limits", "hsp_topology_limits", .kind = KIND_sized, .size = sizeof(hsp_topology_limits), .null = NULL_always},
};
static int64_t call_hsp_topology_compute(const value *v) {
  return (int64_t)hsp_topology_compute(v[0].p, v[1].p, v[2].p);
}

static const argument of_hsp_topology_compute_with[] = {
  {"topology", "hsp_topology", .kind = KIND_handle, .noun = NOUN_topology},
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"request", "hsp_topology_request", .kind = KIND_sized_in, .size = sizeof(hsp_topology_request), .null = NULL_always,
      .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 2,
      .offset = offsetof(hsp_topology_request, executor), .is_const = 1},
  {"limits", "hsp_topology_limits", .kind = KIND_sized, .size = sizeof(hsp_topology_limits), .null = NULL_always},
};
static int64_t call_hsp_topology_compute_with(const value *v) {
  return (int64_t)hsp_topology_compute_with(v[0].p, v[1].p, v[2].p, v[4].p);
}

static const argument of_hsp_topology_get_counts[] = {
  {"topology", "hsp_topology", .kind = KIND_handle, .noun = NOUN_topology, .is_const = 1},
  {"counts", "hsp_topology_counts", .kind = KIND_struct_out, .size = sizeof(hsp_topology_counts)},
};
static int64_t call_hsp_topology_get_counts(const value *v) {
  return (int64_t)hsp_topology_get_counts(v[0].p, v[1].p);
}

static const argument of_hsp_topology_get_shells[] = {
  {"topology", "hsp_topology", .kind = KIND_handle, .noun = NOUN_topology, .is_const = 1},
  {"out", "hsp_shell", .kind = KIND_array_out, .size = sizeof(hsp_shell), .extent = "needed", .null = NULL_empty, .held
      = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_topology_get_shells(const value *v) {
  return (int64_t)hsp_topology_get_shells(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_topology_get_components[] = {
  {"topology", "hsp_topology", .kind = KIND_handle, .noun = NOUN_topology, .is_const = 1},
  {"out", "hsp_component", .kind = KIND_array_out, .size = sizeof(hsp_component), .extent = "needed", .null =
      NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_topology_get_components(const value *v) {
  return (int64_t)hsp_topology_get_components(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_topology_get_regions[] = {
  {"topology", "hsp_topology", .kind = KIND_handle, .noun = NOUN_topology, .is_const = 1},
  {"out", "hsp_region", .kind = KIND_array_out, .size = sizeof(hsp_region), .extent = "needed", .null = NULL_empty,
      .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_topology_get_regions(const value *v) {
  return (int64_t)hsp_topology_get_regions(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_topology_get_region_shells[] = {
  {"topology", "hsp_topology", .kind = KIND_handle, .noun = NOUN_topology, .is_const = 1},
  {"region", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"shells", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "needed", .null = NULL_empty, .held
      = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_topology_get_region_shells(const value *v) {
  return (int64_t)hsp_topology_get_region_shells(v[0].p, v[1].u, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_topology_get_region_balls[] = {
  {"topology", "hsp_topology", .kind = KIND_handle, .noun = NOUN_topology, .is_const = 1},
  {"region", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"balls", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "needed", .null = NULL_empty, .held
      = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_topology_get_region_balls(const value *v) {
  return (int64_t)hsp_topology_get_region_balls(v[0].p, v[1].u, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_topology_locate[] = {
  {"topology", "hsp_topology", .kind = KIND_handle, .noun = NOUN_topology, .is_const = 1},
  {"xyz", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "3", .is_const = 1},
  {"region", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_topology_locate(const value *v) {
  return (int64_t)hsp_topology_locate(v[0].p, v[1].p, v[2].p);
}

static const argument of_hsp_topology_onext[] = {
  {"topology", "hsp_topology", .kind = KIND_handle, .noun = NOUN_topology, .is_const = 1},
  {"q", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_topology_onext(const value *v) {
  return (int64_t)hsp_topology_onext(v[0].p, v[1].u);
}

static const argument of_hsp_topology_lnext[] = {
  {"topology", "hsp_topology", .kind = KIND_handle, .noun = NOUN_topology, .is_const = 1},
  {"q", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_topology_lnext(const value *v) {
  return (int64_t)hsp_topology_lnext(v[0].p, v[1].u);
}

static const argument of_hsp_topology_origin[] = {
  {"topology", "hsp_topology", .kind = KIND_handle, .noun = NOUN_topology, .is_const = 1},
  {"q", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_topology_origin(const value *v) {
  return (int64_t)hsp_topology_origin(v[0].p, v[1].u);
}

static const argument of_hsp_topology_left[] = {
  {"topology", "hsp_topology", .kind = KIND_handle, .noun = NOUN_topology, .is_const = 1},
  {"q", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_topology_left(const value *v) {
  return (int64_t)hsp_topology_left(v[0].p, v[1].u);
}

static const argument of_hsp_topology_get_quad_edges[] = {
  {"topology", "hsp_topology", .kind = KIND_handle, .noun = NOUN_topology, .is_const = 1},
  {"first", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"onext", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "count", .row = 4, .null =
      NULL_always},
  {"origin", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "count", .row = 4, .null =
      NULL_always},
};
static int64_t call_hsp_topology_get_quad_edges(const value *v) {
  return (int64_t)hsp_topology_get_quad_edges(v[0].p, v[1].u, v[2].u, v[3].p, v[4].p);
}

static const argument of_hsp_topology_get_vertices[] = {
  {"topology", "hsp_topology", .kind = KIND_handle, .noun = NOUN_topology, .is_const = 1},
  {"first", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"out", "hsp_topology_vertex", .kind = KIND_array_out, .size = sizeof(hsp_topology_vertex), .extent = "count", .null =
      NULL_empty},
};
static int64_t call_hsp_topology_get_vertices(const value *v) {
  return (int64_t)hsp_topology_get_vertices(v[0].p, v[1].u, v[2].u, v[3].p);
}

static const argument of_hsp_topology_get_edges[] = {
  {"topology", "hsp_topology", .kind = KIND_handle, .noun = NOUN_topology, .is_const = 1},
  {"first", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"out", "hsp_topology_edge", .kind = KIND_array_out, .size = sizeof(hsp_topology_edge), .extent = "count", .null =
      NULL_empty},
};
static int64_t call_hsp_topology_get_edges(const value *v) {
  return (int64_t)hsp_topology_get_edges(v[0].p, v[1].u, v[2].u, v[3].p);
}

static const argument of_hsp_topology_get_simple_faces[] = {
  {"topology", "hsp_topology", .kind = KIND_handle, .noun = NOUN_topology, .is_const = 1},
  {"first", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"out", "hsp_simple_face", .kind = KIND_array_out, .size = sizeof(hsp_simple_face), .extent = "count", .null =
      NULL_empty},
};
static int64_t call_hsp_topology_get_simple_faces(const value *v) {
  return (int64_t)hsp_topology_get_simple_faces(v[0].p, v[1].u, v[2].u, v[3].p);
}

static const argument of_hsp_topology_get_traversal[] = {
  {"topology", "hsp_topology", .kind = KIND_handle, .noun = NOUN_topology, .is_const = 1},
  {"shell", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"faces", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "needed", .null = NULL_empty, .held
      = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_topology_get_traversal(const value *v) {
  return (int64_t)hsp_topology_get_traversal(v[0].p, v[1].u, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_topology_check[] = {
  {"topology", "hsp_topology", .kind = KIND_handle, .noun = NOUN_topology},
  {"invariant", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
  {"id", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_topology_check(const value *v) {
  return (int64_t)hsp_topology_check(v[0].p, v[1].p, v[2].p);
}

static const argument of_hsp_cells_limits_init[] = {
  {"limits", "hsp_cells_limits", .kind = KIND_sized, .size = sizeof(hsp_cells_limits)},
  {"struct_size", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"balls", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_cells_limits_init(const value *v) {
  return (int64_t)hsp_cells_limits_init(v[0].p, v[1].u, v[2].u);
}

static const argument of_hsp_cells_bytes[] = {
  {"limits", "hsp_cells_limits", .kind = KIND_sized_in, .size = sizeof(hsp_cells_limits), .is_const = 1},
  {"bytes", "size_t", .kind = KIND_value_out, .size = sizeof(size_t)},
};
static int64_t call_hsp_cells_bytes(const value *v) {
  return (int64_t)hsp_cells_bytes(v[0].p, v[1].p);
}

static const argument of_hsp_cells_init[] = {
  {"memory", "void", .kind = KIND_memory},
  {"bytes", "size_t", .kind = KIND_value, .size = sizeof(size_t)},
  {"limits", "hsp_cells_limits", .kind = KIND_sized_in, .size = sizeof(hsp_cells_limits), .is_const = 1},
  {"cells", "hsp_cells", .kind = KIND_handle_out, .noun = NOUN_cells},
};
static int64_t call_hsp_cells_init(const value *v) {
  return (int64_t)hsp_cells_init(v[0].p, v[1].z, v[2].p, v[3].p);
}

static const argument of_hsp_cells_compute[] = {
  {"cells", "hsp_cells", .kind = KIND_handle, .noun = NOUN_cells},
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
  {"limits", "hsp_cells_limits", .kind = KIND_sized, .size = sizeof(hsp_cells_limits), .null = NULL_always},
};
static int64_t call_hsp_cells_compute(const value *v) {
  return (int64_t)hsp_cells_compute(v[0].p, v[1].p, v[2].p);
}

static const argument of_hsp_cells_compute_with[] = {
  {"cells", "hsp_cells", .kind = KIND_handle, .noun = NOUN_cells},
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
  {"request", "hsp_cells_request", .kind = KIND_sized_in, .size = sizeof(hsp_cells_request), .null = NULL_always,
      .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 2,
      .offset = offsetof(hsp_cells_request, executor), .is_const = 1},
  {"limits", "hsp_cells_limits", .kind = KIND_sized, .size = sizeof(hsp_cells_limits), .null = NULL_always},
};
static int64_t call_hsp_cells_compute_with(const value *v) {
  return (int64_t)hsp_cells_compute_with(v[0].p, v[1].p, v[2].p, v[4].p);
}

static const argument of_hsp_cells_get_counts[] = {
  {"cells", "hsp_cells", .kind = KIND_handle, .noun = NOUN_cells, .is_const = 1},
  {"counts", "hsp_cells_counts", .kind = KIND_struct_out, .size = sizeof(hsp_cells_counts)},
};
static int64_t call_hsp_cells_get_counts(const value *v) {
  return (int64_t)hsp_cells_get_counts(v[0].p, v[1].p);
}

static const argument of_hsp_cells_get_cells[] = {
  {"cells", "hsp_cells", .kind = KIND_handle, .noun = NOUN_cells, .is_const = 1},
  {"first", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"out", "hsp_free_cell", .kind = KIND_array_out, .size = sizeof(hsp_free_cell), .extent = "count", .null =
      NULL_empty},
};
static int64_t call_hsp_cells_get_cells(const value *v) {
  return (int64_t)hsp_cells_get_cells(v[0].p, v[1].u, v[2].u, v[3].p);
}

static const argument of_hsp_cells_get_neighbours[] = {
  {"cells", "hsp_cells", .kind = KIND_handle, .noun = NOUN_cells, .is_const = 1},
  {"cell", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"neighbours", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "needed", .null = NULL_empty,
      .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_cells_get_neighbours(const value *v) {
  return (int64_t)hsp_cells_get_neighbours(v[0].p, v[1].u, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_cells_get_pairs[] = {
  {"cells", "hsp_cells", .kind = KIND_handle, .noun = NOUN_cells, .is_const = 1},
  {"first", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"out", "hsp_cell_pair", .kind = KIND_array_out, .size = sizeof(hsp_cell_pair), .extent = "count", .null =
      NULL_empty},
};
static int64_t call_hsp_cells_get_pairs(const value *v) {
  return (int64_t)hsp_cells_get_pairs(v[0].p, v[1].u, v[2].u, v[3].p);
}

static const argument of_hsp_cells_locate[] = {
  {"cells", "hsp_cells", .kind = KIND_handle, .noun = NOUN_cells, .is_const = 1},
  {"xyz", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "3", .is_const = 1},
  {"cell", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_cells_locate(const value *v) {
  return (int64_t)hsp_cells_locate(v[0].p, v[1].p, v[2].p);
}

static const argument of_hsp_cells_check[] = {
  {"cells", "hsp_cells", .kind = KIND_handle, .noun = NOUN_cells},
  {"topology", "hsp_topology", .kind = KIND_handle, .noun = NOUN_topology, .null = NULL_always, .is_const = 1},
  {"invariant", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
  {"id", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_cells_check(const value *v) {
  return (int64_t)hsp_cells_check(v[0].p, v[1].p, v[2].p, v[3].p);
}

static const argument of_hsp_model_arrangement[] = {
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
  {"totals", "hsp_arrangement", .kind = KIND_struct_out, .size = sizeof(hsp_arrangement), .null = NULL_always},
  {"of_ball", "hsp_arrangement", .kind = KIND_array_out, .size = sizeof(hsp_arrangement), .extent = "n", .null =
      NULL_always},
  {"scratch", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "needed", .null = NULL_empty,
      .held = 1},
  {"words", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"words_needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_model_arrangement(const value *v) {
  return (int64_t)hsp_model_arrangement(v[0].p, v[1].p, v[2].p, v[3].p, v[4].u, v[5].p);
}

static const argument of_hsp_paths_limits_init[] = {
  {"limits", "hsp_paths_limits", .kind = KIND_sized, .size = sizeof(hsp_paths_limits)},
  {"struct_size", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"balls", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_paths_limits_init(const value *v) {
  return (int64_t)hsp_paths_limits_init(v[0].p, v[1].u, v[2].u);
}

static const argument of_hsp_paths_bytes[] = {
  {"limits", "hsp_paths_limits", .kind = KIND_sized_in, .size = sizeof(hsp_paths_limits), .is_const = 1},
  {"bytes", "size_t", .kind = KIND_value_out, .size = sizeof(size_t)},
};
static int64_t call_hsp_paths_bytes(const value *v) {
  return (int64_t)hsp_paths_bytes(v[0].p, v[1].p);
}

static const argument of_hsp_paths_init[] = {
  {"memory", "void", .kind = KIND_memory},
  {"bytes", "size_t", .kind = KIND_value, .size = sizeof(size_t)},
  {"limits", "hsp_paths_limits", .kind = KIND_sized_in, .size = sizeof(hsp_paths_limits), .is_const = 1},
  {"paths", "hsp_paths", .kind = KIND_handle_out, .noun = NOUN_paths},
};
static int64_t call_hsp_paths_init(const value *v) {
  return (int64_t)hsp_paths_init(v[0].p, v[1].z, v[2].p, v[3].p);
}

static const argument of_hsp_paths_compute[] = {
  {"paths", "hsp_paths", .kind = KIND_handle, .noun = NOUN_paths},
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
  {"limits", "hsp_paths_limits", .kind = KIND_sized, .size = sizeof(hsp_paths_limits), .null = NULL_always},
};
static int64_t call_hsp_paths_compute(const value *v) {
  return (int64_t)hsp_paths_compute(v[0].p, v[1].p, v[2].p);
}

static const argument of_hsp_paths_compute_with[] = {
  {"paths", "hsp_paths", .kind = KIND_handle, .noun = NOUN_paths},
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
  {"request", "hsp_paths_request", .kind = KIND_sized_in, .size = sizeof(hsp_paths_request), .null = NULL_always,
      .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 2,
      .offset = offsetof(hsp_paths_request, executor), .is_const = 1},
  {"limits", "hsp_paths_limits", .kind = KIND_sized, .size = sizeof(hsp_paths_limits), .null = NULL_always},
};
static int64_t call_hsp_paths_compute_with(const value *v) {
  return (int64_t)hsp_paths_compute_with(v[0].p, v[1].p, v[2].p, v[4].p);
}

static const argument of_hsp_paths_find[] = {
  {"paths", "hsp_paths", .kind = KIND_handle, .noun = NOUN_paths},
  {"from", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "3", .is_const = 1},
  {"to", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "3", .is_const = 1},
  {"path", "hsp_path", .kind = KIND_struct_out, .size = sizeof(hsp_path)},
  {"limits", "hsp_paths_limits", .kind = KIND_sized, .size = sizeof(hsp_paths_limits), .null = NULL_always},
};
static int64_t call_hsp_paths_find(const value *v) {
  return (int64_t)hsp_paths_find(v[0].p, v[1].p, v[2].p, v[3].p, v[4].p);
}

static const argument of_hsp_paths_find_with[] = {
  {"paths", "hsp_paths", .kind = KIND_handle, .noun = NOUN_paths},
  {"from", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "3", .is_const = 1},
  {"to", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "3", .is_const = 1},
  {"request", "hsp_paths_request", .kind = KIND_sized_in, .size = sizeof(hsp_paths_request), .null = NULL_always,
      .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 3,
      .offset = offsetof(hsp_paths_request, executor), .is_const = 1},
  {"path", "hsp_path", .kind = KIND_struct_out, .size = sizeof(hsp_path)},
  {"limits", "hsp_paths_limits", .kind = KIND_sized, .size = sizeof(hsp_paths_limits), .null = NULL_always},
};
static int64_t call_hsp_paths_find_with(const value *v) {
  return (int64_t)hsp_paths_find_with(v[0].p, v[1].p, v[2].p, v[3].p, v[5].p, v[6].p);
}

static const argument of_hsp_paths_get_points[] = {
  {"paths", "hsp_paths", .kind = KIND_handle, .noun = NOUN_paths, .is_const = 1},
  {"points", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "needed", .row = 3, .null = NULL_empty,
      .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_paths_get_points(const value *v) {
  return (int64_t)hsp_paths_get_points(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_pores_limits_init[] = {
  {"limits", "hsp_pores_limits", .kind = KIND_sized, .size = sizeof(hsp_pores_limits)},
  {"struct_size", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"balls", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_pores_limits_init(const value *v) {
  return (int64_t)hsp_pores_limits_init(v[0].p, v[1].u, v[2].u);
}

static const argument of_hsp_pores_bytes[] = {
  {"limits", "hsp_pores_limits", .kind = KIND_sized_in, .size = sizeof(hsp_pores_limits), .is_const = 1},
  {"bytes", "size_t", .kind = KIND_value_out, .size = sizeof(size_t)},
};
static int64_t call_hsp_pores_bytes(const value *v) {
  return (int64_t)hsp_pores_bytes(v[0].p, v[1].p);
}

static const argument of_hsp_pores_init[] = {
  {"memory", "void", .kind = KIND_memory},
  {"bytes", "size_t", .kind = KIND_value, .size = sizeof(size_t)},
  {"limits", "hsp_pores_limits", .kind = KIND_sized_in, .size = sizeof(hsp_pores_limits), .is_const = 1},
  {"pores", "hsp_pores", .kind = KIND_handle_out, .noun = NOUN_pores},
};
static int64_t call_hsp_pores_init(const value *v) {
  return (int64_t)hsp_pores_init(v[0].p, v[1].z, v[2].p, v[3].p);
}

static const argument of_hsp_pores_options_init[] = {
  {"options", "hsp_pores_options", .kind = KIND_sized, .size = sizeof(hsp_pores_options)},
  {"struct_size", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_pores_options_init(const value *v) {
  return (int64_t)hsp_pores_options_init(v[0].p, v[1].u);
}

static const argument of_hsp_pores_compute[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores},
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
  {"options", "hsp_pores_options", .kind = KIND_sized_in, .size = sizeof(hsp_pores_options), .null = NULL_always,
      .is_const = 1},
  {"limits", "hsp_pores_limits", .kind = KIND_sized, .size = sizeof(hsp_pores_limits), .null = NULL_always},
};
static int64_t call_hsp_pores_compute(const value *v) {
  return (int64_t)hsp_pores_compute(v[0].p, v[1].p, v[2].p, v[3].p);
}

static const argument of_hsp_pores_compute_periodic[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores},
  {"periodic", "hsp_periodic", .kind = KIND_handle, .noun = NOUN_periodic, .is_const = 1},
  {"options", "hsp_pores_options", .kind = KIND_sized_in, .size = sizeof(hsp_pores_options), .null = NULL_always,
      .is_const = 1},
  {"limits", "hsp_pores_limits", .kind = KIND_sized, .size = sizeof(hsp_pores_limits), .null = NULL_always},
};
static int64_t call_hsp_pores_compute_periodic(const value *v) {
  return (int64_t)hsp_pores_compute_periodic(v[0].p, v[1].p, v[2].p, v[3].p);
}

static const argument of_hsp_pores_get_counts[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores, .is_const = 1},
  {"counts", "hsp_pores_counts", .kind = KIND_struct_out, .size = sizeof(hsp_pores_counts)},
};
static int64_t call_hsp_pores_get_counts(const value *v) {
  return (int64_t)hsp_pores_get_counts(v[0].p, v[1].p);
}

static const argument of_hsp_pores_get_maxima[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores, .is_const = 1},
  {"first", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"out", "hsp_pore_maximum", .kind = KIND_array_out, .size = sizeof(hsp_pore_maximum), .extent = "count", .null =
      NULL_empty},
};
static int64_t call_hsp_pores_get_maxima(const value *v) {
  return (int64_t)hsp_pores_get_maxima(v[0].p, v[1].u, v[2].u, v[3].p);
}

static const argument of_hsp_pores_get_gates[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores, .is_const = 1},
  {"first", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"out", "hsp_pore_gate", .kind = KIND_array_out, .size = sizeof(hsp_pore_gate), .extent = "count", .null =
      NULL_empty},
};
static int64_t call_hsp_pores_get_gates(const value *v) {
  return (int64_t)hsp_pores_get_gates(v[0].p, v[1].u, v[2].u, v[3].p);
}

static const argument of_hsp_pores_get_gate_shifts[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores, .is_const = 1},
  {"first", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"out", "hsp_pore_gate_shifts", .kind = KIND_array_out, .size = sizeof(hsp_pore_gate_shifts), .extent = "count", .null
      = NULL_empty},
};
static int64_t call_hsp_pores_get_gate_shifts(const value *v) {
  return (int64_t)hsp_pores_get_gate_shifts(v[0].p, v[1].u, v[2].u, v[3].p);
}

static const argument of_hsp_pores_get_maximum_balls[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores, .is_const = 1},
  {"maximum", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"balls", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "needed", .null = NULL_empty, .held
      = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_pores_get_maximum_balls(const value *v) {
  return (int64_t)hsp_pores_get_maximum_balls(v[0].p, v[1].u, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_pores_get_gate_balls[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores, .is_const = 1},
  {"gate", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"balls", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "needed", .null = NULL_empty, .held
      = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_pores_get_gate_balls(const value *v) {
  return (int64_t)hsp_pores_get_gate_balls(v[0].p, v[1].u, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_pores_get_maximum_images[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores, .is_const = 1},
  {"maximum", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"images", "hsp_image", .kind = KIND_array_out, .size = sizeof(hsp_image), .extent = "needed", .null = NULL_empty,
      .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_pores_get_maximum_images(const value *v) {
  return (int64_t)hsp_pores_get_maximum_images(v[0].p, v[1].u, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_pores_get_gate_images[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores, .is_const = 1},
  {"gate", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"images", "hsp_image", .kind = KIND_array_out, .size = sizeof(hsp_image), .extent = "needed", .null = NULL_empty,
      .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_pores_get_gate_images(const value *v) {
  return (int64_t)hsp_pores_get_gate_images(v[0].p, v[1].u, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_pores_get_percolation[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores, .is_const = 1},
  {"percolation", "hsp_pore_percolation", .kind = KIND_struct_out, .size = sizeof(hsp_pore_percolation)},
};
static int64_t call_hsp_pores_get_percolation(const value *v) {
  return (int64_t)hsp_pores_get_percolation(v[0].p, v[1].p);
}

static const argument of_hsp_pores_get_channels[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores},
  {"radius", "double", .kind = KIND_value, .size = sizeof(double)},
  {"out", "hsp_pore_channel", .kind = KIND_array_out, .size = sizeof(hsp_pore_channel), .extent = "needed", .null =
      NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_pores_get_channels(const value *v) {
  return (int64_t)hsp_pores_get_channels(v[0].p, v[1].d, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_pores_class_at[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores, .is_const = 1},
  {"maximum", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"radius", "double", .kind = KIND_value, .size = sizeof(double)},
  {"member", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_pores_class_at(const value *v) {
  return (int64_t)hsp_pores_class_at(v[0].p, v[1].u, v[2].d, v[3].p);
}

static const argument of_hsp_pores_gate_between[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores, .is_const = 1},
  {"maximum", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"other", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"gate", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_pores_gate_between(const value *v) {
  return (int64_t)hsp_pores_gate_between(v[0].p, v[1].u, v[2].u, v[3].p);
}

static const argument of_hsp_pores_locate[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores, .is_const = 1},
  {"xyz", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "3", .is_const = 1},
  {"place", "hsp_pore_place", .kind = KIND_struct_out, .size = sizeof(hsp_pore_place)},
};
static int64_t call_hsp_pores_locate(const value *v) {
  return (int64_t)hsp_pores_locate(v[0].p, v[1].p, v[2].p);
}

static const argument of_hsp_pores_locate_with_shifts[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores, .is_const = 1},
  {"xyz", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "3", .is_const = 1},
  {"place", "hsp_pore_place", .kind = KIND_struct_out, .size = sizeof(hsp_pore_place)},
  {"shifts", "hsp_pore_place_shifts", .kind = KIND_struct_out, .size = sizeof(hsp_pore_place_shifts)},
};
static int64_t call_hsp_pores_locate_with_shifts(const value *v) {
  return (int64_t)hsp_pores_locate_with_shifts(v[0].p, v[1].p, v[2].p, v[3].p);
}

static const argument of_hsp_pores_widest[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores, .is_const = 1},
  {"from", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "3", .is_const = 1},
  {"to", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "3", .null = NULL_always, .is_const = 1},
  {"passage", "hsp_pore_passage", .kind = KIND_struct_out, .size = sizeof(hsp_pore_passage)},
};
static int64_t call_hsp_pores_widest(const value *v) {
  return (int64_t)hsp_pores_widest(v[0].p, v[1].p, v[2].p, v[3].p);
}

static const argument of_hsp_pores_find_tunnel[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores},
  {"from", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "3", .is_const = 1},
  {"to", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "3", .null = NULL_always, .is_const = 1},
  {"avoided", "uint32_t", .kind = KIND_array_in, .size = sizeof(uint32_t), .extent = "count", .null = NULL_empty,
      .is_const = 1},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"tunnel", "hsp_tunnel", .kind = KIND_struct_out, .size = sizeof(hsp_tunnel)},
  {"limits", "hsp_pores_limits", .kind = KIND_sized, .size = sizeof(hsp_pores_limits), .null = NULL_always},
};
static int64_t call_hsp_pores_find_tunnel(const value *v) {
  return (int64_t)hsp_pores_find_tunnel(v[0].p, v[1].p, v[2].p, v[3].p, v[4].u, v[5].p, v[6].p);
}

static const argument of_hsp_pores_find_cheapest_tunnel[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores},
  {"from", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "3", .is_const = 1},
  {"to", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "3", .null = NULL_always, .is_const = 1},
  {"avoided", "uint32_t", .kind = KIND_array_in, .size = sizeof(uint32_t), .extent = "count", .null = NULL_empty,
      .is_const = 1},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"tunnel", "hsp_tunnel", .kind = KIND_struct_out, .size = sizeof(hsp_tunnel)},
  {"limits", "hsp_pores_limits", .kind = KIND_sized, .size = sizeof(hsp_pores_limits), .null = NULL_always},
};
static int64_t call_hsp_pores_find_cheapest_tunnel(const value *v) {
  return (int64_t)hsp_pores_find_cheapest_tunnel(v[0].p, v[1].p, v[2].p, v[3].p, v[4].u, v[5].p, v[6].p);
}

static const argument of_hsp_pores_find_tunnel_with[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores},
  {"from", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "3", .is_const = 1},
  {"to", "double", .kind = KIND_array_in, .size = sizeof(double), .extent = "3", .null = NULL_always, .is_const = 1},
  {"avoided", "uint32_t", .kind = KIND_array_in, .size = sizeof(uint32_t), .extent = "count", .null = NULL_empty,
      .is_const = 1},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"request", "hsp_tunnel_request", .kind = KIND_sized_in, .size = sizeof(hsp_tunnel_request), .null = NULL_always,
      .is_const = 1},
  {"cheapest", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t), .of = 5, .offset = offsetof(hsp_tunnel_request,
      cheapest)},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 5,
      .offset = offsetof(hsp_tunnel_request, executor), .is_const = 1},
  {"tunnel", "hsp_tunnel", .kind = KIND_struct_out, .size = sizeof(hsp_tunnel)},
  {"limits", "hsp_pores_limits", .kind = KIND_sized, .size = sizeof(hsp_pores_limits), .null = NULL_always},
};
static int64_t call_hsp_pores_find_tunnel_with(const value *v) {
  return (int64_t)hsp_pores_find_tunnel_with(v[0].p, v[1].p, v[2].p, v[3].p, v[4].u, v[5].p, v[8].p, v[9].p);
}

static const argument of_hsp_pores_get_tunnel_route[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores, .is_const = 1},
  {"route", "hsp_tunnel_route", .kind = KIND_struct_out, .size = sizeof(hsp_tunnel_route)},
};
static int64_t call_hsp_pores_get_tunnel_route(const value *v) {
  return (int64_t)hsp_pores_get_tunnel_route(v[0].p, v[1].p);
}

static const argument of_hsp_pores_get_tunnel_points[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores, .is_const = 1},
  {"points", "hsp_tunnel_point", .kind = KIND_array_out, .size = sizeof(hsp_tunnel_point), .extent = "needed", .null =
      NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_pores_get_tunnel_points(const value *v) {
  return (int64_t)hsp_pores_get_tunnel_points(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_pores_get_tunnel_point_shifts[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores, .is_const = 1},
  {"points", "hsp_tunnel_point_shifts", .kind = KIND_array_out, .size = sizeof(hsp_tunnel_point_shifts), .extent =
      "needed", .null = NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_pores_get_tunnel_point_shifts(const value *v) {
  return (int64_t)hsp_pores_get_tunnel_point_shifts(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_pores_find_pockets[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores},
  {"narrow", "double", .kind = KIND_value, .size = sizeof(double)},
  {"wide", "double", .kind = KIND_value, .size = sizeof(double)},
  {"pockets", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_pores_find_pockets(const value *v) {
  return (int64_t)hsp_pores_find_pockets(v[0].p, v[1].d, v[2].d, v[3].p);
}

static const argument of_hsp_pores_get_pockets[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores, .is_const = 1},
  {"first", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"out", "hsp_pore_pocket", .kind = KIND_array_out, .size = sizeof(hsp_pore_pocket), .extent = "count", .null =
      NULL_empty},
};
static int64_t call_hsp_pores_get_pockets(const value *v) {
  return (int64_t)hsp_pores_get_pockets(v[0].p, v[1].u, v[2].u, v[3].p);
}

static const argument of_hsp_pores_get_pocket_maxima[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores, .is_const = 1},
  {"pocket", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"maxima", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "needed", .null = NULL_empty, .held
      = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_pores_get_pocket_maxima(const value *v) {
  return (int64_t)hsp_pores_get_pocket_maxima(v[0].p, v[1].u, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_pores_get_pocket_mouths[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores, .is_const = 1},
  {"pocket", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"gates", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "needed", .null = NULL_empty, .held
      = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_pores_get_pocket_mouths(const value *v) {
  return (int64_t)hsp_pores_get_pocket_mouths(v[0].p, v[1].u, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_pores_get_pocket_balls[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores, .is_const = 1},
  {"pocket", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"balls", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "needed", .null = NULL_empty, .held
      = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_pores_get_pocket_balls(const value *v) {
  return (int64_t)hsp_pores_get_pocket_balls(v[0].p, v[1].u, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_pores_get_plugged_balls[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores, .is_const = 1},
  {"xyz", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "needed", .row = 3, .null = NULL_always,
      .held = 1},
  {"radius", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "needed", .null = NULL_always, .held =
      1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_pores_get_plugged_balls(const value *v) {
  return (int64_t)hsp_pores_get_plugged_balls(v[0].p, v[1].p, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_pores_find_regions[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores},
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .null = NULL_box, .is_const = 1},
  {"access", "hsp_pore_access", .kind = KIND_struct_out, .size = sizeof(hsp_pore_access), .null = NULL_always},
  {"regions", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_pores_find_regions(const value *v) {
  return (int64_t)hsp_pores_find_regions(v[0].p, v[1].p, v[2].p, v[3].p);
}

static const argument of_hsp_pores_find_regions_with[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores},
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"request", "hsp_pores_request", .kind = KIND_sized_in, .size = sizeof(hsp_pores_request), .null = NULL_always,
      .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 2,
      .offset = offsetof(hsp_pores_request, executor), .is_const = 1},
  {"access", "hsp_pore_access", .kind = KIND_struct_out, .size = sizeof(hsp_pore_access), .null = NULL_always},
  {"regions", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_pores_find_regions_with(const value *v) {
  return (int64_t)hsp_pores_find_regions_with(v[0].p, v[1].p, v[2].p, v[4].p, v[5].p);
}

static const argument of_hsp_pores_get_regions[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores, .is_const = 1},
  {"first", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"out", "hsp_pore_region", .kind = KIND_array_out, .size = sizeof(hsp_pore_region), .extent = "count", .null =
      NULL_empty},
};
static int64_t call_hsp_pores_get_regions(const value *v) {
  return (int64_t)hsp_pores_get_regions(v[0].p, v[1].u, v[2].u, v[3].p);
}

static const argument of_hsp_pores_measure_pockets[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores},
  {"plugged", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores},
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .null = NULL_box, .is_const = 1},
  {"out", "hsp_pore_pocket_size", .kind = KIND_array_out, .size = sizeof(hsp_pore_pocket_size), .extent = "needed",
      .null = NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_pores_measure_pockets(const value *v) {
  return (int64_t)hsp_pores_measure_pockets(v[0].p, v[1].p, v[2].p, v[3].p, v[4].u, v[5].p);
}

static const argument of_hsp_pores_measure_pockets_with[] = {
  {"pores", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores},
  {"plugged", "hsp_pores", .kind = KIND_handle, .noun = NOUN_pores},
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .is_const = 1},
  {"request", "hsp_pores_request", .kind = KIND_sized_in, .size = sizeof(hsp_pores_request), .null = NULL_always,
      .is_const = 1},
  {"executor", "hsp_executor", .kind = KIND_sized_in, .size = sizeof(hsp_executor), .null = NULL_always, .of = 3,
      .offset = offsetof(hsp_pores_request, executor), .is_const = 1},
  {"out", "hsp_pore_pocket_size", .kind = KIND_array_out, .size = sizeof(hsp_pore_pocket_size), .extent = "needed",
      .null = NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_pores_measure_pockets_with(const value *v) {
  return (int64_t)hsp_pores_measure_pockets_with(v[0].p, v[1].p, v[2].p, v[3].p, v[5].p, v[6].u, v[7].p);
}

static const argument of_hsp_view_limits_init[] = {
  {"limits", "hsp_view_limits", .kind = KIND_sized, .size = sizeof(hsp_view_limits)},
  {"struct_size", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"balls", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_view_limits_init(const value *v) {
  return (int64_t)hsp_view_limits_init(v[0].p, v[1].u, v[2].u);
}

static const argument of_hsp_view_bytes[] = {
  {"limits", "hsp_view_limits", .kind = KIND_sized_in, .size = sizeof(hsp_view_limits), .is_const = 1},
  {"bytes", "size_t", .kind = KIND_value_out, .size = sizeof(size_t)},
};
static int64_t call_hsp_view_bytes(const value *v) {
  return (int64_t)hsp_view_bytes(v[0].p, v[1].p);
}

static const argument of_hsp_view_init[] = {
  {"memory", "void", .kind = KIND_memory},
  {"bytes", "size_t", .kind = KIND_value, .size = sizeof(size_t)},
  {"limits", "hsp_view_limits", .kind = KIND_sized_in, .size = sizeof(hsp_view_limits), .is_const = 1},
  {"view", "hsp_view", .kind = KIND_handle_out, .noun = NOUN_view},
};
static int64_t call_hsp_view_init(const value *v) {
  return (int64_t)hsp_view_init(v[0].p, v[1].z, v[2].p, v[3].p);
}

static const argument of_hsp_view_options_init[] = {
  {"options", "hsp_view_options", .kind = KIND_sized, .size = sizeof(hsp_view_options)},
  {"struct_size", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_view_options_init(const value *v) {
  return (int64_t)hsp_view_options_init(v[0].p, v[1].u);
}

static const argument of_hsp_view_options_turn[] = {
  {"options", "hsp_view_options", .kind = KIND_sized, .size = sizeof(hsp_view_options)},
  {"x", "double", .kind = KIND_value, .size = sizeof(double)},
  {"y", "double", .kind = KIND_value, .size = sizeof(double)},
  {"z", "double", .kind = KIND_value, .size = sizeof(double)},
};
static int64_t call_hsp_view_options_turn(const value *v) {
  return (int64_t)hsp_view_options_turn(v[0].p, v[1].d, v[2].d, v[3].d);
}

static const argument of_hsp_view_compute[] = {
  {"view", "hsp_view", .kind = KIND_handle, .noun = NOUN_view},
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
  {"boundary", "hsp_boundary", .kind = KIND_handle, .noun = NOUN_boundary, .null = NULL_always, .is_const = 1},
  {"options", "hsp_view_options", .kind = KIND_sized_in, .size = sizeof(hsp_view_options), .null = NULL_always,
      .is_const = 1},
  {"limits", "hsp_view_limits", .kind = KIND_sized, .size = sizeof(hsp_view_limits), .null = NULL_always},
};
static int64_t call_hsp_view_compute(const value *v) {
  return (int64_t)hsp_view_compute(v[0].p, v[1].p, v[2].p, v[3].p, v[4].p);
}

static const argument of_hsp_view_get_info[] = {
  {"view", "hsp_view", .kind = KIND_handle, .noun = NOUN_view, .is_const = 1},
  {"info", "hsp_view_info", .kind = KIND_struct_out, .size = sizeof(hsp_view_info)},
};
static int64_t call_hsp_view_get_info(const value *v) {
  return (int64_t)hsp_view_get_info(v[0].p, v[1].p);
}

static const argument of_hsp_view_get_pieces[] = {
  {"view", "hsp_view", .kind = KIND_handle, .noun = NOUN_view, .is_const = 1},
  {"out", "hsp_view_piece", .kind = KIND_array_out, .size = sizeof(hsp_view_piece), .extent = "needed", .null =
      NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_view_get_pieces(const value *v) {
  return (int64_t)hsp_view_get_pieces(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_view_get_loops[] = {
  {"view", "hsp_view", .kind = KIND_handle, .noun = NOUN_view, .is_const = 1},
  {"out", "hsp_view_loop", .kind = KIND_array_out, .size = sizeof(hsp_view_loop), .extent = "needed", .null =
      NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_view_get_loops(const value *v) {
  return (int64_t)hsp_view_get_loops(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_view_get_arcs[] = {
  {"view", "hsp_view", .kind = KIND_handle, .noun = NOUN_view, .is_const = 1},
  {"out", "hsp_view_arc", .kind = KIND_array_out, .size = sizeof(hsp_view_arc), .extent = "needed", .null = NULL_empty,
      .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_view_get_arcs(const value *v) {
  return (int64_t)hsp_view_get_arcs(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_map_limits_init[] = {
  {"limits", "hsp_map_limits", .kind = KIND_sized, .size = sizeof(hsp_map_limits)},
  {"struct_size", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"balls", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_map_limits_init(const value *v) {
  return (int64_t)hsp_map_limits_init(v[0].p, v[1].u, v[2].u);
}

static const argument of_hsp_map_bytes[] = {
  {"limits", "hsp_map_limits", .kind = KIND_sized_in, .size = sizeof(hsp_map_limits), .is_const = 1},
  {"bytes", "size_t", .kind = KIND_value_out, .size = sizeof(size_t)},
};
static int64_t call_hsp_map_bytes(const value *v) {
  return (int64_t)hsp_map_bytes(v[0].p, v[1].p);
}

static const argument of_hsp_map_init[] = {
  {"memory", "void", .kind = KIND_memory},
  {"bytes", "size_t", .kind = KIND_value, .size = sizeof(size_t)},
  {"limits", "hsp_map_limits", .kind = KIND_sized_in, .size = sizeof(hsp_map_limits), .is_const = 1},
  {"map", "hsp_map", .kind = KIND_handle_out, .noun = NOUN_map},
};
static int64_t call_hsp_map_init(const value *v) {
  return (int64_t)hsp_map_init(v[0].p, v[1].z, v[2].p, v[3].p);
}

static const argument of_hsp_map_compute[] = {
  {"map", "hsp_map", .kind = KIND_handle, .noun = NOUN_map},
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
  {"options", "hsp_view_options", .kind = KIND_sized_in, .size = sizeof(hsp_view_options), .null = NULL_always,
      .is_const = 1},
  {"limits", "hsp_map_limits", .kind = KIND_sized, .size = sizeof(hsp_map_limits), .null = NULL_always},
};
static int64_t call_hsp_map_compute(const value *v) {
  return (int64_t)hsp_map_compute(v[0].p, v[1].p, v[2].p, v[3].p);
}

static const argument of_hsp_map_get_info[] = {
  {"map", "hsp_map", .kind = KIND_handle, .noun = NOUN_map, .is_const = 1},
  {"info", "hsp_map_info", .kind = KIND_struct_out, .size = sizeof(hsp_map_info)},
};
static int64_t call_hsp_map_get_info(const value *v) {
  return (int64_t)hsp_map_get_info(v[0].p, v[1].p);
}

static const argument of_hsp_map_next[] = {
  {"map", "hsp_map", .kind = KIND_handle, .noun = NOUN_map, .is_const = 1},
  {"h", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_map_next(const value *v) {
  return (int64_t)hsp_map_next(v[0].p, v[1].u);
}

static const argument of_hsp_map_previous[] = {
  {"map", "hsp_map", .kind = KIND_handle, .noun = NOUN_map, .is_const = 1},
  {"h", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_map_previous(const value *v) {
  return (int64_t)hsp_map_previous(v[0].p, v[1].u);
}

static const argument of_hsp_map_next_loop[] = {
  {"map", "hsp_map", .kind = KIND_handle, .noun = NOUN_map, .is_const = 1},
  {"h", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_map_next_loop(const value *v) {
  return (int64_t)hsp_map_next_loop(v[0].p, v[1].u);
}

static const argument of_hsp_map_origin[] = {
  {"map", "hsp_map", .kind = KIND_handle, .noun = NOUN_map, .is_const = 1},
  {"h", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_map_origin(const value *v) {
  return (int64_t)hsp_map_origin(v[0].p, v[1].u);
}

static const argument of_hsp_map_left[] = {
  {"map", "hsp_map", .kind = KIND_handle, .noun = NOUN_map, .is_const = 1},
  {"h", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_map_left(const value *v) {
  return (int64_t)hsp_map_left(v[0].p, v[1].u);
}

static const argument of_hsp_map_get_vertices[] = {
  {"map", "hsp_map", .kind = KIND_handle, .noun = NOUN_map, .is_const = 1},
  {"first", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"out", "hsp_map_vertex", .kind = KIND_array_out, .size = sizeof(hsp_map_vertex), .extent = "count", .null =
      NULL_empty},
};
static int64_t call_hsp_map_get_vertices(const value *v) {
  return (int64_t)hsp_map_get_vertices(v[0].p, v[1].u, v[2].u, v[3].p);
}

static const argument of_hsp_map_get_edges[] = {
  {"map", "hsp_map", .kind = KIND_handle, .noun = NOUN_map, .is_const = 1},
  {"first", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"out", "hsp_map_edge", .kind = KIND_array_out, .size = sizeof(hsp_map_edge), .extent = "count", .null = NULL_empty},
};
static int64_t call_hsp_map_get_edges(const value *v) {
  return (int64_t)hsp_map_get_edges(v[0].p, v[1].u, v[2].u, v[3].p);
}

static const argument of_hsp_map_get_faces[] = {
  {"map", "hsp_map", .kind = KIND_handle, .noun = NOUN_map, .is_const = 1},
  {"first", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"out", "hsp_map_face", .kind = KIND_array_out, .size = sizeof(hsp_map_face), .extent = "count", .null = NULL_empty},
};
static int64_t call_hsp_map_get_faces(const value *v) {
  return (int64_t)hsp_map_get_faces(v[0].p, v[1].u, v[2].u, v[3].p);
}

static const argument of_hsp_map_get_areas[] = {
  {"map", "hsp_map", .kind = KIND_handle, .noun = NOUN_map, .is_const = 1},
  {"area", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "needed", .null = NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_map_get_areas(const value *v) {
  return (int64_t)hsp_map_get_areas(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_map_get_outline[] = {
  {"map", "hsp_map", .kind = KIND_handle, .noun = NOUN_map, .is_const = 1},
  {"ball", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"h", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "needed", .null = NULL_empty, .held =
      1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_map_get_outline(const value *v) {
  return (int64_t)hsp_map_get_outline(v[0].p, v[1].u, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_map_pick[] = {
  {"map", "hsp_map", .kind = KIND_handle, .noun = NOUN_map, .is_const = 1},
  {"x", "double", .kind = KIND_value, .size = sizeof(double)},
  {"y", "double", .kind = KIND_value, .size = sizeof(double)},
  {"sight", "hsp_map_sight", .kind = KIND_struct_out, .size = sizeof(hsp_map_sight)},
};
static int64_t call_hsp_map_pick(const value *v) {
  return (int64_t)hsp_map_pick(v[0].p, v[1].d, v[2].d, v[3].p);
}

static const argument of_hsp_map_get_point[] = {
  {"map", "hsp_map", .kind = KIND_handle, .noun = NOUN_map, .is_const = 1},
  {"edge", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"t", "double", .kind = KIND_value, .size = sizeof(double)},
  {"point", "hsp_map_point", .kind = KIND_struct_out, .size = sizeof(hsp_map_point)},
};
static int64_t call_hsp_map_get_point(const value *v) {
  return (int64_t)hsp_map_get_point(v[0].p, v[1].u, v[2].d, v[3].p);
}

static const argument of_hsp_map_get_pole[] = {
  {"map", "hsp_map", .kind = KIND_handle, .noun = NOUN_map, .is_const = 1},
  {"face", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"pole", "hsp_map_pole", .kind = KIND_struct_out, .size = sizeof(hsp_map_pole)},
};
static int64_t call_hsp_map_get_pole(const value *v) {
  return (int64_t)hsp_map_get_pole(v[0].p, v[1].u, v[2].p);
}

static const argument of_hsp_map_check[] = {
  {"map", "hsp_map", .kind = KIND_handle, .noun = NOUN_map},
  {"invariant", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
  {"id", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_map_check(const value *v) {
  return (int64_t)hsp_map_check(v[0].p, v[1].p, v[2].p);
}

static const argument of_hsp_sticks_limits_init[] = {
  {"limits", "hsp_sticks_limits", .kind = KIND_sized, .size = sizeof(hsp_sticks_limits)},
  {"struct_size", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"balls", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_sticks_limits_init(const value *v) {
  return (int64_t)hsp_sticks_limits_init(v[0].p, v[1].u, v[2].u);
}

static const argument of_hsp_sticks_bytes[] = {
  {"limits", "hsp_sticks_limits", .kind = KIND_sized_in, .size = sizeof(hsp_sticks_limits), .is_const = 1},
  {"bytes", "size_t", .kind = KIND_value_out, .size = sizeof(size_t)},
};
static int64_t call_hsp_sticks_bytes(const value *v) {
  return (int64_t)hsp_sticks_bytes(v[0].p, v[1].p);
}

static const argument of_hsp_sticks_init[] = {
  {"memory", "void", .kind = KIND_memory},
  {"bytes", "size_t", .kind = KIND_value, .size = sizeof(size_t)},
  {"limits", "hsp_sticks_limits", .kind = KIND_sized_in, .size = sizeof(hsp_sticks_limits), .is_const = 1},
  {"sticks", "hsp_sticks", .kind = KIND_handle_out, .noun = NOUN_sticks},
};
static int64_t call_hsp_sticks_init(const value *v) {
  return (int64_t)hsp_sticks_init(v[0].p, v[1].z, v[2].p, v[3].p);
}

static const argument of_hsp_sticks_compute[] = {
  {"sticks", "hsp_sticks", .kind = KIND_handle, .noun = NOUN_sticks},
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
  {"options", "hsp_view_options", .kind = KIND_sized_in, .size = sizeof(hsp_view_options), .null = NULL_always,
      .is_const = 1},
  {"stick", "hsp_stick", .kind = KIND_array_in, .size = sizeof(hsp_stick), .extent = "count", .null = NULL_empty,
      .is_const = 1},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"radius", "double", .kind = KIND_value, .size = sizeof(double)},
  {"conflict", "hsp_sticks_conflict", .kind = KIND_struct_out, .size = sizeof(hsp_sticks_conflict), .null =
      NULL_always},
  {"limits", "hsp_sticks_limits", .kind = KIND_sized, .size = sizeof(hsp_sticks_limits), .null = NULL_always},
};
static int64_t call_hsp_sticks_compute(const value *v) {
  return (int64_t)hsp_sticks_compute(v[0].p, v[1].p, v[2].p, v[3].p, v[4].u, v[5].d, v[6].p, v[7].p);
}

static const argument of_hsp_sticks_compute_map[] = {
  {"sticks", "hsp_sticks", .kind = KIND_handle, .noun = NOUN_sticks},
  {"model", "hsp_model", .kind = KIND_handle, .noun = NOUN_model, .is_const = 1},
  {"options", "hsp_view_options", .kind = KIND_sized_in, .size = sizeof(hsp_view_options), .null = NULL_always,
      .is_const = 1},
  {"stick", "hsp_stick", .kind = KIND_array_in, .size = sizeof(hsp_stick), .extent = "count", .null = NULL_empty,
      .is_const = 1},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"radius", "double", .kind = KIND_value, .size = sizeof(double)},
  {"conflict", "hsp_sticks_conflict", .kind = KIND_struct_out, .size = sizeof(hsp_sticks_conflict), .null =
      NULL_always},
  {"limits", "hsp_sticks_limits", .kind = KIND_sized, .size = sizeof(hsp_sticks_limits), .null = NULL_always},
};
static int64_t call_hsp_sticks_compute_map(const value *v) {
  return (int64_t)hsp_sticks_compute_map(v[0].p, v[1].p, v[2].p, v[3].p, v[4].u, v[5].d, v[6].p, v[7].p);
}

static const argument of_hsp_sticks_get_info[] = {
  {"sticks", "hsp_sticks", .kind = KIND_handle, .noun = NOUN_sticks, .is_const = 1},
  {"info", "hsp_sticks_info", .kind = KIND_struct_out, .size = sizeof(hsp_sticks_info)},
};
static int64_t call_hsp_sticks_get_info(const value *v) {
  return (int64_t)hsp_sticks_get_info(v[0].p, v[1].p);
}

static const argument of_hsp_sticks_get_map_info[] = {
  {"sticks", "hsp_sticks", .kind = KIND_handle, .noun = NOUN_sticks, .is_const = 1},
  {"info", "hsp_map_info", .kind = KIND_struct_out, .size = sizeof(hsp_map_info)},
};
static int64_t call_hsp_sticks_get_map_info(const value *v) {
  return (int64_t)hsp_sticks_get_map_info(v[0].p, v[1].p);
}

static const argument of_hsp_sticks_get_vertices[] = {
  {"sticks", "hsp_sticks", .kind = KIND_handle, .noun = NOUN_sticks, .is_const = 1},
  {"first", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"out", "hsp_map_vertex", .kind = KIND_array_out, .size = sizeof(hsp_map_vertex), .extent = "count", .null =
      NULL_empty},
};
static int64_t call_hsp_sticks_get_vertices(const value *v) {
  return (int64_t)hsp_sticks_get_vertices(v[0].p, v[1].u, v[2].u, v[3].p);
}

static const argument of_hsp_sticks_get_edges[] = {
  {"sticks", "hsp_sticks", .kind = KIND_handle, .noun = NOUN_sticks, .is_const = 1},
  {"first", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"out", "hsp_map_edge", .kind = KIND_array_out, .size = sizeof(hsp_map_edge), .extent = "count", .null = NULL_empty},
};
static int64_t call_hsp_sticks_get_edges(const value *v) {
  return (int64_t)hsp_sticks_get_edges(v[0].p, v[1].u, v[2].u, v[3].p);
}

static const argument of_hsp_sticks_get_faces[] = {
  {"sticks", "hsp_sticks", .kind = KIND_handle, .noun = NOUN_sticks, .is_const = 1},
  {"first", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"count", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"out", "hsp_map_face", .kind = KIND_array_out, .size = sizeof(hsp_map_face), .extent = "count", .null = NULL_empty},
};
static int64_t call_hsp_sticks_get_faces(const value *v) {
  return (int64_t)hsp_sticks_get_faces(v[0].p, v[1].u, v[2].u, v[3].p);
}

static const argument of_hsp_sticks_get_areas[] = {
  {"sticks", "hsp_sticks", .kind = KIND_handle, .noun = NOUN_sticks, .is_const = 1},
  {"area", "double", .kind = KIND_array_out, .size = sizeof(double), .extent = "needed", .null = NULL_empty, .held = 1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_sticks_get_areas(const value *v) {
  return (int64_t)hsp_sticks_get_areas(v[0].p, v[1].p, v[2].u, v[3].p);
}

static const argument of_hsp_sticks_pick[] = {
  {"sticks", "hsp_sticks", .kind = KIND_handle, .noun = NOUN_sticks, .is_const = 1},
  {"x", "double", .kind = KIND_value, .size = sizeof(double)},
  {"y", "double", .kind = KIND_value, .size = sizeof(double)},
  {"sight", "hsp_map_sight", .kind = KIND_struct_out, .size = sizeof(hsp_map_sight)},
};
static int64_t call_hsp_sticks_pick(const value *v) {
  return (int64_t)hsp_sticks_pick(v[0].p, v[1].d, v[2].d, v[3].p);
}

static const argument of_hsp_sticks_get_outline[] = {
  {"sticks", "hsp_sticks", .kind = KIND_handle, .noun = NOUN_sticks, .is_const = 1},
  {"ball", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"h", "uint32_t", .kind = KIND_array_out, .size = sizeof(uint32_t), .extent = "needed", .null = NULL_empty, .held =
      1},
  {"capacity", "uint32_t", .kind = KIND_capacity, .size = sizeof(uint32_t)},
  {"needed", "uint32_t", .kind = KIND_needed, .size = sizeof(uint32_t), .null = NULL_always},
};
static int64_t call_hsp_sticks_get_outline(const value *v) {
  return (int64_t)hsp_sticks_get_outline(v[0].p, v[1].u, v[2].p, v[3].u, v[4].p);
}

static const argument of_hsp_sticks_get_point[] = {
  {"sticks", "hsp_sticks", .kind = KIND_handle, .noun = NOUN_sticks, .is_const = 1},
  {"edge", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"t", "double", .kind = KIND_value, .size = sizeof(double)},
  {"point", "hsp_map_point", .kind = KIND_struct_out, .size = sizeof(hsp_map_point)},
};
static int64_t call_hsp_sticks_get_point(const value *v) {
  return (int64_t)hsp_sticks_get_point(v[0].p, v[1].u, v[2].d, v[3].p);
}

static const argument of_hsp_sticks_get_pole[] = {
  {"sticks", "hsp_sticks", .kind = KIND_handle, .noun = NOUN_sticks, .is_const = 1},
  {"face", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"pole", "hsp_map_pole", .kind = KIND_struct_out, .size = sizeof(hsp_map_pole)},
};
static int64_t call_hsp_sticks_get_pole(const value *v) {
  return (int64_t)hsp_sticks_get_pole(v[0].p, v[1].u, v[2].p);
}

static const argument of_hsp_sticks_check[] = {
  {"sticks", "hsp_sticks", .kind = KIND_handle, .noun = NOUN_sticks},
  {"invariant", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
  {"id", "uint32_t", .kind = KIND_value_out, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_sticks_check(const value *v) {
  return (int64_t)hsp_sticks_check(v[0].p, v[1].p, v[2].p);
}

static const argument of_hsp_picture_ink_width[] = {
  {"full_width", "double", .kind = KIND_value, .size = sizeof(double)},
  {"gap", "double", .kind = KIND_value, .size = sizeof(double)},
  {"width", "double", .kind = KIND_value_out, .size = sizeof(double)},
};
static int64_t call_hsp_picture_ink_width(const value *v) {
  return (int64_t)hsp_picture_ink_width(v[0].d, v[1].d, v[2].p);
}

static const argument of_hsp_picture_fog_share[] = {
  {"nearest", "double", .kind = KIND_value, .size = sizeof(double)},
  {"farthest", "double", .kind = KIND_value, .size = sizeof(double)},
  {"mean_radius", "double", .kind = KIND_value, .size = sizeof(double)},
  {"depth", "double", .kind = KIND_value, .size = sizeof(double)},
  {"share", "double", .kind = KIND_value_out, .size = sizeof(double)},
};
static int64_t call_hsp_picture_fog_share(const value *v) {
  return (int64_t)hsp_picture_fog_share(v[0].d, v[1].d, v[2].d, v[3].d, v[4].p);
}

static const argument of_hsp_picture_options_init[] = {
  {"options", "hsp_picture_options", .kind = KIND_sized, .size = sizeof(hsp_picture_options)},
  {"struct_size", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_picture_options_init(const value *v) {
  return (int64_t)hsp_picture_options_init(v[0].p, v[1].u);
}

static const argument of_hsp_palette_colour[] = {
  {"palette", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"atomic_number", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
  {"chain", "uint32_t", .kind = KIND_value, .size = sizeof(uint32_t)},
};
static int64_t call_hsp_palette_colour(const value *v) {
  return (int64_t)hsp_palette_colour(v[0].u, v[1].u, v[2].u);
}

static const argument of_hsp_picture_write[] = {
  {"view", "hsp_view", .kind = KIND_handle, .noun = NOUN_view},
  {"colour", "uint32_t", .kind = KIND_array_in, .size = sizeof(uint32_t), .extent = "n", .null = NULL_always, .is_const
      = 1},
  {"options", "hsp_picture_options", .kind = KIND_sized_in, .size = sizeof(hsp_picture_options), .null = NULL_always,
      .is_const = 1},
  {"title", "char", .kind = KIND_string, .null = NULL_always, .is_const = 1},
  {"description", "char", .kind = KIND_string, .null = NULL_always, .is_const = 1},
  {"sink", "hsp_sink", .kind = KIND_callback},
  {"context", "void", .kind = KIND_context, .null = NULL_always},
  {"bytes", "uint64_t", .kind = KIND_value_out, .size = sizeof(uint64_t), .null = NULL_always},
};
static int64_t call_hsp_picture_write(const value *v) {
  return (int64_t)hsp_picture_write(v[0].p, v[1].p, v[2].p, v[3].p, v[4].p, v[5].f, v[6].p, v[7].p);
}

static const argument of_hsp_picture_write_map[] = {
  {"map", "hsp_map", .kind = KIND_handle, .noun = NOUN_map},
  {"colour", "uint32_t", .kind = KIND_array_in, .size = sizeof(uint32_t), .extent = "n", .null = NULL_always, .is_const
      = 1},
  {"options", "hsp_picture_options", .kind = KIND_sized_in, .size = sizeof(hsp_picture_options), .null = NULL_always,
      .is_const = 1},
  {"title", "char", .kind = KIND_string, .null = NULL_always, .is_const = 1},
  {"description", "char", .kind = KIND_string, .null = NULL_always, .is_const = 1},
  {"sink", "hsp_sink", .kind = KIND_callback},
  {"context", "void", .kind = KIND_context, .null = NULL_always},
  {"bytes", "uint64_t", .kind = KIND_value_out, .size = sizeof(uint64_t), .null = NULL_always},
};
static int64_t call_hsp_picture_write_map(const value *v) {
  return (int64_t)hsp_picture_write_map(v[0].p, v[1].p, v[2].p, v[3].p, v[4].p, v[5].f, v[6].p, v[7].p);
}

static const argument of_hsp_picture_write_sticks[] = {
  {"sticks", "hsp_sticks", .kind = KIND_handle, .noun = NOUN_sticks},
  {"colour", "uint32_t", .kind = KIND_array_in, .size = sizeof(uint32_t), .extent = "n", .null = NULL_always, .is_const
      = 1},
  {"options", "hsp_picture_options", .kind = KIND_sized_in, .size = sizeof(hsp_picture_options), .null = NULL_always,
      .is_const = 1},
  {"title", "char", .kind = KIND_string, .null = NULL_always, .is_const = 1},
  {"description", "char", .kind = KIND_string, .null = NULL_always, .is_const = 1},
  {"sink", "hsp_sink", .kind = KIND_callback},
  {"context", "void", .kind = KIND_context, .null = NULL_always},
  {"bytes", "uint64_t", .kind = KIND_value_out, .size = sizeof(uint64_t), .null = NULL_always},
};
static int64_t call_hsp_picture_write_sticks(const value *v) {
  return (int64_t)hsp_picture_write_sticks(v[0].p, v[1].p, v[2].p, v[3].p, v[4].p, v[5].f, v[6].p, v[7].p);
}

const function registry[] = {
  {"hsp_version", "version", RESULT_number, 0, NULL, call_hsp_version, 0},
  {"hsp_abi", "version", RESULT_number, 0, NULL, call_hsp_abi, 0},
  {"hsp_provisional", "version", RESULT_number, 0, NULL, call_hsp_provisional, 0},
  {"hsp_numerics", "version", RESULT_number, 0, NULL, call_hsp_numerics, 0},
  {"hsp_provisional_numerics", "version", RESULT_number, 0, NULL, call_hsp_provisional_numerics, 0},
  {"hsp_status_text", "status", RESULT_text, 1, of_hsp_status_text, call_hsp_status_text, 0},
  {"hsp_element_radius", "element", RESULT_status, 4, of_hsp_element_radius, call_hsp_element_radius, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_ID)},
  {"hsp_element_number", "element", RESULT_status, 2, of_hsp_element_number, call_hsp_element_number, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_ID)},
  {"hsp_element_symbol", "element", RESULT_text, 1, of_hsp_element_symbol, call_hsp_element_symbol, 0},
  {"hsp_residue_radius", "residue", RESULT_status, 4, of_hsp_residue_radius, call_hsp_residue_radius, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_ID)},
  {"hsp_residue_get_atoms", "residue", RESULT_status, 4, of_hsp_residue_get_atoms, call_hsp_residue_get_atoms,
      BIT(HSP_OK) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY)},
  {"hsp_model_max_balls", "model", RESULT_number, 0, NULL, call_hsp_model_max_balls, 0},
  {"hsp_model_bytes", "model", RESULT_status, 2, of_hsp_model_bytes, call_hsp_model_bytes, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_RANGE)},
  {"hsp_model_init", "model", RESULT_status, 4, of_hsp_model_init, call_hsp_model_init, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_MEMORY) | BIT(HSP_E_RANGE)},
  {"hsp_model_options_init", "model", RESULT_status, 2, of_hsp_model_options_init, call_hsp_model_options_init,
      BIT(HSP_OK) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION)},
  {"hsp_model_set", "model", RESULT_status, 6, of_hsp_model_set, call_hsp_model_set, BIT(HSP_OK) | BIT(HSP_E_HANDLE) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_NEGATIVE) |
      BIT(HSP_E_RANGE)},
  {"hsp_model_set_with", "model", RESULT_status, 8, of_hsp_model_set_with, call_hsp_model_set_with, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_NOT_FINITE) |
      BIT(HSP_E_NEGATIVE) | BIT(HSP_E_RANGE) | BIT(HSP_E_STOPPED)},
  {"hsp_model_get_info", "model", RESULT_status, 2, of_hsp_model_get_info, call_hsp_model_get_info, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT)},
  {"hsp_model_get_balls", "model", RESULT_status, 5, of_hsp_model_get_balls, call_hsp_model_get_balls, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_model_get_packing", "model", RESULT_status, 2, of_hsp_model_get_packing, call_hsp_model_get_packing, BIT(HSP_OK)
      | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE)},
  {"hsp_query_point", "query", RESULT_status, 5, of_hsp_query_point, call_hsp_query_point, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) |
      BIT(HSP_E_RANGE)},
  {"hsp_query_ball", "query", RESULT_status, 6, of_hsp_query_ball, call_hsp_query_ball, BIT(HSP_OK) | BIT(HSP_E_HANDLE)
      | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_NEGATIVE) |
      BIT(HSP_E_RANGE)},
  {"hsp_query_meets", "query", RESULT_status, 4, of_hsp_query_meets, call_hsp_query_meets, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_NEGATIVE) |
      BIT(HSP_E_RANGE)},
  {"hsp_query_neighbours", "query", RESULT_status, 5, of_hsp_query_neighbours, call_hsp_query_neighbours, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_query_pairs", "query", RESULT_status, 6, of_hsp_query_pairs, call_hsp_query_pairs, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_RANGE)},
  {"hsp_query_pairs_with", "query", RESULT_status, 8, of_hsp_query_pairs_with, call_hsp_query_pairs_with, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) |
      BIT(HSP_E_RANGE) | BIT(HSP_E_STOPPED)},
  {"hsp_query_ray", "query", RESULT_status, 4, of_hsp_query_ray, call_hsp_query_ray, BIT(HSP_OK) | BIT(HSP_E_HANDLE) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE)},
  {"hsp_body_bytes", "pose", RESULT_status, 2, of_hsp_body_bytes, call_hsp_body_bytes, BIT(HSP_OK) | BIT(HSP_E_ARGUMENT)
      | BIT(HSP_E_RANGE)},
  {"hsp_body_init", "pose", RESULT_status, 4, of_hsp_body_init, call_hsp_body_init, BIT(HSP_OK) | BIT(HSP_E_ARGUMENT) |
      BIT(HSP_E_MEMORY) | BIT(HSP_E_RANGE)},
  {"hsp_body_set", "pose", RESULT_status, 2, of_hsp_body_set, call_hsp_body_set, BIT(HSP_OK) | BIT(HSP_E_HANDLE) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_body_set_with", "pose", RESULT_status, 4, of_hsp_body_set_with, call_hsp_body_set_with, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) |
      BIT(HSP_E_STOPPED)},
  {"hsp_pose_from_matrix", "pose", RESULT_status, 3, of_hsp_pose_from_matrix, call_hsp_pose_from_matrix, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE)},
  {"hsp_body_hits", "pose", RESULT_status, 6, of_hsp_body_hits, call_hsp_body_hits, BIT(HSP_OK) | BIT(HSP_E_HANDLE) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE)},
  {"hsp_body_hits_along", "pose", RESULT_status, 7, of_hsp_body_hits_along, call_hsp_body_hits_along, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE)},
  {"hsp_body_gaps", "pose", RESULT_status, 6, of_hsp_body_gaps, call_hsp_body_gaps, BIT(HSP_OK) | BIT(HSP_E_HANDLE) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE)},
  {"hsp_body_overlaps", "pose", RESULT_status, 6, of_hsp_body_overlaps, call_hsp_body_overlaps, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE)},
  {"hsp_body_pairs", "pose", RESULT_status, 6, of_hsp_body_pairs, call_hsp_body_pairs, BIT(HSP_OK) | BIT(HSP_E_HANDLE) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE)},
  {"hsp_body_rational_hits", "pose", RESULT_status, 6, of_hsp_body_rational_hits, call_hsp_body_rational_hits,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) |
      BIT(HSP_E_RANGE)},
  {"hsp_body_rational_hits_along", "pose", RESULT_status, 7, of_hsp_body_rational_hits_along,
      call_hsp_body_rational_hits_along, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) |
      BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE)},
  {"hsp_body_rational_gaps", "pose", RESULT_status, 6, of_hsp_body_rational_gaps, call_hsp_body_rational_gaps,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) |
      BIT(HSP_E_RANGE)},
  {"hsp_body_rational_pairs", "pose", RESULT_status, 6, of_hsp_body_rational_pairs, call_hsp_body_rational_pairs,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) |
      BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE)},
  {"hsp_boundary_limits_init", "boundary", RESULT_status, 3, of_hsp_boundary_limits_init, call_hsp_boundary_limits_init,
      BIT(HSP_OK) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_RANGE)},
  {"hsp_boundary_bytes", "boundary", RESULT_status, 2, of_hsp_boundary_bytes, call_hsp_boundary_bytes, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_RANGE)},
  {"hsp_boundary_init", "boundary", RESULT_status, 4, of_hsp_boundary_init, call_hsp_boundary_init, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_MEMORY) | BIT(HSP_E_RANGE)},
  {"hsp_boundary_compute", "boundary", RESULT_status, 3, of_hsp_boundary_compute, call_hsp_boundary_compute, BIT(HSP_OK)
      | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_boundary_compute_with", "boundary", RESULT_status, 6, of_hsp_boundary_compute_with,
      call_hsp_boundary_compute_with, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) |
      BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_EXECUTOR) | BIT(HSP_E_STOPPED)},
  {"hsp_boundary_get_counts", "boundary", RESULT_status, 2, of_hsp_boundary_get_counts, call_hsp_boundary_get_counts,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE)},
  {"hsp_boundary_get_vertices", "boundary", RESULT_status, 4, of_hsp_boundary_get_vertices,
      call_hsp_boundary_get_vertices, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE)},
  {"hsp_boundary_get_arcs", "boundary", RESULT_status, 4, of_hsp_boundary_get_arcs, call_hsp_boundary_get_arcs,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_boundary_get_circles", "boundary", RESULT_status, 4, of_hsp_boundary_get_circles, call_hsp_boundary_get_circles,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_boundary_get_faces", "boundary", RESULT_status, 4, of_hsp_boundary_get_faces, call_hsp_boundary_get_faces,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_boundary_get_loops", "boundary", RESULT_status, 4, of_hsp_boundary_get_loops, call_hsp_boundary_get_loops,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_boundary_get_loop_arcs", "boundary", RESULT_status, 4, of_hsp_boundary_get_loop_arcs,
      call_hsp_boundary_get_loop_arcs, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE)},
  {"hsp_boundary_get_balls", "boundary", RESULT_status, 4, of_hsp_boundary_get_balls, call_hsp_boundary_get_balls,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_boundary_check", "boundary", RESULT_status, 3, of_hsp_boundary_check, call_hsp_boundary_check, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_CHECK)},
  {"hsp_areas_bytes", "measure", RESULT_status, 2, of_hsp_areas_bytes, call_hsp_areas_bytes, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_RANGE)},
  {"hsp_areas", "measure", RESULT_status, 8, of_hsp_areas, call_hsp_areas, BIT(HSP_OK) | BIT(HSP_E_ARGUMENT) |
      BIT(HSP_E_CAPACITY) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_NEGATIVE) | BIT(HSP_E_RANGE)},
  {"hsp_boundary_measure", "measure", RESULT_status, 7, of_hsp_boundary_measure, call_hsp_boundary_measure, BIT(HSP_OK)
      | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_boundary_get_measures", "measure", RESULT_status, 10, of_hsp_boundary_get_measures,
      call_hsp_boundary_get_measures, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) |
      BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_EXECUTOR) | BIT(HSP_E_STOPPED)},
  {"hsp_boundary_measure_faces", "measure", RESULT_status, 5, of_hsp_boundary_measure_faces,
      call_hsp_boundary_measure_faces, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE)},
  {"hsp_gradient_request_init", "gradient", RESULT_status, 2, of_hsp_gradient_request_init,
      call_hsp_gradient_request_init, BIT(HSP_OK) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION)},
  {"hsp_boundary_get_gradient", "gradient", RESULT_status, 16, of_hsp_boundary_get_gradient,
      call_hsp_boundary_get_gradient, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) |
      BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_EXECUTOR) | BIT(HSP_E_STOPPED)},
  {"hsp_boundary_get_derivatives", "gradient", RESULT_status, 14, of_hsp_boundary_get_derivatives,
      call_hsp_boundary_get_derivatives, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) |
      BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_EXECUTOR) | BIT(HSP_E_STOPPED)},
  {"hsp_boundary_get_area_row", "gradient", RESULT_status, 6, of_hsp_boundary_get_area_row,
      call_hsp_boundary_get_area_row, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_boundary_get_area_rows", "gradient", RESULT_status, 11, of_hsp_boundary_get_area_rows,
      call_hsp_boundary_get_area_rows, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) |
      BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_EXECUTOR) | BIT(HSP_E_STOPPED)},
  {"hsp_moving_limits_init", "moving", RESULT_status, 3, of_hsp_moving_limits_init, call_hsp_moving_limits_init,
      BIT(HSP_OK) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_RANGE)},
  {"hsp_moving_bytes", "moving", RESULT_status, 2, of_hsp_moving_bytes, call_hsp_moving_bytes, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_RANGE)},
  {"hsp_moving_init", "moving", RESULT_status, 4, of_hsp_moving_init, call_hsp_moving_init, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_MEMORY) | BIT(HSP_E_RANGE)},
  {"hsp_moving_set", "moving", RESULT_status, 8, of_hsp_moving_set, call_hsp_moving_set, BIT(HSP_OK) | BIT(HSP_E_HANDLE)
      | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE)},
  {"hsp_moving_set_with", "moving", RESULT_status, 10, of_hsp_moving_set_with, call_hsp_moving_set_with, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) |
      BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_STOPPED)},
  {"hsp_moving_move", "moving", RESULT_status, 7, of_hsp_moving_move, call_hsp_moving_move, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) |
      BIT(HSP_E_ID) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_NEGATIVE) | BIT(HSP_E_RANGE)},
  {"hsp_moving_move_with", "moving", RESULT_status, 9, of_hsp_moving_move_with, call_hsp_moving_move_with, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) |
      BIT(HSP_E_ID) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_NEGATIVE) | BIT(HSP_E_RANGE) | BIT(HSP_E_STOPPED)},
  {"hsp_moving_undo", "moving", RESULT_status, 1, of_hsp_moving_undo, call_hsp_moving_undo, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE)},
  {"hsp_moving_get_info", "moving", RESULT_status, 2, of_hsp_moving_get_info, call_hsp_moving_get_info, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE)},
  {"hsp_moving_measure", "moving", RESULT_status, 6, of_hsp_moving_measure, call_hsp_moving_measure, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_moving_gradient", "moving", RESULT_status, 7, of_hsp_moving_gradient, call_hsp_moving_gradient, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_moving_get_balls", "moving", RESULT_status, 4, of_hsp_moving_get_balls, call_hsp_moving_get_balls, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_moving_get_changed", "moving", RESULT_status, 4, of_hsp_moving_get_changed, call_hsp_moving_get_changed,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_moving_get_model", "moving", RESULT_status, 2, of_hsp_moving_get_model, call_hsp_moving_get_model, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_boundary_curvature", "curvature", RESULT_status, 6, of_hsp_boundary_curvature, call_hsp_boundary_curvature,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_boundary_curvature_with", "curvature", RESULT_status, 8, of_hsp_boundary_curvature_with,
      call_hsp_boundary_curvature_with, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) |
      BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_STOPPED)},
  {"hsp_boundary_get_morphometry", "curvature", RESULT_status, 17, of_hsp_boundary_get_morphometry,
      call_hsp_boundary_get_morphometry, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) |
      BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_EXECUTOR) | BIT(HSP_E_STOPPED)},
  {"hsp_boundary_get_hessian_rows", "hessian", RESULT_status, 13, of_hsp_boundary_get_hessian_rows,
      call_hsp_boundary_get_hessian_rows, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) |
      BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_EXECUTOR) | BIT(HSP_E_STOPPED)},
  {"hsp_boundary_get_hessian_product", "hessian", RESULT_status, 12, of_hsp_boundary_get_hessian_product,
      call_hsp_boundary_get_hessian_product, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION)
      | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_EXECUTOR) | BIT(HSP_E_STOPPED)},
  {"hsp_brick_summarise", "bricks", RESULT_status, 11, of_hsp_brick_summarise, call_hsp_brick_summarise, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) |
      BIT(HSP_E_ID) | BIT(HSP_E_STOPPED)},
  {"hsp_brick_merge", "bricks", RESULT_status, 8, of_hsp_brick_merge, call_hsp_brick_merge, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_ID) | BIT(HSP_E_RANGE) |
      BIT(HSP_E_CONFLICT) | BIT(HSP_E_DAMAGED) | BIT(HSP_E_STOPPED)},
  {"hsp_brick_get_totals", "bricks", RESULT_status, 4, of_hsp_brick_get_totals, call_hsp_brick_get_totals, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_STATE) | BIT(HSP_E_CONFLICT) | BIT(HSP_E_DAMAGED)},
  {"hsp_brick_get_shells", "bricks", RESULT_status, 6, of_hsp_brick_get_shells, call_hsp_brick_get_shells, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_CONFLICT) |
      BIT(HSP_E_DAMAGED)},
  {"hsp_contacts_limits_init", "contacts", RESULT_status, 3, of_hsp_contacts_limits_init, call_hsp_contacts_limits_init,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_STATE) | BIT(HSP_E_RANGE)},
  {"hsp_contacts_bytes", "contacts", RESULT_status, 2, of_hsp_contacts_bytes, call_hsp_contacts_bytes, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_RANGE)},
  {"hsp_contacts_init", "contacts", RESULT_status, 4, of_hsp_contacts_init, call_hsp_contacts_init, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_MEMORY) | BIT(HSP_E_RANGE)},
  {"hsp_contacts_compute", "contacts", RESULT_status, 3, of_hsp_contacts_compute, call_hsp_contacts_compute, BIT(HSP_OK)
      | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_contacts_compute_with", "contacts", RESULT_status, 5, of_hsp_contacts_compute_with,
      call_hsp_contacts_compute_with, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) |
      BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_STOPPED)},
  {"hsp_contacts_get_pairs", "contacts", RESULT_status, 4, of_hsp_contacts_get_pairs, call_hsp_contacts_get_pairs,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_contacts_get_row", "contacts", RESULT_status, 5, of_hsp_contacts_get_row, call_hsp_contacts_get_row, BIT(HSP_OK)
      | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_contacts_measure", "contacts", RESULT_status, 6, of_hsp_contacts_measure, call_hsp_contacts_measure, BIT(HSP_OK)
      | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_contacts_group", "contacts", RESULT_status, 5, of_hsp_contacts_group, call_hsp_contacts_group, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_contacts_get_complex", "contacts", RESULT_status, 2, of_hsp_contacts_get_complex, call_hsp_contacts_get_complex,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE)},
  {"hsp_contacts_get_simplices", "contacts", RESULT_status, 5, of_hsp_contacts_get_simplices,
      call_hsp_contacts_get_simplices, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE)},
  {"hsp_contacts_check", "contacts", RESULT_status, 3, of_hsp_contacts_check, call_hsp_contacts_check, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_CHECK)},
  {"hsp_periodic_limits_init", "periodic", RESULT_status, 3, of_hsp_periodic_limits_init, call_hsp_periodic_limits_init,
      BIT(HSP_OK) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_RANGE)},
  {"hsp_periodic_bytes", "periodic", RESULT_status, 2, of_hsp_periodic_bytes, call_hsp_periodic_bytes, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_RANGE)},
  {"hsp_periodic_init", "periodic", RESULT_status, 4, of_hsp_periodic_init, call_hsp_periodic_init, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_MEMORY) | BIT(HSP_E_RANGE)},
  {"hsp_periodic_compute", "periodic", RESULT_status, 8, of_hsp_periodic_compute, call_hsp_periodic_compute, BIT(HSP_OK)
      | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_NOT_FINITE) |
      BIT(HSP_E_NEGATIVE) | BIT(HSP_E_RANGE)},
  {"hsp_periodic_compute_with", "periodic", RESULT_status, 11, of_hsp_periodic_compute_with,
      call_hsp_periodic_compute_with, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) |
      BIT(HSP_E_CAPACITY) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_NEGATIVE) | BIT(HSP_E_RANGE) | BIT(HSP_E_EXECUTOR) |
      BIT(HSP_E_STOPPED)},
  {"hsp_periodic_get_counts", "periodic", RESULT_status, 2, of_hsp_periodic_get_counts, call_hsp_periodic_get_counts,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE)},
  {"hsp_periodic_measure", "periodic", RESULT_status, 6, of_hsp_periodic_measure, call_hsp_periodic_measure, BIT(HSP_OK)
      | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_periodic_curvature", "periodic", RESULT_status, 6, of_hsp_periodic_curvature, call_hsp_periodic_curvature,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_periodic_get_morphometry", "periodic", RESULT_status, 19, of_hsp_periodic_get_morphometry,
      call_hsp_periodic_get_morphometry, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) |
      BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_EXECUTOR) | BIT(HSP_E_STOPPED)},
  {"hsp_periodic_get_contacts", "periodic", RESULT_status, 4, of_hsp_periodic_get_contacts,
      call_hsp_periodic_get_contacts, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE)},
  {"hsp_periodic_group_contacts", "periodic", RESULT_status, 5, of_hsp_periodic_group_contacts,
      call_hsp_periodic_group_contacts, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE)},
  {"hsp_periodic_get_windings", "periodic", RESULT_status, 4, of_hsp_periodic_get_windings,
      call_hsp_periodic_get_windings, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE)},
  {"hsp_periodic_get_components", "periodic", RESULT_status, 4, of_hsp_periodic_get_components,
      call_hsp_periodic_get_components, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE)},
  {"hsp_periodic_get_gradient", "periodic", RESULT_status, 18, of_hsp_periodic_get_gradient,
      call_hsp_periodic_get_gradient, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) |
      BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_EXECUTOR) | BIT(HSP_E_STOPPED)},
  {"hsp_periodic_get_hessian_rows", "periodic", RESULT_status, 13, of_hsp_periodic_get_hessian_rows,
      call_hsp_periodic_get_hessian_rows, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) |
      BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_EXECUTOR) | BIT(HSP_E_STOPPED)},
  {"hsp_periodic_query_point", "periodic", RESULT_status, 5, of_hsp_periodic_query_point, call_hsp_periodic_query_point,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) |
      BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE)},
  {"hsp_periodic_query_ball", "periodic", RESULT_status, 6, of_hsp_periodic_query_ball, call_hsp_periodic_query_ball,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) |
      BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_NEGATIVE) | BIT(HSP_E_RANGE)},
  {"hsp_periodic_query_neighbours", "periodic", RESULT_status, 5, of_hsp_periodic_query_neighbours,
      call_hsp_periodic_query_neighbours, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_periodic_query_pairs", "periodic", RESULT_status, 6, of_hsp_periodic_query_pairs, call_hsp_periodic_query_pairs,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) |
      BIT(HSP_E_RANGE)},
  {"hsp_periodic_check", "periodic", RESULT_status, 3, of_hsp_periodic_check, call_hsp_periodic_check, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_CHECK)},
  {"hsp_periodic_get_vertices", "periodic_boundary", RESULT_status, 4, of_hsp_periodic_get_vertices,
      call_hsp_periodic_get_vertices, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE)},
  {"hsp_periodic_get_arcs", "periodic_boundary", RESULT_status, 4, of_hsp_periodic_get_arcs, call_hsp_periodic_get_arcs,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_periodic_get_circles", "periodic_boundary", RESULT_status, 4, of_hsp_periodic_get_circles,
      call_hsp_periodic_get_circles, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE)},
  {"hsp_periodic_get_faces", "periodic_boundary", RESULT_status, 4, of_hsp_periodic_get_faces,
      call_hsp_periodic_get_faces, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE)},
  {"hsp_periodic_get_loops", "periodic_boundary", RESULT_status, 4, of_hsp_periodic_get_loops,
      call_hsp_periodic_get_loops, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE)},
  {"hsp_periodic_get_loop_arcs", "periodic_boundary", RESULT_status, 4, of_hsp_periodic_get_loop_arcs,
      call_hsp_periodic_get_loop_arcs, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE)},
  {"hsp_periodic_get_balls", "periodic_boundary", RESULT_status, 4, of_hsp_periodic_get_balls,
      call_hsp_periodic_get_balls, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE)},
  {"hsp_surface_limits_init", "surface", RESULT_status, 3, of_hsp_surface_limits_init, call_hsp_surface_limits_init,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_STATE)},
  {"hsp_surface_bytes", "surface", RESULT_status, 2, of_hsp_surface_bytes, call_hsp_surface_bytes, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_RANGE)},
  {"hsp_surface_init", "surface", RESULT_status, 4, of_hsp_surface_init, call_hsp_surface_init, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_MEMORY) | BIT(HSP_E_RANGE)},
  {"hsp_surface_compute", "surface", RESULT_status, 3, of_hsp_surface_compute, call_hsp_surface_compute, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) |
      BIT(HSP_E_DEGENERATE)},
  {"hsp_surface_compute_shells", "surface", RESULT_status, 5, of_hsp_surface_compute_shells,
      call_hsp_surface_compute_shells, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) |
      BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_ID) | BIT(HSP_E_DEGENERATE)},
  {"hsp_surface_compute_with", "surface", RESULT_status, 7, of_hsp_surface_compute_with, call_hsp_surface_compute_with,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE) | BIT(HSP_E_ID) | BIT(HSP_E_DEGENERATE) | BIT(HSP_E_STOPPED)},
  {"hsp_surface_get_counts", "surface", RESULT_status, 2, of_hsp_surface_get_counts, call_hsp_surface_get_counts,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE)},
  {"hsp_surface_measure", "surface", RESULT_status, 5, of_hsp_surface_measure, call_hsp_surface_measure, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_surface_measure_with", "surface", RESULT_status, 7, of_hsp_surface_measure_with, call_hsp_surface_measure_with,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE) | BIT(HSP_E_STOPPED)},
  {"hsp_surface_get_gradient", "surface", RESULT_status, 16, of_hsp_surface_get_gradient, call_hsp_surface_get_gradient,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_EXECUTOR) | BIT(HSP_E_STOPPED)},
  {"hsp_surface_get_part_counts", "surface", RESULT_status, 2, of_hsp_surface_get_part_counts,
      call_hsp_surface_get_part_counts, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE)},
  {"hsp_surface_next", "surface", RESULT_id, 2, of_hsp_surface_next, call_hsp_surface_next, 0},
  {"hsp_surface_previous", "surface", RESULT_id, 2, of_hsp_surface_previous, call_hsp_surface_previous, 0},
  {"hsp_surface_next_loop", "surface", RESULT_id, 2, of_hsp_surface_next_loop, call_hsp_surface_next_loop, 0},
  {"hsp_surface_origin", "surface", RESULT_id, 2, of_hsp_surface_origin, call_hsp_surface_origin, 0},
  {"hsp_surface_left", "surface", RESULT_id, 2, of_hsp_surface_left, call_hsp_surface_left, 0},
  {"hsp_surface_get_patches", "surface", RESULT_status, 4, of_hsp_surface_get_patches, call_hsp_surface_get_patches,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_surface_get_edges", "surface", RESULT_status, 4, of_hsp_surface_get_edges, call_hsp_surface_get_edges,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_surface_get_corners", "surface", RESULT_status, 4, of_hsp_surface_get_corners, call_hsp_surface_get_corners,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_surface_get_shells", "surface", RESULT_status, 4, of_hsp_surface_get_shells, call_hsp_surface_get_shells,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_surface_check", "surface", RESULT_status, 3, of_hsp_surface_check, call_hsp_surface_check, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_CHECK)},
  {"hsp_mesh_limits_init", "mesh", RESULT_status, 4, of_hsp_mesh_limits_init, call_hsp_mesh_limits_init, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE) |
      BIT(HSP_E_STATE)},
  {"hsp_mesh_limits_init_surface", "mesh", RESULT_status, 4, of_hsp_mesh_limits_init_surface,
      call_hsp_mesh_limits_init_surface, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) |
      BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE) | BIT(HSP_E_STATE)},
  {"hsp_mesh_bytes", "mesh", RESULT_status, 2, of_hsp_mesh_bytes, call_hsp_mesh_bytes, BIT(HSP_OK) | BIT(HSP_E_ARGUMENT)
      | BIT(HSP_E_VERSION) | BIT(HSP_E_RANGE)},
  {"hsp_mesh_init", "mesh", RESULT_status, 4, of_hsp_mesh_init, call_hsp_mesh_init, BIT(HSP_OK) | BIT(HSP_E_ARGUMENT) |
      BIT(HSP_E_VERSION) | BIT(HSP_E_MEMORY) | BIT(HSP_E_RANGE)},
  {"hsp_mesh_compute", "mesh", RESULT_status, 4, of_hsp_mesh_compute, call_hsp_mesh_compute, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE) |
      BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_DEGENERATE)},
  {"hsp_mesh_compute_surface", "mesh", RESULT_status, 4, of_hsp_mesh_compute_surface, call_hsp_mesh_compute_surface,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_NOT_FINITE) |
      BIT(HSP_E_RANGE) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_DEGENERATE)},
  {"hsp_mesh_compute_with", "mesh", RESULT_status, 6, of_hsp_mesh_compute_with, call_hsp_mesh_compute_with, BIT(HSP_OK)
      | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) |
      BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE) | BIT(HSP_E_DEGENERATE) | BIT(HSP_E_STOPPED)},
  {"hsp_mesh_compute_surface_with", "mesh", RESULT_status, 6, of_hsp_mesh_compute_surface_with,
      call_hsp_mesh_compute_surface_with, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) |
      BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE) | BIT(HSP_E_DEGENERATE) |
      BIT(HSP_E_STOPPED)},
  {"hsp_mesh_get_counts", "mesh", RESULT_status, 2, of_hsp_mesh_get_counts, call_hsp_mesh_get_counts, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE)},
  {"hsp_mesh_get_vertices", "mesh", RESULT_status, 7, of_hsp_mesh_get_vertices, call_hsp_mesh_get_vertices, BIT(HSP_OK)
      | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_mesh_get_weights", "mesh", RESULT_status, 6, of_hsp_mesh_get_weights, call_hsp_mesh_get_weights, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_ID) |
      BIT(HSP_E_NOT_FINITE)},
  {"hsp_mesh_get_triangles", "mesh", RESULT_status, 7, of_hsp_mesh_get_triangles, call_hsp_mesh_get_triangles,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_mesh_get_patch", "mesh", RESULT_status, 4, of_hsp_mesh_get_patch, call_hsp_mesh_get_patch, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE)},
  {"hsp_topology_limits_init", "regions", RESULT_status, 3, of_hsp_topology_limits_init, call_hsp_topology_limits_init,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_STATE)},
  {"hsp_topology_bytes", "regions", RESULT_status, 2, of_hsp_topology_bytes, call_hsp_topology_bytes, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_RANGE)},
  {"hsp_topology_init", "regions", RESULT_status, 4, of_hsp_topology_init, call_hsp_topology_init, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_MEMORY) | BIT(HSP_E_RANGE)},
  {"hsp_topology_compute", "regions", RESULT_status, 3, of_hsp_topology_compute, call_hsp_topology_compute, BIT(HSP_OK)
      | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_topology_compute_with", "regions", RESULT_status, 5, of_hsp_topology_compute_with,
      call_hsp_topology_compute_with, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) |
      BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_STOPPED)},
  {"hsp_topology_get_counts", "regions", RESULT_status, 2, of_hsp_topology_get_counts, call_hsp_topology_get_counts,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE)},
  {"hsp_topology_get_shells", "regions", RESULT_status, 4, of_hsp_topology_get_shells, call_hsp_topology_get_shells,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_topology_get_components", "regions", RESULT_status, 4, of_hsp_topology_get_components,
      call_hsp_topology_get_components, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE)},
  {"hsp_topology_get_regions", "regions", RESULT_status, 4, of_hsp_topology_get_regions, call_hsp_topology_get_regions,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_topology_get_region_shells", "regions", RESULT_status, 5, of_hsp_topology_get_region_shells,
      call_hsp_topology_get_region_shells, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_topology_get_region_balls", "regions", RESULT_status, 5, of_hsp_topology_get_region_balls,
      call_hsp_topology_get_region_balls, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_topology_locate", "regions", RESULT_status, 3, of_hsp_topology_locate, call_hsp_topology_locate, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE)},
  {"hsp_topology_onext", "topology", RESULT_id, 2, of_hsp_topology_onext, call_hsp_topology_onext, 0},
  {"hsp_topology_lnext", "topology", RESULT_id, 2, of_hsp_topology_lnext, call_hsp_topology_lnext, 0},
  {"hsp_topology_origin", "topology", RESULT_id, 2, of_hsp_topology_origin, call_hsp_topology_origin, 0},
  {"hsp_topology_left", "topology", RESULT_id, 2, of_hsp_topology_left, call_hsp_topology_left, 0},
  {"hsp_topology_get_quad_edges", "topology", RESULT_status, 5, of_hsp_topology_get_quad_edges,
      call_hsp_topology_get_quad_edges, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) |
      BIT(HSP_E_ID)},
  {"hsp_topology_get_vertices", "topology", RESULT_status, 4, of_hsp_topology_get_vertices,
      call_hsp_topology_get_vertices, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) |
      BIT(HSP_E_ID)},
  {"hsp_topology_get_edges", "topology", RESULT_status, 4, of_hsp_topology_get_edges, call_hsp_topology_get_edges,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_topology_get_simple_faces", "topology", RESULT_status, 4, of_hsp_topology_get_simple_faces,
      call_hsp_topology_get_simple_faces, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) |
      BIT(HSP_E_ID)},
  {"hsp_topology_get_traversal", "topology", RESULT_status, 5, of_hsp_topology_get_traversal,
      call_hsp_topology_get_traversal, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_topology_check", "topology", RESULT_status, 3, of_hsp_topology_check, call_hsp_topology_check, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_CHECK)},
  {"hsp_cells_limits_init", "cells", RESULT_status, 3, of_hsp_cells_limits_init, call_hsp_cells_limits_init, BIT(HSP_OK)
      | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_RANGE)},
  {"hsp_cells_bytes", "cells", RESULT_status, 2, of_hsp_cells_bytes, call_hsp_cells_bytes, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_RANGE)},
  {"hsp_cells_init", "cells", RESULT_status, 4, of_hsp_cells_init, call_hsp_cells_init, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_MEMORY) | BIT(HSP_E_RANGE)},
  {"hsp_cells_compute", "cells", RESULT_status, 3, of_hsp_cells_compute, call_hsp_cells_compute, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) |
      BIT(HSP_E_CHECK)},
  {"hsp_cells_compute_with", "cells", RESULT_status, 5, of_hsp_cells_compute_with, call_hsp_cells_compute_with,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE) | BIT(HSP_E_CHECK) | BIT(HSP_E_STOPPED)},
  {"hsp_cells_get_counts", "cells", RESULT_status, 2, of_hsp_cells_get_counts, call_hsp_cells_get_counts, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE)},
  {"hsp_cells_get_cells", "cells", RESULT_status, 4, of_hsp_cells_get_cells, call_hsp_cells_get_cells, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_cells_get_neighbours", "cells", RESULT_status, 5, of_hsp_cells_get_neighbours, call_hsp_cells_get_neighbours,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_cells_get_pairs", "cells", RESULT_status, 4, of_hsp_cells_get_pairs, call_hsp_cells_get_pairs, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_cells_locate", "cells", RESULT_status, 3, of_hsp_cells_locate, call_hsp_cells_locate, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE)},
  {"hsp_cells_check", "cells", RESULT_status, 4, of_hsp_cells_check, call_hsp_cells_check, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_CHECK)},
  {"hsp_model_arrangement", "cells", RESULT_status, 6, of_hsp_model_arrangement, call_hsp_model_arrangement, BIT(HSP_OK)
      | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_RANGE)},
  {"hsp_paths_limits_init", "paths", RESULT_status, 3, of_hsp_paths_limits_init, call_hsp_paths_limits_init, BIT(HSP_OK)
      | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_RANGE)},
  {"hsp_paths_bytes", "paths", RESULT_status, 2, of_hsp_paths_bytes, call_hsp_paths_bytes, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_RANGE)},
  {"hsp_paths_init", "paths", RESULT_status, 4, of_hsp_paths_init, call_hsp_paths_init, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_MEMORY) | BIT(HSP_E_RANGE)},
  {"hsp_paths_compute", "paths", RESULT_status, 3, of_hsp_paths_compute, call_hsp_paths_compute, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) |
      BIT(HSP_E_CHECK)},
  {"hsp_paths_compute_with", "paths", RESULT_status, 5, of_hsp_paths_compute_with, call_hsp_paths_compute_with,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE) | BIT(HSP_E_CHECK) | BIT(HSP_E_STOPPED)},
  {"hsp_paths_find", "paths", RESULT_status, 5, of_hsp_paths_find, call_hsp_paths_find, BIT(HSP_OK) | BIT(HSP_E_HANDLE)
      | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_CHECK) |
      BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE)},
  {"hsp_paths_find_with", "paths", RESULT_status, 7, of_hsp_paths_find_with, call_hsp_paths_find_with, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) |
      BIT(HSP_E_CHECK) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE) | BIT(HSP_E_STOPPED)},
  {"hsp_paths_get_points", "paths", RESULT_status, 4, of_hsp_paths_get_points, call_hsp_paths_get_points, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_pores_limits_init", "pores", RESULT_status, 3, of_hsp_pores_limits_init, call_hsp_pores_limits_init, BIT(HSP_OK)
      | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_RANGE)},
  {"hsp_pores_bytes", "pores", RESULT_status, 2, of_hsp_pores_bytes, call_hsp_pores_bytes, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_RANGE)},
  {"hsp_pores_init", "pores", RESULT_status, 4, of_hsp_pores_init, call_hsp_pores_init, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_MEMORY) | BIT(HSP_E_RANGE)},
  {"hsp_pores_options_init", "pores", RESULT_status, 2, of_hsp_pores_options_init, call_hsp_pores_options_init,
      BIT(HSP_OK) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION)},
  {"hsp_pores_compute", "pores", RESULT_status, 4, of_hsp_pores_compute, call_hsp_pores_compute, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) |
      BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE) | BIT(HSP_E_CHECK) | BIT(HSP_E_STOPPED)},
  {"hsp_pores_compute_periodic", "pores", RESULT_status, 4, of_hsp_pores_compute_periodic,
      call_hsp_pores_compute_periodic, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) |
      BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE) | BIT(HSP_E_CHECK) |
      BIT(HSP_E_STOPPED)},
  {"hsp_pores_get_counts", "pores", RESULT_status, 2, of_hsp_pores_get_counts, call_hsp_pores_get_counts, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE)},
  {"hsp_pores_get_maxima", "pores", RESULT_status, 4, of_hsp_pores_get_maxima, call_hsp_pores_get_maxima, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_pores_get_gates", "pores", RESULT_status, 4, of_hsp_pores_get_gates, call_hsp_pores_get_gates, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_pores_get_gate_shifts", "pores", RESULT_status, 4, of_hsp_pores_get_gate_shifts, call_hsp_pores_get_gate_shifts,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_pores_get_maximum_balls", "pores", RESULT_status, 5, of_hsp_pores_get_maximum_balls,
      call_hsp_pores_get_maximum_balls, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_pores_get_gate_balls", "pores", RESULT_status, 5, of_hsp_pores_get_gate_balls, call_hsp_pores_get_gate_balls,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_pores_get_maximum_images", "pores", RESULT_status, 5, of_hsp_pores_get_maximum_images,
      call_hsp_pores_get_maximum_images, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_pores_get_gate_images", "pores", RESULT_status, 5, of_hsp_pores_get_gate_images, call_hsp_pores_get_gate_images,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_pores_get_percolation", "pores", RESULT_status, 2, of_hsp_pores_get_percolation, call_hsp_pores_get_percolation,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE)},
  {"hsp_pores_get_channels", "pores", RESULT_status, 5, of_hsp_pores_get_channels, call_hsp_pores_get_channels,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) |
      BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE)},
  {"hsp_pores_class_at", "pores", RESULT_status, 4, of_hsp_pores_class_at, call_hsp_pores_class_at, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_ID) | BIT(HSP_E_NOT_FINITE) |
      BIT(HSP_E_RANGE)},
  {"hsp_pores_gate_between", "pores", RESULT_status, 4, of_hsp_pores_gate_between, call_hsp_pores_gate_between,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_pores_locate", "pores", RESULT_status, 3, of_hsp_pores_locate, call_hsp_pores_locate, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE) |
      BIT(HSP_E_CHECK)},
  {"hsp_pores_locate_with_shifts", "pores", RESULT_status, 4, of_hsp_pores_locate_with_shifts,
      call_hsp_pores_locate_with_shifts, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) |
      BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE) | BIT(HSP_E_CHECK)},
  {"hsp_pores_widest", "pores", RESULT_status, 4, of_hsp_pores_widest, call_hsp_pores_widest, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE) |
      BIT(HSP_E_CHECK)},
  {"hsp_pores_find_tunnel", "pores", RESULT_status, 7, of_hsp_pores_find_tunnel, call_hsp_pores_find_tunnel, BIT(HSP_OK)
      | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) |
      BIT(HSP_E_ID) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE) | BIT(HSP_E_CHECK)},
  {"hsp_pores_find_cheapest_tunnel", "pores", RESULT_status, 7, of_hsp_pores_find_cheapest_tunnel,
      call_hsp_pores_find_cheapest_tunnel, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) |
      BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_ID) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE) |
      BIT(HSP_E_CHECK)},
  {"hsp_pores_find_tunnel_with", "pores", RESULT_status, 10, of_hsp_pores_find_tunnel_with,
      call_hsp_pores_find_tunnel_with, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) |
      BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_ID) | BIT(HSP_E_CHECK) | BIT(HSP_E_NOT_FINITE) |
      BIT(HSP_E_RANGE) | BIT(HSP_E_STOPPED)},
  {"hsp_pores_get_tunnel_route", "pores", RESULT_status, 2, of_hsp_pores_get_tunnel_route,
      call_hsp_pores_get_tunnel_route, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE)},
  {"hsp_pores_get_tunnel_points", "pores", RESULT_status, 4, of_hsp_pores_get_tunnel_points,
      call_hsp_pores_get_tunnel_points, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE)},
  {"hsp_pores_get_tunnel_point_shifts", "pores", RESULT_status, 4, of_hsp_pores_get_tunnel_point_shifts,
      call_hsp_pores_get_tunnel_point_shifts, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) |
      BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_pores_find_pockets", "pockets", RESULT_status, 4, of_hsp_pores_find_pockets, call_hsp_pores_find_pockets,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) |
      BIT(HSP_E_RANGE)},
  {"hsp_pores_get_pockets", "pockets", RESULT_status, 4, of_hsp_pores_get_pockets, call_hsp_pores_get_pockets,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_pores_get_pocket_maxima", "pockets", RESULT_status, 5, of_hsp_pores_get_pocket_maxima,
      call_hsp_pores_get_pocket_maxima, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_pores_get_pocket_mouths", "pockets", RESULT_status, 5, of_hsp_pores_get_pocket_mouths,
      call_hsp_pores_get_pocket_mouths, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_pores_get_pocket_balls", "pockets", RESULT_status, 5, of_hsp_pores_get_pocket_balls,
      call_hsp_pores_get_pocket_balls, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_pores_get_plugged_balls", "pockets", RESULT_status, 5, of_hsp_pores_get_plugged_balls,
      call_hsp_pores_get_plugged_balls, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE)},
  {"hsp_pores_find_regions", "pockets", RESULT_status, 4, of_hsp_pores_find_regions, call_hsp_pores_find_regions,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_RANGE) | BIT(HSP_E_CHECK)},
  {"hsp_pores_find_regions_with", "pockets", RESULT_status, 6, of_hsp_pores_find_regions_with,
      call_hsp_pores_find_regions_with, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) |
      BIT(HSP_E_STATE) | BIT(HSP_E_RANGE) | BIT(HSP_E_CHECK) | BIT(HSP_E_STOPPED)},
  {"hsp_pores_get_regions", "pockets", RESULT_status, 4, of_hsp_pores_get_regions, call_hsp_pores_get_regions,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_pores_measure_pockets", "pockets", RESULT_status, 6, of_hsp_pores_measure_pockets,
      call_hsp_pores_measure_pockets, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE) | BIT(HSP_E_RANGE) | BIT(HSP_E_CHECK)},
  {"hsp_pores_measure_pockets_with", "pockets", RESULT_status, 8, of_hsp_pores_measure_pockets_with,
      call_hsp_pores_measure_pockets_with, BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) |
      BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_RANGE) | BIT(HSP_E_CHECK) | BIT(HSP_E_STOPPED)},
  {"hsp_view_limits_init", "view", RESULT_status, 3, of_hsp_view_limits_init, call_hsp_view_limits_init, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_RANGE)},
  {"hsp_view_bytes", "view", RESULT_status, 2, of_hsp_view_bytes, call_hsp_view_bytes, BIT(HSP_OK) | BIT(HSP_E_ARGUMENT)
      | BIT(HSP_E_VERSION) | BIT(HSP_E_RANGE)},
  {"hsp_view_init", "view", RESULT_status, 4, of_hsp_view_init, call_hsp_view_init, BIT(HSP_OK) | BIT(HSP_E_ARGUMENT) |
      BIT(HSP_E_VERSION) | BIT(HSP_E_MEMORY) | BIT(HSP_E_RANGE)},
  {"hsp_view_options_init", "view", RESULT_status, 2, of_hsp_view_options_init, call_hsp_view_options_init, BIT(HSP_OK)
      | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION)},
  {"hsp_view_options_turn", "view", RESULT_status, 4, of_hsp_view_options_turn, call_hsp_view_options_turn, BIT(HSP_OK)
      | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE)},
  {"hsp_view_compute", "view", RESULT_status, 5, of_hsp_view_compute, call_hsp_view_compute, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) |
      BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_STOPPED)},
  {"hsp_view_get_info", "view", RESULT_status, 2, of_hsp_view_get_info, call_hsp_view_get_info, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE)},
  {"hsp_view_get_pieces", "view", RESULT_status, 4, of_hsp_view_get_pieces, call_hsp_view_get_pieces, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_view_get_loops", "view", RESULT_status, 4, of_hsp_view_get_loops, call_hsp_view_get_loops, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_view_get_arcs", "view", RESULT_status, 4, of_hsp_view_get_arcs, call_hsp_view_get_arcs, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_map_limits_init", "map", RESULT_status, 3, of_hsp_map_limits_init, call_hsp_map_limits_init, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_RANGE)},
  {"hsp_map_bytes", "map", RESULT_status, 2, of_hsp_map_bytes, call_hsp_map_bytes, BIT(HSP_OK) | BIT(HSP_E_ARGUMENT) |
      BIT(HSP_E_VERSION) | BIT(HSP_E_RANGE)},
  {"hsp_map_init", "map", RESULT_status, 4, of_hsp_map_init, call_hsp_map_init, BIT(HSP_OK) | BIT(HSP_E_ARGUMENT) |
      BIT(HSP_E_VERSION) | BIT(HSP_E_MEMORY) | BIT(HSP_E_RANGE)},
  {"hsp_map_compute", "map", RESULT_status, 4, of_hsp_map_compute, call_hsp_map_compute, BIT(HSP_OK) | BIT(HSP_E_HANDLE)
      | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) |
      BIT(HSP_E_DEGENERATE) | BIT(HSP_E_STOPPED)},
  {"hsp_map_get_info", "map", RESULT_status, 2, of_hsp_map_get_info, call_hsp_map_get_info, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE)},
  {"hsp_map_next", "map", RESULT_id, 2, of_hsp_map_next, call_hsp_map_next, 0},
  {"hsp_map_previous", "map", RESULT_id, 2, of_hsp_map_previous, call_hsp_map_previous, 0},
  {"hsp_map_next_loop", "map", RESULT_id, 2, of_hsp_map_next_loop, call_hsp_map_next_loop, 0},
  {"hsp_map_origin", "map", RESULT_id, 2, of_hsp_map_origin, call_hsp_map_origin, 0},
  {"hsp_map_left", "map", RESULT_id, 2, of_hsp_map_left, call_hsp_map_left, 0},
  {"hsp_map_get_vertices", "map", RESULT_status, 4, of_hsp_map_get_vertices, call_hsp_map_get_vertices, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_map_get_edges", "map", RESULT_status, 4, of_hsp_map_get_edges, call_hsp_map_get_edges, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_map_get_faces", "map", RESULT_status, 4, of_hsp_map_get_faces, call_hsp_map_get_faces, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_map_get_areas", "map", RESULT_status, 4, of_hsp_map_get_areas, call_hsp_map_get_areas, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_map_get_outline", "map", RESULT_status, 5, of_hsp_map_get_outline, call_hsp_map_get_outline, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_map_pick", "map", RESULT_status, 4, of_hsp_map_pick, call_hsp_map_pick, BIT(HSP_OK) | BIT(HSP_E_HANDLE) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE)},
  {"hsp_map_get_point", "map", RESULT_status, 4, of_hsp_map_get_point, call_hsp_map_get_point, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_ID) | BIT(HSP_E_NOT_FINITE) |
      BIT(HSP_E_RANGE)},
  {"hsp_map_get_pole", "map", RESULT_status, 3, of_hsp_map_get_pole, call_hsp_map_get_pole, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_map_check", "map", RESULT_status, 3, of_hsp_map_check, call_hsp_map_check, BIT(HSP_OK) | BIT(HSP_E_HANDLE) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_CHECK)},
  {"hsp_sticks_limits_init", "sticks", RESULT_status, 3, of_hsp_sticks_limits_init, call_hsp_sticks_limits_init,
      BIT(HSP_OK) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_RANGE)},
  {"hsp_sticks_bytes", "sticks", RESULT_status, 2, of_hsp_sticks_bytes, call_hsp_sticks_bytes, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_RANGE)},
  {"hsp_sticks_init", "sticks", RESULT_status, 4, of_hsp_sticks_init, call_hsp_sticks_init, BIT(HSP_OK) |
      BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_MEMORY) | BIT(HSP_E_RANGE)},
  {"hsp_sticks_compute", "sticks", RESULT_status, 8, of_hsp_sticks_compute, call_hsp_sticks_compute, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) |
      BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_NEGATIVE) | BIT(HSP_E_RANGE) | BIT(HSP_E_CONFLICT) | BIT(HSP_E_DEGENERATE) |
      BIT(HSP_E_STOPPED)},
  {"hsp_sticks_compute_map", "sticks", RESULT_status, 8, of_hsp_sticks_compute_map, call_hsp_sticks_compute_map,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION) | BIT(HSP_E_CAPACITY) |
      BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_NEGATIVE) | BIT(HSP_E_RANGE) | BIT(HSP_E_CONFLICT) |
      BIT(HSP_E_DEGENERATE) | BIT(HSP_E_STOPPED)},
  {"hsp_sticks_get_info", "sticks", RESULT_status, 2, of_hsp_sticks_get_info, call_hsp_sticks_get_info, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE)},
  {"hsp_sticks_get_map_info", "sticks", RESULT_status, 2, of_hsp_sticks_get_map_info, call_hsp_sticks_get_map_info,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE)},
  {"hsp_sticks_get_vertices", "sticks", RESULT_status, 4, of_hsp_sticks_get_vertices, call_hsp_sticks_get_vertices,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_sticks_get_edges", "sticks", RESULT_status, 4, of_hsp_sticks_get_edges, call_hsp_sticks_get_edges, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_sticks_get_faces", "sticks", RESULT_status, 4, of_hsp_sticks_get_faces, call_hsp_sticks_get_faces, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_sticks_get_areas", "sticks", RESULT_status, 4, of_hsp_sticks_get_areas, call_hsp_sticks_get_areas, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE)},
  {"hsp_sticks_pick", "sticks", RESULT_status, 4, of_hsp_sticks_pick, call_hsp_sticks_pick, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_NOT_FINITE)},
  {"hsp_sticks_get_outline", "sticks", RESULT_status, 5, of_hsp_sticks_get_outline, call_hsp_sticks_get_outline,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_CAPACITY) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_sticks_get_point", "sticks", RESULT_status, 4, of_hsp_sticks_get_point, call_hsp_sticks_get_point, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_ID) | BIT(HSP_E_NOT_FINITE) |
      BIT(HSP_E_RANGE)},
  {"hsp_sticks_get_pole", "sticks", RESULT_status, 3, of_hsp_sticks_get_pole, call_hsp_sticks_get_pole, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_ID)},
  {"hsp_sticks_check", "sticks", RESULT_status, 3, of_hsp_sticks_check, call_hsp_sticks_check, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_STATE) | BIT(HSP_E_CHECK)},
  {"hsp_picture_ink_width", "picture", RESULT_status, 3, of_hsp_picture_ink_width, call_hsp_picture_ink_width,
      BIT(HSP_OK) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE)},
  {"hsp_picture_fog_share", "picture", RESULT_status, 5, of_hsp_picture_fog_share, call_hsp_picture_fog_share,
      BIT(HSP_OK) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE)},
  {"hsp_picture_options_init", "picture", RESULT_status, 2, of_hsp_picture_options_init, call_hsp_picture_options_init,
      BIT(HSP_OK) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_VERSION)},
  {"hsp_palette_colour", "picture", RESULT_number, 3, of_hsp_palette_colour, call_hsp_palette_colour, 0},
  {"hsp_picture_write", "picture", RESULT_status, 8, of_hsp_picture_write, call_hsp_picture_write, BIT(HSP_OK) |
      BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_HANDLE) | BIT(HSP_E_VERSION) | BIT(HSP_E_MEMORY) |
      BIT(HSP_E_STATE) | BIT(HSP_E_SINK) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE)},
  {"hsp_picture_write_map", "picture", RESULT_status, 8, of_hsp_picture_write_map, call_hsp_picture_write_map,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_HANDLE) | BIT(HSP_E_VERSION) | BIT(HSP_E_MEMORY)
      | BIT(HSP_E_STATE) | BIT(HSP_E_SINK) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE)},
  {"hsp_picture_write_sticks", "picture", RESULT_status, 8, of_hsp_picture_write_sticks, call_hsp_picture_write_sticks,
      BIT(HSP_OK) | BIT(HSP_E_HANDLE) | BIT(HSP_E_ARGUMENT) | BIT(HSP_E_HANDLE) | BIT(HSP_E_VERSION) | BIT(HSP_E_MEMORY)
      | BIT(HSP_E_STATE) | BIT(HSP_E_SINK) | BIT(HSP_E_NOT_FINITE) | BIT(HSP_E_RANGE)},
};
const size_t registry_size = sizeof registry / sizeof registry[0];

const field registry_fields[] = {
  {"hsp_executor", "struct_size", "uint32_t", offsetof(hsp_executor, struct_size), 1},
  {"hsp_executor", "workers", "uint32_t", offsetof(hsp_executor, workers), 1},
  {"hsp_executor", "context", "void *", offsetof(hsp_executor, context), 1},
  {"hsp_executor", "run", "function *", offsetof(hsp_executor, run), 1},
  {"hsp_executor", "proceed", "function *", offsetof(hsp_executor, proceed), 1},
  {"hsp_residue_atom", "residue", "char", offsetof(hsp_residue_atom, residue), 8},
  {"hsp_residue_atom", "atom", "char", offsetof(hsp_residue_atom, atom), 8},
  {"hsp_residue_atom", "radius", "double", offsetof(hsp_residue_atom, radius), 1},
  {"hsp_model_options", "struct_size", "uint32_t", offsetof(hsp_model_options, struct_size), 1},
  {"hsp_model_options", "reserved", "uint32_t", offsetof(hsp_model_options, reserved), 1},
  {"hsp_model_options", "probe", "double", offsetof(hsp_model_options, probe), 1},
  {"hsp_model_options", "step", "double", offsetof(hsp_model_options, step), 1},
  {"hsp_model_options", "largest_radius", "double", offsetof(hsp_model_options, largest_radius), 1},
  {"hsp_model_request", "struct_size", "uint32_t", offsetof(hsp_model_request, struct_size), 1},
  {"hsp_model_request", "reserved", "uint32_t", offsetof(hsp_model_request, reserved), 1},
  {"hsp_model_request", "options", "hsp_model_options *", offsetof(hsp_model_request, options), 1},
  {"hsp_model_request", "executor", "hsp_executor *", offsetof(hsp_model_request, executor), 1},
  {"hsp_model_info", "balls", "uint32_t", offsetof(hsp_model_info, balls), 1},
  {"hsp_model_info", "cubes", "uint32_t", offsetof(hsp_model_info, cubes), 1},
  {"hsp_model_info", "table_slots", "uint32_t", offsetof(hsp_model_info, table_slots), 1},
  {"hsp_model_info", "longest_probe", "uint32_t", offsetof(hsp_model_info, longest_probe), 1},
  {"hsp_model_info", "step", "double", offsetof(hsp_model_info, step), 1},
  {"hsp_model_info", "probe", "double", offsetof(hsp_model_info, probe), 1},
  {"hsp_model_info", "largest_radius", "double", offsetof(hsp_model_info, largest_radius), 1},
  {"hsp_model_info", "largest_rounding", "double", offsetof(hsp_model_info, largest_rounding), 1},
  {"hsp_model_info", "reserved", "uint64_t", offsetof(hsp_model_info, reserved), 2},
  {"hsp_packing", "k", "double", offsetof(hsp_packing, k), 1},
  {"hsp_packing", "rho", "double", offsetof(hsp_packing, rho), 1},
  {"hsp_packing", "mean_overlaps", "double", offsetof(hsp_packing, mean_overlaps), 1},
  {"hsp_packing", "neighbour_bound", "double", offsetof(hsp_packing, neighbour_bound), 1},
  {"hsp_packing", "max_overlaps", "uint32_t", offsetof(hsp_packing, max_overlaps), 1},
  {"hsp_packing", "flags", "uint32_t", offsetof(hsp_packing, flags), 1},
  {"hsp_packing", "reserved", "uint64_t", offsetof(hsp_packing, reserved), 2},
  {"hsp_pairs_request", "struct_size", "uint32_t", offsetof(hsp_pairs_request, struct_size), 1},
  {"hsp_pairs_request", "flags", "uint32_t", offsetof(hsp_pairs_request, flags), 1},
  {"hsp_pairs_request", "executor", "hsp_executor *", offsetof(hsp_pairs_request, executor), 1},
  {"hsp_ray_hit", "xyz", "double", offsetof(hsp_ray_hit, xyz), 3},
  {"hsp_ray_hit", "distance", "double", offsetof(hsp_ray_hit, distance), 1},
  {"hsp_ray_hit", "ball", "uint32_t", offsetof(hsp_ray_hit, ball), 1},
  {"hsp_ray_hit", "reserved", "uint32_t", offsetof(hsp_ray_hit, reserved), 1},
  {"hsp_body_request", "struct_size", "uint32_t", offsetof(hsp_body_request, struct_size), 1},
  {"hsp_body_request", "reserved", "uint32_t", offsetof(hsp_body_request, reserved), 1},
  {"hsp_body_request", "executor", "hsp_executor *", offsetof(hsp_body_request, executor), 1},
  {"hsp_pose", "quaternion", "double", offsetof(hsp_pose, quaternion), 4},
  {"hsp_pose", "translation", "double", offsetof(hsp_pose, translation), 3},
  {"hsp_body_gap", "gap", "double", offsetof(hsp_body_gap, gap), 1},
  {"hsp_body_gap", "fixed", "uint32_t", offsetof(hsp_body_gap, fixed), 1},
  {"hsp_body_gap", "posed", "uint32_t", offsetof(hsp_body_gap, posed), 1},
  {"hsp_body_overlap", "volume", "double", offsetof(hsp_body_overlap, volume), 1},
  {"hsp_body_overlap", "pairs", "uint32_t", offsetof(hsp_body_overlap, pairs), 1},
  {"hsp_body_overlap", "reserved", "uint32_t", offsetof(hsp_body_overlap, reserved), 1},
  {"hsp_rational_pose", "quaternion", "int32_t", offsetof(hsp_rational_pose, quaternion), 4},
  {"hsp_rational_pose", "translation", "double", offsetof(hsp_rational_pose, translation), 3},
  {"hsp_boundary_limits", "struct_size", "uint32_t", offsetof(hsp_boundary_limits, struct_size), 1},
  {"hsp_boundary_limits", "balls", "uint32_t", offsetof(hsp_boundary_limits, balls), 1},
  {"hsp_boundary_limits", "neighbours", "uint32_t", offsetof(hsp_boundary_limits, neighbours), 1},
  {"hsp_boundary_limits", "vertices", "uint32_t", offsetof(hsp_boundary_limits, vertices), 1},
  {"hsp_boundary_limits", "circles", "uint32_t", offsetof(hsp_boundary_limits, circles), 1},
  {"hsp_boundary_limits", "workers", "uint32_t", offsetof(hsp_boundary_limits, workers), 1},
  {"hsp_boundary_request", "struct_size", "uint32_t", offsetof(hsp_boundary_request, struct_size), 1},
  {"hsp_boundary_request", "reserved", "uint32_t", offsetof(hsp_boundary_request, reserved), 1},
  {"hsp_boundary_request", "executor", "hsp_executor *", offsetof(hsp_boundary_request, executor), 1},
  {"hsp_boundary_request", "selected", "uint8_t *", offsetof(hsp_boundary_request, selected), 1},
  {"hsp_boundary_counts", "balls", "uint32_t", offsetof(hsp_boundary_counts, balls), 1},
  {"hsp_boundary_counts", "exposed_balls", "uint32_t", offsetof(hsp_boundary_counts, exposed_balls), 1},
  {"hsp_boundary_counts", "contained_balls", "uint32_t", offsetof(hsp_boundary_counts, contained_balls), 1},
  {"hsp_boundary_counts", "vertices", "uint32_t", offsetof(hsp_boundary_counts, vertices), 1},
  {"hsp_boundary_counts", "arcs", "uint32_t", offsetof(hsp_boundary_counts, arcs), 1},
  {"hsp_boundary_counts", "circles", "uint32_t", offsetof(hsp_boundary_counts, circles), 1},
  {"hsp_boundary_counts", "faces", "uint32_t", offsetof(hsp_boundary_counts, faces), 1},
  {"hsp_boundary_counts", "loops", "uint32_t", offsetof(hsp_boundary_counts, loops), 1},
  {"hsp_boundary_counts", "shells", "uint32_t", offsetof(hsp_boundary_counts, shells), 1},
  {"hsp_boundary_counts", "components", "uint32_t", offsetof(hsp_boundary_counts, components), 1},
  {"hsp_boundary_counts", "voids", "uint32_t", offsetof(hsp_boundary_counts, voids), 1},
  {"hsp_boundary_counts", "tied_vertices", "uint32_t", offsetof(hsp_boundary_counts, tied_vertices), 1},
  {"hsp_boundary_counts", "euler", "int64_t", offsetof(hsp_boundary_counts, euler), 1},
  {"hsp_boundary_counts", "reserved", "uint64_t", offsetof(hsp_boundary_counts, reserved), 2},
  {"hsp_vertex", "xyz", "double", offsetof(hsp_vertex, xyz), 3},
  {"hsp_vertex", "ball", "uint32_t", offsetof(hsp_vertex, ball), 3},
  {"hsp_vertex", "sign", "int32_t", offsetof(hsp_vertex, sign), 1},
  {"hsp_vertex", "flags", "uint32_t", offsetof(hsp_vertex, flags), 1},
  {"hsp_vertex", "reserved", "uint32_t", offsetof(hsp_vertex, reserved), 1},
  {"hsp_arc", "centre", "double", offsetof(hsp_arc, centre), 3},
  {"hsp_arc", "axis", "double", offsetof(hsp_arc, axis), 3},
  {"hsp_arc", "radius", "double", offsetof(hsp_arc, radius), 1},
  {"hsp_arc", "angle", "double", offsetof(hsp_arc, angle), 1},
  {"hsp_arc", "ball", "uint32_t", offsetof(hsp_arc, ball), 2},
  {"hsp_arc", "vertex", "uint32_t", offsetof(hsp_arc, vertex), 2},
  {"hsp_arc", "face", "uint32_t", offsetof(hsp_arc, face), 2},
  {"hsp_circle", "centre", "double", offsetof(hsp_circle, centre), 3},
  {"hsp_circle", "axis", "double", offsetof(hsp_circle, axis), 3},
  {"hsp_circle", "radius", "double", offsetof(hsp_circle, radius), 1},
  {"hsp_circle", "ball", "uint32_t", offsetof(hsp_circle, ball), 2},
  {"hsp_circle", "face", "uint32_t", offsetof(hsp_circle, face), 2},
  {"hsp_face", "ball", "uint32_t", offsetof(hsp_face, ball), 1},
  {"hsp_face", "loops", "uint32_t", offsetof(hsp_face, loops), 1},
  {"hsp_face", "shell", "uint32_t", offsetof(hsp_face, shell), 1},
  {"hsp_face", "first_loop", "uint32_t", offsetof(hsp_face, first_loop), 1},
  {"hsp_loop", "face", "uint32_t", offsetof(hsp_loop, face), 1},
  {"hsp_loop", "circle", "uint32_t", offsetof(hsp_loop, circle), 1},
  {"hsp_loop", "side", "uint32_t", offsetof(hsp_loop, side), 1},
  {"hsp_loop", "first_arc", "uint32_t", offsetof(hsp_loop, first_arc), 1},
  {"hsp_loop", "arcs", "uint32_t", offsetof(hsp_loop, arcs), 1},
  {"hsp_loop_arc", "arc", "uint32_t", offsetof(hsp_loop_arc, arc), 1},
  {"hsp_loop_arc", "side", "uint32_t", offsetof(hsp_loop_arc, side), 1},
  {"hsp_loop_arc", "vertex", "uint32_t", offsetof(hsp_loop_arc, vertex), 1},
  {"hsp_ball", "faces", "uint32_t", offsetof(hsp_ball, faces), 1},
  {"hsp_ball", "first_face", "uint32_t", offsetof(hsp_ball, first_face), 1},
  {"hsp_ball", "component", "uint32_t", offsetof(hsp_ball, component), 1},
  {"hsp_ball", "flags", "uint32_t", offsetof(hsp_ball, flags), 1},
  {"hsp_totals", "area", "double", offsetof(hsp_totals, area), 1},
  {"hsp_totals", "volume", "double", offsetof(hsp_totals, volume), 1},
  {"hsp_totals", "reserved", "uint64_t", offsetof(hsp_totals, reserved), 2},
  {"hsp_measure_request", "struct_size", "uint32_t", offsetof(hsp_measure_request, struct_size), 1},
  {"hsp_measure_request", "reserved", "uint32_t", offsetof(hsp_measure_request, reserved), 1},
  {"hsp_measure_request", "selected", "uint8_t *", offsetof(hsp_measure_request, selected), 1},
  {"hsp_measure_request", "executor", "hsp_executor *", offsetof(hsp_measure_request, executor), 1},
  {"hsp_measure_outputs", "struct_size", "uint32_t", offsetof(hsp_measure_outputs, struct_size), 1},
  {"hsp_measure_outputs", "capacity", "uint32_t", offsetof(hsp_measure_outputs, capacity), 1},
  {"hsp_measure_outputs", "needed", "uint32_t", offsetof(hsp_measure_outputs, needed), 1},
  {"hsp_measure_outputs", "reserved", "uint32_t", offsetof(hsp_measure_outputs, reserved), 1},
  {"hsp_measure_outputs", "totals", "hsp_totals *", offsetof(hsp_measure_outputs, totals), 1},
  {"hsp_measure_outputs", "area", "double *", offsetof(hsp_measure_outputs, area), 1},
  {"hsp_measure_outputs", "volume_term", "double *", offsetof(hsp_measure_outputs, volume_term), 1},
  {"hsp_energy", "value", "double", offsetof(hsp_energy, value), 1},
  {"hsp_energy", "area", "double", offsetof(hsp_energy, area), 1},
  {"hsp_energy", "volume", "double", offsetof(hsp_energy, volume), 1},
  {"hsp_energy", "d_probe", "double", offsetof(hsp_energy, d_probe), 1},
  {"hsp_energy", "reserved", "uint64_t", offsetof(hsp_energy, reserved), 2},
  {"hsp_gradient_request", "struct_size", "uint32_t", offsetof(hsp_gradient_request, struct_size), 1},
  {"hsp_gradient_request", "tangency", "uint32_t", offsetof(hsp_gradient_request, tangency), 1},
  {"hsp_gradient_request", "tension", "double", offsetof(hsp_gradient_request, tension), 1},
  {"hsp_gradient_request", "pressure", "double", offsetof(hsp_gradient_request, pressure), 1},
  {"hsp_gradient_request", "sigma", "double *", offsetof(hsp_gradient_request, sigma), 1},
  {"hsp_gradient_request", "executor", "hsp_executor *", offsetof(hsp_gradient_request, executor), 1},
  {"hsp_gradient_outputs", "struct_size", "uint32_t", offsetof(hsp_gradient_outputs, struct_size), 1},
  {"hsp_gradient_outputs", "capacity", "uint32_t", offsetof(hsp_gradient_outputs, capacity), 1},
  {"hsp_gradient_outputs", "needed", "uint32_t", offsetof(hsp_gradient_outputs, needed), 1},
  {"hsp_gradient_outputs", "first_bad", "uint32_t", offsetof(hsp_gradient_outputs, first_bad), 1},
  {"hsp_gradient_outputs", "energy", "hsp_energy *", offsetof(hsp_gradient_outputs, energy), 1},
  {"hsp_gradient_outputs", "d_centre", "double *", offsetof(hsp_gradient_outputs, d_centre), 1},
  {"hsp_gradient_outputs", "d_radius", "double *", offsetof(hsp_gradient_outputs, d_radius), 1},
  {"hsp_gradient_outputs", "flags", "uint32_t *", offsetof(hsp_gradient_outputs, flags), 1},
  {"hsp_gradient_outputs", "area", "double *", offsetof(hsp_gradient_outputs, area), 1},
  {"hsp_derivatives_request", "struct_size", "uint32_t", offsetof(hsp_derivatives_request, struct_size), 1},
  {"hsp_derivatives_request", "tangency", "uint32_t", offsetof(hsp_derivatives_request, tangency), 1},
  {"hsp_derivatives_request", "sigma", "double *", offsetof(hsp_derivatives_request, sigma), 1},
  {"hsp_derivatives_request", "executor", "hsp_executor *", offsetof(hsp_derivatives_request, executor), 1},
  {"hsp_derivatives_outputs", "struct_size", "uint32_t", offsetof(hsp_derivatives_outputs, struct_size), 1},
  {"hsp_derivatives_outputs", "capacity", "uint32_t", offsetof(hsp_derivatives_outputs, capacity), 1},
  {"hsp_derivatives_outputs", "needed", "uint32_t", offsetof(hsp_derivatives_outputs, needed), 1},
  {"hsp_derivatives_outputs", "first_bad", "uint32_t", offsetof(hsp_derivatives_outputs, first_bad), 1},
  {"hsp_derivatives_outputs", "area_centre", "double *", offsetof(hsp_derivatives_outputs, area_centre), 1},
  {"hsp_derivatives_outputs", "area_radius", "double *", offsetof(hsp_derivatives_outputs, area_radius), 1},
  {"hsp_derivatives_outputs", "volume_centre", "double *", offsetof(hsp_derivatives_outputs, volume_centre), 1},
  {"hsp_derivatives_outputs", "volume_radius", "double *", offsetof(hsp_derivatives_outputs, volume_radius), 1},
  {"hsp_derivatives_outputs", "flags", "uint32_t *", offsetof(hsp_derivatives_outputs, flags), 1},
  {"hsp_area_derivative", "centre", "double", offsetof(hsp_area_derivative, centre), 3},
  {"hsp_area_derivative", "radius", "double", offsetof(hsp_area_derivative, radius), 1},
  {"hsp_area_derivative", "angle", "double", offsetof(hsp_area_derivative, angle), 1},
  {"hsp_area_derivative", "ball", "uint32_t", offsetof(hsp_area_derivative, ball), 1},
  {"hsp_area_derivative", "flags", "uint32_t", offsetof(hsp_area_derivative, flags), 1},
  {"hsp_moving_limits", "struct_size", "uint32_t", offsetof(hsp_moving_limits, struct_size), 1},
  {"hsp_moving_limits", "balls", "uint32_t", offsetof(hsp_moving_limits, balls), 1},
  {"hsp_moving_limits", "neighbours", "uint32_t", offsetof(hsp_moving_limits, neighbours), 1},
  {"hsp_moving_request", "struct_size", "uint32_t", offsetof(hsp_moving_request, struct_size), 1},
  {"hsp_moving_request", "reserved", "uint32_t", offsetof(hsp_moving_request, reserved), 1},
  {"hsp_moving_request", "executor", "hsp_executor *", offsetof(hsp_moving_request, executor), 1},
  {"hsp_moving_info", "step", "double", offsetof(hsp_moving_info, step), 1},
  {"hsp_moving_info", "probe", "double", offsetof(hsp_moving_info, probe), 1},
  {"hsp_moving_info", "largest_radius", "double", offsetof(hsp_moving_info, largest_radius), 1},
  {"hsp_moving_info", "vertices", "uint64_t", offsetof(hsp_moving_info, vertices), 1},
  {"hsp_moving_info", "arcs", "uint64_t", offsetof(hsp_moving_info, arcs), 1},
  {"hsp_moving_info", "circles", "uint64_t", offsetof(hsp_moving_info, circles), 1},
  {"hsp_moving_info", "faces", "uint64_t", offsetof(hsp_moving_info, faces), 1},
  {"hsp_moving_info", "loops", "uint64_t", offsetof(hsp_moving_info, loops), 1},
  {"hsp_moving_info", "balls", "uint32_t", offsetof(hsp_moving_info, balls), 1},
  {"hsp_moving_info", "exposed_balls", "uint32_t", offsetof(hsp_moving_info, exposed_balls), 1},
  {"hsp_moving_info", "contained_balls", "uint32_t", offsetof(hsp_moving_info, contained_balls), 1},
  {"hsp_moving_info", "components", "uint32_t", offsetof(hsp_moving_info, components), 1},
  {"hsp_moving_info", "changed", "uint32_t", offsetof(hsp_moving_info, changed), 1},
  {"hsp_moving_info", "reserved", "uint32_t", offsetof(hsp_moving_info, reserved), 1},
  {"hsp_moving_ball", "centre", "double", offsetof(hsp_moving_ball, centre), 3},
  {"hsp_moving_ball", "radius", "double", offsetof(hsp_moving_ball, radius), 1},
  {"hsp_moving_ball", "area", "double", offsetof(hsp_moving_ball, area), 1},
  {"hsp_moving_ball", "volume_term", "double", offsetof(hsp_moving_ball, volume_term), 1},
  {"hsp_moving_ball", "d_centre", "double", offsetof(hsp_moving_ball, d_centre), 3},
  {"hsp_moving_ball", "d_radius", "double", offsetof(hsp_moving_ball, d_radius), 1},
  {"hsp_moving_ball", "faces", "uint32_t", offsetof(hsp_moving_ball, faces), 1},
  {"hsp_moving_ball", "flags", "uint32_t", offsetof(hsp_moving_ball, flags), 1},
  {"hsp_moving_ball", "gradient_flags", "uint32_t", offsetof(hsp_moving_ball, gradient_flags), 1},
  {"hsp_moving_ball", "reserved", "uint32_t", offsetof(hsp_moving_ball, reserved), 1},
  {"hsp_curvatures", "mean", "double", offsetof(hsp_curvatures, mean), 1},
  {"hsp_curvatures", "gauss", "double", offsetof(hsp_curvatures, gauss), 1},
  {"hsp_curvature_request", "struct_size", "uint32_t", offsetof(hsp_curvature_request, struct_size), 1},
  {"hsp_curvature_request", "reserved", "uint32_t", offsetof(hsp_curvature_request, reserved), 1},
  {"hsp_curvature_request", "executor", "hsp_executor *", offsetof(hsp_curvature_request, executor), 1},
  {"hsp_morphometry_request", "struct_size", "uint32_t", offsetof(hsp_morphometry_request, struct_size), 1},
  {"hsp_morphometry_request", "reserved", "uint32_t", offsetof(hsp_morphometry_request, reserved), 1},
  {"hsp_morphometry_request", "pressure", "double", offsetof(hsp_morphometry_request, pressure), 1},
  {"hsp_morphometry_request", "tension", "double", offsetof(hsp_morphometry_request, tension), 1},
  {"hsp_morphometry_request", "bending", "double", offsetof(hsp_morphometry_request, bending), 1},
  {"hsp_morphometry_request", "gaussian", "double", offsetof(hsp_morphometry_request, gaussian), 1},
  {"hsp_morphometry_request", "sigma", "double *", offsetof(hsp_morphometry_request, sigma), 1},
  {"hsp_morphometry_request", "executor", "hsp_executor *", offsetof(hsp_morphometry_request, executor), 1},
  {"hsp_morphometric_energy", "value", "double", offsetof(hsp_morphometric_energy, value), 1},
  {"hsp_morphometric_energy", "volume", "double", offsetof(hsp_morphometric_energy, volume), 1},
  {"hsp_morphometric_energy", "area", "double", offsetof(hsp_morphometric_energy, area), 1},
  {"hsp_morphometric_energy", "mean", "double", offsetof(hsp_morphometric_energy, mean), 1},
  {"hsp_morphometric_energy", "gauss", "double", offsetof(hsp_morphometric_energy, gauss), 1},
  {"hsp_morphometric_energy", "d_probe", "double", offsetof(hsp_morphometric_energy, d_probe), 1},
  {"hsp_morphometry_outputs", "struct_size", "uint32_t", offsetof(hsp_morphometry_outputs, struct_size), 1},
  {"hsp_morphometry_outputs", "capacity", "uint32_t", offsetof(hsp_morphometry_outputs, capacity), 1},
  {"hsp_morphometry_outputs", "needed", "uint32_t", offsetof(hsp_morphometry_outputs, needed), 1},
  {"hsp_morphometry_outputs", "first_bad", "uint32_t", offsetof(hsp_morphometry_outputs, first_bad), 1},
  {"hsp_morphometry_outputs", "energy", "hsp_morphometric_energy *", offsetof(hsp_morphometry_outputs, energy), 1},
  {"hsp_morphometry_outputs", "d_centre", "double *", offsetof(hsp_morphometry_outputs, d_centre), 1},
  {"hsp_morphometry_outputs", "d_radius", "double *", offsetof(hsp_morphometry_outputs, d_radius), 1},
  {"hsp_morphometry_outputs", "flags", "uint32_t *", offsetof(hsp_morphometry_outputs, flags), 1},
  {"hsp_morphometry_outputs", "area", "double *", offsetof(hsp_morphometry_outputs, area), 1},
  {"hsp_brick_request", "struct_size", "uint32_t", offsetof(hsp_brick_request, struct_size), 1},
  {"hsp_brick_request", "brick", "uint32_t", offsetof(hsp_brick_request, brick), 1},
  {"hsp_brick_request", "bricks", "uint32_t", offsetof(hsp_brick_request, bricks), 1},
  {"hsp_brick_request", "flags", "uint32_t", offsetof(hsp_brick_request, flags), 1},
  {"hsp_brick_request", "id", "uint64_t *", offsetof(hsp_brick_request, id), 1},
  {"hsp_brick_request", "owner", "uint32_t *", offsetof(hsp_brick_request, owner), 1},
  {"hsp_brick_request", "executor", "hsp_executor *", offsetof(hsp_brick_request, executor), 1},
  {"hsp_brick_totals", "balls", "uint64_t", offsetof(hsp_brick_totals, balls), 1},
  {"hsp_brick_totals", "exposed_balls", "uint64_t", offsetof(hsp_brick_totals, exposed_balls), 1},
  {"hsp_brick_totals", "contained_balls", "uint64_t", offsetof(hsp_brick_totals, contained_balls), 1},
  {"hsp_brick_totals", "vertices", "uint64_t", offsetof(hsp_brick_totals, vertices), 1},
  {"hsp_brick_totals", "arcs", "uint64_t", offsetof(hsp_brick_totals, arcs), 1},
  {"hsp_brick_totals", "circles", "uint64_t", offsetof(hsp_brick_totals, circles), 1},
  {"hsp_brick_totals", "faces", "uint64_t", offsetof(hsp_brick_totals, faces), 1},
  {"hsp_brick_totals", "loops", "uint64_t", offsetof(hsp_brick_totals, loops), 1},
  {"hsp_brick_totals", "shells", "uint64_t", offsetof(hsp_brick_totals, shells), 1},
  {"hsp_brick_totals", "components", "uint64_t", offsetof(hsp_brick_totals, components), 1},
  {"hsp_brick_totals", "voids", "uint64_t", offsetof(hsp_brick_totals, voids), 1},
  {"hsp_brick_totals", "tied_vertices", "uint64_t", offsetof(hsp_brick_totals, tied_vertices), 1},
  {"hsp_brick_totals", "euler", "int64_t", offsetof(hsp_brick_totals, euler), 1},
  {"hsp_brick_totals", "area", "double", offsetof(hsp_brick_totals, area), 1},
  {"hsp_brick_totals", "volume", "double", offsetof(hsp_brick_totals, volume), 1},
  {"hsp_brick_totals", "void_volume", "double", offsetof(hsp_brick_totals, void_volume), 1},
  {"hsp_brick_totals", "reserved", "uint64_t", offsetof(hsp_brick_totals, reserved), 2},
  {"hsp_brick_shell", "component", "uint64_t", offsetof(hsp_brick_shell, component), 1},
  {"hsp_brick_shell", "faces", "uint64_t", offsetof(hsp_brick_shell, faces), 1},
  {"hsp_brick_shell", "euler", "int64_t", offsetof(hsp_brick_shell, euler), 1},
  {"hsp_brick_shell", "area", "double", offsetof(hsp_brick_shell, area), 1},
  {"hsp_brick_shell", "volume", "double", offsetof(hsp_brick_shell, volume), 1},
  {"hsp_brick_shell", "kind", "uint32_t", offsetof(hsp_brick_shell, kind), 1},
  {"hsp_brick_shell", "reserved", "uint32_t", offsetof(hsp_brick_shell, reserved), 3},
  {"hsp_contacts_limits", "struct_size", "uint32_t", offsetof(hsp_contacts_limits, struct_size), 1},
  {"hsp_contacts_limits", "balls", "uint32_t", offsetof(hsp_contacts_limits, balls), 1},
  {"hsp_contacts_limits", "neighbours", "uint32_t", offsetof(hsp_contacts_limits, neighbours), 1},
  {"hsp_contacts_limits", "contacts", "uint32_t", offsetof(hsp_contacts_limits, contacts), 1},
  {"hsp_contacts_limits", "triangles", "uint32_t", offsetof(hsp_contacts_limits, triangles), 1},
  {"hsp_contacts_limits", "tetrahedra", "uint32_t", offsetof(hsp_contacts_limits, tetrahedra), 1},
  {"hsp_contacts_request", "struct_size", "uint32_t", offsetof(hsp_contacts_request, struct_size), 1},
  {"hsp_contacts_request", "reserved", "uint32_t", offsetof(hsp_contacts_request, reserved), 1},
  {"hsp_contacts_request", "executor", "hsp_executor *", offsetof(hsp_contacts_request, executor), 1},
  {"hsp_contact", "area", "double", offsetof(hsp_contact, area), 1},
  {"hsp_contact", "rim", "double", offsetof(hsp_contact, rim), 1},
  {"hsp_contact", "distance", "double", offsetof(hsp_contact, distance), 1},
  {"hsp_contact", "ball", "uint32_t", offsetof(hsp_contact, ball), 2},
  {"hsp_contact", "chords", "uint32_t", offsetof(hsp_contact, chords), 1},
  {"hsp_contact", "flags", "uint32_t", offsetof(hsp_contact, flags), 1},
  {"hsp_contact", "reserved", "uint32_t", offsetof(hsp_contact, reserved), 2},
  {"hsp_group_contact", "area", "double", offsetof(hsp_group_contact, area), 1},
  {"hsp_group_contact", "rim", "double", offsetof(hsp_group_contact, rim), 1},
  {"hsp_group_contact", "group", "uint32_t", offsetof(hsp_group_contact, group), 2},
  {"hsp_group_contact", "contacts", "uint32_t", offsetof(hsp_group_contact, contacts), 1},
  {"hsp_group_contact", "reserved", "uint32_t", offsetof(hsp_group_contact, reserved), 1},
  {"hsp_complex", "singular", "uint32_t", offsetof(hsp_complex, singular), 4},
  {"hsp_complex", "regular", "uint32_t", offsetof(hsp_complex, regular), 4},
  {"hsp_complex", "interior", "uint32_t", offsetof(hsp_complex, interior), 4},
  {"hsp_complex", "euler", "int64_t", offsetof(hsp_complex, euler), 1},
  {"hsp_complex", "betti", "uint32_t", offsetof(hsp_complex, betti), 3},
  {"hsp_complex", "reserved", "uint32_t", offsetof(hsp_complex, reserved), 5},
  {"hsp_simplex", "ball", "uint32_t", offsetof(hsp_simplex, ball), 4},
  {"hsp_simplex", "kind", "uint32_t", offsetof(hsp_simplex, kind), 1},
  {"hsp_simplex", "reserved", "uint32_t", offsetof(hsp_simplex, reserved), 1},
  {"hsp_periodic_limits", "struct_size", "uint32_t", offsetof(hsp_periodic_limits, struct_size), 1},
  {"hsp_periodic_limits", "balls", "uint32_t", offsetof(hsp_periodic_limits, balls), 1},
  {"hsp_periodic_limits", "images", "uint32_t", offsetof(hsp_periodic_limits, images), 1},
  {"hsp_periodic_limits", "neighbours", "uint32_t", offsetof(hsp_periodic_limits, neighbours), 1},
  {"hsp_periodic_limits", "vertices", "uint32_t", offsetof(hsp_periodic_limits, vertices), 1},
  {"hsp_periodic_limits", "circles", "uint32_t", offsetof(hsp_periodic_limits, circles), 1},
  {"hsp_periodic_limits", "contacts", "uint32_t", offsetof(hsp_periodic_limits, contacts), 1},
  {"hsp_periodic_limits", "workers", "uint32_t", offsetof(hsp_periodic_limits, workers), 1},
  {"hsp_periodic_request", "struct_size", "uint32_t", offsetof(hsp_periodic_request, struct_size), 1},
  {"hsp_periodic_request", "areas_alone", "uint32_t", offsetof(hsp_periodic_request, areas_alone), 1},
  {"hsp_periodic_request", "options", "hsp_model_options *", offsetof(hsp_periodic_request, options), 1},
  {"hsp_periodic_request", "executor", "hsp_executor *", offsetof(hsp_periodic_request, executor), 1},
  {"hsp_periodic_counts", "balls", "uint32_t", offsetof(hsp_periodic_counts, balls), 1},
  {"hsp_periodic_counts", "images", "uint32_t", offsetof(hsp_periodic_counts, images), 1},
  {"hsp_periodic_counts", "vertices", "uint32_t", offsetof(hsp_periodic_counts, vertices), 1},
  {"hsp_periodic_counts", "arcs", "uint32_t", offsetof(hsp_periodic_counts, arcs), 1},
  {"hsp_periodic_counts", "circles", "uint32_t", offsetof(hsp_periodic_counts, circles), 1},
  {"hsp_periodic_counts", "loops", "uint32_t", offsetof(hsp_periodic_counts, loops), 1},
  {"hsp_periodic_counts", "faces", "uint32_t", offsetof(hsp_periodic_counts, faces), 1},
  {"hsp_periodic_counts", "shells", "uint32_t", offsetof(hsp_periodic_counts, shells), 1},
  {"hsp_periodic_counts", "components", "uint32_t", offsetof(hsp_periodic_counts, components), 1},
  {"hsp_periodic_counts", "contacts", "uint32_t", offsetof(hsp_periodic_counts, contacts), 1},
  {"hsp_periodic_counts", "euler", "int64_t", offsetof(hsp_periodic_counts, euler), 1},
  {"hsp_periodic_totals", "area", "double", offsetof(hsp_periodic_totals, area), 1},
  {"hsp_periodic_totals", "volume", "double", offsetof(hsp_periodic_totals, volume), 1},
  {"hsp_periodic_totals", "box_volume", "double", offsetof(hsp_periodic_totals, box_volume), 1},
  {"hsp_periodic_totals", "free_volume", "double", offsetof(hsp_periodic_totals, free_volume), 1},
  {"hsp_periodic_totals", "contact_area", "double", offsetof(hsp_periodic_totals, contact_area), 1},
  {"hsp_periodic_morphometry_outputs", "struct_size", "uint32_t", offsetof(hsp_periodic_morphometry_outputs,
      struct_size), 1},
  {"hsp_periodic_morphometry_outputs", "capacity", "uint32_t", offsetof(hsp_periodic_morphometry_outputs, capacity), 1},
  {"hsp_periodic_morphometry_outputs", "needed", "uint32_t", offsetof(hsp_periodic_morphometry_outputs, needed), 1},
  {"hsp_periodic_morphometry_outputs", "first_bad", "uint32_t", offsetof(hsp_periodic_morphometry_outputs, first_bad),
      1},
  {"hsp_periodic_morphometry_outputs", "energy", "hsp_morphometric_energy *", offsetof(hsp_periodic_morphometry_outputs,
      energy), 1},
  {"hsp_periodic_morphometry_outputs", "d_centre", "double *", offsetof(hsp_periodic_morphometry_outputs, d_centre), 1},
  {"hsp_periodic_morphometry_outputs", "d_radius", "double *", offsetof(hsp_periodic_morphometry_outputs, d_radius), 1},
  {"hsp_periodic_morphometry_outputs", "flags", "uint32_t *", offsetof(hsp_periodic_morphometry_outputs, flags), 1},
  {"hsp_periodic_morphometry_outputs", "d_strain", "double *", offsetof(hsp_periodic_morphometry_outputs, d_strain), 1},
  {"hsp_periodic_morphometry_outputs", "d_box", "double *", offsetof(hsp_periodic_morphometry_outputs, d_box), 1},
  {"hsp_periodic_morphometry_outputs", "area", "double *", offsetof(hsp_periodic_morphometry_outputs, area), 1},
  {"hsp_periodic_contact", "area", "double", offsetof(hsp_periodic_contact, area), 1},
  {"hsp_periodic_contact", "rim", "double", offsetof(hsp_periodic_contact, rim), 1},
  {"hsp_periodic_contact", "distance", "double", offsetof(hsp_periodic_contact, distance), 1},
  {"hsp_periodic_contact", "ball", "uint32_t", offsetof(hsp_periodic_contact, ball), 2},
  {"hsp_periodic_contact", "chords", "uint32_t", offsetof(hsp_periodic_contact, chords), 1},
  {"hsp_periodic_contact", "flags", "uint32_t", offsetof(hsp_periodic_contact, flags), 1},
  {"hsp_periodic_contact", "shift", "int32_t", offsetof(hsp_periodic_contact, shift), 3},
  {"hsp_periodic_contact", "reserved", "uint32_t", offsetof(hsp_periodic_contact, reserved), 1},
  {"hsp_winding", "balls", "uint32_t", offsetof(hsp_winding, balls), 1},
  {"hsp_winding", "first", "uint32_t", offsetof(hsp_winding, first), 1},
  {"hsp_winding", "directions", "uint32_t", offsetof(hsp_winding, directions), 1},
  {"hsp_winding", "copies", "uint32_t", offsetof(hsp_winding, copies), 1},
  {"hsp_winding", "row", "int32_t", offsetof(hsp_winding, row), 9},
  {"hsp_periodic_gradient_outputs", "struct_size", "uint32_t", offsetof(hsp_periodic_gradient_outputs, struct_size), 1},
  {"hsp_periodic_gradient_outputs", "capacity", "uint32_t", offsetof(hsp_periodic_gradient_outputs, capacity), 1},
  {"hsp_periodic_gradient_outputs", "needed", "uint32_t", offsetof(hsp_periodic_gradient_outputs, needed), 1},
  {"hsp_periodic_gradient_outputs", "first_bad", "uint32_t", offsetof(hsp_periodic_gradient_outputs, first_bad), 1},
  {"hsp_periodic_gradient_outputs", "energy", "hsp_energy *", offsetof(hsp_periodic_gradient_outputs, energy), 1},
  {"hsp_periodic_gradient_outputs", "d_centre", "double *", offsetof(hsp_periodic_gradient_outputs, d_centre), 1},
  {"hsp_periodic_gradient_outputs", "d_radius", "double *", offsetof(hsp_periodic_gradient_outputs, d_radius), 1},
  {"hsp_periodic_gradient_outputs", "flags", "uint32_t *", offsetof(hsp_periodic_gradient_outputs, flags), 1},
  {"hsp_periodic_gradient_outputs", "d_strain", "double *", offsetof(hsp_periodic_gradient_outputs, d_strain), 1},
  {"hsp_periodic_gradient_outputs", "d_box", "double *", offsetof(hsp_periodic_gradient_outputs, d_box), 1},
  {"hsp_periodic_gradient_outputs", "area", "double *", offsetof(hsp_periodic_gradient_outputs, area), 1},
  {"hsp_image", "ball", "uint32_t", offsetof(hsp_image, ball), 1},
  {"hsp_image", "shift", "int32_t", offsetof(hsp_image, shift), 3},
  {"hsp_periodic_id", "id", "uint32_t", offsetof(hsp_periodic_id, id), 1},
  {"hsp_periodic_id", "shift", "int32_t", offsetof(hsp_periodic_id, shift), 3},
  {"hsp_periodic_vertex", "xyz", "double", offsetof(hsp_periodic_vertex, xyz), 3},
  {"hsp_periodic_vertex", "image", "hsp_image", offsetof(hsp_periodic_vertex, image), 3},
  {"hsp_periodic_vertex", "sign", "int32_t", offsetof(hsp_periodic_vertex, sign), 1},
  {"hsp_periodic_vertex", "flags", "uint32_t", offsetof(hsp_periodic_vertex, flags), 1},
  {"hsp_periodic_arc", "centre", "double", offsetof(hsp_periodic_arc, centre), 3},
  {"hsp_periodic_arc", "axis", "double", offsetof(hsp_periodic_arc, axis), 3},
  {"hsp_periodic_arc", "radius", "double", offsetof(hsp_periodic_arc, radius), 1},
  {"hsp_periodic_arc", "angle", "double", offsetof(hsp_periodic_arc, angle), 1},
  {"hsp_periodic_arc", "image", "hsp_image", offsetof(hsp_periodic_arc, image), 2},
  {"hsp_periodic_arc", "vertex", "hsp_periodic_id", offsetof(hsp_periodic_arc, vertex), 2},
  {"hsp_periodic_arc", "face", "hsp_periodic_id", offsetof(hsp_periodic_arc, face), 2},
  {"hsp_periodic_circle", "centre", "double", offsetof(hsp_periodic_circle, centre), 3},
  {"hsp_periodic_circle", "axis", "double", offsetof(hsp_periodic_circle, axis), 3},
  {"hsp_periodic_circle", "radius", "double", offsetof(hsp_periodic_circle, radius), 1},
  {"hsp_periodic_circle", "image", "hsp_image", offsetof(hsp_periodic_circle, image), 2},
  {"hsp_periodic_circle", "face", "hsp_periodic_id", offsetof(hsp_periodic_circle, face), 2},
  {"hsp_periodic_face", "image", "hsp_image", offsetof(hsp_periodic_face, image), 1},
  {"hsp_periodic_face", "loops", "uint32_t", offsetof(hsp_periodic_face, loops), 1},
  {"hsp_periodic_face", "shell", "uint32_t", offsetof(hsp_periodic_face, shell), 1},
  {"hsp_periodic_face", "first_loop", "uint32_t", offsetof(hsp_periodic_face, first_loop), 1},
  {"hsp_periodic_face", "reserved", "uint32_t", offsetof(hsp_periodic_face, reserved), 1},
  {"hsp_periodic_loop", "circle", "hsp_periodic_id", offsetof(hsp_periodic_loop, circle), 1},
  {"hsp_periodic_loop", "face", "uint32_t", offsetof(hsp_periodic_loop, face), 1},
  {"hsp_periodic_loop", "side", "uint32_t", offsetof(hsp_periodic_loop, side), 1},
  {"hsp_periodic_loop", "first_arc", "uint32_t", offsetof(hsp_periodic_loop, first_arc), 1},
  {"hsp_periodic_loop", "arcs", "uint32_t", offsetof(hsp_periodic_loop, arcs), 1},
  {"hsp_periodic_loop_arc", "arc", "hsp_periodic_id", offsetof(hsp_periodic_loop_arc, arc), 1},
  {"hsp_periodic_loop_arc", "vertex", "hsp_periodic_id", offsetof(hsp_periodic_loop_arc, vertex), 1},
  {"hsp_periodic_loop_arc", "side", "uint32_t", offsetof(hsp_periodic_loop_arc, side), 1},
  {"hsp_periodic_loop_arc", "reserved", "uint32_t", offsetof(hsp_periodic_loop_arc, reserved), 1},
  {"hsp_surface_limits", "struct_size", "uint32_t", offsetof(hsp_surface_limits, struct_size), 1},
  {"hsp_surface_limits", "vertices", "uint32_t", offsetof(hsp_surface_limits, vertices), 1},
  {"hsp_surface_limits", "faces", "uint32_t", offsetof(hsp_surface_limits, faces), 1},
  {"hsp_surface_limits", "neighbours", "uint32_t", offsetof(hsp_surface_limits, neighbours), 1},
  {"hsp_surface_limits", "pieces", "uint32_t", offsetof(hsp_surface_limits, pieces), 1},
  {"hsp_surface_limits", "arcs", "uint32_t", offsetof(hsp_surface_limits, arcs), 1},
  {"hsp_surface_limits", "cusped_circles", "uint32_t", offsetof(hsp_surface_limits, cusped_circles), 1},
  {"hsp_surface_request", "struct_size", "uint32_t", offsetof(hsp_surface_request, struct_size), 1},
  {"hsp_surface_request", "count", "uint32_t", offsetof(hsp_surface_request, count), 1},
  {"hsp_surface_request", "executor", "hsp_executor *", offsetof(hsp_surface_request, executor), 1},
  {"hsp_surface_request", "shells", "uint32_t *", offsetof(hsp_surface_request, shells), 1},
  {"hsp_surface_counts", "convex_patches", "uint32_t", offsetof(hsp_surface_counts, convex_patches), 1},
  {"hsp_surface_counts", "saddle_patches", "uint32_t", offsetof(hsp_surface_counts, saddle_patches), 1},
  {"hsp_surface_counts", "concave_patches", "uint32_t", offsetof(hsp_surface_counts, concave_patches), 1},
  {"hsp_surface_counts", "cusped_patches", "uint32_t", offsetof(hsp_surface_counts, cusped_patches), 1},
  {"hsp_surface_counts", "cut_patches", "uint32_t", offsetof(hsp_surface_counts, cut_patches), 1},
  {"hsp_surface_counts", "hidden_patches", "uint32_t", offsetof(hsp_surface_counts, hidden_patches), 1},
  {"hsp_surface_counts", "rounded_patches", "uint32_t", offsetof(hsp_surface_counts, rounded_patches), 1},
  {"hsp_surface_counts", "open_joints", "uint32_t", offsetof(hsp_surface_counts, open_joints), 1},
  {"hsp_surface_totals", "area", "double", offsetof(hsp_surface_totals, area), 1},
  {"hsp_surface_totals", "volume", "double", offsetof(hsp_surface_totals, volume), 1},
  {"hsp_surface_totals", "convex_area", "double", offsetof(hsp_surface_totals, convex_area), 1},
  {"hsp_surface_totals", "saddle_area", "double", offsetof(hsp_surface_totals, saddle_area), 1},
  {"hsp_surface_totals", "concave_area", "double", offsetof(hsp_surface_totals, concave_area), 1},
  {"hsp_surface_measure_request", "struct_size", "uint32_t", offsetof(hsp_surface_measure_request, struct_size), 1},
  {"hsp_surface_measure_request", "reserved", "uint32_t", offsetof(hsp_surface_measure_request, reserved), 1},
  {"hsp_surface_measure_request", "executor", "hsp_executor *", offsetof(hsp_surface_measure_request, executor), 1},
  {"hsp_surface_part_counts", "patches", "uint32_t", offsetof(hsp_surface_part_counts, patches), 1},
  {"hsp_surface_part_counts", "edges", "uint32_t", offsetof(hsp_surface_part_counts, edges), 1},
  {"hsp_surface_part_counts", "corners", "uint32_t", offsetof(hsp_surface_part_counts, corners), 1},
  {"hsp_surface_part_counts", "shells", "uint32_t", offsetof(hsp_surface_part_counts, shells), 1},
  {"hsp_surface_part_counts", "cusps", "uint32_t", offsetof(hsp_surface_part_counts, cusps), 1},
  {"hsp_surface_part_counts", "junctions", "uint32_t", offsetof(hsp_surface_part_counts, junctions), 1},
  {"hsp_surface_part_counts", "creases", "uint32_t", offsetof(hsp_surface_part_counts, creases), 1},
  {"hsp_surface_part_counts", "reserved", "uint32_t", offsetof(hsp_surface_part_counts, reserved), 1},
  {"hsp_surface_patch", "area", "double", offsetof(hsp_surface_patch, area), 1},
  {"hsp_surface_patch", "kind", "uint32_t", offsetof(hsp_surface_patch, kind), 1},
  {"hsp_surface_patch", "source", "uint32_t", offsetof(hsp_surface_patch, source), 1},
  {"hsp_surface_patch", "part", "uint32_t", offsetof(hsp_surface_patch, part), 1},
  {"hsp_surface_patch", "shell", "uint32_t", offsetof(hsp_surface_patch, shell), 1},
  {"hsp_surface_patch", "loops", "uint32_t", offsetof(hsp_surface_patch, loops), 1},
  {"hsp_surface_patch", "edges", "uint32_t", offsetof(hsp_surface_patch, edges), 1},
  {"hsp_surface_patch", "h", "uint32_t", offsetof(hsp_surface_patch, h), 1},
  {"hsp_surface_patch", "reserved", "uint32_t", offsetof(hsp_surface_patch, reserved), 1},
  {"hsp_surface_edge", "centre", "double", offsetof(hsp_surface_edge, centre), 3},
  {"hsp_surface_edge", "axis", "double", offsetof(hsp_surface_edge, axis), 3},
  {"hsp_surface_edge", "radius", "double", offsetof(hsp_surface_edge, radius), 1},
  {"hsp_surface_edge", "angle", "double", offsetof(hsp_surface_edge, angle), 1},
  {"hsp_surface_edge", "patch", "uint32_t", offsetof(hsp_surface_edge, patch), 2},
  {"hsp_surface_edge", "corner", "uint32_t", offsetof(hsp_surface_edge, corner), 2},
  {"hsp_surface_edge", "next", "uint32_t", offsetof(hsp_surface_edge, next), 2},
  {"hsp_surface_edge", "previous", "uint32_t", offsetof(hsp_surface_edge, previous), 2},
  {"hsp_surface_edge", "kind", "uint32_t", offsetof(hsp_surface_edge, kind), 1},
  {"hsp_surface_edge", "source", "uint32_t", offsetof(hsp_surface_edge, source), 1},
  {"hsp_surface_corner", "xyz", "double", offsetof(hsp_surface_corner, xyz), 3},
  {"hsp_surface_corner", "kind", "uint32_t", offsetof(hsp_surface_corner, kind), 1},
  {"hsp_surface_corner", "ball", "uint32_t", offsetof(hsp_surface_corner, ball), 2},
  {"hsp_surface_corner", "vertex", "uint32_t", offsetof(hsp_surface_corner, vertex), 3},
  {"hsp_surface_corner", "shell", "uint32_t", offsetof(hsp_surface_corner, shell), 1},
  {"hsp_surface_corner", "reserved", "uint32_t", offsetof(hsp_surface_corner, reserved), 1},
  {"hsp_surface_shell", "area", "double", offsetof(hsp_surface_shell, area), 1},
  {"hsp_surface_shell", "volume", "double", offsetof(hsp_surface_shell, volume), 1},
  {"hsp_surface_shell", "euler", "int64_t", offsetof(hsp_surface_shell, euler), 1},
  {"hsp_surface_shell", "genus", "uint32_t", offsetof(hsp_surface_shell, genus), 1},
  {"hsp_surface_shell", "patches", "uint32_t", offsetof(hsp_surface_shell, patches), 1},
  {"hsp_surface_shell", "chosen", "uint32_t", offsetof(hsp_surface_shell, chosen), 1},
  {"hsp_surface_shell", "reserved", "uint32_t", offsetof(hsp_surface_shell, reserved), 1},
  {"hsp_mesh_limits", "struct_size", "uint32_t", offsetof(hsp_mesh_limits, struct_size), 1},
  {"hsp_mesh_limits", "balls", "uint32_t", offsetof(hsp_mesh_limits, balls), 1},
  {"hsp_mesh_limits", "curves", "uint32_t", offsetof(hsp_mesh_limits, curves), 1},
  {"hsp_mesh_limits", "vertices", "uint32_t", offsetof(hsp_mesh_limits, vertices), 1},
  {"hsp_mesh_limits", "triangles", "uint32_t", offsetof(hsp_mesh_limits, triangles), 1},
  {"hsp_mesh_limits", "points", "uint32_t", offsetof(hsp_mesh_limits, points), 1},
  {"hsp_mesh_request", "struct_size", "uint32_t", offsetof(hsp_mesh_request, struct_size), 1},
  {"hsp_mesh_request", "reserved", "uint32_t", offsetof(hsp_mesh_request, reserved), 1},
  {"hsp_mesh_request", "executor", "hsp_executor *", offsetof(hsp_mesh_request, executor), 1},
  {"hsp_mesh_counts", "vertices", "uint32_t", offsetof(hsp_mesh_counts, vertices), 1},
  {"hsp_mesh_counts", "triangles", "uint32_t", offsetof(hsp_mesh_counts, triangles), 1},
  {"hsp_mesh_counts", "curves", "uint32_t", offsetof(hsp_mesh_counts, curves), 1},
  {"hsp_mesh_counts", "refined", "uint32_t", offsetof(hsp_mesh_counts, refined), 1},
  {"hsp_topology_limits", "struct_size", "uint32_t", offsetof(hsp_topology_limits, struct_size), 1},
  {"hsp_topology_limits", "balls", "uint32_t", offsetof(hsp_topology_limits, balls), 1},
  {"hsp_topology_limits", "neighbours", "uint32_t", offsetof(hsp_topology_limits, neighbours), 1},
  {"hsp_topology_limits", "edges", "uint32_t", offsetof(hsp_topology_limits, edges), 1},
  {"hsp_topology_limits", "cut_arcs", "uint32_t", offsetof(hsp_topology_limits, cut_arcs), 1},
  {"hsp_topology_limits", "shells", "uint32_t", offsetof(hsp_topology_limits, shells), 1},
  {"hsp_topology_request", "struct_size", "uint32_t", offsetof(hsp_topology_request, struct_size), 1},
  {"hsp_topology_request", "reserved", "uint32_t", offsetof(hsp_topology_request, reserved), 1},
  {"hsp_topology_request", "executor", "hsp_executor *", offsetof(hsp_topology_request, executor), 1},
  {"hsp_topology_counts", "vertices", "uint32_t", offsetof(hsp_topology_counts, vertices), 1},
  {"hsp_topology_counts", "edges", "uint32_t", offsetof(hsp_topology_counts, edges), 1},
  {"hsp_topology_counts", "simple_faces", "uint32_t", offsetof(hsp_topology_counts, simple_faces), 1},
  {"hsp_topology_counts", "cut_edges", "uint32_t", offsetof(hsp_topology_counts, cut_edges), 1},
  {"hsp_topology_counts", "shells", "uint32_t", offsetof(hsp_topology_counts, shells), 1},
  {"hsp_topology_counts", "components", "uint32_t", offsetof(hsp_topology_counts, components), 1},
  {"hsp_topology_counts", "regions", "uint32_t", offsetof(hsp_topology_counts, regions), 1},
  {"hsp_topology_counts", "start_face", "uint32_t", offsetof(hsp_topology_counts, start_face), 1},
  {"hsp_topology_counts", "reserved", "uint32_t", offsetof(hsp_topology_counts, reserved), 4},
  {"hsp_shell", "area", "double", offsetof(hsp_shell, area), 1},
  {"hsp_shell", "volume", "double", offsetof(hsp_shell, volume), 1},
  {"hsp_shell", "point", "double", offsetof(hsp_shell, point), 3},
  {"hsp_shell", "euler", "int64_t", offsetof(hsp_shell, euler), 1},
  {"hsp_shell", "genus", "uint32_t", offsetof(hsp_shell, genus), 1},
  {"hsp_shell", "kind", "uint32_t", offsetof(hsp_shell, kind), 1},
  {"hsp_shell", "component", "uint32_t", offsetof(hsp_shell, component), 1},
  {"hsp_shell", "region", "uint32_t", offsetof(hsp_shell, region), 1},
  {"hsp_shell", "faces", "uint32_t", offsetof(hsp_shell, faces), 1},
  {"hsp_shell", "simple_faces", "uint32_t", offsetof(hsp_shell, simple_faces), 1},
  {"hsp_shell", "edges", "uint32_t", offsetof(hsp_shell, edges), 1},
  {"hsp_shell", "vertices", "uint32_t", offsetof(hsp_shell, vertices), 1},
  {"hsp_shell", "start_face", "uint32_t", offsetof(hsp_shell, start_face), 1},
  {"hsp_shell", "reserved", "uint32_t", offsetof(hsp_shell, reserved), 1},
  {"hsp_component", "balls", "uint32_t", offsetof(hsp_component, balls), 1},
  {"hsp_component", "top_ball", "uint32_t", offsetof(hsp_component, top_ball), 1},
  {"hsp_component", "outer_shell", "uint32_t", offsetof(hsp_component, outer_shell), 1},
  {"hsp_component", "shells", "uint32_t", offsetof(hsp_component, shells), 1},
  {"hsp_component", "region", "uint32_t", offsetof(hsp_component, region), 1},
  {"hsp_component", "reserved", "uint32_t", offsetof(hsp_component, reserved), 1},
  {"hsp_region", "area", "double", offsetof(hsp_region, area), 1},
  {"hsp_region", "volume", "double", offsetof(hsp_region, volume), 1},
  {"hsp_region", "enclosing_shell", "uint32_t", offsetof(hsp_region, enclosing_shell), 1},
  {"hsp_region", "components", "uint32_t", offsetof(hsp_region, components), 1},
  {"hsp_region", "shells", "uint32_t", offsetof(hsp_region, shells), 1},
  {"hsp_region", "reserved", "uint32_t", offsetof(hsp_region, reserved), 1},
  {"hsp_topology_vertex", "xyz", "double", offsetof(hsp_topology_vertex, xyz), 3},
  {"hsp_topology_vertex", "ball", "uint32_t", offsetof(hsp_topology_vertex, ball), 3},
  {"hsp_topology_vertex", "kind", "uint32_t", offsetof(hsp_topology_vertex, kind), 1},
  {"hsp_topology_vertex", "q", "uint32_t", offsetof(hsp_topology_vertex, q), 1},
  {"hsp_topology_vertex", "reserved", "uint32_t", offsetof(hsp_topology_vertex, reserved), 1},
  {"hsp_topology_edge", "centre", "double", offsetof(hsp_topology_edge, centre), 3},
  {"hsp_topology_edge", "axis", "double", offsetof(hsp_topology_edge, axis), 3},
  {"hsp_topology_edge", "radius", "double", offsetof(hsp_topology_edge, radius), 1},
  {"hsp_topology_edge", "angle", "double", offsetof(hsp_topology_edge, angle), 1},
  {"hsp_topology_edge", "vertex", "uint32_t", offsetof(hsp_topology_edge, vertex), 2},
  {"hsp_topology_edge", "face", "uint32_t", offsetof(hsp_topology_edge, face), 2},
  {"hsp_topology_edge", "ball", "uint32_t", offsetof(hsp_topology_edge, ball), 2},
  {"hsp_topology_edge", "kind", "uint32_t", offsetof(hsp_topology_edge, kind), 1},
  {"hsp_topology_edge", "source", "uint32_t", offsetof(hsp_topology_edge, source), 1},
  {"hsp_simple_face", "ball", "uint32_t", offsetof(hsp_simple_face, ball), 1},
  {"hsp_simple_face", "face", "uint32_t", offsetof(hsp_simple_face, face), 1},
  {"hsp_simple_face", "edges", "uint32_t", offsetof(hsp_simple_face, edges), 1},
  {"hsp_simple_face", "q", "uint32_t", offsetof(hsp_simple_face, q), 1},
  {"hsp_simple_face", "shell", "uint32_t", offsetof(hsp_simple_face, shell), 1},
  {"hsp_simple_face", "reserved", "uint32_t", offsetof(hsp_simple_face, reserved), 1},
  {"hsp_cells_limits", "struct_size", "uint32_t", offsetof(hsp_cells_limits, struct_size), 1},
  {"hsp_cells_limits", "cubes", "uint32_t", offsetof(hsp_cells_limits, cubes), 1},
  {"hsp_cells_limits", "entries", "uint32_t", offsetof(hsp_cells_limits, entries), 1},
  {"hsp_cells_limits", "cells", "uint32_t", offsetof(hsp_cells_limits, cells), 1},
  {"hsp_cells_limits", "adjacencies", "uint32_t", offsetof(hsp_cells_limits, adjacencies), 1},
  {"hsp_cells_limits", "landmarks", "uint32_t", offsetof(hsp_cells_limits, landmarks), 1},
  {"hsp_cells_limits", "facets", "uint32_t", offsetof(hsp_cells_limits, facets), 1},
  {"hsp_cells_limits", "corners", "uint32_t", offsetof(hsp_cells_limits, corners), 1},
  {"hsp_cells_limits", "cube_balls", "uint32_t", offsetof(hsp_cells_limits, cube_balls), 1},
  {"hsp_cells_limits", "cube_corners", "uint32_t", offsetof(hsp_cells_limits, cube_corners), 1},
  {"hsp_cells_request", "struct_size", "uint32_t", offsetof(hsp_cells_request, struct_size), 1},
  {"hsp_cells_request", "reserved", "uint32_t", offsetof(hsp_cells_request, reserved), 1},
  {"hsp_cells_request", "executor", "hsp_executor *", offsetof(hsp_cells_request, executor), 1},
  {"hsp_cells_counts", "cubes", "uint32_t", offsetof(hsp_cells_counts, cubes), 1},
  {"hsp_cells_counts", "power_cells", "uint32_t", offsetof(hsp_cells_counts, power_cells), 1},
  {"hsp_cells_counts", "cells", "uint32_t", offsetof(hsp_cells_counts, cells), 1},
  {"hsp_cells_counts", "runs", "uint32_t", offsetof(hsp_cells_counts, runs), 1},
  {"hsp_cells_counts", "adjacencies", "uint32_t", offsetof(hsp_cells_counts, adjacencies), 1},
  {"hsp_cells_counts", "regions", "uint32_t", offsetof(hsp_cells_counts, regions), 1},
  {"hsp_free_cell", "low", "double", offsetof(hsp_free_cell, low), 3},
  {"hsp_free_cell", "high", "double", offsetof(hsp_free_cell, high), 3},
  {"hsp_free_cell", "ball", "uint32_t", offsetof(hsp_free_cell, ball), 1},
  {"hsp_free_cell", "cube", "uint32_t", offsetof(hsp_free_cell, cube), 1},
  {"hsp_free_cell", "kind", "uint32_t", offsetof(hsp_free_cell, kind), 1},
  {"hsp_free_cell", "region", "uint32_t", offsetof(hsp_free_cell, region), 1},
  {"hsp_free_cell", "neighbours", "uint32_t", offsetof(hsp_free_cell, neighbours), 1},
  {"hsp_free_cell", "reserved", "uint32_t", offsetof(hsp_free_cell, reserved), 1},
  {"hsp_cell_pair", "cell", "uint32_t", offsetof(hsp_cell_pair, cell), 2},
  {"hsp_arrangement", "vertices", "uint64_t", offsetof(hsp_arrangement, vertices), 1},
  {"hsp_arrangement", "edges", "uint64_t", offsetof(hsp_arrangement, edges), 1},
  {"hsp_arrangement", "faces", "uint64_t", offsetof(hsp_arrangement, faces), 1},
  {"hsp_paths_limits", "struct_size", "uint32_t", offsetof(hsp_paths_limits, struct_size), 1},
  {"hsp_paths_limits", "cubes", "uint32_t", offsetof(hsp_paths_limits, cubes), 1},
  {"hsp_paths_limits", "entries", "uint32_t", offsetof(hsp_paths_limits, entries), 1},
  {"hsp_paths_limits", "cells", "uint32_t", offsetof(hsp_paths_limits, cells), 1},
  {"hsp_paths_limits", "adjacencies", "uint32_t", offsetof(hsp_paths_limits, adjacencies), 1},
  {"hsp_paths_limits", "landmarks", "uint32_t", offsetof(hsp_paths_limits, landmarks), 1},
  {"hsp_paths_limits", "facets", "uint32_t", offsetof(hsp_paths_limits, facets), 1},
  {"hsp_paths_limits", "corners", "uint32_t", offsetof(hsp_paths_limits, corners), 1},
  {"hsp_paths_limits", "cube_balls", "uint32_t", offsetof(hsp_paths_limits, cube_balls), 1},
  {"hsp_paths_limits", "cube_corners", "uint32_t", offsetof(hsp_paths_limits, cube_corners), 1},
  {"hsp_paths_limits", "points", "uint32_t", offsetof(hsp_paths_limits, points), 1},
  {"hsp_paths_request", "struct_size", "uint32_t", offsetof(hsp_paths_request, struct_size), 1},
  {"hsp_paths_request", "reserved", "uint32_t", offsetof(hsp_paths_request, reserved), 1},
  {"hsp_paths_request", "executor", "hsp_executor *", offsetof(hsp_paths_request, executor), 1},
  {"hsp_path", "length", "double", offsetof(hsp_path, length), 1},
  {"hsp_path", "clearance", "double", offsetof(hsp_path, clearance), 1},
  {"hsp_path", "ends", "uint32_t", offsetof(hsp_path, ends), 1},
  {"hsp_path", "certified", "uint32_t", offsetof(hsp_path, certified), 1},
  {"hsp_path", "points", "uint32_t", offsetof(hsp_path, points), 1},
  {"hsp_path", "reserved", "uint32_t", offsetof(hsp_path, reserved), 1},
  {"hsp_pores_limits", "struct_size", "uint32_t", offsetof(hsp_pores_limits, struct_size), 1},
  {"hsp_pores_limits", "balls", "uint32_t", offsetof(hsp_pores_limits, balls), 1},
  {"hsp_pores_limits", "maxima", "uint32_t", offsetof(hsp_pores_limits, maxima), 1},
  {"hsp_pores_limits", "gates", "uint32_t", offsetof(hsp_pores_limits, gates), 1},
  {"hsp_pores_limits", "tied", "uint32_t", offsetof(hsp_pores_limits, tied), 1},
  {"hsp_pores_limits", "candidates", "uint32_t", offsetof(hsp_pores_limits, candidates), 1},
  {"hsp_pores_limits", "neighbours", "uint32_t", offsetof(hsp_pores_limits, neighbours), 1},
  {"hsp_pores_limits", "points", "uint32_t", offsetof(hsp_pores_limits, points), 1},
  {"hsp_pores_options", "struct_size", "uint32_t", offsetof(hsp_pores_options, struct_size), 1},
  {"hsp_pores_options", "reserved", "uint32_t", offsetof(hsp_pores_options, reserved), 1},
  {"hsp_pores_options", "floor", "double", offsetof(hsp_pores_options, floor), 1},
  {"hsp_pores_options", "executor", "hsp_executor *", offsetof(hsp_pores_options, executor), 1},
  {"hsp_pores_options", "before", "hsp_pores *", offsetof(hsp_pores_options, before), 1},
  {"hsp_pores_counts", "maxima", "uint32_t", offsetof(hsp_pores_counts, maxima), 1},
  {"hsp_pores_counts", "gates", "uint32_t", offsetof(hsp_pores_counts, gates), 1},
  {"hsp_pores_counts", "merges", "uint32_t", offsetof(hsp_pores_counts, merges), 1},
  {"hsp_pores_counts", "cavities", "uint32_t", offsetof(hsp_pores_counts, cavities), 1},
  {"hsp_pores_counts", "outer_balls", "uint32_t", offsetof(hsp_pores_counts, outer_balls), 1},
  {"hsp_pores_counts", "reserved", "uint32_t", offsetof(hsp_pores_counts, reserved), 1},
  {"hsp_pore_maximum", "xyz", "double", offsetof(hsp_pore_maximum, xyz), 3},
  {"hsp_pore_maximum", "radius", "double", offsetof(hsp_pore_maximum, radius), 1},
  {"hsp_pore_maximum", "death", "double", offsetof(hsp_pore_maximum, death), 1},
  {"hsp_pore_maximum", "ball", "uint32_t", offsetof(hsp_pore_maximum, ball), 4},
  {"hsp_pore_maximum", "gate", "uint32_t", offsetof(hsp_pore_maximum, gate), 1},
  {"hsp_pore_maximum", "parent", "uint32_t", offsetof(hsp_pore_maximum, parent), 1},
  {"hsp_pore_gate", "xyz", "double", offsetof(hsp_pore_gate, xyz), 3},
  {"hsp_pore_gate", "radius", "double", offsetof(hsp_pore_gate, radius), 1},
  {"hsp_pore_gate", "ball", "uint32_t", offsetof(hsp_pore_gate, ball), 3},
  {"hsp_pore_gate", "end", "uint32_t", offsetof(hsp_pore_gate, end), 2},
  {"hsp_pore_gate", "merges", "uint32_t", offsetof(hsp_pore_gate, merges), 1},
  {"hsp_pore_gate_shifts", "ball", "int32_t", offsetof(hsp_pore_gate_shifts, ball), 9},
  {"hsp_pore_gate_shifts", "end", "int32_t", offsetof(hsp_pore_gate_shifts, end), 6},
  {"hsp_pore_gate_shifts", "winds", "uint32_t", offsetof(hsp_pore_gate_shifts, winds), 1},
  {"hsp_pore_gate_shifts", "directions", "uint32_t", offsetof(hsp_pore_gate_shifts, directions), 1},
  {"hsp_pore_percolation", "largest", "double", offsetof(hsp_pore_percolation, largest), 1},
  {"hsp_pore_percolation", "through", "double", offsetof(hsp_pore_percolation, through), 3},
  {"hsp_pore_percolation", "included", "double", offsetof(hsp_pore_percolation, included), 3},
  {"hsp_pore_percolation", "along", "double", offsetof(hsp_pore_percolation, along), 3},
  {"hsp_pore_percolation", "gate", "uint32_t", offsetof(hsp_pore_percolation, gate), 3},
  {"hsp_pore_percolation", "maximum", "uint32_t", offsetof(hsp_pore_percolation, maximum), 3},
  {"hsp_pore_percolation", "gate_along", "uint32_t", offsetof(hsp_pore_percolation, gate_along), 3},
  {"hsp_pore_percolation", "reserved", "uint32_t", offsetof(hsp_pore_percolation, reserved), 1},
  {"hsp_pore_channel", "radius", "double", offsetof(hsp_pore_channel, radius), 1},
  {"hsp_pore_channel", "maximum", "uint32_t", offsetof(hsp_pore_channel, maximum), 1},
  {"hsp_pore_channel", "maxima", "uint32_t", offsetof(hsp_pore_channel, maxima), 1},
  {"hsp_pore_channel", "directions", "uint32_t", offsetof(hsp_pore_channel, directions), 1},
  {"hsp_pore_channel", "copies", "uint32_t", offsetof(hsp_pore_channel, copies), 1},
  {"hsp_pore_channel", "row", "int32_t", offsetof(hsp_pore_channel, row), 9},
  {"hsp_pore_channel", "reserved", "uint32_t", offsetof(hsp_pore_channel, reserved), 1},
  {"hsp_pore_place", "radius", "double", offsetof(hsp_pore_place, radius), 1},
  {"hsp_pore_place", "ball", "uint32_t", offsetof(hsp_pore_place, ball), 1},
  {"hsp_pore_place", "maximum", "uint32_t", offsetof(hsp_pore_place, maximum), 1},
  {"hsp_pore_place_shifts", "ball", "int32_t", offsetof(hsp_pore_place_shifts, ball), 3},
  {"hsp_pore_place_shifts", "maximum", "int32_t", offsetof(hsp_pore_place_shifts, maximum), 3},
  {"hsp_pore_passage", "radius", "double", offsetof(hsp_pore_passage, radius), 1},
  {"hsp_pore_passage", "passes", "uint32_t", offsetof(hsp_pore_passage, passes), 1},
  {"hsp_pore_passage", "gate", "uint32_t", offsetof(hsp_pore_passage, gate), 1},
  {"hsp_pore_passage", "ball", "uint32_t", offsetof(hsp_pore_passage, ball), 1},
  {"hsp_pore_passage", "at", "uint32_t", offsetof(hsp_pore_passage, at), 2},
  {"hsp_pore_passage", "reserved", "uint32_t", offsetof(hsp_pore_passage, reserved), 1},
  {"hsp_tunnel", "radius", "double", offsetof(hsp_tunnel, radius), 1},
  {"hsp_tunnel", "length", "double", offsetof(hsp_tunnel, length), 1},
  {"hsp_tunnel", "there", "uint32_t", offsetof(hsp_tunnel, there), 1},
  {"hsp_tunnel", "gate", "uint32_t", offsetof(hsp_tunnel, gate), 1},
  {"hsp_tunnel", "gates", "uint32_t", offsetof(hsp_tunnel, gates), 1},
  {"hsp_tunnel", "points", "uint32_t", offsetof(hsp_tunnel, points), 1},
  {"hsp_tunnel", "outside", "uint32_t", offsetof(hsp_tunnel, outside), 1},
  {"hsp_tunnel", "reserved", "uint32_t", offsetof(hsp_tunnel, reserved), 1},
  {"hsp_tunnel_request", "struct_size", "uint32_t", offsetof(hsp_tunnel_request, struct_size), 1},
  {"hsp_tunnel_request", "cheapest", "uint32_t", offsetof(hsp_tunnel_request, cheapest), 1},
  {"hsp_tunnel_request", "executor", "hsp_executor *", offsetof(hsp_tunnel_request, executor), 1},
  {"hsp_tunnel_route", "cost", "double", offsetof(hsp_tunnel_route, cost), 1},
  {"hsp_tunnel_route", "shift", "int32_t", offsetof(hsp_tunnel_route, shift), 3},
  {"hsp_tunnel_route", "reserved", "uint32_t", offsetof(hsp_tunnel_route, reserved), 1},
  {"hsp_tunnel_point", "xyz", "double", offsetof(hsp_tunnel_point, xyz), 3},
  {"hsp_tunnel_point", "radius", "double", offsetof(hsp_tunnel_point, radius), 1},
  {"hsp_tunnel_point", "ball", "uint32_t", offsetof(hsp_tunnel_point, ball), 4},
  {"hsp_tunnel_point", "gate", "uint32_t", offsetof(hsp_tunnel_point, gate), 1},
  {"hsp_tunnel_point", "maximum", "uint32_t", offsetof(hsp_tunnel_point, maximum), 1},
  {"hsp_tunnel_point_shifts", "ball", "int32_t", offsetof(hsp_tunnel_point_shifts, ball), 12},
  {"hsp_tunnel_point_shifts", "at", "int32_t", offsetof(hsp_tunnel_point_shifts, at), 3},
  {"hsp_pore_pocket", "radius", "double", offsetof(hsp_pore_pocket, radius), 1},
  {"hsp_pore_pocket", "mouth", "double", offsetof(hsp_pore_pocket, mouth), 1},
  {"hsp_pore_pocket", "maximum", "uint32_t", offsetof(hsp_pore_pocket, maximum), 1},
  {"hsp_pore_pocket", "gate", "uint32_t", offsetof(hsp_pore_pocket, gate), 1},
  {"hsp_pore_pocket", "maxima", "uint32_t", offsetof(hsp_pore_pocket, maxima), 1},
  {"hsp_pore_pocket", "mouths", "uint32_t", offsetof(hsp_pore_pocket, mouths), 1},
  {"hsp_pore_pocket", "balls", "uint32_t", offsetof(hsp_pore_pocket, balls), 1},
  {"hsp_pore_pocket", "reserved", "uint32_t", offsetof(hsp_pore_pocket, reserved), 1},
  {"hsp_pore_access", "accessible_area", "double", offsetof(hsp_pore_access, accessible_area), 1},
  {"hsp_pore_access", "accessible_volume", "double", offsetof(hsp_pore_access, accessible_volume), 1},
  {"hsp_pore_access", "blocked_area", "double", offsetof(hsp_pore_access, blocked_area), 1},
  {"hsp_pore_access", "blocked_volume", "double", offsetof(hsp_pore_access, blocked_volume), 1},
  {"hsp_pore_access", "accessible", "uint32_t", offsetof(hsp_pore_access, accessible), 1},
  {"hsp_pore_access", "blocked", "uint32_t", offsetof(hsp_pore_access, blocked), 1},
  {"hsp_pores_request", "struct_size", "uint32_t", offsetof(hsp_pores_request, struct_size), 1},
  {"hsp_pores_request", "reserved", "uint32_t", offsetof(hsp_pores_request, reserved), 1},
  {"hsp_pores_request", "executor", "hsp_executor *", offsetof(hsp_pores_request, executor), 1},
  {"hsp_pore_region", "radius", "double", offsetof(hsp_pore_region, radius), 1},
  {"hsp_pore_region", "area", "double", offsetof(hsp_pore_region, area), 1},
  {"hsp_pore_region", "volume", "double", offsetof(hsp_pore_region, volume), 1},
  {"hsp_pore_region", "maximum", "uint32_t", offsetof(hsp_pore_region, maximum), 1},
  {"hsp_pore_region", "maxima", "uint32_t", offsetof(hsp_pore_region, maxima), 1},
  {"hsp_pore_region", "shells", "uint32_t", offsetof(hsp_pore_region, shells), 1},
  {"hsp_pore_region", "accessible", "uint32_t", offsetof(hsp_pore_region, accessible), 1},
  {"hsp_pore_region", "directions", "uint32_t", offsetof(hsp_pore_region, directions), 1},
  {"hsp_pore_region", "copies", "uint32_t", offsetof(hsp_pore_region, copies), 1},
  {"hsp_pore_region", "row", "int32_t", offsetof(hsp_pore_region, row), 9},
  {"hsp_pore_region", "reserved", "uint32_t", offsetof(hsp_pore_region, reserved), 1},
  {"hsp_pore_pocket_size", "volume", "double", offsetof(hsp_pore_pocket_size, volume), 1},
  {"hsp_pore_pocket_size", "area", "double", offsetof(hsp_pore_pocket_size, area), 1},
  {"hsp_pore_pocket_size", "plug_area", "double", offsetof(hsp_pore_pocket_size, plug_area), 1},
  {"hsp_pore_pocket_size", "regions", "uint32_t", offsetof(hsp_pore_pocket_size, regions), 1},
  {"hsp_pore_pocket_size", "closed", "uint32_t", offsetof(hsp_pore_pocket_size, closed), 1},
  {"hsp_view_limits", "struct_size", "uint32_t", offsetof(hsp_view_limits, struct_size), 1},
  {"hsp_view_limits", "balls", "uint32_t", offsetof(hsp_view_limits, balls), 1},
  {"hsp_view_limits", "neighbours", "uint32_t", offsetof(hsp_view_limits, neighbours), 1},
  {"hsp_view_limits", "arcs", "uint32_t", offsetof(hsp_view_limits, arcs), 1},
  {"hsp_view_options", "struct_size", "uint32_t", offsetof(hsp_view_options, struct_size), 1},
  {"hsp_view_options", "pieces", "uint32_t", offsetof(hsp_view_options, pieces), 1},
  {"hsp_view_options", "flags", "uint32_t", offsetof(hsp_view_options, flags), 1},
  {"hsp_view_options", "reserved", "uint32_t", offsetof(hsp_view_options, reserved), 1},
  {"hsp_view_options", "towards", "double", offsetof(hsp_view_options, towards), 3},
  {"hsp_view_options", "up", "double", offsetof(hsp_view_options, up), 3},
  {"hsp_view_options", "executor", "hsp_executor *", offsetof(hsp_view_options, executor), 1},
  {"hsp_view_options", "unused", "void *", offsetof(hsp_view_options, unused), 1},
  {"hsp_view_info", "origin", "double", offsetof(hsp_view_info, origin), 3},
  {"hsp_view_info", "right", "double", offsetof(hsp_view_info, right), 3},
  {"hsp_view_info", "up", "double", offsetof(hsp_view_info, up), 3},
  {"hsp_view_info", "towards", "double", offsetof(hsp_view_info, towards), 3},
  {"hsp_view_info", "low", "double", offsetof(hsp_view_info, low), 2},
  {"hsp_view_info", "high", "double", offsetof(hsp_view_info, high), 2},
  {"hsp_view_info", "depth_low", "double", offsetof(hsp_view_info, depth_low), 1},
  {"hsp_view_info", "depth_high", "double", offsetof(hsp_view_info, depth_high), 1},
  {"hsp_view_info", "pieces", "uint32_t", offsetof(hsp_view_info, pieces), 1},
  {"hsp_view_info", "loops", "uint32_t", offsetof(hsp_view_info, loops), 1},
  {"hsp_view_info", "arcs", "uint32_t", offsetof(hsp_view_info, arcs), 1},
  {"hsp_view_info", "kind", "uint32_t", offsetof(hsp_view_info, kind), 1},
  {"hsp_view_piece", "centre", "double", offsetof(hsp_view_piece, centre), 2},
  {"hsp_view_piece", "depth", "double", offsetof(hsp_view_piece, depth), 1},
  {"hsp_view_piece", "radius", "double", offsetof(hsp_view_piece, radius), 1},
  {"hsp_view_piece", "ball", "uint32_t", offsetof(hsp_view_piece, ball), 1},
  {"hsp_view_piece", "first_loop", "uint32_t", offsetof(hsp_view_piece, first_loop), 1},
  {"hsp_view_piece", "loops", "uint32_t", offsetof(hsp_view_piece, loops), 1},
  {"hsp_view_piece", "first_arc", "uint32_t", offsetof(hsp_view_piece, first_arc), 1},
  {"hsp_view_piece", "arcs", "uint32_t", offsetof(hsp_view_piece, arcs), 1},
  {"hsp_view_piece", "reserved", "uint32_t", offsetof(hsp_view_piece, reserved), 1},
  {"hsp_view_loop", "piece", "uint32_t", offsetof(hsp_view_loop, piece), 1},
  {"hsp_view_loop", "first_arc", "uint32_t", offsetof(hsp_view_loop, first_arc), 1},
  {"hsp_view_loop", "arcs", "uint32_t", offsetof(hsp_view_loop, arcs), 1},
  {"hsp_view_loop", "reserved", "uint32_t", offsetof(hsp_view_loop, reserved), 1},
  {"hsp_view_arc", "centre", "double", offsetof(hsp_view_arc, centre), 2},
  {"hsp_view_arc", "semi_axis", "double", offsetof(hsp_view_arc, semi_axis), 2},
  {"hsp_view_arc", "rotation", "double", offsetof(hsp_view_arc, rotation), 1},
  {"hsp_view_arc", "from", "double", offsetof(hsp_view_arc, from), 1},
  {"hsp_view_arc", "to", "double", offsetof(hsp_view_arc, to), 1},
  {"hsp_view_arc", "start", "double", offsetof(hsp_view_arc, start), 2},
  {"hsp_view_arc", "end", "double", offsetof(hsp_view_arc, end), 2},
  {"hsp_view_arc", "piece", "uint32_t", offsetof(hsp_view_arc, piece), 1},
  {"hsp_view_arc", "other_ball", "uint32_t", offsetof(hsp_view_arc, other_ball), 1},
  {"hsp_map_limits", "struct_size", "uint32_t", offsetof(hsp_map_limits, struct_size), 1},
  {"hsp_map_limits", "balls", "uint32_t", offsetof(hsp_map_limits, balls), 1},
  {"hsp_map_limits", "neighbours", "uint32_t", offsetof(hsp_map_limits, neighbours), 1},
  {"hsp_map_limits", "edges", "uint32_t", offsetof(hsp_map_limits, edges), 1},
  {"hsp_map_info", "origin", "double", offsetof(hsp_map_info, origin), 3},
  {"hsp_map_info", "right", "double", offsetof(hsp_map_info, right), 3},
  {"hsp_map_info", "up", "double", offsetof(hsp_map_info, up), 3},
  {"hsp_map_info", "towards", "double", offsetof(hsp_map_info, towards), 3},
  {"hsp_map_info", "area", "double", offsetof(hsp_map_info, area), 1},
  {"hsp_map_info", "perturbation", "double", offsetof(hsp_map_info, perturbation), 1},
  {"hsp_map_info", "vertices", "uint32_t", offsetof(hsp_map_info, vertices), 1},
  {"hsp_map_info", "edges", "uint32_t", offsetof(hsp_map_info, edges), 1},
  {"hsp_map_info", "faces", "uint32_t", offsetof(hsp_map_info, faces), 1},
  {"hsp_map_info", "components", "uint32_t", offsetof(hsp_map_info, components), 1},
  {"hsp_map_info", "balls", "uint32_t", offsetof(hsp_map_info, balls), 1},
  {"hsp_map_info", "reserved", "uint32_t", offsetof(hsp_map_info, reserved), 1},
  {"hsp_map_vertex", "xyz", "double", offsetof(hsp_map_vertex, xyz), 3},
  {"hsp_map_vertex", "kind", "uint32_t", offsetof(hsp_map_vertex, kind), 1},
  {"hsp_map_vertex", "h", "uint32_t", offsetof(hsp_map_vertex, h), 1},
  {"hsp_map_vertex", "ball", "uint32_t", offsetof(hsp_map_vertex, ball), 3},
  {"hsp_map_vertex", "reserved", "uint32_t", offsetof(hsp_map_vertex, reserved), 1},
  {"hsp_map_edge", "centre", "double", offsetof(hsp_map_edge, centre), 2},
  {"hsp_map_edge", "first", "double", offsetof(hsp_map_edge, first), 2},
  {"hsp_map_edge", "second", "double", offsetof(hsp_map_edge, second), 2},
  {"hsp_map_edge", "from", "double", offsetof(hsp_map_edge, from), 1},
  {"hsp_map_edge", "to", "double", offsetof(hsp_map_edge, to), 1},
  {"hsp_map_edge", "ball", "uint32_t", offsetof(hsp_map_edge, ball), 2},
  {"hsp_map_edge", "face", "uint32_t", offsetof(hsp_map_edge, face), 2},
  {"hsp_map_edge", "vertex", "uint32_t", offsetof(hsp_map_edge, vertex), 2},
  {"hsp_map_edge", "next", "uint32_t", offsetof(hsp_map_edge, next), 2},
  {"hsp_map_face", "area", "double", offsetof(hsp_map_face, area), 1},
  {"hsp_map_face", "ball", "uint32_t", offsetof(hsp_map_face, ball), 1},
  {"hsp_map_face", "h", "uint32_t", offsetof(hsp_map_face, h), 1},
  {"hsp_map_face", "loops", "uint32_t", offsetof(hsp_map_face, loops), 1},
  {"hsp_map_face", "reserved", "uint32_t", offsetof(hsp_map_face, reserved), 1},
  {"hsp_map_sight", "depth", "double", offsetof(hsp_map_sight, depth), 1},
  {"hsp_map_sight", "ball", "uint32_t", offsetof(hsp_map_sight, ball), 1},
  {"hsp_map_sight", "face", "uint32_t", offsetof(hsp_map_sight, face), 1},
  {"hsp_map_point", "xyz", "double", offsetof(hsp_map_point, xyz), 3},
  {"hsp_map_point", "gap", "double", offsetof(hsp_map_point, gap), 2},
  {"hsp_map_pole", "centre", "double", offsetof(hsp_map_pole, centre), 2},
  {"hsp_map_pole", "radius", "double", offsetof(hsp_map_pole, radius), 1},
  {"hsp_map_pole", "bound", "double", offsetof(hsp_map_pole, bound), 1},
  {"hsp_sticks_limits", "struct_size", "uint32_t", offsetof(hsp_sticks_limits, struct_size), 1},
  {"hsp_sticks_limits", "balls", "uint32_t", offsetof(hsp_sticks_limits, balls), 1},
  {"hsp_sticks_limits", "sticks", "uint32_t", offsetof(hsp_sticks_limits, sticks), 1},
  {"hsp_sticks_limits", "pairs", "uint32_t", offsetof(hsp_sticks_limits, pairs), 1},
  {"hsp_sticks_limits", "edges", "uint32_t", offsetof(hsp_sticks_limits, edges), 1},
  {"hsp_stick", "ball", "uint32_t", offsetof(hsp_stick, ball), 2},
  {"hsp_stick", "flags", "uint32_t", offsetof(hsp_stick, flags), 1},
  {"hsp_stick", "reserved", "uint32_t", offsetof(hsp_stick, reserved), 1},
  {"hsp_sticks_conflict", "kind", "uint32_t", offsetof(hsp_sticks_conflict, kind), 1},
  {"hsp_sticks_conflict", "first", "uint32_t", offsetof(hsp_sticks_conflict, first), 1},
  {"hsp_sticks_conflict", "second", "uint32_t", offsetof(hsp_sticks_conflict, second), 1},
  {"hsp_sticks_conflict", "reserved", "uint32_t", offsetof(hsp_sticks_conflict, reserved), 1},
  {"hsp_sticks_info", "origin", "double", offsetof(hsp_sticks_info, origin), 3},
  {"hsp_sticks_info", "right", "double", offsetof(hsp_sticks_info, right), 3},
  {"hsp_sticks_info", "up", "double", offsetof(hsp_sticks_info, up), 3},
  {"hsp_sticks_info", "towards", "double", offsetof(hsp_sticks_info, towards), 3},
  {"hsp_sticks_info", "low", "double", offsetof(hsp_sticks_info, low), 2},
  {"hsp_sticks_info", "high", "double", offsetof(hsp_sticks_info, high), 2},
  {"hsp_sticks_info", "paths", "uint32_t", offsetof(hsp_sticks_info, paths), 1},
  {"hsp_sticks_info", "balls", "uint32_t", offsetof(hsp_sticks_info, balls), 1},
  {"hsp_sticks_info", "sticks", "uint32_t", offsetof(hsp_sticks_info, sticks), 1},
  {"hsp_sticks_info", "arcs", "uint32_t", offsetof(hsp_sticks_info, arcs), 1},
  {"hsp_picture_options", "struct_size", "uint32_t", offsetof(hsp_picture_options, struct_size), 1},
  {"hsp_picture_options", "format", "uint32_t", offsetof(hsp_picture_options, format), 1},
  {"hsp_picture_options", "style", "uint32_t", offsetof(hsp_picture_options, style), 1},
  {"hsp_picture_options", "unit", "uint32_t", offsetof(hsp_picture_options, unit), 1},
  {"hsp_picture_options", "width", "double", offsetof(hsp_picture_options, width), 1},
  {"hsp_picture_options", "height", "double", offsetof(hsp_picture_options, height), 1},
  {"hsp_picture_options", "margin", "double", offsetof(hsp_picture_options, margin), 1},
  {"hsp_picture_options", "outline", "double", offsetof(hsp_picture_options, outline), 1},
  {"hsp_picture_options", "fog", "double", offsetof(hsp_picture_options, fog), 1},
  {"hsp_picture_options", "outline_colour", "uint32_t", offsetof(hsp_picture_options, outline_colour), 1},
  {"hsp_picture_options", "background", "uint32_t", offsetof(hsp_picture_options, background), 1},
  {"hsp_picture_options", "flags", "uint32_t", offsetof(hsp_picture_options, flags), 1},
  {"hsp_picture_options", "reserved", "uint32_t", offsetof(hsp_picture_options, reserved), 1},
  {"hsp_picture_options", "scale", "double", offsetof(hsp_picture_options, scale), 1},
  {"hsp_picture_options", "centre", "double", offsetof(hsp_picture_options, centre), 3},
  {"hsp_picture_options", "memory", "void *", offsetof(hsp_picture_options, memory), 1},
  {"hsp_picture_options", "memory_bytes", "size_t", offsetof(hsp_picture_options, memory_bytes), 1},
  {"hsp_picture_options", "ink", "hsp_map *", offsetof(hsp_picture_options, ink), 1},
  {"hsp_picture_options", "group", "uint32_t *", offsetof(hsp_picture_options, group), 1},
  {"hsp_picture_options", "ink_width", "double", offsetof(hsp_picture_options, ink_width), 3},
  {"hsp_picture_options", "ink_colour", "uint32_t", offsetof(hsp_picture_options, ink_colour), 3},
  {"hsp_picture_options", "reserved_for_ink", "uint32_t", offsetof(hsp_picture_options, reserved_for_ink), 1},
  {"hsp_picture_options", "atom_class", "char *", offsetof(hsp_picture_options, atom_class), 1},
  {"hsp_picture_options", "atom_title", "char *", offsetof(hsp_picture_options, atom_title), 1},
  {"hsp_picture_options", "ink_of_sticks", "hsp_sticks *", offsetof(hsp_picture_options, ink_of_sticks), 1},
  {"hsp_picture_options", "reserved_for_sticks", "size_t", offsetof(hsp_picture_options, reserved_for_sticks), 1},
};
const size_t registry_fields_size = sizeof registry_fields / sizeof registry_fields[0];
