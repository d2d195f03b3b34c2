#include "baker/mesh/solid_region.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace lr::baker {
namespace {

constexpr std::size_t rays = 192; // along each side, for overlaps
constexpr std::size_t trapped_cells = 48;
// Per face, in bins that hold it: a line through a stack of broad faces meets them all, however small the bins.
constexpr std::size_t most_entries = 512, fewest_bins = 16;

double wedge(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

// Least and largest coordinate p of the part of a triangle with coordinate q in [low, high]. The triangle must reach there.
std::pair<double, double> extent_in(const std::array<Eigen::Vector3d, 3>& t, Eigen::Index p, Eigen::Index q, double low,
                                    double high) {
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Vector3d &from = t[k], &to = t[(k + 1) % 3];
        double begin = 0.0, end = 1.0; // the part of the side
        const double run = to[q] - from[q];
        if (run != 0.0) {
            const auto [first, last] = std::minmax({(low - from[q]) / run, (high - from[q]) / run});
            begin = std::max(begin, first);
            end = std::min(end, last);
        }
        if (begin > end || std::max(from[q], to[q]) < low || std::min(from[q], to[q]) > high) continue;
        for (const double share : {begin, end}) {
            const double at = from[p] + share * (to[p] - from[p]);
            least = std::min(least, at);
            most = std::max(most, at);
        }
    }
    return {least, most};
}
} // namespace

SolidRegion::SolidRegion(const Mesh& mesh, const std::vector<Face>& faces) {
    low_ = Eigen::Vector3d::Constant(HUGE_VAL);
    high_ = -low_;
    for (const Face& f : faces) {
        faces_.push_back({mesh.vertices[f[0]], mesh.vertices[f[1]], mesh.vertices[f[2]]});
        for (const Eigen::Vector3d& v : faces_.back()) {
            low_ = low_.cwiseMin(v);
            high_ = high_.cwiseMax(v);
        }
        // No line crosses it; coarse surfaces have thousands.
        const auto& t = faces_.back();
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) faces_.pop_back();
    }
    if (faces_.empty()) return;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto p = static_cast<Eigen::Index>((axis + 1) % 3), q = static_cast<Eigen::Index>((axis + 2) % 3);
        std::size_t& bins = bins_[axis];
        bins = std::clamp<std::size_t>(static_cast<std::size_t>(std::sqrt(static_cast<double>(faces_.size()))), 1, 256);
        const double slack = 1e-9 * (high_ - low_).maxCoeff();
        // Calls use(first bin, last bin, face) for each row of bins that a face reaches.
        const auto visit = [&](const auto& use) {
            const double row = (high_[q] - low_[q]) / static_cast<double>(bins);
            for (std::size_t i = 0; i < faces_.size(); ++i) {
                const auto& t = faces_[i];
                const auto [q0, q1] = std::minmax({t[0][q], t[1][q], t[2][q]});
                for (std::size_t b = bin(axis, q0, q), last = bin(axis, q1, q); b <= last; ++b) {
                    // The rectangle around a slanting needle has a hundred times the bins that the needle crosses.
                    const auto [from, to] = extent_in(t, p, q, low_[q] + static_cast<double>(b) * row - slack,
                                                      low_[q] + static_cast<double>(b + 1) * row + slack);
                    use(b * bins + bin(axis, from - slack, p), b * bins + bin(axis, to + slack, p),
                        static_cast<uint32_t>(i));
                }
            }
        };
        for (;; bins /= 2) {
            std::size_t entries = 0;
            visit([&](std::size_t from, std::size_t to, uint32_t) { entries += to + 1 - std::min(from, to + 1); });
            if (entries <= most_entries * faces_.size() || bins < 2 * fewest_bins) break;
        }
        std::vector<uint32_t>& start = start_[axis];
        start.assign(bins * bins + 1, 0);
        visit([&](std::size_t from, std::size_t to, uint32_t) {
            for (std::size_t b = from; b <= to; ++b) ++start[b + 1];
        });
        for (std::size_t b = 0; b < bins * bins; ++b) start[b + 1] += start[b];
        list_[axis].resize(start.back());
        std::vector<uint32_t> next(start.begin(), start.end() - 1);
        visit([&](std::size_t from, std::size_t to, uint32_t i) {
            for (std::size_t b = from; b <= to; ++b) list_[axis][next[b]++] = i;
        });
    }
    const auto length = [&](std::size_t axis) { return list_[axis].size() / (bins_[axis] * bins_[axis]); };
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) { return length(a) < length(b); });
}

