// SPDX-License-Identifier: MIT
// The first falling bodies: a few of the paper's leaves, released at different tilts, for two seconds. Prints the same as
// samples/hello.c, bit for bit.
using System;
using System.Globalization;
using LangevinRigid;

static class Hello
{
    const int Bodies = 6;

    static void Main()
    {
        CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;

        // The shape: a thin ellipsoid, 8 cm x 2 cm x 0.1 mm. Closed forms give its mass and added mass. For an asset made by lr_bake:
        // Asset.LoadFile("leaf.lrb").
        EllipsoidDesc shape = EllipsoidDesc.Create();
        shape.SemiAxes = new Double3(0.04, 0.01, 0.00005);
        shape.Density = 800.0;

        // A world with still air, gravity along -y, and a batch: all bodies of one asset.
        WorldDesc desc = WorldDesc.Create();
        desc.Seed = 1;
        using (var world = new World(desc))
        {
            Batch leaves;
            using (Asset leaf = Asset.CreateEllipsoid(shape)) leaves = world.CreateBatch(leaf, Bodies); // the batch keeps its own reference

            // The thin axis (body z) points up, then tilts a little more from leaf to leaf.
            var start = new BodyDesc[Bodies];
            for (int i = 0; i < Bodies; ++i)
            {
                start[i] = BodyDesc.Create();
                start[i].Position = new Float3(0.5f * i, 10.0f, 0.0f);
                start[i].Orientation = new Float4(-1.0f, 0.15f * i, 0.0f, 1.0f);
            }
            BodyId[] bodies = leaves.CreateBodies(start);

            // Two seconds of frames. A renderer would write the transforms into its instance buffer after each.
            var transforms = new float[Bodies * 12];
            for (int frame = 0; frame < 120; ++frame)
            {
                world.Step(1.0f / 60.0f, 4);
                leaves.WriteTransforms(TransformFormat.Matrix3x4RowMajor, transforms);
            }

            Console.WriteLine("leaf  fallen m  aside m  speed down m/s  spin y rad/s");
            for (int i = 0; i < Bodies; ++i)
            {
                BodyState state = world.GetState(bodies[i]);
                Console.WriteLine("{0,4}  {1,8:F3}  {2,7:F3}  {3,14:F3}  {4,12:F2}", i, start[i].Position.Y - state.Position.Y,
                    state.Position.X - start[i].Position.X, -state.LinearVelocity.Y, state.AngularVelocity.Y);
            }
            Console.WriteLine("state {0:x16} after 2 s", world.Hash);
        }
    }
}
