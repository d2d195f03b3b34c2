#include "baker/added_mass/cluster_tree.h"
#include "baker/added_mass/fast_double_layer.h"
#include "baker/added_mass/multipole.h"
#include "baker/added_mass/near_panels.h"
#include "baker/parallel_for.h"
#include "mesh_shapes.h"

#include <doctest/doctest.h>

#include <atomic>
#include <set>
#include <stdexcept>

using namespace lr;
using namespace lr::baker;
using Vec = Eigen::Vector3d;

namespace {

// Pseudo-random in [-1, 1].
class Noise {
public:
    double next() {
        state_ = state_ * 6364136223846793005U + 1442695040888963407U;
        return static_cast<double>(state_ >> 11) * 0x1p-52 - 1.0;
    }
    Vec point() {
        const double x = next(), y = next(), z = next();
        return {x, y, z};
    }

private:
    uint64_t state_ = 12345;
};

struct Charges {
    std::vector<Vec> place;
    std::vector<double> charge;
};

Charges some_charges(Noise& noise, const Vec& centre, double radius) {
    Charges charges;
    for (int i = 0; i < 30; ++i) {
        Vec p = noise.point();
        while (p.norm() > 1.0) p = noise.point();
        charges.place.emplace_back(centre + radius * p);
        charges.charge.push_back(noise.next());
    }
    return charges;
}

double potential(const Charges& charges, const Vec& x) {
    double sum = 0.0;
    for (std::size_t i = 0; i < charges.place.size(); ++i) sum += charges.charge[i] / (x - charges.place[i]).norm();
    return sum;
}

// All charges in mode 2.
std::vector<double> multipole_of(const Charges& charges, const Vec& centre) {
    std::vector<double> m(expansion_size, 0.0);
    for (std::size_t i = 0; i < charges.place.size(); ++i) {
        const Harmonics r = regular_harmonics(charges.place[i] - centre);
        for (std::size_t l = 0; l <= expansion_order; ++l)
            for (std::size_t k = 0; k <= l; ++k) {
                const double half = k == 0 ? 0.5 : 1.0;
                m[2 * term(l, k) * mode_lanes + 2] += half * charges.charge[i] * r[term(l, k)].real();
                m[(2 * term(l, k) + 1) * mode_lanes + 2] += half * charges.charge[i] * r[term(l, k)].imag();
            }
    }
    return m;
}

double evaluate(const std::vector<double>& local, const Harmonics& r) {
    double sum = 0.0;
    for (std::size_t l = 0; l <= expansion_order; ++l)
        for (std::size_t k = 0; k <= l; ++k) {
            const double half = k == 0 ? 0.5 : 1.0, *at = &local[2 * term(l, k) * mode_lanes + 2];
            sum += half * (r[term(l, k)].real() * at[0] + r[term(l, k)].imag() * at[mode_lanes]);
        }
    return sum;
}

void finish_local(std::vector<double>& local) {
    for (std::size_t l = 0; l <= expansion_order; ++l)
        for (std::size_t i = 2 * term(l, 0) * mode_lanes; i < 2 * term(l + 1, 0) * mode_lanes; ++i)
            local[i] *= l % 2 ? -2.0 : 2.0;
}

} // namespace

TEST_CASE("expansions: potential and gradient of far charges, better with each degree") {
    Noise noise;
    const Vec child(0.1, -0.2, 0.15), parent(0.25, 0.05, -0.1), far_parent(2.0, -1.5, 1.2), far_child(2.2, -1.3, 1.1);
    const Charges charges = some_charges(noise, child, 0.2);
    double last = 1.0;
    for (const std::size_t order : {2U, 4U, 6U, 8U}) {
        const std::vector<double> m = multipole_of(charges, child);
        std::vector<double> up(expansion_size, 0.0), across(expansion_size, 0.0), down(expansion_size, 0.0);
        shift_multipole(m.data(), Vec(child - parent).data(), order, up.data());
        add_multipole(up.data(), Vec(far_parent - parent).data(), order, across.data());
        finish_local(across);
        shift_local(across.data(), Vec(far_child - far_parent).data(), order, down.data());
        double worst = 0.0;
        for (int i = 0; i < 20; ++i) {
            const Vec x = far_child + 0.2 * noise.point();
            const Harmonics r = regular_harmonics(x - far_child);
            worst = std::max(worst, std::abs(evaluate(down, r) - potential(charges, x)));
            const Vec n = noise.point();
            const double step = 1e-4;
            const double slope = (potential(charges, x + step * n) - potential(charges, x - step * n)) / (2.0 * step);
            if (order == 8) CHECK(evaluate(down, normal_derivatives(r, n)) == doctest::Approx(slope).epsilon(2e-4));
        }
        CHECK(worst < 0.2 * last);
        last = worst;
    }
    CHECK(last < 2e-6);
}

