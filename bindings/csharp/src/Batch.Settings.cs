// SPDX-License-Identifier: MIT
using System;

namespace LangevinRigid
{
    public sealed unsafe partial class Batch
    {
        /// <summary>Sets a turbulence table from arrays of equal length; the table's pointers and count are set here.</summary>
        public void SetTurbulenceTable(TurbulenceTable table, float[] chi, float[] epsilon)
        {
            if (chi == null) throw new ArgumentNullException("chi");
            if (epsilon == null) throw new ArgumentNullException("epsilon");
            if (chi.Length != epsilon.Length) throw new ArgumentException("Both arrays have a value for each sample.", "epsilon");
            fixed (float* frequencies = chi)
            fixed (float* rates = epsilon)
            {
                table.Count = (uint)chi.Length;
                table.Chi = frequencies;
                table.Epsilon = rates;
                SetTurbulenceTable(table);
            }
        }

        /// <summary>Reads the turbulence table in use, the one that was set or the asset's; its samples are in the arrays.</summary>
        public TurbulenceTable GetTurbulenceTable(out float[] chi, out float[] epsilon)
        {
            var table = new TurbulenceTable { StructSize = (uint)sizeof(TurbulenceTable) };
            Leave(Native.lr_batch_get_turbulence_table(Enter(), _id, &table, null, null, 0), "lr_batch_get_turbulence_table");
            chi = new float[table.Count];
            epsilon = new float[table.Count];
            fixed (float* frequencies = chi)
            fixed (float* rates = epsilon)
                Leave(Native.lr_batch_get_turbulence_table(Enter(), _id, &table, frequencies, rates, table.Count), "lr_batch_get_turbulence_table");
            return table;
        }

        /// <summary>Reads corners of a box around all bodies; false without bodies.</summary>
        public bool TryGetBounds(out Float3 low, out Float3 high)
        {
            Float3 first = default(Float3), last = default(Float3);
            Leave(Native.lr_batch_get_bounds(Enter(), _id, &first.X, &last.X), "lr_batch_get_bounds");
            low = first;
            high = last;
            return low.X <= high.X;
        }

        /// <summary>Adds forces to bodies in the order of the view, from arrays with a value per body.</summary>
        public void AddForces(ForceArrays arrays)
        {
            Leave(Native.lr_batch_add_forces(EnterChange(), _id, &arrays), "lr_batch_add_forces");
        }

        /// <summary>Adds a force to each body from <paramref name="first"/> on, in the order of the view.</summary>
        public void AddForces(ForceMode mode, Float3[] forces, int first = 0)
        {
            if (forces == null) throw new ArgumentNullException("forces");
            ForceArrays arrays = ForceArrays.Create();
            arrays.Mode = mode;
            arrays.First = Counts.Of(first);
            arrays.Count = (uint)forces.Length;
            arrays.Stride = (uint)sizeof(Float3);
            fixed (Float3* values = forces)
            {
                if (values == null) return;
                arrays.ForceX = &values->X;
                arrays.ForceY = &values->Y;
                arrays.ForceZ = &values->Z;
                AddForces(arrays);
            }
        }

        /// <summary>Reads the rules; false without rules.</summary>
        public bool TryGetRules(out BatchRules rules)
        {
            int present;
            var found = new BatchRules { StructSize = (uint)sizeof(BatchRules) };
            Leave(Native.lr_batch_get_rules(Enter(), _id, &found, &present), "lr_batch_get_rules");
            rules = found;
            return present != 0;
        }

        /// <summary>Reads the emitter; false without an emitter.</summary>
        public bool TryGetEmitter(out EmitterDesc desc)
        {
            int present;
            var found = new EmitterDesc { StructSize = (uint)sizeof(EmitterDesc) };
            Leave(Native.lr_batch_get_emitter(Enter(), _id, &found, &present), "lr_batch_get_emitter");
            desc = found;
            return present != 0;
        }

        /// <summary>Switches contact with the bodies of another batch, or among those of this batch.</summary>
        public void SetBodyContact(Batch other, bool enabled)
        {
            _world.SetBodyContact(this, other, enabled);
        }
    }
}
