// Between the library's frame (metres, right-handed) and Unreal's (centimetres, left-handed, Z up). Plain C++: no engine
// types, so that it is tested with numbers outside the engine.
//
// The library has no up axis of its own. Its world is here Unreal's with y mirrored and lengths over 100, which is also
// what Unreal's FBX and OBJ importers make of a right-handed Z-up mesh file: a mesh that was baked from the same file as
// the one that is drawn needs no further turn. Mirroring turns true vectors (positions, velocities) into (x, -y, z), and
// pseudovectors (spins, torques, rotation axes) into (-x, y, -z).
//
// SPDX-License-Identifier: MIT
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

/** A direction keeps its length. Its own inverse. */
constexpr FVec MirrorDirection(const FVec& V) {
    return {V.X, -V.Y, V.Z};
}

/** Spins in rad/s, rotation axes. Its own inverse. */
constexpr FVec MirrorSpin(const FVec& V) {
    return {-V.X, V.Y, -V.Z};
}

/** Its own inverse: S R S of the mirror S. */
constexpr FRotation MirrorRotation(const FRotation& Q) {
    return {-Q.X, Q.Y, -Q.Z, Q.W};
}

/** Velocities, accelerations and offsets: cm to m. */
constexpr FVec VectorToLangevin(const FVec& V) {
    return {LengthToMetres(V.X), -LengthToMetres(V.Y), LengthToMetres(V.Z)};
}

constexpr FVec VectorToUnreal(const FVec& V) {
    return {LengthToCentimetres(V.X), -LengthToCentimetres(V.Y), LengthToCentimetres(V.Z)};
}

/** Origin: the point of the level, in cm, where the library's world has its own. It keeps the library's floats fine in
    levels that are larger than some kilometres. */
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

/** Planes, capsules and heightfields stand along y in the library and along Z in Unreal: the orientation of such a
    collider, for the rotation of what it is in Unreal. Its own y then points along Unreal's Z, and its own x and z along
    Unreal's X and Y, so that heights in rows of X are in the library's order as they are. */
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

/** Where an instance is drawn, in Unreal's frame: location in cm, rotation, uniform scale. */
struct FPose {
    FVec Location;
    FRotation Rotation;
    double Scale = 1.0;
};

/** Record: position x y z, quaternion x y z w, scale, as lr_batch_write_transforms has them
    (LR_TRANSFORM_POSITION_QUATERNION_SCALE). MeshOrigin: where the drawn mesh has its origin in the body, cm, Unreal's
    axes: minus the centre of mass, which is the body's own. */
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

/** Moves a record on by Seconds with the body's velocity and spin, both in its own frame as in lr_batch_view. For frames
    between fixed steps; angles stay small there. */
inline void AdvanceRecord(float* Record, const FVec& BodyVelocity, const FVec& BodySpin, double Seconds) {
    const FRotation Q{Record[3], Record[4], Record[5], Record[6]};
    const FVec V = Rotate(Q, BodyVelocity);
    Record[0] += static_cast<float>(V.X * Seconds);
    Record[1] += static_cast<float>(V.Y * Seconds);
    Record[2] += static_cast<float>(V.Z * Seconds);
    const double Speed = std::sqrt(BodySpin.X * BodySpin.X + BodySpin.Y * BodySpin.Y + BodySpin.Z * BodySpin.Z);
    if (Speed * Seconds < 1e-9) return;
    const double Angle = 0.5 * Speed * Seconds;
    const double S = std::sin(Angle) / Speed;
    const FRotation Turned = Multiply(Q, {BodySpin.X * S, BodySpin.Y * S, BodySpin.Z * S, std::cos(Angle)});
    Record[3] = static_cast<float>(Turned.X);
    Record[4] = static_cast<float>(Turned.Y);
    Record[5] = static_cast<float>(Turned.Z);
    Record[6] = static_cast<float>(Turned.W);
}
} // namespace LangevinConversion
