// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
namespace LangevinRigid
{
    public sealed unsafe partial class Batch
    {
        /// <summary>Sets the gains of a batch from the next step on. <see cref="Native.lr_batch_set_load_gains"/></summary>
        public void SetLoadGains(LoadGains gains)
        {
            Leave(Native.lr_batch_set_load_gains(EnterChange(), _id, &gains), "lr_batch_set_load_gains");
        }

        /// <summary>Undoes <see cref="SetLoadGains(LoadGains)"/>.</summary>
        public void ResetLoadGains()
        {
            Leave(Native.lr_batch_set_load_gains(EnterChange(), _id, null), "lr_batch_set_load_gains");
        }

        /// <summary>Reads the gains of a batch. <see cref="Native.lr_batch_get_load_gains"/></summary>
        public LoadGains GetLoadGains()
        {
            LoadGains value = new LoadGains { StructSize = (uint)sizeof(LoadGains) };
            Leave(Native.lr_batch_get_load_gains(Enter(), _id, &value), "lr_batch_get_load_gains");
            return value;
        }

        /// <summary>Sets how often a batch is stepped. <see cref="Native.lr_batch_set_rate"/></summary>
        /// <param name="divisor">1 to 1024; default 1.</param>
        public void SetRate(uint divisor)
        {
            Leave(Native.lr_batch_set_rate(EnterChange(), _id, divisor), "lr_batch_set_rate");
        }

        /// <summary>Reads a batch's rate and backlog. <see cref="Native.lr_batch_get_pace"/></summary>
        public BatchPace GetPace()
        {
            BatchPace value = new BatchPace { StructSize = (uint)sizeof(BatchPace) };
            Leave(Native.lr_batch_get_pace(Enter(), _id, &value), "lr_batch_get_pace");
            return value;
        }

        /// <summary>Sets the forces on a batch from the next step on. <see cref="Native.lr_batch_set_force"/></summary>
        public void SetForce(BatchForce force)
        {
            Leave(Native.lr_batch_set_force(EnterChange(), _id, &force), "lr_batch_set_force");
        }

        /// <summary>Undoes <see cref="SetForce(BatchForce)"/>.</summary>
        public void ClearForce()
        {
            Leave(Native.lr_batch_set_force(EnterChange(), _id, null), "lr_batch_set_force");
        }

        /// <summary>Reads the forces on every body of a batch. <see cref="Native.lr_batch_get_force"/></summary>
        public BatchForce GetForce()
        {
            BatchForce value = new BatchForce { StructSize = (uint)sizeof(BatchForce) };
            Leave(Native.lr_batch_get_force(Enter(), _id, &value), "lr_batch_get_force");
            return value;
        }

        /// <summary>Sets how a batch collides from the next step on. <see cref="Native.lr_batch_set_contact"/></summary>
        public void SetContact(BatchContact contact)
        {
            Leave(Native.lr_batch_set_contact(EnterChange(), _id, &contact), "lr_batch_set_contact");
        }

        /// <summary>Undoes <see cref="SetContact(BatchContact)"/>.</summary>
        public void ResetContact()
        {
            Leave(Native.lr_batch_set_contact(EnterChange(), _id, null), "lr_batch_set_contact");
        }

        /// <summary>Reads how a batch collides. <see cref="Native.lr_batch_get_contact"/></summary>
        public BatchContact GetContact()
        {
            BatchContact value = new BatchContact { StructSize = (uint)sizeof(BatchContact) };
            Leave(Native.lr_batch_get_contact(Enter(), _id, &value), "lr_batch_get_contact");
            return value;
        }

        /// <summary>Sets the rules of a batch. <see cref="Native.lr_batch_set_rules"/></summary>
        public void SetRules(BatchRules rules)
        {
            Leave(Native.lr_batch_set_rules(EnterChange(), _id, &rules), "lr_batch_set_rules");
        }

        /// <summary>Undoes <see cref="SetRules(BatchRules)"/>.</summary>
        public void ClearRules()
        {
            Leave(Native.lr_batch_set_rules(EnterChange(), _id, null), "lr_batch_set_rules");
        }

        /// <summary>Sets how a batch treats diverged bodies. <see cref="Native.lr_batch_get_divergence_policy"/></summary>
        public DivergencePolicy DivergencePolicy
        {
            get
            {
                DivergencePolicy value;
                Leave(Native.lr_batch_get_divergence_policy(Enter(), _id, &value), "lr_batch_get_divergence_policy");
                return value;
            }
            set { Leave(Native.lr_batch_set_divergence_policy(EnterChange(), _id, value), "lr_batch_set_divergence_policy"); }
        }

        /// <summary>Sets the emitter of a batch. <see cref="Native.lr_batch_set_emitter"/></summary>
        public void SetEmitter(EmitterDesc desc)
        {
            Leave(Native.lr_batch_set_emitter(EnterChange(), _id, &desc), "lr_batch_set_emitter");
        }

        /// <summary>Undoes <see cref="SetEmitter(EmitterDesc)"/>.</summary>
        public void ClearEmitter()
        {
            Leave(Native.lr_batch_set_emitter(EnterChange(), _id, null), "lr_batch_set_emitter");
        }

        /// <summary>Reads the counts of a batch. <see cref="Native.lr_batch_get_counts"/></summary>
        public BatchCounts GetCounts()
        {
            BatchCounts value = new BatchCounts { StructSize = (uint)sizeof(BatchCounts) };
            Leave(Native.lr_batch_get_counts(Enter(), _id, &value), "lr_batch_get_counts");
            return value;
        }

        /// <summary>Replaces the asset's coefficients of AERODYNAMIC loads for a batch from the next step on.
        /// <see cref="Native.lr_batch_set_aerodynamics"/></summary>
        public void SetAerodynamics(Aerodynamics aerodynamics)
        {
            Leave(Native.lr_batch_set_aerodynamics(EnterChange(), _id, &aerodynamics), "lr_batch_set_aerodynamics");
        }

        /// <summary>Undoes <see cref="SetAerodynamics(Aerodynamics)"/>.</summary>
        public void ResetAerodynamics()
        {
            Leave(Native.lr_batch_set_aerodynamics(EnterChange(), _id, null), "lr_batch_set_aerodynamics");
        }

        /// <summary>Reads a batch's current coefficients. <see cref="Native.lr_batch_get_aerodynamics"/></summary>
        public Aerodynamics GetAerodynamics()
        {
            Aerodynamics value = new Aerodynamics { StructSize = (uint)sizeof(Aerodynamics) };
            Leave(Native.lr_batch_get_aerodynamics(Enter(), _id, &value), "lr_batch_get_aerodynamics");
            return value;
        }

        /// <summary>Replaces the turbulence table of a batch. <see cref="Native.lr_batch_set_turbulence_table"/></summary>
        public void SetTurbulenceTable(TurbulenceTable table)
        {
            Leave(Native.lr_batch_set_turbulence_table(EnterChange(), _id, &table), "lr_batch_set_turbulence_table");
        }

        /// <summary>Undoes <see cref="SetTurbulenceTable(TurbulenceTable)"/>.</summary>
        public void ResetTurbulenceTable()
        {
            Leave(Native.lr_batch_set_turbulence_table(EnterChange(), _id, null), "lr_batch_set_turbulence_table");
        }
    }
}