std::size_t SolidRegion::bin(std::size_t axis, double x, Eigen::Index k) const {
    const double size = high_[k] - low_[k], last = static_cast<double>(bins_[axis] - 1);
    return static_cast<std::size_t>(
        std::clamp(size > 0.0 ? (x - low_[k]) / size * static_cast<double>(bins_[axis]) : 0.0, 0.0, last));
}

void SolidRegion::cross(std::size_t axis, double p, double q, Crossings& out) const {
    out.clear();
    const auto a = static_cast<Eigen::Index>((axis + 1) % 3), b = static_cast<Eigen::Index>((axis + 2) % 3);
    const auto along = static_cast<Eigen::Index>(axis);
    if (empty() || p < low_[a] || p > high_[a] || q < low_[b] || q > high_[b]) return;
    const std::size_t cell = bin(axis, q, b) * bins_[axis] + bin(axis, p, a);
    const Eigen::Vector2d at(p, q);
    // The side of an edge on which the point lies. Ordered by the edge's ends, so that both of its faces agree on a line through it.
    const auto side = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
        const bool swap = to.x() < from.x() || (to.x() == from.x() && to.y() < from.y());
        const Eigen::Vector2d &low = swap ? to : from, &high = swap ? from : to;
        const bool left = wedge(high - low, at - low) >= 0.0;
        return left != swap;
    };
    for (uint32_t i = start_[axis][cell]; i < start_[axis][cell + 1]; ++i) {
        const auto& t = faces_[list_[axis][i]];
        const Eigen::Vector2d u(t[0][a], t[0][b]), v(t[1][a], t[1][b]), w(t[2][a], t[2][b]);
        const bool uv = side(u, v);
        if (side(v, w) != uv || side(w, u) != uv) continue;
        const double area = wedge(v - u, w - u);
        const double x = wedge(at - u, w - u), y = wedge(v - u, at - u);
        const double depth =
            area != 0.0 ? t[0][along] + (x * (t[1] - t[0])[along] + y * (t[2] - t[0])[along]) / area : t[0][along];
        out.emplace_back(depth, uv ? -1 : 1); // a normal along the line: the line leaves the region
    }
    std::sort(out.begin(), out.end());
}

bool SolidRegion::contains(const Eigen::Vector3d& point) const {
    if (empty() || (point.array() < low_.array()).any() || (point.array() > high_.array()).any()) return false;
    Crossings crossings;
    // By majority of three lines, since one may graze a face.
    int votes = 0;
    for (const std::size_t axis : order_) {
        if (axis == order_[2] && votes != 1) break;
        const auto k = static_cast<Eigen::Index>(axis);
        cross(axis, point[(k + 1) % 3], point[(k + 2) % 3], crossings);
        int winding = 0;
        for (const auto& [depth, change] : crossings)
            if (depth < point[k]) winding += change;
        votes += winding >= 1;
    }
    return votes >= 2;
}

