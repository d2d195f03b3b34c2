// SPDX-License-Identifier: MIT
using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace LangevinUnity
{
    /// <summary>Ways to draw bodies.</summary>
    public enum LangevinDrawMode
    {
        /// <summary>Draws nothing: your code reads Instances.</summary>
        None = 0,
        /// <summary>Graphics.RenderMeshInstanced, for any render pipeline: a call for each 1023 bodies, with culling by their bounds.</summary>
        Instanced = 1,
        /// <summary>BatchRendererGroup, for URP and HDRP with the SRP Batcher: matrices stay on the GPU, and only those of moving bodies are
        /// sent. Without raw buffers in the graphics API, Instanced replaces it.</summary>
        BatchRendererGroup = 2,
    }

    /// <summary>Settings for drawing a batch.</summary>
    [Serializable]
    public sealed class LangevinDrawSettings
    {
        /// <summary>The way to draw.</summary>
        public LangevinDrawMode mode = LangevinDrawMode.Instanced;
        /// <summary>The mesh that was baked.</summary>
        public Mesh mesh;
        /// <summary>A material for each submesh; the last is used for the rest. Mode Instanced needs "Enable GPU Instancing" on each.</summary>
        public Material[] materials = new Material[0];
        /// <summary>Whether bodies cast shadows.</summary>
        public ShadowCastingMode shadows = ShadowCastingMode.On;
        /// <summary>Whether bodies receive shadows.</summary>
        public bool receiveShadows = true;
        /// <summary>Light probes: Blend Probes or Off.</summary>
        public LightProbeUsage lightProbes = LightProbeUsage.Off;

        /// <summary>The material of a submesh, or null.</summary>
        public Material MaterialOf(int submesh)
        {
            return materials == null || materials.Length == 0 ? null : materials[Math.Min(submesh, materials.Length - 1)];
        }

        /// <summary>Distance from the mesh's origin to its farthest corner, m.</summary>
        public float Reach
        {
            get
            {
                if (mesh == null) return 0.1f;
                Bounds b = mesh.bounds;
                Vector3 a = b.min, c = b.max;
                return new Vector3(Mathf.Max(Mathf.Abs(a.x), Mathf.Abs(c.x)), Mathf.Max(Mathf.Abs(a.y), Mathf.Abs(c.y)),
                    Mathf.Max(Mathf.Abs(a.z), Mathf.Abs(c.z))).magnitude;
            }
        }

        /// <summary>The reason why bodies are not drawn, or null.</summary>
        public string Problem()
        {
            if (mode == LangevinDrawMode.None) return null;
            if (mesh == null) return "No mesh is assigned.";
            for (int i = 0; i < mesh.subMeshCount; ++i)
            {
                Material material = MaterialOf(i);
                if (material == null) return "No material is assigned for submesh " + i + ".";
                if (mode == LangevinDrawMode.Instanced && !material.enableInstancing)
                    return "Material \"" + material.name + "\" needs \"Enable GPU Instancing\" (in its inspector, below).";
            }
            return null;
        }
    }

    /// <summary>Draws by Graphics.RenderMeshInstanced.</summary>
    internal static class LangevinInstancedDrawing
    {
        public static void Draw(LangevinDrawSettings settings, LangevinInstances instances, int layer)
        {
            float reach = settings.Reach;
            for (int submesh = 0; submesh < settings.mesh.subMeshCount; ++submesh)
            {
                var parameters = new RenderParams(settings.MaterialOf(submesh))
                {
                    layer = layer,
                    shadowCastingMode = settings.shadows,
                    receiveShadows = settings.receiveShadows,
                    lightProbeUsage = settings.lightProbes,
                };
                for (int chunk = 0; chunk < instances.ChunkCount; ++chunk)
                {
                    parameters.worldBounds = instances.BoundsOf(chunk, reach);
                    Graphics.RenderMeshInstanced(parameters, settings.mesh, submesh, instances.Matrices, instances.CountOf(chunk),
                        instances.FirstOf(chunk));
                }
            }
        }
    }
}
