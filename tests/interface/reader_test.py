"""The reader of capi/interface, on small headers: every rule, and every question that it must leave open."""
import unittest

from small_headers import DECLARED, function_of, interface_of
from read.tiers import SENTENCES
from write.model_text import argument_text, function_row


class Reading(unittest.TestCase):
    def argument(self, name, arguments, comment, before=""):
        """The row of an argument in the model; nothing about it may be open."""
        function = function_of(arguments, comment, before)
        self.assertEqual(function.open_questions, [])
        return argument_text(function.argument(name))

    def assertOpen(self, question, arguments, comment, before=""):
        self.assertEqual(function_of(arguments, comment, before).open_questions, [question])


class Declarations(Reading):
    def test_types(self):
        arguments = "const hsp_x *x, hsp_x **made, double a, const char *title"
        f = function_of(arguments, "A. B.\n@retval HSP_E_ARGUMENT  x is NULL")
        self.assertEqual(f.c, f"int32_t hsp_f({arguments})")
        self.assertEqual([a.const for a in f.arguments], [True, False, False, True])

    def test_results_and_no_arguments(self):
        declared = ["uint32_t hsp_f(void)", "const char *hsp_text(int32_t status)", "uint32_t hsp_g(uint32_t a)",
                    "uint32_t hsp_h(const hsp_x *x)"]
        found = interface_of(DECLARED + "".join(f"/** A. */\n{row};\n" for row in declared))
        self.assertEqual([f.c for f in found.functions], declared)
        self.assertEqual([f.name for f in found.functions if f.pure], ["hsp_g"])

    def test_structs(self):
        found = interface_of(DECLARED)
        row, limits = found.structs["hsp_row"], found.structs["hsp_limits"]
        self.assertEqual([(f.name, f.base, f.count) for f in row.fields],
                         [("centre", "double", 3), ("ball", "uint32_t", 1), ("reserved", "uint32_t", 1)])
        self.assertEqual([f.remark for f in limits.fields], ["sizeof(hsp_limits)", "most balls, as they come"])
        self.assertTrue(limits.sized and not row.sized)

    def test_pointers_in_structs(self):
        found = interface_of(DECLARED + """typedef void hsp_task(void *data, uint32_t task);
            typedef struct hsp_a { const double *a; uint32_t *b[2]; void (*run)(void *c, hsp_task *task); } hsp_a;""")
        fields = found.structs["hsp_a"].fields
        self.assertEqual([(f.base, f.stars, f.const, f.count) for f in fields],
                         [("double", 1, True, 1), ("uint32_t", 1, False, 2), ("function", 1, False, 1)])
        self.assertEqual([f.c for f in fields],
                         ["const double *a", "uint32_t *b[2]", "void (*run)(void *c, hsp_task *task)"])
        self.assertIn("hsp_task", found.callbacks)

    def test_structs_inside_others_come_first(self):
        found = interface_of("typedef struct hsp_a { uint32_t a; } hsp_a;\ntypedef struct hsp_b { hsp_a a; } hsp_b;\n")
        found.structs = dict(reversed(found.structs.items()))
        self.assertEqual([s.name for s in found.structs_inside_first()], ["hsp_a", "hsp_b"])

    def test_macros(self):
        found = interface_of('#define HSP_A 2 /**< two\n   of them */\n/** B. */\n#define HSP_B UINT32_C(0xFFFFFFFF)\n'
                             '#define HSP_C (10 * HSP_A + (-1))\n#define HSP_D \\\n  4 /**< four */\n'
                             '#define HSP_S "0.1"\n#define HSP_F(a, b) ((a) + (b))\n')
        self.assertEqual([(c.name, c.value, c.remark) for c in found.constants.values()],
                         [("HSP_A", 2, "two of them"), ("HSP_B", 2 ** 32 - 1, "B."), ("HSP_C", 19, ""),
                          ("HSP_D", 4, "four")])
        self.assertEqual(found.texts, {"HSP_S": "0.1"})
        self.assertEqual(found.macros["HSP_F"].parameters, ["a", "b"])
        self.assertEqual(found.macros["HSP_F"].text, "((a) + (b))")

    def test_a_constant_is_no_code(self):
        with self.assertRaises(ValueError):
            interface_of("#define HSP_A sizeof(int)\n")

    def test_a_header_that_is_not_listed(self):
        with self.assertRaises(ValueError):
            interface_of(DECLARED, listed=())

    def test_more_than_eight_arguments(self):
        comment = "F.\n@retval HSP_E_RANGE  a is 0"
        names = [f"uint32_t a{k}" for k in range(9)]
        self.assertEqual(function_of(", ".join(names[:8]), comment).open_questions, [])
        self.assertOpen("more than 8 arguments: a request and outputs have names", ", ".join(names), comment)


