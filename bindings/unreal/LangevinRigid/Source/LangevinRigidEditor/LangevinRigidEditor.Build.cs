// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
using UnrealBuildTool;

public class LangevinRigidEditor : ModuleRules
{
	public LangevinRigidEditor(ReadOnlyTargetRules Target) : base(Target)
	{
		PCHUsage = PCHUsageMode.UseExplicitOrSharedPCHs;

		PrivateDependencyModuleNames.AddRange(new string[]
		{
			"Core", "CoreUObject", "Engine", "UnrealEd", "AssetDefinition", "AssetTools", "ContentBrowser", "Projects", "Slate", "SlateCore",
			"ToolMenus", "LangevinRigid"
		});
	}
}
