// SPDX-License-Identifier: MIT
#include "drawn_storm.h"

#include <cmath>

namespace {

// A camera at `eye` that looks along -z, `rise` upwards, at what is `distance` ahead.
::camera at(float x, float y, float z, float rise, float distance) {
    return {v3(x, y + distance * std::sin(rise), z - distance * std::cos(rise)), distance, 0.0f, -rise};
}

// In the box, low; in the park at the height of a child's eyes, for a heap lower.
::camera camera_for(const Options& options, const Storm& storm) {
    if (!storm.park()) {
        const storm::Box& box = storm.box();
        const float h = box.size(1);
        return at(0.5f * (box.low[0] + box.high[0]), box.low[1] + 0.16f * h, box.low[2] + 0.88f * box.size(2), 0.13f,
                  h);
    }
    const Park::Place heap = storm.park()->heap();
    if (options.heap) return at(heap.x, heap.y + 0.75f, heap.z + 1.9f, -0.27f, 2.0f);
    return at(0.0f, static_cast<float>(storm.park()->terrain().at(0.0, 4.0).height) + 1.25f, 4.0f, -0.19f, 5.0f);
}

look look_for(const std::string& name) {
    if (name.find("petal") != std::string::npos) return look_petal;
    if (name.find("confetti") != std::string::npos) return look_confetti;
    return name.find("paper") != std::string::npos ? look_paper : look_leaf;
}

} // namespace

DrawnStorm::DrawnStorm(const Options& options, const Storm& storm, std::vector<Kind> kinds)
    : storm_(storm), kinds_(std::move(kinds)), camera_(camera_for(options, storm)),
      haze_(storm.park() ? 26.0f : 2.4f * storm.box().size(1)) {
    throw_failures();
    context_without_display();
    for (const Kind& kind : kinds_) meshes_.push_back(kind.mesh.view());
    for (std::size_t k = 0; k < kinds_.size(); ++k)
        batches_.push_back({storm.kinds()[k].batch, &meshes_[k], look_for(kinds_[k].name)});
    picture_create(&picture_);
    picture_resize(&picture_, options.width, options.height); // fails before the storm, not after it
    shadow_create(&shadow_);
    bodies_create(&bodies_, &light_evening, batches_.data(), static_cast<int>(batches_.size()));
    ground_shape shape{};
    if (const Park* park = storm.park()) shape = {Terrain::side, Terrain::cell, 0.0f, park->terrain().heights().data()};
    landscape_create(&landscape_, &light_evening, &shape);
}

DrawnStorm::~DrawnStorm() {
    landscape_free(&landscape_);
    bodies_free(&bodies_);
    shadow_free(&shadow_);
    picture_free(&picture_);
}

std::vector<std::uint8_t> DrawnStorm::draw(int width, int height) {
    picture_resize(&picture_, width, height);
    pass p{};
    p.light = &light_evening;
    p.haze = haze_;
    p.view = camera_look(&camera_, static_cast<float>(width) / static_cast<float>(height));
    const lr_world* world = storm_.world();
    bodies_update(&bodies_, world, batches_.data());
    if (const Park* park = storm_.park())
        landscape_place(&landscape_, park->solids().data(), static_cast<int>(park->solids().size()));
    shadow_begin(&shadow_, &camera_, &p);
    landscape_draw_shadow(&landscape_, &p);
    bodies_draw_shadow(&bodies_, world, batches_.data(), &p);
    picture_begin(&picture_);
    bodies_draw(&bodies_, world, batches_.data(), &p, height);
    landscape_draw(&landscape_, ground_lawn, &p);
    picture_resolve(&picture_);
    std::vector<std::uint8_t> pixels(std::size_t{3} * static_cast<std::size_t>(width) *
                                     static_cast<std::size_t>(height));
    picture_read(&picture_, pixels.data());
    return pixels;
}
