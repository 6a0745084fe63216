"""Records as columns."""
from __future__ import annotations

import ctypes
from typing import Any

from ._calls import Record, numpy


def _column(columns: dict[str, Any], name: str, values: Any) -> None:
    """One column, or one for each part of values that have several: ball_0 and ball_1."""
    if numpy is not None and isinstance(values, numpy.ndarray):
        if values.ndim == 1:
            columns[name] = values
            return
        for part in range(values.shape[1]):
            columns[f"{name}_{part}"] = values[:, part]
        return
    parts = {len(value) if isinstance(value, (ctypes.Array, tuple)) else 0 for value in values}
    if parts == {0} or len(parts) != 1:
        columns[name] = values
        return
    for part in range(parts.pop()):
        columns[f"{name}_{part}"] = [value[part] for value in values]


def table(records: Any) -> dict[str, Any]:
    """A dict of columns of records or of named tuples, as pandas.DataFrame takes it: of contacts area, rim, distance,
    ball_0 and ball_1; of cavities volume, area and balls. Fields that are reserved are left out."""
    columns: dict[str, Any] = {}
    if numpy is not None and isinstance(records, numpy.ndarray):
        if records.dtype.names is None:
            raise TypeError("an array without fields is no table")
        for name in records.dtype.names:
            if name != "reserved":
                _column(columns, name, records[name])
        return columns
    rows = list(records)
    names = [name for name, *_ in rows[0]._fields_] if rows and isinstance(rows[0], Record) else \
        rows[0]._fields if rows else ()
    for name in names:
        if name != "reserved":
            _column(columns, name, [getattr(row, name) for row in rows])
    return columns
