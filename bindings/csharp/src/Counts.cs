// SPDX-License-Identifier: MIT
using System;

namespace LangevinRigid
{
    /// <summary>Checks counts and lengths of pointers and arrays: a wrong one must not reach native code.</summary>
    internal static class Counts
    {
        public static uint Of(int count)
        {
            if (count < 0) throw new ArgumentOutOfRangeException("count");
            return (uint)count;
        }

        /// <summary>Checks the length of an array that receives <paramref name="count"/> elements.</summary>
        public static void CheckRoom(Array array, string name, int count)
        {
            if (array == null) throw new ArgumentNullException(name);
            if (array.Length < count) throw new ArgumentException("It has room for " + array.Length + " elements of " + count + ".", name);
        }

        /// <summary>Checks the given part of an array.</summary>
        public static uint OfPart(Array array, string name, int count)
        {
            if (array == null) throw new ArgumentNullException(name);
            if (count < 0 || count > array.Length)
                throw new ArgumentOutOfRangeException("count", "The array has " + array.Length + " elements, not " + count + ".");
            return (uint)count;
        }
    }
}
