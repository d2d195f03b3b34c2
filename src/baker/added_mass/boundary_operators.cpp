#include "baker/added_mass/boundary_operators.h"

#include "baker/added_mass/fast_double_layer.h"
#include "baker/added_mass/near_panels.h"
#include "baker/added_mass/panel_kernels.h"
#include "baker/mesh/half_edges.h"
#include "baker/parallel_for.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numbers>
#include <numeric>

namespace lr::baker {
namespace {

constexpr double four_pi = 4.0 * std::numbers::pi;

using Mode = Eigen::Matrix<double, 6, 1>;

void add_to_unknowns(RigidModes& sums, const CornerUnknowns& corner, const Mode& value) {
    if (corner.plus >= 0) sums.row(corner.plus) += value.transpose();
    if (corner.minus >= 0) sums.row(corner.minus) -= value.transpose();
}

Mode normal_velocity(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
    Mode q;
    q << normal, point.cross(normal);
    return q;
}

class Assembler {
public:
    Assembler(const Mesh& mesh, const SurfaceBasis& basis, const std::function<void(double)>& progress,
              BoundaryOperators& out)
        : mesh_(mesh), basis_(basis), progress_(progress), out_(out), near_(mesh.faces.size()) {}

    void run(const NearLimits& limits) {
        if (assemble_right_side(sum_all_doublets, 1, limits)) assemble_hypersingular();
    }

    bool run_fast(unsigned threads, const NearLimits& limits, NearSingleLayer& near) {
        const auto sum_fast = [&](DoubletArrays& arrays, std::size_t count, const auto& progress) {
            sum_doublets_fast(arrays, count, threads, progress);
        };
        if (!assemble_right_side(sum_fast, threads, limits)) return false;
        near.start.assign(1, 0);
        for (std::size_t t = 0; t < near_.size(); ++t) {
            for (const NearPair& pair : near_[t]) {
                const std::vector<NearPair>& back = near_[pair.panel];
                const auto mirror = std::lower_bound(back.begin(), back.end(), t,
                                                     [](const NearPair& a, std::size_t b) { return a.panel < b; });
                near.panel.push_back(pair.panel);
                near.value.push_back(near_single_layer(t, pair, *mirror) / four_pi);
            }
            near.start.push_back(near.panel.size());
        }
        return true;
    }

private:
    using SumDoublets = std::function<void(DoubletArrays&, std::size_t, const std::function<void(double)>&)>;

    static void sum_all_doublets(DoubletArrays& arrays, std::size_t, const std::function<void(double)>& progress) {
        constexpr std::size_t stride = 256;
        const std::size_t padded = arrays.position[0].size();
        for (std::size_t e = 0; e < padded; e += stride) {
            sum_doublets(arrays, e, std::min(e + stride, padded));
            progress(static_cast<double>(e) / static_cast<double>(padded));
        }
    }

    bool assemble_right_side(const SumDoublets& sum_doublets, unsigned threads, const NearLimits& limits) {
        const auto unknowns = static_cast<Eigen::Index>(basis_.unknowns);
        for (const Face& f : mesh_.faces)
            out_.panels.push_back(make_panel(mesh_.vertices[f[0]], mesh_.vertices[f[1]], mesh_.vertices[f[2]]));
        for (const Panel& panel : out_.panels) out_.self.push_back(self_interaction(panel) / four_pi);
        out_.moments = RigidModes::Zero(unknowns, 6);
        out_.right_side = RigidModes::Zero(unknowns, 6);
        if (!find_near_panels(out_.panels, limits.pairs, near_, level_)) return false;
        // The single layer is integrated over the smaller of two panels; the double layer, for all neighbours at once.
        if (basis_.sheet) level_.assign(level_.size(), 0);
        if (near_points() > limits.points) return false;
        find_edges();
        if (!basis_.sheet) add_far_double_layer(sum_doublets);
        for (const Panel& panel : out_.panels) fields_.push_back(near_fields(panel));
        integrate_all_near(threads);
        if (basis_.sheet)
            out_.right_side = -out_.moments;
        else
            out_.right_side -= 0.5 * out_.moments;
        return true;
    }

