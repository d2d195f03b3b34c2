// SPDX-License-Identifier: MIT
using System;
using LangevinUnity;
using NUnit.Framework;
using Unity.Collections;
using UnityEngine;

public sealed class WindTests : Stage
{
    private static WindZone NewWind(Action<WindZone> set)
    {
        var made = new GameObject("wind");
        made.SetActive(false);
        var zone = made.AddComponent<WindZone>();
        zone.windTurbulence = 0.0f;
        zone.windPulseMagnitude = 0.0f;
        set(zone);
        made.AddComponent<LangevinWind>();
        made.SetActive(true);
        return zone;
    }

    [Test]
    public void DirectionalZonesBlowForwardAndAddUp()
    {
        WindZone a = NewWind(z => { z.windMain = 3.0f; });
        Frames(2);
        Near(new Vector3(0.0f, 0.0f, 3.0f), World.SampleWind(new Vector3(5.0f, 1.0f, 2.0f)), 1e-5);
        a.transform.rotation = Quaternion.AngleAxis(90.0f, Vector3.up);
        Frames(2);
        Near(new Vector3(3.0f, 0.0f, 0.0f), World.SampleWind(Vector3.zero), 1e-5);
        WindZone b = NewWind(z => { z.windMain = 2.0f; });
        b.GetComponent<LangevinWind>().SpeedScale = 2.0f;
        Frames(2);
        Near(new Vector3(3.0f, 0.0f, 4.0f), World.SampleWind(Vector3.zero), 1e-5);
        b.gameObject.SetActive(false);
        Frames(2);
        Near(new Vector3(3.0f, 0.0f, 0.0f), World.SampleWind(Vector3.zero), 1e-5);
        a.gameObject.SetActive(false);
        Near(Vector3.zero, World.SampleWind(Vector3.zero), 0.0);
        Silent();
    }

    [Test]
    public void LeavesGoWithTheWind()
    {
        LangevinBatch batch = NewBatch(100, b => b.StartCount = 100);
        NewWind(z => z.windMain = 4.0f);
        Frames(120);
        Bounds all = batch.Instances.BoundsOfAll(0.0f);
        Assert.Greater(all.center.z, 2.0);
    }

    [Test]
    public void PulsesGoUpAndDown()
    {
        WindZone zone = NewWind(z => { z.windMain = 2.0f; z.windPulseMagnitude = 0.5f; z.windPulseFrequency = 0.5f; });
        float least = 100.0f, most = 0.0f;
        for (int i = 0; i < 120; ++i)
        {
            Frames(1);
            float speed = World.SampleWind(Vector3.zero).z;
            least = Math.Min(least, speed);
            most = Math.Max(most, speed);
        }
        Assert.AreEqual(1.0, least, 0.01);
        Assert.AreEqual(3.0, most, 0.01);
        Assert.AreEqual(2.0, zone.windMain, 0.0);
    }

    [Test]
    public void SphericalZonesBlowOutwardToTheirRadius()
    {
        WindZone zone = NewWind(z => { z.mode = WindZoneMode.Spherical; z.radius = 8.0f; z.windMain = 4.0f; z.transform.position = new Vector3(10.0f, 0.0f, 20.0f); });
        Frames(1);
        Near(new Vector3(0.0f, 0.0f, 2.0f), World.SampleWind(new Vector3(10.0f, 0.0f, 24.0f)), 0.05);
        Near(new Vector3(0.0f, 0.0f, -3.0f), World.SampleWind(new Vector3(10.0f, 0.0f, 18.0f)), 0.05);
        Near(new Vector3(-1.0f, 0.0f, 0.0f), World.SampleWind(new Vector3(4.0f, 0.0f, 20.0f)), 0.05);
        Near(Vector3.zero, World.SampleWind(new Vector3(10.0f, 8.5f, 20.0f)), 1e-6);
        zone.transform.position = new Vector3(10.0f, 0.0f, -20.0f);
        Frames(1);
        Near(new Vector3(0.0f, 0.0f, 2.0f), World.SampleWind(new Vector3(10.0f, 0.0f, -16.0f)), 0.05);
        Near(Vector3.zero, World.SampleWind(new Vector3(10.0f, 0.0f, 24.0f)), 1e-6);
        zone.windMain = -4.0f;
        Frames(1);
        Near(new Vector3(0.0f, 0.0f, -2.0f), World.SampleWind(new Vector3(10.0f, 0.0f, -16.0f)), 0.05);
        zone.mode = WindZoneMode.Directional;
        zone.windMain = 1.0f;
        Frames(2);
        Near(new Vector3(0.0f, 0.0f, 1.0f), World.SampleWind(new Vector3(10.0f, 0.0f, -16.0f)), 1e-5);
        Silent();
    }

    [Test]
    public void SphericalPulses()
    {
        NewWind(z => { z.mode = WindZoneMode.Spherical; z.radius = 8.0f; z.windMain = 4.0f; z.windPulseMagnitude = 0.5f; z.windPulseFrequency = 1.0f; });
        float least = 100.0f, most = 0.0f;
        for (int i = 0; i < 90; ++i)
        {
            Frames(1);
            float speed = World.SampleWind(new Vector3(0.0f, 0.0f, 4.0f)).z;
            least = Math.Min(least, speed);
            most = Math.Max(most, speed);
        }
        Assert.AreEqual(1.0, least, 0.1);
        Assert.AreEqual(3.0, most, 0.1);
        Silent();
    }

    [Test]
    public void TurbulenceHasTheStrengthOfTheZone()
    {
        NewWind(z => { z.windMain = 2.0f; z.windTurbulence = 0.5f; });
        Frames(2);
        const int n = 4000;
        var positions = new NativeArray<Vector3>(n, Allocator.Temp);
        var velocities = new NativeArray<Vector3>(n, Allocator.Temp);
        var random = new System.Random(3);
        for (int i = 0; i < n; ++i)
            positions[i] = new Vector3((float)random.NextDouble() * 200.0f, (float)random.NextDouble() * 200.0f, (float)random.NextDouble() * 200.0f);
        World.SampleWind(positions, velocities);
        double mean = 0.0, square = 0.0;
        for (int i = 0; i < n; ++i)
        {
            mean += velocities[i].z / (double)n;
            square += (velocities[i].x * velocities[i].x + velocities[i].y * velocities[i].y) / (2.0 * n);
        }
        Assert.AreEqual(2.0, mean, 0.1);
        Assert.AreEqual(1.0, Math.Sqrt(square), 0.1);
        Near(World.SampleWind(positions[7]), velocities[7], 1e-6);
        positions.Dispose();
        velocities.Dispose();
    }
}
