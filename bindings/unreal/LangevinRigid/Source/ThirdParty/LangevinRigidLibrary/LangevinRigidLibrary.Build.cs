// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
using System.IO;
using UnrealBuildTool;

// The native library, in the layout of bindings/unreal/package.py:
//   include/langevin_rigid.h
//   lib/Win64/langevin_rigid.lib, lib/Win64/*.dll
//   lib/Linux/liblangevin_rigid.so and its dependencies; likewise lib/LinuxArm64
public class LangevinRigidLibrary : ModuleRules
{
	public LangevinRigidLibrary(ReadOnlyTargetRules Target) : base(Target)
	{
		Type = ModuleType.External;

		string LibraryDir = Path.Combine(ModuleDirectory, "lib", Target.Platform.ToString());
		if (Target.Platform != UnrealTargetPlatform.Win64 && Target.Platform != UnrealTargetPlatform.Linux
			&& Target.Platform != UnrealTargetPlatform.LinuxArm64)
		{
			throw new BuildException("Langevin Rigid has no native library for " + Target.Platform
				+ ": Win64, Linux and LinuxArm64 are supported. Disable the plugin for this platform.");
		}
		if (!Directory.Exists(LibraryDir))
		{
			throw new BuildException("Langevin Rigid: " + LibraryDir + " is missing. Take a packaged plugin, or run "
				+ "bindings/unreal/package.py --native " + Target.Platform + "=PREFIX --out DIR on an installed library.");
		}

		string Loaded = "liblangevin_rigid.so";
		PublicSystemIncludePaths.Add(Path.Combine(ModuleDirectory, "include"));

		if (Target.Platform == UnrealTargetPlatform.Win64)
		{
			PublicAdditionalLibraries.Add(Path.Combine(LibraryDir, "langevin_rigid.lib"));
			// Windows would search only beside the executable; StartupModule loads the library by its path instead.
			foreach (string Dll in Directory.GetFiles(LibraryDir, "*.dll"))
			{
				PublicDelayLoadDLLs.Add(Path.GetFileName(Dll));
				RuntimeDependencies.Add(Dll);
				if (Path.GetFileName(Dll).Contains("langevin_rigid"))
				{
					Loaded = Path.GetFileName(Dll);
				}
			}
		}
		else
		{
			PublicAdditionalLibraries.Add(Path.Combine(LibraryDir, "liblangevin_rigid.so"));
			// The loader needs a run path to the library; packaged servers lack it without this line.
			PublicRuntimeLibraryPaths.Add(LibraryDir);
			foreach (string Library in Directory.GetFiles(LibraryDir, "*.so*"))
			{
				RuntimeDependencies.Add(Library);
				// The loader's name of the library: a copy under another name would be a second library with its own worlds.
				if (Path.GetFileName(Library).StartsWith("liblangevin_rigid.so."))
				{
					Loaded = Path.GetFileName(Library);
				}
			}
		}
		PublicDefinitions.Add("LANGEVIN_RIGID_LIBRARY=\"lib/" + Target.Platform + "/" + Loaded + "\"");
	}
}
