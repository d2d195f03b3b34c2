// SPDX-License-Identifier: MIT
using System;
using System.IO;
using LangevinRigid;
using UnityEditor.AssetImporters;
using UnityEngine;

namespace LangevinUnity.Editor
{
    /// <summary>Imports .lrb files, which lr_bake makes, as LangevinAsset. A damaged file says in the console what is wrong with it, by the fault
    /// numbers of docs/reference/asset_format.md.</summary>
    [ScriptedImporter(1, "lrb")]
    public sealed class LrbImporter : ScriptedImporter
    {
        [Tooltip("How the drawn mesh lies to the baked one. Z: baked from a Unity mesh by the bake window. X: baked from the FBX or OBJ file.")]
        [SerializeField] private MeshMirror meshMirror = MeshMirror.Z;

        /// <summary>How the drawn mesh lies to the baked one.</summary>
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
