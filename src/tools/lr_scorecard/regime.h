// Moved to src/tools/falls.
#pragma once

#include "tools/falls/regime.h"

namespace lr::scorecard {
using namespace lr::falls;
}
