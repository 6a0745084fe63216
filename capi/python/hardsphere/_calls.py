"""Calls of the shared library by ctypes, as `_interface.py` describes its functions: arrays in and out, memory that
grows, statuses as exceptions. numpy's arrays come back where numpy is there, and lists where it is not."""
from __future__ import annotations

import copy
import ctypes as C
import ctypes.util
import math
import operator
import os
import threading
from _thread import allocate_lock, start_new_thread
from contextlib import contextmanager, suppress
from keyword import iskeyword
from types import SimpleNamespace
from typing import Any, Callable, Iterable, Iterator, NamedTuple

try:
    import numpy
except ImportError:
    numpy = None  # type: ignore[assignment]

_NONE, _ABI = 0xFFFFFFFF, 2
_ARGUMENT, _CAPACITY, _REFUSED, _NOT_FINITE, _NEGATIVE, _RANGE, _CONFLICT, _EXECUTOR = -1, -2, -7, -10, -11, -12, -13, -15
_SCALARS = {"double": C.c_double, "int32_t": C.c_int32, "uint32_t": C.c_uint32, "uint8_t": C.c_uint8,
            "int64_t": C.c_int64, "uint64_t": C.c_uint64, "size_t": C.c_size_t}
_WHOLE = set(_SCALARS) - {"double", "uint8_t"}
_SINK = C.CFUNCTYPE(C.c_int32, C.c_void_p, C.POINTER(C.c_char), C.c_size_t)
_TASK = C.CFUNCTYPE(None, C.c_void_p, C.c_uint32)
_LOOP = C.CFUNCTYPE(C.c_int32, C.c_void_p, C.c_uint32, _TASK, C.c_void_p)


def _load() -> C.CDLL:
    here = os.path.dirname(os.path.abspath(__file__))
    chosen = os.environ.get("HARDSPHERE_LIBRARY")
    if chosen:
        return C.CDLL(chosen)
    for name in (os.path.join(here, f"libhardsphere.so.{_ABI}"), os.path.join(here, "libhardsphere.so"),
                 os.path.join(here, "../../..", f"libhardsphere.so.{_ABI}"),  # as it is installed
                 f"libhardsphere.so.{_ABI}", ctypes.util.find_library("hardsphere")):
        with suppress(OSError):
            if name:
                return C.CDLL(name)
    raise ImportError(f"there is no libhardsphere.so.{_ABI}: build it with -DBUILD_SHARED_LIBS=ON and set "
                      "HARDSPHERE_LIBRARY to it")


library = _load()
library.hsp_status_text.restype = C.c_char_p
if library.hsp_abi() != _ABI:
    raise ImportError(f"the library has ABI number {library.hsp_abi()}, and this module is for {_ABI}")


def _again(kind: type[ValueError], args: tuple[Any, ...], fields: dict[str, Any]) -> ValueError:
    """An exception of ours in another process, which has its text and not what it was made of."""
    made = kind.__new__(kind, *args)
    made.__dict__.update(fields)
    return made


class _Portable(ValueError):
    """An exception that comes whole from another process."""

    def __reduce__(self) -> Any:
        return _again, (type(self), self.args, self.__dict__)


class Error(_Portable):
    """A call failed. `status` is one of hardsphere.E_*, `ball` the index of the ball to blame, or None. `conflict` says
    which sticks or bricks do not fit together, or which brick is missing: a SticksConflict or a number, else None."""

    def __init__(self, status: int, ball: int = _NONE, where: str = "", given: dict[str, Any] | None = None,
                 conflict: Any = None):
        self.status, self.ball, self.conflict = status, None if ball == _NONE else ball, conflict
        text = library.hsp_status_text(status).decode()
        named = self.ball is None and _to_blame(status, given or {})
        super().__init__(f"{named or text}{'' if self.ball is None else f' (ball {ball})'}{where and f' in {where}'}")


