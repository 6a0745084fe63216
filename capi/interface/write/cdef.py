"""The declarations without comments, in one file and without a preprocessor, as cffi and others read them."""


def cdef(interface):
    rows = ["/* The declarations of hardsphere.h. Generated from the headers by capi/interface/generate.sh. */"]
    rows += [f"typedef struct {handle} {handle};" for handle in interface.handles]
    rows += [f"{declaration};" for declaration in interface.callbacks.values()]
    for struct in interface.structs_inside_first():
        fields = (f"  {f.c};" for f in struct.fields)
        rows += [f"typedef struct {struct.name} {{", *fields, f"}} {struct.name};"]
    rows += [f"#define {constant.name} {constant.value}" for constant in interface.constants.values()]
    return "\n".join([*rows, *(f"{f.c};" for f in interface.functions), ""])
