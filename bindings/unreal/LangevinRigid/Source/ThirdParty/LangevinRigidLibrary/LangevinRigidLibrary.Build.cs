// SPDX-License-Identifier: MIT
using System.IO;
using UnrealBuildTool;

// The native library as bindings/unreal/package.py puts it in place:
//   include/langevin_rigid.h
//   lib/Win64/langevin_rigid.lib, lib/Win64/*.dll
//   lib/Linux/liblangevin_rigid.so, and the files that it needs; likewise lib/LinuxArm64
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
			// Windows would look for it beside the executable only; StartupModule loads it by its path instead.
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
			// The loader needs a run path to it, which packaged servers lack without this line.
			PublicRuntimeLibraryPaths.Add(LibraryDir);
			foreach (string Library in Directory.GetFiles(LibraryDir, "*.so*"))
			{
				RuntimeDependencies.Add(Library);
				// The name that the loader knows it by: another copy would be another library, with worlds of its own.
				if (Path.GetFileName(Library).StartsWith("liblangevin_rigid.so."))
				{
					Loaded = Path.GetFileName(Library);
				}
			}
		}
		PublicDefinitions.Add("LANGEVIN_RIGID_LIBRARY=\"lib/" + Target.Platform + "/" + Loaded + "\"");
	}
}