class Comments(Reading):
    def test_parts(self):
        f = function_of("const hsp_x *x", """\
            First one.
            More of it, see hsp_g.
             - Property 1: it holds.
            @retval HSP_OK          all is well
            @retval HSP_E_ARGUMENT  x is NULL; and so
                                    on""")
        self.assertEqual(f.brief, "First one.")
        self.assertEqual(f.prose, "First one. More of it, see hsp_g. - Property 1: it holds.")
        self.assertEqual(f.statuses, {"HSP_OK": "all is well", "HSP_E_ARGUMENT": "x is NULL; and so on"})
        self.assertEqual(function_row(f), "hsp_f(x handle) -> status E_ARGUMENT")

    def test_no_comment(self):
        found = interface_of("/* Not Doxygen's. */\nuint32_t hsp_f(uint32_t a);\n")
        self.assertEqual(found.open_questions(), ["hsp_f: what it does: there is no comment"])

    def test_parameters(self):
        arguments = "const double *a, double *b, hsp_row *c"
        comment = """\
            F.
            @param[in] a [n][3], or NULL
            @param[out] b [3], or NULL with n = 0
            @param[out] c a row"""
        self.assertEqual(self.argument("a", arguments, comment), "a array_in [n][3] or NULL")
        self.assertEqual(self.argument("b", arguments, comment), "b array_out [3] or NULL if empty")
        self.assertEqual(self.argument("c", arguments, comment), "c struct_out")
        self.assertOpen("an argument d, of which @param speaks", "const hsp_x *x",
                        "F.\n@param[in] d [3]\n@retval HSP_E_ARGUMENT  x is NULL")


class Kinds(Reading):
    ALL = "F.\n@retval HSP_E_ARGUMENT  a null pointer"

    def test_by_type(self):
        for arguments, row in (("hsp_x *a", "a handle"), ("hsp_x **a", "a handle_out"),
                               ("void *a, size_t bytes", "a memory"), ("void *a, size_t b", "a context or NULL"),
                               ("hsp_sink a", "a callback"),
                               ("const char *a", "a string"), ("double a", "a value"), ("double *a", "a value_out"),
                               ("const hsp_limits *a", "a sized_in"), ("hsp_limits *a", "a sized"),
                               ("const hsp_row *a", "a struct_in"), ("hsp_row *a", "a struct_out")):
            with self.subTest(arguments):
                self.assertEqual(self.argument("a", arguments, self.ALL), row)

    def test_capacity_and_needed(self):
        arguments = "double *totals, hsp_row *out, uint32_t capacity, uint32_t *needed"
        comment = "totals [9] and rows.\n@retval HSP_E_ARGUMENT  a null pointer"
        self.assertEqual(self.argument("out", arguments, comment), "out array_out [needed] held or NULL if empty")
        self.assertEqual(self.argument("totals", arguments, comment), "totals array_out [9]")
        self.assertEqual(self.argument("capacity", arguments, comment), "capacity")
        self.assertEqual(self.argument("needed", arguments, comment), "needed or NULL")

    def test_several_arrays_are_held(self):
        arguments = "double *a, double *b, uint32_t *first, uint32_t capacity, uint32_t *needed"
        comment = "a [n][3], b [n], first [n + 1].\n@retval HSP_E_ARGUMENT  needed is NULL"
        self.assertEqual(self.argument("a", arguments, comment), "a array_out [n][3] held or NULL")
        self.assertEqual(self.argument("b", arguments, comment), "b array_out [n] held or NULL")
        self.assertEqual(self.argument("first", arguments, comment), "first array_out [n + 1] or NULL")

    def test_words_hold_scratch_alone(self):
        arguments = "uint32_t *ids, uint32_t *scratch, uint32_t words, uint32_t *words_needed"
        comment = "ids [n].\n@retval HSP_E_ARGUMENT  words_needed is NULL"
        self.assertEqual(self.argument("scratch", arguments, comment), "scratch array_out [needed] held or NULL")
        self.assertEqual(self.argument("ids", arguments, comment), "ids array_out [n] or NULL")

    def test_first_and_count(self):
        comment = "Rows.\n@retval HSP_E_ARGUMENT  out is NULL with count > 0"
        self.assertEqual(self.argument("out", "uint32_t first, uint32_t count, hsp_row *out", comment),
                         "out array_out [count] or NULL if empty")

    def test_lengths_that_nobody_says(self):
        self.assertOpen("length of a", "const double *a", self.ALL)
        self.assertOpen("length of a", "double *a, hsp_row *out, uint32_t capacity, uint32_t *needed", self.ALL)

    def test_one_struct_or_several(self):
        self.assertOpen("whether a is one struct or several", "uint32_t poses, const hsp_row *a",
                        "Each of hit [poses].\n@retval HSP_E_ARGUMENT  a null pointer")
        self.assertOpen("whether a is one struct or several", "uint32_t count, const uint32_t *ball, hsp_row *a",
                        "Of ball [count].\n@retval HSP_E_ARGUMENT  a null pointer")
        self.assertEqual(self.argument("a", "uint32_t poses, const hsp_row *a",
                                       "For each a [poses].\n@retval HSP_E_ARGUMENT  a null pointer"),
                         "a array_in [poses]")

    def test_names_that_mean_something(self):
        self.assertOpen("what capacity is of: no pointer follows that becomes what is needed",
                        "hsp_x *x, uint32_t capacity", self.ALL)
        self.assertOpen("what first begins: no count follows", "hsp_x *x, uint32_t first", self.ALL)
        self.assertOpen("what [rows] of a is", "const double *a", "a [rows].\n@retval HSP_E_ARGUMENT  a null pointer")