    // The quadrature rule with nodes at the edge midpoints is exact to degree 2, and neighbours share its nodes.
    void find_edges() {
        const std::vector<HalfEdge> halves = sorted_half_edges(mesh_);
        panel_edges_.resize(mesh_.faces.size());
        for (std::size_t i = 0; i < halves.size(); ++i) {
            const HalfEdge& half = halves[i];
            const bool fresh = i == 0 || !same_edge(half, halves[i - 1]);
            if (fresh) {
                edges_.push_back({half.low, half.high});
                middle_.push_back(0.5 * (mesh_.vertices[half.low] + mesh_.vertices[half.high]));
            }
            panel_edges_[half.face][half.side] = static_cast<uint32_t>(edges_.size() - 1);
        }
    }

    // Sums over all pairs of edge midpoints, also of near panels; integrate_near subtracts the near pairs.
    void add_far_double_layer(const SumDoublets& sum_doublets) {
        const std::size_t n = edges_.size(), padded = (n + near_batch - 1) / near_batch * near_batch;
        DoubletArrays arrays;
        for (std::size_t k = 0; k < 3; ++k) {
            arrays.position[k].assign(padded, 0.0);
            arrays.normal[k].assign(padded, 0.0);
        }
        for (std::size_t m = 0; m < 6; ++m) {
            arrays.moment[m].assign(padded, 0.0);
            arrays.sum[m].assign(padded, 0.0);
        }
        std::vector<Mode> flux(n, Mode::Zero());
        for (std::size_t t = 0; t < out_.panels.size(); ++t) {
            const Panel& panel = out_.panels[t];
            for (const uint32_t e : panel_edges_[t]) {
                flux[e] += panel.area / 3.0 * normal_velocity(middle_[e], panel.normal);
                for (std::size_t k = 0; k < 3; ++k)
                    arrays.normal[k][e] += panel.area / 3.0 * panel.normal[static_cast<Eigen::Index>(k)];
            }
        }
        for (std::size_t e = 0; e < n; ++e) {
            for (std::size_t k = 0; k < 3; ++k) arrays.position[k][e] = middle_[e][static_cast<Eigen::Index>(k)];
            for (std::size_t m = 0; m < 6; ++m) arrays.moment[m][e] = flux[e][static_cast<Eigen::Index>(m)];
        }
        sum_doublets(arrays, n, [&](double fraction) { progress_(0.2 * fraction); });
        // Both hat functions of an edge are 1/2 at its midpoint; the third one of the triangle is 0.
        for (std::size_t e = 0; e < n; ++e)
            for (const uint32_t vertex : edges_[e])
                for (std::size_t m = 0; m < 6; ++m)
                    out_.right_side(vertex, static_cast<Eigen::Index>(m)) -= 0.5 / four_pi * arrays.sum[m][e];
    }

    struct NearLayer {
        uint32_t panel;
        std::array<Mode, 3> double_layer; // of each corner's hat function
    };
    // Work arrays for one outer panel.
    struct NearWork {
        std::vector<NearPair*> batch, apart;
        std::vector<std::vector<uint32_t>> sources; // of each part of the panel, as indices into `batch`
        std::vector<double> points, weights;        // of the outer rule
        std::array<double, 9> middles{};            // of the outer edges
        std::vector<double> sums;                   // of each pair of `batch`
        std::vector<NearLayer> layers;
    };

    // Threads take a block of panels at a time; the sums always follow the order of the panels.
    void integrate_all_near(unsigned threads) {
        constexpr std::size_t most_panels = 4096, most_pairs = 200000;
        const std::size_t n = out_.panels.size();
        std::vector<NearWork> work(threads > 1 ? std::min(n, most_panels) : 1);
        for (std::size_t begin = 0, end = 0; begin < n; begin = end) {
            std::size_t pairs = near_[end++].size();
            while (end < n && end - begin < work.size() && pairs + near_[end].size() <= most_pairs)
                pairs += near_[end++].size();
            if (work.size() == 1)
                integrate_near(begin, work[0]);
            else
                parallel_for(end - begin, threads,
                             [&](std::size_t i, unsigned) { integrate_near(begin + i, work[i]); });
            for (std::size_t t = begin; t < end; ++t) add_near(t, work[t - begin]);
            if (begin % 64 == 0 || work.size() > 1)
                progress_(0.2 + 0.2 * static_cast<double>(end) / static_cast<double>(n));
        }
    }

