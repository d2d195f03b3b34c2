#include "baker/card/card.h"

#include "baker/card/outline.h"
#include "baker/card/outline_simplify.h"
#include "baker/card/planar_mesh.h"
#include "baker/file_faults.h"
#include "baker/file_io.h"
#include "baker/printable_text.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <new>

namespace lr::baker {
namespace {

constexpr std::size_t max_file_bytes = std::size_t{1} << 30;
constexpr std::size_t max_triangles = 200000;
constexpr int most_listed = 8;
// Largest displacement of an outline by simplification, in pixels. The stairs of a mask without grey levels deviate by half a pixel
// from the intended line; grey levels place a line within about a tenth.
constexpr double stairs_tolerance = 0.7;
constexpr double grey_tolerance = 0.2;
// The same in edge lengths: a mesh cannot represent finer detail.
constexpr double edge_tolerance = 0.02;
constexpr double short_edge = 0.25; // in edge lengths: see simplify_outlines

std::string rounded(double value, double unit = 0.1) {
    return shortest(std::round(value / unit) / std::round(1.0 / unit));
}

bool check_options(const CardOptions& o, Faults& faults) {
    const auto in_range = [&](double value, double low, double high, const char* where, const char* unit) {
        if (value >= low && value <= high) return true;
        return fail(faults, FaultId::parameter_out_of_range, where,
                    "The value " + shortest(value) + " is outside its range.",
                    "Give a number from " + shortest(low) + " to " + shortest(high) + unit + ".");
    };
    bool good = in_range(o.width, 1e-6, 1e3, "width", " m");
    good = in_range(o.alpha, 0.001, 0.999, "alpha", "") && good;
    good =
        in_range(static_cast<double>(o.triangles), 20.0, static_cast<double>(max_triangles), "triangles", "") && good;
    return in_range(o.speck, 0.0, 1.0, "speck", "") && good;
}

class CardMesher {
public:
    CardMesher(const CardOptions& options, const std::string& where, Mesh& out, CardReport& report, Faults& faults)
        : options_(options), where_(where), out_(out), report_(report), faults_(faults) {}

    bool run(const void* bytes, std::size_t size) {
        AlphaMask mask;
        if (!read_alpha_mask(bytes, size, options_.channel, where_, mask, faults_)) return false;
        report_.image_width = mask.width;
        report_.image_height = mask.height;
        Outlines outlines;
        if (!trace_outlines(mask, options_.alpha, options_.speck, where_, outlines, faults_)) return false;
        mask = AlphaMask{};
        report_specks(outlines);
        stairs_ = outlines.stairs;
        report_.pieces = outlines.pieces.size();
        if (!choose(outlines)) return false;
        return mesh();
    }

private:
    double pixel() const { return options_.width / static_cast<double>(report_.image_width); }

    void report_specks(const Outlines& outlines) {
        const auto sentence = [](std::size_t count, double area, const char* what, const char* change) {
            return std::to_string(count) + what + " (" + rounded(area) + " pixels in all) " + change + ".";
        };
        const char* const remedy = "Clean the alpha channel, or give a lower --speck to keep them.";
        if (outlines.specks > 0)
            faults_.push_back({FaultId::image_specks, Severity::warning, where_,
                               sentence(outlines.specks, outlines.speck_area, " specks", "were ignored"), remedy});
        if (outlines.pinholes > 0)
            faults_.push_back({FaultId::image_specks, Severity::warning, where_,
                               sentence(outlines.pinholes, outlines.pinhole_area, " pinholes", "were closed"), remedy});
    }

    // "1 at 120,88 (61 %), 2 at 300,90 (39 %)": centres in pixels from the top left, as in image editors.
    std::string name_pieces(const std::vector<Piece>& pieces) const {
        double total = 0.0;
        for (const Piece& piece : pieces) total += piece.area;
        std::string text;
        for (std::size_t i = 0; i < pieces.size() && i < most_listed; ++i) {
            Eigen::Vector2d low = pieces[i].loops[0][0], high = low;
            for (const Eigen::Vector2d& p : pieces[i].loops[0]) {
                low = low.cwiseMin(p);
                high = high.cwiseMax(p);
            }
            const Eigen::Vector2d centre = 0.5 * (low + high);
            text += (i > 0 ? ", " : "") + std::to_string(i + 1) + " at " + rounded(centre.x(), 1.0) + "," +
                    rounded(static_cast<double>(report_.image_height) - centre.y(), 1.0) + " (" +
                    rounded(100.0 * pieces[i].area / total) + " %)";
        }
        if (pieces.size() > most_listed) text += " and " + std::to_string(pieces.size() - most_listed) + " more";
        return text;
    }

