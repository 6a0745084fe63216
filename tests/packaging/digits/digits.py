"""What digits.c prints, by cffi and the declarations in CDEF: digits.py FILE INCLUDE-FOLDER LIBRARY-FOLDER CDEF. Compiles
its module where it runs, if it is not there."""
import importlib.util
import struct
import sys

import cffi

path, include, library, cdef = sys.argv[1:]
ffi = cffi.FFI()
ffi.cdef(open(cdef).read())
ffi.cdef("""
    typedef struct { ...; } hsp_workspace;
    hsp_boundary *boundary_of(hsp_workspace *work);
    int32_t hsp_workspace_set(hsp_workspace *work, uint32_t n, const double *xyz, const double *radius,
                              const hsp_model_options *options, uint32_t *first_bad);
    int32_t hsp_workspace_boundary(hsp_workspace *work);
    void hsp_workspace_free(hsp_workspace *work);
""")
ffi.set_source("_digits", """
    #include <hardsphere.h>
    #include <hardsphere_workspace.h>
    static hsp_boundary *boundary_of(hsp_workspace *work) { return work->boundary; }
""", libraries=["hardsphere", "m"], include_dirs=[include], library_dirs=[library])
sys.path.insert(0, ".")
if importlib.util.find_spec("_digits") is None:
    ffi.compile()
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
request, outputs = ffi.new("hsp_gradient_request *"), ffi.new("hsp_gradient_outputs *")
request.struct_size, request.tension, request.pressure = ffi.sizeof(request[0]), 1.0, 1.0
outputs.struct_size, outputs.capacity, outputs.d_centre = ffi.sizeof(outputs[0]), n, gradient
assert lib.hsp_boundary_get_gradient(boundary, request, outputs) == 0
for number in [totals.area, totals.volume, *area, *volume, *gradient]:
    print("%016X" % struct.unpack("=Q", struct.pack("=d", number)))
lib.hsp_workspace_free(work)
