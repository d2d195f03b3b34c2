// SPDX-License-Identifier: MIT
using System;
using LangevinRigid;

/// <summary>What a process says whose library is missing or another one; each needs a process of its own.</summary>
static class LoadCheck
{
    public static int Run(string kind)
    {
        foreach (Action first in new Action[] { () => LangevinLibrary.EnsureLoaded(), () => new World(), () => BodyDesc.Create(), () => Asset.Check(new byte[1]) })
        {
            try
            {
                first();
            }
            catch (LangevinLibraryException e)
            {
                string expected = kind == "newer" || kind == "older" ? kind + " than version" : kind == "other" ? "no lr_version" : "could not be loaded";
                if (!e.Message.Contains(expected)) return Fail(kind + ": " + e.Message);
                if (kind == "newer" && !Equals(e.Found, new Version(0, 2, 0))) return Fail("found " + e.Found);
                if (kind == "missing" && !(e.InnerException is DllNotFoundException)) return Fail("the cause is kept");
                continue;
            }
            return Fail(kind + ": nothing was thrown");
        }
        return 0;
    }

    static int Fail(string what)
    {
        Console.WriteLine("FAILED " + what);
        return 1;
    }
}
