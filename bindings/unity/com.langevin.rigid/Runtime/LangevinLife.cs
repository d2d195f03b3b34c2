// SPDX-License-Identifier: MIT
using System;
using LangevinRigid;
using UnityEngine;

namespace LangevinUnity
{
    /// <summary>Spawns bodies of a batch, in places and directions of the batch's transform.</summary>
    [Serializable]
    public sealed class LangevinEmitter
    {
        /// <summary>Whether the batch has an emitter.</summary>
        public bool enabled = true;
        /// <summary>The shape in which bodies spawn.</summary>
        public EmitterShape shape = EmitterShape.Box;
        /// <summary>Half extents or semi-axes along the transform's axes, m, times its scale.</summary>
        public Vector3 size = new Vector3(5.0f, 1.0f, 5.0f);
        /// <summary>Initial orientation: random, or that of the transform.</summary>
        public EmitterPose pose = EmitterPose.Random;
        /// <summary>Direction of the initial velocity, in the transform's axes.</summary>
        public Vector3 direction = Vector3.down;
        /// <summary>Half angle of a cone about the direction, degrees.</summary>
        [Range(0.0f, 180.0f)] public float spread = 0.0f;
        /// <summary>Minimum and maximum initial speed, m/s.</summary>
        public Vector2 speed = Vector2.zero;
        /// <summary>Minimum and maximum initial spin, rad/s.</summary>
        public Vector2 spin = new Vector2(0.0f, 5.0f);
        /// <summary>Minimum and maximum scale.</summary>
        public Vector2 scale = Vector2.one;
        /// <summary>Bodies spawned per second.</summary>
        [Min(0.0f)] public float rate = 100.0f;
        /// <summary>Bodies spawned at once in a burst.</summary>
        [Min(0)] public int burstCount = 0;
        /// <summary>Time between bursts, s.</summary>
        [Min(0.0001f)] public float burstInterval = 1.0f;

        internal EmitterDesc ToLibrary(Transform at, MeshMirror mirror)
        {
            EmitterDesc desc = EmitterDesc.Create();
            Vector3 s = at.lossyScale;
            desc.Shape = shape;
            desc.Position = LangevinConversion.ToLibrary(at.position);
            desc.Orientation = LangevinConversion.ToLibrary(at.rotation);
            desc.Size = LangevinConversion.SizeToLibrary(new Vector3(Mathf.Abs(size.x * s.x), Mathf.Abs(size.y * s.y), Mathf.Abs(size.z * s.z)));
            desc.Pose = pose;
            desc.BodyOrientation = LangevinConversion.ToLibrary(at.rotation, mirror);
            desc.Direction = LangevinConversion.ToLibrary(at.rotation * (direction == Vector3.zero ? Vector3.down : direction));
            desc.Spread = spread * Mathf.Deg2Rad;
            desc.SpeedMin = Mathf.Min(speed.x, speed.y);
            desc.SpeedMax = Mathf.Max(speed.x, speed.y);
            desc.SpinMin = Mathf.Min(spin.x, spin.y);
            desc.SpinMax = Mathf.Max(spin.x, spin.y);
            desc.ScaleMin = Mathf.Min(scale.x, scale.y);
            desc.ScaleMax = Mathf.Max(scale.x, scale.y);
            desc.Rate = rate;
            desc.BurstCount = (uint)burstCount;
            desc.BurstInterval = Mathf.Max(burstInterval, 1e-4f);
            return desc;
        }
    }

    /// <summary>A volume in Unity's world. Bodies end inside it, or outside.</summary>
    [Serializable]
    public struct LangevinKillVolume
    {
        /// <summary>Plane: its inside is behind it. Box: along the world's axes.</summary>
        public VolumeShape shape;
        /// <summary>The side on which bodies end.</summary>
        public KillSide side;
        /// <summary>The center of the volume, m.</summary>
        public Vector3 center;
        /// <summary>Half extents of a box, m; x: radius of a sphere; or the normal of a plane.</summary>
        public Vector3 size;
    }

    /// <summary>Rules that end bodies of a batch.</summary>
    [Serializable]
    public sealed unsafe class LangevinRules
    {
        /// <summary>Whether the batch has rules.</summary>
        public bool enabled = false;
        /// <summary>The fate of ended bodies: destroyed, or respawned by the emitter.</summary>
        public EndAction action = EndAction.Respawn;
        /// <summary>Largest age, s; 0: no limit.</summary>
        [Min(0.0f)] public float maximumAge = 0.0f;
        /// <summary>Kill volumes, eight at most.</summary>
        public LangevinKillVolume[] volumes = new LangevinKillVolume[0];

        internal BatchRules ToLibrary()
        {
            BatchRules rules = BatchRules.Create();
            rules.Action = action;
            rules.MaxAge = maximumAge;
            int count = volumes == null ? 0 : volumes.Length;
            if (count > (int)Limits.MaxKillVolumes)
                throw new ArgumentException("A batch has at most " + Limits.MaxKillVolumes + " kill volumes, not " + count + ".");
            rules.VolumeCount = (uint)count;
            KillVolume* first = &rules.Volumes0;
            for (int i = 0; i < count; ++i)
            {
                first[i].Shape = volumes[i].shape;
                first[i].Side = volumes[i].side;
                first[i].Center = LangevinConversion.ToLibrary(volumes[i].center);
                first[i].Size = volumes[i].shape == VolumeShape.Plane ? LangevinConversion.ToLibrary(volumes[i].size)
                                                                      : LangevinConversion.SizeToLibrary(volumes[i].size);
            }
            return rules;
        }
    }
}
