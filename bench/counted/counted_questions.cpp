// counted_questions: the largest number of instructions between two questions whether to go on (hsp_executor.proceed),
// for each function on a large set. Under valgrind --tool=callgrind it prints instructions. Without valgrind it prints
// nanoseconds of processor time, which show the functions that are worth counting.
//   valgrind --tool=callgrind --callgrind-out-file=DUMP counted_questions DUMP COPIES [FUNCTION ..]
//   counted_questions - COPIES [FUNCTION ..]
// The set is COPIES x COPIES x COPIES times crambin. Each line: function, balls, questions, the most instructions
// between two questions, and all instructions. If there are more than the interface promises the file DUMP.<number>
// is kept for callgrind_annotate.
#include <hardsphere.h>
#include <hardsphere_workspace.h>
#include <unistd.h>
#include <valgrind/callgrind.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "sizes.hpp"
#include "tiling.hpp"

namespace {

constexpr uint64_t promised = 10000000;

// Measures the work since it was last read: instructions, or nanoseconds.
class Meter {
 public:
  explicit Meter(std::string dump) : dump_(std::move(dump)) {}

  uint64_t spent() {
    if (dump_ == "-") {
      timespec now{};
      clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
      const uint64_t time = static_cast<uint64_t>(now.tv_sec) * 1000000000U + static_cast<uint64_t>(now.tv_nsec);
      const uint64_t since = time - last_;
      last_ = time;
      return since;
    }
    CALLGRIND_DUMP_STATS;
    const std::string name = dump_ + "." + std::to_string(++dumps_);
    uint64_t instructions = 0;
    if (FILE *const file = std::fopen(name.c_str(), "r")) {
      char line[4096];
      while (std::fgets(line, sizeof line, file) != nullptr) {
        if (std::strncmp(line, "totals:", 7) == 0) instructions = std::strtoull(line + 7, nullptr, 10);
      }
      std::fclose(file);
      if (instructions < promised) unlink(name.c_str());
    }
    CALLGRIND_ZERO_STATS;
    return instructions;
  }

 private:
  std::string dump_;
  uint64_t last_ = 0, dumps_ = 0;
};

struct Asked {
  Meter &meter;
  uint64_t questions = 0, most = 0, all = 0;

  void note() {
    const uint64_t spent = meter.spent();
    all += spent;
    most = spent > most ? spent : most;
  }
  static int32_t proceed(void *context) {
    Asked &own = *static_cast<Asked *>(context);
    ++own.questions;
    own.note();
    return 0;
  }
};

struct Scene {
  hsp_workspace work{}, bare{};
  std::vector<double> area, d_centre;
  double box[9]{};
  std::vector<unsigned char> memory;
  hsp_body *body = nullptr;
  const hsp_executor *executor = nullptr;
};

}  // namespace

