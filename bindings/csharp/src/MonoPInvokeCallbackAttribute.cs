// SPDX-License-Identifier: MIT
using System;

namespace LangevinRigid
{
    /// <summary>Marks static methods that native code calls. Ahead-of-time compilers (IL2CPP, Mono's) recognise it by its name, and generate
    /// the native entry points of these methods.</summary>
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
