#include "baker/bake.h"

#include "asset/asset_file.h"
#include "asset/closed_forms/ellipsoid_asset.h"
#include "baker/added_mass/mixed_added_mass.h"
#include "baker/aerodynamics/mesh_geometry.h"
#include "baker/aerodynamics/principal_axes.h"
#include "baker/aerodynamics/stations.h"
#include "baker/bake_added_mass.h"
#include "baker/bake_input.h"
#include "baker/check_options.h"
#include "baker/fault_text.h"
#include "baker/file_faults.h"
#include "baker/length_text.h"
#include "baker/mass_mesh.h"
#include "baker/mesh/body_parts.h"
#include "baker/mesh/convex_hull.h"
#include "baker/mesh/double_sheets.h"
#include "baker/mesh/ellipsoid_mesh.h"
#include "baker/mesh/mass_properties.h"
#include "baker/mesh/mesh_check.h"
#include "baker/mesh/solid_region.h"
#include "baker/printable_text.h"
#include "baker/size_warning.h"
#include "baker/turbulence/stream_body.h"
#include "baker/turbulence/turbulence.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <new>

namespace lr::baker {
namespace {

// Largest thickness over length of a sheet. At the edges of a thicker one the zero-thickness formulation is wrong.
constexpr double max_thickness_share = 0.2;
constexpr double longest_body = 1e3; // m, at most the diagonal of its box
// Relative difference from half of the projected surface, which is exact if no part hides another, from which the silhouette is used.
constexpr double hidden_share = 0.01;

std::array<double, 3> to_array(const Eigen::Vector3d& v) {
    return {v[0], v[1], v[2]};
}

class Pipeline {
public:
    Pipeline(const BakeOptions& options, AssetData& out, Faults& faults, BakeTimings* timings,
             const BakeProgress& progress, const BakeHooks& hooks)
        : options_(options), out_(out), faults_(faults), timings_(timings), progress_(progress), hooks_(hooks),
          density_(options.density), sheet_(options.sheet.has_value()) {
        if (options.thickness) thickness_ = *options.thickness / units_per_metre(options.unit);
        if (options.sheet && options.sheet->thickness != choose_thickness)
            thickness_ = options.sheet->thickness / units_per_metre(options.unit);
    }

    bool run() {
        out_ = AssetData{};
        try {
            return make();
        } catch (const std::bad_alloc&) {
            return fail(faults_, FaultId::mesh_too_many_faces, mesh_.source ? printable(options_.mesh_path) : "memory",
                        "The bake does not fit into memory" +
                            (mesh_.source ? ": " + mesh_.source->largest() : std::string()) + ".",
                        "Reduce the mesh (decimate), leave parts out with --mesh, or give a coarser --grid.");
        }
    }

private:
    bool make() {
        return check_options(options_, faults_) && (options_.semi_axes ? make_ellipsoid() : make_mesh_body()) &&
               phase("turbulence", [&] { return make_turbulence(); }) && finish();
    }

