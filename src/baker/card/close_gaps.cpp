#include "baker/card/close_gaps.h"

#include <algorithm>
#include <cmath>

namespace lr::baker {
namespace {

// All pixels within the reach of one that has this value get it. Per row: those near each are as many neighbours as its distance within its column
// leaves.
void grow(std::vector<uint8_t>& bits, std::size_t width, std::size_t reach, uint8_t value) {
    const std::size_t height = bits.size() / width, far = reach + 1;
    std::vector<std::size_t> half(far);
    for (std::size_t d = 0; d < far; ++d)
        half[d] = static_cast<std::size_t>(std::sqrt(static_cast<double>(reach * reach - d * d)));
    std::vector<uint16_t> away(bits.size());
    std::vector<uint16_t> column(width, static_cast<uint16_t>(far));
    const auto pass = [&](std::size_t y, bool first) {
        for (std::size_t i = y * width, x = 0; x < width; ++x, ++i) {
            const auto next = static_cast<uint16_t>(std::min<std::size_t>(column[x] + 1U, far));
            column[x] = bits[i] == value ? uint16_t{0} : first ? next : std::min(next, away[i]);
            away[i] = column[x];
        }
    };
    for (std::size_t y = 0; y < height; ++y) pass(y, true);
    std::fill(column.begin(), column.end(), static_cast<uint16_t>(far));
    for (std::size_t y = height; y-- > 0;) pass(y, false);
    std::vector<int32_t> begins(width + 1);
    for (std::size_t y = 0; y < height; ++y) {
        std::fill(begins.begin(), begins.end(), 0);
        for (std::size_t x = 0; x < width; ++x) {
            const uint16_t d = away[y * width + x];
            if (d > reach) continue;
            ++begins[x - std::min(x, half[d])];
            --begins[std::min(width, x + half[d] + 1)];
        }
        int32_t open = 0;
        for (std::size_t x = 0; x < width; ++x) {
            open += begins[x];
            if (open > 0) bits[y * width + x] = value;
        }
    }
}
} // namespace

AlphaMask close_gaps(const AlphaMask& mask, double opaque, std::size_t reach) {
    const double level = opaque * 65535.0;
    const std::size_t width = mask.width + 2 * reach, height = mask.height + 2 * reach;
    std::vector<uint8_t> bits(width * height, 0);
    for (std::size_t y = 0; y < mask.height; ++y)
        for (std::size_t x = 0; x < mask.width; ++x)
            bits[(y + reach) * width + x + reach] = mask.opacity[y * mask.width + x] >= level;
    grow(bits, width, reach, 1);
    grow(bits, width, reach, 0);
    AlphaMask out = mask;
    for (std::size_t y = 0; y < mask.height; ++y)
        for (std::size_t x = 0; x < mask.width; ++x) {
            uint16_t& opacity = out.opacity[y * mask.width + x];
            if (bits[(y + reach) * width + x + reach] != 0 && opacity < level) opacity = 65535;
        }
    return out;
}
} // namespace lr::baker
