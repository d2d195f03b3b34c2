#include "tools/lr_scorecard/report.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lr::scorecard {
namespace {

std::string number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

std::string with_unit(double value, const std::string& unit) {
    std::string text = number(value);
    if (!unit.empty()) text.append(" ").append(unit);
    return text;
}

std::string reference(const Check& c) {
    switch (c.rule) {
    case Rule::at_most:
        return std::string("at most ").append(number(c.reference));
    case Rule::at_least:
        return std::string("at least ").append(number(c.reference));
    case Rule::shown:
        return "";
    default:
        return number(c.reference);
    }
}

std::string tolerance(const Check& c) {
    switch (c.rule) {
    case Rule::relative:
    case Rule::compared:
        return number(100.0 * c.tolerance) + " %";
    case Rule::absolute:
        return number(c.tolerance);
    default:
        return "";
    }
}

// A vertical bar would end the table cell.
std::string in_table(const std::string& text) {
    std::string out;
    for (char c : text) {
        if (c == '|') out += '\\';
        out += c;
    }
    return out;
}

const char* verdict(const Check& c) {
    if (c.rule == Rule::compared) return c.within() ? "within" : "outside";
    return c.rule == Rule::shown ? "" : c.holds() ? "pass" : "FAIL";
}

const char* rule_name(Rule rule) {
    static constexpr const char* names[] = {"relative", "absolute", "at most", "at least", "compared", "shown"};
    return names[static_cast<size_t>(rule)];
}
} // namespace

std::string to_text(const Finished& f) {
    std::string out = std::string(f.result.holds() ? "PASS  " : "FAIL  ") + f.row->id + ": " + f.row->title + " (" +
                      f.row->source + ")\n";
    for (const Check& c : f.result.checks) {
        std::string line = "      " + c.what;
        line.resize(std::max<size_t>(line.size() + 1, 78), ' ');
        line += with_unit(c.value, c.unit);
        if (c.rule != Rule::shown)
            line.append("  |  ")
                .append(reference(c))
                .append(tolerance(c).empty() ? "" : " +- ")
                .append(tolerance(c))
                .append("  ")
                .append(verdict(c));
        out += line + "\n";
    }
    for (const std::string& r : f.result.remarks) out.append("      ").append(r).append("\n");
    return out;
}

std::string to_markdown(const std::vector<Finished>& rows, const Context& context) {
    std::string out =
        "# Scorecard\n\nThis page compares the library with all known references for falling bodies, with "
        "verdicts. "
        "`lr_scorecard` writes it; how it measures: [measurements.md](measurements.md).\n\n";
    out += "Loads: " + context.loads.name +
           ". Falls per cell of discs and set of seeds: " + std::to_string(context.seeds) +
           ". Releases per point of the phase map: " + std::to_string(context.quick ? 8 : context.phase_seeds) +
           (context.quick ? ". Quick: fewer and shorter runs than the full one" : "") + ".\n\n";
    out += "| row | | reference | checks that hold | verdict |\n|---|---|---|---|---|\n";
    for (const Finished& f : rows) {
        size_t held = 0, all = 0;
        for (const Check& c : f.result.checks) {
            if (c.rule == Rule::shown || c.rule == Rule::compared) continue;
            ++all;
            held += c.holds();
        }
        out += "| [" + std::string(f.row->id) + "](#" + f.row->id + ") | " + in_table(f.row->title) + " | " +
               f.row->source + " | " + std::to_string(held) + " of " + std::to_string(all) + " | " +
               (f.result.holds() ? "pass" : "**FAIL**") + " |\n";
    }
    for (const Finished& f : rows) {
        out += "\n## " + std::string(f.row->id) + "\n\n" + f.row->title + ". Reference: " + f.row->source + ".\n\n";
        out += "| what | value | reference | tolerance | verdict |\n|---|---|---|---|---|\n";
        // The table omits long series without a verdict (the picture shows them) and long series equal to their references.
        const auto shown = std::count_if(f.result.checks.begin(), f.result.checks.end(),
                                         [](const Check& c) { return c.rule == Rule::shown; });
        size_t equal = 0;
        for (const Check& c : f.result.checks) {
            if (c.rule == Rule::shown && shown > 12) continue;
            const bool fails = !c.holds();
            if (!fails && f.result.checks.size() > 30 && number(c.value) == reference(c)) {
                ++equal;
                continue;
            }
            out += "| " + in_table(c.what) + " | " + with_unit(c.value, c.unit) + " | " + reference(c) + " | " +
                   tolerance(c) + " | " + (fails ? "**FAIL**" : verdict(c)) + " |\n";
        }
        if (equal > 0)
            out.append("\n")
                .append(std::to_string(equal))
                .append(" more values equal their references to all digits.\n");
        if (shown > 12)
            out.append("\n")
                .append(std::to_string(shown))
                .append(" more numbers, without a verdict, are in `--json`.\n");
        for (const std::string& r : f.result.remarks) out += "\n" + r + "\n";
        for (const Picture& p : f.result.pictures) out += "\n![" + p.caption + "](images/scorecard/" + p.file + ")\n";
    }
    return out;
}

std::string to_json(const std::vector<Finished>& rows, const Context& context) {
    nlohmann::ordered_json json;
    json["version"] = langevin_rigid::baker_version();
    json["loads"] = context.loads.name;
    json["seeds"] = context.seeds;
    json["quick"] = context.quick;
    bool all = true;
    for (const Finished& f : rows) {
        nlohmann::ordered_json row;
        row["id"] = f.row->id;
        row["title"] = f.row->title;
        row["source"] = f.row->source;
        row["holds"] = f.result.holds();
        row["seconds"] = f.result.seconds;
        for (const Check& c : f.result.checks) {
            nlohmann::ordered_json check;
            check["what"] = c.what;
            check["value"] = c.value;
            check["unit"] = c.unit;
            check["rule"] = rule_name(c.rule);
            if (c.rule != Rule::shown) {
                check["reference"] = c.reference;
                if (!tolerance(c).empty()) check["tolerance"] = c.tolerance;
                check["holds"] = c.within();
            }
            row["checks"].push_back(std::move(check));
        }
        row["remarks"] = f.result.remarks;
        all = all && f.result.holds();
        json["rows"].push_back(std::move(row));
    }
    json["holds"] = all;
    return json.dump(2) + "\n";
}
} // namespace lr::scorecard
