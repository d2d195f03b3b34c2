// The measured rows, and the library's constants for their names.
#pragma once

#include "lr_bench/subject.h"

#include <string>
#include <vector>

namespace lr_bench {

enum class Selection {
    quick,  // enough for the goals, small numbers of bodies
    usual,  // the table of docs/maintainers/performance.md
    product // all models, integrators, paths, targets, counts, workers, substeps
};

bool find_model(const std::string& name, int32_t& load_model, int32_t& clock);
bool find_integrator(const std::string& name, int32_t& integrator);
int32_t target_value(const std::string& name); // -1: unknown
std::vector<std::string> targets_here();       // best first

// Rows of a group exist together and are timed in turns.
std::vector<std::vector<Row>> select_rows(Selection selection);

// From Row::name(); false if invalid.
bool parse_row(const std::string& name, Row& row);

// The subject of any row; null, with a reason.
std::unique_ptr<Subject> make_subject(const Row& row, std::string& why_not);

} // namespace lr_bench