def _to_blame(status: int, given: dict[str, Any]) -> str:
    """The argument that a status is about, where that is plain."""
    numbers = {name: value for name, value in given.items() if isinstance(value, (int, float))}
    for name, value in numbers.items():
        if status == _NOT_FINITE and not math.isfinite(value):
            return f"{name}: {value} is not finite"
        if status == _NEGATIVE and value < 0:
            return f"{name}: {value} is negative"
        if status == _ARGUMENT and name in ("edge_length", "width") and value <= 0:
            return f"{name}: {value} is not above 0"
    return ""


class Record(C.Structure):
    """A struct of the interface; its fields are attributes."""

    def __init__(self, *given: Any, **named: Any):
        super().__init__(*given, **named)
        for name, value in [*zip((field[0] for field in self._fields_), given), *named.items()]:
            held = getattr(self, name)
            for kept, meant in zip(held, value) if isinstance(held, C.Array) else [(held, value)]:
                if isinstance(kept, int) and kept != meant:  # ctypes takes its last bits
                    raise ValueError(f"{name}: {meant} does not fit")

    def __repr__(self) -> str:
        shown = ((name, getattr(self, name)) for name, *_ in self._fields_)
        return f"{type(self).__name__}({', '.join(f'{n}={list(v) if isinstance(v, C.Array) else v!r}' for n, v in shown)})"


class Result(SimpleNamespace):
    """Several results of one call, by name."""


class Argument(NamedTuple):
    name: str
    kind: str
    base: str
    extents: tuple[str, ...]
    null: str

    @classmethod
    def read(cls, text: str) -> "Argument":
        name, kind, base, extents, null = text.split(":")
        return cls(name, kind, base, tuple(extents.split(";")) if extents else (), null)


class Described(NamedTuple):
    function: Any
    result: str
    arguments: list[Argument]
    fields: dict[str, list[Argument]]


_functions: dict[str, str] = {}
_fields: dict[str, list[Argument]] = {}
_records: dict[str, type] = {}
_ready: dict[str, Described] = {}


def describe(functions: dict[str, str], fields: dict[str, str], records: dict[str, type]) -> None:
    """Takes what `_interface.py` says of functions, of structs that go in field by field, and of records."""
    _functions.update(functions)
    _fields.update({name: [Argument.read(a) for a in text.split()] for name, text in fields.items()})
    _records.update(records)


def _described(name: str) -> Described:
    if name not in _ready:
        result, *arguments = _functions[name].split()
        parsed = [Argument.read(a) for a in arguments]
        function = getattr(library, name)
        function.restype = {"int32_t": C.c_int32, "uint32_t": C.c_uint32}.get(result, C.c_char_p)
        function.argtypes = [_SCALARS[a.base] if a.kind in ("value", "capacity") else
                             C.c_char_p if a.kind == "string" else _SINK if a.kind == "callback" else C.c_void_p
                             for a in parsed]
        _ready[name] = Described(function, result, parsed, {a.name: _fields.get(a.base, []) for a in parsed})
    return _ready[name]


def _type(base: str) -> Any:
    return _SCALARS[base] if base in _SCALARS else C.c_char_p if base == "char" else _records[base]


def _check(status: int, where: str, ball: int = _NONE, given: dict[str, Any] | None = None,
           conflict: Any = None) -> None:
    if status != 0:
        raise Error(status, ball, where, given, conflict)


# ---- arrays ----------------------------------------------------------------------------------------------------------

class Misshapen(_Portable):
    """An array of another shape than an argument has."""

    def __init__(self, argument: str, problem: str):
        self.argument, self.problem = argument, problem
        super().__init__(f"{argument}: {problem}")


@contextmanager
def called(**names: str) -> Iterator[None]:
    """What is refused inside is named as the caller knows it."""
    try:
        yield
    except Misshapen as refused:
        raise Misshapen(names.get(refused.argument, refused.argument), refused.problem) from None
    except Error as refused:
        argument, colon, problem = str(refused).partition(": ")
        if colon and argument in names:
            refused.args = (f"{names[argument]}: {problem}",)
        raise


