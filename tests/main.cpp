#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
// doctest::Approx(x) accepts |a - b| < epsilon (1 + max(|a|, |b|)): any two areas or masses of leaves would be equal. This replaces
// the 1 in its constructor, so that tolerances are relative; not by 0, which doctest's own comparison of timeouts with 0 needs.
#define m_scale(one) m_scale(1e-100)
#include <doctest/doctest.h>

#include <cstdio>
#include <cstdlib>

#if defined(__SANITIZE_ADDRESS__)
// assimp leaks memory on some damaged files; this project cannot free it.
extern "C" __attribute__((visibility("default"))) const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libassimp\n";
}
#endif

namespace {

// A run without any matching test case would pass: CTest cuts names at a semicolon, and no test begins with half a name.
struct SomeRun : doctest::IReporter {
    explicit SomeRun(const doctest::ContextOptions&) {}
    void report_query(const doctest::QueryData&) override {}
    void test_run_start() override {
        if (1e-9 != doctest::Approx(2e-9)) return;
        std::fputs("doctest::Approx is not relative\n", stderr);
        std::_Exit(1);
    }
    void test_run_end(const doctest::TestRunStats& stats) override {
        if (stats.numTestCasesPassingFilters != 0) return;
        std::fputs("no test case passes the filters\n", stderr);
        std::_Exit(1);
    }
    void test_case_start(const doctest::TestCaseData&) override {}
    void test_case_reenter(const doctest::TestCaseData&) override {}
    void test_case_end(const doctest::CurrentTestCaseStats&) override {}
    void test_case_exception(const doctest::TestCaseException&) override {}
    void subcase_start(const doctest::SubcaseSignature&) override {}
    void subcase_end() override {}
    void log_assert(const doctest::AssertData&) override {}
    void log_message(const doctest::MessageData&) override {}
    void test_case_skipped(const doctest::TestCaseData&) override {}
};

} // namespace

DOCTEST_REGISTER_LISTENER("some_run", 1, SomeRun);