    bool choose(Outlines& outlines) {
        std::vector<Piece>& pieces = outlines.pieces;
        if (options_.piece && (*options_.piece < 1 || *options_.piece > pieces.size()))
            return fail(faults_, FaultId::parameter_unknown, "piece",
                        "The image has no region " + std::to_string(*options_.piece) + ".",
                        "It has: " + name_pieces(pieces) + ".");
        const std::size_t first = options_.piece ? *options_.piece - 1 : 0;
        const std::size_t end = options_.all_pieces ? pieces.size() : first + 1;
        if (pieces.size() > 1 && !options_.piece)
            faults_.push_back({FaultId::image_several_pieces, Severity::warning, where_,
                               "The image has " + std::to_string(pieces.size()) +
                                   " separate regions: " + name_pieces(pieces) + "; " +
                                   (options_.all_pieces ? "all were baked as one body." : "the largest was baked."),
                               options_.all_pieces ? "Choose one with --piece N if they are separate bodies."
                                                   : "Choose another with --piece N, or bake all with --piece all."});
        for (std::size_t i = first; i < end; ++i) {
            report_.holes += pieces[i].loops.size() - 1;
            area_ += pieces[i].area;
            for (Loop& loop : pieces[i].loops) loops_.push_back(std::move(loop));
        }
        report_.traced_area = area_ * pixel() * pixel();
        return true;
    }

    bool mesh() {
        const auto wanted = static_cast<double>(options_.triangles);
        double edge = std::sqrt(area_ / (wanted * std::sqrt(3.0) / 4.0)); // equilateral
        PlanarMesh best;
        std::vector<Loop> outline;
        double best_miss = HUGE_VAL;
        // The number of triangles is proportional to edge length^-2 or, in stems, ^-1.
        for (int attempt = 0; attempt < 5 && best_miss > 1.05; ++attempt) {
            std::vector<Loop> loops = loops_;
            simplify_outlines(loops, std::max(stairs_ ? stairs_tolerance : grey_tolerance, edge_tolerance * edge),
                              short_edge * edge);
            PlanarMesh mesh;
            if (!triangulate_region(loops, edge, max_triangles, mesh)) break;
            const double count = static_cast<double>(mesh.faces.size()),
                         miss = std::max(count / wanted, wanted / count);
            if (miss < best_miss) {
                best_miss = miss;
                best = std::move(mesh);
                outline = std::move(loops);
                report_.edge = edge * pixel();
            }
            edge *= std::clamp(std::sqrt(count / wanted), 0.5, 2.0);
        }
        if (best.faces.empty())
            return fail(faults_, FaultId::image_too_ragged, where_,
                        "The outline cannot be meshed with " + std::to_string(max_triangles) + " triangles.",
                        "Smooth the mask, or reduce the image.");
        if (static_cast<double>(best.faces.size()) > 1.5 * wanted)
            faults_.push_back({FaultId::image_too_ragged, Severity::warning, where_,
                               "The outline needs " + std::to_string(best.faces.size()) + " triangles; " +
                                   std::to_string(options_.triangles) + " were requested.",
                               "Smooth the mask, or reduce the image, for fewer."});
        write(best, outline);
        return true;
    }

    void write(const PlanarMesh& mesh, const std::vector<Loop>& outline) {
        const double metres = pixel();
        const Eigen::Vector2d centre(0.5 * static_cast<double>(report_.image_width),
                                     0.5 * static_cast<double>(report_.image_height));
        for (const Eigen::Vector2d& p : mesh.vertices) {
            const Eigen::Vector2d at = metres * (p - centre);
            out_.vertices.emplace_back(at.x(), at.y(), 0.0);
        }
        out_.faces = mesh.faces;
        for (const Loop& loop : outline) {
            report_.area += signed_area(loop) * metres * metres;
            report_.outline += perimeter(loop) * metres;
        }
        report_.smallest_angle = smallest_angle(mesh);
    }

    const CardOptions& options_;
    const std::string& where_;
    Mesh& out_;
    CardReport& report_;
    Faults& faults_;
    std::vector<Loop> loops_; // pixels
    double area_ = 0.0;
    bool stairs_ = false;
};
} // namespace

bool read_card_memory(const void* bytes, std::size_t size, const CardOptions& options, const std::string& where,
                      Mesh& out, CardReport& report, Faults& faults) {
    out = Mesh{};
    report = CardReport{};
    if (!check_options(options, faults)) return false;
    try {
        return CardMesher(options, where, out, report, faults).run(bytes, size);
    } catch (const std::bad_alloc&) {
        return fail(faults, FaultId::image_unreadable, where, "The image does not fit into memory.",
                    "Reduce its resolution.");
    }
}

bool read_card(const std::string& path_utf8, const CardOptions& options, Mesh& out, CardReport& report,
               Faults& faults) {
    std::vector<uint8_t> bytes;
    if (!read_file(path_utf8, max_file_bytes, bytes, faults)) return false;
    if (!read_card_memory(bytes.data(), bytes.size(), options, path_utf8, out, report, faults)) return false;
    const std::filesystem::path path = to_path(path_utf8);
    const std::u8string stem = path.stem().u8string();
    out.name = valid_utf8(std::string(stem.begin(), stem.end()));
    return true;
}
} // namespace lr::baker
