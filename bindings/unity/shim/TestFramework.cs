// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using System.Reflection;

// The part of NUnit that the tests use. The same tests run in Unity's Test Runner.
namespace NUnit.Framework
{
    [AttributeUsage(AttributeTargets.Method)] public class TestAttribute : Attribute { }
    [AttributeUsage(AttributeTargets.Method)] public class SetUpAttribute : Attribute { }
    [AttributeUsage(AttributeTargets.Method)] public class TearDownAttribute : Attribute { }

    public class AssertionException : Exception { public AssertionException(string message) : base(message) { } }

    public delegate void TestDelegate();

    public class Assert
    {
        private static void That(bool good, string what, string message)
        {
            if (!good) throw new AssertionException(what + (message == null ? "" : ": " + message));
        }
        public static void AreEqual(object expected, object actual) { AreEqual(expected, actual, null); }
        public static void AreEqual(object expected, object actual, string message)
        {
            That(Equals(expected, actual), "expected " + expected + ", but was " + actual, message);
        }
        public static void AreNotEqual(object expected, object actual) { That(!Equals(expected, actual), "expected another than " + expected, null); }
        public static void AreEqual(double expected, double actual, double delta) { AreEqual(expected, actual, delta, null); }
        public static void AreEqual(double expected, double actual, double delta, string message)
        {
            That(Math.Abs(expected - actual) <= delta, "expected " + expected + " +- " + delta + ", but was " + actual, message);
        }
        public static void IsTrue(bool condition) { That(condition, "expected true", null); }
        public static void IsTrue(bool condition, string message) { That(condition, "expected true", message); }
        public static void IsFalse(bool condition) { That(!condition, "expected false", null); }
        public static void IsNull(object o) { That(o == null, "expected null, but was " + o, null); }
        public static void IsNotNull(object o) { That(o != null, "expected not null", null); }
        public static void Greater(double a, double b) { That(a > b, "expected more than " + b + ", but was " + a, null); }
        public static void Greater(double a, double b, string message) { That(a > b, "expected more than " + b + ", but was " + a, message); }
        public static void Less(double a, double b) { That(a < b, "expected less than " + b + ", but was " + a, null); }
        public static void Less(double a, double b, string message) { That(a < b, "expected less than " + b + ", but was " + a, message); }
        public static T Throws<T>(TestDelegate code) where T : Exception
        {
            try { code(); }
            catch (T e) { return e; }
            catch (Exception e) { throw new AssertionException("expected " + typeof(T).Name + ", but was " + e); }
            throw new AssertionException("expected " + typeof(T).Name + ", but nothing was thrown");
        }
    }
}

public static class ShimTestRunner
{
    public static int Run(params Assembly[] assemblies)
    {
        int passed = 0, failed = 0;
        foreach (Type type in assemblies.SelectMany(a => a.GetTypes()).OrderBy(t => t.FullName))
        {
            MethodInfo[] methods = type.GetMethods();
            if (!methods.Any(Has<NUnit.Framework.TestAttribute>)) continue;
            var clock = Stopwatch.StartNew();
            int before = failed;
            int count = 0;
            foreach (MethodInfo test in methods.Where(Has<NUnit.Framework.TestAttribute>))
            {
                ++count;
                Exception fault = Once(type, methods, test);
                if (fault == null) { ++passed; continue; }
                ++failed;
                Console.WriteLine("FAILED: " + type.Name + "." + test.Name + ": " + fault);
            }
            Console.WriteLine(type.Name + ": " + count + " tests, " + (failed - before) + " failed, " + clock.ElapsedMilliseconds + " ms");
        }
        Console.WriteLine("RESULT " + passed + " " + failed);
        return failed == 0 && passed > 0 ? 0 : 1;
    }

    private static bool Has<T>(MethodInfo m) { return m.GetCustomAttributes(typeof(T), true).Length > 0; }

    private static Exception Once(Type type, MethodInfo[] methods, MethodInfo test)
    {
        object fixture = Activator.CreateInstance(type);
        Exception fault = null;
        foreach (MethodInfo m in methods.Where(Has<NUnit.Framework.SetUpAttribute>)) fault = fault ?? Call(fixture, m);
        if (fault == null) fault = Call(fixture, test);
        foreach (MethodInfo m in methods.Where(Has<NUnit.Framework.TearDownAttribute>)) { Exception later = Call(fixture, m); fault = fault ?? later; }
        return fault;
    }

    private static Exception Call(object fixture, MethodInfo m)
    {
        try { m.Invoke(fixture, null); return null; }
        catch (TargetInvocationException e) { return e.InnerException; }
    }
}
