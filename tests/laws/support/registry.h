/* The functions of the interface as a table: what each argument is, which statuses are documented, and a call.
 * registry.c is generated from the headers; capi/interface/README.md says what the kinds of arguments are. */
#pragma once

#include <hardsphere.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
  KIND_handle,
  KIND_handle_out,
  KIND_memory,
  KIND_context,
  KIND_callback,
  KIND_string,
  KIND_value,
  KIND_capacity,
  KIND_needed,
  KIND_array_in,
  KIND_array_out,
  KIND_struct_in,
  KIND_struct_out,
  KIND_value_out,
  KIND_sized_in,
  KIND_sized,
  KIND_outputs
};

/* Whether an argument may be NULL. empty: if it has no entries. box: in a periodic box, which the laws do not use. */
enum { NULL_never, NULL_always, NULL_empty, NULL_box };

/* The kinds of values that functions return. id: an unsigned number that is HSP_NONE where other functions return a
 * failing status. */
enum { RESULT_status, RESULT_id, RESULT_number, RESULT_text };

/* The kinds of handles. */
enum {
  NOUN_none,
  NOUN_model,
  NOUN_body,
  NOUN_boundary,
  NOUN_moving,
  NOUN_contacts,
  NOUN_periodic,
  NOUN_surface,
  NOUN_mesh,
  NOUN_topology,
  NOUN_cells,
  NOUN_paths,
  NOUN_pores,
  NOUN_view,
  NOUN_map,
  NOUN_sticks,
  NOUNS
};

typedef union value {
  void *p;
  uint32_t u;
  int32_t i;
  double d;
  size_t z;
  int32_t(HSP_CALL *f)(void *context, const char *bytes, size_t count); /* an hsp_sink */
} value;

typedef struct argument {
  const char *name, *base; /* its type without const and stars */
  int kind;
  size_t size;        /* of a number or struct in bytes */
  const char *extent; /* how many entries an array has, NULL if it is none */
  size_t row;         /* how many numbers or structs make an entry, 0: one */
  int noun, null, is_const;
  int held; /* an output array that has to have room for what `needed` becomes */
  /* A field of a request or outputs struct is listed as an argument behind it: the place of the struct, 0 if it is no
   * field, and its offset in the struct. */
  int of;
  size_t offset;
} argument;

typedef struct function {
  const char *name, *noun;
  int result, count;
  const argument *arguments;
  int64_t (*call)(const value *v);
  uint32_t statuses; /* BIT of each that is documented */
} function;
#define BIT(status) (UINT32_C(1) << -(status))

typedef struct field {
  const char *of, *name, *base;
  size_t offset, count;
} field;

extern const function registry[];
extern const size_t registry_size;
extern const field registry_fields[]; /* of all structs */
extern const size_t registry_fields_size;

#ifdef __cplusplus
}
#endif
