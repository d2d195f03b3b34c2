// The picture of a storm: its frames in time, the last one large above, the earlier ones in a strip below. With --ground all
// frames have the same size, in two columns.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "drawn_storm.h"
#include "image/picture.h"
#include "options.h"
#include "storm.h"

// The mesh for the bodies of a kind: from --mesh, or from a file beside the asset, or an ellipse. path: receives the file's
// path; may be empty.
Mesh drawn_mesh(const Options& options, const Storm& storm, std::size_t kind, std::string& path);

class ContactSheet {
public:
    // Throws Failure without OpenGL: before the storm, not after it.
    ContactSheet(const Options& options, const Storm& storm);

    // Whether to take a frame after this step.
    bool due(std::uint64_t step) const;
    void take(const Storm& storm);
    const Picture& picture() const { return picture_; }

private:
    struct Tile {
        int left, top, width, height;
        std::uint64_t step;
    };
    std::vector<Tile> tiles_;
    std::size_t taken_ = 0;
    std::unique_ptr<DrawnStorm> drawn_;
    Picture picture_;
};
