// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using Unity.Collections;

namespace UnityEngine
{
    public class Texture : Object { }

    public class Shader : Object
    {
        private static readonly List<string> Names = new List<string>();
        public static int PropertyToID(string name)
        {
            if (!Names.Contains(name)) Names.Add(name);
            return Names.IndexOf(name);
        }
        public static Shader Find(string name) { return new Shader { name = name }; }
    }

    public class Material : Object
    {
        public Material(Shader shader) { this.shader = shader; name = "material"; }
        public Material(Material source) : this(source.shader) { }
        public Shader shader { get; set; }
        public bool enableInstancing { get; set; }
        public Color color { get; set; }
        public bool HasProperty(string name) { return true; }
        public void SetFloat(string name, float value) { }
    }

    public class MeshRenderer : Component { public Material sharedMaterial { get; set; } }

    public class Mesh : Object
    {
        private Vector3[] points = new Vector3[0];
        private int[] corners = new int[0];
        private bool readable = true;
        public bool isReadable { get { return readable; } }
        public void UploadMeshData(bool markNoLongerReadable) { readable = !markNoLongerReadable; }
        public Vector3[] vertices { get { return (Vector3[])points.Clone(); } set { points = value; } }
        public int[] triangles { get { return (int[])corners.Clone(); } set { corners = value; } }
        public int vertexCount { get { return points.Length; } }
        public int subMeshCount { get; set; }
        public Bounds bounds { get; set; }
        public Mesh() { subMeshCount = 1; name = "mesh"; }
        public void RecalculateNormals() { }
        public void RecalculateBounds()
        {
            var box = new Bounds();
            for (int i = 0; i < points.Length; ++i)
            {
                var point = new Bounds(points[i], Vector3.zero);
                if (i == 0) box = point;
                else box.Encapsulate(point);
            }
            bounds = box;
        }
    }

    public class Camera : Behaviour { }

    public static class SystemInfo { public static int processorCount { get { return 4; } } }

    public enum MotionVectorGenerationMode { Camera, Object, ForceNoMotion }

    public struct RenderParams
    {
        public RenderParams(Material mat) : this() { material = mat; renderingLayerMask = uint.MaxValue; }
        public int layer { get; set; }
        public uint renderingLayerMask { get; set; }
        public Bounds worldBounds { get; set; }
        public Material material { get; set; }
        public Rendering.ShadowCastingMode shadowCastingMode { get; set; }
        public bool receiveShadows { get; set; }
        public Rendering.LightProbeUsage lightProbeUsage { get; set; }
    }

    public static class Graphics
    {
        public sealed class Call
        {
            public RenderParams Parameters;
            public Mesh Mesh;
            public int Submesh;
            public Matrix4x4[] Instances;
        }

        public static readonly List<Call> Calls = new List<Call>();

        // Refuses the same arguments as the engine.
        public static void RenderMeshInstanced<T>(in RenderParams rparams, Mesh mesh, int submeshIndex, NativeArray<T> instanceData,
            int instanceCount = -1, int startInstance = 0) where T : struct
        {
            if (!rparams.material.enableInstancing) throw new InvalidOperationException("Material needs to enable instancing for use with RenderMeshInstanced.");
            if (mesh == null) throw new ArgumentNullException("mesh");
            if (submeshIndex >= mesh.subMeshCount) throw new ArgumentOutOfRangeException("submeshIndex");
            int count = instanceCount == -1 ? instanceData.Length : instanceCount;
            if (count > 1023) throw new InvalidOperationException("Instance count cannot exceed 1023.");
            if (startInstance + count > instanceData.Length) throw new ArgumentOutOfRangeException("instanceCount");
            var matrices = (NativeArray<Matrix4x4>)(object)instanceData;
            var call = new Call { Parameters = rparams, Mesh = mesh, Submesh = submeshIndex, Instances = new Matrix4x4[count] };
            for (int i = 0; i < count; ++i) call.Instances[i] = matrices[startInstance + i];
            Calls.Add(call);
        }
    }

    public struct GraphicsBufferHandle { public uint value; }

    public sealed class GraphicsBuffer : IDisposable
    {
        [Flags]
        public enum Target { Vertex = 1, Index = 2, CopySource = 4, CopyDestination = 8, Structured = 16, Raw = 32 }

        public static int Living;
        public static GraphicsBuffer Last;
        public float[] Floats;
        public int Sent;
        private bool gone;

        public GraphicsBuffer(Target target, int count, int stride)
        {
            if (target == Target.Raw && stride != 4) throw new ArgumentException("The raw buffer's stride must be 4");
            Floats = new float[count * stride / 4];
            ++Living;
            Last = this;
        }

        public GraphicsBufferHandle bufferHandle { get { return new GraphicsBufferHandle { value = 1 }; } }

        public void SetData<T>(NativeArray<T> data, int nativeBufferStartIndex, int graphicsBufferStartIndex, int count) where T : struct
        {
            if (gone) throw new ObjectDisposedException("GraphicsBuffer");
            var floats = (NativeArray<float>)(object)data;
            for (int i = 0; i < count; ++i) Floats[graphicsBufferStartIndex + i] = floats[nativeBufferStartIndex + i];
            Sent += count;
        }

