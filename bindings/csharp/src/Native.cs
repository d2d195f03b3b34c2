// SPDX-License-Identifier: MIT
namespace LangevinRigid
{
    /// <summary>The functions of the C library under their own names, with the header's texts. They check nothing and keep nothing alive;
    /// <see cref="World"/>, <see cref="Batch"/> and <see cref="Asset"/> do.</summary>
    public static unsafe partial class Native
    {
        /// <summary>The library's name: the platform adds prefix and extension, or the library is linked into the program.</summary>
#if !UNITY_EDITOR && (UNITY_WEBGL || UNITY_IOS)
        public const string Library = "__Internal";
#else
        public const string Library = "langevin_rigid";
#endif
    }
}
