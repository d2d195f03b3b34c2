#include "baker/turbulence/pressure_multigrid.h"

#include <algorithm>
#include <cmath>

namespace lr::baker {
namespace {

constexpr uint32_t none = 0xffffffffu;
constexpr size_t coarsest_size = 200;
// An axis is not coarsened while its cells are longer than this times the shortest, because smoothing leaves errors along its weak links.
constexpr double long_cell = 1.5;
// Part of the spectrum of D^-1 A, which ends at 2 or below, that Chebyshev smoothing damps.
constexpr float smoothed_from = 0.4f, smoothed_to = 2.0f;
constexpr int smoothing_steps = 2;
} // namespace

PressureMultigrid::PressureMultigrid(const std::array<uint32_t, 3>& cells, const std::array<double, 3>& spacing,
                                     const double* diagonal, const std::array<const double*, 3>& links) {
    const size_t count = static_cast<size_t>(cells[0]) * cells[1] * cells[2];
    const size_t stride[3] = {1, cells[0], static_cast<size_t>(cells[0]) * cells[1]};
    Level finest;
    node_of_cell_.assign(count, none);
    for (size_t c = 0; c < count; ++c) {
        if (!(diagonal[c] > 0.0)) continue;
        node_of_cell_[c] = static_cast<uint32_t>(finest.diagonal.size());
        finest.diagonal.push_back(static_cast<float>(diagonal[c]));
        finest.block.push_back({static_cast<uint16_t>(c % cells[0]), static_cast<uint16_t>(c / stride[1] % cells[1]),
                                static_cast<uint16_t>(c / stride[2])});
    }
    finest.begin.push_back(0);
    for (size_t c = 0; c < count; ++c) {
        if (node_of_cell_[c] == none) continue;
        const auto add = [&](size_t other, double link) {
            if (!(link > 0.0)) return;
            finest.column.push_back(node_of_cell_[other]);
            finest.link.push_back(static_cast<float>(link));
        };
        for (size_t a = 3; a-- > 0;)
            if (c >= stride[a]) add(c - stride[a], links[a][c - stride[a]]);
        for (size_t a = 0; a < 3; ++a)
            if (c + stride[a] < count) add(c + stride[a], links[a][c]);
        finest.begin.push_back(static_cast<uint32_t>(finest.column.size()));
    }
    levels_.push_back(std::move(finest));

    std::array<double, 3> size = spacing;
    std::array<uint32_t, 3> blocks = cells;
    while (levels_.back().size() > coarsest_size) {
        double shortest = 1e300;
        for (size_t a = 0; a < 3; ++a)
            if (blocks[a] > 1) shortest = std::min(shortest, size[a]);
        std::array<bool, 3> halved{};
        bool any = false;
        for (size_t a = 0; a < 3; ++a) {
            halved[a] = blocks[a] > 1 && size[a] <= long_cell * shortest;
            any = any || halved[a];
            if (!halved[a]) continue;
            size[a] *= 2.0;
            blocks[a] = (blocks[a] + 1) / 2;
        }
        if (!any) break;
        Level coarse = coarsen(levels_.back(), halved);
        levels_.push_back(std::move(coarse));
    }
    for (Level& level : levels_) {
        level.inverse.resize(level.size());
        for (size_t n = 0; n < level.size(); ++n) level.inverse[n] = 1.0f / level.diagonal[n];
        for (std::vector<float>* v : {&level.x, &level.right, &level.residual, &level.direction, &level.saved})
            v->assign(level.size(), 0.0f);
    }
    factorise_coarsest();
}

PressureMultigrid::Level PressureMultigrid::coarsen(Level& fine, const std::array<bool, 3>& halved) {
    Level coarse;
    fine.parent.assign(fine.size(), none);
    const auto block_of = [&](size_t n) {
        std::array<uint16_t, 3> b = fine.block[n];
        for (size_t a = 0; a < 3; ++a)
            if (halved[a]) b[a] = static_cast<uint16_t>(b[a] >> 1);
        return b;
    };
    std::vector<uint32_t> front;
    for (size_t n = 0; n < fine.size(); ++n) {
        if (fine.parent[n] != none) continue;
        const auto part = static_cast<uint32_t>(coarse.block.size());
        coarse.block.push_back(block_of(n));
        fine.parent[n] = part;
        front.assign(1, static_cast<uint32_t>(n));
        while (!front.empty()) {
            const uint32_t m = front.back();
            front.pop_back();
            for (uint32_t e = fine.begin[m]; e < fine.begin[m + 1]; ++e) {
                const uint32_t other = fine.column[e];
                if (fine.parent[other] != none || block_of(other) != coarse.block[part]) continue;
                fine.parent[other] = part;
                front.push_back(other);
            }
        }
    }

    struct Link {
        uint32_t from, to;
        float weight;
    };
    std::vector<Link> links;
    coarse.diagonal.assign(coarse.block.size(), 0.0f);
    for (size_t n = 0; n < fine.size(); ++n) {
        float outside = fine.diagonal[n];
        for (uint32_t e = fine.begin[n]; e < fine.begin[n + 1]; ++e) {
            outside -= fine.link[e];
            const uint32_t from = fine.parent[n], to = fine.parent[fine.column[e]];
            if (from == to) continue;
            size_t axis = 0;
            while (axis < 2 && coarse.block[from][axis] == coarse.block[to][axis]) ++axis;
            links.push_back({from, to, (halved[axis] ? 0.5f : 1.0f) * fine.link[e]});
        }
        // The rest of the diagonal is the outflow link, across x.
        if (outside > 1e-4f * fine.diagonal[n]) coarse.diagonal[fine.parent[n]] += (halved[0] ? 0.5f : 1.0f) * outside;
    }
    std::stable_sort(links.begin(), links.end(),
                     [](const Link& a, const Link& b) { return a.from != b.from ? a.from < b.from : a.to < b.to; });
    size_t next = 0;
    coarse.begin.push_back(0);
    for (uint32_t n = 0; n < coarse.block.size(); ++n) {
        while (next < links.size() && links[next].from == n) {
            const uint32_t to = links[next].to;
            float weight = 0.0f;
            for (; next < links.size() && links[next].from == n && links[next].to == to; ++next)
                weight += links[next].weight;
            coarse.column.push_back(to);
            coarse.link.push_back(weight);
            coarse.diagonal[n] += weight;
        }
        coarse.begin.push_back(static_cast<uint32_t>(coarse.column.size()));
    }
    return coarse;
}

void PressureMultigrid::factorise_coarsest() {
    const Level& level = levels_.back();
    const size_t n = level.size();
    factor_.assign(n * n, 0.0);
    for (size_t i = 0; i < n; ++i) {
        for (uint32_t e = level.begin[i]; e < level.begin[i + 1]; ++e)
            factor_[i * n + level.column[e]] = -static_cast<double>(level.link[e]);
        factor_[i * n + i] = static_cast<double>(level.diagonal[i]) * (1.0 + 1e-6);
    }
    for (size_t i = 0; i < n; ++i)
        for (size_t j = 0; j <= i; ++j) {
            double sum = factor_[i * n + j];
            for (size_t k = 0; k < j; ++k) sum -= factor_[i * n + k] * factor_[j * n + k];
            factor_[i * n + j] = i == j ? std::sqrt(sum) : sum / factor_[j * n + j];
        }
}

void PressureMultigrid::solve_coarsest(Level& level) const {
    const size_t n = level.size();
    std::vector<double> y(n);
    for (size_t i = 0; i < n; ++i) {
        double sum = static_cast<double>(level.right[i]);
        for (size_t k = 0; k < i; ++k) sum -= factor_[i * n + k] * y[k];
        y[i] = sum / factor_[i * n + i];
    }
    for (size_t i = n; i-- > 0;) {
        double sum = y[i];
        for (size_t k = i + 1; k < n; ++k) sum -= factor_[k * n + i] * y[k];
        y[i] = sum / factor_[i * n + i];
        level.x[i] = static_cast<float>(y[i]);
    }
}

void PressureMultigrid::find_residual(Level& level) {
    for (size_t n = 0; n < level.size(); ++n) {
        float sum = level.right[n] - level.diagonal[n] * level.x[n];
        for (uint32_t e = level.begin[n]; e < level.begin[n + 1]; ++e) sum += level.link[e] * level.x[level.column[e]];
        level.residual[n] = sum;
    }
}

void PressureMultigrid::smooth(Level& level, bool from_zero) {
    constexpr float theta = 0.5f * (smoothed_to + smoothed_from), delta = 0.5f * (smoothed_to - smoothed_from);
    constexpr float sigma = theta / delta;
    float rho = 1.0f / sigma;
    for (int step = 0; step < smoothing_steps; ++step) {
        const bool first = step == 0;
        if (first && from_zero)
            std::copy(level.right.begin(), level.right.end(), level.residual.begin());
        else
            find_residual(level);
        const float next = 1.0f / (2.0f * sigma - rho);
        const float keep = first ? 0.0f : next * rho, take = first ? 1.0f / theta : 2.0f * next / delta;
        if (!first) rho = next;
        for (size_t n = 0; n < level.size(); ++n) {
            const float d = keep * (first ? 0.0f : level.direction[n]) + take * level.inverse[n] * level.residual[n];
            level.direction[n] = d;
            level.x[n] = (first && from_zero ? 0.0f : level.x[n]) + d;
        }
    }
}

void PressureMultigrid::descend(size_t depth) {
    Level& level = levels_[depth];
    if (depth + 1 == levels_.size()) {
        solve_coarsest(level);
        return;
    }
    Level& coarse = levels_[depth + 1];
    smooth(level, true);
    find_residual(level);
    std::fill(coarse.right.begin(), coarse.right.end(), 0.0f);
    for (size_t n = 0; n < level.size(); ++n) coarse.right[level.parent[n]] += level.residual[n];
    descend(depth + 1);
    if (depth + 2 < levels_.size()) { // W-cycle: once more on the residual
        coarse.saved = coarse.x;
        find_residual(coarse);
        coarse.right.swap(coarse.residual);
        descend(depth + 1);
        for (size_t n = 0; n < coarse.size(); ++n) coarse.x[n] += coarse.saved[n];
    }
    for (size_t n = 0; n < level.size(); ++n) level.x[n] += coarse.x[level.parent[n]];
    smooth(level, false);
}

void PressureMultigrid::cycle(const double* right, double* solution) {
    Level& finest = levels_.front();
    // Scaled to one, because single precision has a limited exponent.
    double largest = 0.0;
    for (size_t c = 0; c < node_of_cell_.size(); ++c) largest = std::max(largest, std::abs(right[c]));
    const double scale = largest > 0.0 ? largest : 1.0;
    for (size_t c = 0; c < node_of_cell_.size(); ++c)
        if (node_of_cell_[c] != none) finest.right[node_of_cell_[c]] = static_cast<float>(right[c] / scale);
    descend(0);
    for (size_t c = 0; c < node_of_cell_.size(); ++c)
        solution[c] = node_of_cell_[c] == none ? 0.0 : scale * static_cast<double>(finest.x[node_of_cell_[c]]);
}
} // namespace lr::baker
