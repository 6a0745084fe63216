"""The lists: the record of the binary interface, the index of functions, and the declarations for other languages."""
import tempfile
import unittest
from pathlib import Path

from small_headers import DECLARED, interface_of
from write import abi
from write.cdef import cdef
from write.function_index import function_index

HEADER = DECLARED + """
typedef struct hsp_both { hsp_row row[2]; int64_t sum; } hsp_both;
typedef struct hsp_places { uint32_t struct_size; uint32_t n; const hsp_x *x; const char *const *name; size_t bytes;
                            double a; } hsp_places;
#define HSP_ABI_NUMBER 7
#define HSP_PROVISIONAL_NUMBER 5
#define HSP_VERSION_STRING "0.3.0"
#define HSP_ALL UINT32_C(0xFFFFFFFF)
#define HSP_X_BYTES(n, m) ((size_t)(n) + (size_t)(m))
/** Make a | b of *x. More.
 *  @retval HSP_OK          always
 *  @retval HSP_E_ARGUMENT  x is NULL
 *  @retval HSP_E_ID        no such b */
int32_t hsp_b(const hsp_x *x, uint32_t b);
/** A. */
uint32_t hsp_a(uint32_t a);
"""


class Lists(unittest.TestCase):
    def setUp(self):
        self.interface = interface_of(HEADER)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(setattr, abi, "RECORD", abi.RECORD)
        abi.RECORD = Path(folder.name)
        self.record(["uint32_t hsp_a(uint32_t a)"], ["hsp_a 0.1.0", "hsp_b 0.2.0"])

    def record(self, functions, since):
        (abi.RECORD / "functions.txt").write_text("\n".join(["# a title", *functions, ""]))
        (abi.RECORD / "since.txt").write_text("\n".join(["# a title", *since, ""]))

    def test_functions(self):
        self.assertEqual(abi.abi_functions(self.interface), """\
# Declarations of ABI number 7
int32_t hsp_b(const hsp_x *x, uint32_t b)
typedef int32_t (*hsp_sink)(void *context, const char *bytes, size_t count)
typedef struct hsp_x hsp_x
uint32_t hsp_a(uint32_t a)
HSP_X_BYTES(n,m) ((size_t)(n) + (size_t)(m))
# Declarations of provisional number 5
""")

    def test_constants_without_the_numbers_of_releases(self):
        self.assertEqual(abi.abi_constants(self.interface), "# Constants of ABI number 7\nHSP_ALL 4294967295\n"
                         "# Constants of provisional number 5\n")

    def test_tiers_are_kept_apart(self):
        sentence = "Provisional: this may change with any minor\n * version, as the changelog then says."
        interface = interface_of(HEADER, tier=sentence)
        self.assertEqual(abi.abi_constants(interface), "# Constants of ABI number 7\n"
                         "# Constants of provisional number 5\nHSP_ALL 4294967295\n")
        self.assertTrue(abi.abi_functions(interface).startswith("# Declarations of ABI number 7\n# Decl"))
        self.assertIn("\nhsp_a 0.1.0 provisional\n", abi.abi_since(interface))
        self.assertIn("(../../include/hardsphere/x.h). Provisional.\n", function_index(interface))

    def test_structs_with_structs_inside(self):
        rows = abi.abi_structs(self.interface).split("\n")
        self.assertEqual(rows[1:5], ["hsp_both 72", "hsp_both.row 0 hsp_row 2", "hsp_both.sum 64 int64_t 1",
                                     "hsp_limits 8"])

    def test_pointers_have_two_sizes(self):
        self.interface = interface_of(HEADER + "typedef struct hsp_p { uint32_t a; uint32_t b; const double *x;"
                                      " void (*run)(void *data); } hsp_p;")
        self.assertIn("\nhsp_p 24/16\nhsp_p.a 0 uint32_t 1\nhsp_p.b 4 uint32_t 1\nhsp_p.x 8 double* 1\n"
                      "hsp_p.run 16/12 function* 1\n", abi.abi_structs(self.interface))

    def test_structs_with_pointers_have_two_layouts(self):
        rows = abi.abi_structs(self.interface).split("\n")
        self.assertEqual(rows[rows.index("hsp_places 40/28"):][1:7], [
            "hsp_places.struct_size 0 uint32_t 1", "hsp_places.n 4 uint32_t 1", "hsp_places.x 8 hsp_x* 1",
            "hsp_places.name 16/12 char* 1", "hsp_places.bytes 24/16 size_t 1", "hsp_places.a 32/20 double 1"])

    def test_padding(self):
        def padded(fields):
            interface = interface_of(f"{DECLARED}typedef struct hsp_p {{ {fields} }} hsp_p;")
            return abi.padded_structs(interface)

        self.assertEqual(padded("uint32_t a; uint32_t b; const double *x; const double *y; double z; hsp_row row;"), [])
        self.assertEqual(padded("double a; uint32_t b;"), ["hsp_p: padding at its end"])
        self.assertEqual(padded("uint32_t a; double b; uint32_t c;"), ["hsp_p: padding before b"])
        # With pointers of 8 bytes alone, and of 4.
        self.assertEqual(padded("const double *x; uint32_t a;"), ["hsp_p: padding at its end"])
        self.assertEqual(padded("uint32_t a; uint32_t b; const double *x; double y;"), ["hsp_p: padding before y",
                                                                                               "hsp_p: padding at its end"])
        self.assertEqual(padded("hsp_row row; uint32_t b;"), ["hsp_p: padding at its end"])

    def test_since_when(self):
        title = "# The version since which each function is declared as it is, and its tier\n"
        # The declaration of hsp_b is another one than in the record.
        self.assertEqual(abi.abi_since(self.interface), title + "hsp_a 0.1.0 stable\nhsp_b 0.3.0 stable\n")
        self.record([f.c for f in self.interface.functions], ["hsp_b 0.2.0"])
        self.assertEqual(abi.abi_since(self.interface), title + "hsp_a 0.3.0 stable\nhsp_b 0.2.0 stable\n")

    def test_index(self):
        page = function_index(self.interface)
        self.assertIn("\n## x.h\n\nWhat it is for: [hardsphere/x.h](../../include/hardsphere/x.h). Stable.\n", page)
        self.assertIn("\n| `hsp_b` | Make a \\| b of \\*x. | E_ARGUMENT, E_ID | 0.3.0 |\n", page)
        self.assertLess(page.index("`hsp_b`"), page.index("`hsp_a`"))

    def test_declarations_for_other_languages(self):
        text = cdef(self.interface)
        self.assertIn("typedef struct hsp_both {\n  hsp_row row[2];\n  int64_t sum;\n} hsp_both;\n", text)
        self.assertIn("  const hsp_x *x;\n  const char * const *name;\n  size_t bytes;\n", text)
        self.assertIn("#define HSP_ALL 4294967295\n", text)
        self.assertIn("int32_t hsp_b(const hsp_x *x, uint32_t b);\n", text)
        self.assertIn("typedef struct hsp_x hsp_x;\n", text)


if __name__ == "__main__":
    unittest.main()
