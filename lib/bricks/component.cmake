# One set of balls in bricks that no memory holds together: a summary of each, and how summaries merge.
hsp_part(bricks
  STANDS_ON union
  HEADERS bricks
  SOURCES
    bricks/brick_seams.cpp
    bricks/brick_summary.cpp
    bricks/exact_sums.cpp
    bricks/summary_block.cpp
    bricks/summary_draft.cpp
    bricks/summary_merge.cpp
    bricks/whole_set.cpp
  SHIMS hsp_bricks
  LEVELS shims -O2)
