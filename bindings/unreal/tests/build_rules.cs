// The parts of UnrealBuildTool that the plugin's rules use, and a program that runs the rules: every file that they name must exist.
// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace UnrealBuildTool
{
	public class BuildException : Exception
	{
		public BuildException(string Message) : base(Message) { }
	}

	public struct UnrealTargetPlatform
	{
		private readonly string Name;
		private UnrealTargetPlatform(string InName) { Name = InName; }
		public static readonly UnrealTargetPlatform Win64 = new UnrealTargetPlatform("Win64");
		public static readonly UnrealTargetPlatform Mac = new UnrealTargetPlatform("Mac");
		public static readonly UnrealTargetPlatform Linux = new UnrealTargetPlatform("Linux");
		public static readonly UnrealTargetPlatform LinuxArm64 = new UnrealTargetPlatform("LinuxArm64");
		public static bool operator ==(UnrealTargetPlatform A, UnrealTargetPlatform B) { return A.Name == B.Name; }
		public static bool operator !=(UnrealTargetPlatform A, UnrealTargetPlatform B) { return A.Name != B.Name; }
		public override bool Equals(object Other) { return Other is UnrealTargetPlatform && this == (UnrealTargetPlatform)Other; }
		public override int GetHashCode() { return Name.GetHashCode(); }
		public override string ToString() { return Name; }
	}

	public class ReadOnlyTargetRules
	{
		public readonly UnrealTargetPlatform Platform;
		public ReadOnlyTargetRules(UnrealTargetPlatform InPlatform) { Platform = InPlatform; }
	}


	public class ModuleRules
	{
		public enum ModuleType { CPlusPlus, External }
		public enum PCHUsageMode { Default, NoPCHs, NoSharedPCHs, UseSharedPCHs, UseExplicitOrSharedPCHs }

		public class RuntimeDependencyList
		{
			public readonly List<string> Paths = new List<string>();
			public void Add(string Path) { Paths.Add(Path); }
		}

		// UnrealBuildTool sets it before the constructor runs.
		public static string NextDirectory;

		public ModuleRules(ReadOnlyTargetRules Target) { ModuleDirectory = NextDirectory; }
		public readonly string ModuleDirectory;
		public ModuleType Type = ModuleType.CPlusPlus;
		public PCHUsageMode PCHUsage = PCHUsageMode.Default;
		public readonly List<string> PublicDependencyModuleNames = new List<string>();
		public readonly List<string> PrivateDependencyModuleNames = new List<string>();
		public readonly List<string> PublicSystemIncludePaths = new List<string>();
		public readonly List<string> PublicAdditionalLibraries = new List<string>();
		public readonly List<string> PublicRuntimeLibraryPaths = new List<string>();
		public readonly List<string> PublicDelayLoadDLLs = new List<string>();
		public readonly List<string> PublicDefinitions = new List<string>();
		public readonly RuntimeDependencyList RuntimeDependencies = new RuntimeDependencyList();
	}
}

// Usage: build_rules.exe PLUGIN PLATFORM...
public static class Program
{
	private static int Failures;

	private static void Check(bool Good, string What)
	{
		if (!Good)
		{
			++Failures;
			Console.WriteLine("FAILED: " + What);
		}
	}

	private static UnrealBuildTool.ModuleRules Make(Type Rules, string Plugin, UnrealBuildTool.UnrealTargetPlatform Platform)
	{
		string Folder = Rules.Name == "LangevinRigidLibrary" ? Path.Combine("ThirdParty", Rules.Name) : Rules.Name;
		UnrealBuildTool.ModuleRules.NextDirectory = Path.Combine(Plugin, "Source", Folder);
		Check(File.Exists(Path.Combine(UnrealBuildTool.ModuleRules.NextDirectory, Rules.Name + ".Build.cs")), Rules.Name + ".Build.cs in its folder");
		try
		{
			return (UnrealBuildTool.ModuleRules)Activator.CreateInstance(Rules, new UnrealBuildTool.ReadOnlyTargetRules(Platform));
		}
		catch (System.Reflection.TargetInvocationException Thrown)
		{
			throw Thrown.InnerException;
		}
	}

