#include "smallest_failing.hpp"

#include <exception>

namespace {

std::string complain(const oracle::Balls &balls, const Complaint &complaint) {
  try {
    return complaint(balls);
  } catch (const std::exception &error) {
    return std::string("exception: ") + error.what();
  }
}

}  // namespace

std::string complaint_about_smallest(const oracle::Balls &balls, const Complaint &complaint) {
  std::string text = complain(balls, complaint);
  if (text.empty()) return text;
  oracle::Balls smallest = balls;
  for (size_t k = 0; k < smallest.size();) {
    oracle::Balls fewer = smallest;
    fewer.erase(fewer.begin() + static_cast<ptrdiff_t>(k));
    const std::string still = complain(fewer, complaint);
    if (still.empty()) {
      ++k;
      continue;
    }
    text = still;
    smallest = fewer;
    k = 0;
  }
  return text + "\nfor the " + std::to_string(smallest.size()) + " balls " + oracle::to_text(smallest) +
         "found among " + oracle::to_text(balls);
}
