// The scorecard as text, as a page of the documentation, and as JSON.
#pragma once

#include "tools/lr_scorecard/row.h"

#include <string>
#include <vector>

namespace lr::scorecard {

struct Finished {
    const Row* row;
    RowResult result;
};

std::string to_text(const Finished& row);
std::string to_markdown(const std::vector<Finished>& rows, const Context& context);
std::string to_json(const std::vector<Finished>& rows, const Context& context);
} // namespace lr::scorecard
