// SPDX-License-Identifier: MIT
using System;

namespace LangevinRigid
{
    /// <summary>All bodies of one asset in a world. Lives until it or its world is disposed of.</summary>
    public sealed unsafe partial class Batch : IDisposable
    {
        private readonly World _world;
        private readonly BatchId _id;
        private bool _disposed;

        internal Batch(World world, BatchId id, uint capacity)
        {
            _world = world;
            _id = id;
            Capacity = (int)capacity;
        }

        /// <summary>The world of the batch.</summary>
        public World World { get { return _world; } }
        /// <summary>Its handle, for <see cref="Native"/>, rays, events and queries of fields.</summary>
        public BatchId Id { get { return _id; } }
        /// <summary>Largest number of bodies.</summary>
        public int Capacity { get; private set; }
        /// <summary>Whether it was disposed of, or its world was.</summary>
        public bool IsDisposed { get { return _disposed || _world.IsDisposed; } }

        /// <summary>Destroys the batch with all its bodies.</summary>
        public void Dispose()
        {
            if (IsDisposed) return;
            IntPtr world = _world.EnterChange();
            _disposed = true; // first: a callback can throw
            _world.Leave(Native.lr_batch_destroy(world, _id), "lr_batch_destroy");
        }

        /// <summary>Creates a body.</summary>
        public BodyId CreateBody(BodyDesc desc)
        {
            BodyId body;
            CreateBodies(&desc, 1, &body);
            return body;
        }

        /// <summary>Creates bodies, all or none; <paramref name="ids"/> can be null.</summary>
        public void CreateBodies(BodyDesc* descs, int count, BodyId* ids)
        {
            uint number = Counts.Of(count);
            _world.LeaveNew(Native.lr_body_create(EnterChange(), _id, descs, number, ids), "lr_body_create");
        }

        /// <summary>Creates bodies from an array, all or none; returns their ids.</summary>
        public BodyId[] CreateBodies(BodyDesc[] descs)
        {
            if (descs == null) throw new ArgumentNullException("descs");
            var ids = new BodyId[descs.Length];
            fixed (BodyDesc* first = descs)
            fixed (BodyId* to = ids) CreateBodies(first, descs.Length, to);
            return ids;
        }

        /// <summary>Spawns bodies from the emitter now, all or none; returns their ids.</summary>
        public BodyId[] Emit(int count)
        {
            var ids = new BodyId[Counts.Of(count)];
            fixed (BodyId* to = ids) Emit(count, to);
            return ids;
        }

        /// <summary>Spawns bodies from the emitter now, all or none; <paramref name="ids"/> can be null.</summary>
        public void Emit(int count, BodyId* ids)
        {
            uint number = Counts.Of(count);
            _world.LeaveNew(Native.lr_batch_spawn(EnterChange(), _id, number, ids), "lr_batch_spawn");
        }

        /// <summary>Spawns bodies at rest, evenly in a box and turned at random, without an emitter, all or none; returns their
        /// ids.</summary>
        public BodyId[] SpawnBox(Float3 low, Float3 high, int count)
        {
            var ids = new BodyId[Counts.Of(count)];
            fixed (BodyId* to = ids)
                _world.LeaveNew(Native.lr_batch_spawn_box(EnterChange(), _id, &low.X, &high.X, (uint)count, to), "lr_batch_spawn_box");
            return ids;
        }

        /// <summary>The number of bodies.</summary>
        public int Count { get { return (int)RawView().Count; } }

        /// <summary>The number of awake bodies.</summary>
        public int AwakeCount { get { return (int)RawView().AwakeCount; } }

        /// <summary>The state of all bodies, without a copy. It throws once it is no longer valid.</summary>
        public BatchData View()
        {
            BatchView view = RawView();
            return new BatchData(_world, view);
        }

        /// <summary>The library's own view: pointers that are valid until the next call that is not a query.</summary>
        public BatchView RawView()
        {
            var view = new BatchView { StructSize = (uint)sizeof(BatchView) };
            Leave(Native.lr_batch_get_view(Enter(), _id, &view), "lr_batch_get_view");
            return view;
        }

        /// <summary>The size of a contiguous transform, in bytes.</summary>
        public static int SizeOf(TransformFormat format)
        {
            return FloatsOf(format) * 4;
        }

        /// <summary>Writes the transforms of the first <paramref name="count"/> bodies, or of all if there are fewer, in the order of the view;
        /// returns their number. <paramref name="stride"/>: bytes from one transform to the next, 0 for no gaps. For buffers that keep earlier
        /// transforms: docs/reference/bodies.md.</summary>
        public int WriteTransforms(TransformFormat format, void* to, ulong stride, int count)
        {
            uint room = Counts.Of(count), written = 0;
            Leave(Native.lr_batch_write_transforms(Enter(), _id, format, to, stride, room, &written), "lr_batch_write_transforms");
            return (int)written;
        }

        /// <summary>Writes contiguous transforms into an array, as many as fit.</summary>
        public int WriteTransforms(TransformFormat format, float[] to)
        {
            if (to == null) throw new ArgumentNullException("to");
            fixed (float* first = to) return WriteTransforms(format, first, 0, to.Length / FloatsOf(format));
        }

        /// <summary>Writes the velocities of the first <paramref name="count"/> bodies, or of all if there are fewer, in the order of the view;
        /// returns their number. For each body: linear velocity, m/s, and angular velocity, rad/s, world frame, as in <see cref="BodyState"/>.
        /// <paramref name="stride"/>: bytes from one body to the next, 0 for no gaps.</summary>
        public int WriteVelocities(void* to, ulong stride, int count)
        {
            uint room = Counts.Of(count), written = 0;
            Leave(Native.lr_batch_write_velocities(Enter(), _id, to, stride, room, &written), "lr_batch_write_velocities");
            return (int)written;
        }

        /// <summary>Writes velocities into an array, two elements for each body: linear, then angular. As many bodies as fit.</summary>
        public int WriteVelocities(Float3[] to)
        {
            if (to == null) throw new ArgumentNullException("to");
            fixed (Float3* first = to) return WriteVelocities(first, 0, to.Length / 2);
        }

        private static int FloatsOf(TransformFormat format)
        {
            switch (format)
            {
                case TransformFormat.PositionQuaternion: return 7;
                case TransformFormat.PositionQuaternionScale: return 8;
                case TransformFormat.Matrix3x4RowMajor:
                case TransformFormat.Matrix3x4ColumnMajor: return 12;
                case TransformFormat.Matrix4x4RowMajor:
                case TransformFormat.Matrix4x4ColumnMajor: return 16;
                default: throw new ArgumentOutOfRangeException("format");
            }
        }

        internal BatchId IdIn(World world)
        {
            CheckAlive();
            if (world != _world) throw new ArgumentException("The batch is in another world.");
            return _id;
        }

        private IntPtr Enter()
        {
            CheckAlive();
            return _world.Enter();
        }

        private IntPtr EnterChange()
        {
            CheckAlive();
            return _world.EnterChange();
        }

        private void Leave(Status status, string function)
        {
            _world.Leave(status, function);
        }

        private void CheckAlive()
        {
            if (_disposed) throw new ObjectDisposedException("Batch");
        }
    }
}
