// SPDX-License-Identifier: MIT
using System;
using System.Reflection;

/// <summary>Runs every public static method without parameters of the classes whose names end with Tests.</summary>
static class Program
{
    static int Main(string[] arguments)
    {
        if (arguments.Length == 2 && arguments[0] == "--load") return LoadCheck.Run(arguments[1]);
        if (arguments.Length == 1 && arguments[0] == "--leave") return LoadCheck.Leave();
        int passed = 0, failed = 0;
        foreach (Type type in typeof(Program).Assembly.GetTypes())
        {
            if (!type.Name.EndsWith("Tests")) continue;
            foreach (MethodInfo method in type.GetMethods(BindingFlags.Static | BindingFlags.Public | BindingFlags.DeclaredOnly))
            {
                if (method.ReturnType != typeof(void) || method.GetParameters().Length != 0) continue;
                string name = type.Name + "." + method.Name;
                if (arguments.Length > 0 && name.IndexOf(arguments[0], StringComparison.Ordinal) < 0) continue;
                try
                {
                    ((Action)Delegate.CreateDelegate(typeof(Action), method))();
                    ++passed;
                }
                catch (Exception e)
                {
                    ++failed;
                    Console.WriteLine("FAILED " + name + ": " + (e is Check.Failed ? e.Message : e.ToString()));
                }
            }
        }
        Console.WriteLine("tests: {0} passed, {1} failed", passed, failed);
        return failed == 0 && passed > 0 ? 0 : 1;
    }
}
