# Two balls of radius 1 at distance 1, by the declarations for Julia: each loses a cap of height 1/2.
#   lens.jl DECLARATIONS STRUCTS.TXT
include(ARGS[1])
using .HardsphereC
using Printf

for row in eachline(ARGS[2])
    words = split(row)
    startswith(row, "#") && continue
    number = parse(Int, split(words[2], "/")[1])
    names = split(words[1], ".")
    kind = getfield(HardsphereC, Symbol(names[1]))
    if length(names) == 1
        @assert sizeof(kind) == number row
    else
        place = findfirst(==(Symbol(names[2])), fieldnames(kind))
        @assert fieldoffset(kind, place) == number row
    end
end

xyz, radius, area = [0.0, 0, 0, 1, 0, 0], [1.0, 1], zeros(2)
bytes, totals = Ref{Csize_t}(0), Ref(HardsphereC.hsp_totals(0, 0, (0, 0)))
@assert HardsphereC.hsp_areas_bytes(2, bytes) == HardsphereC.HSP_OK
memory = zeros(UInt8, bytes[])
@assert HardsphereC.hsp_areas(2, xyz, radius, 0.0, memory, bytes, totals, area) == HardsphereC.HSP_OK
@printf("%.6f %.6f\n", totals[].area, area[2])
