"""What is known of the interface, as data."""
import re
from dataclasses import dataclass, field

# Bytes of each scalar on every target; size_t has those of a pointer.
SCALARS = {"double": 8, "int32_t": 4, "uint32_t": 4, "uint8_t": 1, "int64_t": 8, "uint64_t": 8, "char": 1}


@dataclass
class Argument:
    """An argument of a function. `base` is its type without const and stars."""
    name: str
    base: str
    stars: int
    const: bool
    kind: str = ""  # one of kinds.KINDS
    extents: list[str] = field(default_factory=list)  # of an array, outermost first
    null: str = "never"  # whether it may be NULL: never, always, empty: where there is nothing to hold, or box: in one
    held: bool = False  # an output array that has to have room for what `needed` becomes
    fields: list["Argument"] = field(default_factory=list)  # of a request or of outputs

    @property
    def c(self):
        """Its declaration in C."""
        return f"{'const ' if self.const else ''}{self.base} {'*' * self.stars}{self.name}"


@dataclass
class Function:
    """A function with what its comment says. `result` is a status (int32_t), a number (uint32_t) or a text."""
    name: str
    result: str
    arguments: list[Argument]
    header: str
    comment: str
    brief: str = ""
    prose: str = ""
    statuses: dict[str, str] = field(default_factory=dict)  # from @retval: the reasons for each
    parameters: dict[str, str] = field(default_factory=dict)  # from @param
    open_questions: list[str] = field(default_factory=list)  # what no rule settles

    @property
    def noun(self):
        return self.header.removesuffix(".h")

    @property
    def pure(self):
        """Whether it makes a number of numbers alone."""
        return self.result == "uint32_t" and bool(self.arguments) and all(a.kind == "value" for a in self.arguments)

    def argument(self, name):
        return next((a for a in self.arguments if a.name == name), None)

    @property
    def c(self):
        """Its declaration in C, without the semicolon."""
        space = "" if self.result.endswith("*") else " "
        return f"{self.result}{space}{self.name}({', '.join(a.c for a in self.arguments) or 'void'})"


@dataclass
class Field:
    """A field of a struct. `base` is its type without const and stars; of a pointer to a function, `function`."""
    name: str
    base: str
    stars: int
    const: bool
    count: int
    remark: str
    c: str  # its declaration in C


@dataclass
class Struct:
    name: str
    fields: list[Field]
    header: str
    comment: str

    @property
    def sized(self):
        """Whether it says its own size, so that programs and libraries of different versions fit together."""
        return self.fields[0].name == "struct_size"


@dataclass
class Macro:
    """A macro with parameters, and the text that it stands for."""
    name: str
    parameters: list[str]
    text: str
    header: str


@dataclass
class Constant:
    name: str
    value: int
    header: str
    remark: str


@dataclass
class Interface:
    """All of it: headers in the order in which hardsphere.h says to read them, and so all the rest."""
    headers: dict[str, str] = field(default_factory=dict)  # and what each is for
    tiers: dict[str, str] = field(default_factory=dict)  # of each header: stable or provisional
    text: str = ""  # hardsphere.h
    open_headers: list[str] = field(default_factory=list)  # what they leave open
    functions: list[Function] = field(default_factory=list)
    structs: dict[str, Struct] = field(default_factory=dict)
    handles: dict[str, str] = field(default_factory=dict)  # and the header of each
    callbacks: dict[str, str] = field(default_factory=dict)  # and the declaration of each in C
    constants: dict[str, Constant] = field(default_factory=dict)
    homes: dict[str, str] = field(default_factory=dict)  # the header of each callback
    texts: dict[str, str] = field(default_factory=dict)  # constants that are texts
    macros: dict[str, Macro] = field(default_factory=dict)

    def function(self, name):
        return next((f for f in self.functions if f.name == name), None)

    def home_of(self, name):
        """The header that declares a type; None of those of C."""
        struct = self.structs.get(name)
        return struct.header if struct else self.handles.get(name) or self.homes.get(name)

    def structs_inside_first(self):
        """The structs, each behind those that it holds."""
        done = {}

        def add(struct):
            for part in struct.fields:
                if part.base in self.structs:
                    add(self.structs[part.base])
            done.setdefault(struct.name, struct)

        for struct in self.structs.values():
            add(struct)
        return list(done.values())

    def open_questions(self):
        """Rows `function: question`."""
        return self.open_headers + self.handles_left_open() + [
            f"{f.name}: {question}" for f in self.functions for question in f.open_questions]

    def handles_left_open(self):
        """What the list in MEMORY of hardsphere.h says of handles that are not const, against the declarations."""
        declared = {f.name for f in self.functions if f.arguments and f.arguments[0].kind == "handle"
                    and not f.arguments[0].const and not re.search(r"_(set|compute|find|move|undo)(_|$)", f.name)}
        listed, noun = set(), ""
        paragraph = self.text.partition("its own memory:")[2].partition(". ")[0]
        for name in re.findall(r"(?<!\w)(?:hsp)?_\w+", paragraph):
            if name.startswith("hsp_"):
                noun = "_".join(name.split("_")[:2])
            listed.add(name if name.startswith("hsp_") else noun + name)
        return [f"{name}: whether MEMORY in hardsphere.h lists it, as its handle is not const"
                for name in sorted(declared ^ listed)]
