// SPDX-License-Identifier: MIT
namespace LangevinRigid
{
    /// <summary>The functions of the C library under their own names, with the header's words on each. Nothing is checked or kept alive
    /// for the caller here; <see cref="World"/>, <see cref="Batch"/> and <see cref="Asset"/> do that.</summary>
    public static unsafe partial class Native
    {
        /// <summary>The library's name: with prefix and extension as the platform has them, or linked into the program.</summary>
#if !UNITY_EDITOR && (UNITY_WEBGL || UNITY_IOS)
        public const string Library = "__Internal";
#else
        public const string Library = "langevin_rigid";
#endif
    }
}
