// A card falling in two dimensions: the model of Andersen, Pesavento and Wang (J. Fluid Mech. 541, 2005), integrated in double precision without the
// library, as a reference.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace lr::scorecard {

// Units: semi-chord a; velocity sqrt((rho_s/rho_f - 1) g b) with the semi-thickness b.
struct CardModel {
    double inertia = 1.1; // I* = rho_s b/(rho_f a)
    double ct = 1.2, cr = 3.14159265358979323846, a = 1.4, b = 1.0, mu1 = 0.2, mu2 = 0.2;
};

struct CardState {
    double vx = 0.0, vy = 0.0, w = 0.0; // along the chord, normal to it, spin
    double angle = 0.0;                 // between chord and horizontal
    double x = 0.0, y = 0.0;            // in the world, y up
};

// States every `interval` for `duration`, by RK4 with time step `step`.
std::vector<CardState> fall(const CardModel& model, CardState start, double duration, double interval, double step);

// Means over the second half of a fall.
struct CardMeans {
    double vx = 0.0, vy = 0.0, w = 0.0; // world frame
};
CardMeans means(const std::vector<CardState>& states, double interval);

// The normal of the card, for the classifier; up is +y.
std::vector<Eigen::Vector3d> normals(const std::vector<CardState>& states);
} // namespace lr::scorecard
