"""The declarations in the headers, by a C parser, and their macros, by the C preprocessor."""
import re
import subprocess
from pathlib import Path

from pycparser import c_ast, c_parser, c_generator

from .comments import comment_before, remark_at
from .interface import Argument, Constant, Field, Function, Interface, Macro, Struct

STUBS = Path(__file__).parent / "stubs"


def read_declarations(include):
    """What the headers of a folder declare, in the order in which hardsphere.h lists them."""
    include = Path(include)
    interface = Interface()
    listed = re.findall(r"\* +hardsphere/(\w+\.h) +(.*)", (include / "hardsphere.h").read_text())
    interface.headers = dict(listed)
    interface.text = (include / "hardsphere.h").read_text()
    rows = {name: (include / "hardsphere" / name).read_text().split("\n") for name in interface.headers}
    by_header = {name: [] for name in interface.headers}
    for node in c_parser.CParser().parse(preprocessed(include), "headers").ext:
        header = Path(node.coord.file).name
        if header in by_header:
            by_header[header].append(node)
        elif header not in ("stddef.h", "stdint.h"):
            raise ValueError(f"hardsphere.h does not list {header}")
    for header, nodes in by_header.items():
        for node in nodes:
            take(interface, node, header, rows[header])
    read_macros(interface, include, rows)
    return interface


def preprocessed(include, *options):
    command = ["cc", "-E", "-nostdinc", f"-I{STUBS}", f"-I{include}", "-DHSP_API=", "-DHSP_CALL=",
               "-D__attribute__(text)=", *options, f"{include}/hardsphere.h"]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def take(interface, node, header, rows):
    """Adds what a node of the parser declares."""
    if isinstance(node, c_ast.Decl) and isinstance(node.type, c_ast.FuncDecl):
        interface.functions.append(function_of(node, header, rows))
    elif isinstance(node, c_ast.Typedef) and isinstance(node.type, (c_ast.PtrDecl, c_ast.FuncDecl)):
        interface.callbacks[node.name] = c_generator.CGenerator().visit(node)
        interface.homes[node.name] = header
    elif isinstance(node, c_ast.Typedef) and node.type.type.decls is None:
        interface.handles[node.name] = header
    elif isinstance(node, c_ast.Typedef):
        struct = node.type.type
        interface.structs[node.name] = Struct(node.name, [field_of(part, rows) for part in struct.decls], header,
                                              comment_before(rows, struct.coord.line))


def function_of(node, header, rows):
    base, stars, const = type_of(node.type.type)
    result = f"{'const ' if const else ''}{base}{' *' if stars else ''}"
    arguments = [Argument(part.name, *type_of(part.type)) for part in node.type.args.params if part.name]
    return Function(node.name, result, arguments, header, comment_before(rows, node.coord.line))


def field_of(part, rows):
    count, kind, declared = 1, part.type, c_generator.CGenerator().visit(part)
    if isinstance(kind, c_ast.ArrayDecl):
        count, kind = int(kind.dim.value), kind.type
    if isinstance(kind, c_ast.PtrDecl) and isinstance(kind.type, c_ast.FuncDecl):
        base, stars, const = "function", 1, False
    else:
        base, stars, const = type_of(kind)
    return Field(part.name, base, stars, const, count, remark_at(rows, part.coord.line), declared)


def type_of(node):
    """Name, stars, and whether what they lead to is const."""
    stars = 0
    while isinstance(node, c_ast.PtrDecl):
        stars, node = stars + 1, node.type
    name = node.type.name if isinstance(node.type, c_ast.Struct) else " ".join(node.type.names)
    return name, stars, "const" in node.quals


def read_macros(interface, include, rows):
    """Adds constants with their values, texts, and macros with parameters."""
    header, constants, macros, texts = None, {}, {}, {}
    for row in preprocessed(include, "-dD").split("\n"):
        place = re.match(r'# \d+ "([^"]*)"', row)
        if place:
            header = Path(place[1]).name
        found = re.match(r"#define (HSP_[A-Z0-9_]+)(\([a-z_, ]+\))? +(.+)", row)
        if not found or header not in rows:  # such as HSP_API in export.h
            continue
        name, parameters, text = found.groups()
        if parameters:
            names = [p.strip() for p in parameters[1:-1].split(",")]
            macros[name] = Macro(name, names, text, header)
        elif text.startswith('"'):
            texts[name] = text.strip('"')
        else:
            line = next(k for k, line in enumerate(rows[header], 1) if re.match(rf"#define {name}\b", line))
            constants[name] = Constant(name, value_of(text, constants), header, remark_at(rows[header], line))
    order = list(interface.headers)
    for found, all_of_them in (constants, interface.constants), (macros, interface.macros):
        all_of_them.update(sorted(found.items(), key=lambda item: order.index(item[1].header)))
    interface.texts = texts


def value_of(text, constants):
    """The value of a constant expression of whole numbers and of constants before it."""
    text = re.sub(r"UINT32_C\((\w+)\)", r"\1", text)
    text = re.sub(r"HSP_\w+", lambda name: str(constants[name[0]].value), text)
    if not re.fullmatch(r"[0-9A-Fa-fx ()+*-]+", text):
        raise ValueError(f"no constant expression: {text}")
    return eval(text, {"__builtins__": {}})