def shape_of(values: Any) -> tuple[int, ...]:
    """Of an array, or of rows in rows."""
    if hasattr(values, "shape"):
        return tuple(values.shape)
    if not hasattr(values, "__len__") or isinstance(values, str):
        return ()
    inside = {shape_of(row) for row in values}
    if len(inside) > 1:
        raise TypeError("rows of several lengths")
    return len(values), *(inside.pop() if inside else ())


def copied(values: Any) -> Any:
    """The same numbers in memory of their own, for calls to come, which refuse anything else. None stays None."""
    if values is None or isinstance(values, str):
        return values
    try:
        return list(values) if numpy is None else numpy.array(values, subok=True)
    except (TypeError, ValueError):
        return values


def _flat(values: Any) -> Iterable[Any]:
    rows = hasattr(values, "__len__") and not isinstance(values, str)
    return (x for row in values for x in _flat(row)) if rows else (values,)


def _held_to(extents: tuple[str, ...], shape: tuple[int, ...], flat_serves: bool, sizes: dict[str, int]) -> str:
    """What shape was expected, if it is another one; else `sizes` has the first extent. Nine numbers may be a matrix, and
    numbers in a list without rows are taken row after row; an empty array has no rows."""
    first, *rest = extents
    row = tuple(map(int, rest))
    known = int(first) if first.isdigit() else sizes.get(first)
    count = shape[0] if shape else -1
    fits = len(shape) == len(extents) and shape[1:] == row or shape == (0,)
    if known == 9 and shape == (3, 3):
        fits, count = True, 9
    if flat_serves and row and len(shape) == 1 and count % row[0] == 0:
        fits, count = True, count // row[0]
    if fits and (known is None or count == known):
        sizes.setdefault(first, count)
        return ""
    expected = first if known is None else known
    return f"({expected},)" if not row else f"({', '.join(map(str, (expected, *row)))})"


def _whole(value: Any, kind: Any) -> int:
    """A number as an integer of C, which would else be another one without a word: 2^32 the ball 0."""
    whole = int(value)
    if kind(whole).value != whole or not isinstance(value, str) and whole != value:
        raise ValueError(f"{value} is no whole number of {8 * C.sizeof(kind)} bits{' from 0 on' * (kind(-1).value > 0)}")
    return whole


def _single(value: Any, argument: Argument) -> Any:
    """A single number of an argument or a field, of which ctypes takes the last bits if it is too large."""
    if argument.base not in _SCALARS or argument.base == "double":
        return value
    try:
        return _whole(operator.index(value), _SCALARS[argument.base])
    except (TypeError, ValueError) as wrong:
        raise Misshapen(argument.name, str(wrong)) from None


def _text(value: str, name: str) -> bytes:
    """Text as C takes it, which ends with the first zero."""
    if not isinstance(value, str):
        raise Misshapen(name, f"{type(value).__name__}, expected str")
    if "\0" in value:
        raise Misshapen(name, "has a zero byte")
    return value.encode()


def _struct_in(value: Any, argument: Argument) -> Any:
    """A struct of the type that a function reads, or such a row of numpy's."""
    kind = _records[argument.base]
    if numpy is not None and isinstance(value, numpy.void) and value.dtype == numpy.dtype(kind):
        return kind.from_buffer_copy(value.tobytes())
    if not isinstance(value, kind):
        raise Misshapen(argument.name, f"{type(value).__name__}, expected {kind.__name__}")
    return value


def _whole_array(values: Any, kind: Any) -> Any:
    """The same of many."""
    given = numpy.atleast_1d(values)
    if given.dtype.kind in "biuf":
        with numpy.errstate(invalid="ignore"):
            data = numpy.ascontiguousarray(given.astype(kind))
        for value in given[data != given][:1]:
            _whole(value.item(), kind)
        return data
    return numpy.array([_whole(x, kind) for x in given.flat], dtype=kind).reshape(given.shape)


