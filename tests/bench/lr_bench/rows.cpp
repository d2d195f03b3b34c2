#include "lr_bench/rows.h"
#include "peers/peers.h"

#include "langevin_rigid.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace lr_bench {
namespace {

struct Model {
    const char* name;
    int32_t load_model, clock;
};
constexpr Model models[] = {{"none", LR_LOADS_NONE, LR_CLOCK_SPEED},
                            {"langevin-speed", LR_LOADS_LANGEVIN, LR_CLOCK_SPEED},
                            {"langevin-age", LR_LOADS_LANGEVIN, LR_CLOCK_AGE},
                            {"aerodynamic", LR_LOADS_AERODYNAMIC, LR_CLOCK_SPEED}};

struct Integrator {
    const char* name;
    int32_t value;
};
constexpr Integrator integrators[] = {{"default", LR_INTEGRATOR_DEFAULT}, {"rk4", LR_INTEGRATOR_RK4}};

constexpr const char* paths[] = {"diagonal", "full"};

// Names without spaces, slashes or capitals.
std::string target_word(int32_t target) {
    std::string word = lr_simd_target_name(target);
    std::erase(word, '-');
    for (char& c : word)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + ('a' - 'A'));
    return word;
}

class Rows {
public:
    // Without duplicates.
    void add(Row row) {
        const std::string name = row.name();
        if (std::none_of(rows_.begin(), rows_.end(), [&](const Row& r) { return r.name() == name; }))
            rows_.push_back(std::move(row));
    }
    void ours(const std::string& model, const std::string& integrator, const std::string& path,
              const std::string& target, uint32_t workers, uint32_t bodies, uint32_t substeps) {
        add({"langevin_rigid", model, integrator, path, target, workers, bodies, substeps});
    }
    void sketch(uint32_t bodies) {
        for (const uint32_t substeps : {1u, 4u})
            for (const char* const target : {"native", "x86-64-v3"})
                add({"sketch", "langevin-speed", "rk4", "diagonal", target, 0, bodies, substeps});
        if (bodies >= 1000) add({"sketch", "langevin-speed", "rk4", "diagonal", "native-no-fma", 0, bodies, 4});
    }
    std::vector<Row> take() { return std::move(rows_); }

private:
    std::vector<Row> rows_;
};

std::vector<Row> goals(const std::vector<std::string>& targets, bool quick) {
    Rows rows;
    const std::string& best = targets.front();
    const uint32_t most = quick ? 100000 : 1000000;
    for (const uint32_t bodies : {1u, 1000u, 10000u, 100000u, 1000000u}) {
        if (bodies > most) continue;
        rows.sketch(bodies);
        for (const uint32_t workers : {0u, 1u})
            for (const uint32_t substeps : {1u, 4u}) {
                rows.ours("langevin-speed", "default", "diagonal", best, workers, bodies, substeps);
                if (substeps == 4 || workers == 0)
                    rows.ours("aerodynamic", "default", "diagonal", best, workers, bodies, substeps);
            }
        // As for users: a few bodies run on another target than many.
        if (bodies == 1)
            for (const char* const model : {"langevin-speed", "aerodynamic"})
                for (const uint32_t substeps : {1u, 4u})
                    rows.ours(model, "default", "diagonal", "auto", 0, bodies, substeps);
        rows.ours("langevin-speed", "default", "full", best, 0, bodies, 4);
        for (const char* const path : {"sheet", "full"}) rows.ours("aerodynamic", "default", path, best, 0, bodies, 4);
    }
    // The cost of variation and user data, beside the row of the same bodies on the diagonal path.
    for (const char* const path : {"alike", "user"})
        for (const uint32_t substeps : {1u, 4u}) rows.ours("aerodynamic", "default", path, best, 0, 100000, substeps);
    const uint32_t middle = quick ? 1000 : 10000;
    for (const std::string& target : targets) {
        for (const char* const model : {"langevin-speed", "aerodynamic"})
            for (const char* const path : paths) rows.ours(model, "default", path, target, 0, middle, 4);
        for (const char* const path : {"sheet", "stations5", "stations8"})
            rows.ours("aerodynamic", "default", path, target, 0, middle, 4);
        if (target == "avx2" && !quick)
            for (const uint32_t bodies : {1000u, 100000u, 1000000u})
                rows.ours("langevin-speed", "default", "diagonal", target, 0, bodies, 4);
    }
    for (const Model& model : models)
        for (const Integrator& integrator : integrators)
            for (const char* const path : paths) {
                rows.ours(model.name, integrator.name, path, best, 0, middle, 4);
                // A few rows of each other kind, so that their hashes can be compared.
                if (quick) rows.ours(model.name, integrator.name, path, targets.back(), 1, middle, 4);
            }
    for (const char* const layout : {"3x4", "4x4"})
        for (const char* const subject : {"transforms", "memcpy"})
            rows.add({subject, "langevin-speed", "default", layout, best, 0, most, 1});
    std::vector<std::string> missing;
    for (Row& peer : peer_rows(quick ? 10000 : most, missing)) rows.add(std::move(peer));
    return rows.take();
}

