// SPDX-License-Identifier: MIT
#if NETSTANDARD2_1 || NETSTANDARD2_1_OR_GREATER || NETCOREAPP || UNITY_2021_2_OR_NEWER
#define LANGEVIN_SPAN
#endif
using System;

namespace LangevinRigid
{
    /// <summary>A batch's state in the library's memory: arrays with a value per body. Awake bodies come first, then sleeping ones. Valid until
    /// the next call on the world that is not a query; then everything except <see cref="IsCurrent"/> throws. Spans and pointers
    /// taken before are not checked: take them again after each step.</summary>
    public unsafe readonly ref struct BatchData
    {
        private readonly World _world;
        private readonly BatchView _view;
        private readonly ulong _change;

        internal BatchData(World world, BatchView view)
        {
            _world = world;
            _view = view;
            _change = world.ChangeCount;
        }

        /// <summary>Whether the arrays are still valid.</summary>
        public bool IsCurrent { get { return _world != null && !_world.IsDisposed && _change == _world.ChangeCount; } }

        /// <summary>The number of bodies.</summary>
        public int Count { get { return (int)Raw.Count; } }
        /// <summary>Bodies [0, AwakeCount) are awake, the others asleep.</summary>
        public int AwakeCount { get { return (int)Raw.AwakeCount; } }
        /// <summary>Changes whenever sleeping bodies wake, end or change places.</summary>
        public ulong Revision { get { return Raw.Revision; } }

        /// <summary>The pointers. Valid as long as this view.</summary>
        /// <exception cref="InvalidOperationException">The world has changed since.</exception>
        public BatchView Raw
        {
            get
            {
                if (!IsCurrent) ThrowStale();
                return _view;
            }
        }

        /// <summary>Position of a body, m, world frame.</summary>
        public Float3 Position(int index)
        {
            Check(index);
            return new Float3(_view.PositionX[index], _view.PositionY[index], _view.PositionZ[index]);
        }

        /// <summary>Unit quaternion of a body, body to world.</summary>
        public Float4 Orientation(int index)
        {
            Check(index);
            return new Float4(_view.OrientationX[index], _view.OrientationY[index], _view.OrientationZ[index], _view.OrientationW[index]);
        }

        /// <summary>Id of a body.</summary>
        public BodyId Id(int index)
        {
            Check(index);
            return _view.Ids[index];
        }

        private void Check(int index)
        {
            if (!IsCurrent) ThrowStale();
            if ((uint)index >= _view.Count) throw new ArgumentOutOfRangeException("index");
        }

        private static void ThrowStale()
        {
            throw new InvalidOperationException("The view is stale: its world has changed since. Take another one.");
        }

#if LANGEVIN_SPAN
        /// <summary>m, world frame.</summary>
        public ReadOnlySpan<float> PositionX { get { return Span(Raw.PositionX); } }
        /// <summary>m, world frame.</summary>
        public ReadOnlySpan<float> PositionY { get { return Span(Raw.PositionY); } }
        /// <summary>m, world frame.</summary>
        public ReadOnlySpan<float> PositionZ { get { return Span(Raw.PositionZ); } }
        /// <summary>x of the unit quaternion, body to world.</summary>
        public ReadOnlySpan<float> OrientationX { get { return Span(Raw.OrientationX); } }
        /// <summary>y of the unit quaternion, body to world.</summary>
        public ReadOnlySpan<float> OrientationY { get { return Span(Raw.OrientationY); } }
        /// <summary>z of the unit quaternion, body to world.</summary>
        public ReadOnlySpan<float> OrientationZ { get { return Span(Raw.OrientationZ); } }
        /// <summary>w of the unit quaternion, body to world.</summary>
        public ReadOnlySpan<float> OrientationW { get { return Span(Raw.OrientationW); } }
        /// <summary>Uniform scale.</summary>
        public ReadOnlySpan<float> Scale { get { return Span(Raw.Scale); } }
        /// <summary>s; outdated for sleeping bodies.</summary>
        public ReadOnlySpan<float> Age { get { return Span(Raw.Age); } }
        /// <summary>Noise seeds.</summary>
        public ReadOnlySpan<uint> NoiseSeed { get { return new ReadOnlySpan<uint>(Raw.NoiseSeed, Count); } }
        /// <summary>Ids, in the order of all arrays.</summary>
        public ReadOnlySpan<BodyId> Ids { get { return new ReadOnlySpan<BodyId>(Raw.Ids, Count); } }

        private ReadOnlySpan<float> Span(float* first)
        {
            return new ReadOnlySpan<float>(first, Count);
        }
#endif
    }
}
