// SPDX-License-Identifier: MIT
using System;
using System.Globalization;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    /// <summary>Short arrays of the C structs. They have no arithmetic: engines have types for that, with the same layout.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Float3 : IEquatable<Float3>
    {
        /// <summary>Element 0.</summary>
        public float X;
        /// <summary>Element 1.</summary>
        public float Y;
        /// <summary>Element 2.</summary>
        public float Z;

        /// <summary>All three.</summary>
        public Float3(float x, float y, float z) { X = x; Y = y; Z = z; }
        /// <inheritdoc/>
        public bool Equals(Float3 other) { return X.Equals(other.X) && Y.Equals(other.Y) && Z.Equals(other.Z); }
        /// <inheritdoc/>
        public override bool Equals(object other) { return other is Float3 && Equals((Float3)other); }
        /// <inheritdoc/>
        public override int GetHashCode() { return (X.GetHashCode() * 31 + Y.GetHashCode()) * 31 + Z.GetHashCode(); }
        /// <inheritdoc/>
        public override string ToString() { return string.Format(CultureInfo.InvariantCulture, "({0}, {1}, {2})", X, Y, Z); }
    }

    /// <summary>A quaternion x, y, z, w.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Float4 : IEquatable<Float4>
    {
        /// <summary>Element 0.</summary>
        public float X;
        /// <summary>Element 1.</summary>
        public float Y;
        /// <summary>Element 2.</summary>
        public float Z;
        /// <summary>Element 3.</summary>
        public float W;

        /// <summary>The identity quaternion.</summary>
        public static Float4 Identity { get { return new Float4(0.0f, 0.0f, 0.0f, 1.0f); } }
        /// <summary>All four.</summary>
        public Float4(float x, float y, float z, float w) { X = x; Y = y; Z = z; W = w; }
        /// <inheritdoc/>
        public bool Equals(Float4 other) { return X.Equals(other.X) && Y.Equals(other.Y) && Z.Equals(other.Z) && W.Equals(other.W); }
        /// <inheritdoc/>
        public override bool Equals(object other) { return other is Float4 && Equals((Float4)other); }
        /// <inheritdoc/>
        public override int GetHashCode()
        {
            return ((X.GetHashCode() * 31 + Y.GetHashCode()) * 31 + Z.GetHashCode()) * 31 + W.GetHashCode();
        }
        /// <inheritdoc/>
        public override string ToString() { return string.Format(CultureInfo.InvariantCulture, "({0}, {1}, {2}, {3})", X, Y, Z, W); }
    }

    /// <summary>Two numbers.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Float2
    {
        /// <summary>Element 0.</summary>
        public float X;
        /// <summary>Element 1.</summary>
        public float Y;

        /// <summary>Both.</summary>
        public Float2(float x, float y) { X = x; Y = y; }
        /// <inheritdoc/>
        public override string ToString() { return string.Format(CultureInfo.InvariantCulture, "({0}, {1})", X, Y); }
    }

    /// <summary>Three numbers in double precision, for assets.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Double3 : IEquatable<Double3>
    {
        /// <summary>Element 0.</summary>
        public double X;
        /// <summary>Element 1.</summary>
        public double Y;
        /// <summary>Element 2.</summary>
        public double Z;

        /// <summary>All three.</summary>
        public Double3(double x, double y, double z) { X = x; Y = y; Z = z; }
        /// <inheritdoc/>
        public bool Equals(Double3 other) { return X.Equals(other.X) && Y.Equals(other.Y) && Z.Equals(other.Z); }
        /// <inheritdoc/>
        public override bool Equals(object other) { return other is Double3 && Equals((Double3)other); }
        /// <inheritdoc/>
        public override int GetHashCode() { return (X.GetHashCode() * 31 + Y.GetHashCode()) * 31 + Z.GetHashCode(); }
        /// <inheritdoc/>
        public override string ToString() { return string.Format(CultureInfo.InvariantCulture, "({0}, {1}, {2})", X, Y, Z); }
    }

    /// <summary>Two counts.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct UInt2
    {
        /// <summary>Element 0.</summary>
        public uint X;
        /// <summary>Element 1.</summary>
        public uint Y;

        /// <summary>Both.</summary>
        public UInt2(uint x, uint y) { X = x; Y = y; }
        /// <inheritdoc/>
        public override string ToString() { return "(" + X + ", " + Y + ")"; }
    }

    /// <summary>Three counts.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct UInt3
    {
        /// <summary>Element 0.</summary>
        public uint X;
        /// <summary>Element 1.</summary>
        public uint Y;
        /// <summary>Element 2.</summary>
        public uint Z;

        /// <summary>All three.</summary>
        public UInt3(uint x, uint y, uint z) { X = x; Y = y; Z = z; }
        /// <inheritdoc/>
        public override string ToString() { return "(" + X + ", " + Y + ", " + Z + ")"; }
    }
}
