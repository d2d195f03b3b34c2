// SPDX-License-Identifier: MIT
using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace LangevinUnity
{
    /// <summary>How bodies are drawn.</summary>
    public enum LangevinDrawMode
    {
        /// <summary>Not at all: you read Instances yourself.</summary>
        None = 0,
        /// <summary>Graphics.RenderMeshInstanced, for any render pipeline: one call for 1023 bodies, culled by their bounds.</summary>
        Instanced = 1,
        /// <summary>BatchRendererGroup, for URP and HDRP with the SRP Batcher: matrices stay on the GPU, and only those of moving bodies
        /// are sent. Where the graphics API has no raw buffers it falls back to Instanced.</summary>
        BatchRendererGroup = 2,
    }

    /// <summary>What is drawn, and how.</summary>
    [Serializable]
    public sealed class LangevinDrawSettings
    {
        /// <summary>How.</summary>
        public LangevinDrawMode mode = LangevinDrawMode.Instanced;
        /// <summary>The mesh that was baked.</summary>
        public Mesh mesh;
        /// <summary>One for each submesh; the last serves what is left. "Enable GPU Instancing" must be on for mode Instanced.</summary>
        public Material[] materials = new Material[0];
        /// <summary>Shadows that they cast.</summary>
        public ShadowCastingMode shadows = ShadowCastingMode.On;
        /// <summary>Shadows that fall on them.</summary>
        public bool receiveShadows = true;
        /// <summary>For light probes: Blend Probes or Off.</summary>
        public LightProbeUsage lightProbes = LightProbeUsage.Off;

        /// <summary>The material of a submesh; null where there is none.</summary>
        public Material MaterialOf(int submesh)
        {
            return materials == null || materials.Length == 0 ? null : materials[Math.Min(submesh, materials.Length - 1)];
        }

        /// <summary>m, from the mesh's origin to its farthest corner.</summary>
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

        /// <summary>What keeps it from being drawn; null if nothing does.</summary>
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
