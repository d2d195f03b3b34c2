// lr_fit for users: exit codes. A whole run is a test of its own.
#include "baker/scratch.h"

#include <doctest/doctest.h>

TEST_CASE("lr_fit: wrong usage is 2, and says what would be right") {
    const auto fit = [](const std::vector<std::string>& arguments) { return lr::test::run(LR_FIT_PATH, arguments); };
    for (const std::vector<std::string>& bad : std::vector<std::vector<std::string>>{{"--start", "lift"},
                                                                                     {"--start", "lift=99"},
                                                                                     {"--start", "lift=1,5"},
                                                                                     {"--start", "drag=1"},
                                                                                     {"--fix", "drag"},
                                                                                     {"--seconds", "0"},
                                                                                     {"more"}})
        CHECK(fit(bad).exit_code == 2);
    CHECK(fit({"--start", "lift=99"}).err.find("between 1.2") != std::string::npos);
    CHECK(fit({"--help"}).exit_code == 0);
}
