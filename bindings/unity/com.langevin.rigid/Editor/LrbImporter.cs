// SPDX-License-Identifier: MIT
using System;
using System.IO;
using LangevinRigid;
using UnityEditor.AssetImporters;
using UnityEngine;

namespace LangevinUnity.Editor
{
    /// <summary>Imports .lrb files, made by lr_bake, as LangevinAsset. For a damaged file the console lists its faults, with the numbers of
    /// docs/reference/asset_format.md.</summary>
    [ScriptedImporter(1, "lrb")]
    public sealed class LrbImporter : ScriptedImporter
    {
        [Tooltip("Axis along which the drawn mesh mirrors the baked mesh. Z: baked from a Unity mesh. X: baked from the FBX or OBJ file.")]
        [SerializeField] private MeshMirror meshMirror = MeshMirror.Z;

        /// <summary>The mirror from the baked to the drawn mesh.</summary>
        public MeshMirror Mirror { get { return meshMirror; } set { meshMirror = value; } }

        /// <inheritdoc/>
        public override void OnImportAsset(AssetImportContext ctx)
        {
            byte[] bytes = File.ReadAllBytes(ctx.assetPath);
            LangevinAsset asset;
            try
            {
                asset = LangevinAsset.FromBytes(bytes, meshMirror);
            }
            catch (LangevinException e)
            {
                ctx.LogImportError(Path.GetFileName(ctx.assetPath) + ": " + e.Message);
                return;
            }
            catch (DllNotFoundException e)
            {
                ctx.LogImportError(e.Message);
                return;
            }
            asset.name = Path.GetFileNameWithoutExtension(ctx.assetPath);
            ctx.AddObjectToAsset("asset", asset);
            ctx.SetMainObject(asset);
        }
    }
}
