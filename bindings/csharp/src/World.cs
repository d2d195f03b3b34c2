// SPDX-License-Identifier: MIT
using System;
using System.Threading;

namespace LangevinRigid
{
    /// <summary>A world of falling bodies. Only one thread at a time can use it: a second thread during a call, or a callback of that call,
    /// gets an <see cref="InvalidOperationException"/>. Different worlds can be used at the same time.
    /// <para>Refused calls throw <see cref="LangevinException"/> and change nothing. An exception of a callback is thrown after the call that it
    /// happened in; if that created something, by the next call that creates nothing, so that no handle is lost.</para></summary>
    public sealed unsafe partial class World : IDisposable
    {
        private const int Idle = 0, InCall = 1, Disposed = 2;

        private readonly WorldHandle _handle;
        private readonly WorldCallbacks _callbacks;
        private readonly EventHandler _atExit;
        private int _state;
        private Thread _exits; // ends the program

        /// <summary>Creates a world with defaults: still air, gravity along -y, all work on the calling thread.</summary>
        public World() : this(WorldDesc.Create(), null)
        {
        }

        /// <summary>Creates a world with the settings of a desc.</summary>
        public World(WorldDesc desc) : this(desc, null)
        {
        }

        /// <summary>Creates a world with the settings of a desc and services of the program, which replace the desc's function pointers; the log is
        /// always the binding's.</summary>
        public World(WorldDesc desc, WorldServices services)
        {
            LangevinLibrary.EnsureLoaded();
            _callbacks = new WorldCallbacks(services ?? new WorldServices());
            if (desc.StructSize == (uint)sizeof(WorldDesc)) _callbacks.Register(ref desc);
            IntPtr world;
            Status status = Native.lr_world_create(&desc, &world);
            if (status == Status.Ok)
            {
                _handle = new WorldHandle(world, _callbacks);
                if (desc.WorkerCount != 0) AppDomain.CurrentDomain.ProcessExit += _atExit = AtExit(new WeakReference<World>(this));
                return;
            }
            _callbacks.Free();
            _callbacks.Rethrow();
            throw new LangevinException(status, "lr_world_create", _callbacks.LastError);
        }

        /// <summary>The native world, for <see cref="Native"/>. Valid while this object is: keep it alive over the call. After a call of
        /// <see cref="Native"/> that is not a query, call <see cref="NoteChange"/>.</summary>
        /// <exception cref="ObjectDisposedException">It was disposed of.</exception>
        public IntPtr Pointer
        {
            get
            {
                if (_handle.IsClosed) throw new ObjectDisposedException("World");
                return _handle.DangerousGetHandle();
            }
        }

        /// <summary>Whether it was disposed of.</summary>
        public bool IsDisposed { get { return Volatile.Read(ref _state) == Disposed; } }

        /// <summary>The number of calls on the world that were not queries. Views are valid while it stays the same: <see
        /// cref="BatchData.IsCurrent"/>.</summary>
        public ulong ChangeCount { get; private set; }

        /// <summary>Invalidates views, after direct calls of <see cref="Native"/>.</summary>
        public void NoteChange()
        {
            ++ChangeCount;
        }

        /// <summary>Destroys the world with all its batches and bodies, and ends its threads.</summary>
        /// <exception cref="InvalidOperationException">A call on it is running: its own callbacks cannot dispose of it.</exception>
        public void Dispose()
        {
            int before = Interlocked.CompareExchange(ref _state, Disposed, Idle);
            if (before == Disposed) return;
            if (before == InCall) throw Busy();
            ++ChangeCount;
            if (_atExit != null) AppDomain.CurrentDomain.ProcessExit -= _atExit;
            _handle.Dispose();
            _callbacks.Rethrow();
        }

        // Mono ends a program only when all threads that have ever called managed code have ended, as workers do by a wind field. So a program
        // that ends without Dispose ends them here. A thread that steps the world meanwhile waits for the end in its next call; the thread that ends the
        // program must not, since handlers after this one can call the world.
        private static EventHandler AtExit(WeakReference<World> ending)
        {
            return (sender, arguments) =>
            {
                World world;
                if (ending.TryGetTarget(out world)) world.EndThreads();
            };
        }