    // Outer quadrature on panel t, closed forms on the panels around it. All panels close to a part of t share the outer points there: on a thin body
    // the double layer of one panel is nearly a step, and only the sum over neighbours is smooth. q is linear on a panel, so all modes follow from
    // integrals with the barycentric coordinates of t.
    void integrate_near(std::size_t t, NearWork& work) {
        work.layers.clear();
        sort_near(t, work);
        const std::array<Mode, 3> velocity = corner_velocities(out_.panels[t]);
        if (level_[t] == 0)
            integrate_pairs(t, touching_rule_, work.batch, velocity, work);
        else
            integrate_by_parts(t, velocity, work);
        integrate_pairs(t, apart_rule_, work.apart, velocity, work);
    }

    void sort_near(std::size_t t, NearWork& work) {
        work.batch.clear();
        work.apart.clear();
        for (NearPair& pair : near_[t]) {
            if (basis_.sheet && size_ratio(t, pair) > most_unlike) continue;
            (pair.touching || level_[t] > 0 ? work.batch : work.apart).push_back(&pair);
        }
        // Fills the last vector of the batch with pairs that would need fewer points: its spare lanes are free.
        const std::size_t spare =
            std::min((near_batch - work.batch.size() % near_batch) % near_batch, work.apart.size());
        work.batch.insert(work.batch.end(), work.apart.end() - static_cast<std::ptrdiff_t>(spare), work.apart.end());
        work.apart.resize(work.apart.size() - spare);
        if (level_[t] > 0) assign_sources(t, work);
    }

    // Estimate of the points of all near integrals, from every n-th panel.
    double near_points() {
        constexpr std::size_t stride = 16;
        NearWork work;
        std::size_t points = 0;
        for (std::size_t t = 0; t < near_.size(); t += stride) {
            sort_near(t, work);
            points += apart_rule_.weights.size() * work.apart.size();
            if (level_[t] == 0) points += touching_rule_.weights.size() * work.batch.size();
            if (level_[t] > 0)
                for (std::size_t part = 0; part < parts_.size(); ++part)
                    points += parts_[part].rule.weights.size() * work.sources[part].size();
        }
        return static_cast<double>(stride * points);
    }

    // Cuts t into quarters, level_[t] times, for the panels that are close to them.
    void integrate_by_parts(std::size_t t, const std::array<Mode, 3>& velocity, NearWork& work) {
        constexpr std::size_t fields = NearResult::count;
        work.sums.assign(fields * work.batch.size(), 0.0);
        BatchResults results;
        for (std::size_t part = 0; part < parts_.size(); ++part) {
            const std::vector<uint32_t>& sources = work.sources[part];
            if (sources.empty()) continue;
            const OuterRule rule = outer_rule(t, parts_[part].rule, work);
            for (std::size_t first = 0; first < sources.size(); first += near_batch) {
                const std::size_t lanes = std::min(near_batch, sources.size() - first);
                integrate_batch(
                    rule, lanes, [&](std::size_t lane) { return work.batch[sources[first + lane]]->panel; }, results);
                for (std::size_t lane = 0; lane < lanes; ++lane) {
                    double* const sum = &work.sums[fields * sources[first + lane]];
                    for (std::size_t f = 0; f < NearResult::middles; ++f) sum[f] += results[f * near_batch + lane];
                    for (std::size_t f = NearResult::middles; f < fields; ++f) sum[f] = results[f * near_batch + lane];
                }
            }
        }
        for (std::size_t i = 0; i < work.batch.size(); ++i)
            add_pair(t, *work.batch[i], velocity, &work.sums[fields * i], 1, work);
    }

