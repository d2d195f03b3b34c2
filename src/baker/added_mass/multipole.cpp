#include "baker/added_mass/multipole.h"

#include "baker/parallel_for.h"

#include <algorithm>

namespace lr::baker {

void scale_degrees(double ratio, double* expansion) {
    double factor = 1.0;
    for (std::size_t l = 0; l <= expansion_order; ++l, factor *= ratio) {
        const std::size_t begin = 2 * term(l, 0) * mode_lanes, end = 2 * term(l + 1, 0) * mode_lanes;
        for (std::size_t i = begin; i < end; ++i) expansion[i] *= factor;
    }
}

void evaluate_far(const ClusterTree& tree, unsigned threads, std::size_t order, Expansions& multipoles,
                  Expansions& locals) {
    const auto multipole = [&](auto cluster) {
        return &multipoles[static_cast<std::size_t>(cluster) * expansion_size];
    };
    const auto local = [&](auto cluster) { return &locals[static_cast<std::size_t>(cluster) * expansion_size]; };
    const auto offset = [&](uint32_t from, uint32_t to) {
        return Eigen::Vector3d(tree.clusters[to].centre - tree.clusters[from].centre);
    };
    for (std::size_t level = tree.levels.size(); level-- > 0;) {
        const std::vector<uint32_t>& here = tree.levels[level];
        parallel_for(here.size(), threads, [&](std::size_t i, unsigned) {
            const Cluster& cluster = tree.clusters[here[i]];
            if (cluster.is_leaf()) return;
            std::fill_n(multipole(here[i]), expansion_size, 0.0);
            for (const int32_t child : {cluster.first_child, cluster.second_child})
                shift_multipole(multipole(child), offset(here[i], static_cast<uint32_t>(child)).data(), order,
                                multipole(here[i]));
        });
    }
    locals.assign(tree.clusters.size() * expansion_size, 0.0);
    parallel_for(tree.clusters.size(), threads, [&](std::size_t i, unsigned) {
        const auto target = static_cast<uint32_t>(i);
        for (std::size_t k = tree.far_start[i]; k < tree.far_start[i + 1]; ++k)
            add_multipole(multipole(tree.far[k]), offset(tree.far[k], target).data(), order, local(target));
        double factor = 2.0;
        for (std::size_t l = 0; l <= expansion_order; ++l, factor = -factor)
            for (std::size_t at = 2 * term(l, 0) * mode_lanes; at < 2 * term(l + 1, 0) * mode_lanes; ++at)
                local(target)[at] *= factor;
    });
    for (const std::vector<uint32_t>& here : tree.levels)
        parallel_for(here.size(), threads, [&](std::size_t i, unsigned) {
            const int32_t parent = tree.clusters[here[i]].parent;
            if (parent < 0) return;
            const auto from = static_cast<uint32_t>(parent);
            shift_local(local(from), offset(from, here[i]).data(), order, local(here[i]));
        });
}

Harmonics regular_harmonics(const Eigen::Vector3d& place) {
    Harmonics r;
    const std::complex<double> xy(place[0], place[1]);
    const double z = place[2], square = place.squaredNorm();
    r[0] = 1.0;
    for (std::size_t m = 0; m <= expansion_order; ++m) {
        if (m > 0) {
            const std::complex<double> before = 0.5 / static_cast<double>(m) * r[term(m - 1, m - 1)];
            r[term(m, m)] = {xy.real() * before.real() - xy.imag() * before.imag(),
                             xy.real() * before.imag() + xy.imag() * before.real()};
        }
        for (std::size_t l = m; l < expansion_order; ++l) {
            const auto n = static_cast<double>(l + 1);
            const double f = 1.0 / (n * n - static_cast<double>(m * m));
            r[term(l + 1, m)] = f * (2.0 * n - 1.0) * z * r[term(l, m)];
            if (l > m) r[term(l + 1, m)] -= f * square * r[term(l - 1, m)];
        }
    }
    return r;
}

// d/dz R_l^m = R_(l-1)^m, (d/dx - i d/dy) R_l^m = R_(l-1)^(m-1), (d/dx + i d/dy) R_l^m = -R_(l-1)^(m+1).
Harmonics normal_derivatives(const Harmonics& r, const Eigen::Vector3d& normal) {
    Harmonics out;
    out[0] = 0.0;
    const double x = 0.5 * normal[0], y = 0.5 * normal[1], z = normal[2];
    for (std::size_t l = 1; l <= expansion_order; ++l)
        for (std::size_t m = 0; m <= l; ++m) {
            std::complex<double> below = 0.0, above = 0.0, same = 0.0;
            if (m > 0) below = r[term(l - 1, m - 1)];
            if (m == 0 && l > 1) below = -std::conj(r[term(l - 1, 1)]);
            if (m + 1 < l) above = r[term(l - 1, m + 1)];
            if (m < l) same = r[term(l - 1, m)];
            // z same + (x + i y) below - (x - i y) above
            out[term(l, m)] = {z * same.real() + x * (below.real() - above.real()) - y * (below.imag() + above.imag()),
                               z * same.imag() + x * (below.imag() - above.imag()) + y * (below.real() + above.real())};
        }
    return out;
}
} // namespace lr::baker