    template <class Work> bool phase(const char* name, const Work& work) {
        phase_ = name;
        report(0.0);
        const auto start = std::chrono::steady_clock::now();
        const bool good = work();
        if (timings_)
            timings_->emplace_back(name,
                                   std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        if (good) report(1.0);
        return good;
    }
    void report(double fraction) const {
        if (progress_) progress_(phase_, fraction);
    }
    // Solvers can report completion several times; a phase ends once.
    void advance(double fraction) const { report(std::min(fraction, 0.999)); }
    std::array<double, 3> in_metres(const std::array<double, 3>& lengths) const {
        const double n = units_per_metre(options_.unit);
        return {lengths[0] / n, lengths[1] / n, lengths[2] / n};
    }

    // Makes the largest side of the bounding box as long as options.size.
    bool resize() {
        if (!options_.size) return true;
        const double side = box_sides(mesh_).maxCoeff();
        size_scale_ = *options_.size / side;
        if (!(side > 0.0) || !std::isfinite(size_scale_) || !(size_scale_ > 0.0))
            return fail(faults_, FaultId::mesh_degenerate_face, options_.mesh_path,
                        "All of the mesh lies in one point.", "Export the mesh again.");
        resize(mesh_, size_scale_);
        return true;
    }
    static void resize(Mesh& mesh, double factor) {
        for (Eigen::Vector3d& v : mesh.vertices) v *= factor;
        if (mesh.source) mesh.source->scale_by(factor);
    }

    bool make_ellipsoid() {
        shape::EllipsoidSpec spec;
        spec.semi_axes = in_metres(*options_.semi_axes);
        spec.density = options_.density;
        spec.fluid_density = options_.fluid_density;
        spec.fluid_viscosity = options_.fluid_viscosity;
        spec.intensity = options_.intensity;
        if (options_.center_of_mass) spec.center_of_mass = in_metres(*options_.center_of_mass);
        if (hooks_.body) *hooks_.body = ellipsoid_mesh(spec.semi_axes, spec.center_of_mass, 4);
        return phase("closed forms", [&] { return shape::ellipsoid_body(spec, out_, faults_); });
    }

    bool make_mesh_body() {
        return phase("reading", [&] { return read(); }) && phase("checking", [&] { return check(); }) &&
               phase("mass", [&] { return make_mass(); }) && phase("hull", [&] { return make_hull(); }) &&
               phase("aerodynamics", [&] { return make_aerodynamics(); }) &&
               phase("added mass", [&] { return make_added_mass(); });
    }

    bool read() {
        if (!read_input(options_, mesh_, card_, input_, faults_) || !resize()) return false;
        side_ = box_sides(mesh_).maxCoeff();
        if (box_sides(mesh_).norm() > longest_body && !options_.size && !options_.card && !options_.strict &&
            options_.unit == Unit::file) {
            size_scale_ = 1e-3;
            resize(mesh_, size_scale_);
            faults_.push_back(
                {FaultId::mesh_turned_or_scaled, Severity::warning, "unit",
                 "The body would be " + length_text(side_) + " long: its lengths were taken as millimetres.",
                 "Give its true length, as in --size 20cm, or the --unit that it was modelled in."});
            side_ *= size_scale_;
        }
        out_.provenance.source = source_name(options_);
        return true;
    }

    bool check() {
        const auto as_modelled = [&](Mesh& mesh, Faults& faults) {
            return is_sheet() ? check_sheet(mesh, faults) : check_and_repair(mesh, faults);
        };
        if (options_.strict || options_.card) return as_modelled(mesh_, faults_) && (!is_sheet() || finish_sheet());
        Mesh checked = mesh_;
        Faults found;
        const auto repairable = [](const Fault& f) {
            return f.severity == Severity::error && f.id != FaultId::mesh_not_finite && f.id != FaultId::mesh_bad_index;
        };
        if (as_modelled(checked, found) || std::none_of(found.begin(), found.end(), repairable)) {
            mesh_ = std::move(checked);
            faults_.insert(faults_.end(), found.begin(), found.end());
            return !has_error(found) && (!is_sheet() || finish_sheet());
        }
        const OpenParts open = is_sheet()      ? OpenParts::all_sheets
                               : options_.fill ? OpenParts::filled
                                               : OpenParts::sheets;
        if (!find_parts(mesh_, parts_, faults_, open)) return false;
        mesh_ = parts_.mesh;
        if (parts_.solid_faces == 0) {
            sheet_ = true;
            return check_sheet(mesh_, faults_) && finish_sheet();
        }
        mixed_ = !parts_.clean || parts_.has_sheets();
        if (!mixed_) return true;
        const BodyParts skin = outer_skin(parts_);
        if (take_as_one_solid(skin)) return true;
        std::vector<Face> sheets = skin.sheets();
        mesh_ = skin.mesh;
        solid_faces_ = skin.solid_faces;
        if (!sheets.empty()) {
            set_thickness(mesh_, sheets);
            parts_.covered =
                covered_sheets(parts_, sheets); // before backs of double sheets, which lie outside, are left out
            if (!take_once(sheets)) return false;
            Faults same;
            take_double_sheets_once(parts_.mesh, thickness_, false, parts_.covered, same);
        }
        mesh_.faces.resize(solid_faces_);
        mesh_.faces.insert(mesh_.faces.end(), sheets.begin(), sheets.end());
        drop_unused_vertices(mesh_);
        parts_.mesh.faces.resize(parts_.solid_faces);
        parts_.mesh.faces.insert(parts_.mesh.faces.end(), sheets.begin(), sheets.end());
        return true;
    }

    bool finish_sheet() {
        std::vector<Face> sheets = mesh_.faces;
        set_thickness(mesh_, sheets);
        if (!options_.card && !take_once(sheets)) return false;
        if (sheets.size() == mesh_.faces.size()) return true;
        mesh_.faces = std::move(sheets);
        drop_unused_vertices(mesh_);
        // The backs of sheets were counted as parts; counts again.
        const auto counts_parts = [](const Fault& f) { return f.id == FaultId::mesh_several_components; };
        std::erase_if(faults_, counts_parts);
        Faults again;
        check_sheet(mesh_, again);
        std::copy_if(again.begin(), again.end(), std::back_inserter(faults_), counts_parts);
        return true;
    }

    bool take_once(std::vector<Face>& sheets) {
        return take_double_sheets_once(mesh_, thickness_, options_.strict, sheets, faults_);
    }

    // If all extra faces lie inside one sound solid, it can be solved as a solid, which is more exact. Not with cavities, which can hold solids.
    bool take_as_one_solid(const BodyParts& skin) {
        const std::size_t inside = parts_.mesh.faces.size() - skin.mesh.faces.size();
        if (inside == 0 || skin.has_sheets() || !parts_.cavities.faces.empty()) return false;
        Mesh solid = skin.mesh;
        drop_unused_vertices(solid);
        Faults found;
        if (!is_clean_solid(solid, found)) return false;
        mesh_ = std::move(solid);
        mixed_ = false;
        faults_.push_back({FaultId::mesh_several_components, Severity::warning, "mesh",
                           counted(inside, "face lies", "faces lie") + " inside the solid, without effect.",
                           "None needed; --strict refuses such parts."});
        return true;
    }

    void set_thickness(const Mesh& mesh, const std::vector<Face>& sheets) {
        if (thickness_ == 0.0) {
            thickness_ = default_thickness * sheet_length(mesh, sheets);
            faults_.push_back(
                {FaultId::mesh_open_edge, Severity::warning, "mesh",
                 "Open parts are sheets " + length_text(thickness_, 2) + " thick: 0.3 % of their typical length.",
                 "Give --thickness if it is known."});
        }
        if (options_.sheet && options_.sheet->areal_density) density_ = *options_.sheet->areal_density / thickness_;
    }

    // Of the union of the solids, and of the sheets outside them.
    MassProperties mixed_properties() {
        const RegionMoments m = body_moments(parts_, thickness_, false);
        if (m.counted - m.volume > 1e-4 * m.counted)
            faults_.push_back({FaultId::mesh_several_components, Severity::warning, "mesh",
                               "Solids cross or lie in each other: they were taken as one body; " +
                                   shortest(std::round(1e4 * (1.0 - m.volume / m.counted)) / 100.0) +
                                   " % of their volume was covered more than once and counts once.",
                               "None needed. A boolean union in the modelling program makes the added mass more exact; "
                               "--strict refuses such parts."});
        return combined_mass_properties(mesh_, solid_faces_, m.volume, m.first, m.second);
    }

    // In the mesh of a frayed card gaps are closed; its weight lies where the image is opaque.
    MassProperties card_properties() const {
        const PlaneMoments& m = card_.opaque;
        Eigen::Vector3d first = Eigen::Vector3d::Zero();
        Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
        first.head<2>() = m.first;
        second.topLeftCorner<2, 2>() = m.second;
        second(2, 2) = m.area * thickness_ * thickness_ / 12.0;
        return combined_mass_properties(mesh_, 0, thickness_ * m.area, thickness_ * first, thickness_ * second);
    }

    MassProperties properties() {
        if (mixed_) return mixed_properties();
        if (options_.card) return card_properties();
        return is_sheet() ? compute_sheet_mass_properties(mesh_, thickness_) : solid_mass_properties(mesh_, faults_);
    }

    // Mass properties of the mass mesh if there is one, else of the mesh without its cavities.
    bool read_mass(MassProperties& weighed) {
        weighed = solid_;
        if (!options_.mass) {
            if (parts_.cavities.faces.empty()) return true;
            if (!mixed_) parts_.mesh = mesh_, parts_.solid_faces = mesh_.faces.size();
            const RegionMoments m = body_moments(parts_, thickness_, true);
            weighed = combined_mass_properties(mesh_, solid_faces_, m.volume, m.first, m.second);
            return true;
        }
        Mesh mesh;
        const std::size_t before = faults_.size();
        bool good = read_mass_input(options_, mesh, input_, faults_);
        resize(mesh, size_scale_);
        good = good && weigh(mesh, {is_sheet(), options_.strict, options_.fill, thickness_}, weighed, faults_);
        for (std::size_t i = before; i < faults_.size(); ++i)
            if (static_cast<uint32_t>(faults_[i].id) >= 200) faults_[i].where = "mass, " + faults_[i].where;
        return good;
    }

    bool make_mass() {
        solid_ = properties();
        MassProperties weighed;
        if (!read_mass(weighed)) return false;
        // The layers lie on each other and displace their own volume, so the sheet's mean thickness is that of all layers.
        if (is_sheet() && options_.mass) {
            thickness_ *= weighed.area / solid_.area;
            solid_.volume = weighed.volume;
            solid_.centroid = weighed.centroid;
        }
        const double size = solid_.extents.maxCoeff();
        if (!(size >= 1e-6 && size <= longest_body))
            return fail(faults_, FaultId::parameter_out_of_range, "unit",
                        "The body is " + length_text(size) + " long; the limits are 1e-6 and 1000 m.",
                        "Give its true length, as in --size 20cm, or the --unit that it was modelled in.");
        if (is_sheet() && thickness_ > max_thickness_share * size)
            return fail(faults_, FaultId::parameter_out_of_range, "thickness",
                        "A sheet " + length_text(thickness_) + " thick and " + length_text(size) +
                            " long is too thick.",
                        "Model it as a solid, or check --thickness and --unit.");
        center_ = weighed.centroid;
        if (options_.center_of_mass) {
            const std::array<double, 3> given = in_metres(*options_.center_of_mass);
            center_ = size_scale_ * Eigen::Vector3d(given[0], given[1], given[2]);
        }
        out_.volume = solid_.volume;
        out_.mass = density_ * weighed.volume;
        out_.density = weighs_less_or_more() ? out_.mass / solid_.volume : density_;
        out_.center_of_mass = to_array(center_);
        out_.center_of_buoyancy = to_array(solid_.centroid - center_);
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                out_.inertia[i * 3 + j] =
                    density_ * weighed.inertia(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
        out_.provenance.faces = static_cast<uint32_t>(mesh_.faces.size());
        out_.provenance.vertices = static_cast<uint32_t>(mesh_.vertices.size());
        for (Eigen::Vector3d& v : mesh_.vertices) v -= center_; // now in the body frame
        for (Eigen::Vector3d& v : parts_.mesh.vertices) v -= center_;
        if (mesh_.source) mesh_.source->move_to(center_);
        if (hooks_.body) *hooks_.body = mesh_;
        return true;
    }

    bool make_hull() {
        ConvexHull hull;
        if (!compute_convex_hull(is_sheet() || mixed_ ? both_sides() : mesh_.vertices, hull, faults_)) return false;
        for (const Face& f : hull.faces) {
            const Eigen::Vector3d& a = hull.vertices[f[0]];
            const Eigen::Vector3d normal = (hull.vertices[f[1]] - a).cross(hull.vertices[f[2]] - a);
            if (a.dot(normal) < -hull.slack * normal.norm())
                return fail(faults_, FaultId::parameter_out_of_range, "center of mass",
                            "It is outside the convex hull of the body.",
                            "Give it in the unit and the frame of the mesh.");
            hull_volume_ += normal.dot(a) / 6.0;
        }
        out_.hull = store_hull(hull, solid_.extents.maxCoeff());
        return true;
    }

    bool make_aerodynamics() {
        // Closed gaps add surface where a card is sparse: the loads would act beside the centre of mass and turn the body.
        for (Eigen::Vector3d& v : mesh_.vertices) v.head<2>() += card_.off_centre;
        // The axes follow the surface, not the mass.
        std::array<double, 9> inertia = out_.inertia;
        if (weighs_less_or_more())
            for (std::size_t i = 0; i < 9; ++i)
                inertia[i] = solid_.inertia(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3));
        const std::array<double, 9> axes = shape::principal_axes(inertia, mesh_.vertices);
        const Eigen::Vector3d centre = solid_.centroid - center_;
        shape::AerodynamicGeometry geometry = is_sheet() || mixed_
                                                  ? sheet_geometry(mesh_, thickness_, axes, centre, solid_faces_)
                                                  : mesh_geometry(mesh_, axes, centre);
        geometry.volume = solid_.volume;
        const auto broad = std::max_element(geometry.area.begin(), geometry.area.end()) - geometry.area.begin();
        broad_area_ = geometry.area[static_cast<std::size_t>(broad)];
        broad_normal_ = Eigen::Map<const Eigen::Vector3d>(axes.data() + 3 * broad);
        out_.aerodynamics = shape::default_aerodynamics(geometry);
        make_stations();
        return true;
    }

    void make_stations() {
        if (options_.stations == 1) return;
        StationOptions how;
        how.most = options_.stations;
        how.solid_faces = mixed_ || is_sheet() ? solid_faces_ : mesh_.faces.size();
        how.volume = solid_.volume;
        how.hull_volume = hull_volume_;
        how.length = solid_.extents.maxCoeff();
        how.viscosity = options_.fluid_viscosity;
        const std::array<double, 3>& offset = out_.aerodynamics.center;
        const Eigen::Vector3d center = solid_.centroid - center_ + Eigen::Vector3d(offset[0], offset[1], offset[2]);
        stations_ = lr::baker::make_stations(mesh_, out_.aerodynamics, center, how);
        out_.stations = stations_.at;
        if (hooks_.station_errors) *hooks_.station_errors = {stations_.error, stations_.error_one};
        warn_of_stations();
    }

    void warn_of_stations() {
        const auto warn = [&](const char* what, const char* remedy) {
            faults_.push_back({FaultId::loads_uncertain, Severity::warning, "aerodynamics", what, remedy});
        };
        if (stations_.fit == StationFit::coarse)
            warn("The shape has more wings and bends than its stations can describe.",
                 "Take its flight as a rough likeness, or bake a simpler shape.");
        if (stations_.fit == StationFit::hidden)
            warn("Large parts of the surface lie behind others (a tube, a crumpled sheet): the loads are "
                 "those of a plate of its outline.",
                 "Take its fall as a rough likeness; close the shape if it has a filling or lid.");
        if (stations_.fit == StationFit::hollow)
            warn(
                "The body fills less than half of its convex hull: the loads are those of a solid body of its outline.",
                "Take its fall as a rough likeness.");
    }

    bool is_sheet() const { return sheet_; }
    // The mass is not that of the displaced volume at `density`.
    bool weighs_less_or_more() const { return options_.mass || !parts_.cavities.faces.empty(); }

    std::vector<Eigen::Vector3d> both_sides() const {
        std::vector<Eigen::Vector3d> points;
        points.reserve(6 * mesh_.faces.size());
        for (std::size_t i = 0; i < solid_faces_; ++i)
            for (const uint32_t v : mesh_.faces[i]) points.push_back(mesh_.vertices[v]);
        for (std::size_t i = solid_faces_; i < mesh_.faces.size(); ++i) {
            const Face& f = mesh_.faces[i];
            const Eigen::Vector3d& a = mesh_.vertices[f[0]];
            const Eigen::Vector3d normal = (mesh_.vertices[f[1]] - a).cross(mesh_.vertices[f[2]] - a).normalized();
            for (const uint32_t v : f)
                for (const double side : {-0.5, 0.5})
                    points.emplace_back(mesh_.vertices[v] + side * thickness_ * normal);
        }
        return points;
    }

    bool make_added_mass() {
        // The solver refines coarse meshes, sheets to about twice as many faces.
        if (hooks_.before_solve)
            hooks_.before_solve(std::max<std::size_t>((is_sheet() ? 2 : 1) * mesh_.faces.size(), 5000));
        AddedMass added;
        AddedMassOptions how;
        how.threads = hooks_.threads;
        how.patient = options_.strict || options_.card;
        if (!solve_added_mass({mesh_, parts_, is_sheet(), mixed_}, how, added, faults_, [&](double f) { advance(f); }))
            return false;
        for (std::size_t i = 0; i < 36; ++i) {
            const auto row = static_cast<Eigen::Index>(i / 6), column = static_cast<Eigen::Index>(i % 6);
            // Exactly symmetric: scaled products differ in the last bit.
            out_.added_mass[i] = 0.5 * (added.value(row, column) + added.value(column, row));
            out_.added_mass_error[i] = 0.5 * (added.error(row, column) + added.error(column, row));
        }
        drop_noise(out_);
        share_added_mass(out_.aerodynamics, out_.added_mass, out_.stations);
        Eigen::Index broad = 0;
        out_.projected_area = solid_.projected_areas.maxCoeff(&broad);
        Eigen::Vector3d normal = solid_.axes.col(broad);
        double layers = thickness_; // of a sheet: of all layers that lie behind each other
        if (broad_area_ < (1.0 - hidden_share) * out_.projected_area) {
            layers *= out_.projected_area / broad_area_;
            out_.projected_area = broad_area_;
            normal = broad_normal_;
        }
        const double broadside = normal.dot(added.value.topLeftCorner<3, 3>() * normal);
        const shape::BodyScales scales =
            shape::body_scales(solid_.extents.maxCoeff(), is_sheet() ? layers : solid_.extents.minCoeff(),
                               solid_.volume, out_.projected_area, broadside, out_.density, options_.fluid_density);
        out_.length_d = scales.d;
        out_.length_b = scales.b;
        out_.length_l = scales.l;
        out_.u0 = scales.u0;
        out_.fluid_density = options_.fluid_density;
        out_.fluid_viscosity = options_.fluid_viscosity;
        doubt_closed_gaps();
        return true;
    }

    // Gaps as wide as the viscous length sqrt(nu d/U0) let the flow through. Then nearly all of the added mass of the closed surface is missing.
    void doubt_closed_gaps() {
        const double viscous = std::sqrt(out_.fluid_viscosity * out_.length_d / out_.u0);
        const double share = std::min(1.0, card_.closed_gap / viscous);
        for (std::size_t i = 0; i < 36; ++i)
            out_.added_mass_error[i] = std::max(out_.added_mass_error[i], share * std::abs(out_.added_mass[i]));
    }

    bool make_turbulence() {
        TurbulenceOptions o;
        o.cells = options_.cells;
        o.intensity = options_.intensity;
        o.u0 = out_.u0;
        o.length_l = out_.length_l;
        o.length_d = out_.length_d;
        o.viscosity = options_.fluid_viscosity;
        if (options_.wake && !put_body_in_stream(o)) return false;
        TurbulenceTable table;
        if (!compute_turbulence_table(o, table, faults_, [&](double f) { advance(f); })) return false;
        TurbulenceData& data = out_.turbulence;
        data.dt = table.dt * table.u0 / table.l;
        for (std::size_t i = 0; i < table.chi.size(); ++i) {
            data.chi.push_back(table.chi_star(i));
            data.epsilon.push_back(table.epsilon_star(i));
        }
        data.stationary = table.stationary_index;
        data.c0 = table.c0;
        data.intensity = table.intensity;
        data.cells = table.cells;
        data.loop_begin = table.loop_begin;
        data.loop_end = table.loop_end;
        data.wake = table.wake;
        data.settled = table.settled;
        data.domain = table.domain_lengths;
        data.max_divergence = table.max_divergence;
        if (!table.settled)
            faults_.push_back(
                {FaultId::wake_unsettled, Severity::warning, "turbulence",
                 "The wake neither settled nor became periodic in four passages of the stream.",
                 "None needed: the table ends with its mean over the last half. A higher --intensity settles."});
        return true;
    }

    bool put_body_in_stream(TurbulenceOptions& o) {
        if (!options_.semi_axes) return put_in_stream(mesh_, solid_.axes, solid_.projected_areas, o, faults_);
        const auto [a, b, c] = in_metres(*options_.semi_axes);
        return put_in_stream(ellipsoid_mesh({a, b, c}, {}, 5), Eigen::Matrix3d::Identity(), {b * c, a * c, a * b}, o,
                             faults_);
    }

    BodySize body_size() const {
        BodySize size{solid_.extents.maxCoeff(), "--size", side_, options_.size, out_.mass, out_.u0};
        if (options_.semi_axes) {
            const std::array<double, 3> axes = in_metres(*options_.semi_axes);
            size.option = nullptr;
            size.length = size.side = 2.0 * *std::max_element(axes.begin(), axes.end());
        } else if (options_.card) {
            size.option = "--width";
            size.side = in_metres({options_.card->width, 0.0, 0.0})[0];
        }
        return size;
    }

    bool finish() {
        if (out_.u0 <= 1e-6)
            faults_.push_back({FaultId::parameter_not_denser, Severity::warning, "density",
                               "The body is as dense as its fluid: it has no fall speed, which scales the turbulence.",
                               "None needed if it shall float; else check --density and --fluid."});
        warn_of_size(body_size(), faults_);
        // Replaces -0 by 0 in the report.
        for (double& c : out_.center_of_buoyancy) c += 0.0;
        for (double& c : out_.added_mass) c += 0.0;
        out_.name = asset_name(options_);
        out_.provenance.tool = "lr_bake";
        out_.provenance.tool_version = baker_version();
        out_.provenance.options = canonical_options(options_);
        out_.provenance.input_hash = input_hash(input_, out_.provenance.options);
        const std::size_t before = faults_.size();
        if (check_asset(out_, faults_) && check_plausible(out_, faults_)) return true;
        for (std::size_t i = before; i < faults_.size(); ++i)
            faults_[i].remedy = "A body like this cannot be baked: check the mesh, --unit and --density.";
        return false;
    }

    const BakeOptions& options_;
    AssetData& out_;
    Faults& faults_;
    BakeTimings* timings_;
    const BakeProgress& progress_;
    const char* phase_ = "";
    const BakeHooks& hooks_;
    InputFiles input_;
    double density_, thickness_ = 0.0;     // kg/m^3, m
    bool sheet_, mixed_ = false;           // mixed: solids and sheets, or solids that cross
    BodyParts parts_;                      // mixed: all faces of the solids, also within other solids
    std::size_t solid_faces_ = 0;          // mixed: of mesh_, which has only outer faces
    double side_ = 0.0, size_scale_ = 1.0; // of the bounding box, m; of options.size
    double hull_volume_ = 0.0;             // m^3
    double broad_area_ = 0.0;              // m^2, of the largest silhouette
    Eigen::Vector3d broad_normal_ = Eigen::Vector3d::Zero();
    Stations stations_;
    Mesh mesh_;
    CardReport card_;
    MassProperties solid_;
    Eigen::Vector3d center_ = Eigen::Vector3d::Zero();
};
} // namespace

double units_per_metre(Unit unit) {
    return unit == Unit::cm ? 100.0 : unit == Unit::mm ? 1000.0 : 1.0;
}

const char* unit_name(Unit unit) {
    const char* const names[] = {"m", "cm", "mm", "file"};
    return names[static_cast<std::size_t>(unit)];
}

bool bake(const BakeOptions& options, AssetData& out, Faults& faults, BakeTimings* timings,
          const BakeProgress& progress, const BakeHooks& hooks) {
    return Pipeline(options, out, faults, timings, progress, hooks).run();
}
} // namespace lr::baker