    // Each source panel uses the largest parts of t that are apart from it, or else the smallest parts.
    void assign_sources(std::size_t t, NearWork& work) const {
        work.sources.resize(parts_.size());
        for (std::vector<uint32_t>& sources : work.sources) sources.clear();
        for (uint32_t i = 0; i < work.batch.size(); ++i)
            assign_source(t, 0, i, out_.panels[work.batch[i]->panel], work);
    }
    void assign_source(std::size_t t, std::size_t at, uint32_t index, const Panel& panel, NearWork& work) const {
        constexpr double apart = 3.0; // distance from the centre of a part, over its radius
        const Panel& outer = out_.panels[t];
        const TrianglePart& part = parts_[at];
        const Eigen::Vector3d &c = part.centre,
                              centre = c[0] * outer.corner[0] + c[1] * outer.corner[1] + c[2] * outer.corner[2];
        const bool smallest = part.size < (level_[t] == 1 ? 0.75 : 0.375);
        if (smallest || is_beyond(panel, centre, apart * part.size * outer.radius))
            work.sources[at].push_back(index);
        else
            for (std::size_t k = 1; k <= 4; ++k) assign_source(t, 4 * at + k, index, panel, work);
    }
    static bool is_beyond(const Panel& panel, const Eigen::Vector3d& point, double distance) {
        const double square = (panel.centroid - point).squaredNorm();
        if (square <= distance * distance) return false;
        const double reach = distance + panel.radius;
        return square > reach * reach || square_distance(panel, point) > distance * distance;
    }

    static std::array<Mode, 3> corner_velocities(const Panel& panel) {
        std::array<Mode, 3> velocity;
        for (std::size_t k = 0; k < 3; ++k) velocity[k] = normal_velocity(panel.corner[k], panel.normal);
        return velocity;
    }

    void add_near(std::size_t t, const NearWork& work) {
        const Panel& outer = out_.panels[t];
        const std::array<Mode, 3> velocity = corner_velocities(outer);
        for (std::size_t k = 0; k < 3; ++k)
            add_to_unknowns(out_.moments, basis_.corners[t][k],
                            outer.area / 12.0 * (velocity[0] + velocity[1] + velocity[2] + velocity[k]));
        for (const NearLayer& layer : work.layers)
            for (std::size_t k = 0; k < 3; ++k)
                out_.right_side.row(mesh_.faces[layer.panel][k]) -=
                    outer.area / four_pi * layer.double_layer[k].transpose();
    }

    OuterRule outer_rule(std::size_t t, const TriangleRule& rule, NearWork& work) const {
        const Panel& outer = out_.panels[t];
        work.points.clear();
        work.weights.clear();
        for (std::size_t g = 0; g < rule.weights.size(); ++g) {
            const Eigen::Vector3d& node = rule.nodes[g];
            const Eigen::Vector3d x = node[0] * outer.corner[0] + node[1] * outer.corner[1] + node[2] * outer.corner[2];
            for (Eigen::Index k = 0; k < 3; ++k) {
                work.points.push_back(x[k]);
                work.weights.push_back(rule.weights[g] * node[k]);
            }
        }
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t c = 0; c < 3; ++c)
                work.middles[3 * k + c] = middle_[panel_edges_[t][k]][static_cast<Eigen::Index>(c)];
        return {work.points.data(), work.weights.data(), rule.weights.size(), work.middles.data()};
    }

    using BatchResults = std::array<double, NearResult::count * near_batch>;

    template <class PanelOf>
    void integrate_batch(const OuterRule& rule, std::size_t lanes, const PanelOf& panel_of,
                         BatchResults& results) const {
        std::array<double, NearFields::count * near_batch> sources;
        for (std::size_t lane = 0; lane < near_batch; ++lane) {
            const auto& fields = fields_[panel_of(std::min(lane, lanes - 1))];
            for (std::size_t f = 0; f < NearFields::count; ++f) sources[f * near_batch + lane] = fields[f];
        }
        integrate_near_panels(rule, sources.data(), results.data());
    }

    void integrate_pairs(std::size_t t, const TriangleRule& rule, const std::vector<NearPair*>& pairs,
                         const std::array<Mode, 3>& velocity, NearWork& work) {
        if (pairs.empty()) return;
        const OuterRule outer = outer_rule(t, rule, work);
        BatchResults results;
        for (std::size_t first = 0; first < pairs.size(); first += near_batch) {
            const std::size_t lanes = std::min(near_batch, pairs.size() - first);
            integrate_batch(
                outer, lanes, [&](std::size_t lane) { return pairs[first + lane]->panel; }, results);
            for (std::size_t lane = 0; lane < lanes; ++lane)
                add_pair(t, *pairs[first + lane], velocity, &results[lane], near_batch, work);
        }
    }

