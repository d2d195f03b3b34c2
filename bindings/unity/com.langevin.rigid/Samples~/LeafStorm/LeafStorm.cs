// SPDX-License-Identifier: MIT
using LangevinRigid;
using LangevinUnity;
using UnityEngine;

/// <summary>A storm of leaves over a lawn. Add this to an empty GameObject and press Play. The leaf and its mesh are beside this script,
/// which builds the scene.</summary>
public sealed class LeafStorm : MonoBehaviour
{
    public LangevinAsset asset;
    public Mesh mesh;
    public Material material;
    public int count = 20000;
    public float windSpeed = 4.0f;

    private Transform ball;
    private float time;

    private void Start()
    {
        var world = new GameObject("World", typeof(LangevinWorld)).GetComponent<LangevinWorld>();
        world.StepThread = LangevinStepThread.Job;

        Solid(PrimitiveType.Cube, "Lawn", new Vector3(0.0f, -0.5f, 0.0f), new Vector3(60.0f, 1.0f, 60.0f));
        for (int i = 0; i < 5; ++i) Solid(PrimitiveType.Cube, "Crate", new Vector3(i * 4.0f - 8.0f, 0.5f, 3.0f), Vector3.one);
        ball = Solid(PrimitiveType.Sphere, "Ball", new Vector3(0.0f, 0.75f, -8.0f), Vector3.one * 1.5f).transform;

        var wind = new GameObject("Wind", typeof(WindZone));
        var zone = wind.GetComponent<WindZone>();
        zone.windMain = windSpeed;
        zone.windTurbulence = 0.4f;
        zone.windPulseMagnitude = 0.6f;
        zone.windPulseFrequency = 0.1f;
        wind.transform.rotation = Quaternion.AngleAxis(60.0f, Vector3.up);
        wind.AddComponent<LangevinWind>();

        Leaves();
    }

    private static GameObject Solid(PrimitiveType type, string name, Vector3 at, Vector3 size)
    {
        GameObject made = GameObject.CreatePrimitive(type);
        made.name = name;
        made.transform.position = at;
        made.transform.localScale = size;
        made.AddComponent<LangevinCollider>();
        return made;
    }

    private void Leaves()
    {
        var made = new GameObject("Leaves");
        made.SetActive(false);
        var leaves = made.AddComponent<LangevinBatch>();
        leaves.transform.position = new Vector3(0.0f, 12.0f, 0.0f);
        leaves.Asset = asset;
        leaves.Capacity = count;
        leaves.StartCount = count / 2;
        leaves.Emitter.size = new Vector3(25.0f, 4.0f, 25.0f);
        leaves.Emitter.rate = count / 20.0f;
        leaves.Emitter.scale = new Vector2(0.8f, 1.4f);
        leaves.Rules.enabled = true;
        leaves.Rules.action = EndAction.Respawn;
        leaves.Rules.volumes = new[]
        {
            new LangevinKillVolume
            {
                shape = VolumeShape.Box, side = KillSide.Outside, center = new Vector3(0, 10, 0), size = new Vector3(30, 15, 30),
            },
        };
        leaves.Drawing.mesh = mesh;
        leaves.Drawing.materials = new[] { material != null ? material : LeafMaterial() };
        made.SetActive(true);
    }

    private static Material LeafMaterial()
    {
        Shader shader = Shader.Find("Universal Render Pipeline/Lit");
        if (shader == null) shader = Shader.Find("HDRP/Lit");
        if (shader == null) shader = Shader.Find("Standard");
        return new Material(shader) { enableInstancing = true, color = new Color(0.75f, 0.4f, 0.1f) };
    }

    private void Update()
    {
        time += Time.deltaTime;
        ball.position = new Vector3(12.0f * Mathf.Sin(0.5f * time), 0.75f, -8.0f + 4.0f * Mathf.Cos(0.5f * time));
    }

#if UNITY_EDITOR
    // When the component is added: use the assets beside this script.
    private void Reset()
    {
        string folder = System.IO.Path.GetDirectoryName(UnityEditor.AssetDatabase.GetAssetPath(UnityEditor.MonoScript.FromMonoBehaviour(this)));
        asset = UnityEditor.AssetDatabase.LoadAssetAtPath<LangevinAsset>(folder + "/leaf.lrb");
        mesh = UnityEditor.AssetDatabase.LoadAssetAtPath<Mesh>(folder + "/leaf.obj");
    }
#endif
}
