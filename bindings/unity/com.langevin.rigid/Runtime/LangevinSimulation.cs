// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.IO;
using System.Runtime.InteropServices;
using LangevinRigid;
using Unity.Jobs;
using UnityEngine;

namespace LangevinUnity
{
    /// <summary>A world of the library with the assets that it uses. This class lists all simulations, because a reload of scripts frees
    /// managed objects, but not native memory and worker threads.</summary>
    public sealed unsafe partial class LangevinSimulation : IDisposable
    {
        private static readonly List<LangevinSimulation> Living = new List<LangevinSimulation>();
        // A static field, because native code keeps the pointer as long as a world exists.
        private static readonly LogFn LogThunk = OnLog;

        // The library's message about the last refused call: it logs before it returns.
        private static volatile string lastError;

        private readonly Dictionary<LangevinAsset, IntPtr> assets = new Dictionary<LangevinAsset, IntPtr>();
        private IntPtr world;

        /// <summary>What members have removed: a restored snapshot can have it again.</summary>
        internal readonly HashSet<ColliderId> GoneColliders = new HashSet<ColliderId>();
        internal readonly HashSet<WindSourceId> GoneWinds = new HashSet<WindSourceId>();

        /// <summary>A step that runs as a job.</summary>
        internal JobHandle Stepping;

        /// <summary>The library's lr_world, for calls of LangevinRigid.Native; IntPtr.Zero when disposed.</summary>
        public IntPtr Handle { get { return world; } }

        /// <summary>Whether Dispose was called.</summary>
        public bool IsDisposed { get { return world == IntPtr.Zero; } }

        /// <summary>The number of simulations that are not disposed.</summary>
        public static int LivingCount { get { return Living.Count; } }

        /// <summary>Creates the world.</summary>
        public LangevinSimulation(ulong seed, int workers, Vector3 gravity, float fluidDensity, float fluidViscosity)
        {
            WorldDesc desc = WorldDesc.Create();
            desc.Seed = seed;
            desc.WorkerCount = (uint)Mathf.Clamp(workers, 0, 64);
            desc.Gravity = LangevinConversion.ToLibrary(gravity);
            desc.FluidDensity = fluidDensity;
            desc.FluidViscosity = fluidViscosity;
            desc.Log = Marshal.GetFunctionPointerForDelegate(LogThunk);
            IntPtr created;
            LangevinSimulation.Check(Native.lr_world_create(&desc, &created), "lr_world_create");
            world = created;
            Living.Add(this);
        }

        /// <summary>The library's asset, loaded once and kept until the world is disposed.</summary>
        public IntPtr AssetOf(LangevinAsset asset)
        {
            if (asset == null) throw new ArgumentNullException("asset");
            IntPtr handle;
            if (assets.TryGetValue(asset, out handle)) return handle;
            handle = asset.Load();
            assets.Add(asset, handle);
            return handle;
        }

        internal void RemoveGone()
        {
            foreach (ColliderId gone in GoneColliders)
            {
                ColliderId id = gone;
                if (Native.lr_collider_is_valid(world, id) != 0) Check(Native.lr_collider_destroy(world, &id, 1), "lr_collider_destroy");
            }
            foreach (WindSourceId gone in GoneWinds)
                if (Native.lr_wind_source_is_valid(world, gone) != 0) Check(Native.lr_world_remove_wind(world, gone), "lr_world_remove_wind");
        }

        /// <summary>Information on the world.</summary>
        public WorldInfo Info()
        {
            WorldInfo info = WorldInfo.Create();
            LangevinSimulation.Check(Native.lr_world_get_info(world, &info), "lr_world_get_info");
            return info;
        }

        /// <summary>Destroys the world with its batches and threads, and releases its assets. Further calls do nothing.</summary>
        public void Dispose()
        {
            if (world == IntPtr.Zero) return;
            // DisposeAll comes without the components, which Unity may disable only after it.
            Stepping.Complete();
            Native.lr_world_destroy(world);
            world = IntPtr.Zero;
            try { CloseRecording(); }
            catch (IOException e) { Debug.LogException(e); }
            foreach (IntPtr asset in assets.Values) Native.lr_asset_release(asset);
            assets.Clear();
            Living.Remove(this);
        }

        /// <summary>Throws a LangevinException for a failed status, with the library's message.</summary>
        public static void Check(Status status, string function)
        {
            string detail = lastError;
            lastError = null;
            if (status < Status.Ok) throw new LangevinException(status, function, detail);
        }

        /// <summary>Disposes of all simulations: before scripts are reloaded, and before a play session that keeps old statics.</summary>
        public static void DisposeAll()
        {
            foreach (LangevinSimulation simulation in Living.ToArray()) simulation.Dispose();
        }

        private static string TextOf(byte* text)
        {
            int length = 0;
            while (text[length] != 0) ++length;
            return System.Text.Encoding.UTF8.GetString(text, length);
        }

        // IL2CPP makes native functions only of static methods with this attribute.
        [AOT.MonoPInvokeCallback(typeof(LogFn))]
        private static void OnLog(IntPtr user, LogLevel level, byte* message)
        {
            try
            {
                string text = "Langevin Rigid: " + TextOf(message);
                if (level == LogLevel.Error) lastError = TextOf(message);
                else if (level == LogLevel.Warning) Debug.LogWarning(text);
                else Debug.Log(text);
            }
            catch (Exception)
            {
                // An exception must not reach native code, and there is nowhere to report this one.
            }
        }
    }
}
