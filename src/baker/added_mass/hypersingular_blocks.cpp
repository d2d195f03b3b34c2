#include "baker/added_mass/hypersingular_blocks.h"

#include <algorithm>
#include <numbers>
#include <numeric>

namespace lr::baker {
namespace {

template <class Visit> void for_each_part(const SurfaceBasis& basis, const Visit& visit) {
    for (std::size_t t = 0; t < basis.corners.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const CornerUnknowns& corner = basis.corners[t][k];
            const auto panel = static_cast<uint32_t>(t);
            const auto index = static_cast<uint8_t>(k);
            if (corner.plus >= 0) visit(static_cast<std::size_t>(corner.plus), BasisPart{panel, index, 1});
            if (corner.minus >= 0) visit(static_cast<std::size_t>(corner.minus), BasisPart{panel, index, -1});
        }
}

void add_record(const Panel& panel, std::vector<double>& records) {
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d& corner : panel.corner)
        second += (corner - panel.centroid) * (corner - panel.centroid).transpose() / 12.0;
    records.insert(records.end(),
                   {panel.centroid[0], panel.centroid[1], panel.centroid[2], second(0, 0), second(1, 1), second(2, 2),
                    second(0, 1), second(1, 2), second(2, 0), panel.area / (4.0 * std::numbers::pi)});
}
} // namespace

BasisParts find_basis_parts(const SurfaceBasis& basis) {
    BasisParts parts;
    parts.start.assign(basis.unknowns + 1, 0);
    for_each_part(basis, [&](std::size_t unknown, const BasisPart&) { ++parts.start[unknown + 1]; });
    std::partial_sum(parts.start.begin(), parts.start.end(), parts.start.begin());
    parts.part.resize(parts.start.back());
    std::vector<std::size_t> next(parts.start.begin(), parts.start.end() - 1);
    for_each_part(basis, [&](std::size_t unknown, const BasisPart& part) { parts.part[next[unknown]++] = part; });
    return parts;
}

HypersingularBlocks::HypersingularBlocks(const std::vector<Panel>& panels, const std::vector<double>& self,
                                         const NearSingleLayer& near, const SurfaceBasis& basis,
                                         const BasisParts& parts)
    : panels_(panels), self_(self), near_(near), basis_(basis), parts_(parts) {}

void HypersingularBlocks::assemble(std::span<const uint32_t> rows, std::span<const uint32_t> columns, Workspace& work,
                                   Eigen::MatrixXd& out) const {
    out.setZero(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns.size()));
    work.row_panels.clear();
    work.targets.clear();
    work.records.clear();
    work.fans.start.assign(1, 0);
    work.fans.panel.clear();
    work.fans.curl.clear();
    work.unused.assign(rows.size(), 0.0);
    for (const uint32_t row : rows) {
        for (const BasisPart& part : parts_.of(row)) {
            int32_t& local = work.row_of_panel[part.panel];
            if (local < 0) {
                local = static_cast<int32_t>(work.row_panels.size());
                work.row_panels.push_back(part.panel);
                add_record(panels_[part.panel], work.records);
            }
            const Eigen::Vector3d curl = part.sign * hat_curl(panels_[part.panel], part.corner);
            work.fans.panel.push_back(static_cast<uint32_t>(local));
            work.fans.curl.insert(work.fans.curl.end(), curl.data(), curl.data() + 3);
        }
        work.fans.start.push_back(work.fans.panel.size());
    }
    for (std::size_t j = 0; j < columns.size(); ++j) {
        work.column_of_unknown[columns[j]] = static_cast<int32_t>(j);
        for (const BasisPart& part : parts_.of(columns[j]))
            if (!work.is_target[part.panel]) {
                work.is_target[part.panel] = 1;
                work.targets.push_back(part.panel);
                add_record(panels_[part.panel], work.records);
            }
    }

    const std::size_t count = work.row_panels.size();
    work.values.resize(count * near_batch);
    const auto column = [&](int32_t unknown) {
        const int32_t j = unknown < 0 ? -1 : work.column_of_unknown[static_cast<std::size_t>(unknown)];
        return j < 0 ? work.unused.data() : out.col(j).data();
    };
    for (std::size_t first = 0; first < work.targets.size(); first += near_batch) {
        const std::size_t lanes = std::min(near_batch, work.targets.size() - first);
        std::array<std::size_t, near_batch> records;
        std::array<double, 9 * near_batch> curls{};
        std::array<double*, 3 * near_batch> plus{}, minus{};
        bool any_minus = false;
        for (std::size_t lane = 0; lane < near_batch; ++lane) {
            const std::size_t at = first + std::min(lane, lanes - 1);
            records[lane] = count + at;
            const Panel& panel = panels_[work.targets[at]];
            for (std::size_t k = 0; k < 3; ++k) {
                const CornerUnknowns& corner = basis_.corners[work.targets[at]][k];
                plus[k * near_batch + lane] = column(corner.plus);
                minus[k * near_batch + lane] = column(corner.minus);
                any_minus = any_minus || corner.minus >= 0;
                const Eigen::Vector3d curl = hat_curl(panel, k);
                for (std::size_t c = 0; c < 3; ++c)
                    curls[(3 * k + c) * near_batch + lane] = curl[static_cast<Eigen::Index>(c)];
            }
        }
        far_single_layer(work.records.data(), count, records, work.values.data());
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const uint32_t t = work.targets[first + lane];
            const auto set = [&](uint32_t panel, double value) {
                const int32_t row = work.row_of_panel[panel];
                if (row >= 0) work.values[static_cast<std::size_t>(row) * near_batch + lane] = value;
            };
            for (std::size_t i = near_.start[t]; i < near_.start[t + 1]; ++i) set(near_.panel[i], near_.value[i]);
            set(t, self_[t]);
        }
        add_currents(work.fans, work.values.data(), curls.data(), plus, lanes);
        if (any_minus) {
            for (double& curl : curls) curl = -curl;
            add_currents(work.fans, work.values.data(), curls.data(), minus, lanes);
        }
    }
    for (const uint32_t panel : work.row_panels) work.row_of_panel[panel] = -1;
    for (const uint32_t panel : work.targets) work.is_target[panel] = 0;
    for (const uint32_t unknown : columns) work.column_of_unknown[unknown] = -1;
}
} // namespace lr::baker
