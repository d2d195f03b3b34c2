#include "baker/size_warning.h"

#include "baker/length_text.h"

#include <cstdio>
#include <string>

namespace lr::baker {
namespace {

std::string three_digits(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", x);
    return text;
}
// In the form that --size takes.
std::string size_text(double metres) {
    return length_text(metres, 3, "");
}
} // namespace

void warn_of_size(const BodySize& body, Faults& faults) {
    const bool far_off = !(body.length >= 1e-3 && body.length <= 2.0);
    const bool odd = body.mass > 1e3 || body.mass < 1e-10 || body.fall_speed > 150.0;
    if (!far_off && !odd) return;
    const double side = body.given.value_or(body.side);
    std::string remedy;
    const auto offer = [&](double factor, const char* cause) {
        const double other = side * factor;
        if (other < 2e-3 || other > 2.0) return;
        remedy += (remedy.empty() ? "Give --size " : ", --size ") + size_text(other) + " if " + cause;
    };
    if (!body.given && body.length > 0.1) {
        offer(0.01, "it was modelled in centimetres");
        offer(0.001, "in millimetres");
        offer(0.0254, "in inches");
    } else if (!body.given) {
        offer(1000.0, "its lengths were divided by a thousand");
        offer(100.0, "by a hundred");
    }
    remedy += remedy.empty() ? "Give its true length, as in --size 20cm, or another --density; nothing if it is right."
                             : "; nothing if it is right.";
    faults.push_back({FaultId::parameter_implausible, Severity::warning, "size",
                      "The body is " + length_text(side) + " long, weighs " + three_digits(body.mass) +
                          " kg and falls at about " + three_digits(body.fall_speed) + " m/s.",
                      remedy});
}
} // namespace lr::baker