    void add_pair(std::size_t t, NearPair& pair, const std::array<Mode, 3>& velocity, const double* results,
                  std::size_t stride, NearWork& work) const {
        pair.single_layer = out_.panels[t].area * results[NearResult::single_layer * stride];
        if (!basis_.sheet)
            work.layers.push_back({pair.panel, near_double_layer(velocity, pair.panel, results, stride)});
    }

    std::array<Mode, 3> near_double_layer(const std::array<Mode, 3>& velocity, uint32_t s, const double* results,
                                          std::size_t stride) const {
        std::array<Mode, 3> layer;
        const Panel& inner = out_.panels[s];
        const double share = 0.5 * inner.area / 9.0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t edge = (k + 1) % 3; // opposite; the hat of k is 1/2 at the midpoints of edges k and k - 1
            const double slope = inner.edge_length[edge] / (2.0 * inner.area);
            Mode sum = Mode::Zero();
            for (std::size_t a = 0; a < 3; ++a) {
                const auto at = [&](std::size_t field, std::size_t row) {
                    return results[(field + 3 * row + a) * stride];
                };
                sum += (slope * at(NearResult::double_layer, edge) -
                        share * (at(NearResult::middles, k) + at(NearResult::middles, (k + 2) % 3))) *
                       velocity[a];
            }
            layer[k] = sum;
        }
        return layer;
    }

    // The outer rule is on the smaller panel, where the inner potential varies least.
    double near_single_layer(std::size_t t, const NearPair& pair, const NearPair& mirror) const {
        const double ratio = size_ratio(t, pair);
        if (ratio < 1.0 / most_unlike) return pair.single_layer;
        if (ratio > most_unlike) return mirror.single_layer;
        return 0.5 * (pair.single_layer + mirror.single_layer);
    }
    static constexpr double most_unlike = 1.0 / 0.7; // between these size ratios both outer rules are equally good
    double size_ratio(std::size_t t, const NearPair& pair) const {
        return out_.panels[t].radius / out_.panels[pair.panel].radius;
    }

    PanelFans find_fans() const {
        PanelFans fans;
        fans.start.assign(basis_.unknowns + 1, 0);
        const auto for_corners = [&](auto&& visit) {
            for (std::size_t t = 0; t < mesh_.faces.size(); ++t)
                for (std::size_t k = 0; k < 3; ++k) {
                    const CornerUnknowns& corner = basis_.corners[t][k];
                    if (corner.plus >= 0) visit(t, k, static_cast<std::size_t>(corner.plus), 1.0);
                    if (corner.minus >= 0) visit(t, k, static_cast<std::size_t>(corner.minus), -1.0);
                }
        };
        for_corners([&](std::size_t, std::size_t, std::size_t unknown, double) { ++fans.start[unknown + 1]; });
        std::partial_sum(fans.start.begin(), fans.start.end(), fans.start.begin());
        fans.panel.resize(fans.start.back());
        fans.curl.resize(3 * fans.start.back());
        std::vector<std::size_t> next(fans.start.begin(), fans.start.end() - 1);
        for_corners([&](std::size_t t, std::size_t k, std::size_t unknown, double sign) {
            const std::size_t at = next[unknown]++;
            const Eigen::Vector3d curl = sign * hat_curl(out_.panels[t], k);
            fans.panel[at] = static_cast<uint32_t>(t);
            std::copy_n(curl.data(), 3, &fans.curl[3 * at]);
        });
        return fans;
    }

