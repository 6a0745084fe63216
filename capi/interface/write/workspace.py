"""The header of workspaces: what is the same for every handle, into workspace_template.h. The facts are those of the
module of workspaces, too."""
from pathlib import Path

from read.components import component_of_headers

from .template import filled, guarded

TEMPLATE = Path(__file__).with_name("workspace_template.h")
# The handles behind the model, in the order in which they stand in a workspace.
HANDLES = ("boundary", "topology", "view", "surface", "mesh", "map", "contacts", "cells", "paths", "pores",
           "moving", "periodic")
WIDTH = 120
# The functions of a workspace that make a handle, where they are not called as it.
MADE_BY = {"model": "set", "paths": "path"}
# Of a handle those that a second function, hsp_X_compute_, computes from it.
COMPUTED_FROM = {"periodic": ("pores",)}


def handles_of(interface):
    return [noun for noun in HANDLES if f"hsp_{noun}" in interface.handles]


def header_of(interface, noun):
    return interface.handles[f"hsp_{noun}"]


def dependents(interface, source):
    """The handles whose results end with those of another, and the function that computes each: all that come from a
    model end with it."""
    found = []
    for noun in handles_of(interface):
        compute = interface.function(f"hsp_{noun}_compute")
        sources = [a.base for a in compute.arguments[1:] if a.kind == "handle" and a.null == "never"] if compute else []
        if sources and source == "model" or f"hsp_{source}" in sources:
            found.append((noun, compute))
    return found + [(noun, interface.function(f"hsp_{noun}_compute_{source}")) for noun in COMPUTED_FROM.get(source, ())
                    if f"hsp_{noun}" in interface.handles]


def first_limits_from(interface, noun):
    """What the first limits of a handle are made from: `most_balls` of the workspace, `n` balls of its own, or the noun
    of another handle; None if that takes more."""
    given = [a.name for a in interface.function(f"hsp_{noun}_limits_init").arguments[2:]]
    if given != ["balls"]:
        return given[0] if len(given) == 1 else None
    compute = interface.function(f"hsp_{noun}_compute")
    return "n" if compute and compute.argument("n") else "most_balls"


def passed_on(compute):
    """The arguments of a function that a workspace does not have itself."""
    return [a for a in compute.arguments if a.kind != "handle" and a.name != "limits"]


def computed_by(interface, name):
    """Of a row `compute X_how`: X, "_how" or "", the function, and whether it is called with a request that has the
    executor of the workspace alone."""
    noun, join, how = name.removeprefix("compute ").partition("_")
    with_request = interface.function(f"hsp_{noun}_compute_with")
    asks = not how and with_request is not None and len(passed_on(with_request)) == 1
    return noun, join + how, with_request if asks else interface.function(f"hsp_{noun}_compute{join}{how}"), asks


def workspace_header(interface):
    def part(name):
        if name.startswith("compute "):
            noun, how, compute, asks = computed_by(interface, name)
            return compute_rows(compute, noun, how, asks)
        return {"fields": field_rows, "drop": drop_rows, "make": make_rows}[name](interface)

    return "\n".join(guarded(filled(TEMPLATE, r" */\* <(.*)> \*/", part).split("\n"), component_of_headers()))


def field_rows(interface):
    nouns = ("model", *HANDLES)
    fields = [(f"hsp_{noun} *{noun};", f"NULL before hsp_workspace_{MADE_BY.get(noun, noun)} "
               f"(hardsphere/{header_of(interface, noun)})") for noun in nouns]
    fields += [(f"void (*drop_{noun})(struct hsp_workspace *work);",
                f"drops its results (hardsphere/{header_of(interface, noun)})")
               for noun in dropped(interface)]
    fields += [("const hsp_executor *executor;", "or NULL, may be set: for all calls but of requests, views, maps, pores"),
               (f"void *memory[{len(nouns)}];", "memory of the handles"),
               ("uint32_t most_balls;", "how many balls the model has room for"), ("uint32_t reserved;", "0")]
    fields += [(f"hsp_{noun}_limits {noun}_limits;", f"what it has room for (hardsphere/{header_of(interface, noun)})")
               for noun in HANDLES]
    return [f"  {field} /**< {remark} */" for field, remark in fields]


def dropped(interface):
    """The handles that are made of others."""
    found = {noun for source in ("model", *HANDLES) for noun, _ in dependents(interface, source)}
    return [noun for noun in HANDLES if noun in found]