        public void Dispose() { if (!gone) --Living; gone = true; }
    }
}

namespace UnityEngine.Rendering
{
    public class RenderPipelineAsset : ScriptableObject { public Material defaultMaterial { get; set; } }

    // Its setter is the shim's.
    public sealed class GraphicsSettings { public static RenderPipelineAsset currentRenderPipeline { get; set; } }

    public enum ShadowCastingMode { Off, On, TwoSided, ShadowsOnly }
    public enum LightProbeUsage { Off = 0, BlendProbes = 1, UseProxyVolume = 2, CustomProvided = 4 }
    public enum BatchBufferTarget { UnsupportedByUnderlyingGraphicsApi = -1, Unknown = 0, RawBuffer = 1, ConstantBuffer = 2 }
    public enum BatchCullingViewType { Unknown, Camera, Light, Picking, SelectionOutline, Filtering }
    [Flags] public enum BatchDrawCommandFlags { None = 0, FlipWinding = 1, HasMotion = 2 }

    public struct BatchID { public uint value; }
    public struct BatchMeshID { public uint value; }
    public struct BatchMaterialID { public uint value; }
    public struct MetadataValue { public int NameID; public uint Value; }

    public struct BatchDrawCommand
    {
        public uint visibleOffset;
        public uint visibleCount;
        public BatchID batchID;
        public BatchMaterialID materialID;
        public BatchMeshID meshID;
        public ushort submeshIndex;
        public ushort splitVisibilityMask;
        public BatchDrawCommandFlags flags;
        public int sortingPosition;
    }

    public struct BatchFilterSettings
    {
        public uint renderingLayerMask;
        public byte layer;
        private byte motion, shadow, receive;
        public MotionVectorGenerationMode motionMode { get { return (MotionVectorGenerationMode)motion; } set { motion = (byte)value; } }
        public ShadowCastingMode shadowCastingMode { get { return (ShadowCastingMode)shadow; } set { shadow = (byte)value; } }
        public bool receiveShadows { get { return receive != 0; } set { receive = value ? (byte)1 : (byte)0; } }
    }

    public struct BatchDrawRange
    {
        public uint drawCommandsBegin;
        public uint drawCommandsCount;
        public BatchFilterSettings filterSettings;
    }

    public unsafe struct BatchCullingOutputDrawCommands
    {
        public BatchDrawCommand* drawCommands;
        public int* visibleInstances;
        public BatchDrawRange* drawRanges;
        public float* instanceSortingPositions;
        public int* drawCommandPickingInstanceIDs;
        public int drawCommandCount;
        public int visibleInstanceCount;
        public int drawRangeCount;
        public int instanceSortingPositionFloatCount;
    }

    public struct BatchCullingContext
    {
        public NativeArray<Plane> cullingPlanes;
        public BatchCullingViewType viewType;
    }

    public struct BatchCullingOutput { public NativeArray<BatchCullingOutputDrawCommands> drawCommands; }

    public class BatchRendererGroup : IDisposable
    {
        public delegate Unity.Jobs.JobHandle OnPerformCulling(BatchRendererGroup rendererGroup, BatchCullingContext cullingContext,
            BatchCullingOutput cullingOutput, IntPtr userContext);

        public static int Living;
        public static BatchRendererGroup Last;
        public static BatchBufferTarget Target = BatchBufferTarget.RawBuffer;
        public readonly OnPerformCulling Cull;
        public MetadataValue[] Metadata;
        public Bounds GlobalBounds;
        private uint next;
        private int registered;

        public BatchRendererGroup(OnPerformCulling cullingCallback, IntPtr userContext) { Cull = cullingCallback; ++Living; Last = this; }
        public static BatchBufferTarget BufferTarget { get { return Target; } }
        public BatchMeshID RegisterMesh(Mesh mesh) { ++registered; return new BatchMeshID { value = ++next }; }
        public void UnregisterMesh(BatchMeshID mesh) { --registered; }
        public BatchMaterialID RegisterMaterial(Material material) { ++registered; return new BatchMaterialID { value = ++next }; }
        public void UnregisterMaterial(BatchMaterialID material) { --registered; }
        public BatchID AddBatch(NativeArray<MetadataValue> batchMetadata, GraphicsBufferHandle buffer)
        {
            ++registered;
            Metadata = new MetadataValue[batchMetadata.Length];
            for (int i = 0; i < Metadata.Length; ++i) Metadata[i] = batchMetadata[i];
            return new BatchID { value = ++next };
        }
        public void RemoveBatch(BatchID batchID) { --registered; }
        public void SetGlobalBounds(Bounds bounds) { GlobalBounds = bounds; }
        public void Dispose()
        {
            if (registered != 0) throw new InvalidOperationException(registered + " things are still registered");
            --Living;
        }
    }
}
