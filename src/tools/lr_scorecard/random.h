// Moved to src/tools/falls.
#pragma once

#include "tools/falls/random.h"

namespace lr::scorecard {
using namespace lr::falls;
}
