// Verdicts, jobs and reports of the scorecard.
#include "baker/json.h"
#include "tools/lr_scorecard/report.h"

#include <doctest/doctest.h>

#include <atomic>
#include <limits>
#include <stdexcept>

using namespace lr::scorecard;

namespace {

bool holds(Rule rule, double value, double reference, double tolerance = 0.0) {
    return Check{"", rule, value, reference, tolerance, ""}.holds();
}

RowResult run_nothing(const Context&) {
    return {};
}

Finished sample_row(const Row& row) {
    RowResult result;
    result.add("a | b", Rule::relative, 1.05, 1.0, 0.1, "m/s");
    result.add("too large", Rule::at_most, 2.0, 1.0, 0.0);
    result.show("by the way", 3.0);
    result.add("one of many", Rule::compared, 1.3, 1.0, 0.2);
    result.remarks.push_back("A remark.");
    result.pictures.push_back({"p.svg", "<svg/>", "A picture."});
    return {&row, result};
}

} // namespace

TEST_CASE("verdicts: each rule at its edges, and nothing holds that is not a number") {
    CHECK(holds(Rule::relative, 1.1, 1.0, 0.1 + 1e-12));
    CHECK_FALSE(holds(Rule::relative, 1.11, 1.0, 0.1));
    CHECK(holds(Rule::relative, -0.95, -1.0, 0.1));
    CHECK_FALSE(holds(Rule::relative, 1.0, -1.0, 0.1));
    CHECK(holds(Rule::absolute, 0.1, 0.0, 0.1));
    CHECK_FALSE(holds(Rule::absolute, -0.11, 0.0, 0.1));
    CHECK(holds(Rule::at_most, 1.0, 1.0));
    CHECK_FALSE(holds(Rule::at_most, 1.01, 1.0));
    CHECK(holds(Rule::at_least, 1.0, 1.0));
    CHECK_FALSE(holds(Rule::at_least, 0.99, 1.0));
    for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        for (Rule rule : {Rule::relative, Rule::absolute, Rule::at_most, Rule::at_least}) {
            CHECK_FALSE(holds(rule, bad, 1.0, 1e9));
            CHECK_FALSE(holds(rule, -bad, 1.0, 1e9));
        }
        CHECK(holds(Rule::shown, bad, 0.0));
    }
    CHECK_FALSE(holds(Rule::relative, 0.0, 0.0, 0.1)); // nothing is relative to zero
    CHECK(holds(Rule::compared, 2.0, 1.0, 0.1));       // another check judges it
    CHECK_FALSE(Check{"", Rule::compared, 1.11, 1.0, 0.1, ""}.within());
    CHECK(Check{"", Rule::compared, 1.09, 1.0, 0.1, ""}.within());
}

TEST_CASE("jobs: each once, with progress to the end, on any number of threads, failures come out") {
    for (uint32_t threads : {1U, 2U, 7U}) {
        Context context;
        context.threads = threads;
        double last = 0.0;
        context.progress = [&](double part) {
            CHECK(part > last);
            last = part;
        };
        std::vector<std::atomic<int>> done(50);
        context.parallel(done.size(), [&](size_t i) { ++done[i]; });
        for (const std::atomic<int>& d : done) CHECK(d == 1);
        CHECK(last == 1.0);
        context.progress = {};
        CHECK_THROWS_WITH(context.parallel(50,
                                           [](size_t i) {
                                               if (i == 20) throw std::runtime_error("twenty");
                                           }),
                          "twenty");
        context.parallel(0, [](size_t) { FAIL("no job"); });
    }
}

TEST_CASE("rows: names are unlike and fit the anchors of a page, groups are known") {
    std::vector<std::string> seen;
    for (const Row& row : all_rows()) {
        const std::string id = row.id;
        CHECK(id.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") == std::string::npos);
        CHECK(std::find(seen.begin(), seen.end(), id) == seen.end());
        seen.push_back(id);
        const std::string group = row.group;
        CHECK((group == "exact" || group == "measured" || group == "paper"));
        CHECK(row.seconds > 0.0);
        CHECK(row.quick_seconds > 0.0);
    }
}

TEST_CASE("reports: all three say the same") {
    const Row row{"a-row", "exact", "A title", "a source", 1.0, 1.0, run_nothing};
    const Finished f = sample_row(row);
    CHECK_FALSE(f.result.holds());
    const std::string text = to_text(f);
    CHECK(text.starts_with("FAIL  a-row"));
    CHECK(text.find("1.05 m/s  |  1 +- 10 %  pass") != std::string::npos);
    CHECK(text.find("at most 1  FAIL") != std::string::npos);
    const std::string page = to_markdown({f}, Context{});
    CHECK(page.find("1 of 2 | **FAIL**") != std::string::npos);
    CHECK(page.find("| a \\| b | 1.05 m/s | 1 | 10 % | pass |") != std::string::npos);
    CHECK(page.find("![A picture.](images/scorecard/p.svg)") != std::string::npos);
    const lr::test::Json json = lr::test::Json::parse(to_json({f}, Context{}));
    CHECK(json["holds"] == false);
    const lr::test::Json checks = json["rows"][0]["checks"];
    REQUIRE(checks.size() == 4);
    CHECK(checks[0]["holds"] == true);
    CHECK(checks[1]["holds"] == false);
    CHECK_FALSE(checks[2].contains("holds"));
    CHECK(checks[3]["holds"] == false);
    CHECK(page.find("| one of many | 1.3 | 1 | 20 % | outside |") != std::string::npos);
}
