// SPDX-License-Identifier: MIT
using System;

namespace LangevinRigid
{
    /// <summary>Messages for a native library that cannot be used.</summary>
    internal static class LoadHelp
    {
        private static string Bits { get { return IntPtr.Size == 8 ? "64-bit" : "32-bit"; } }

        public static string Missing()
        {
            return "The native library \"" + Native.Library + "\" could not be loaded by this " + Bits + " process. It is called " +
                "liblangevin_rigid.so (Linux, Android), langevin_rigid.dll (Windows) or liblangevin_rigid.dylib (macOS). Put it beside the " +
                "program, or name its folder in LD_LIBRARY_PATH (Linux), PATH (Windows) or DYLD_LIBRARY_PATH (macOS) before the program " +
                "starts; in Unity it belongs into a Plugins folder, enabled for this platform. If it is there, a library that it needs is " +
                "missing: ldd (Linux) or Dependencies (Windows) shows which; MONO_LOG_LEVEL=debug MONO_LOG_MASK=dll (Mono) and " +
                "LD_DEBUG=libs (Linux) show what was tried.";
        }

        public static string WrongKind()
        {
            return "The native library \"" + Native.Library + "\" is not for this " + Bits + " process, or damaged: it must be for the same " +
                "operating system and processor. Langevin Rigid is for 64-bit processes (\"x64\" or \"AnyCPU\" without \"Prefer 32-bit\").";
        }

        public static string AnotherLibrary()
        {
            return "The native library \"" + Native.Library + "\" was loaded, but it has no lr_version: it is another library of that name, " +
                "or was stripped of its exports.";
        }

        public static string WrongVersion(Version found, Version header)
        {
            string older = found < header ? "older" : "newer";
            return "The native library \"" + Native.Library + "\" is version " + found + ", " + older + " than version " + header +
                " that this C# binding was made for. Structs and functions may differ, so it is not used. Take both from the same package; " +
                "if you replaced the library in Unity, restart the editor, which keeps the old one loaded.";
        }
    }
}