RegionMoments SolidRegion::moments(const MassProperties& parts) const {
    RegionMoments m;
    m.counted = m.volume = parts.volume;
    m.first = parts.volume * parts.centroid;
    m.second = 0.5 * parts.inertia.trace() * Eigen::Matrix3d::Identity() - parts.inertia +
               parts.volume * parts.centroid * parts.centroid.transpose();
    Crossings crossings;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<Eigen::Index>(axis), a = (k + 1) % 3, b = (k + 2) % 3;
        const double dp = (high_[a] - low_[a]) / rays, dq = (high_[b] - low_[b]) / rays;
        for (std::size_t i = 0; i < rays; ++i)
            for (std::size_t j = 0; j < rays; ++j) {
                Eigen::Vector3d at;
                at[a] = low_[a] + (static_cast<double>(i) + 0.5) * dp;
                at[b] = low_[b] + (static_cast<double>(j) + 0.5) * dq;
                cross(axis, at[a], at[b], crossings);
                int winding = 0;
                for (std::size_t n = 0; n + 1 < crossings.size(); ++n) {
                    winding += crossings[n].second;
                    const int extra = winding - (winding >= 1 ? 1 : 0);
                    if (extra == 0) continue;
                    const double from = crossings[n].first, to = crossings[n + 1].first;
                    const double part = -extra * dp * dq * (to - from) / 3.0;
                    Eigen::Vector3d middle = at;
                    middle[k] = 0.5 * (from + to);
                    m.volume += part;
                    m.first += part * middle;
                    m.second += part * middle * middle.transpose();
                    m.second(k, k) += part * (to - from) * (to - from) / 12.0;
                }
            }
    }
    return m;
}

SolidRegion::Grid SolidRegion::grid(std::size_t longest) const {
    constexpr std::size_t samples = 4; // along each side of a cell
    Grid g;
    const Eigen::Vector3d size = high_ - low_;
    g.step = size.maxCoeff() / static_cast<double>(longest);
    std::array<std::size_t, 3> fine{};
    for (std::size_t k = 0; k < 3; ++k) {
        // Half a cell beyond the box at both ends, so that no face has space beyond the grid.
        g.cells[k] = static_cast<std::size_t>(std::ceil(size[static_cast<Eigen::Index>(k)] / g.step)) + 2;
        fine[k] = samples * g.cells[k];
    }
    g.low = 0.5 * (low_ + high_);
    for (std::size_t k = 0; k < 3; ++k)
        g.low[static_cast<Eigen::Index>(k)] -= 0.5 * g.step * static_cast<double>(g.cells[k]);
    for (auto& faces : g.inside) faces.assign(g.cells[0] * g.cells[1] * g.cells[2], 0.0F);
    const double h = g.step / samples;
    Crossings crossings;
    for (std::size_t k = 0; k < fine[2]; ++k)
        for (std::size_t j = 0; j < fine[1]; ++j) {
            cross(0, g.low[1] + (static_cast<double>(j) + 0.5) * h, g.low[2] + (static_cast<double>(k) + 0.5) * h,
                  crossings);
            if (crossings.empty()) continue;
            int winding = 0;
            std::size_t next = 0;
            for (std::size_t i = 0; i < fine[0]; ++i) {
                const double x = g.low[0] + (static_cast<double>(i) + 0.5) * h;
                while (next < crossings.size() && crossings[next].first < x) winding += crossings[next++].second;
                if (winding < 1) continue;
                const std::array<std::size_t, 3> at{i, j, k};
                for (std::size_t d = 0; d < 3; ++d) {
                    std::array<std::size_t, 3> cell{i / samples, j / samples, k / samples};
                    cell[d] = (at[d] + samples / 2) / samples;
                    if (cell[d] < g.cells[d])
                        g.inside[d][g.at(cell[0], cell[1], cell[2])] += 1.0F / (samples * samples * samples);
                }
            }
        }
    return g;
}

