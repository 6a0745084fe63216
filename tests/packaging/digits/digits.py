"""What digits.c prints, by cffi: digits.py FILE INCLUDE-FOLDER LIBRARY-FOLDER. Compiles its module where it runs."""
import struct
import sys

import cffi

path, include, library = sys.argv[1:]
ffi = cffi.FFI()
ffi.cdef("""
    typedef struct { ...; } hsp_workspace;
    typedef struct { double area, volume; } hsp_totals;
    typedef struct hsp_boundary hsp_boundary;
    hsp_boundary *boundary_of(hsp_workspace *work);
    int32_t hsp_workspace_set(hsp_workspace *work, uint32_t n, const double *xyz, const double *radius, void *options,
                              uint32_t *first_bad);
    int32_t hsp_workspace_boundary(hsp_workspace *work);
    void hsp_workspace_free(hsp_workspace *work);
    int32_t hsp_boundary_measure(const hsp_boundary *boundary, const uint8_t *selected, hsp_totals *totals, double *area,
                                 double *volume, uint32_t capacity, uint32_t *needed);
    int32_t hsp_boundary_gradient(const hsp_boundary *boundary, const double *sigma, double tension, double pressure,
                                  uint32_t tangency, void *energy, double *d_centre, double *d_radius, void *flags,
                                  uint32_t capacity, uint32_t *needed, uint32_t *first_bad);
    #define HSP_TANGENT_OVERLAP ...
""")
ffi.set_source("_digits", """
    #include <hardsphere.h>
    #include <hardsphere_workspace.h>
    static hsp_boundary *boundary_of(hsp_workspace *work) { return work->boundary; }
""", libraries=["hardsphere", "m"], include_dirs=[include], library_dirs=[library])
ffi.compile()
sys.path.insert(0, ".")
from _digits import ffi, lib

rows = [[float(word) for word in line.split()] for line in open(path)]
n = len(rows)
xyz = ffi.new("double[]", [number for row in rows for number in row[:3]])
radius = ffi.new("double[]", [row[3] for row in rows])
work, totals = ffi.new("hsp_workspace *"), ffi.new("hsp_totals *")
area, volume, gradient = ffi.new("double[]", n), ffi.new("double[]", n), ffi.new("double[]", 3 * n)
null = ffi.NULL
assert lib.hsp_workspace_set(work, n, xyz, radius, null, null) == 0
assert lib.hsp_workspace_boundary(work) == 0
boundary = lib.boundary_of(work)
assert lib.hsp_boundary_measure(boundary, null, totals, area, volume, n, null) == 0
assert lib.hsp_boundary_gradient(boundary, null, 1.0, 1.0, lib.HSP_TANGENT_OVERLAP, null, gradient, null, null, n, null,
                                 null) == 0
for number in [totals.area, totals.volume, *area, *volume, *gradient]:
    print("%016X" % struct.unpack("=Q", struct.pack("=d", number)))
lib.hsp_workspace_free(work)