def array_in(values: Any, argument: Argument, sizes: dict[str, int]) -> Any:
    """Values as a C array; of what `sizes` does not know yet of its extents, the values say how many there are."""
    base, kind = argument.base, _type(argument.base)
    name = argument.name + "_" * iskeyword(argument.name)
    try:
        if base == "uint8_t" and isinstance(values, (bytes, bytearray)):  # as they are; other bytes are yes or no
            made, shape = (kind * len(values)).from_buffer_copy(values), (len(values),)
        elif base in _SCALARS and numpy is not None:
            if numpy.ma.is_masked(values) or numpy.iscomplexobj(values):  # which numpy drops without a word
                raise ValueError("masked values, or complex numbers")
            if base == "uint8_t":
                values = numpy.asarray(values).astype(bool)
            data = _whole_array(values, kind) if base in _WHOLE else numpy.ascontiguousarray(values, dtype=kind)
            made, shape = C.cast(data.ctypes.data, C.POINTER(kind)), data.shape
            made.kept = data  # type: ignore[attr-defined]
        else:
            given = values if hasattr(values, "__len__") else list(values)
            flat = list(_flat(given)) if base in _SCALARS else list(given)
            shape = shape_of(given) if base in _SCALARS else getattr(given, "shape", (len(flat),))
            if base == "char":
                flat = [None if text is None else _text(text, name) for text in flat]
            elif base == "double":
                flat = [float(x) for x in flat]
            elif base in _SCALARS:
                flat = [int(bool(x)) if base == "uint8_t" else _whole(x, kind) for x in flat]
            elif numpy is not None and isinstance(given, numpy.ndarray) and given.dtype != object:
                if given.dtype != numpy.dtype(kind):  # whose bytes have another meaning
                    raise ValueError(f"{given.dtype}, expected {numpy.dtype(kind)}")
                flat = [kind.from_buffer_copy(row.tobytes()) for row in given]
            made = (kind * len(flat))(*flat)
    except (OverflowError, TypeError, ValueError) as wrong:
        raise Misshapen(name, str(wrong)) from wrong
    expected = _held_to(argument.extents or ("1",), tuple(shape), not hasattr(values, "shape"), sizes)
    if expected:
        raise Misshapen(name, f"shape {tuple(shape)}, expected {expected}")
    return made


def array_out(argument: Argument, rows: int) -> Any:
    count = rows
    for extent in argument.extents[1:]:
        count *= int(extent)
    return (_type(argument.base) * count)()


def given_back(made: Any, argument: Argument) -> Any:
    """A C array as numpy's, or as a list; of several extents as rows."""
    row = [int(extent) for extent in argument.extents[1:]]
    if numpy is not None:
        if len(made) == 0:
            return numpy.zeros((0, *row), dtype=made._type_)
        result = numpy.ctypeslib.as_array(made)
        return result.reshape(-1, *row) if row else result
    values = list(made)
    for size in reversed(row):
        values = [tuple(values[k:k + size]) for k in range(0, len(values), size)]
    return values


# ---- handles ---------------------------------------------------------------------------------------------------------

