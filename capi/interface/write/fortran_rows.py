"""What the Fortran modules are made of: rows of no more than 120 characters, types, declarations of dummy arguments."""

WIDTH = 120
KINDS = {"double": "real(c_double)", "int32_t": "integer(c_int32_t)", "uint32_t": "integer(c_int32_t)",
         "uint8_t": "integer(c_int8_t)", "uint64_t": "integer(c_int64_t)", "int64_t": "integer(c_int64_t)",
         "size_t": "integer(c_size_t)", "char": "character(kind=c_char)"}


def wrapped(text, indent, begin="", mark=""):
    """A text over as many rows as it takes; `begin` stands before each, `mark` at the end of those that go on. Parts
    that stay together have \\xa0 for spaces."""
    rows, lead = [], " " * indent + begin
    while len(lead) + len(text) > WIDTH:
        cut = text.rfind(" ", 0, WIDTH - len(lead) - len(mark))
        rows.append(lead + text[:cut] + mark)
        text, lead = text[cut + 1:], " " * (indent + (0 if begin else 2)) + begin
    return [row.replace("\xa0", " ") for row in (*rows, lead + text)]


def remarked(declared, remark, column=0):
    """A declaration with a remark behind it, or before it if it is too long for that."""
    row = f"{declared.ljust(column)}  ! {remark}" if remark else declared
    indent = len(declared) - len(declared.lstrip())
    return [row] if len(row) <= WIDTH else [*wrapped(remark, indent, "! "), declared]


def kind_of(base):
    return KINDS.get(base, f"type({base})")


REMARKS = {"always": "may be c_null_ptr", "box": "c_null_ptr in a box"}


def declaration(argument):
    """The declaration of a dummy argument, and a remark."""
    name = argument.name
    if argument.kind in ("handle", "memory", "context"):
        return f"type(c_ptr), value :: {name}", REMARKS.get(argument.null, "")
    if argument.kind == "handle_out":
        return f"type(c_ptr), intent(inout) :: {name}", ""
    if argument.kind == "callback":
        return f"type(c_funptr), value :: {name}", f"of a function with the interface {argument.base}"
    if not argument.stars:
        return f"{kind_of(argument.base)}, value :: {name}", ""
    optional = "" if argument.null == "never" else ", optional"
    if argument.kind == "string":
        return f"character(kind=c_char), intent(in){optional} :: {name}(*)", "ends with c_null_char"
    extents, remark = extents_of(argument)
    intent = "in" if argument.const else "inout"
    return f"{kind_of(argument.base)}, intent({intent}){optional} :: {name}{extents}", remark


def extents_of(argument):
    """C's [n][3] is (3, *), and the remark says 3, n. What has four forms for each edge is numbered from 0, as in C."""
    if not argument.extents:
        return "", ""
    first, *inner = argument.extents
    inner = inner[::-1]
    if first.isdigit():
        return f"({', '.join([*inner, first])})", ""
    if inner == ["4"]:
        return "(0:3, 0:*)", f"4, {first}"
    return f"({', '.join([*inner, '*'])})", ", ".join([*inner, first])
