// The results of lr_drop as text and as JSON.
#pragma once

#include "tools/falls/how_it_falls.h"
#include "tools/lr_drop/options.h"

namespace lr::tools {

struct Results {
    falls::Shape shape;
    falls::Falls falls;
    std::vector<falls::Fall> each;
    double step = 0.0;                // s
    std::vector<falls::Track> tracks; // of the first bodies, for the picture
};

// Three digits without an exponent, whatever the size.
std::string number(double x);

// "500 falls of leaf from 1 m, released at random, wind 1,0,0 m/s"
std::string title(const DropCommand& command, const Results& results);
std::string text(const DropCommand& command, const Results& results);
std::string json(const DropCommand& command, const Results& results);
} // namespace lr::tools