class Fields(Reading):
    STRUCTS = """
typedef struct hsp_a_request {
  uint32_t struct_size;
  uint32_t reserved;
  double factor;
  const double *a; /**< [n][3], or NULL for ones */
  const hsp_limits *limits; /**< what there is */
} hsp_a_request;
typedef struct hsp_a_outputs {
  uint32_t struct_size;
  uint32_t capacity;
  uint32_t needed;
  uint32_t first_bad;
  hsp_row *row; /**< or NULL */
  double *b; /**< [n], or NULL: of each */
  double *c; /**< [9] */
  double *d;%s
} hsp_a_outputs;
"""
    ARGUMENTS = "const hsp_a_request *request, hsp_a_outputs *outputs"
    COMMENT = "F.\n@retval HSP_E_ARGUMENT  outputs is NULL"

    def test_each_is_an_argument(self):
        self.assertEqual(self.argument("request", self.ARGUMENTS, self.COMMENT, self.STRUCTS % "/**< [2] */"),
                         "request sized_in or NULL {factor value, a array_in [n][3] or NULL, limits sized_in}")
        self.assertEqual(self.argument("outputs", self.ARGUMENTS, self.COMMENT, self.STRUCTS % "/**< [2] */"),
                         "outputs {capacity, needed, first_bad value_out, row struct_out or NULL, "
                         "b array_out [n] held or NULL, c array_out [9], d array_out [2]}")

    def test_a_length_that_nobody_says(self):
        self.assertOpen("length of outputs->d", self.ARGUMENTS, self.COMMENT, self.STRUCTS % "")

    def test_a_request_that_is_written_is_a_struct_as_any(self):
        self.assertEqual(self.argument("a", "hsp_a_request *a", "F.\n@retval HSP_E_ARGUMENT  a is NULL",
                                       self.STRUCTS % ""), "a sized")


class Extents(Reading):
    BEFORE = """
/** a [n][3] is what it is.
 *  @retval HSP_E_ARGUMENT  a null pointer */
int32_t hsp_g(const double *a);
"""

    def test_of_a_function_that_is_named(self):
        for begin in ("As hsp_g.", "The same."):
            comment = f"{begin}\n@retval HSP_E_ARGUMENT  a null pointer"
            self.assertEqual(self.argument("a", "const double *a", comment, self.BEFORE), "a array_in [n][3]")

    def test_of_another_type_or_name_nothing_is_passed_on(self):
        comment = "As hsp_g.\n@retval HSP_E_ARGUMENT  a null pointer"
        self.assertOpen("length of a", "const uint32_t *a", comment, self.BEFORE)
        self.assertOpen("length of b", "const double *b", comment, self.BEFORE)

    def test_own_words_go_before_those_of_others(self):
        comment = "As hsp_g, but a [9].\n@retval HSP_E_ARGUMENT  a null pointer"
        self.assertEqual(self.argument("a", "const double *a", comment, self.BEFORE), "a array_in [9]")

    def test_names_are_whole_words(self):
        self.assertOpen("length of a", "const double *a", "beta [3], x.a [3].\n@retval HSP_E_ARGUMENT  a null pointer")


