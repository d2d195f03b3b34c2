// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    public static unsafe partial class Native
    {
        /// <summary>Fills a struct with its initial values; <c>BodyDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_body_desc_init(BodyDesc* desc, uint structSize);

        /// <summary>Creates <paramref name="count"/> bodies, all or none.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="descs"><paramref name="count"/> elements.</param>
        /// <param name="count">number of elements</param>
        /// <param name="outIds">receives <paramref name="count"/> ids; may be null. The first <c>user</c> other than 0
        /// allocates 8 bytes for each body of the batch's capacity.</param>
        /// <returns><see cref="Status.Ok"/> (also for count 0), <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StaleBatch"/>, <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>, <see cref="Status.Capacity"/>,
        /// <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_body_create(IntPtr world, BatchId batch, BodyDesc* descs, uint count, BodyId* outIds);

        /// <summary>Destroys <paramref name="count"/> bodies of any batches, all or none: a stale or repeated id fails
        /// the call. Wakes the bodies that lay on them.</summary>
        /// <param name="world">the world</param>
        /// <param name="bodies"><paramref name="count"/> ids of bodies</param>
        /// <param name="count">number of elements</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StaleBody"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_body_destroy(IntPtr world, BodyId* bodies, uint count);

        /// <summary>Returns 1 if the body exists in this world, else 0. Never an error: a null world gives 0, and so
        /// does a call that <see cref="WorldDesc.Checks"/> refuses. Not recorded.</summary>
        /// <param name="world">the world</param>
        /// <param name="body">id of a body</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int lr_body_is_valid(IntPtr world, BodyId body);

        /// <summary>Fills a struct with its initial values; <c>BodyState.Create()</c> does it with the right size.</summary>
        /// <param name="state">state</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_body_state_init(BodyState* state, uint structSize);

        /// <summary>Reads the state of a body.</summary>
        /// <param name="world">the world</param>
        /// <param name="body">id of a body</param>
        /// <param name="state">initialised, or with struct_size set.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBody"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_body_get_state(IntPtr world, BodyId body, BodyState* state);

        /// <summary>Sets everything but the noise seed, and wakes the body. The quaternion is normalised. Limits, also
        /// of <see cref="Native.lr_body_create"/>: positions up to 1e9 m, velocities up to 1e6 m/s and rad/s. To steer
        /// bodies every frame, prefer forces and wind: setting the state bypasses physics.</summary>
        /// <param name="world">the world</param>
        /// <param name="body">id of a body</param>
        /// <param name="state">state</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBody"/>,
        /// <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>, <see cref="Status.InvalidArgument"/>,
        /// <see cref="Status.OutOfMemory"/> (of <c>user</c>, as for <see cref="Native.lr_body_create"/>).</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_body_set_state(IntPtr world, BodyId body, BodyState* state);

        /// <summary>
        /// <para>Puts bodies of any batches to sleep or wakes them, all or none. Bodies may already be in that state,
        /// and ids may repeat. A sleeping body does not move, whatever acts on it, and adds no cost to a step. Its
        /// velocities and pending forces are cleared. It still ages, and its batch's rules still apply: they check
        /// sleeping bodies in every 16th step of the batch. Falling asleep and waking change a body's index in the
        /// view, not its id. Part of snapshots. A batch's first sleeping body allocates up to 25 bytes for each body of
        /// the batch's capacity. A body is woken by</para>
        /// <para>- this function, <see cref="Native.lr_world_wake_box"/> and
        /// <see cref="Native.lr_body_set_state"/>;</para>
        /// <para>- a force, impulse or velocity other than zero (<see cref="Native.lr_body_add_force"/>,
        /// <see cref="Native.lr_batch_add_forces"/>);</para>
        /// <para>- a change by <see cref="Native.lr_batch_set_force"/>, <see cref="Native.lr_world_set_gravity"/> or
        /// <see cref="Native.lr_batch_set_body_contact"/> that concerns it;</para>
        /// <para>- a respawn by its batch's rules;</para>
        /// <para>- contact with colliders or other bodies, and wind: docs/reference/bodies.md.</para>
        /// </summary>
        /// <param name="world">the world</param>
        /// <param name="bodies"><paramref name="count"/> ids of bodies</param>
        /// <param name="count">number of elements</param>
        /// <param name="sleepState"><see cref="SleepState"/>.</param>
        /// <returns><see cref="Status.Ok"/> (also for count 0), <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StaleBody"/>, <see cref="Status.InvalidArgument"/>,
        /// <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_body_set_sleep(IntPtr world, BodyId* bodies, uint count, SleepState sleepState);

        /// <summary>Wakes all sleeping bodies that touch a box, for events that the world does not know about, such as
        /// footsteps and explosions. Each body counts as the cube that contains it in any orientation. The cost depends
        /// on the bodies near the box alone.</summary>
        /// <param name="world">the world</param>
        /// <param name="low">x, y, z of its corners, m, low &lt;= high.</param>
        /// <param name="high">x, y, z of its corners, m, low &lt;= high.</param>
        /// <param name="woken">receives how many; may be null.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_wake_box(IntPtr world, float* low, float* high, uint* woken);
    }
}
