// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.IO;
using System.Runtime.InteropServices;
using LangevinRigid;
using UnityEngine;

namespace LangevinUnity
{
    /// <summary>A world of the library with the assets that it uses. All of them are known to this class, so that none outlives a
    /// reload of scripts: native memory and worker threads stay in the editor's process when managed code goes.</summary>
    public sealed unsafe partial class LangevinSimulation : IDisposable
    {
        private static readonly List<LangevinSimulation> Living = new List<LangevinSimulation>();
        // Held by a static field: native code keeps the pointer as long as there is a world.
        private static readonly LogFn LogThunk = OnLog;

        // What the library said of the call that failed last: it logs before it returns.
        private static volatile string lastError;

        private readonly Dictionary<LangevinAsset, IntPtr> assets = new Dictionary<LangevinAsset, IntPtr>();
        private IntPtr world;

        /// <summary>The library's lr_world, for calls of LangevinRigid.Native; IntPtr.Zero when disposed.</summary>
        public IntPtr Handle { get { return world; } }

        /// <summary>Whether Dispose was called.</summary>
        public bool IsDisposed { get { return world == IntPtr.Zero; } }

        /// <summary>Simulations that were not disposed of.</summary>
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

        /// <summary>The library's asset, loaded once for each world and kept until that goes.</summary>
        public IntPtr AssetOf(LangevinAsset asset)
        {
            if (asset == null) throw new ArgumentNullException("asset");
            IntPtr handle;
            if (assets.TryGetValue(asset, out handle)) return handle;
            handle = asset.Load();
            assets.Add(asset, handle);
            return handle;
        }

        /// <summary>Numbers of the world as it is.</summary>
        public WorldInfo Info()
        {
            WorldInfo info = WorldInfo.Create();
            LangevinSimulation.Check(Native.lr_world_get_info(world, &info), "lr_world_get_info");
            return info;
        }

        /// <summary>Ends the world, its batches and threads, and lets go of its assets. More than once is fine.</summary>
        public void Dispose()
        {
            if (world == IntPtr.Zero) return;
            Native.lr_world_destroy(world);
            world = IntPtr.Zero;
            try { CloseRecording(); }
            catch (IOException e) { Debug.LogException(e); }
            foreach (IntPtr asset in assets.Values) Native.lr_asset_release(asset);
            assets.Clear();
            Living.Remove(this);
        }

        /// <summary>Throws a LangevinException for a status that is an error, with what the library said of it.</summary>
        public static void Check(Status status, string function)
        {
            string detail = lastError;
            lastError = null;
            if (status < Status.Ok) throw new LangevinException(status, function, detail);
        }

        /// <summary>Ends what is left: before scripts are reloaded, and before a play session that keeps the last one's statics.</summary>
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

        // IL2CPP needs a static method with this attribute to make a native function of it.
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
                // An exception must not cross into native code, and there is nowhere left to report this one.
            }
        }
    }
}
