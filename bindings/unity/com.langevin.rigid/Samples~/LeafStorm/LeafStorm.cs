// SPDX-License-Identifier: MIT
using LangevinUnity;
using UnityEngine;
using UnityEngine.Rendering;

/// <summary>Rolls the ball of the scene LeafStorm, and gives everything a material of the project's render pipeline.</summary>
public sealed class LeafStorm : MonoBehaviour
{
    [SerializeField] private Transform ball = null;

    private float time;

    private void Start()
    {
        RenderPipelineAsset pipeline = GraphicsSettings.currentRenderPipeline;
        if (pipeline == null) return; // the built-in one, for which the scene was made
        foreach (MeshRenderer solid in GetComponentsInChildren<MeshRenderer>()) solid.sharedMaterial = pipeline.defaultMaterial;
        foreach (LangevinBatch leaves in GetComponentsInChildren<LangevinBatch>())
            leaves.Drawing.materials = new[] { new Material(pipeline.defaultMaterial) { enableInstancing = true, color = new Color(0.75f, 0.4f, 0.1f) } };
    }

    private void Update()
    {
        time += Time.deltaTime;
        if (ball != null) ball.position = new Vector3(12.0f * Mathf.Sin(0.5f * time), 0.75f, -8.0f + 4.0f * Mathf.Cos(0.5f * time));
    }
}
