// SPDX-License-Identifier: MIT
using System;
using System.Text;

namespace LangevinRigid
{
    /// <summary>Strings of the library: UTF-8 on every platform, ending with 0.</summary>
    internal static unsafe class Utf8
    {
        public static string Read(byte* text)
        {
            return Read(text, int.MaxValue);
        }

        /// <summary>Reads an array that can lack the final 0.</summary>
        public static string Read(byte* text, int capacity)
        {
            if (text == null) return string.Empty;
            int length = 0;
            while (length < capacity && text[length] != 0) ++length;
            return length == 0 ? string.Empty : Encoding.UTF8.GetString(text, length);
        }

        public static byte[] Bytes(string text)
        {
            if (text.IndexOf('\0') >= 0) throw new ArgumentException("A path cannot hold a character 0.", "text");
            var bytes = new byte[Encoding.UTF8.GetByteCount(text) + 1];
            Encoding.UTF8.GetBytes(text, 0, text.Length, bytes, 0);
            return bytes;
        }
    }
}
