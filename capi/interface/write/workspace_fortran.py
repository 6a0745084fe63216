"""The Fortran module of workspaces: what is the same for every handle, into workspace_template.f90."""
from pathlib import Path

from .fortran_rows import declaration, wrapped
from .template import filled
from .workspace import computed_by, dependents, first_limits_from, handles_of, header_of, passed_on

TEMPLATE = Path(__file__).with_name("workspace_template.f90")
SELF = "    class(hsp_workspace), intent(inout), target :: self"
STATUS = "    integer(c_int32_t) :: status"


def workspace_module(interface):
    def part(name):
        if name.startswith("compute "):
            noun, how, compute, asks = computed_by(interface, name)
            # A request alone is an argument that need not be there.
            alone = how == "_with" and len(passed_on(compute)) == 1
            return compute_rows(compute, noun, f"compute_{noun}{'' if alone else how}", asks, alone)
        return {"fields": field_rows, "private": private_rows, "drop": drop_rows, "make": make_rows}[name](interface)

    return filled(TEMPLATE, r" *! <(.*)>", part, interface.headers)


def field_rows(interface):
    def remark(noun):
        return f" ! hardsphere/{header_of(interface, noun)}"

    return [*(f"    type(c_ptr) :: {noun} = c_null_ptr{remark(noun)}" for noun in ("model", *handles_of(interface))),
            "    type(c_ptr) :: executor = c_null_ptr ! may be set: for all calls but of requests, views, maps, pores",
            "    integer(c_int32_t), private :: most_balls = 0",
            f"    type(memory_block), private :: memory({1 + len(handles_of(interface))})",
            *(f"    type(hsp_{noun}_limits), private :: {noun}_limits{remark(noun)}" for noun in handles_of(interface))]


def private_rows(interface):
    names = [row.split("(")[0].split()[-1] for row in [*drop_rows(interface), *make_rows(interface)]
             if row.startswith(("  function", "  subroutine"))]
    return [f"  private :: {', '.join(own)} ! hardsphere/{header_of(interface, noun)}" for noun in ("model", *handles_of(interface))
            if (own := [name for name in names if name.endswith(f"_{noun}")])]


def drop_rows(interface):
    rows = []
    for source in ("model", *handles_of(interface)):
        if dependents(interface, source):
            rows += [f"  ! ---- {header_of(interface, source)}", f"  subroutine drop_of_{source}(self)", SELF,
                     "    integer(c_int32_t) :: ignored",
                     "    ! Where a build leaves out all others, this line keeps both names in use.",
                     "    if (.not. c_associated(self%model)) ignored = HSP_OK"]
            for noun, compute in dependents(interface, source):
                nothing = ", ".join(nothing_for(a) for a in compute.arguments[1:]
                                    if a.kind == "handle" or a.null == "never")
                call = f"{compute.name}(self%{noun}, {nothing})"
                remark = f" ! hardsphere/{header_of(interface, noun)}"
                rows += [row + remark for row in
                         wrapped(f"if (c_associated(self%{noun})) ignored = {call}", 4, mark=" &".ljust(len(remark)))]
            rows += ["  end subroutine", ""]
    return rows[:-1]


def nothing_for(argument):
    """What stands for an argument that has to be there, where another one is refused in any case."""
    if argument.kind == "handle":
        return f"{argument.name}=c_null_ptr"
    if argument.extents:
        return f"{argument.name}=[real(c_double) :: {', '.join(['0'] * int(argument.extents[0]))}]"
    return f"{argument.name}=0.0_c_double"


def make_rows(interface):
    rows = []
    for place, noun in enumerate(handles_of(interface), 2):
        memory = f"self%memory({place})"
        rows += [f"  ! ---- {header_of(interface, noun)}", f"  function make_{noun}(self) result(status)", SELF, STATUS, "    integer(c_size_t) :: bytes",
                 f"    self%{noun} = c_null_ptr",
                 f"    status = hsp_{noun}_bytes(self%{noun}_limits, bytes)",
                 f"    if (status == HSP_OK) status = allocated_to({memory}, bytes)",
                 *wrapped(f"if (status == HSP_OK) status = hsp_{noun}_init(c_loc({memory}%bytes), bytes, "
                          f"self%{noun}_limits, self%{noun})", 4, mark=" &"),
                 "    if (status /= HSP_OK) self%most_balls = 0",
                 "  end function", ""]
        source = first_limits_from(interface, noun)
        if source:
            size = f"self%{noun}_limits%struct_size"
            given = f"{size}, {'n' if source == 'n' else f'self%{source}'}"
            rows += [f"  function ready_{noun}(self{', n' if source == 'n' else ''}) result(status)", SELF,
                     *(["    integer(c_int32_t), intent(in) :: n"] if source == "n" else []), STATUS,
                     "    status = HSP_OK",
                     f"    if (c_associated(self%{noun})) return",
                     *wrapped(f"status = hsp_{noun}_limits_init(self%{noun}_limits, {given})", 4, mark=" &"),
                     *(["    ! More balls than it knows limits for: these grow.",
                        f"    if (status == HSP_E_RANGE) &",
                        f"      status = hsp_{noun}_limits_init(self%{noun}_limits, {size}, 0_c_int32_t)"]
                       if source in ("n", "most_balls") else []),
                     f"    if (status == HSP_OK) status = make_{noun}(self)",
                     "  end function", "",
                     f"  function grow_{noun}(self, limits) result(status)", SELF,
                     f"    type(hsp_{noun}_limits), intent(in) :: limits", STATUS,
                     f"    self%{noun}_limits = limits",
                     *([f"    call drop_of_{noun}(self)"] if dependents(interface, noun) else []),
                     f"    status = make_{noun}(self)",
                     "  end function", ""]
    return rows[:-1]


def compute_rows(compute, noun, name, asks, alone):
    """A function that computes a handle, and makes it larger until it suffices; asks: with a request that has the
    executor of the workspace alone; alone: with such a one where the caller's is not there."""
    own = {a.name: f"self%{a.name}" for a in compute.arguments if a.kind == "handle"}
    if asks or alone:
        own["request"] = "asked"
    call = f"{compute.name}({', '.join(own.get(a.name, a.name) for a in compute.arguments)})"
    arguments = [] if asks else passed_on(compute)
    names = ", ".join(["self", *(a.name for a in arguments)])
    n = ", n" if compute.argument("n") else ""
    return [*wrapped(f"function {name}({names}) result(status)", 2, mark=" &"), SELF,
            *(f"    {declaration(a)[0]}" for a in arguments),
            f"    type(hsp_{noun}_limits) :: limits",
            *([f"    type(hsp_{noun}_request) :: asked"] if asks or alone else []), STATUS,
            *(["    asked%executor = self%executor"] if asks or alone else []),
            *(["    if (present(request)) asked = request"] if alone else []),
            f"    status = ready_{noun}(self{n})",
            f"    limits = self%{noun}_limits",
            "    do while (status == HSP_OK)",
            f"      status = {call}",
            "      if (status /= HSP_E_CAPACITY) return",
            f"      status = grow_{noun}(self, limits)",
            "    end do",
            "  end function"]
