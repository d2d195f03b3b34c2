// Vectors, quaternions and transforms with the engine's conventions. SPDX-License-Identifier: MIT
#pragma once

#include "core.h"

enum EForceInit { ForceInit, ForceInitToZero };
namespace EAxis {
enum Type { None, X, Y, Z };
}

template <typename T> struct TShimVector {
    T X = 0, Y = 0, Z = 0;
    TShimVector() = default;
    explicit TShimVector(T V) : X(V), Y(V), Z(V) {}
    TShimVector(T InX, T InY, T InZ) : X(InX), Y(InY), Z(InZ) {}
    template <typename U>
    requires(!std::is_same_v<T, U>) explicit TShimVector(const TShimVector<U>& V)
        : X(static_cast<T>(V.X)), Y(static_cast<T>(V.Y)), Z(static_cast<T>(V.Z)) {}
    static const TShimVector ZeroVector, OneVector, UpVector;

    TShimVector operator+(const TShimVector& V) const { return {X + V.X, Y + V.Y, Z + V.Z}; }
    TShimVector operator-(const TShimVector& V) const { return {X - V.X, Y - V.Y, Z - V.Z}; }
    TShimVector operator*(const TShimVector& V) const { return {X * V.X, Y * V.Y, Z * V.Z}; }
    TShimVector operator/(const TShimVector& V) const { return {X / V.X, Y / V.Y, Z / V.Z}; }
    TShimVector operator*(T S) const { return {X * S, Y * S, Z * S}; }
    TShimVector operator/(T S) const { return {X / S, Y / S, Z / S}; }
    TShimVector operator-() const { return {-X, -Y, -Z}; }
    TShimVector& operator+=(const TShimVector& V) { return *this = *this + V; }
    bool operator==(const TShimVector& V) const { return X == V.X && Y == V.Y && Z == V.Z; }
    bool Equals(const TShimVector& V, double Tolerance = 1e-4) const {
        return std::abs(X - V.X) <= Tolerance && std::abs(Y - V.Y) <= Tolerance && std::abs(Z - V.Z) <= Tolerance;
    }
    T Size() const { return std::sqrt(X * X + Y * Y + Z * Z); }
    bool IsZero() const { return X == 0 && Y == 0 && Z == 0; }
    TShimVector GetAbs() const { return {std::abs(X), std::abs(Y), std::abs(Z)}; }
    TShimVector GetSafeNormal() const { return Size() < T(1e-4) ? TShimVector() : *this / Size(); }
    static T DotProduct(const TShimVector& A, const TShimVector& B) { return A.X * B.X + A.Y * B.Y + A.Z * B.Z; }
    static TShimVector CrossProduct(const TShimVector& A, const TShimVector& B) {
        return {A.Y * B.Z - A.Z * B.Y, A.Z * B.X - A.X * B.Z, A.X * B.Y - A.Y * B.X};
    }
};
template <typename T> const TShimVector<T> TShimVector<T>::ZeroVector{0, 0, 0};
template <typename T> const TShimVector<T> TShimVector<T>::OneVector{1, 1, 1};
template <typename T> const TShimVector<T> TShimVector<T>::UpVector{0, 0, 1};
using FVector = TShimVector<double>;
using FVector3f = TShimVector<float>;

struct FVector2D {
    double X = 0.0, Y = 0.0;
    FVector2D(double InX, double InY) : X(InX), Y(InY) {}
};

template <typename T> struct TShimQuat {
    T X = 0, Y = 0, Z = 0, W = 1;
    TShimQuat() = default;
    TShimQuat(T InX, T InY, T InZ, T InW) : X(InX), Y(InY), Z(InZ), W(InW) {}
    TShimQuat(const TShimVector<T>& Axis, T Angle)
        : X(Axis.X * std::sin(Angle / 2)), Y(Axis.Y * std::sin(Angle / 2)), Z(Axis.Z * std::sin(Angle / 2)),
          W(std::cos(Angle / 2)) {}
    template <typename U>
    requires(!std::is_same_v<T, U>) explicit TShimQuat(const TShimQuat<U>& Q)
        : X(static_cast<T>(Q.X)), Y(static_cast<T>(Q.Y)), Z(static_cast<T>(Q.Z)), W(static_cast<T>(Q.W)) {}
    static const TShimQuat Identity;

    TShimQuat operator*(const TShimQuat& B) const {
        return {W * B.X + X * B.W + Y * B.Z - Z * B.Y, W * B.Y - X * B.Z + Y * B.W + Z * B.X,
                W * B.Z + X * B.Y - Y * B.X + Z * B.W, W * B.W - X * B.X - Y * B.Y - Z * B.Z};
    }
    TShimQuat Inverse() const { return {-X, -Y, -Z, W}; }
    TShimVector<T> RotateVector(const TShimVector<T>& V) const {
        const TShimVector<T> Q(X, Y, Z);
        const TShimVector<T> U = TShimVector<T>::CrossProduct(Q, V) * T(2);
        return V + U * W + TShimVector<T>::CrossProduct(Q, U);
    }
    bool Equals(const TShimQuat& Q, double Tolerance = 1e-4) const {
        const auto Near = [&](T S) {
            return std::abs(X - S * Q.X) <= Tolerance && std::abs(Y - S * Q.Y) <= Tolerance &&
                   std::abs(Z - S * Q.Z) <= Tolerance && std::abs(W - S * Q.W) <= Tolerance;
        };
        return Near(1) || Near(-1);
    }
};
template <typename T> const TShimQuat<T> TShimQuat<T>::Identity{0, 0, 0, 1};
using FQuat = TShimQuat<double>;
using FQuat4f = TShimQuat<float>;

