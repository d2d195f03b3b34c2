// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Text;
using UnityEditor;

namespace LangevinUnity.Editor
{
    /// <summary>Settings of a bake.</summary>
    [Serializable]
    public sealed class LangevinBakeSettings
    {
        /// <summary>kg/m^3; unused if arealDensity is given.</summary>
        public double density = 800.0;
        /// <summary>The mesh is the middle surface of a sheet.</summary>
        public bool sheet = false;
        /// <summary>m, of a sheet.</summary>
        public double thickness = 0.0002;
        /// <summary>kg/m^2 of a sheet; 0: use density.</summary>
        public double arealDensity = 0.0;
        /// <summary>air, water, or "density,viscosity".</summary>
        public string fluid = "air";
        /// <summary>m for a Unity mesh. "file": the unit stored in the file.</summary>
        public string unit = "m";
        /// <summary>Whether to compute the turbulence of the body's own wake, which takes longer.</summary>
        public bool wake = false;

        /// <summary>The first problem of the settings, or null.</summary>
        public string Problem()
        {
            if (sheet && !(thickness > 0.0)) return "A sheet needs a thickness.";
            if (sheet && arealDensity < 0.0) return "The areal density is negative.";
            if (!(sheet && arealDensity > 0.0) && !(density > 0.0)) return "The density must be more than 0.";
            return null;
        }

        /// <summary>The arguments for lr_bake.</summary>
        public List<string> Arguments(string mesh, string output, string name)
        {
            var list = new List<string> { "mesh", mesh, "-o", output, "--unit", unit, "--fluid", fluid };
            if (!string.IsNullOrEmpty(name)) { list.Add("--name"); list.Add(name); }
            if (sheet) { list.Add("--sheet"); list.Add("--thickness"); list.Add(Number(thickness)); }
            bool areal = sheet && arealDensity > 0.0;
            list.Add(areal ? "--areal-density" : "--density");
            list.Add(Number(areal ? arealDensity : density));
            if (wake) list.Add("--wake");
            return list;
        }

        // The baker reads numbers with a decimal point, whatever the system's language.
        private static string Number(double value) { return value.ToString("R", CultureInfo.InvariantCulture); }
    }

    /// <summary>A run of lr_bake in a process of its own.</summary>
    public sealed class LangevinBake : IDisposable
    {
        private readonly Process process = new Process();
        private readonly StringBuilder errors = new StringBuilder();
        private readonly StringBuilder report = new StringBuilder();
        private readonly object guard = new object();
        private string phase = "starting";

        /// <summary>The present phase.</summary>
        public string Phase { get { lock (guard) return phase; } }

        /// <summary>The reported faults: numbers, places and remedies.</summary>
        public string Errors { get { lock (guard) return errors.ToString(); } }

        /// <summary>The summary that it printed.</summary>
        public string Report { get { lock (guard) return report.ToString(); } }

        /// <summary>Whether it was cancelled.</summary>
        public bool Cancelled { get; private set; }

        /// <summary>Whether it has exited.</summary>
        public bool Ended { get { return process.HasExited; } }

        /// <summary>0: success; 1: a numbered fault; 2: wrong usage.</summary>
        public int ExitCode { get { return process.ExitCode; } }

        /// <summary>Starts the baker.</summary>
        public LangevinBake(string program, IEnumerable<string> arguments)
        {
            var start = new ProcessStartInfo(program)
            {
                UseShellExecute = false,
                CreateNoWindow = true,
                RedirectStandardError = true,
                RedirectStandardOutput = true,
                Arguments = LangevinCommandLine.Join(arguments),
            };
            process.StartInfo = start;
            process.ErrorDataReceived += (sender, e) => Take(e.Data, true);
            process.OutputDataReceived += (sender, e) => Take(e.Data, false);
            LangevinBakerTool.MakeExecutable(program);
            process.Start();
            process.BeginErrorReadLine();
            process.BeginOutputReadLine();
        }

        // On standard error, progress is "phase: 0.01 s" and a fault is "FILE: error NUMBER at WHERE: ...".
        private void Take(string line, bool error)
        {
            if (line == null) return;
            lock (guard)
            {
                if (!error) report.AppendLine(line);
                else if (line.EndsWith(" s", StringComparison.Ordinal) && !line.Contains(": error ") && !line.Contains(": warning "))
                    phase = line.Substring(0, Math.Max(0, line.IndexOf(':')));
                else errors.AppendLine(line);
            }
        }