Eigen::Matrix3d trapped_fluid_inertia(const SolidRegion& region, const Eigen::Vector3d& centroid,
                                      const Eigen::Matrix3d& frozen) {
    const SolidRegion::Grid g = region.grid(trapped_cells);
    const std::size_t count = g.cells[0] * g.cells[1] * g.cells[2];
    const std::array<std::size_t, 3> stride{1, g.cells[0], g.cells[0] * g.cells[1]};
    struct Link {
        uint32_t low, high;
        double weight;
        Eigen::Vector3d wall; // velocity of the walls along the link, for a spin about each axis
    };
    std::vector<Link> links;
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(count));
    for (std::size_t k = 0; k < g.cells[2]; ++k)
        for (std::size_t j = 0; j < g.cells[1]; ++j)
            for (std::size_t i = 0; i < g.cells[0]; ++i)
                for (std::size_t d = 0; d < 3; ++d) {
                    const std::array<std::size_t, 3> at{i, j, k};
                    const std::size_t cell = g.at(i, j, k);
                    const auto weight = static_cast<double>(g.inside[d][cell]);
                    if (!(weight > 0.0) || at[d] == 0) continue;
                    Eigen::Vector3d middle(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
                    middle +=
                        Eigen::Vector3d::Constant(0.5) - 0.5 * Eigen::Vector3d::Unit(static_cast<Eigen::Index>(d));
                    const Eigen::Vector3d arm = g.low + g.step * middle - centroid;
                    // (e_m x arm) . e_d = e_m . (arm x e_d)
                    links.push_back({static_cast<uint32_t>(cell - stride[d]), static_cast<uint32_t>(cell), weight,
                                     arm.cross(Eigen::Vector3d::Unit(static_cast<Eigen::Index>(d)))});
                    diagonal[static_cast<Eigen::Index>(links.back().low)] += weight;
                    diagonal[static_cast<Eigen::Index>(links.back().high)] += weight;
                }
    const auto multiply = [&](const Eigen::VectorXd& x) {
        Eigen::VectorXd y = Eigen::VectorXd::Zero(x.size());
        for (const Link& l : links) {
            const double flow = l.weight * (x[l.high] - x[l.low]);
            y[l.high] += flow;
            y[l.low] -= flow;
        }
        return y;
    };
    const Eigen::VectorXd scale = diagonal.unaryExpr([](double x) { return x > 0.0 ? 1.0 / x : 0.0; });
    Eigen::Matrix3d energy = Eigen::Matrix3d::Zero();
    for (Eigen::Index m = 0; m < 3; ++m) {
        Eigen::VectorXd rest = Eigen::VectorXd::Zero(diagonal.size()), x = rest;
        for (const Link& l : links) {
            rest[l.high] += l.weight * l.wall[m];
            rest[l.low] -= l.weight * l.wall[m];
        }
        Eigen::VectorXd scaled = scale.cwiseProduct(rest), direction = scaled;
        double product = rest.dot(scaled);
        const double enough = 1e-10 * product;
        for (int round = 0; round < 1000 && product > enough; ++round) {
            const Eigen::VectorXd image = multiply(direction);
            const double curvature = direction.dot(image);
            if (!(curvature > 0.0)) break;
            x += product / curvature * direction;
            rest -= product / curvature * image;
            scaled = scale.cwiseProduct(rest);
            const double now = rest.dot(scaled);
            direction = scaled + now / product * direction;
            product = now;
        }
        for (const Link& l : links) energy.col(m) += l.weight * (x[l.high] - x[l.low]) * l.wall;
    }
    Eigen::Vector3d on_grid = Eigen::Vector3d::Zero();
    for (const Link& l : links) on_grid += l.weight * l.wall.cwiseAbs2();
    on_grid *= std::pow(g.step, 3);
    const Eigen::Vector3d scale_of = (frozen.diagonal().cwiseMax(0.0).array() / on_grid.array().max(1e-300)).sqrt();
    const Eigen::Matrix3d inertia = 0.5 * std::pow(g.step, 3) * (energy + energy.transpose());
    return scale_of.asDiagonal() * inertia * scale_of.asDiagonal();
}
} // namespace lr::baker
