// The main function of a program that holds the tests of a folder:
//   PROGRAM [--file=NAME [--without=CASE:CASE...]] [GoogleTest's options]
// With --file it runs the tests of one source of the folder, as ctest does; with --without too, all but the cases
// named.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>

namespace {

// The tests of a source as a filter of GoogleTest's: their full names, with ':' between them.
std::string tests_of(std::string_view source) {
  std::string names;
  const testing::UnitTest &program = *testing::UnitTest::GetInstance();
  for (int s = 0; s < program.total_test_suite_count(); ++s) {
    const testing::TestSuite &suite = *program.GetTestSuite(s);
    for (int t = 0; t < suite.total_test_count(); ++t) {
      const testing::TestInfo &test = *suite.GetTestInfo(t);
      const std::string_view path = test.file();
      if (path.substr(path.find_last_of('/') + 1) != source) continue;
      names.append(suite.name()).append(1, '.').append(test.name()).append(1, ':');
    }
  }
  return names;
}

// Whether each of `some`, with ':' between them, is one of `names`, which has ':' behind each.
bool are_among(std::string_view names, std::string_view some) {
  const std::string between = ':' + std::string(names);
  while (!some.empty()) {
    const std::string_view one = some.substr(0, some.find(':'));
    if (between.find(':' + std::string(one) + ':') == std::string::npos) return false;
    some.remove_prefix(std::min(some.size(), one.size() + 1));
  }
  return true;
}

}  // namespace

int main(int argc, char **argv) {
  testing::InitGoogleTest(&argc, argv);
  constexpr std::string_view option = "--file=";
  constexpr std::string_view without = "--without=";
  const bool of_a_file = argc >= 2 && std::string_view(argv[1]).starts_with(option);
  const bool with_exceptions = of_a_file && argc == 3 && std::string_view(argv[2]).starts_with(without);
  if (argc > 1 && !(of_a_file && argc == 2) && !with_exceptions) {
    std::fprintf(stderr, "usage: %s [--file=NAME [--without=CASE:CASE...]] [GoogleTest's options]\n", argv[0]);
    return 2;
  }
  if (of_a_file) {
    const std::string_view source = std::string_view(argv[1]).substr(option.size());
    const std::string_view left_out = with_exceptions ? std::string_view(argv[2]).substr(without.size()) : "";
    std::string names = tests_of(source);
    if (names.empty() || !are_among(names, left_out)) {
      std::fprintf(stderr, "there is no test in a source called %s, or not all those to be left out\n",
                   argv[1] + option.size());
      return 2;
    }
    if (!left_out.empty()) names.append(1, '-').append(left_out);
    GTEST_FLAG_SET(filter, names);
  }
  return RUN_ALL_TESTS();
}
