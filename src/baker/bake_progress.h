// How far a bake has come, by the time that its phases usually take.
#pragma once

namespace lr::baker {

// Of the whole, for a phase and the part of it that is done.
double overall_progress(const char* phase, double fraction);

} // namespace lr::baker