TEST_CASE("expansions: shifts of multipoles are exact, shifts of locals their transpose") {
    Noise noise;
    const Vec child(0.3, 0.1, -0.2), parent(-0.1, 0.2, 0.1);
    const Charges charges = some_charges(noise, child, 0.5);
    const std::vector<double> direct = multipole_of(charges, parent), from = multipole_of(charges, child);
    std::vector<double> shifted(expansion_size, 0.0);
    shift_multipole(from.data(), Vec(child - parent).data(), expansion_order, shifted.data());
    std::vector<double> local(expansion_size, 0.0), lowered(expansion_size, 0.0);
    for (std::size_t i = 2; i < expansion_size; i += mode_lanes) {
        CHECK(shifted[i] == doctest::Approx(direct[i]).epsilon(1e-11));
        local[i] = noise.next();
    }
    shift_local(local.data(), Vec(child - parent).data(), expansion_order, lowered.data());
    double a = 0.0, b = 0.0;
    for (std::size_t i = 2; i < expansion_size; i += mode_lanes) {
        a += local[i] * shifted[i];
        b += lowered[i] * from[i];
    }
    CHECK(a == doctest::Approx(b).epsilon(1e-12));
}

TEST_CASE("blocks of any size times modes, and transposed") {
    Noise noise;
    for (const std::size_t rows : {1U, 3U, 8U, 13U})
        for (const std::size_t columns : {1U, 4U, 17U}) {
            std::vector<float> block(rows * columns);
            for (float& w : block) w = static_cast<float>(noise.next());
            std::vector<double> x(columns * mode_lanes), y(rows * mode_lanes, 1.0), scratch(rows * columns);
            std::vector<double> u(rows * mode_lanes), v(columns * mode_lanes, -1.0);
            for (double& value : x) value = noise.next();
            for (double& value : u) value = noise.next();
            multiply_block(block.data(), rows, columns, x.data(), y.data(), scratch.data());
            multiply_transposed(block.data(), rows, columns, u.data(), v.data(), scratch.data());
            for (std::size_t m = 0; m < mode_lanes; ++m) {
                for (std::size_t i = 0; i < rows; ++i) {
                    double sum = 1.0;
                    for (std::size_t j = 0; j < columns; ++j)
                        sum += static_cast<double>(block[i * columns + j]) * x[j * mode_lanes + m];
                    CHECK(y[i * mode_lanes + m] == doctest::Approx(sum).epsilon(1e-13));
                }
                for (std::size_t j = 0; j < columns; ++j) {
                    double sum = -1.0;
                    for (std::size_t i = 0; i < rows; ++i)
                        sum += static_cast<double>(block[i * columns + j]) * u[i * mode_lanes + m];
                    CHECK(v[j * mode_lanes + m] == doctest::Approx(sum).epsilon(1e-13));
                }
            }
        }
}

TEST_CASE("clusters: every pair of items once, far ones apart, also where some items reach far") {
    Noise noise;
    ClusterItems items;
    items.start.push_back(0);
    for (int i = 0; i < 400; ++i) {
        const Vec p(noise.next(), noise.next(), 0.05 * noise.next());
        items.position.push_back(p);
        items.support.emplace_back(p + (i % 50 == 0 ? 1.0 : 0.02) * noise.point());
        items.start.push_back(items.support.size());
    }
    items.position.push_back(items.position.front()); // twice the same place
    items.support.push_back(items.support.front());
    items.start.push_back(items.support.size());
    ClusterTree tree = build_cluster_tree(items, 12);
    find_cluster_pairs(tree, 0.6);

    const std::size_t n = items.position.size();
    std::vector<uint32_t> sorted = tree.order;
    std::sort(sorted.begin(), sorted.end());
    for (uint32_t i = 0; i < n; ++i) CHECK(sorted[i] == i);
    std::vector<int> seen(n * n, 0);
    const auto mark = [&](const Cluster& a, const Cluster& b) {
        for (uint32_t i = a.begin; i < a.end; ++i)
            for (uint32_t j = b.begin; j < b.end; ++j) ++seen[tree.order[i] * n + tree.order[j]];
    };
    std::size_t far = 0;
    for (std::size_t i = 0; i < tree.clusters.size(); ++i) {
        const Cluster& a = tree.clusters[i];
        if (a.is_leaf()) CHECK(a.end - a.begin <= 12);
        for (uint32_t k = a.begin; k < a.end; ++k) {
            const uint32_t item = tree.order[k];
            CHECK((items.position[item] - a.centre).norm() <= a.radius * (1.0 + 1e-12));
            CHECK((items.support[item] - a.centre).norm() <= a.radius * (1.0 + 1e-12));
        }
        for (std::size_t k = tree.far_start[i]; k < tree.far_start[i + 1]; ++k, ++far) {
            const Cluster& b = tree.clusters[tree.far[k]];
            CHECK(a.radius + b.radius <= 0.6 * (a.centre - b.centre).norm() * (1.0 + 1e-12));
            mark(a, b);
        }
    }
    for (const ClusterPair& pair : tree.near) {
        mark(tree.clusters[pair.first], tree.clusters[pair.second]);
        if (pair.first != pair.second) mark(tree.clusters[pair.second], tree.clusters[pair.first]);
    }
    CHECK(far > 0);
    CHECK(std::all_of(seen.begin(), seen.end(), [](int count) { return count == 1; }));
    CHECK(build_cluster_tree({}, 12).clusters.empty());
}

