// SPDX-License-Identifier: MIT
#include "figure_numbers.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "langevin_rigid.h"

namespace {

const char* name(Verdict verdict) {
    return verdict == Verdict::agrees ? "yes" : verdict == Verdict::differs ? "**no**" : "";
}

std::string title(const std::string& figure) {
    return figure == "table2" ? "Table 2" : "Fig. " + figure;
}

} // namespace

void Numbers::show(std::string figure, std::string model, std::string what, double value, std::string unit,
                   std::string paper) {
    rows_.push_back({std::move(figure), std::move(model), std::move(what), value, std::move(unit), std::move(paper),
                     Verdict::none});
}

void Numbers::judge(std::string figure, std::string model, std::string what, double value, std::string unit,
                    std::string paper, bool agrees) {
    rows_.push_back({std::move(figure), std::move(model), std::move(what), value, std::move(unit), std::move(paper),
                     agrees ? Verdict::agrees : Verdict::differs});
}

std::string Numbers::markdown() const {
    std::string text, figure;
    for (const Row& row : rows_) {
        if (row.figure != figure) {
            figure = row.figure;
            text += (text.empty() ? "" : "\n");
            text +=
                "**" + title(figure) + "**\n\n| of | measured | value | the paper | agrees |\n|---|---|---|---|---|\n";
        }
        char value[32];
        std::snprintf(value, sizeof value, std::abs(row.value) >= 1000.0 ? "%.0f" : "%.3g", row.value);
        text += "| " + row.model + " | " + row.what + " | " + value + (row.unit.empty() ? "" : " " + row.unit) + " | " +
                row.paper + " | " + name(row.verdict) + " |\n";
    }
    return text;
}

std::string Numbers::json(std::uint64_t seed, std::uint32_t falls) const {
    const std::uint32_t version = lr_version();
    nlohmann::ordered_json json;
    json["library"] = std::to_string(version >> 22) + "." + std::to_string(version >> 12 & 1023) + "." +
                      std::to_string(version & 4095);
    json["seed"] = seed;
    json["falls"] = falls;
    json["rows"] = nlohmann::ordered_json::array();
    for (const Row& row : rows_) {
        nlohmann::ordered_json one{{"figure", row.figure}, {"of", row.model},  {"what", row.what},
                                   {"value", row.value},   {"unit", row.unit}, {"paper", row.paper}};
        if (row.verdict != Verdict::none) one["agrees"] = row.verdict == Verdict::agrees;
        json["rows"].push_back(one);
    }
    return json.dump(1) + "\n";
}
