// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using LangevinRigid;

/// <summary>Assertions.</summary>
static class Check
{
    public sealed class Failed : Exception
    {
        public Failed(string message) : base(message) { }
    }

    public static void True(bool value, string what)
    {
        if (!value) throw new Failed(what);
    }

    public static void Equal<T>(T expected, T found, string what)
    {
        if (!EqualityComparer<T>.Default.Equals(expected, found)) throw new Failed(what + ": expected " + expected + ", found " + found);
    }

    public static void Near(double expected, double found, double tolerance, string what)
    {
        if (!(Math.Abs(expected - found) <= tolerance)) throw new Failed(what + ": expected " + expected + ", found " + found);
    }

    public static T Throws<T>(Action action, string what) where T : Exception
    {
        try
        {
            action();
        }
        catch (T e)
        {
            return e;
        }
        catch (Exception e)
        {
            throw new Failed(what + ": expected " + typeof(T).Name + ", found " + e);
        }
        throw new Failed(what + ": expected " + typeof(T).Name + ", nothing was thrown");
    }

    public static LangevinException Status(Status expected, Action action)
    {
        LangevinException e = Throws<LangevinException>(action, expected.ToString());
        Equal(expected, e.Status, e.Message);
        True(e.Message.StartsWith(e.Function + ": ") && e.Function.StartsWith("lr_") && e.Message.LastIndexOf(e.Function + ":") == 0,
            "the message names the function, once: " + e.Message);
        return e;
    }
}
