"""The Fortran module: every form of an argument, and that sizes are those of the header's macros."""
import re
import unittest
from pathlib import Path

from read import read_interface
from small_headers import DECLARED, function_of, interface_of
from write.fortran import bound_rows, bounds_of, constant_rows, declaration, fortran_module, function_rows, type_rows

INCLUDE = Path(__file__).parents[2] / "include"


class Arguments(unittest.TestCase):
    ARGUMENTS = ("const hsp_x *x, const hsp_x *y, void *memory, size_t bytes, uint32_t n, const double *xyz,"
                 " const hsp_limits *limits, const char *title, hsp_sink sink, void *context, uint32_t *quads,"
                 " double *box, uint64_t *total, hsp_row *out, uint32_t capacity, uint32_t *needed")
    COMMENT = """\
        xyz [n][3], quads [n][4], box [3][3].
        @retval HSP_E_ARGUMENT  x, memory, box, total, sink or needed is NULL; xyz is NULL with n > 0"""

    def test_declarations(self):
        function = function_of(self.ARGUMENTS, self.COMMENT)
        self.assertEqual([declaration(a) for a in function.arguments], [
            ("type(c_ptr), value :: x", ""),
            ("type(c_ptr), value :: y", "may be c_null_ptr"),
            ("type(c_ptr), value :: memory", ""),
            ("integer(c_size_t), value :: bytes", ""),
            ("integer(c_int32_t), value :: n", ""),
            ("real(c_double), intent(in), optional :: xyz(3, *)", "3, n"),
            ("type(hsp_limits), intent(in), optional :: limits", ""),
            ("character(kind=c_char), intent(in), optional :: title(*)", "ends with c_null_char"),
            ("type(c_funptr), value :: sink", "of a function with the interface hsp_sink"),
            ("type(c_ptr), value :: context", "may be c_null_ptr"),
            ("integer(c_int32_t), intent(inout), optional :: quads(0:3, 0:*)", "4, n"),
            ("real(c_double), intent(inout) :: box(3, 3)", ""),
            ("integer(c_int64_t), intent(inout) :: total", ""),
            ("type(hsp_row), intent(inout), optional :: out(*)", "needed"),
            ("integer(c_int32_t), value :: capacity", ""),
            ("integer(c_int32_t), intent(inout), optional :: needed", "")])

    def test_a_function(self):
        function = function_of("hsp_x **x, double a", "F.\n@retval HSP_E_ARGUMENT  x is NULL")
        self.assertEqual("\n".join(function_rows(function)), """\
    function hsp_f(x, a) result(status) bind(C, name="hsp_f")
      import :: c_double, c_int32_t, c_ptr
      type(c_ptr), intent(inout) :: x
      real(c_double), value :: a
      integer(c_int32_t) :: status
    end function""")

    def test_long_rows_go_on(self):
        rows = function_rows(function_of(self.ARGUMENTS, self.COMMENT))
        self.assertTrue(rows[0].endswith(" &") and rows[1].startswith("      "))
        self.assertLessEqual(max(map(len, rows)), 120)


class Data(unittest.TestCase):
    def test_types(self):
        found = interface_of(DECLARED)
        self.assertEqual("\n".join(type_rows(found.structs["hsp_row"])), """\
  type, bind(C) :: hsp_row
    real(c_double) :: centre(3)     ! length
    integer(c_int32_t) :: ball
    integer(c_int32_t) :: reserved  ! 0
  end type""")
        rows = type_rows(found.structs["hsp_limits"], (24, 16))
        self.assertIn("    integer(c_int32_t) :: struct_size = 8_c_int32_t + 2 * pointer_bytes  ! sizeof(hsp_limits)", rows)
        self.assertIn("    integer(c_int32_t) :: struct_size = 24_c_int32_t  ! sizeof(hsp_limits)",
                      type_rows(found.structs["hsp_limits"], (24, 24)))

    def test_what_is_asked_has_defaults(self):
        found = interface_of("typedef struct hsp_a_request {\n  uint32_t struct_size;\n  uint32_t reserved;\n"
                             "  double factor;\n  const double *a; /**< [n] */\n} hsp_a_request;\n")
        self.assertEqual("\n".join(type_rows(found.structs["hsp_a_request"], (24, 20))), """\
  type, bind(C) :: hsp_a_request
    integer(c_int32_t) :: struct_size = 16_c_int32_t + 1 * pointer_bytes
    integer(c_int32_t) :: reserved = 0_c_int32_t
    real(c_double) :: factor = 0.0_c_double
    type(c_ptr) :: a = c_null_ptr                                         ! [n]
  end type""")

    def test_constants(self):
        found = interface_of("#define HSP_A UINT32_C(0xFFFFFFFF) /**< none */\n#define HSP_B (-3)\n"
                             "#define HSP_LONG 1 /**< " + "word " * 30 + "*/\n")
        rows = [constant_rows(c) for c in found.constants.values()]
        self.assertEqual(rows[:2], [["  integer(c_int32_t), parameter :: HSP_A = -1_c_int32_t  ! none"],
                                    ["  integer(c_int32_t), parameter :: HSP_B = -3_c_int32_t"]])
        self.assertEqual([row.startswith("  ! word") for row in rows[2]], [True, True, False])

    def test_sizes_are_those_of_the_macros(self):
        macros = bounds_of(read_interface(INCLUDE))
        self.assertGreater(len(macros), 10)
        for macro in macros:
            values = {name: 1000003 * place ** 2 + 1 for place, name in enumerate(macro.parameters, 1)}
            text = " ".join(row.strip().removesuffix("&") for row in bound_rows(macro))
            made = re.search(r"bytes = (.*?) +end function", text)[1]
            made = re.sub(r"int\((\w+), c_size_t\)", r"\1", made).replace("_c_size_t", "")
            stated = macro.text.replace("(size_t)", "")
            self.assertEqual(eval(made, {}, values), eval(stated, {}, values), macro.name)

    def test_a_size_that_is_no_sum_of_products(self):
        macro = interface_of("#define HSP_X_BYTES(n) ((size_t)4 * (size_t)(n) * (size_t)(n))\n").macros["HSP_X_BYTES"]
        with self.assertRaises(ValueError):
            bound_rows(macro)


class Module(unittest.TestCase):
    def test_all_of_it_is_there(self):
        found = read_interface(INCLUDE)
        module = fortran_module(found)
        texts = [f'name="{f.name}"' for f in found.functions]
        texts += [f"bind(C) :: {name}\n" for name in found.structs]
        texts += [f":: {name} = " for name in [*found.constants, *found.texts]]
        for text in texts:
            self.assertEqual(module.count(text), 1, text)
        self.assertLessEqual(max(map(len, module.split("\n"))), 120)
        self.assertNotIn("! <", module)

    def test_headers_can_be_left_out(self):
        module, rows, left_out = fortran_module(read_interface(INCLUDE)), [], False
        for row in module.split("\n"):
            if "! ----" in row:
                left_out = "! ---- surface.h" in row or "! ---- mesh.h" in row
            rows += [] if left_out else [row]
        left = "\n".join(rows)
        for name in ("hsp_surface_", "HSP_SURFACE_", "hsp_mesh_"):
            self.assertNotIn(name, left)
        for name in ("abstract interface", "  ! ----\n\ncontains", "hsp_map_twin", "hsp_topology_bytes_bound",
                     "hsp_picture_write_map", "end module"):
            self.assertIn(name, left)


if __name__ == "__main__":
    unittest.main()
