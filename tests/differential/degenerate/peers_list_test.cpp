// The degenerate list of peers, row by row: the library must be right in every one. Prints the table.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "hardsphere.h"
#include "lattice_lengths.hpp"
#include "molecule_file.hpp"
#include "owned_handle.hpp"
#include "peers_inputs.hpp"
#include "set_checks.hpp"
#include "slice_quadrature.hpp"

namespace {

using degenerate::Arbiter;
using degenerate::PeersRow;
using degenerate::Topology;
using support::BallList;
using support::expect_ok;

// Relative.
constexpr long double tolerance = 1e-12L;

// A caller's whole session with the library, with default options.
struct Session {
  int32_t set_status = HSP_OK;
  uint32_t first_bad = 0;
  hsp_model_info info{};
  hsp_boundary_counts counts{};
  hsp_totals totals{};
  int32_t check_status = HSP_OK;
  std::vector<double> area;
};

Session session_with(const BallList &balls) {
  Session session;
  const auto n = static_cast<uint32_t>(balls.radius.size());
  support::OwnedModel model(n);
  session.set_status = model.set(balls, nullptr, &session.first_bad);
  expect_ok(hsp_model_get_info(model.get(), &session.info), "hsp_model_get_info");
  if (session.set_status != HSP_OK) return session;

  // Limits for molecules; lattices need more.
  support::OwnedBoundary owned;
  owned.take(support::default_boundary_limits(n));
  owned.compute([&](hsp_boundary *handle, hsp_boundary_limits *limits) {
    return hsp_boundary_compute(handle, model.get(), limits);
  });
  hsp_boundary *boundary = owned.get();
  expect_ok(hsp_boundary_get_counts(boundary, &session.counts), "hsp_boundary_get_counts");
  session.area.resize(n);
  expect_ok(hsp_boundary_measure(boundary, nullptr, &session.totals, session.area.data(), nullptr, n, nullptr),
            "hsp_boundary_measure");
  uint32_t invariant = 0;
  uint32_t id = 0;
  session.check_status = hsp_boundary_check(boundary, &invariant, &id);
  return session;
}

struct Amount {
  long double area;
  long double volume;
};

Amount right_amount(const PeersRow &row, const Session &session) {
  if (row.right.arbiter != Arbiter::slices) return {row.right.area, row.right.volume};
  const auto step = static_cast<long double>(session.info.step);
  // As the library documents to round them.
  const oracle::Balls rounded = oracle::on_lattice(row.balls, 0, std::round(1 / session.info.step));
  const oracle::SliceMeasures measures = oracle::measure_by_slices(oracle::real_balls(rounded));
  return {measures.area * step * step, measures.volume * step * step * step};
}

const char *name_of(Arbiter arbiter) {
  switch (arbiter) {
    case Arbiter::formula:
      return "formula";
    case Arbiter::slices:
      return "slice quadrature";
    case Arbiter::reference:
      return "reference value";
    case Arbiter::status:
      return "documented status";
  }
  return "";
}

// The library's result, for the table.
std::string check_finite(const PeersRow &row, const Session &session) {
  EXPECT_EQ(session.set_status, HSP_OK);
  EXPECT_EQ(session.first_bad, HSP_NONE);
  EXPECT_EQ(session.check_status, HSP_OK);
  const Topology topology{session.counts.components, session.counts.voids, session.counts.shells, session.counts.euler};
  EXPECT_EQ(degenerate::to_text(topology), degenerate::to_text(row.topology));
  const Amount right = right_amount(row, session);
  const long double area_error = std::abs(static_cast<long double>(session.totals.area) - right.area);
  const long double volume_error = std::abs(static_cast<long double>(session.totals.volume) - right.volume);
  EXPECT_LE(area_error, tolerance * right.area);
  EXPECT_LE(volume_error, tolerance * right.volume);
  if (right.area == 0) return "0";
  char text[64];
  std::snprintf(text, sizeof text, "%.0e",
                static_cast<double>(std::max(area_error / right.area, volume_error / right.volume)));
  return text;
}

std::string check_refused(const PeersRow &row, const Session &session) {
  EXPECT_EQ(session.set_status, row.right.status);
  EXPECT_EQ(session.first_bad, row.right.first_bad);
  EXPECT_EQ(session.info.balls, 0U);  // the model is empty
  return std::string(hsp_status_text(session.set_status)) + ", ball " + std::to_string(session.first_bad);
}

BallList crambin_atoms() {
  return with_radii(support::read_atoms(support::own_molecule("crambin.pdb")), support::Radii::van_der_waals);
}

TEST(PeersList, IsRightInEveryRow) {
  const BallList crambin = crambin_atoms();
  ASSERT_EQ(crambin.radius.size(), 327U);
  std::printf("| input | arbiter | hardsphere | Voronota-LT 1.1 | AlphaMol | libarvo | FreeSASA 2.1.2, L&R / S&R |\n");
  std::printf("|---|---|---|---|---|---|---|\n");
  const std::vector<PeersRow> rows = degenerate::peers_rows(crambin);
  EXPECT_EQ(rows.size(), 30U);
  for (const PeersRow &row : rows) {
    SCOPED_TRACE(row.input);
    const Session session = session_with(row.balls);
    const std::string ours =
        row.right.arbiter == Arbiter::status ? check_refused(row, session) : check_finite(row, session);
    std::printf("| %s | %s | %s | %s | %s | %s | %s |\n", row.input.c_str(), name_of(row.right.arbiter), ours.c_str(),
                row.voronota_lt.c_str(), row.alpha_mol.c_str(), row.libarvo.c_str(), row.free_sasa.c_str());
  }
}

// Crambin's rows are not only right in total.
TEST(PeersList, CrambinIsTheSameBallByBall) {
  const BallList crambin = crambin_atoms();
  const Session plain = session_with(crambin);
  EXPECT_EQ(plain.counts.vertices, degenerate::crambin_vertices);
  EXPECT_LE(std::abs(static_cast<long double>(plain.totals.area) - degenerate::crambin_area),
            tolerance * degenerate::crambin_area);
  int seen = 0;
  for (const PeersRow &row : degenerate::peers_rows(crambin)) {
    if (!row.input.starts_with("crambin")) continue;
    SCOPED_TRACE(row.input);
    ++seen;
    const Session other = session_with(row.balls);
    EXPECT_EQ(other.counts.vertices, plain.counts.vertices);
    EXPECT_EQ(other.counts.circles, plain.counts.circles);
    EXPECT_EQ(other.counts.faces, plain.counts.faces);
    EXPECT_EQ(other.counts.loops, plain.counts.loops);
    EXPECT_EQ(other.counts.euler, plain.counts.euler);
    EXPECT_EQ(other.counts.contained_balls, row.balls.radius.size() - 327);
    const double scale = row.balls.radius[0] / crambin.radius[0];
    for (size_t i = 0; i < other.area.size(); ++i) {
      if (i >= 327)
        EXPECT_EQ(other.area[i], 0);
      else if (std::abs(scale - 1) < 0.5)
        EXPECT_EQ(other.area[i], plain.area[i]);
      else
        EXPECT_NEAR(other.area[i], plain.area[i] * scale * scale, 1e-14 * plain.totals.area * scale * scale);
    }
  }
  EXPECT_EQ(seen, 6);
}

}  // namespace
