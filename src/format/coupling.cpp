#include "format/coupling.h"

#include <algorithm>
#include <cmath>

namespace lr {

double largest_coupling(const AssetData& a) {
    double largest = 0.0;
    for (const double c : a.center_of_buoyancy) largest = std::max(largest, std::abs(c) / a.length_d);
    for (const double c : a.aerodynamics.center) largest = std::max(largest, std::abs(c) / a.length_d);
    const auto relative = [](double off, double x, double y) { return std::abs(off) / std::sqrt(std::abs(x * y)); };
    // About an axis of revolution the added inertia vanishes; the body's own then says what is small.
    const auto size = [&](std::size_t n) {
        return a.added_mass[n * 7] + (n < 3 ? a.volume : a.inertia[(n - 3) * 4] / a.density);
    };
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < i; ++j) {
            largest = std::max(largest, relative(a.added_mass[i * 6 + j], size(i), size(j)));
            if (j >= 3)
                largest = std::max(
                    largest, relative(a.inertia[(i - 3) * 3 + j - 3], a.inertia[(i - 3) * 4], a.inertia[(j - 3) * 4]));
        }
    return largest;
}

} // namespace lr
