"""Types of what goes in and what comes back, for those who check types. Arrays are numpy's where numpy is there, and lists
where it is not."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Sequence, Union

if TYPE_CHECKING:
    import numpy
    from numpy.typing import NDArray

    Doubles = NDArray[numpy.float64]
    Numbers = NDArray[numpy.uint32]
    Records = NDArray[numpy.void]
    Rows = Union[NDArray[Any], Sequence[Sequence[float]]]  # (n, 3)
    Values = Union[NDArray[Any], Sequence[float]]  # (n,)
    Integers = Union[NDArray[Any], Sequence[int]]
    Truths = Union[NDArray[Any], Sequence[bool], Sequence[int]]
else:
    Doubles = Numbers = Records = Rows = Values = Integers = Truths = Any
