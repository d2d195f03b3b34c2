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
// In the form that options take.
std::string size_text(double metres) {
    return length_text(metres, 3, "");
}
} // namespace

void warn_of_size(const BodySize& body, Faults& faults) {
    const bool far_off = !(body.length >= 1e-3 && body.length <= 2.0);
    const bool odd = body.mass > 1e3 || body.mass < 1e-10 || body.fall_speed > 150.0;
    if (!far_off && !odd) return;
    const std::string option = body.option ? body.option : "";
    std::string remedy;
    const auto offer = [&](double factor, const char* unit, const char* cause) {
        const double other = body.side * factor;
        if (other < 2e-3 || other > 2.0 || (option.empty() && !*unit)) return;
        remedy += remedy.empty() ? "Give " : ", ";
        remedy += option.empty() ? "--unit" : option;
        remedy.append(" ").append(option.empty() ? unit : size_text(other)).append(" if ").append(cause);
    };
    if (!body.given && body.length > 0.1) {
        offer(0.01, "cm", "it was modelled in centimetres");
        offer(0.001, "mm", "in millimetres");
        offer(0.0254, "", "in inches");
    } else if (!body.given) {
        offer(1000.0, "", "its lengths were divided by a thousand");
        offer(100.0, "", "by a hundred");
    }
    if (remedy.empty()) {
        remedy = "Give its true length, ";
        if (!option.empty()) remedy.append("as in ").append(option).append(" 20cm, ");
        remedy += "or another --density";
    }
    remedy += "; nothing if it is right.";
    faults.push_back({FaultId::parameter_implausible, Severity::warning, "size",
                      "The body is " + length_text(body.given.value_or(body.length)) + " long, weighs " +
                          three_digits(body.mass) + " kg and falls at about " + three_digits(body.fall_speed) + " m/s.",
                      remedy});
}
} // namespace lr::baker