        private void EndThreads()
        {
            Volatile.Write(ref _exits, Thread.CurrentThread);
            for (int tries = 0; tries < 1000; ++tries)
            {
                int before = Interlocked.CompareExchange(ref _state, Disposed, Idle);
                if (before == Idle) _handle.Dispose();
                if (before != InCall) return;
                Thread.Sleep(1);
            }
        }

        /// <summary>Advances all bodies by <paramref name="dt"/> seconds in <paramref name="substeps"/> equal parts. At 60 Hz take 2 for leaves and
        /// paper of a few centimetres, 4 for petals and confetti.</summary>
        /// <exception cref="LangevinException">The step was refused, and not taken. Exception: with <see cref="Status.OutOfMemory"/>
        /// it was taken without some contacts, so do not repeat it.</exception>
        /// <exception cref="Exception">An exception of a callback; the step was taken.</exception>
        public void Step(float dt, int substeps = 2)
        {
            Leave(Native.lr_world_step(EnterChange(), dt, substeps < 0 ? 0u : (uint)substeps), "lr_world_step");
        }

        /// <summary>A hash of all state that determines further motion: equal on every machine after equal calls.</summary>
        public ulong Hash
        {
            get
            {
                ulong hash;
                Leave(Native.lr_world_hash(Enter(), &hash), "lr_world_hash");
                return hash;
            }
        }

        /// <summary>Sets gravity, m/s^2, from the next step on.</summary>
        public void SetGravity(Float3 gravity)
        {
            Leave(Native.lr_world_set_gravity(EnterChange(), &gravity.X), "lr_world_set_gravity");
        }

        /// <summary>Creates a batch of bodies of one asset, with defaults.</summary>
        public Batch CreateBatch(Asset asset, int capacity)
        {
            BatchDesc desc = BatchDesc.Create();
            desc.Capacity = capacity < 0 ? 0u : (uint)capacity;
            return CreateBatch(asset, desc);
        }

        /// <summary>Creates a batch of bodies of one asset, with the settings of a desc.</summary>
        public Batch CreateBatch(Asset asset, BatchDesc desc)
        {
            if (asset == null) throw new ArgumentNullException("asset");
            bool held = false;
            desc.Asset = asset.Hold(ref held);
            try
            {
                BatchId id;
                LeaveNew(Native.lr_batch_create(EnterChange(), &desc, &id), "lr_batch_create");
                return new Batch(this, id, desc.Capacity);
            }
            finally
            {
                asset.Release(held);
            }
        }

        /// <summary>Whether a batch exists; false for a disposed batch and for the null handle.</summary>
        public bool IsValid(BatchId batch)
        {
            int valid = Native.lr_batch_is_valid(Enter(), batch);
            Leave(Status.Ok, "lr_batch_is_valid");
            return valid != 0;
        }

        // Every call of the library goes through Enter and Leave. Nothing may throw between them.

        /// <summary>The native world, for a query.</summary>
        internal IntPtr Enter()
        {
            Thread exits = Volatile.Read(ref _exits);
            if (exits != null && exits != Thread.CurrentThread) Thread.Sleep(Timeout.Infinite);
            int before = Interlocked.CompareExchange(ref _state, InCall, Idle);
            if (before == Disposed) throw new ObjectDisposedException("World");
            if (before == InCall) throw Busy();
            _callbacks.LastError = null;
            return _handle.DangerousGetHandle();
        }

        /// <summary>The native world, for a call that invalidates views.</summary>
        internal IntPtr EnterChange()
        {
            IntPtr world = Enter();
            ++ChangeCount;
            return world;
        }

        internal void Leave(Status status, string function)
        {
            Volatile.Write(ref _state, Idle);
            _callbacks.Rethrow();
            if (status < Status.Ok) throw new LangevinException(status, function, _callbacks.LastError);
        }

        /// <summary>Leaves a call that creates something. An exception of a callback would lose the handle, so the next other call throws
        /// it.</summary>
        internal void LeaveNew(Status status, string function)
        {
            if (status < Status.Ok) Leave(status, function);
            else Volatile.Write(ref _state, Idle);
        }

        private static Exception Busy()
        {
            return new InvalidOperationException("A call on this world is running: on another thread, or the one whose callback this is. " +
                "A world is used by one thread at a time, and not by its own callbacks.");
        }
    }
}
