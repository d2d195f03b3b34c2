// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
using UnrealBuildTool;

public class LangevinRigidNiagara : ModuleRules
{
	public LangevinRigidNiagara(ReadOnlyTargetRules Target) : base(Target)
	{
		PCHUsage = PCHUsageMode.UseExplicitOrSharedPCHs;

		PublicDependencyModuleNames.AddRange(new string[]
		{
			"Core", "CoreUObject", "Engine", "Niagara", "NiagaraCore", "VectorVM", "LangevinRigid"
		});
	}
}
