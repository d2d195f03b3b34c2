// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
using UnrealBuildTool;

public class LangevinRigid : ModuleRules
{
	public LangevinRigid(ReadOnlyTargetRules Target) : base(Target)
	{
		PCHUsage = PCHUsageMode.UseExplicitOrSharedPCHs;

		PublicDependencyModuleNames.AddRange(new string[]
		{
			"Core", "CoreUObject", "Engine", "DeveloperSettings", "LangevinRigidLibrary"
		});
		PrivateDependencyModuleNames.AddRange(new string[]
		{
			"Landscape", "PhysicsCore", "Projects"
		});
	}
}
