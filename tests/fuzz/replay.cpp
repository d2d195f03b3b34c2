// Runs files through a fuzzer's target without libFuzzer: replay [--reaches LIST] FILE|FOLDER...
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

#ifdef LR_FUZZ_REACHED
namespace fuzz {
const std::set<std::string>& reached();
}
#endif

namespace {

void run(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    // Exactly its size.
    const std::vector<uint8_t> input(bytes.begin(), bytes.end());
    LLVMFuzzerTestOneInput(input.data(), input.size());
}

#ifdef LR_FUZZ_REACHED
// Every function of the list must have been called.
bool reaches_all(const std::string& list) {
    std::ifstream file(list);
    size_t names = 0, missing = 0;
    for (std::string name; std::getline(file, name);) {
        if (name.empty()) continue;
        ++names;
        if (fuzz::reached().count(name) == 0) ++missing, std::fprintf(stderr, "never called: %s\n", name.c_str());
    }
    std::printf("%zu of %zu functions called\n", names - missing, names);
    return names != 0 && missing == 0;
}
#endif

} // namespace

int main(int count, char** arguments) {
    std::vector<std::filesystem::path> files;
    [[maybe_unused]] std::string list;
    for (int i = 1; i < count; ++i) {
        if (std::string(arguments[i]) == "--reaches" && i + 1 < count) {
            list = arguments[++i];
        } else if (std::filesystem::is_directory(arguments[i])) {
            for (const auto& entry : std::filesystem::directory_iterator(arguments[i])) files.push_back(entry.path());
        } else {
            files.emplace_back(arguments[i]);
        }
    }
    std::sort(files.begin(), files.end());
    for (const auto& file : files) run(file);
    std::printf("%zu inputs\n", files.size());
    if (files.empty()) return 1;
#ifdef LR_FUZZ_REACHED
    if (!list.empty() && !reaches_all(list)) return 1;
#endif
    return 0;
}
