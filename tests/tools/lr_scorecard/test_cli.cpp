// lr_scorecard for users: choices, files, exit codes.
#include "baker/json.h"
#include "baker/scratch.h"

#include <doctest/doctest.h>

using lr::test::Outcome;
using lr::test::Scratch;

namespace {

Outcome scorecard(const std::vector<std::string>& arguments) {
    return lr::test::run(LR_SCORECARD_PATH, arguments);
}

} // namespace

TEST_CASE("lr_scorecard: lists rows without running them, and only those asked for") {
    const Outcome all = scorecard({"--list"});
    CHECK(all.exit_code == 0);
    for (const char* id : {"kirchhoff", "phase-map", "cost"}) CHECK(all.out.find(id) != std::string::npos);
    const Outcome exact = scorecard({"--list", "--group", "exact"});
    CHECK(exact.out.find("kirchhoff") != std::string::npos);
    CHECK(exact.out.find("phase-map") == std::string::npos);
    const Outcome two = scorecard({"--list", "--only", "discs,leaf"});
    CHECK(std::count(two.out.begin(), two.out.end(), '\n') == 2);
}

TEST_CASE("lr_scorecard: wrong usage is 2, and says what would be right") {
    const Outcome row = scorecard({"--only", "nonsense"});
    CHECK(row.exit_code == 2);
    CHECK(row.err.find("phase-map") != std::string::npos);
    for (const std::vector<std::string>& bad : std::vector<std::vector<std::string>>{{"--seeds", "1"},
                                                                                     {"--seeds", "many"},
                                                                                     {"--threads", "0"},
                                                                                     {"--group", "all"},
                                                                                     {"--loads", "heavy"},
                                                                                     {"more"}})
        CHECK(scorecard(bad).exit_code == 2);
    CHECK(scorecard({"--help"}).exit_code == 0);
    CHECK(scorecard({"--version"}).exit_code == 0);
}

TEST_CASE("lr_scorecard: runs a row, writes what it found, and does not depend on the number of threads") {
    const Scratch scratch;
    const std::vector<std::string> run{"--quick", "--only", "sphere,discs", "--seeds", "8", "--report-only"};
    std::vector<std::string> pages;
    for (const char* threads : {"1", "3"}) {
        std::vector<std::string> arguments = run;
        const std::string folder = scratch.path(threads), json = scratch.path(std::string(threads) + ".json");
        arguments.insert(arguments.end(), {"--threads", threads, "--output-dir", folder, "--json", json});
        const Outcome outcome = scorecard(arguments);
        CHECK(outcome.exit_code == 0);
        CHECK(outcome.out.find("PASS  sphere") != std::string::npos);
        CHECK(outcome.err.find("discs") != std::string::npos); // progress
        pages.push_back(scratch.read(std::string(threads) + "/scorecard.md"));
        CHECK(pages.back().find("## discs") != std::string::npos);
        CHECK(scratch.read(std::string(threads) + "/images/scorecard/discs.svg").find("</svg>") != std::string::npos);
        const lr::test::Json found = lr::test::Json::parse(scratch.read(std::string(threads) + ".json"));
        CHECK(found["rows"].size() == 2);
        CHECK(found["rows"][0]["holds"] == true);
    }
    CHECK(pages[0] == pages[1]);
}

TEST_CASE("lr_scorecard: exit code 1 when a row does not hold, 3 when a file cannot be written") {
    const Scratch scratch;
    // Two falls cannot hold 38 of 40 means to 15 %.
    CHECK(scorecard({"--quick", "--quiet", "--only", "discs", "--seeds", "2"}).exit_code == 1);
    const Outcome quiet = scorecard({"--quiet", "--only", "sphere"});
    CHECK(quiet.exit_code == 0);
    CHECK(quiet.err.empty());
    const Outcome file = scorecard({"--quiet", "--only", "sphere", "--json", scratch.path("none/out.json")});
    CHECK(file.exit_code == 3);
    CHECK(file.err.find("none/out.json") != std::string::npos);
    CHECK(scorecard({"--quiet", "--only", "sphere", "--output-dir", scratch.write("file", "") + "/sub"}).exit_code ==
          3);
}
