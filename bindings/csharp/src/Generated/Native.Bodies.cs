// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: change those.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    public static unsafe partial class Native
    {
        /// <summary>Fills a struct with its initial values; <c>BodyDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_body_desc_init(BodyDesc* desc, uint structSize);

        /// <summary>Creates <paramref name="count"/> bodies, all or none.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="descs"><paramref name="count"/> elements.</param>
        /// <param name="count">elements of the arrays</param>
        /// <param name="outIds">receives <paramref name="count"/> ids; may be null.</param>
        /// <returns><see cref="Status.Ok"/> (also for count 0), <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StaleBatch"/>, <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>, <see cref="Status.Capacity"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_body_create(IntPtr world, BatchId batch, BodyDesc* descs, uint count, BodyId* outIds);

        /// <summary>Destroys <paramref name="count"/> bodies of any batches, all or none: if one of them is stale, or
        /// given twice, nothing is destroyed. What lay on them wakes.</summary>
        /// <param name="world">the world</param>
        /// <param name="bodies"><paramref name="count"/> ids of bodies</param>
        /// <param name="count">elements of the arrays</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StaleBody"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_body_destroy(IntPtr world, BodyId* bodies, uint count);

        /// <summary>Fills a struct with its initial values; <c>BodyState.Create()</c> does it with the right size.</summary>
        /// <param name="state">state</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_body_state_init(BodyState* state, uint structSize);

        /// <summary><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBody"/>,
        /// <see cref="Status.StructSize"/>.</summary>
        /// <param name="world">the world</param>
        /// <param name="body">a body's id</param>
        /// <param name="state">state</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBody"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_body_get_state(IntPtr world, BodyId body, BodyState* state);

        /// <summary>Sets everything but the key, and wakes the body. The quaternion is normalised. Positions up to 1e9
        /// m, velocities up to 1e6 m/s and rad/s are taken, here and by <see cref="Native.lr_body_create"/>. For many
        /// bodies a frame, prefer forces and wind: this breaks the physics by design.</summary>
        /// <param name="world">the world</param>
        /// <param name="body">a body's id</param>
        /// <param name="state">state</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBody"/>,
        /// <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_body_set_state(IntPtr world, BodyId body, BodyState* state);

        /// <summary>
        /// <para>Puts bodies of any batches to rest, or wakes them, all or none; some may be so already, or be given
        /// twice. A body at rest does not move, whatever acts on it, and costs a step nothing. Its velocities and the
        /// forces on it end. It wakes</para>
        /// <para>- by this function, <see cref="Native.lr_world_wake_box"/>, and
        /// <see cref="Native.lr_body_set_state"/>,</para>
        /// <para>- by a force, impulse or velocity on it that is not zero (<see cref="Native.lr_body_add_force"/>,
        /// <see cref="Native.lr_batch_add_forces"/>),</para>
        /// <para>- by a change of <see cref="Native.lr_batch_set_force"/>, <see cref="Native.lr_world_set_gravity"/> or
        /// <see cref="Native.lr_batch_set_pair_contact"/>, with all others that it is about,</para>
        /// <para>- when it begins anew by its batch's rules,</para>
        /// <para>- by contact: colliders, wind. docs/reference/bodies.md. It grows older, and the rules of its batch
        /// are for it too: they look at bodies at rest in every 16th step of the batch. Bodies that wake and come to
        /// rest change indices in the view, not ids. Part of snapshots. The first body at rest of a batch takes up to
        /// 25 bytes for each of the batch's capacity.</para>
        /// </summary>
        /// <param name="world">the world</param>
        /// <param name="bodies"><paramref name="count"/> ids of bodies</param>
        /// <param name="count">elements of the arrays</param>
        /// <param name="rest"><see cref="RestState"/>.</param>
        /// <returns><see cref="Status.Ok"/> (also for count 0), <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StaleBody"/>, <see cref="Status.InvalidArgument"/>,
        /// <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_body_set_rest(IntPtr world, BodyId* bodies, uint count, RestState rest);

        /// <summary>Wakes all bodies at rest that reach into a box, each taken to be a cube that it can turn in: for
        /// what the world does not know of, as footsteps and explosions.</summary>
        /// <param name="world">the world</param>
        /// <param name="low">x, y, z of its corners, m, low &lt;= high.</param>
        /// <param name="high">x, y, z of its corners, m, low &lt;= high.</param>
        /// <param name="woken">how many; may be null. It takes time by what lies there, not by what rests
        /// elsewhere.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_wake_box(IntPtr world, float* low, float* high, uint* woken);
    }
}
