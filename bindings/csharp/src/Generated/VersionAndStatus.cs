// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    /// <summary><see cref="Status.Ok"/>, or a negative error. Values never change.</summary>
    public enum Status : int
    {
        /// <summary>Success.</summary>
        Ok = 0,
        /// <summary>A required pointer is null.</summary>
        NullArgument = -1,
        /// <summary>Struct_size is of no release, or an unknown tail is not 0: see LR_..._INIT.</summary>
        StructSize = -2,
        /// <summary>A value is out of range.</summary>
        InvalidArgument = -3,
        /// <summary>A number is NaN or infinite.</summary>
        NotFinite = -4,
        /// <summary>Out of memory: the allocator returned null.</summary>
        OutOfMemory = -5,
        /// <summary>The body was destroyed, or never existed.</summary>
        StaleBody = -6,
        /// <summary>The batch was destroyed, or never existed.</summary>
        StaleBatch = -7,
        /// <summary>The batch, or the world's table of batches, is full.</summary>
        Capacity = -8,
        /// <summary>The caller's buffer cannot hold the result.</summary>
        BufferTooSmall = -9,
        /// <summary>No file at that path.</summary>
        FileNotFound = -10,
        /// <summary>The file exists but cannot be read.</summary>
        FileRead = -11,
        /// <summary>Not an asset file: too short, or another kind of file.</summary>
        AssetFormat = -12,
        /// <summary>Made for a newer library.</summary>
        AssetVersion = -13,
        /// <summary>An asset file, but damaged.</summary>
        AssetCorrupt = -14,
        /// <summary>An undamaged asset file with numbers that no body can have.</summary>
        AssetInvalid = -15,
        /// <summary>Not a snapshot, damaged, or of another version.</summary>
        SnapshotFormat = -16,
        /// <summary>The snapshot's world has other batches, capacities or assets.</summary>
        SnapshotMismatch = -17,
        /// <summary>Not available on this processor or in this build.</summary>
        Unsupported = -18,
        /// <summary>The worker threads could not be started.</summary>
        Threads = -19,
        /// <summary>Dt is 0: while paused, do not step.</summary>
        TimestepZero = -20,
        /// <summary>Dt is negative.</summary>
        TimestepNegative = -21,
        /// <summary>Dt is NaN or infinite.</summary>
        TimestepNotFinite = -22,
        /// <summary>Dt / substeps exceeds <see cref="Limits.MaxSubstep"/>.</summary>
        TimestepTooLarge = -23,
        /// <summary>Substeps is 0 or exceeds <see cref="Limits.MaxSubsteps"/>.</summary>
        Substeps = -24,
        /// <summary>A bug in the library: please report it.</summary>
        Internal = -25,
        /// <summary>The wind source was removed, or never existed.</summary>
        StaleWindSource = -26,
        /// <summary>The collider was destroyed, or never existed.</summary>
        StaleCollider = -27,
        /// <summary>Another thread is inside a call on this world: see <see cref="CheckFlags.Threads"/>.</summary>
        ConcurrentUse = -28,
        /// <summary>Called from one of this world's callbacks: see <see cref="CheckFlags.Threads"/>.</summary>
        Reentrant = -29,
    }

    /// <summary>Version of the header behind these sources, and limits of the library.</summary>
    public static class Limits
    {
        /// <summary>Version of the header: major.</summary>
        public const uint VersionMajor = 0;
        /// <summary>Version of the header: minor.</summary>
        public const uint VersionMinor = 2;
        /// <summary>Version of the header: patch.</summary>
        public const uint VersionPatch = 0;
        /// <summary>s: the largest dt / substeps</summary>
        public const float MaxSubstep = 1f;
        /// <summary>the most substeps in one step</summary>
        public const uint MaxSubsteps = 65536u;
        /// <summary>MaxWindSources.</summary>
        public const uint MaxWindSources = 64u;
        /// <summary>of one grid, all frames together</summary>
        public const uint MaxWindSamples = 67108864u;
        /// <summary>MaxWaves.</summary>
        public const uint MaxWaves = 8u;
        /// <summary>in a world, at a time</summary>
        public const uint MaxColliders = 67108864u;
        /// <summary>of one hull</summary>
        public const uint MaxHullVertices = 256u;
        /// <summary>vertices or triangles of one mesh, or heights of one heightfield</summary>
        public const uint MaxColliderVertices = 67108864u;
        /// <summary>MaxKillVolumes.</summary>
        public const uint MaxKillVolumes = 8u;
    }
}
