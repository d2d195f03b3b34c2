// The picture of a storm: its frames in time, the last one large above, the earlier ones in a strip below.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "image/picture.h"
#include "options.h"
#include "renderer/renderer.h"
#include "storm.h"

class ContactSheet {
public:
    // Throws Failure when there is no OpenGL: before the storm, not after it.
    ContactSheet(const Options& options, const Storm& storm);

    // True when a frame is to be taken after this step.
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
    std::unique_ptr<Renderer> renderer_;
    std::vector<Renderer::Bodies> bodies_;
    Picture picture_;
};
