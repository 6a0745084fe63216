# Reads the list of entry points, then the call graphs of all object files; prints the deepest path of each entry.

FNR == 1 { ++file }
file == 1 { entry[++entries] = $1; next }

# The text between the quotes that follow `key: `.
function quoted(key,    from, rest) {
  from = index($0, key ": \"")
  if (from == 0) return ""
  rest = substr($0, from + length(key) + 3)
  return substr(rest, 1, index(rest, "\"") - 1)
}

# The types say what calls through pointers reach: those of class PaintedPaths (lib/sight/picture/painted_paths.hpp) its
# functions, those of an ArcVisitor the lambdas that take arcs. Contours (lib/sight/picture/ink.hpp) ask for silhouettes and
# for paths, their source hands arcs to the lambda that takes them, and that curves to those of the writers: it and
# BodyInk, its state, may call both.
function reached_by(from) {
  if (from ~ /^_ZNK3hsp3Ink14visit_contours/) return "a function of silhouettes"
  if (from ~ /17SilhouetteVisitorE$/) return "a taker of silhouettes"
  if (from ~ /17BodyInk|3Ink14visit_contours.*13SilhouetteArc.*_FUN/) return "a call by contours"
  if (from ~ /10ArcVisitor/) return "a visitor"
  if (from ~ /8Executor7run_all/) return "a loop over tasks"
  if (from ~ /10run_marked/) return "a task"
  if (from ~ /12PaintedPaths|12PictureInput|[SEP][vpd][gsf]Writer|3hsp5Paint|^hsp_sticks_get_info$/) return "a function of paths"
  return "__indirect_call"
}

function add_callee(from, to) {
  callee[from, ++callees[from]] = to
}

BEGIN {
  add_callee("a call by contours", "a taker of contours")
  add_callee("a call by contours", "a function of paths")
}

/^node:/ {
  title = quoted("title")
  if (title ~ /10run_marked/) add_callee("a loop over tasks", title)
  if (title ~ /8Executor8for_each.*_FUN/) add_callee("a task", title)
  if (title ~ /12PaintedPaths5visitI.*_FUN/) add_callee("a visitor", title)
  if (title ~ /17SilhouetteVisitorE$/) add_callee("a function of silhouettes", title)
  if (title ~ /13SilhouetteArc.*_FUN/) add_callee("a taker of silhouettes", title)
  if (title ~ /8InkCurve.*_FUN/) add_callee("a taker of contours", title)
  if (title ~ /EPKvj$|EPKvRKNS_7BallSetEjRKNS_10ArcVisitorE$/) {
    add_callee("a function of paths", title)
    add_callee("a function of silhouettes", title)
  }
  label = quoted("label")
  if (match(label, /[0-9]+ bytes \([a-z,]+\)/)) {
    text = substr(label, RSTART, RLENGTH)
    split(text, part, " ")
    # an inline function may be compiled several times
    if (!(title in frame) || part[1] + 0 > frame[title]) frame[title] = part[1] + 0
    # "dynamic,bounded" is a frame that is aligned at run time; its number is a reliable maximum
    if (text ~ /\(dynamic\)/) dynamic[title] = text
  }
}

/^edge:/ {
  from = quoted("sourcename")
  to = quoted("targetname")
  # of the caller's functions, a sink and whether to go on, nothing is counted
  if (to == "__indirect_call" && from ~ /8ByteSink|8Executor3ask/) next
  if (to == "__indirect_call") to = reached_by(from)
  if (!((from, to) in seen)) {
    seen[from, to] = 1
    add_callee(from, to)
  }
}

# The most stack below and including f. Call graphs without recursion are as deep as awk can go.
function deepest(f,    i, below, most, to) {
  if (f in depth) return depth[f]
  if (f in active) {
    if (!(f in recursive)) print "recursion through " f
    recursive[f] = 1
    failed = 1
    return 0
  }
  if (f == "__indirect_call") {
    failed = 1
    return 0
  }
  active[f] = 1
  most = 0
  for (i = 1; i <= callees[f]; ++i) {
    to = callee[f, i]
    if (to == "__indirect_call") print "a call through a pointer by " f
    below = deepest(to)
    if (below > most) {
      most = below
      next_on_path[f] = to
    }
  }
  delete active[f]
  if (f in dynamic) {
    print "a frame whose size is not fixed: " f ", " dynamic[f]
    failed = 1
  }
  depth[f] = frame[f] + most
  return depth[f]
}

END {
  for (e = 1; e <= entries; ++e) {
    f = entry[e]
    if (!(f in frame)) {
      print "no frame known for " f
      failed = 1
      continue
    }
    bytes = deepest(f)
    ++counted
    printf "%7d  %s\n", bytes, f
    if (bytes > worst) {
      worst = bytes
      worst_entry = f
    }
    if (bytes > limit) {
      printf "         more than %d:\n", limit
      for (g = f; g != ""; g = next_on_path[g]) printf "         %6d %s\n", frame[g], g
      failed = 1
    }
  }
  if (counted == 0) failed = 1
  printf "deepest: %d bytes in %s, limit %d\n", worst, worst_entry, limit
  exit failed ? 1 : 0
}