    // Adds to the columns of the unknowns at the corners of the target panels. A corner has up to two unknowns.
    void add_to_columns(const PanelFans& fans, const std::vector<double>& values,
                        const std::array<std::size_t, near_batch>& targets, std::size_t lanes) {
        for (const bool plus : {true, false}) {
            std::array<double, 9 * near_batch> curls{};
            std::array<double*, 3 * near_batch> columns{};
            columns.fill(unused_.data());
            bool any = false;
            for (std::size_t lane = 0; lane < lanes; ++lane)
                for (std::size_t k = 0; k < 3; ++k) {
                    const CornerUnknowns& corner = basis_.corners[targets[lane]][k];
                    const int32_t unknown = plus ? corner.plus : corner.minus;
                    if (unknown < 0) continue;
                    any = true;
                    columns[k * near_batch + lane] = out_.hypersingular.col(unknown).data();
                    const Eigen::Vector3d curl = (plus ? 1.0 : -1.0) * hat_curl(out_.panels[targets[lane]], k);
                    for (std::size_t c = 0; c < 3; ++c)
                        curls[(3 * k + c) * near_batch + lane] = curl[static_cast<Eigen::Index>(c)];
                }
            if (any) add_currents(fans, values.data(), curls.data(), columns, lanes);
        }
    }

    // Computes near_batch columns of the single layer at a time; far panels by centroids and second moments, with an error of
    // third order in size over distance.
    void assemble_hypersingular() {
        const std::size_t n = out_.panels.size();
        const auto unknowns = static_cast<Eigen::Index>(basis_.unknowns);
        std::vector<double> records;
        records.reserve(far_fields * n);
        for (const Panel& panel : out_.panels) {
            Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
            for (const Eigen::Vector3d& corner : panel.corner)
                second += (corner - panel.centroid) * (corner - panel.centroid).transpose() / 12.0;
            records.insert(records.end(),
                           {panel.centroid[0], panel.centroid[1], panel.centroid[2], second(0, 0), second(1, 1),
                            second(2, 2), second(0, 1), second(1, 2), second(2, 0), panel.area / four_pi});
        }
        const PanelFans fans = find_fans();
        out_.hypersingular = Eigen::MatrixXd::Zero(unknowns, unknowns);
        unused_.assign(basis_.unknowns, 0.0);
        std::vector<double> values(n * near_batch);
        std::vector<std::size_t> mirrors(n, 0); // lists are sorted: each panel finds itself in ascending order
        for (std::size_t first = 0; first < n; first += near_batch) {
            const std::size_t lanes = std::min(near_batch, n - first);
            std::array<std::size_t, near_batch> targets;
            for (std::size_t lane = 0; lane < near_batch; ++lane) targets[lane] = first + std::min(lane, lanes - 1);
            far_single_layer(records.data(), n, targets, values.data());
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                const std::size_t t = targets[lane];
                for (const NearPair& pair : near_[t]) {
                    const NearPair& mirror = near_[pair.panel][mirrors[pair.panel]++];
                    values[pair.panel * near_batch + lane] = near_single_layer(t, pair, mirror) / four_pi;
                }
                values[t * near_batch + lane] = out_.self[t];
            }
            add_to_columns(fans, values, targets, lanes);
            if (first % 64 == 0) progress_(0.4 + 0.4 * static_cast<double>(first) / static_cast<double>(n));
        }
    }

    const Mesh& mesh_;
    const SurfaceBasis& basis_;
    const std::function<void(double)>& progress_;
    BoundaryOperators& out_;
    std::vector<std::array<uint32_t, 2>> edges_;
    std::vector<std::array<uint32_t, 3>> panel_edges_;
    std::vector<Eigen::Vector3d> middle_;
    std::vector<std::vector<NearPair>> near_;
    std::vector<std::size_t> level_;
    TriangleRule touching_rule_ = dunavant_rule(0), apart_rule_ = six_point_rule();
    std::vector<TrianglePart> parts_ = triangle_parts(2);
    std::vector<std::array<double, NearFields::count>> fields_; // of each panel
    std::vector<double> unused_;                                // column for corners without an unknown
};
} // namespace

BoundaryOperators assemble_boundary_operators(const Mesh& mesh, const SurfaceBasis& basis,
                                              const std::function<void(double)>& progress, const NearLimits& limits) {
    BoundaryOperators out;
    Assembler(mesh, basis, progress, out).run(limits);
    return out;
}

bool assemble_without_matrix(const Mesh& mesh, const SurfaceBasis& basis, unsigned threads,
                             const std::function<void(double)>& progress, BoundaryOperators& out, NearSingleLayer& near,
                             const NearLimits& limits) {
    out = {};
    return Assembler(mesh, basis, progress, out).run_fast(thread_count(threads), limits, near);
}
} // namespace lr::baker
