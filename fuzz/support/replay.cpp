// Runs a harness without a fuzzing engine, with any compiler:
//   fuzz_AREA [--random COUNT] [--longest BYTES] [--seed NUMBER] FOLDER-OR-FILE...
// It runs every file of the folders in the order of their names, then COUNT pseudo-random inputs, which depend on the
// seed alone. An input that fails is named and written to the file `crash-input`, which can be run again by naming it.
#include <algorithm>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "random_numbers.hpp"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

// Defined by the sanitizers of g++ and clang; null without them.
extern "C" __attribute__((weak)) void __sanitizer_set_death_callback(void (*callback)());

namespace {

std::string running;
std::vector<uint8_t> input;

// Not async-signal-safe, but the process is at its end and what matters is to keep the input.
void keep_input() {
  std::fprintf(stderr, "failed on %s (%zu bytes), kept as crash-input\n", running.c_str(), input.size());
  if (std::FILE *file = std::fopen("crash-input", "wb")) {
    std::fwrite(input.data(), 1, input.size(), file);
    std::fclose(file);
  }
}

void on_signal(int) {
  keep_input();
  std::_Exit(1);
}

void run(const std::string &name) {
  running = name;
  LLVMFuzzerTestOneInput(input.data(), input.size());
}

}  // namespace

int main(int argc, char **argv) {
  uint64_t random = 0, longest = 160, seed = 1994, done = 0;
  std::vector<std::filesystem::path> files;
  for (const int signal : {SIGABRT, SIGFPE, SIGILL}) std::signal(signal, on_signal);
  if (__sanitizer_set_death_callback != nullptr) {
    __sanitizer_set_death_callback(keep_input);
  } else {
    std::signal(SIGSEGV, on_signal);
  }
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--random") == 0 && i + 1 < argc) {
      random = std::strtoull(argv[++i], nullptr, 10);
    } else if (std::strcmp(argv[i], "--longest") == 0 && i + 1 < argc) {
      longest = std::strtoull(argv[++i], nullptr, 10);
    } else if (std::strcmp(argv[i], "--seed") == 0 && i + 1 < argc) {
      seed = std::strtoull(argv[++i], nullptr, 10);
    } else if (std::filesystem::is_directory(argv[i])) {
      std::vector<std::filesystem::path> found;
      for (const auto &entry : std::filesystem::directory_iterator(argv[i])) {
        if (entry.is_regular_file()) found.push_back(entry.path());
      }
      if (found.empty()) {
        std::fprintf(stderr, "%s: no input in this folder\n", argv[i]);
        return 1;
      }
      std::sort(found.begin(), found.end());
      files.insert(files.end(), found.begin(), found.end());
    } else {
      files.emplace_back(argv[i]);
    }
  }
  for (const std::filesystem::path &path : files) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) {
      std::fprintf(stderr, "%s: cannot be read\n", path.c_str());
      return 1;
    }
    input.assign(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
    run(path.string());
    ++done;
  }
  support::Random bytes(seed);
  for (uint64_t i = 0; i < random; ++i, ++done) {
    input.resize(static_cast<std::size_t>(bytes.next() % (longest + 1)));
    for (uint8_t &byte : input) byte = static_cast<uint8_t>(bytes.next() >> 56);
    run("random input " + std::to_string(i));
  }
  std::printf("%llu inputs\n", static_cast<unsigned long long>(done));
  return done > 0 ? 0 : 1;
}
