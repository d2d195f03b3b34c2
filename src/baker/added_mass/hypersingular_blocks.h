// Blocks of the matrix of W (boundary_operators.h) between any unknowns.
#pragma once

#include "baker/added_mass/boundary_operators.h"
#include "baker/added_mass/panel_kernels.h"
#include "baker/added_mass/surface_basis.h"

#include <Eigen/Core>

#include <span>

namespace lr::baker {

// One panel corner of an unknown's basis function.
struct BasisPart {
    uint32_t panel;
    uint8_t corner;
    int8_t sign;
};

// The parts of all unknowns.
struct BasisParts {
    std::vector<std::size_t> start;
    std::vector<BasisPart> part;
    std::span<const BasisPart> of(std::size_t unknown) const {
        return {part.data() + start[unknown], start[unknown + 1] - start[unknown]};
    }
};
BasisParts find_basis_parts(const SurfaceBasis& basis);

class HypersingularBlocks {
public:
    // Keeps references to all arguments.
    HypersingularBlocks(const std::vector<Panel>& panels, const std::vector<double>& self, const NearSingleLayer& near,
                        const SurfaceBasis& basis, const BasisParts& parts);

    // Reusable work arrays of one thread.
    class Workspace;

    // Panels as in the dense matrix: near ones from the list, others by centroids and second moments.
    void assemble(std::span<const uint32_t> rows, std::span<const uint32_t> columns, Workspace& work,
                  Eigen::MatrixXd& out) const;

    std::size_t panel_count() const { return panels_.size(); }
    std::size_t unknowns() const { return basis_.unknowns; }

private:
    const std::vector<Panel>& panels_;
    const std::vector<double>& self_;
    const NearSingleLayer& near_;
    const SurfaceBasis& basis_;
    const BasisParts& parts_;
};

class HypersingularBlocks::Workspace {
public:
    explicit Workspace(const HypersingularBlocks& blocks)
        : row_of_panel(blocks.panel_count(), -1), column_of_unknown(blocks.unknowns(), -1),
          is_target(blocks.panel_count(), 0) {}

private:
    friend class HypersingularBlocks;
    std::vector<int32_t> row_of_panel, column_of_unknown; // -1: not in the block
    std::vector<char> is_target;
    std::vector<uint32_t> row_panels, targets;
    std::vector<double> records, values, unused;
    PanelFans fans;
};
} // namespace lr::baker
