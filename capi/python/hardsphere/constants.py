"""The constants of the headers, and nothing else: hardsphere.constants.PIECES_OUTSIDE_ALL. The module hardsphere has them
beside all else."""
from . import _interface

__all__ = [name for name, value in vars(_interface).items() if name.isupper() and isinstance(value, (int, str))]
globals().update({name: getattr(_interface, name) for name in __all__})