std::vector<std::vector<Row>> product(const std::vector<std::string>& targets) {
    std::vector<std::vector<Row>> groups;
    for (const uint32_t bodies : {1000u, 10000u, 100000u, 1000000u})
        for (const Model& model : models)
            for (const Integrator& integrator : integrators)
                for (const char* const path : paths) {
                    Rows rows;
                    rows.sketch(bodies);
                    for (const std::string& target : targets)
                        for (const uint32_t workers : {0u, 1u})
                            for (const uint32_t substeps : {1u, 4u})
                                rows.ours(model.name, integrator.name, path, target, workers, bodies, substeps);
                    groups.push_back(rows.take());
                }
    std::vector<std::string> missing;
    groups.push_back(peer_rows(1000000, missing));
    return groups;
}

} // namespace

bool find_model(const std::string& name, int32_t& load_model, int32_t& clock) {
    for (const Model& m : models)
        if (name == m.name) return load_model = m.load_model, clock = m.clock, true;
    return false;
}

bool find_integrator(const std::string& name, int32_t& integrator) {
    for (const Integrator& i : integrators)
        if (name == i.name) return integrator = i.value, true;
    return false;
}

std::vector<std::string> targets_here() {
    std::array<int32_t, 16> targets{};
    uint32_t count = 0;
    if (lr_simd_targets(targets.data(), targets.size(), &count) != LR_OK) count = 0;
    std::vector<std::string> words;
    for (uint32_t i = 0; i < count; ++i) words.push_back(target_word(targets[i]));
    return words;
}

int32_t target_value(const std::string& name) {
    for (int32_t t = LR_SIMD_AUTO; t <= LR_SIMD_PLAIN; ++t)
        if (target_word(t) == name) return t;
    return -1;
}

std::vector<std::vector<Row>> select_rows(Selection selection) {
    const std::vector<std::string> targets = targets_here();
    if (targets.empty()) return {};
    if (selection == Selection::product) return product(targets);
    return {goals(targets, selection == Selection::quick)};
}

bool parse_row(const std::string& name, Row& row) {
    std::vector<std::string> words(1);
    for (const char c : name) {
        if (c == '/')
            words.emplace_back();
        else
            words.back() += c;
    }
    if (words.size() != 8) return false;
    row.subject = words[0], row.model = words[1], row.integrator = words[2], row.path = words[3], row.target = words[4];
    uint32_t* const numbers[] = {&row.workers, &row.bodies, &row.substeps};
    for (size_t i = 0; i < 3; ++i) {
        const std::string& w = words[5 + i];
        const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), *numbers[i]);
        if (error != std::errc() || end != w.data() + w.size()) return false;
    }
    return row.bodies > 0 && row.substeps > 0;
}

std::unique_ptr<Subject> make_subject(const Row& row, std::string& why_not) {
    const bool ours = row.ours() || row.subject == "transforms" || row.subject == "memcpy";
    return ours ? make_ours(row, why_not) : make_peer(row, why_not);
}

} // namespace lr_bench
