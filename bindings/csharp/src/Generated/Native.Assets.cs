// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    public static unsafe partial class Native
    {
        /// <summary>
        /// <para>Loads an asset made by <c>lr_bake</c> from a regular file. The whole file is verified before any of it
        /// is used.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="pathUtf8">UTF-8 on every platform.</param>
        /// <param name="out">receives the asset with one reference, which <see cref="Native.lr_asset_release"/> gives
        /// back; null after an error.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.FileNotFound"/>,
        /// <see cref="Status.FileRead"/>, <see cref="Status.AssetFormat"/>, <see cref="Status.AssetVersion"/>,
        /// <see cref="Status.AssetCorrupt"/>, <see cref="Status.AssetInvalid"/>,
        /// <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_asset_load_file(byte* pathUtf8, IntPtr* @out);

        /// <summary>
        /// <para>Loads an asset from memory.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="bytes">of any alignment, not kept.</param>
        /// <param name="size">number of bytes</param>
        /// <param name="out">as for <see cref="Native.lr_asset_load_file"/>.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <c>Status.Asset*</c>,
        /// <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_asset_load_memory(void* bytes, ulong size, IntPtr* @out);

        /// <summary>
        /// <para>Checks the bytes of an asset and calls <paramref name="report"/>, which may be null, once for each
        /// fault found. Returns what <see cref="Native.lr_asset_load_memory"/> would.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="bytes">bytes</param>
        /// <param name="size">number of bytes</param>
        /// <param name="report">report</param>
        /// <param name="user">passed to each call of the function</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_asset_check_memory(void* bytes, ulong size, IntPtr report, IntPtr user);

        /// <summary>
        /// <para>Sets the defaults, those of <c>LR_ELLIPSOID_DESC_INIT</c>. All other _init functions work alike.
        /// struct_size: sizeof(<see cref="EllipsoidDesc"/>) in the caller's header.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_ellipsoid_desc_init(EllipsoidDesc* desc, uint structSize);

        /// <summary>
        /// <para>Creates an asset from an ellipsoid. Formulas: Lamb, Hydrodynamics, art. 114-115;
        /// docs/maintainers/physics.md.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="out">as for <see cref="Native.lr_asset_load_file"/>.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StructSize"/>,
        /// <see cref="Status.NotFinite"/>, <see cref="Status.InvalidArgument"/>,
        /// <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_asset_create_ellipsoid(EllipsoidDesc* desc, IntPtr* @out);

        /// <summary>
        /// <para>Adds a reference, which <see cref="Native.lr_asset_release"/> gives back.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="asset">the asset</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_asset_retain(IntPtr asset);

        /// <summary>
        /// <para>Gives back a reference. The last one frees the asset. Each batch holds its own. Null is
        /// allowed.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="asset">the asset</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void lr_asset_release(IntPtr asset);

        /// <summary>Fills a struct with its initial values; <c>AssetInfo.Create()</c> does it with the right size.</summary>
        /// <param name="info">info</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_asset_info_init(AssetInfo* info, uint structSize);

        /// <summary>
        /// <para>Reads an asset's properties.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="asset">the asset</param>
        /// <param name="info">initialised by <see cref="Native.lr_asset_info_init"/>, or with struct_size set.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_asset_get_info(IntPtr asset, AssetInfo* info);
    }
}
