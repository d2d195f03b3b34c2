#include "baker/plot/plot_axis.h"
#include "baker/plot/plots.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace lr::baker {
namespace {

constexpr const char* row_names[6] = {"vx", "vy", "vz", "\xcf\x89x", "\xcf\x89y", "\xcf\x89z"};
constexpr const char* axis_names[3] = {"x", "y", "z"};

struct Entry {
    std::size_t row, column;
};

struct Block {
    const char* title;
    const char* unit;
    double scale = 0.0;
    std::vector<Entry> entries;
};

// The blocks A, B and D. Scales: the largest diagonal entry of A and of D; for the coupling B their geometric mean, its bound in a positive matrix.
std::array<Block, 3> blocks_of(const AssetData& a) {
    std::array<Block, 3> blocks{{{"A, translation", "kg", 0.0, {}},
                                 {"B, coupling", "kg m", 0.0, {}},
                                 {"D, rotation", "kg m\xc2\xb2", 0.0, {}}}};
    for (std::size_t i = 0; i < 3; ++i) {
        blocks[0].scale = std::max(blocks[0].scale, a.fluid_density * std::abs(a.added_mass[i * 7]));
        blocks[2].scale = std::max(blocks[2].scale, a.fluid_density * std::abs(a.added_mass[(i + 3) * 7]));
        for (std::size_t j = 0; j < 3; ++j) blocks[1].entries.push_back({i, j + 3});
    }
    blocks[1].scale = std::sqrt(blocks[0].scale * blocks[2].scale);
    for (const std::size_t first : {std::size_t{0}, std::size_t{3}})
        for (std::size_t apart = 0; apart < 3; ++apart) // the diagonal first
            for (std::size_t i = 0; i + apart < 3; ++i)
                blocks[first == 0 ? 0 : 2].entries.push_back({first + i, first + i + apart});
    return blocks;
}

const Block& block_at(const std::array<Block, 3>& blocks, std::size_t row, std::size_t column) {
    return blocks[(row < 3 ? 0U : 1U) + (column < 3 ? 0U : 1U)];
}

double share(double value, const Block& block) {
    return block.scale > 0.0 ? value / block.scale : 0.0;
}

// Colour scale: blue for -1, white for 0, red for 1.
std::string heat(double part) {
    const double p = std::clamp(part, -1.0, 1.0);
    const int full[3] = {p < 0.0 ? 46 : 190, p < 0.0 ? 102 : 58, p < 0.0 ? 168 : 48};
    std::string color = "rgb(";
    for (int i = 0; i < 3; ++i) {
        if (i > 0) color += ',';
        color += std::to_string(255 + static_cast<int>(std::lround(std::abs(p) * (full[i] - 255))));
    }
    color += ')';
    return color;
}

std::string cell_number(double part) {
    const double size = std::abs(part);
    if (size == 0.0) return "0";
    if (size >= 0.1) return paper_number(part, 3);
    return paper_number(part, size >= 1e-3 ? 2 : 1);
}

void draw_heat_map(Svg& svg, const AssetData& a, const std::array<Block, 3>& blocks, double x, double y) {
    constexpr double cell = 54.0;
    svg.text({x + 3.0 * cell, y - 34.0}, "entry / scale of its block", R"(text-anchor="middle" font-size="13")");
    for (std::size_t i = 0; i < 6; ++i) {
        const double offset = (static_cast<double>(i) + 0.5) * cell;
        svg.text({x - 8.0, y + offset + 4.0}, row_names[i], R"(text-anchor="end")");
        svg.text({x + offset, y - 8.0}, row_names[i], R"(text-anchor="middle")");
        for (std::size_t j = 0; j < 6; ++j) {
            const double part = share(a.fluid_density * a.added_mass[i * 6 + j], block_at(blocks, i, j));
            const double cx = x + static_cast<double>(j) * cell, cy = y + static_cast<double>(i) * cell;
            svg.rect(cx, cy, cell, cell, "fill=\"" + heat(part) + "\" stroke=\"#ccc\" stroke-width=\"0.6\"");
            svg.text({cx + 0.5 * cell, cy + 0.5 * cell + 4.0}, cell_number(part),
                     std::string(R"(text-anchor="middle" font-size="11" fill=")") +
                         (std::abs(part) > 0.6 ? "#fff"
                          : part == 0.0        ? "#999"
                                               : "#222") +
                         "\"");
        }
    }
    for (const double at : {0.0, 3.0, 6.0}) {
        svg.line({x + at * cell, y}, {x + at * cell, y + 6.0 * cell}, R"(stroke="#222" stroke-width="1")");
        svg.line({x, y + at * cell}, {x + 6.0 * cell, y + at * cell}, R"(stroke="#222" stroke-width="1")");
    }
    const double bar = y + 6.0 * cell + 16.0, step = 6.0 * cell / 60.0;
    for (int i = 0; i < 60; ++i)
        svg.rect(x + i * step, bar, step + 0.3, 10.0, "fill=\"" + heat((i + 0.5) / 30.0 - 1.0) + "\"");
    svg.rect(x, bar, 6.0 * cell, 10.0, R"(fill="none" stroke="#222" stroke-width="0.6")");
    svg.text({x, bar + 25.0},
             "\xe2\x88\x92"
             "1",
             R"(text-anchor="middle" font-size="11")");
    svg.text({x + 3.0 * cell, bar + 25.0}, "0", R"(text-anchor="middle" font-size="11")");
    svg.text({x + 6.0 * cell, bar + 25.0}, "1", R"(text-anchor="middle" font-size="11")");
    for (std::size_t b = 0; b < 3; ++b)
        svg.text({x - 24.0, bar + 50.0 + 18.0 * static_cast<double>(b)},
                 std::string("scale of ") + blocks[b].title + ":  " + paper_number(blocks[b].scale, 4) + " " +
                     blocks[b].unit,
                 R"(fill="#333")");
}

constexpr const char* block_colors[3] = {"#1f5fa8", "#7a5195", "#b5402a"};
constexpr double bar_pitch = 22.0, block_gap = 14.0;

// Calls draw(entry, block number, x of the bar's middle) for each entry; returns the total width.
template <class Draw> double for_each_bar(const std::array<Block, 3>& blocks, const Draw& draw) {
    double x = block_gap;
    for (std::size_t b = 0; b < 3; ++b) {
        for (const Entry& e : blocks[b].entries) {
            draw(e, b, x + 0.5 * bar_pitch);
            x += bar_pitch;
        }
        x += block_gap;
    }
    return x;
}

void draw_values(Svg& svg, const AssetData& a, const std::array<Block, 3>& blocks, PlotFrame frame) {
    double low = 0.0, high = 1.02;
    const auto value = [&](const Entry& e, std::size_t b) {
        return share(a.fluid_density * a.added_mass[e.row * 6 + e.column], blocks[b]);
    };
    const auto error = [&](const Entry& e, std::size_t b) {
        return share(a.fluid_density * a.added_mass_error[e.row * 6 + e.column], blocks[b]);
    };
    for_each_bar(blocks, [&](const Entry& e, std::size_t b, double) {
        low = std::min(low, std::max(value(e, b) - error(e, b), -2.0));
        high = std::max(high, std::min(value(e, b) + error(e, b), 2.0));
    });
    frame.vertical = Axis::linear(low, high, 6);
    frame.draw(svg, false);
    frame.draw_title(svg, "entry / scale, with estimated error");
    const double zero = frame.at(0.0, 0.0).y;
    for_each_bar(blocks, [&](const Entry& e, std::size_t b, double x) {
        const double at = frame.x + x, v = frame.at(0.0, value(e, b)).y;
        svg.rect(at - 7.0, std::min(v, zero), 14.0, std::abs(v - zero),
                 std::string("fill=\"") + block_colors[b] + "\" fill-opacity=\"0.55\"");
        if (!(error(e, b) > 0.0)) return;
        const double top = frame.at(0.0, value(e, b) + error(e, b)).y, end = frame.at(0.0, value(e, b) - error(e, b)).y;
        svg.line({at, top}, {at, end}, R"(stroke="#111" stroke-width="1.2")");
        for (const double y : {top, end}) svg.line({at - 4.0, y}, {at + 4.0, y}, R"(stroke="#111" stroke-width="1.2")");
    });
    svg.line({frame.x, zero}, {frame.x + frame.width, zero}, R"(stroke="#222" stroke-width="0.8")");
}

void draw_errors(Svg& svg, const AssetData& a, const std::array<Block, 3>& blocks, PlotFrame frame) {
    double low = 1.0, high = 0.0;
    const auto error = [&](const Entry& e, std::size_t b) {
        return share(a.fluid_density * a.added_mass_error[e.row * 6 + e.column], blocks[b]);
    };
    for_each_bar(blocks, [&](const Entry& e, std::size_t b, double) {
        if (!(error(e, b) > 0.0)) return;
        low = std::min(low, error(e, b));
        high = std::max(high, error(e, b));
    });
    const bool any = high > 0.0;
    // The axis covers at most four decades; smaller values are drawn at its lower end.
    frame.vertical = any ? Axis::logarithmic(std::max(low, 1e-4 * high), high) : Axis();
    frame.draw(svg, false);
    frame.draw_title(svg, "estimated error / scale");
    if (!any)
        svg.text({frame.x + 0.5 * frame.width, frame.y + 0.5 * frame.height + 4.0}, "none: closed forms",
                 R"(text-anchor="middle" fill="#444")");
    for_each_bar(blocks, [&](const Entry& e, std::size_t b, double x) {
        const double at = frame.x + x, floor = frame.y + frame.height;
        svg.text({at, floor + 16.0}, std::string(axis_names[e.row % 3]) + axis_names[e.column % 3],
                 R"(text-anchor="middle" font-size="11")");
        if (!(error(e, b) > 0.0)) return;
        const double y = frame.at(0.0, error(e, b)).y;
        svg.line({at, floor}, {at, y}, std::string("stroke-width=\"1.6\" stroke=\"") + block_colors[b] + "\"");
        svg.circle({at, y}, 3.6, std::string("fill=\"") + block_colors[b] + "\"");
    });
    double x = frame.x + block_gap;
    for (std::size_t b = 0; b < 3; ++b) {
        const double width = bar_pitch * static_cast<double>(blocks[b].entries.size());
        svg.line({x, frame.y + frame.height + 24.0}, {x + width, frame.y + frame.height + 24.0},
                 std::string("stroke-width=\"1.5\" stroke=\"") + block_colors[b] + "\"");
        svg.text({x + 0.5 * width, frame.y + frame.height + 40.0}, blocks[b].title,
                 std::string(R"(text-anchor="middle" fill=")") + block_colors[b] + "\"");
        x += width + block_gap;
    }
}
} // namespace

std::string plot_entries(const AssetData& a) {
    const std::array<Block, 3> blocks = blocks_of(a);
    const double bars = for_each_bar(blocks, [](const Entry&, std::size_t, double) {});
    constexpr double left = 60.0, map_top = 112.0, bars_left = 496.0;
    Svg svg(bars_left + bars + 28.0, 588.0, "Added mass of " + a.name, plot_description(a));
    svg.text({left - 24.0, 30.0}, "Added mass of " + shortened(a.name, 64), R"(font-size="17" font-weight="bold")");
    svg.text({left - 24.0, 50.0},
             "6\xc3\x97"
             "6 matrix about the centre of mass, in a fluid of " +
                 paper_number(a.fluid_density, 3) + " kg/m\xc2\xb3; axes of the mesh",
             R"(fill="#444")");
    draw_heat_map(svg, a, blocks, left, map_top);
    PlotFrame frame;
    frame.x = bars_left;
    frame.width = bars;
    frame.y = 78.0;
    frame.height = 240.0;
    frame.horizontal = Axis();
    draw_values(svg, a, blocks, frame);
    frame.y = 338.0;
    frame.height = 176.0;
    draw_errors(svg, a, blocks, frame);
    return svg.finish();
}
} // namespace lr::baker
