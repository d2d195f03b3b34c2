// Which rows are measured, and what their words mean to the library.
#pragma once

#include "lr_bench/subject.h"

#include <string>
#include <vector>

namespace lr_bench {

enum class Selection {
    quick,  // what the goals ask for, small bodies counts
    usual,  // the table of docs/maintainers/performance.md
    product // all models, integrators, paths, targets, counts, workers, substeps
};

bool find_model(const std::string& name, int32_t& load_model, int32_t& clock);
bool find_integrator(const std::string& name, int32_t& integrator);
int32_t target_value(const std::string& name); // -1: unknown
std::vector<std::string> targets_here();       // best first

// Rows of one group are alive together and timed in turns.
std::vector<std::vector<Row>> select_rows(Selection selection);

// From Row::name(); false if it is none.
bool parse_row(const std::string& name, Row& row);

// The subject of any row. Null, with a reason.
std::unique_ptr<Subject> make_subject(const Row& row, std::string& why_not);

} // namespace lr_bench