class Handle:
    """A handle of the library in memory that grows until it suffices."""
    noun = ""

    def __init__(self, **limits: int):
        """limits: fields of the limits that are to be larger from the start, for those who know."""
        self.n = 0  # balls
        self._pointer: Any = C.c_void_p()
        self._memory: Any = None
        self._room = -1
        self._limits: Any = None
        self._wanted = limits
        self._kept: list[Any] = []  # memory of what the results come from
        self._last: tuple[str, dict[str, Any]] | None = None

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.n} balls)"

    def _of(self, what: str) -> str:
        return f"hsp_{self.noun}_{what}"

    def _make(self, *size: Any) -> None:
        memory_bytes, pointer = C.c_size_t(), C.c_void_p()
        _check(_described(self._of("bytes")).function(*size, C.byref(memory_bytes)), self._of("bytes"))
        memory = C.create_string_buffer(memory_bytes.value)
        status = _described(self._of("init")).function(C.cast(memory, C.c_void_p), memory_bytes, *size, C.byref(pointer))
        _check(status, self._of("init"))
        self._memory, self._pointer = memory, pointer

    def _grow(self, limits: Any) -> None:
        self._make(C.byref(limits))
        self._limits = limits  # of the memory there is, also where there is none for more

    def _ready(self, name: str, values: dict[str, Any], sizes: dict[str, int]) -> int:
        """Makes the handle before it computes for the first time, and one without limits when more balls come. How many
        come, which it has no sooner than the function has been called: arrays are made for what is in the handle."""
        balls = sizes.get("n", next((v.n for v in values.values() if isinstance(v, Handle)), self.n))
        if self._of("limits_init") not in _functions:
            if balls > self._room:
                if self._memory is not None:  # what was made of the balls there is not made of those to come
                    _described(self._of("init")).function(C.cast(self._memory, C.c_void_p), C.sizeof(self._memory),
                                                          self._room, C.byref(C.c_void_p()))
                self._make(max(balls, 1))
                self._room = max(balls, 1)
        elif self._limits is None:
            init = name.removesuffix("_with").replace("compute", "limits_init")
            described = _described(init if "limits_init" in init and init in _functions else self._of("limits_init"))
            limits = _records[described.arguments[0].base]()
            for known in (balls, 0):  # of more balls than it knows limits for: those of none, which grow
                more = []
                for a in described.arguments[2:]:
                    handles = [v for v in values.values() if isinstance(v, Handle) and f"hsp_{v.noun}" == a.base]
                    more.append(handles[0]._pointer if handles else known if a.name == "balls" else values[a.name])
                status = described.function(C.byref(limits), C.sizeof(limits), *more)
                if status != _RANGE or "balls" not in (a.name for a in described.arguments):
                    break
            _check(status, self._of("limits_init"), given=values)
            for field, least in self._wanted.items():
                setattr(limits, field, max(getattr(limits, field), _whole(least, C.c_uint32)))
            self._grow(limits)
        return balls


    def _grow_with_balls(self, limits: Any) -> None:
        """Balls that moved go into more memory. If that fails all is as before."""
        assert self._last is not None  # there are balls, or none could need more room
        name, values = self._last
        model = type(values["model"])()  # not the caller's, which has balls of its own
        model._make(self.n)
        model._room = self.n
        call(self._of("get_model"), self, model=model)
        before = dict(self.__dict__)
        try:
            self._grow(limits)
            call(name, self, **{**values, "model": model})
        except BaseException:
            self.__dict__.update(before)
            raise


# ---- a call ----------------------------------------------------------------------------------------------------------

def _handle_in(value: Any, argument: Argument) -> Handle:
    if not isinstance(value, Handle):
        raise Misshapen(argument.name, f"{type(value).__name__}, expected a handle")
    return value


def _options(argument: Argument, fields: list[Argument], values: dict[str, Any], sizes: dict[str, int],
             raised: list[BaseException]) -> Any:
    """A struct of options with its defaults and what is given."""
    made = _records[argument.base]()
    init = f"{argument.base}_init"
    if init in _functions:
        _check(_described(init).function(C.byref(made), C.sizeof(made)), init)
    else:
        made.struct_size = C.sizeof(made)
    kept = []
    for field in fields:
        value = values.get(field.name)
        if field.base == "hsp_executor" and (values.get("threads") or 1) > 1:
            value = _executor(values["threads"], raised)
        elif field.kind == "sized_in" and field.base in _fields:
            value = _options(field, _fields[field.base], values, sizes, raised)
        if value is None:
            continue
        if field.kind == "sized_in":
            kept.append(value)
            value = C.addressof(value)
        elif field.kind == "handle":
            value = _handle_in(value, field)._pointer.value
        elif field.kind == "array_in":
            kept.append(array_in(value, field, sizes))
            value = C.cast(kept[-1], C.c_void_p).value
        elif field.extents:
            value = (_SCALARS[field.base] * int(field.extents[0]))(
                *array_in(value, field, sizes)[:int(field.extents[0])])
        setattr(made, field.name, _single(value, field) if field.kind == "value" and not field.extents else value)
    made.kept = kept
    return made