        /// <summary>Waits for its end and for all of its output.</summary>
        public void Wait() { process.WaitForExit(); }

        /// <summary>Kills the baker, which leaves an earlier output unchanged.</summary>
        public void Cancel()
        {
            Cancelled = true;
            try { if (!process.HasExited) process.Kill(); }
            catch (InvalidOperationException) { }
        }

        /// <summary>Kills the baker if it still runs.</summary>
        public void Dispose()
        {
            Cancel();
            process.Dispose();
        }
    }

    /// <summary>Finds lr_bake.</summary>
    public static class LangevinBakerTool
    {
        /// <summary>The editor preference with the path chosen in the bake window.</summary>
        public const string PreferenceKey = "LangevinRigid.BakerPath";

        /// <summary>The baker: the chosen path, else the package's for this system, else on PATH; otherwise null.</summary>
        public static string Find()
        {
            string chosen = EditorPrefs.GetString(PreferenceKey, "");
            if (chosen.Length > 0 && File.Exists(chosen)) return chosen;
            var package = UnityEditor.PackageManager.PackageInfo.FindForAssembly(typeof(LangevinBakerTool).Assembly);
            return Find(package == null ? null : package.resolvedPath, Environment.GetEnvironmentVariable("PATH"), IsWindows);
        }

        /// <summary>Finds the baker without the editor's preferences.</summary>
        public static string Find(string packagePath, string searchPath, bool windows)
        {
            string file = windows ? "lr_bake.exe" : "lr_bake";
            if (packagePath != null)
                foreach (string folder in new[] { windows ? "windows-x64" : "linux-x64", windows ? "windows-x64" : "linux-arm64" })
                {
                    string bundled = Path.Combine(Path.Combine(Path.Combine(packagePath, "Tools~"), folder), file);
                    if (File.Exists(bundled) && (windows || FolderRuns(folder))) return bundled;
                }
            foreach (string folder in (searchPath ?? "").Split(Path.PathSeparator))
            {
                if (folder.Length == 0) continue;
                string found = Path.Combine(folder, file);
                if (File.Exists(found)) return found;
            }
            return null;
        }

        /// <summary>Sets the executable bit, which archives of packages can lose. If that fails, starting the program reports it.</summary>
        public static void MakeExecutable(string program)
        {
            if (IsWindows) return;
            var start = new ProcessStartInfo("/bin/chmod", LangevinCommandLine.Join(new[] { "u+x", program }))
            {
                UseShellExecute = false,
                RedirectStandardError = true,
            };
            using (Process change = Process.Start(start)) change.WaitForExit();
        }

        private static bool IsWindows { get { return Path.DirectorySeparatorChar == '\\'; } }

        private static bool FolderRuns(string folder)
        {
            bool arm = System.Runtime.InteropServices.RuntimeInformation.ProcessArchitecture == System.Runtime.InteropServices.Architecture.Arm64;
            return arm == folder.EndsWith("arm64", StringComparison.Ordinal);
        }
    }

    /// <summary>Joins arguments into one string, with the quoting of Windows and Mono.</summary>
    internal static class LangevinCommandLine
    {
        public static string Join(IEnumerable<string> arguments)
        {
            var text = new StringBuilder();
            foreach (string argument in arguments)
            {
                if (text.Length > 0) text.Append(' ');
                Quote(text, argument);
            }
            return text.ToString();
        }

        // Backslashes are literal unless they precede a quotation mark.
        private static void Quote(StringBuilder text, string argument)
        {
            if (argument.Length > 0 && argument.IndexOfAny(new[] { ' ', '\t', '"', '\\', '\'' }) < 0)
            {
                text.Append(argument);
                return;
            }
            text.Append('"');
            int slashes = 0;
            foreach (char c in argument)
            {
                if (c == '\\') { ++slashes; continue; }
                text.Append('\\', c == '"' ? 2 * slashes + 1 : slashes).Append(c);
                slashes = 0;
            }
            text.Append('\\', 2 * slashes).Append('"');
        }
    }
}
