// The main function of a program that holds the tests of a folder:
//   PROGRAM [--file=NAME] [GoogleTest's options]
// With --file it runs the tests of one source of the folder, as ctest does.
#include <gtest/gtest.h>

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

}  // namespace

int main(int argc, char **argv) {
  testing::InitGoogleTest(&argc, argv);
  constexpr std::string_view option = "--file=";
  if (argc == 2 && std::string_view(argv[1]).starts_with(option)) {
    const std::string_view source = std::string_view(argv[1]).substr(option.size());
    const std::string names = tests_of(source);
    if (names.empty()) {
      std::fprintf(stderr, "there is no test in a source called %s\n", argv[1] + option.size());
      return 2;
    }
    GTEST_FLAG_SET(filter, names);
  } else if (argc > 1) {
    std::fprintf(stderr, "usage: %s [--file=NAME] [GoogleTest's options]\n", argv[0]);
    return 2;
  }
  return RUN_ALL_TESTS();
}