int main(int count, char **arguments) {
  if (count < 3) return 2;
  const bench::Balls one = bench::with_radii(bench::paper_molecules()[2], bench::Radii::paper);
  const bench::Balls balls = bench::tiled(one, std::atoi(arguments[2]));
  const uint32_t n = balls.size();
  Meter meter(arguments[1]);
  Scene s;
  s.area.resize(n);
  s.d_centre.resize(3 * size_t{n});
  hsp_workspace &work = s.work;
  hsp_model_options options;
  hsp_model_options_init(&options, sizeof options);
  options.probe = 1.4;
  const auto period = bench::tiling_period(one);
  for (size_t k = 0; k < 3; ++k) s.box[4 * k] = period[k] * std::atoi(arguments[2]);
  const auto set = [&](double probe) {
    options.probe = probe;
    return hsp_workspace_set(&work, n, balls.xyz.data(), balls.radius.data(), &options, nullptr);
  };
  hsp_view_options view{};
  hsp_view_options_init(&view, sizeof view);
  hsp_pores_options pores{sizeof pores, 0, 0.0, nullptr, nullptr};
  // `ask` makes the call that is measured, after the results that it needs have been made.
  struct Row {
    const char *name;
    std::function<int32_t()> before, ask;
  };
  const auto boundary = [&] { return set(0.0) == HSP_OK ? hsp_workspace_boundary(&work) : -1; };
  const auto grown = [&] { return set(1.4) == HSP_OK ? hsp_workspace_boundary(&work) : -1; };
  const auto balls_alone = [&] { return set(0.0); };
  std::vector<uint32_t> first(n + 1), ids(64 * size_t{n});
  const std::vector<Row> rows = {
      {"model", balls_alone, [&] { return set(0.0); }},
      {"pairs", balls_alone,
       [&] {
         const hsp_pairs_request request{sizeof request, 0, s.executor};
         return hsp_query_pairs_with(work.model, &request, first.data(), ids.data(), 64 * n, nullptr);
       }},
      {"pairs_once", balls_alone,
       [&] {
         const hsp_pairs_request request{sizeof request, HSP_PAIRS_ONCE, s.executor};
         return hsp_query_pairs_with(work.model, &request, first.data(), ids.data(), 64 * n, nullptr);
       }},
      {"body",
       [&] {
         size_t bytes = 0;
         hsp_body_bytes(n, &bytes);
         s.memory.resize(bytes);
         const int32_t status = hsp_body_init(s.memory.data(), bytes, n, &s.body);
         return status == HSP_OK ? set(0.0) : status;
       },
       [&] {
         const hsp_body_request request{sizeof request, 0, s.executor};
         return hsp_body_set_with(s.body, work.model, &request);
       }},
      {"curvature", boundary,
       [&] {
         const hsp_curvature_request request{sizeof request, 0, s.executor};
         return hsp_boundary_curvature_with(work.boundary, &request, nullptr, s.area.data(), nullptr, n, nullptr);
       }},
      {"surface_measures", [&] { return grown() == HSP_OK ? hsp_workspace_surface(&work) : -1; },
       [&] {
         const hsp_surface_measure_request request{sizeof request, 0, s.executor};
         hsp_surface_totals totals;
         return hsp_surface_measure_with(work.surface, &request, &totals, nullptr, 0, nullptr);
       }},
      {"boundary", boundary, [&] { return hsp_workspace_boundary(&work); }},
      {"boundary_grown", grown, [&] { return hsp_workspace_boundary(&work); }},
      {"measures", boundary,
       [&] {
         const hsp_measure_request request{sizeof request, 0, nullptr, s.executor};
         hsp_measure_outputs outputs{};
         outputs.struct_size = sizeof outputs;
         outputs.capacity = n;
         outputs.area = s.area.data();
         return hsp_boundary_get_measures(work.boundary, &request, &outputs);
       }},
      {"gradient", boundary,
       [&] {
         const hsp_gradient_request request{sizeof request, 0, 1.0, 0.0, nullptr, s.executor};
         hsp_gradient_outputs outputs{};
         outputs.struct_size = sizeof outputs;
         outputs.capacity = n;
         outputs.d_centre = s.d_centre.data();
         return hsp_boundary_get_gradient(work.boundary, &request, &outputs);
       }},
      {"contacts", boundary, [&] { return hsp_workspace_contacts(&work); }},
      {"topology", boundary, [&] { return hsp_workspace_topology(&work); }},
      {"mesh", boundary, [&] { return hsp_workspace_mesh(&work, 0, 1.0); }},
      {"surface", grown, [&] { return hsp_workspace_surface(&work); }},
      {"smooth_mesh", [&] { return grown() == HSP_OK ? hsp_workspace_surface(&work) : -1; },
       [&] { return hsp_workspace_mesh(&work, 1, 1.0); }},
      {"view", boundary,
       [&] {
         view.executor = s.executor;
         view.pieces = HSP_PIECES_OUTSIDE_FARTHER;
         return hsp_workspace_view(&work, 0, &view);
       }},
      {"view_all", boundary,
       [&] {
         view.executor = s.executor;
         view.pieces = HSP_PIECES_OUTSIDE_ALL;
         return hsp_workspace_view(&work, 1, &view);
       }},
      {"map", boundary,
       [&] {
         view.executor = s.executor;
         return hsp_workspace_map(&work, &view);
       }},
      {"moving", boundary, [&] { return hsp_workspace_moving(&work, nullptr, 1, 0, HSP_TANGENT_OVERLAP, nullptr); }},
      {"periodic", boundary,
       [&] {
         hsp_periodic_request request{};
         request.struct_size = sizeof request;
         request.executor = s.executor;
         return hsp_workspace_periodic_with(&work, n, balls.xyz.data(), balls.radius.data(), s.box, &request, nullptr);
       }},
      {"cells", boundary, [&] { return hsp_workspace_cells(&work); }},
      {"path", boundary,
       [&] {
         const double from[3] = {-20, -20, -20}, to[3] = {1000, 1000, 1000};
         hsp_path path;
         return hsp_workspace_path(&work, from, to, &path);
       }},
      {"pores", boundary,
       [&] {
         pores.executor = s.executor;
         return hsp_workspace_pores(&work, &pores);
       }},
      {"regions", boundary,
       [&] {
         const hsp_pores_request request{sizeof request, 0, s.executor};
         if (s.executor == nullptr) return hsp_workspace_pores(&work, nullptr);
         return hsp_pores_find_regions_with(work.pores, work.boundary, &request, nullptr, nullptr);
       }},
      {"tunnel", boundary,
       [&] {
         if (s.executor == nullptr) return hsp_workspace_pores(&work, nullptr);
         hsp_pores_counts counts;
         hsp_pores_get_counts(work.pores, &counts);
         hsp_pore_maximum maximum;
         hsp_pores_get_maxima(work.pores, counts.maxima / 2, 1, &maximum);
         hsp_tunnel tunnel;
         return hsp_workspace_cheapest_tunnel(&work, nullptr, maximum.xyz, nullptr, nullptr, 0, &tunnel);
       }},
  };
  for (const Row &row : rows) {
    bool wanted = count == 3;
    for (int k = 3; k < count; ++k) wanted = wanted || row.name == std::string(arguments[k]);
    if (!wanted) continue;
    s.executor = work.executor = nullptr;
    int32_t status = row.before();
    if (status == HSP_OK) status = row.ask();  // for memory
    Asked asked{meter};
    hsp_executor executor{sizeof executor, 1, &asked, nullptr, Asked::proceed};
    s.executor = work.executor = &executor;
    static_cast<void>(meter.spent());
    if (status == HSP_OK) status = row.ask();
    asked.note();
    std::printf("%-16s %7u balls %7lu questions, at most %10lu of %12lu between two; status %d\n", row.name, n,
                static_cast<unsigned long>(asked.questions), static_cast<unsigned long>(asked.most),
                static_cast<unsigned long>(asked.all), static_cast<int>(status));
    std::fflush(stdout);
  }
  hsp_workspace_free(&work);
  return 0;
}