def _call_apart(function: Callable[[], int], raised: list[BaseException]) -> int:
    """Calls a function that calls back. Handlers of signals run in the main thread, and ctypes drops exceptions of a
    callback: another thread makes the call of the main thread, which waits for its end and puts into `raised` what is
    raised meanwhile. If no thread can be started the call is made here."""
    if threading.current_thread() is not threading.main_thread():
        return function()
    claims: list[object] = []
    found: list[int] = []
    ended = allocate_lock()
    ended.acquire()

    def work() -> None:
        """The first to come makes the call, or none if there is no more use in it."""
        mine = object()
        try:
            claims.append(mine)
            if claims[0] is mine and not raised:
                found.append(function())
        except BaseException as wrong:
            raised.append(wrong)
        finally:
            if claims and claims[0] is mine:
                found.append(_EXECUTOR)
                ended.release()

    while not found:
        try:
            if raised:  # perhaps before a thread was started
                work()
            else:
                try:
                    start_new_thread(work, ())
                except (RuntimeError, MemoryError):
                    work()
            ended.acquire()
        except BaseException as wrong:
            raised.append(wrong)
    return found[0]


def _executor(threads: int, raised: list[BaseException]) -> Any:
    """A loop whose tasks so many threads share; none of them holds Python's lock while it works. Exceptions go into
    `raised`, and no task begins when there is one."""
    def run(_: Any, tasks: int, task: Any, data: Any) -> int:
        """Returns when no task is running and none can begin, 1 if one is left."""
        left, done = list(range(tasks))[::-1], []
        running, started, ended = 0, 0, 0  # tasks in helpers; helpers
        closed = begun = False
        lock, woken = allocate_lock(), allocate_lock()
        woken.acquire()

        def help_out() -> None:
            nonlocal running, ended
            try:
                while True:
                    with lock:
                        if closed or raised or not left:
                            return
                        k = left.pop()
                        running += 1
                    try:
                        task(data, k)
                        done.append(k)
                    finally:
                        with lock:
                            running -= 1
            finally:
                with lock:
                    ended += 1
                    if woken.locked():
                        woken.release()

        while True:
            try:
                if not begun:
                    begun = True
                    with suppress(RuntimeError, MemoryError):  # the threads that there are do all tasks
                        for _ in range(min(threads, tasks) - 1):
                            start_new_thread(help_out, ())
                            started += 1
                while left and not raised:
                    with lock:
                        mine = left[-1:]
                        del left[-1:]
                    for k in mine:
                        task(data, k)
                        done.append(k)
                with lock:
                    closed = True
                    if running == 0 and ended >= started:  # one that begins late could outlive Python
                        break
                woken.acquire()
            except BaseException as wrong:
                raised.append(wrong)
        return 0 if len(done) == tasks else 1

    made = _records["hsp_executor"]()
    made.struct_size, made.workers, made.kept = C.sizeof(made), _whole(threads, C.c_uint32), _LOOP(run)
    made.run = C.cast(made.kept, C.c_void_p).value
    return made


def _length(argument: Argument, sizes: dict[str, int]) -> int | None:
    """How many rows an output array has; None if only the function knows."""
    first = argument.extents[0]
    if first.isdigit():
        return int(first)
    name, _, more = first.partition("+")
    return sizes[name] + int(more or 0) if name in sizes else None