TEST_CASE("near panels are those that a search of all pairs finds, on graded panels too") {
    const Mesh mesh = test::box({1.0, 1.0, 0.02}, {14, 5, 2}, 1.0);
    std::vector<Panel> panels;
    for (const Face& f : mesh.faces)
        panels.push_back(make_panel(mesh.vertices[f[0]], mesh.vertices[f[1]], mesh.vertices[f[2]]));
    std::vector<std::vector<NearPair>> pairs;
    std::vector<std::size_t> level;
    REQUIRE(find_near_panels(panels, 1000000, pairs, level));
    std::size_t found = 0;
    for (uint32_t s = 0; s < panels.size(); ++s) {
        std::vector<uint32_t> near, listed;
        double smallest = panels[s].radius;
        for (uint32_t t = 0; t < panels.size(); ++t) {
            const double reach = panels[s].radius + panels[t].radius;
            const double distance = (panels[s].centroid - panels[t].centroid).norm();
            if (t != s && distance <= 1.5 * reach) near.push_back(t);
            if (t != s && distance < reach) smallest = std::min(smallest, panels[t].radius);
        }
        for (const NearPair& pair : pairs[s]) {
            listed.push_back(pair.panel);
            CHECK(pair.touching == ((panels[s].centroid - panels[pair.panel].centroid).squaredNorm() <
                                    std::pow(panels[s].radius + panels[pair.panel].radius, 2)));
        }
        CHECK(listed == near);
        const double ratio = panels[s].radius / smallest;
        CHECK(level[s] == (ratio > 3.0 ? 2U : ratio > 1.5 ? 1U : 0U));
        found += listed.size();
    }
    CHECK_FALSE(find_near_panels(panels, found / 4, pairs, level));
}

TEST_CASE("sums of doublets: expansions against all pairs, same bits for any number of threads") {
    const Mesh mesh = test::ellipsoid(2, 1, 0.3, 4);
    const std::size_t n = mesh.vertices.size(), padded = (n + near_batch - 1) / near_batch * near_batch;
    Noise noise;
    DoubletArrays all;
    for (std::size_t k = 0; k < 3; ++k) {
        all.position[k].assign(padded, 0.0);
        all.normal[k].assign(padded, 0.0);
    }
    for (std::size_t m = 0; m < 6; ++m) {
        all.moment[m].assign(padded, 0.0);
        all.sum[m].assign(padded, 0.0);
    }
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            all.position[k][i] = mesh.vertices[i][static_cast<Eigen::Index>(k)];
            all.normal[k][i] = noise.next();
        }
        for (std::size_t m = 0; m < 6; ++m) all.moment[m][i] = noise.next();
    }
    DoubletArrays fast = all, threaded = all;
    sum_doublets(all, 0, padded);
    sum_doublets_fast(fast, n, 1, [](double) {});
    sum_doublets_fast(threaded, n, 3, [](double) {});
    for (std::size_t m = 0; m < 6; ++m) {
        double error = 0.0, square = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
            error += std::pow(fast.sum[m][i] - all.sum[m][i], 2);
            square += std::pow(all.sum[m][i], 2);
        }
        CHECK(std::sqrt(error / square) < 5e-6);
        CHECK(fast.sum[m] == threaded.sum[m]);
    }
}

TEST_CASE("work on threads: each index once, exceptions come through, more threads than work") {
    std::vector<std::atomic<int>> calls(1000);
    parallel_for(calls.size(), 4, [&](std::size_t i, unsigned thread) {
        CHECK(thread < 4);
        ++calls[i];
    });
    CHECK(std::all_of(calls.begin(), calls.end(), [](const std::atomic<int>& n) { return n == 1; }));
    std::atomic<int> sum{0};
    parallel_for(2, 8, [&](std::size_t i, unsigned) { sum += static_cast<int>(i) + 1; });
    CHECK(sum == 3);
    parallel_for(0, 3, [&](std::size_t, unsigned) { sum = 0; });
    CHECK(sum == 3);
    CHECK_THROWS_AS(parallel_for(100, 3,
                                 [](std::size_t i, unsigned) {
                                     if (i == 57) throw std::runtime_error("57");
                                 }),
                    std::runtime_error);
    CHECK(thread_count(0) >= 1);
    CHECK(thread_count(5) == 5);
}
