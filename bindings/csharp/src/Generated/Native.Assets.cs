// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: change those.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    public static unsafe partial class Native
    {
        /// <summary>
        /// <para>Reads an asset made by <c>lr_bake</c>, a regular file. It is verified whole before anything of it is
        /// used.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="pathUtf8">UTF-8 on every platform.</param>
        /// <param name="out">receives an asset with one reference, release it with
        /// <see cref="Native.lr_asset_release"/>; null after an error.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.FileNotFound"/>,
        /// <see cref="Status.FileRead"/>, <see cref="Status.AssetFormat"/>, <see cref="Status.AssetVersion"/>,
        /// <see cref="Status.AssetCorrupt"/>, <see cref="Status.AssetInvalid"/>,
        /// <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_asset_load_file(byte* pathUtf8, IntPtr* @out);

        /// <summary>
        /// <para>The same from <paramref name="size"/> bytes in memory, of any alignment, not kept.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="bytes">bytes</param>
        /// <param name="size">bytes</param>
        /// <param name="out">out</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <c>Status.Asset*</c>,
        /// <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_asset_load_memory(void* bytes, ulong size, IntPtr* @out);

        /// <summary>
        /// <para>Says everything that is wrong with asset bytes, by one call of <paramref name="report"/> for each
        /// fault (may be null). Returns what <see cref="Native.lr_asset_load_memory"/> would.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="bytes">bytes</param>
        /// <param name="size">bytes</param>
        /// <param name="report">report</param>
        /// <param name="user">as given along with the function</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_asset_check_memory(void* bytes, ulong size, IntPtr report, IntPtr user);

        /// <summary>
        /// <para>Fills a desc with its initial values.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof(<see cref="EllipsoidDesc"/>) as the caller sees it.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StructSize"/>. The
        /// other _init functions are alike.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_ellipsoid_desc_init(EllipsoidDesc* desc, uint structSize);

        /// <summary>
        /// <para><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StructSize"/>,
        /// <see cref="Status.NotFinite"/>, <see cref="Status.InvalidArgument"/>, <see cref="Status.OutOfMemory"/>.
        /// Source: Lamb, Hydrodynamics, art. 114-115; docs/maintainers/physics.md.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="out">as for <see cref="Native.lr_asset_load_file"/>.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StructSize"/>,
        /// <see cref="Status.NotFinite"/>, <see cref="Status.InvalidArgument"/>, <see cref="Status.OutOfMemory"/>.
        /// Source: Lamb, Hydrodynamics, art. 114-115; docs/maintainers/physics.md.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_asset_create_ellipsoid(EllipsoidDesc* desc, IntPtr* @out);

        /// <summary>
        /// <para>Adds a reference, to be given back by <see cref="Native.lr_asset_release"/>.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="asset">the asset</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_asset_retain(IntPtr asset);

        /// <summary>
        /// <para>Gives a reference back; the last one frees the asset. Batches hold their own. Null is fine.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="asset">the asset</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void lr_asset_release(IntPtr asset);

        /// <summary>Initially the axes are those of the body, <c>length</c> is 1 and all else 0: no loads.</summary>
        /// <param name="aerodynamics">aerodynamics</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_aerodynamics_init(Aerodynamics* aerodynamics, uint structSize);

        /// <summary>Fills a struct with its initial values; <c>RigidDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_rigid_desc_init(RigidDesc* desc, uint structSize);

        /// <summary>
        /// <para><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StructSize"/>,
        /// <see cref="Status.NotFinite"/>, <see cref="Status.InvalidArgument"/> (also matrices that no body has),
        /// <see cref="Status.OutOfMemory"/>.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="out">as for <see cref="Native.lr_asset_load_file"/>.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StructSize"/>,
        /// <see cref="Status.NotFinite"/>, <see cref="Status.InvalidArgument"/> (also matrices that no body has),
        /// <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_asset_create_rigid(RigidDesc* desc, IntPtr* @out);

        /// <summary>Fills a struct with its initial values; <c>AssetInfo.Create()</c> does it with the right size.</summary>
        /// <param name="info">info</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_asset_info_init(AssetInfo* info, uint structSize);

        /// <summary>
        /// <para><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StructSize"/>.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="asset">the asset</param>
        /// <param name="info">initialised by <see cref="Native.lr_asset_info_init"/>, or with struct_size set.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_asset_get_info(IntPtr asset, AssetInfo* info);

        /// <summary>
        /// <para>The coefficients of an asset, as baked.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="asset">the asset</param>
        /// <param name="aerodynamics">initialised by <see cref="Native.lr_aerodynamics_init"/>, or with struct_size
        /// set.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_asset_get_aerodynamics(IntPtr asset, Aerodynamics* aerodynamics);
    }
}