class Nulls(Reading):
    THREE = "const double *a, const double *b, uint32_t *c"

    def nulls(self, reasons, prose="a [n], b [n].", arguments=THREE, before=""):
        """Of each pointer the first letter of never, always, empty."""
        function = function_of(arguments, f"{prose}\n@retval HSP_E_ARGUMENT  {reasons}", before)
        self.assertEqual(function.open_questions, [])
        return "".join(a.null[0] for a in function.arguments if a.stars)

    def test_lists(self):
        self.assertEqual(self.nulls("a is NULL"), "naa")
        self.assertEqual(self.nulls("a or b is NULL; unknown flag"), "nna")
        self.assertEqual(self.nulls("a, b or c is NULL"), "nnn")

    def test_conditions(self):
        self.assertEqual(self.nulls("c is NULL; a or b is NULL with n > 0"), "een")
        self.assertEqual(self.nulls("b or c is NULL, or a with a count above 0"), "enn")
        self.assertEqual(self.nulls("a is NULL and n is not 0"), "eaa")

    def test_a_null_pointer(self):
        self.assertEqual(self.nulls("a null pointer"), "nnn")
        self.assertEqual(self.nulls("a null pointer", "a [n], b [n]; c may be NULL."), "nna")
        self.assertEqual(self.nulls("a null pointer", "a [n] and b [n] may each be NULL."), "aan")
        self.assertEqual(self.nulls("a null pointer", "a [n], b [n] may be NULL only if n is 0."), "een")
        self.assertEqual(self.nulls("a null pointer, but a and b with n = 0"), "een")
        self.assertEqual(self.nulls("a null pointer with n > 0"), "een")

    def test_as_for_another(self):
        self.assertEqual(self.nulls("as for hsp_g", "As hsp_g.", "const double *a", Extents.BEFORE), "n")
        self.assertEqual(self.nulls("as for hsp_g; b is NULL", "b [n]. As hsp_g.", "const double *a, const double *b",
                                    Extents.BEFORE), "nn")
        self.assertOpen("whether b may be NULL", "const double *a, const double *b",
                        "b [n]. As hsp_g.\n@retval HSP_E_ARGUMENT  as for hsp_g", Extents.BEFORE)

    def test_nothing_is_said(self):
        self.assertOpen("whether a may be NULL", "const double *a", "a [n].\n@retval HSP_E_ID  no such ball")

    def test_a_lone_output_array_may_be_NULL_where_it_has_no_room(self):
        arguments = "hsp_row *out, uint32_t capacity, uint32_t *needed"
        self.assertEqual(self.nulls("a null pointer", "Rows.", arguments), "ea")
        self.assertEqual(self.nulls("a null pointer", "a [n], b [n].",
                                    "double *a, double *b, uint32_t capacity, uint32_t *needed"), "nna")


class Memory(unittest.TestCase):
    """The list of handles that are not const."""
    def questions(self, functions, listed):
        declared = "".join(f"/** A. @retval HSP_E_ARGUMENT  x is NULL */\nint32_t {f};\n" for f in functions)
        interface = interface_of(DECLARED + declared)
        interface.text = f" * work in its own memory: {listed}. They stay.\n"
        return [row.split(":")[0] for row in interface.handles_left_open()]

    def test_the_list_is_that_of_the_declarations(self):
        functions = ["hsp_x_check(hsp_x *x)", "hsp_x_get_a(hsp_x *x)", "hsp_x_get_b(const hsp_x *x)",
                     "hsp_x_compute_with(hsp_x *x)", "hsp_y_group(hsp_x *x)", "hsp_x_set(hsp_x *x)"]
        self.assertEqual(self.questions(functions, "hsp_x_check, _get_a;\n *   hsp_y_group"), [])
        self.assertEqual(self.questions(functions, "hsp_x_check;\n *   hsp_y_group"), ["hsp_x_get_a"])
        self.assertEqual(self.questions(functions, "hsp_x_check, _get_a, _get_b; hsp_y_group"), ["hsp_x_get_b"])


class Tiers(unittest.TestCase):
    def questions(self, tier):
        return interface_of("/** A. */\nuint32_t hsp_a(void);\n", tier=tier).open_questions()

    def test_a_header_says_its_tier_once(self):
        self.assertEqual(self.questions("Stable: from version 1.0 on this stays as it is,\n * and is only added to."), [])
        self.assertEqual(self.questions("Stable."), ["x.h: whether it is stable or provisional"])
        both = " ".join(SENTENCES.values())
        self.assertEqual(self.questions(both), ["x.h: whether it is stable or provisional"])


if __name__ == "__main__":
    unittest.main()
