"""The declarations of the C interface for Rust and for Julia: constants, structs, functions, as they are."""
import re

RUST = {"double": "f64", "int32_t": "i32", "uint32_t": "u32", "uint8_t": "u8", "int64_t": "i64", "uint64_t": "u64",
        "size_t": "usize", "char": "c_char", "void": "c_void"}
JULIA = {"double": "Cdouble", "int32_t": "Int32", "uint32_t": "UInt32", "uint8_t": "UInt8", "int64_t": "Int64",
         "uint64_t": "UInt64", "size_t": "Csize_t", "char": "Cchar", "void": "Cvoid"}
RUST_KEYWORDS = ("as async await box break const continue dyn else enum extern false final fn for if impl in let loop"
                 " macro match mod move mut pub ref return self static struct super trait true try type typeof unsafe"
                 " unsized use virtual where while yield").split()
JULIA_KEYWORDS = ("baremodule begin break catch const continue do else elseif end export false finally for function"
                  " global if import let local macro module quote return struct true try using while").split()
WIDTH = 120
GENERATED = "Generated from the headers by capi/interface/generate.sh."


def rust_declarations(interface):
    rows = [f"// The C interface of hardsphere, for Rust. {GENERATED}",
            "// To link it: rustc program.rs -L PREFIX/lib -l static=hardsphere -l m, of an installed archive; C++'s library is not needed.",
            "// All editions: that of 2024 wants `unsafe extern`, which compilers before 1.82 do not know.",
            "#![allow(dead_code, non_camel_case_types)]", "use std::os::raw::{c_char, c_void};", ""]
    for constant in interface.constants.values():
        kind = "i32" if constant.value < 0 or constant.name == "HSP_OK" else "u32"
        rows.append(f"pub const {constant.name}: {kind} = {constant.value};")
    for handle in interface.handles:
        rows += ["", "#[repr(C)]", f"pub struct {handle} {{", "    _private: [u8; 0],", "}"]
    rows.append("")
    for name, declared in interface.callbacks.items():
        rows.append(f"pub type {name} = {rust_function(declared)};")
    for struct in interface.structs_inside_first():
        rows += ["", "#[repr(C)]", "#[derive(Clone, Copy)]", f"pub struct {struct.name} {{"]
        rows += [f"    pub {rust_name(f.name)}: {rust_field(interface, f)}," for f in struct.fields]
        rows.append("}")
    # Of a macro the branch that is taken is compiled, and `_` is an expression from edition 2024 on.
    rows += ["", "macro_rules! functions {",
             '    ($of_2024:expr => $($declared:tt)*) => { unsafe extern "C" { $($declared)* } };',
             '    (_ => $($declared:tt)*) => { extern "C" { $($declared)* } };', "}", "", "functions! { _ =>"]
    for function in interface.functions:
        arguments = [f"{rust_name(a.name)}: {rust_type(interface, a)}" for a in function.arguments]
        result = "*const c_char" if function.result == "const char *" else RUST[function.result]
        rows += wrapped(f"    pub fn {function.name}(", arguments, f") -> {result};", 8)
    return "\n".join([*rows, "}", ""])


def rust_name(name):
    return f"r#{name}" if name in RUST_KEYWORDS else name


def rust_pointed(base, stars, const):
    inner = RUST.get(base, base)
    for _ in range(stars):
        inner = f"*{'const' if const else 'mut'} {inner}"
    return inner


def rust_type(interface, argument):
    """Callbacks are types of pointers, or of functions to which there are pointers."""
    if argument.base in interface.callbacks:
        return f"Option<{argument.base}>"
    return rust_pointed(argument.base, argument.stars, argument.const)


def rust_field(interface, field):
    if field.base == "function":
        return f"Option<{rust_function(field.c)}>"
    kind = rust_type(interface, field)
    return f"[{kind}; {field.count}]" if field.count > 1 else kind


def parts_of(declared):
    """The result and the arguments, as base, stars and const, of the declaration of a function or of a pointer to one."""
    found = re.fullmatch(r"(?:typedef )?(\w+) (?:\(\*\w+\)|\w+)\((.*)\)", declared)
    arguments = []
    for text in found[2].split(", "):
        const, base, stars = re.match(r"(const )?(\w+) ?(\**)", text).groups()
        arguments.append((base, len(stars), bool(const)))
    return found[1], arguments


def rust_function(declared):
    """hsp_task * is a pointer to a function, which Rust's types of functions are already."""
    result, arguments = parts_of(declared)
    kinds = [f"Option<{base}>" if base == "hsp_task" else rust_pointed(base, stars, const)
             for base, stars, const in arguments]
    returned = "" if result == "void" else f" -> {RUST[result]}"
    return f'unsafe extern "C" fn({", ".join(kinds)}){returned}'


def julia_declarations(interface):
    rows = [f"# The C interface of hardsphere, for Julia. {GENERATED}",
            "# HARDSPHERE_LIBRARY names the shared library; without it the system's loader finds one.",
            "module HardsphereC", "", 'const libhardsphere = get(ENV, "HARDSPHERE_LIBRARY", "libhardsphere.so.2")', ""]
    for constant in interface.constants.values():
        kind = "Int32" if constant.value < 0 or constant.name == "HSP_OK" else "UInt32"
        rows.append(f"const {constant.name} = {kind}({constant.value})")
    rows += ["", *(f"mutable struct {handle} end" for handle in interface.handles)]
    for struct in interface.structs_inside_first():
        rows += ["", f"struct {struct.name}"]
        rows += [f"    {julia_name(f.name)}::{julia_field(interface, f)}" for f in struct.fields]
        rows.append("end")
    for function in interface.functions:
        names = [julia_name(a.name) for a in function.arguments]
        kinds = [julia_type(interface, a) for a in function.arguments]
        result = "Cstring" if function.result == "const char *" else JULIA[function.result]
        listed = f"({', '.join(kinds)}{',' if len(kinds) == 1 else ''})"
        call = f"ccall((:{function.name}, libhardsphere), {result}, {listed}{''.join(f', {n}' for n in names)})"
        rows += ["", *filled(f"function {function.name}({', '.join(names)})", 4), *filled(f"    {call}", 10), "end"]
    return "\n".join([*rows, "", "end", ""])


def julia_name(name):
    return f'var"{name}"' if name in JULIA_KEYWORDS else name


def julia_type(interface, part):
    if part.base in interface.callbacks or part.base == "function":
        return "Ptr{Cvoid}"
    inner = JULIA.get(part.base, part.base)
    for _ in range(part.stars):
        inner = f"Ptr{{{inner}}}"
    return inner


def julia_field(interface, field):
    kind = julia_type(interface, field)
    return f"NTuple{{{field.count}, {kind}}}" if field.count > 1 else kind


def filled(text, indent):
    """A row in as many as it takes, broken behind commas."""
    rows = []
    while len(text) > WIDTH:
        cut = text.rfind(", ", 0, WIDTH) + 1
        rows.append(text[:cut])
        text = " " * indent + text[cut + 1:]
    return [*rows, text]


def wrapped(begin, parts, end, indent):
    """In one row, or each part in one of its own."""
    row = begin + ", ".join(parts) + end
    if len(row) <= WIDTH:
        return [row]
    return [begin, *(f"{' ' * indent}{part}," for part in parts), " " * (indent - 4) + end]
