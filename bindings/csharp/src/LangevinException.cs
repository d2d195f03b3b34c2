// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Text;

namespace LangevinRigid
{
    /// <summary>A refused call. It has changed nothing, unless the function's text says otherwise.</summary>
    public sealed class LangevinException : Exception
    {
        private static readonly AssetFault[] NoFaults = new AssetFault[0];

        /// <summary>The reason.</summary>
        public Status Status { get; private set; }
        /// <summary>The C function, as in <see cref="Native"/>.</summary>
        public string Function { get; private set; }
        /// <summary>The world's log message about it, or empty.</summary>
        public string Detail { get; private set; }
        /// <summary>The faults of the bytes, if an asset was not loaded.</summary>
        public IReadOnlyList<AssetFault> Faults { get; private set; }

        /// <summary>Creates the exception for a function's status.</summary>
        public LangevinException(Status status, string function, string detail = null, IReadOnlyList<AssetFault> faults = null)
            : base(Text(status, function, detail, faults))
        {
            Status = status;
            Function = function;
            Detail = detail ?? string.Empty;
            Faults = faults ?? NoFaults;
        }

        /// <summary>Throws unless a function of <see cref="Native"/> returned Ok.</summary>
        public static void Check(Status status, string function)
        {
            if (status < Status.Ok) throw new LangevinException(status, function, LangevinLibrary.LastError);
        }

        private static string Text(Status status, string function, string detail, IReadOnlyList<AssetFault> faults)
        {
            var text = new StringBuilder();
            string reason = LangevinLibrary.TextOf(status), said = detail ?? string.Empty;
            text.Append(function).Append(": ").Append(reason);
            text.Append(" (").Append(status).Append(", ").Append((int)status).Append(')');
            // The library's message begins with the function, and often says no more than the status.
            if (said.StartsWith(function + ": ", StringComparison.Ordinal)) said = said.Substring(function.Length + 2);
            if (said.Length != 0 && said != reason) text.Append(": ").Append(said);
            if (status == Status.StructSize) text.Append(". Was each struct made by its Create()?");
            if (faults != null)
                foreach (AssetFault fault in faults) text.Append(Environment.NewLine).Append("  ").Append(fault);
            return text.ToString();
        }
    }

    /// <summary>The native library is missing, or this binding cannot use it. The message says what to do.</summary>
    public sealed class LangevinLibraryException : DllNotFoundException
    {
        /// <summary>Version of the library that was found; null if there was none.</summary>
        public Version Found { get; private set; }

        internal LangevinLibraryException(string message, Version found, Exception inner) : base(message, inner)
        {
            Found = found;
        }
    }

    /// <summary>A numbered fault of an asset file; docs/reference/asset_format.md lists them.</summary>
    public struct AssetFault
    {
        /// <summary>Its number.</summary>
        public uint Number;
        /// <summary>The part of the file.</summary>
        public string Where;
        /// <summary>The defect.</summary>
        public string What;
        /// <summary>The remedy.</summary>
        public string Remedy;

        /// <inheritdoc/>
        public override string ToString()
        {
            return "error " + Number + " at " + Where + ": " + What + " " + Remedy;
        }
    }
}
