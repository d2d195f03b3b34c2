// Any bytes as a PNG image, and any mask as its opacity: numbered faults, or a mesh that fills the outline.
#include "baker/card/card.h"
#include "baker/card/outline.h"
#include "baker/card/outline_simplify.h"
#include "baker/card/planar_mesh.h"
#include "baker/fault_text.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace {

using namespace lr::baker;

uint32_t crc32(const uint8_t* bytes, std::size_t size) {
    uint32_t crc = ~0U;
    for (std::size_t i = 0; i < size; ++i) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1 ? 0xedb88320U : 0U);
    }
    return ~crc;
}

uint32_t big_endian(const std::string& bytes, std::size_t at) {
    uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<uint8_t>(bytes[at + i]);
    return value;
}

// Checksums would refuse changed bytes early: corrects them, so that the later checks run too.
void mend(std::string& png) {
    for (std::size_t at = 8; at + 12 <= png.size();) {
        const std::size_t length = big_endian(png, at);
        if (length > png.size() - at - 12) return;
        const uint32_t crc = crc32(reinterpret_cast<const uint8_t*>(png.data()) + at + 4, length + 4);
        for (std::size_t i = 0; i < 4; ++i) png[at + 8 + length + i] = static_cast<char>(crc >> (24 - 8 * i) & 255);
        at += length + 12;
    }
}

double area(const Mesh& mesh) {
    double twice = 0.0;
    for (const Face& f : mesh.faces) {
        const Eigen::Vector3d a = mesh.vertices[f[1]] - mesh.vertices[f[0]],
                              b = mesh.vertices[f[2]] - mesh.vertices[f[0]];
        const double part = a.x() * b.y() - a.y() * b.x();
        if (!(part > 0.0)) std::abort();
        twice += part;
    }
    return 0.5 * twice;
}

void read_image(std::string png, std::size_t choice) {
    mend(png);
    if (png.size() < 24 || big_endian(png, 16) > 64 || big_endian(png, 20) > 64) return; // slow, not interesting
    CardOptions options;
    options.width = 0.1;
    options.triangles = 50;
    options.channel = choice & 1 ? MaskChannel::luminance : choice & 4 ? MaskChannel::key : MaskChannel::alpha;
    options.all_pieces = (choice & 2) != 0;
    Mesh mesh;
    CardReport report;
    lr::Faults faults;
    const bool good = read_card_memory(png.data(), png.size(), options, "fuzz", mesh, report, faults);
    if (good == lr::has_error(faults)) std::abort();
    if (good && !(std::abs(area(mesh) - report.traced_area) <= 1e-6 * report.traced_area)) std::abort();
}

// Every mask's outlines can be simplified and meshed.
void mesh_mask(const uint8_t* values, std::size_t size, std::size_t choice) {
    AlphaMask mask;
    mask.width = 1 + choice % 31;
    mask.height = size / mask.width;
    for (std::size_t i = 0; i < mask.width * mask.height; ++i)
        mask.opacity.push_back(static_cast<uint16_t>(values[i] * 257));
    Outlines outlines;
    lr::Faults faults;
    if (!trace_outlines(mask, 0.5, 0.0, true, "fuzz", outlines, faults)) return;
    double wanted = 0.0;
    std::vector<Loop> loops;
    for (const Piece& piece : outlines.pieces) {
        wanted += piece.area;
        loops.insert(loops.end(), piece.loops.begin(), piece.loops.end());
    }
    simplify_outlines(loops, 0.7, 0.3);
    double kept = 0.0;
    for (const Loop& loop : loops) kept += signed_area(loop);
    if (!(std::abs(kept - wanted) <= 1e-6 * wanted)) std::abort();
    PlanarMesh mesh;
    if (!triangulate_region(loops, 4.0, 200000, mesh)) std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    if (size < 2 || size > 1024) return 0;
    if (data[0] % 2)
        read_image(std::string(reinterpret_cast<const char*>(data) + 2, size - 2), data[1]);
    else
        mesh_mask(data + 2, size - 2, data[1]);
    return 0;
}