def call(name: str, handle: Handle | None, only: Iterable[str] | None = None, **values: Any) -> Any:
    """Calls a function: `values` are what its arguments, and the fields of its options, become. only: the names of the
    outputs that are wanted, where not all are."""
    described = _described(name)
    arguments = described.arguments
    values = {key.rstrip("_"): value for key, value in values.items()}  # from_ is Python's way to name it
    only = None if only is None else {only} if isinstance(only, str) else set(only)
    for a in arguments:
        value = values.get(a.name)
        if value is None:
            continue
        if a.kind == "value":
            values[a.name] = _single(value, a)
        elif a.kind == "string":
            values[a.name] = _text(value, a.name)
        elif a.kind == "struct_in":
            values[a.name] = _struct_in(value, a)
        elif a.kind == "handle":
            _handle_in(value, a)
    sizes = {} if handle is None or any(a.name == "n" for a in arguments) else {"n": handle.n}
    computes = any(a.kind == "sized" and a.base.endswith("_limits") for a in arguments)
    makes = handle is not None and (name.removeprefix(handle._of("")).split("_")[0] in ("compute", "set"))
    if makes:  # its balls come with the arguments
        sizes.pop("n", None)
        sizes.update({"n": v.n for v in values.values() if isinstance(v, Handle)})
    arrays = {a.name: None if values.get(a.name) is None else array_in(values[a.name], a, sizes)
              for a in arguments if a.kind == "array_in"}
    for a in arguments:  # a number that is asked for is a length, too
        if a.kind == "value" and isinstance(values.get(a.name), int):
            sizes.setdefault(a.name, values[a.name])
    balls = handle._ready(name, values, sizes) if makes else 0
    for a in arguments:
        if a.kind == "value" and a.name in sizes and a.name not in values:
            values[a.name] = sizes[a.name]
        elif a.kind == "value" and a.name not in values:  # a number of rows, and there are none that say it
            raise Misshapen(next(b.name for b in arguments if a.name in b.extents), "None, expected an array")

    outputs = [f for a in arguments for f in (described.fields[a.name] if a.kind == "outputs" else [a])
               if f.kind in ("value_out", "struct_out", "array_out")]
    if only is not None and not only <= {f.name for f in outputs}:
        raise ValueError(f"only: one of {', '.join(f.name for f in outputs)}")
    wanted = [f for f in outputs if only is None or f.name in only or f.name == "first_bad" or f.null != "always"]
    made = {f.name: array_out(f, _length(f, sizes)) if f.kind == "array_out" else _type(f.base)()
            for f in wanted if f.kind != "array_out" or _length(f, sizes) is not None}
    if "first_bad" in made:
        made["first_bad"].value = _NONE
    open_ones = [f for f in wanted if f.name not in made]
    calls_back = any(a.kind == "callback" for a in arguments)
    taken = bytearray()

    def sink(_: Any, text: Any, count: int) -> int:
        try:
            if raised:
                return 1
            taken.extend(text[:count])
            return 0
        except BaseException as wrong:
            raised.append(wrong)
            return 1

    def attempt(capacity: int) -> tuple[int, int]:
        """The status, and what is needed."""
        needed, passed, kept, ends = C.c_uint32(), [], [], None
        for place, a in enumerate(arguments):
            if a.kind == "handle":
                owner = handle if place == 0 and handle is not None else values.get(a.name)
                passed.append(None if owner is None else owner._pointer)
            elif a.kind == "value":
                passed.append(values[a.name])
            elif a.kind == "array_in":
                passed.append(arrays[a.name])
            elif a.kind in ("value_out", "struct_out", "array_out"):
                passed.append(C.byref(made[a.name]) if a.name in made else None)
            elif a.kind == "capacity":
                passed.append(capacity)
            elif a.kind == "needed":
                passed.append(C.byref(needed))
            elif a.kind == "string":
                passed.append(values.get(a.name))
            elif a.kind == "struct_in":
                passed.append(C.byref(values[a.name]))
            elif a.kind == "callback":
                kept.append(_SINK(sink))
                passed.append(kept[-1])
            elif a.kind == "memory":
                passed.append(C.cast(scratch, C.c_void_p))
            elif a.kind == "outputs":
                ends = _records[a.base]()
                ends.struct_size, ends.capacity = C.sizeof(ends), capacity
                for f in described.fields[a.name]:
                    if f.name in made and f.name != "first_bad":
                        setattr(ends, f.name, C.addressof(made[f.name]))
                passed.append(C.byref(ends))
            elif a.kind == "sized" and a.base.endswith("_limits"):
                if handle._limits is None:  # of a handle that was never made
                    passed.append(None)
                    continue
                limits.append(type(handle._limits)(*(getattr(handle._limits, f) for f, *_ in handle._limits._fields_)))
                passed.append(C.byref(limits[-1]))
            elif a.kind == "sized":
                passed.append(C.byref(values[a.name]))
            elif a.kind == "sized_in" and described.fields[a.name]:
                kept.append(_options(a, described.fields[a.name], values, sizes, raised))
                passed.append(C.byref(kept[-1]))
            else:
                passed.append(None)
        def make() -> int:
            result = described.function(*passed)
            if makes:
                handle.n = balls
            if makes and result == 0:
                handle._kept = [(v._memory, v._kept) for v in values.values() if isinstance(v, Handle)]
                if computes:  # what is given here may be other numbers when the balls have to be set again
                    handle._last = (name, {key: copy.copy(value) if hasattr(value, "__len__") else value
                                           for key, value in values.items()})
            return result

        status = _call_apart(make, raised) if calls_back or (values.get("threads") or 1) > 1 else make()
        if raised:
            raise raised[0]
        if calls_back and status == 0 and len(taken) != made["bytes"].value:
            status = _REFUSED  # ctypes drops an exception that comes before the first line of the sink
        if ends is not None and hasattr(ends, "first_bad") and "first_bad" in made:
            made["first_bad"].value = ends.first_bad
        return status, ends.needed if ends is not None and hasattr(ends, "needed") else needed.value

    raised: list[BaseException] = []  # in callbacks, or while another thread made the call
    limits: list[Any] = []
    scratch = C.create_string_buffer(0)
    # Arrays of one element for each of the handle's balls are held to that number; sizes that only the function knows
    # are asked for first.
    capacity = 0 if open_ones else sizes.get("n", 0)
    status, needed = attempt(capacity)
    while status == _CAPACITY and computes and handle is not None:
        if name.startswith(handle._of("move")):
            handle._grow_with_balls(limits[-1])
        else:
            handle._grow(limits[-1])
            if not makes and handle._last is not None:
                call(handle._last[0], handle, **handle._last[1])
        status, needed = attempt(capacity)
    while status == _CAPACITY and "bytes" in made and C.sizeof(scratch) < made["bytes"].value:  # memory for one call
        scratch = C.create_string_buffer(made["bytes"].value)
        status, needed = attempt(capacity)
    if open_ones and status in (0, _CAPACITY):
        made.update({f.name: array_out(f, needed) for f in open_ones})
        if needed:
            status, needed = attempt(needed)
        elif status == _CAPACITY:
            status = 0
    if described.result != "int32_t":
        return status.decode() if isinstance(status, bytes) else status
    bad = made.pop("first_bad", None)
    part = made["brick"].value if "brick" in made else _NONE
    conflict = made["conflict"] if status == _CONFLICT and "conflict" in made else None if part == _NONE else part
    _check(status, name, _NONE if bad is None else bad.value, values, conflict)
    if handle is not None and name.endswith("get_model"):
        values["model"].n = handle.n
    if calls_back:
        return bytes(taken)
    found = {f.name: given_back(made[f.name], f) if f.kind == "array_out" else
             made[f.name] if f.kind == "struct_out" else made[f.name].value
             for f in wanted if f.name in made and f.name not in ("scratch", "bytes")}
    for a in arguments:  # memory with a name is a result, as summaries of bricks are
        if a.kind == "memory" and a.name != "memory":
            found = {a.name: scratch.raw[:made["bytes"].value], **found}
    return handle if not found else next(iter(found.values())) if len(found) == 1 else Result(**found)

