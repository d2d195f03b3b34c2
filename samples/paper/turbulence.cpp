// SPDX-License-Identifier: MIT
#include "turbulence.h"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "failure.h"

BakeReport read_report(const std::string& path) {
    try {
        std::ifstream file(path);
        if (!file) throw Failure("cannot read " + path, "bake with samples/paper/bake.sh");
        const nlohmann::json json = nlohmann::json::parse(file);
        const auto &table = json.at("turbulence"), &timings = json.at("timings");
        BakeReport report{json.at("reynolds"),
                          json.at("u0"),
                          json.at("c0"),
                          table.at("dt"),
                          table.at("chi"),
                          table.at("epsilon"),
                          table.at("stationary"),
                          json.at("provenance").at("faces"),
                          timings.at("added mass"),
                          timings.at("turbulence")};
        if (report.chi.size() < 2 || report.chi.size() != report.epsilon.size() ||
            report.stationary >= report.chi.size() || !(report.table_dt > 0.0)) {
            throw Failure("report " + path + ": it has no valid table", "bake with samples/paper/bake.sh --force");
        }
        return report;
    } catch (const nlohmann::json::exception& error) {
        throw Failure("report " + path + ": " + error.what(), "bake with samples/paper/bake.sh");
    }
}

double closed_form_decay(double chi0, double t) {
    constexpr double c2 = 1.92;
    return std::pow(1.0 + (c2 - 1.0) * chi0 * t, -1.0 / (c2 - 1.0));
}
