// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
namespace LangevinRigid
{
    public sealed unsafe partial class World
    {
        /// <summary>Adds gusts.</summary>
        public WindSourceId AddGusts(GustsDesc desc)
        {
            WindSourceId source;
            LeaveNew(Native.lr_world_add_gusts(EnterChange(), &desc, &source), "lr_world_add_gusts");
            return source;
        }

        /// <summary>Replaces all values of gusts.</summary>
        public void UpdateGusts(WindSourceId source, GustsDesc desc)
        {
            Leave(Native.lr_world_update_gusts(EnterChange(), source, &desc), "lr_world_update_gusts");
        }

        /// <summary>Reads gusts as last set.</summary>
        public GustsDesc GetGusts(WindSourceId source)
        {
            GustsDesc desc = GustsDesc.Create();
            Leave(Native.lr_world_get_gusts(Enter(), source, &desc), "lr_world_get_gusts");
            return desc;
        }

        /// <summary>Adds a vortex.</summary>
        public WindSourceId AddVortex(VortexDesc desc)
        {
            WindSourceId source;
            LeaveNew(Native.lr_world_add_vortex(EnterChange(), &desc, &source), "lr_world_add_vortex");
            return source;
        }

        /// <summary>Replaces all values of a vortex.</summary>
        public void UpdateVortex(WindSourceId source, VortexDesc desc)
        {
            Leave(Native.lr_world_update_vortex(EnterChange(), source, &desc), "lr_world_update_vortex");
        }

        /// <summary>Reads a vortex as last set.</summary>
        public VortexDesc GetVortex(WindSourceId source)
        {
            VortexDesc desc = VortexDesc.Create();
            Leave(Native.lr_world_get_vortex(Enter(), source, &desc), "lr_world_get_vortex");
            return desc;
        }

        /// <summary>Adds a blower.</summary>
        public WindSourceId AddBlower(BlowerDesc desc)
        {
            WindSourceId source;
            LeaveNew(Native.lr_world_add_blower(EnterChange(), &desc, &source), "lr_world_add_blower");
            return source;
        }

        /// <summary>Replaces all values of a blower.</summary>
        public void UpdateBlower(WindSourceId source, BlowerDesc desc)
        {
            Leave(Native.lr_world_update_blower(EnterChange(), source, &desc), "lr_world_update_blower");
        }

        /// <summary>Reads a blower as last set.</summary>
        public BlowerDesc GetBlower(WindSourceId source)
        {
            BlowerDesc desc = BlowerDesc.Create();
            Leave(Native.lr_world_get_blower(Enter(), source, &desc), "lr_world_get_blower");
            return desc;
        }

        /// <summary>Adds turbulence.</summary>
        public WindSourceId AddTurbulence(TurbulenceDesc desc)
        {
            WindSourceId source;
            LeaveNew(Native.lr_world_add_turbulence(EnterChange(), &desc, &source), "lr_world_add_turbulence");
            return source;
        }

        /// <summary>Replaces all values of turbulence.</summary>
        public void UpdateTurbulence(WindSourceId source, TurbulenceDesc desc)
        {
            Leave(Native.lr_world_update_turbulence(EnterChange(), source, &desc), "lr_world_update_turbulence");
        }

        /// <summary>Reads turbulence as last set.</summary>
        public TurbulenceDesc GetTurbulence(WindSourceId source)
        {
            TurbulenceDesc desc = TurbulenceDesc.Create();
            Leave(Native.lr_world_get_turbulence(Enter(), source, &desc), "lr_world_get_turbulence");
            return desc;
        }

        /// <summary>Adds a grid.</summary>
        public WindSourceId AddWindGrid(WindGridDesc desc)
        {
            WindSourceId source;
            LeaveNew(Native.lr_world_add_wind_grid(EnterChange(), &desc, &source), "lr_world_add_wind_grid");
            return source;
        }

        /// <summary>Replaces all values of a grid.</summary>
        public void UpdateWindGrid(WindSourceId source, WindGridDesc desc)
        {
            Leave(Native.lr_world_update_wind_grid(EnterChange(), source, &desc), "lr_world_update_wind_grid");
        }

        /// <summary>Reads a grid as last set.</summary>
        public WindGridDesc GetWindGrid(WindSourceId source)
        {
            WindGridDesc desc = WindGridDesc.Create();
            Leave(Native.lr_world_get_wind_grid(Enter(), source, &desc), "lr_world_get_wind_grid");
            return desc;
        }

        /// <summary>Adds the wind over a ground.</summary>
        public WindSourceId AddGroundWind(GroundWindDesc desc)
        {
            WindSourceId source;
            LeaveNew(Native.lr_world_add_ground_wind(EnterChange(), &desc, &source), "lr_world_add_ground_wind");
            return source;
        }

        /// <summary>Replaces all values of the wind over a ground.</summary>
        public void UpdateGroundWind(WindSourceId source, GroundWindDesc desc)
        {
            Leave(Native.lr_world_update_ground_wind(EnterChange(), source, &desc), "lr_world_update_ground_wind");
        }

        /// <summary>Reads the wind over a ground as last set.</summary>
        public GroundWindDesc GetGroundWind(WindSourceId source)
        {
            GroundWindDesc desc = GroundWindDesc.Create();
            Leave(Native.lr_world_get_ground_wind(Enter(), source, &desc), "lr_world_get_ground_wind");
            return desc;
        }
    }
}
