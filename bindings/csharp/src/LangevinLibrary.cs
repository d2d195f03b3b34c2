// SPDX-License-Identifier: MIT
using System;

namespace LangevinRigid
{
    /// <summary>The native library: its presence, version and capabilities.</summary>
    public static unsafe class LangevinLibrary
    {
        private static volatile bool _loaded;

        /// <summary>Converts a version number of <see cref="Native.lr_version"/>: major, minor and patch in 10, 10 and 12
        /// bits.</summary>
        public static Version VersionOf(uint number)
        {
            return new Version((int)(number >> 22), (int)(number >> 12 & 0x3ff), (int)(number & 0xfff));
        }

        /// <summary>Version of the header behind these sources.</summary>
        public static Version HeaderVersion
        {
            get { return new Version((int)Limits.VersionMajor, (int)Limits.VersionMinor, (int)Limits.VersionPatch); }
        }

        /// <summary>Version of the loaded library.</summary>
        /// <exception cref="LangevinLibraryException">No library was found, or an incompatible one.</exception>
        public static Version Version
        {
            get
            {
                EnsureLoaded();
                return VersionOf(Native.lr_version());
            }
        }

        /// <summary>Loads the library if necessary, and checks that it is compatible with these sources. All other classes do this by themselves;
        /// call it early to fail early.</summary>
        /// <exception cref="LangevinLibraryException">The reason and its remedy.</exception>
        public static void EnsureLoaded()
        {
            if (!_loaded) Load();
        }

        private static void Load()
        {
            uint number;
            try
            {
                number = Native.lr_version();
            }
            catch (DllNotFoundException e)
            {
                throw new LangevinLibraryException(LoadHelp.Missing(), null, e);
            }
            catch (BadImageFormatException e)
            {
                throw new LangevinLibraryException(LoadHelp.WrongKind(), null, e);
            }
            catch (EntryPointNotFoundException e)
            {
                throw new LangevinLibraryException(LoadHelp.AnotherLibrary(), null, e);
            }
            Version found = VersionOf(number), header = HeaderVersion;
            if (!IsCompatible(found, header)) throw new LangevinLibraryException(LoadHelp.WrongVersion(found, header), found, null);
            _loaded = true;
        }

        /// <summary>Whether sources for a header can use a library: the major version must be equal, before 1.0 also the minor version, and the
        /// library must not be older than the header, because it might lack functions.</summary>
        public static bool IsCompatible(Version library, Version header)
        {
            if (library.Major != header.Major || (header.Major == 0 && library.Minor != header.Minor)) return false;
            return library >= header;
        }

        /// <summary>The instruction sets that this build contains and this processor supports, best first.</summary>
        public static SimdTarget[] SimdTargets()
        {
            EnsureLoaded();
            uint count;
            Native.lr_simd_targets(null, 0, &count);
            var targets = new SimdTarget[count];
            fixed (SimdTarget* first = targets) LangevinException.Check(Native.lr_simd_targets(first, count, &count), "lr_simd_targets");
            return targets;
        }

        /// <summary>A display name, such as "AVX-512".</summary>
        public static string NameOf(SimdTarget target)
        {
            EnsureLoaded();
            return Utf8.Read(Native.lr_simd_target_name(target));
        }

        /// <summary>A short English phrase for a status.</summary>
        public static string TextOf(Status status)
        {
            EnsureLoaded();
            return Utf8.Read(Native.lr_status_string(status));
        }

        /// <summary>The function and the reason of the calling thread's last failed call; empty if there was none.</summary>
        public static string LastError
        {
            get
            {
                EnsureLoaded();
                return Utf8.Read(Native.lr_last_error());
            }
        }
    }
}
