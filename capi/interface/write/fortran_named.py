"""Functions of a request and outputs in Fortran: the same name with the fields as named optional arguments."""
from .fortran_rows import declaration, kind_of, remarked, wrapped


def takes_outputs(function):
    return any(a.kind == "outputs" for a in function.arguments)


def generic_rows(function):
    name = function.name
    return [f"    private :: {name}_named", f"    interface {name}", f"      procedure :: {name}, {name}_named",
            "    end interface"]


def fields_of(function):
    """Pairs of a field and of the argument that holds it: first what is asked, then where it goes, then numbers."""
    pairs = [(field, holder.name) for holder in function.arguments for field in holder.fields]
    numbers = [pair for pair in pairs if pair[1] == "outputs" and not pair[0].stars]
    return [pair for pair in pairs if pair not in numbers] + numbers


def named_rows(function):
    handle, fields = function.arguments[0], fields_of(function)
    names = ", ".join([handle.name, *(field.name for field, _ in fields)])
    rows = [f"  !> {function.name} with the fields of its request and outputs as arguments.",
            *wrapped(f"function {function.name}_named({names}) result(status)", 2, mark=" &"),
            f"    type(c_ptr), intent(in) :: {handle.name}"]
    for field, _ in fields:
        rows += remarked(f"    {declared(field)[0]}", declared(field)[1])
    rows += ["    integer(c_int32_t) :: status",
             *(f"    type({a.base}) :: {a.name}" for a in function.arguments if a.fields)]
    rows += [f"    if (present({field.name})) {holder}%{field.name} = {given(field)}" for field, holder in fields]
    rows.append(f"    status = {function.name}({handle.name}, request, outputs)")
    rows += [f"    if (present({field.name})) {field.name} = {holder}%{field.name}" for field, holder in fields
             if field.kind in ("needed", "value_out")]
    return [*rows, "  end function"]


def declared(field):
    """The declaration of a dummy argument, and a remark."""
    if not field.stars:
        intent = "inout" if field.kind in ("needed", "value_out") else "in"
        return f"{kind_of(field.base)}, intent({intent}), optional :: {field.name}", ""
    text, remark = declaration(field)
    return text.replace(", optional", "").replace(" ::", ", optional, target ::"), remark


def given(field):
    return f"c_loc({field.name})" if field.stars else field.name
