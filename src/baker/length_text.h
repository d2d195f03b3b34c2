// Readable lengths.
#pragma once

#include <cstdio>
#include <string>

namespace lr {

// "7 cm": in metres from 1 m on, in centimetres from 1 cm on, else in millimetres.
inline std::string length_text(double metres, int digits = 3, const char* space = " ") {
    const bool in_m = metres >= 1.0, in_cm = metres >= 0.01;
    const double factor = in_m ? 1.0 : in_cm ? 100.0 : 1000.0;
    char text[40];
    std::snprintf(text, sizeof text, "%.*g%s%s", digits, metres * factor, space, in_m ? "m" : in_cm ? "cm" : "mm");
    return text;
}
} // namespace lr
