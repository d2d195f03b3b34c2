// Moved to src/tools/falls.
#pragma once

#include "tools/falls/statistics.h"

namespace lr::scorecard {
using namespace lr::falls;
}
