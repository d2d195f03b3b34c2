// SPDX-License-Identifier: MIT
using System;

namespace LangevinRigid
{
    /// <summary>Marks static methods that native code calls. Ahead-of-time compilers (IL2CPP, Mono's) go by the name alone, and make the way
    /// in from native code for methods that have it.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    internal sealed class MonoPInvokeCallbackAttribute : Attribute
    {
        public MonoPInvokeCallbackAttribute(Type type)
        {
            DelegateType = type;
        }

        public Type DelegateType { get; private set; }
    }
}