def drop_rows(interface):
    """A program refers to the functions of the handles that it makes and to no others."""
    rows = []
    for noun in dropped(interface):
        compute = interface.function(f"hsp_{noun}_compute")
        nothing = ", ".join("NULL" if a.stars else "0" for a in compute.arguments[1:])
        rows += [f"/* ---- {header_of(interface, noun)} */",
                 f"static inline void hsp_workspace_drop_{noun}(hsp_workspace *work) {{",
                 f"  if (work->{noun} != NULL) (void)hsp_{noun}_compute(work->{noun}, {nothing});",
                 "}", ""]
    for source in ("model", *HANDLES):
        if dependents(interface, source):
            rows += [f"/* ---- {header_of(interface, source)} */",
                     f"static inline void hsp_workspace_drop_of_{source}(hsp_workspace *work) {{",
                     "  (void)work;"]
            rows += [f"  if (work->drop_{noun} != NULL) work->drop_{noun}(work); /* hardsphere/{header_of(interface, noun)} */"
                     for noun, _ in dependents(interface, source)]
            rows += ["}", ""]
    return rows[:-1]


def make_rows(interface):
    rows = []
    for place, noun in enumerate(HANDLES, 1):
        rows += [f"/* ---- {header_of(interface, noun)} */",
                 f"static inline int32_t hsp_workspace_make_{noun}(hsp_workspace *work) {{",
                 "  size_t bytes = 0;",
                 f"  int32_t status = hsp_{noun}_bytes(&work->{noun}_limits, &bytes);",
                 f"  work->{noun} = NULL;",
                 *([f"  work->drop_{noun} = hsp_workspace_drop_{noun};"] if noun in dropped(interface) else []),
                 f"  if (status == HSP_OK) status = hsp_workspace_allocate(&work->memory[{place}], bytes);",
                 "  if (status == HSP_OK) {",
                 f"    status = hsp_{noun}_init(work->memory[{place}], bytes, &work->{noun}_limits, &work->{noun});",
                 "  }",
                 "  if (status == HSP_OK) return status;",
                 f"  return hsp_workspace_not_made(work, &work->{noun}_limits, sizeof work->{noun}_limits, status);",
                 "}", ""]
        source = first_limits_from(interface, noun)
        if source:
            own, given = (", uint32_t n", "n") if source == "n" else ("", f"work->{source}")
            rows += [f"static inline int32_t hsp_workspace_ready_{noun}(hsp_workspace *work{own}) {{",
                     "  int32_t status = HSP_OK;",
                     f"  if (work->{noun} != NULL) return HSP_OK;",
                     f"  if (work->{noun}_limits.struct_size == 0) {{",
                     f"    status = hsp_{noun}_limits_init(&work->{noun}_limits, sizeof work->{noun}_limits, {given});",
                     *([f"    if (status == HSP_E_RANGE) {{ /* more balls than it knows limits for: these grow */",
                        f"      status = hsp_{noun}_limits_init(&work->{noun}_limits, sizeof work->{noun}_limits, 0);",
                        "    }"] if source in ("n", "most_balls") else []),
                     "  }",
                     f"  return status == HSP_OK ? hsp_workspace_make_{noun}(work) : status;",
                     "}", "",
                     f"static inline int32_t hsp_workspace_grow_{noun}(hsp_workspace *work, "
                     f"const hsp_{noun}_limits *limits) {{",
                     f"  work->{noun}_limits = *limits;",
                     *([f"  hsp_workspace_drop_of_{noun}(work);"] if dependents(interface, noun) else []),
                     f"  return hsp_workspace_make_{noun}(work);",
                     "}", ""]
    return rows[:-1]


def request_rows(indent):
    """A request with the executor of the workspace alone."""
    return [f"{indent}memset(&request, 0, sizeof request);",
            f"{indent}request.struct_size = (uint32_t)sizeof request;",
            f"{indent}request.executor = work->executor;"]


def compute_rows(compute, noun, how, asks):
    """A function that computes a handle, and makes it larger until it suffices; how: "_with" a request, "_periodic" or
    ""; asks: whether the request has the executor of the workspace alone"""
    own = {"limits": "&limits"} | ({"request": "&request"} if asks else {}) | {a.name: f"work->{a.name}" for a in compute.arguments if a.kind == "handle"}
    call = f"{compute.name}({', '.join(own.get(a.name, a.name) for a in compute.arguments)})"
    begin, arguments = f"static inline int32_t hsp_workspace_{noun}{how}(", ["hsp_workspace *work"]
    for argument in () if asks else passed_on(compute):
        if len(begin + arguments[-1] + argument.c) > WIDTH - len(", ) {"):
            arguments.append(argument.c)
            continue
        arguments[-1] += f", {argument.c}"
    head = f",\n{' ' * len(begin)}".join(arguments)
    n = ", n" if compute.argument("n") else ""
    return [*f"{begin}{head}) {{".split("\n"),
            f"  int32_t status = hsp_workspace_ready_{noun}(work{n});",
            f"  hsp_{noun}_limits limits = work->{noun}_limits;",
            *([f"  hsp_{noun}_request request;", *request_rows("  ")] if asks else []),
            "  while (status == HSP_OK) {",
            f"    status = {call};",
            "    if (status != HSP_E_CAPACITY) return status;",
            f"    status = hsp_workspace_grow_{noun}(work, &limits);",
            "  }",
            "  return status;",
            "}"]
