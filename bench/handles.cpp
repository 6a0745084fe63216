#include "handles.hpp"

#include <stdexcept>
#include <string>

namespace bench {

void require_ok(int32_t status, const char *what) {
  if (status != HSP_OK) throw std::runtime_error(std::string(what) + ": " + hsp_status_text(status));
}

Model::Model(const Balls &balls, double probe) : balls_(&balls) {
  require_ok(hsp_model_options_init(&options_, sizeof options_), "hsp_model_options_init");
  options_.probe = probe;
  std::size_t bytes = 0;
  require_ok(hsp_model_bytes(size(), &bytes), "hsp_model_bytes");
  memory_.resize(bytes);
  require_ok(hsp_model_init(memory_.data(), memory_.size(), size(), &model_), "hsp_model_init");
  set();
}

void Model::set() {
  require_ok(hsp_model_set(model_, size(), balls_->xyz.data(), balls_->radius.data(), &options_, nullptr),
             "hsp_model_set");
}

double Model::largest_radius() const {
  hsp_model_info info{};
  require_ok(hsp_model_get_info(model_, &info), "hsp_model_get_info");
  return info.largest_radius;
}

Boundary::Boundary(Model &model) : model_(model.get()), area_(model.size()), volume_(model.size()) {
  hsp_boundary_limits limits{};
  require_ok(hsp_boundary_limits_init(&limits, sizeof limits, model.size()), "hsp_boundary_limits_init");
  // Two enlargements at most lead to success (hsp_boundary_get_needed); the last round is for the exact size.
  limits.vertices = 4 * model.size() + 64;
  limits.circles = model.size() / 4 + 16;
  take(limits);
  int32_t status = hsp_boundary_compute(boundary_, model_);
  for (int enlargements = 0; status == HSP_E_CAPACITY && enlargements < 2; ++enlargements) {
    hsp_boundary_limits needed = limits;
    require_ok(hsp_boundary_get_needed(boundary_, &needed), "hsp_boundary_get_needed");
    if (needed.neighbours > limits.neighbours) limits.neighbours = needed.neighbours;
    if (needed.vertices > limits.vertices) limits.vertices = needed.vertices;
    if (needed.circles > limits.circles) limits.circles = needed.circles;
    take(limits);
    status = hsp_boundary_compute(boundary_, model_);
  }
  require_ok(status, "hsp_boundary_compute");
  require_ok(hsp_boundary_get_needed(boundary_, &limits), "hsp_boundary_get_needed");
  limits.struct_size = sizeof limits;
  limits.reserved = 0;
  take(limits);
  compute();
}

void Boundary::take(const hsp_boundary_limits &limits) {
  std::size_t bytes = 0;
  require_ok(hsp_boundary_bytes(&limits, &bytes), "hsp_boundary_bytes");
  std::vector<std::byte>().swap(memory_);
  memory_.resize(bytes);
  require_ok(hsp_boundary_init(memory_.data(), memory_.size(), &limits, &boundary_), "hsp_boundary_init");
}

void Boundary::compute() {
  require_ok(hsp_boundary_compute(boundary_, model_), "hsp_boundary_compute");
}

hsp_totals Boundary::measure() {
  hsp_totals totals{};
  require_ok(
      hsp_boundary_measure(boundary_, &totals, area_.data(), volume_.data(), static_cast<std::uint32_t>(area_.size())),
      "hsp_boundary_measure");
  return totals;
}

hsp_boundary_counts Boundary::counts() const {
  hsp_boundary_counts counts{};
  require_ok(hsp_boundary_get_counts(boundary_, &counts), "hsp_boundary_get_counts");
  return counts;
}

}  // namespace bench
