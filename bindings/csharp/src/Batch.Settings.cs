// SPDX-License-Identifier: MIT
using System;

namespace LangevinRigid
{
    public sealed unsafe partial class Batch
    {
        /// <summary>Replaces the turbulence table; its arrays are copied.</summary>
        public void SetTurbulenceTable(TurbulenceTable table)
        {
            Leave(Native.lr_batch_set_turbulence_table(EnterChange(), _id, &table), "lr_batch_set_turbulence_table");
        }

        /// <summary>The same with arrays of equal length in place of the table's pointers and count.</summary>
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

        /// <summary>Puts the asset's own table back.</summary>
        public void ResetTurbulenceTable()
        {
            Leave(Native.lr_batch_set_turbulence_table(EnterChange(), _id, null), "lr_batch_set_turbulence_table");
        }

        /// <summary>Coefficients of the loads at present.</summary>
        public Aerodynamics GetAerodynamics()
        {
            var aerodynamics = new Aerodynamics { StructSize = (uint)sizeof(Aerodynamics) };
            Leave(Native.lr_batch_get_aerodynamics(Enter(), _id, &aerodynamics), "lr_batch_get_aerodynamics");
            return aerodynamics;
        }

        /// <summary>Coefficients of the loads in place of the asset's, from the next step on.</summary>
        public void SetAerodynamics(Aerodynamics aerodynamics)
        {
            Leave(Native.lr_batch_set_aerodynamics(EnterChange(), _id, &aerodynamics), "lr_batch_set_aerodynamics");
        }

        /// <summary>Puts the asset's own back.</summary>
        public void ResetAerodynamics()
        {
            Leave(Native.lr_batch_set_aerodynamics(EnterChange(), _id, null), "lr_batch_set_aerodynamics");
        }

        /// <summary>Art control: factors on drag, lift, spin drag and turbulence.</summary>
        public void SetLoadGains(LoadGains gains)
        {
            Leave(Native.lr_batch_set_load_gains(EnterChange(), _id, &gains), "lr_batch_set_load_gains");
        }

        /// <summary>Puts all at 1.</summary>
        public void ResetLoadGains()
        {
            Leave(Native.lr_batch_set_load_gains(EnterChange(), _id, null), "lr_batch_set_load_gains");
        }

        /// <summary>How often the batch is stepped: level of detail. 1: as often as the world.</summary>
        public void SetRate(uint divisor)
        {
            Leave(Native.lr_batch_set_rate(EnterChange(), _id, divisor), "lr_batch_set_rate");
        }

        /// <summary>How it keeps up with its world.</summary>
        public BatchPace GetPace()
        {
            var pace = new BatchPace { StructSize = (uint)sizeof(BatchPace) };
            Leave(Native.lr_batch_get_pace(Enter(), _id, &pace), "lr_batch_get_pace");
            return pace;
        }

        /// <summary>Forces on bodies in the order of the view, from arrays with one value a body.</summary>
        public void AddForces(ForceArrays arrays)
        {
            Leave(Native.lr_batch_add_forces(EnterChange(), _id, &arrays), "lr_batch_add_forces");
        }

        /// <summary>A force for each body from <paramref name="first"/> on, in the order of the view.</summary>
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

        /// <summary>What acts on every body, from the next step on, until changed.</summary>
        public void SetForce(BatchForce force)
        {
            Leave(Native.lr_batch_set_force(EnterChange(), _id, &force), "lr_batch_set_force");
        }

        /// <summary>Ends it.</summary>
        public void ClearForce()
        {
            Leave(Native.lr_batch_set_force(EnterChange(), _id, null), "lr_batch_set_force");
        }

        /// <summary>How bodies meet colliders at present.</summary>
        public BatchContact GetContact()
        {
            var contact = new BatchContact { StructSize = (uint)sizeof(BatchContact) };
            Leave(Native.lr_batch_get_contact(Enter(), _id, &contact), "lr_batch_get_contact");
            return contact;
        }

        /// <summary>How bodies meet colliders, from the next step on.</summary>
        public void SetContact(BatchContact contact)
        {
            Leave(Native.lr_batch_set_contact(EnterChange(), _id, &contact), "lr_batch_set_contact");
        }

        /// <summary>As it was initially.</summary>
        public void ResetContact()
        {
            Leave(Native.lr_batch_set_contact(EnterChange(), _id, null), "lr_batch_set_contact");
        }

        /// <summary>When bodies end.</summary>
        public void SetRules(BatchRules rules)
        {
            Leave(Native.lr_batch_set_rules(EnterChange(), _id, &rules), "lr_batch_set_rules");
        }

        /// <summary>Ends the rules.</summary>
        public void ClearRules()
        {
            Leave(Native.lr_batch_set_rules(EnterChange(), _id, null), "lr_batch_set_rules");
        }

        /// <summary>How bodies are born.</summary>
        public void SetEmitter(EmitterDesc desc)
        {
            Leave(Native.lr_batch_set_emitter(EnterChange(), _id, &desc), "lr_batch_set_emitter");
        }

        /// <summary>Ends the emitter.</summary>
        public void ClearEmitter()
        {
            Leave(Native.lr_batch_set_emitter(EnterChange(), _id, null), "lr_batch_set_emitter");
        }

        /// <summary>What rules and emitter did in the last step; its lists are valid until the next call that is not a query.</summary>
        public BatchEvents GetEvents()
        {
            var events = new BatchEvents { StructSize = (uint)sizeof(BatchEvents) };
            Leave(Native.lr_batch_get_events(Enter(), _id, &events), "lr_batch_get_events");
            return events;
        }

        /// <summary>What becomes of bodies that have left physics.</summary>
        public FaultPolicy FaultPolicy
        {
            get
            {
                FaultPolicy policy;
                Leave(Native.lr_batch_get_fault_policy(Enter(), _id, &policy), "lr_batch_get_fault_policy");
                return policy;
            }
            set { Leave(Native.lr_batch_set_fault_policy(EnterChange(), _id, value), "lr_batch_set_fault_policy"); }
        }

        /// <summary>Whether bodies of this batch and of another, or of this one among themselves, meet each other.</summary>
        public void SetPairContact(Batch other, bool enabled)
        {
            _world.SetPairContact(this, other, enabled);
        }
    }
}