/** Degrees. */
struct FRotator {
    double Pitch = 0.0, Yaw = 0.0, Roll = 0.0;
    FRotator() = default;
    FRotator(double InPitch, double InYaw, double InRoll) : Pitch(InPitch), Yaw(InYaw), Roll(InRoll) {}
    FQuat Quaternion() const {
        const double Radians = UE_DOUBLE_PI / 180.0;
        // Positive pitch raises X, positive roll lowers Y: about -Y and -X in the algebra of FQuat.
        return FQuat(FVector(0, 0, 1), Yaw * Radians) * FQuat(FVector(0, -1, 0), Pitch * Radians) *
               FQuat(FVector(-1, 0, 0), Roll * Radians);
    }
};

struct FTransform {
    static const FTransform Identity;
    FTransform() = default;
    explicit FTransform(const FVector& InTranslation) : Translation(InTranslation) {}
    FTransform(const FQuat& InRotation, const FVector& InTranslation, const FVector& InScale = FVector::OneVector)
        : Rotation(InRotation), Translation(InTranslation), Scale(InScale) {}
    FTransform(const FRotator& InRotation, const FVector& InTranslation, const FVector& InScale = FVector::OneVector)
        : FTransform(InRotation.Quaternion(), InTranslation, InScale) {}

    FQuat GetRotation() const { return Rotation; }
    FVector GetLocation() const { return Translation; }
    FVector GetScale3D() const { return Scale; }
    void SetLocation(const FVector& V) { Translation = V; }
    void SetRotation(const FQuat& Q) { Rotation = Q; }
    void SetScale3D(const FVector& V) { Scale = V; }
    FVector TransformPosition(const FVector& V) const { return Rotation.RotateVector(V * Scale) + Translation; }
    FVector GetUnitAxis(EAxis::Type Axis) const {
        return Rotation.RotateVector(FVector(Axis == EAxis::X, Axis == EAxis::Y, Axis == EAxis::Z));
    }
    /** A * B: first A, then B. */
    FTransform operator*(const FTransform& Other) const {
        return {Other.Rotation * Rotation, Other.TransformPosition(Translation), Scale * Other.Scale};
    }
    FTransform GetRelativeTransform(const FTransform& Other) const {
        return {Other.Rotation.Inverse() * Rotation,
                Other.Rotation.Inverse().RotateVector(Translation - Other.Translation) / Other.Scale,
                Scale / Other.Scale};
    }
    FTransform Inverse() const { return FTransform().GetRelativeTransform(*this); }
    bool Equals(const FTransform& Other, double Tolerance = 1e-4) const {
        return Rotation.Equals(Other.Rotation, Tolerance) && Translation.Equals(Other.Translation, Tolerance) &&
               Scale.Equals(Other.Scale, Tolerance);
    }

private:
    FQuat Rotation;
    FVector Translation;
    FVector Scale = FVector(1.0, 1.0, 1.0);
};
inline const FTransform FTransform::Identity;

struct FBox {
    FVector Min, Max;
    uint8 IsValid = 0;
    explicit FBox(EForceInit) {}
    FBox(const FVector& InMin, const FVector& InMax) : Min(InMin), Max(InMax), IsValid(1) {}
    FBox& operator+=(const FVector& V) { return *this += FBox(V, V); }
    FBox& operator+=(const FBox& B) {
        if (!B.IsValid) return *this;
        if (!IsValid) return *this = B;
        Min = {std::min(Min.X, B.Min.X), std::min(Min.Y, B.Min.Y), std::min(Min.Z, B.Min.Z)};
        Max = {std::max(Max.X, B.Max.X), std::max(Max.Y, B.Max.Y), std::max(Max.Z, B.Max.Z)};
        return *this;
    }
    FBox ExpandBy(double W) const { return FBox(Min - FVector(W), Max + FVector(W)); }
    FBox TransformBy(const FTransform& Transform) const {
        FBox Out(ForceInit);
        for (int Corner = 0; Corner < 8; ++Corner) {
            Out += Transform.TransformPosition(
                FVector(Corner & 1 ? Max.X : Min.X, Corner & 2 ? Max.Y : Min.Y, Corner & 4 ? Max.Z : Min.Z));
        }
        return Out;
    }
    bool IsInsideOrOn(const FVector& V) const {
        return V.X >= Min.X && V.X <= Max.X && V.Y >= Min.Y && V.Y <= Max.Y && V.Z >= Min.Z && V.Z <= Max.Z;
    }
};

struct FBoxSphereBounds {
    FVector Origin, BoxExtent;
    double SphereRadius = 0.0;
    FBoxSphereBounds() = default;
    explicit FBoxSphereBounds(const FBox& Box)
        : Origin((Box.Min + Box.Max) * 0.5), BoxExtent((Box.Max - Box.Min) * 0.5), SphereRadius(BoxExtent.Size()) {}
    FBox GetBox() const { return FBox(Origin - BoxExtent, Origin + BoxExtent); }
};

struct FLinearColor {
    float R, G, B, A;
    FLinearColor(float InR, float InG, float InB, float InA = 1.0f) : R(InR), G(InG), B(InB), A(InA) {}
};