	private static void CheckLibrary(UnrealBuildTool.ModuleRules Rules, UnrealBuildTool.UnrealTargetPlatform Platform)
	{
		bool Windows = Platform == UnrealBuildTool.UnrealTargetPlatform.Win64;
		string On = " on " + Platform;
		Check(Rules.Type == UnrealBuildTool.ModuleRules.ModuleType.External, "an external module" + On);
		Check(Rules.PublicSystemIncludePaths.Count == 1 && File.Exists(Path.Combine(Rules.PublicSystemIncludePaths[0], "langevin_rigid.h")), "the header" + On);
		Check(Rules.PublicAdditionalLibraries.Count == 1, "one library to link" + On);
		foreach (string Library in Rules.PublicAdditionalLibraries)
		{
			Check(File.Exists(Library), Library + " exists");
			Check(Path.GetExtension(Library) == (Windows ? ".lib" : ".so"), Library + " is of the platform's kind");
		}
		Check(Rules.RuntimeDependencies.Paths.Count > 0, "files to stage" + On);
		foreach (string Staged in Rules.RuntimeDependencies.Paths) Check(File.Exists(Staged), Staged + " exists");
		Check((Rules.PublicDelayLoadDLLs.Count > 0) == Windows, "delay loading" + On);
		foreach (string Dll in Rules.PublicDelayLoadDLLs)
		{
			Check(Path.GetFileName(Dll) == Dll, Dll + " is a name without a path");
			Check(Rules.RuntimeDependencies.Paths.Any(P => Path.GetFileName(P) == Dll), Dll + " is staged");
		}
		Check(Windows || Rules.PublicRuntimeLibraryPaths.All(Directory.Exists) && Rules.PublicRuntimeLibraryPaths.Count == 1, "a run path" + On);
		string Definition = Rules.PublicDefinitions.Single(D => D.StartsWith("LANGEVIN_RIGID_LIBRARY="));
		string Loaded = Definition.Substring(Definition.IndexOf('=') + 1).Trim('"');
		Check(Rules.RuntimeDependencies.Paths.Contains(Path.Combine(Rules.ModuleDirectory, Loaded)), "what the module loads is staged: " + Loaded);
		Console.WriteLine(Platform + ": links " + Path.GetFileName(Rules.PublicAdditionalLibraries[0]) + ", loads " + Loaded + ", stages " + Rules.RuntimeDependencies.Paths.Count);
	}

	public static int Main(string[] Arguments)
	{
		string Plugin = Arguments[0];
		var Known = new Dictionary<string, UnrealBuildTool.UnrealTargetPlatform>();
		foreach (var Platform in new[] { UnrealBuildTool.UnrealTargetPlatform.Win64, UnrealBuildTool.UnrealTargetPlatform.Linux, UnrealBuildTool.UnrealTargetPlatform.LinuxArm64 })
		{
			Known[Platform.ToString()] = Platform;
		}
		var Modules = new[] { typeof(LangevinRigid), typeof(LangevinRigidNiagara), typeof(LangevinRigidEditor) };
		foreach (string Name in Known.Keys)
		{
			if (Arguments.Contains(Name))
			{
				CheckLibrary(Make(typeof(LangevinRigidLibrary), Plugin, Known[Name]), Known[Name]);
				foreach (Type Module in Modules)
				{
					UnrealBuildTool.ModuleRules Rules = Make(Module, Plugin, Known[Name]);
					Check(Rules.PCHUsage == UnrealBuildTool.ModuleRules.PCHUsageMode.UseExplicitOrSharedPCHs, Module.Name + " uses precompiled headers as the engine wants");
					IEnumerable<string> Needed = Rules.PublicDependencyModuleNames.Concat(Rules.PrivateDependencyModuleNames);
					Check(Needed.Distinct().Count() == Needed.Count(), Module.Name + " names no module twice");
					foreach (string Own in Needed.Where(N => N.StartsWith("Langevin")))
					{
						Check(Own == "LangevinRigidLibrary" || Modules.Any(M => M.Name == Own), Module.Name + " needs " + Own + ", which is in the plugin");
					}
				}
				continue;
			}
			// A platform without a packaged library is refused with a remedy.
			try
			{
				Make(typeof(LangevinRigidLibrary), Plugin, Known[Name]);
				Check(false, Name + " without a library is refused");
			}
			catch (UnrealBuildTool.BuildException Refused)
			{
				Check(Refused.Message.Contains("package.py"), "the refusal says what to do: " + Refused.Message);
			}
		}
		try
		{
			Make(typeof(LangevinRigidLibrary), Plugin, UnrealBuildTool.UnrealTargetPlatform.Mac);
			Check(false, "Mac is refused");
		}
		catch (UnrealBuildTool.BuildException Refused)
		{
			Check(Refused.Message.Contains("Mac"), "Mac is refused by name");
			Console.WriteLine("Mac: refused: " + Refused.Message);
		}
		return Failures == 0 ? 0 : 1;
	}
}
