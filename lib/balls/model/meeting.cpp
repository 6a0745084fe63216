#include "model/meeting.hpp"

#include "exact/power.hpp"

namespace hsp {

[[gnu::cold, gnu::noinline]] bool meet_exactly(double dx, double dy, double dz, double sum) {
  return exact::power({static_cast<int64_t>(dx), static_cast<int64_t>(dy), static_cast<int64_t>(dz)},
                      static_cast<int64_t>(sum))
             .sign() <= 0;
}

}  // namespace hsp
