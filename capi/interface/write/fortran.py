"""The Fortran module. What is written by hand of it stands in fortran_template.f90."""
import re
from pathlib import Path

from .abi import struct_sizes
from .fortran_named import generic_rows, named_rows, takes_outputs
from .fortran_rows import WIDTH, declaration, kind_of, remarked, wrapped
from .template import filled

TEMPLATE = Path(__file__).with_name("fortran_template.f90")
# Differences of Fortran from the header.
NOTES = {
    "hsp_status_text": "A pointer to C characters; hsp_status_message below returns the same as a Fortran string.",
    "hsp_query_pairs": "Row i, from 0 on, is ids(first(i + 1) + 1 : first(i + 2)).",
    "hsp_pose_from_matrix": "The matrix is row by row, as in C: transpose Fortran's.",
    "hsp_periodic_query_pairs": "Row i, from 0 on, is out(first(i + 1) + 1 : first(i + 2)).",
}


def fortran_module(interface):
    sizes = struct_sizes(interface)
    named = [f for f in interface.functions if takes_outputs(f)]
    parts = {
        "constants": sections(interface, "  ", interface.constants.values(), constant_rows),
        "types": sections(interface, "  ", interface.structs_inside_first(),
                          lambda struct: type_rows(struct, sizes[struct.name]), apart=True),
        "functions": sections(interface, "    ", interface.functions, function_rows, apart=True),
        "generics": sections(interface, "    ", named, generic_rows, apart=True),
        "named": sections(interface, "  ", named, named_rows, apart=True),
        "bounds": sections(interface, "  ", bounds_of(interface), bound_rows, apart=True),
    }
    texts = [f"  character(*), parameter :: {name} = '{text}'" for name, text in interface.texts.items()]
    parts["constants"][2:2] = texts  # all of them are in version.h, the first header
    return filled(TEMPLATE, r" *! <(\w+)>", parts.get, interface.headers)


def sections(interface, indent, items, rows_of, apart=False):
    """The rows of all items, header by header, and a row that ends the last; `apart`: an empty row between items."""
    rows, items = [], list(items)
    for header, subject in interface.headers.items():
        own = [item for item in items if item.header == header]
        if own:
            title = f"{indent}! ---- {header}: {subject} "
            rows += [title[:WIDTH].ljust(WIDTH, "-"), ""]
        for item in own:
            rows += rows_of(item) + ([""] if apart else [])
        if own and not apart:
            rows.append("")
    return [*rows, f"{indent}! ----"]


def constant_rows(constant):
    value = constant.value - 2 ** 32 if constant.value >= 2 ** 31 else constant.value
    return remarked(f"  integer(c_int32_t), parameter :: {constant.name} = {value}_c_int32_t", constant.remark)


def kind_of_field(field):
    return "type(c_funptr)" if field.base == "function" else "type(c_ptr)" if field.stars else kind_of(field.base)


def type_rows(struct, sizes=()):
    """`sizes`: its bytes with pointers of 8 bytes and of 4, for the default of struct_size."""
    declared = [f"    {kind_of_field(f)} :: {f.name}{f'({f.count})' if f.count > 1 else ''}" for f in struct.fields]
    if struct.sized and sizes:
        # Zero means default in requests and outputs, and none in executors.
        if struct.name.endswith(("_request", "_outputs", "_executor")):
            declared = [row + initial(f) for row, f in zip(declared, struct.fields)]
        pointers = (sizes[0] - sizes[1]) // 4
        more = f" + {pointers} * pointer_bytes" if pointers else ""
        declared[0] += f" = {sizes[1] - 4 * pointers}_c_int32_t{more}"
    column = max(len(row) for row in declared)
    rows = [row for d, f in zip(declared, struct.fields) for row in remarked(d, f.remark, column)]
    return [f"  type, bind(C) :: {struct.name}", *rows, "  end type"]


def initial(field):
    """The default of a field whose C default is 0; that of struct_size follows."""
    kind = kind_of_field(field)
    if field.name == "struct_size":
        return ""
    return " = " + ("c_null_funptr" if kind == "type(c_funptr)" else "c_null_ptr" if field.stars
                    else f"0.0_{kind[5:-1]}" if kind.startswith("real") else f"0_{kind[8:-1]}")


def function_rows(function):
    result = {"int32_t": "status", "const char *": "text"}.get(function.result, "found")
    kind = "type(c_ptr)" if function.result == "const char *" else kind_of(function.result)
    declared = [declaration(a) for a in function.arguments]
    own = f"{kind} :: {result}"
    names = ", ".join(a.name for a in function.arguments)
    head = (f"{'pure ' if function.pure else ''}function {function.name}({names}) result({result})"
            f" bind(C,\xa0name=\"{function.name}\")")
    rows = wrapped(NOTES[function.name], 4, "! ") if function.name in NOTES else []
    rows += wrapped(head, 4, mark=" &")
    rows += wrapped(f"import :: {', '.join(imported([d for d, _ in declared] + [own]))}", 6, mark=" &")
    rows += [row for d, remark in declared for row in remarked(f"      {d}", remark)]
    return [*rows, f"      {own}", "    end function"]


def imported(rows):
    return sorted(set(re.findall(r"\bc_[a-z0-9_]+|(?<=type\()hsp_\w+", " ".join(rows))))


def bounds_of(interface):
    return [macro for macro in interface.macros.values() if macro.name.endswith("_BYTES")]


def bound_rows(macro):
    """HSP_X_BYTES, a sum of numbers and of numbers times a parameter, as a function."""
    terms = []
    for term in macro.text.replace(" ", "")[1:-1].split("+"):
        found = re.fullmatch(r"\(size_t\)(\d+)(?:\*\(size_t\)\((\w+)\))?", term)
        if not found or found[2] and found[2] not in macro.parameters:
            raise ValueError(f"{macro.name}: no sum of products: {term}")
        terms.append(f"{found[1]}_c_size_t" + (f"*int({found[2]},\xa0c_size_t)" if found[2] else ""))
    names = ", ".join(macro.parameters)
    return [f"  !> {macro.name} of the header, for the size of an allocation.",
            *wrapped(f"pure function {macro.name.lower()}_bound({names}) result(bytes)", 2, mark=" &"),
            *wrapped(f"integer(c_int32_t), intent(in) :: {names}", 4, mark=" &"),
            "    integer(c_size_t) :: bytes",
            *wrapped("bytes = " + " +\xa0".join(terms), 4, mark=" &"), "  end function"]
