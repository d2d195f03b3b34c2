// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
// Converts between the library's frame (metres, right-handed) and Unreal's (centimetres, left-handed, Z up). Plain C++
// without engine types, so that tests can run it outside the engine.
//
// The library has no fixed up axis. Here its world is Unreal's with y mirrored and lengths divided by 100. Unreal's FBX
// and OBJ importers do the same to a right-handed Z-up mesh file, so a mesh baked from the drawn mesh's file needs no
// further rotation. The mirror turns true vectors (positions, velocities) into (x, -y, z), and pseudovectors (spins,
// torques, rotation axes) into (-x, y, -z).
#pragma once

#include <cmath>

namespace LangevinConversion {
struct FVec {
    double X = 0.0, Y = 0.0, Z = 0.0;
};

/** Unit quaternion: rotates vectors by v' = q v q*, the same algebra in both frames. */
struct FRotation {
    double X = 0.0, Y = 0.0, Z = 0.0, W = 1.0;
};

constexpr double CentimetresPerMetre = 100.0;

constexpr double LengthToMetres(double Centimetres) {
    return Centimetres / CentimetresPerMetre;
}

constexpr double LengthToCentimetres(double Metres) {
    return Metres * CentimetresPerMetre;
}

/** Mirrors a direction; its length stays. Its own inverse. */
constexpr FVec MirrorDirection(const FVec& V) {
    return {V.X, -V.Y, V.Z};
}

/** Mirrors a spin (rad/s) or rotation axis. Its own inverse. */
constexpr FVec MirrorSpin(const FVec& V) {
    return {-V.X, V.Y, -V.Z};
}

/** Mirrors a rotation R to S R S, with the mirror S. Its own inverse. */
constexpr FRotation MirrorRotation(const FRotation& Q) {
    return {-Q.X, Q.Y, -Q.Z, Q.W};
}

/** Converts velocities, accelerations and offsets: cm to m. */
constexpr FVec VectorToLangevin(const FVec& V) {
    return {LengthToMetres(V.X), -LengthToMetres(V.Y), LengthToMetres(V.Z)};
}

constexpr FVec VectorToUnreal(const FVec& V) {
    return {LengthToCentimetres(V.X), -LengthToCentimetres(V.Y), LengthToCentimetres(V.Z)};
}

/** Origin: the level's point, in cm, at the origin of the library's world. It keeps single precision accurate in levels of
 * more than a few kilometres. */
constexpr FVec PositionToLangevin(const FVec& P, const FVec& Origin) {
    return VectorToLangevin({P.X - Origin.X, P.Y - Origin.Y, P.Z - Origin.Z});
}

constexpr FVec PositionToUnreal(const FVec& P, const FVec& Origin) {
    const FVec V = VectorToUnreal(P);
    return {V.X + Origin.X, V.Y + Origin.Y, V.Z + Origin.Z};
}

/** Forces are kg cm/s^2 in Unreal and N in the library, torques and moments kg cm^2/s^2 and N m. */
constexpr FVec ForceToLangevin(const FVec& F) {
    return VectorToLangevin(F);
}

constexpr FVec TorqueToLangevin(const FVec& T) {
    constexpr double Scale = CentimetresPerMetre * CentimetresPerMetre;
    const FVec M = MirrorSpin(T);
    return {M.X / Scale, M.Y / Scale, M.Z / Scale};
}

constexpr FRotation Multiply(const FRotation& A, const FRotation& B) {
    return {A.W * B.X + A.X * B.W + A.Y * B.Z - A.Z * B.Y, A.W * B.Y - A.X * B.Z + A.Y * B.W + A.Z * B.X,
            A.W * B.Z + A.X * B.Y - A.Y * B.X + A.Z * B.W, A.W * B.W - A.X * B.X - A.Y * B.Y - A.Z * B.Z};
}

constexpr FVec Rotate(const FRotation& Q, const FVec& V) {
    const FVec T{2.0 * (Q.Y * V.Z - Q.Z * V.Y), 2.0 * (Q.Z * V.X - Q.X * V.Z), 2.0 * (Q.X * V.Y - Q.Y * V.X)};
    return {V.X + Q.W * T.X + Q.Y * T.Z - Q.Z * T.Y, V.Y + Q.W * T.Y + Q.Z * T.X - Q.X * T.Z,
            V.Z + Q.W * T.Z + Q.X * T.Y - Q.Y * T.X};
}

/** Planes, capsules and heightfields stand along y in the library and along Z in Unreal. Gives the orientation of such a
 * collider from its rotation in Unreal: its y points along Unreal's Z, its x and z along Unreal's X and Y. Heights in
 * rows of X are then in the library's order. */
inline FRotation UprightToLangevin(const FRotation& Q) {
    const double Half = std::sqrt(0.5);
    return Multiply(MirrorRotation(Q), {Half, 0.0, 0.0, Half});
}

/** The rotation from the library's y axis to a unit normal, for planes. */
inline FRotation RotationFromYTo(const FVec& Normal) {
    if (Normal.Y < -0.999999) return {1.0, 0.0, 0.0, 0.0};
    const FRotation Q{Normal.Z, 0.0, -Normal.X, 1.0 + Normal.Y};
    const double Length = std::sqrt(Q.X * Q.X + Q.Z * Q.Z + Q.W * Q.W);
    return {Q.X / Length, 0.0, Q.Z / Length, Q.W / Length};
}

/** Pose of an instance in Unreal's frame: location in cm, rotation, uniform scale. */
struct FPose {
    FVec Location;
    FRotation Rotation;
    double Scale = 1.0;
};

/** Record: position x y z, quaternion x y z w, scale, as written by lr_batch_write_transforms with
 * LR_TRANSFORM_POSITION_QUATERNION_SCALE. MeshOrigin: origin of the drawn mesh relative to the body's, which is its centre
 * of mass; cm, Unreal's axes. */
inline FPose InstancePose(const float* Record, const FVec& MeshOrigin, const FVec& Origin) {
    FPose Pose;
    Pose.Rotation = MirrorRotation({Record[3], Record[4], Record[5], Record[6]});
    Pose.Scale = Record[7];
    const FVec Center = PositionToUnreal({Record[0], Record[1], Record[2]}, Origin);
    const FVec Offset =
        Rotate(Pose.Rotation, {MeshOrigin.X * Pose.Scale, MeshOrigin.Y * Pose.Scale, MeshOrigin.Z * Pose.Scale});
    Pose.Location = {Center.X + Offset.X, Center.Y + Offset.Y, Center.Z + Offset.Z};
    return Pose;
}

/** Advances a record by Seconds with the body's Velocities, 6 floats of lr_batch_write_velocities. For frames between fixed
 * steps: angles stay small there. */
inline void AdvanceRecord(float* Record, const float* Velocities, double Seconds) {
    for (int Axis = 0; Axis < 3; ++Axis) Record[Axis] += static_cast<float>(Velocities[Axis] * Seconds);
    const FVec Spin{Velocities[3], Velocities[4], Velocities[5]};
    const double Speed = std::sqrt(Spin.X * Spin.X + Spin.Y * Spin.Y + Spin.Z * Spin.Z);
    if (Speed * std::fabs(Seconds) < 1e-9) return;
    const double Angle = 0.5 * Speed * Seconds;
    const double S = std::sin(Angle) / Speed;
    const FRotation Turned =
        Multiply({Spin.X * S, Spin.Y * S, Spin.Z * S, std::cos(Angle)}, {Record[3], Record[4], Record[5], Record[6]});
    Record[3] = static_cast<float>(Turned.X);
    Record[4] = static_cast<float>(Turned.Y);
    Record[5] = static_cast<float>(Turned.Z);
    Record[6] = static_cast<float>(Turned.W);
}
} // namespace LangevinConversion
