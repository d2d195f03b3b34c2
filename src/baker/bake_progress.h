// Progress of a whole bake, weighted by the usual time of its phases.
#pragma once

namespace lr::baker {

// Fraction of the whole bake, from a phase and its finished fraction.
double overall_progress(const char* phase, double fraction);
} // namespace lr::baker
