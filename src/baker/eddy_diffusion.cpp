#include "baker/eddy_diffusion.h"

#include <algorithm>

namespace lr::baker {

void EddyDiffusion::apply(GridField& field, const std::vector<uint8_t>& prescribed,
                          const std::vector<double>& viscosity, Wall wall, double dt) {
    const size_t longest = std::max({field.count[0], field.count[1], field.count[2]});
    link_.resize(longest + 1);
    upper_.resize(longest + 1);
    right_.resize(longest + 1);
    const size_t stride[3] = {1, field.count[0], static_cast<size_t>(field.count[0]) * field.count[1]};
    for (size_t axis = 0; axis < 3; ++axis) {
        const size_t p = (axis + 1) % 3, q = (axis + 2) % 3, n = field.count[axis], step = stride[axis];
        const double rate = dt * field.inverse_spacing[axis] * field.inverse_spacing[axis];
        for (size_t s = 0; s < field.count[q]; ++s)
            for (size_t r = 0; r < field.count[p]; ++r) {
                const size_t start = r * stride[p] + s * stride[q];
                // link_[m] joins samples m - 1 and m of the line.
                link_[0] = link_[n] = 0.0;
                for (size_t m = 1; m < n; ++m) {
                    const double x = viscosity[start + (m - 1) * step], y = viscosity[start + m * step];
                    const bool inside = x > 0.0 && y > 0.0;
                    link_[m] = rate * (inside ? 0.5 * (x + y) : (wall == Wall::no_slip ? std::max(x, y) : 0.0));
                }
                // The inflow column lies only half a cell before the next sample.
                if (axis == 0 && field.inflow_column) link_[1] *= 2.0;
                // Thomas algorithm; a prescribed sample is a row of the identity.
                double upper = 0.0, right = 0.0;
                for (size_t m = 0; m < n; ++m) {
                    const bool free = prescribed[start + m * step] == 0;
                    const double below = free ? link_[m] : 0.0, above = free ? link_[m + 1] : 0.0;
                    const double pivot = 1.0 + above + below * (1.0 - upper);
                    right = (field.values[start + m * step] + below * right) / pivot;
                    upper = above / pivot;
                    upper_[m] = upper;
                    right_[m] = right;
                }
                double value = 0.0;
                for (size_t m = n; m-- > 0;) {
                    value = right_[m] + upper_[m] * value;
                    field.values[start + m * step] = value;
                }
            }
    }
}

} // namespace lr::baker
