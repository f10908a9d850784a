using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Cleft;

/// <summary>What the tests share: running methods named Test..., asserting, and a small volume.</summary>
static class Checks
{
    /// <summary>First calls that a program may make, where libraries are missing.</summary>
    static readonly Dictionary<string, Action> Attempts = new Dictionary<string, Action> {
        ["TryMesher"] = () => new Mesher(),
        ["TryOptions"] = () => new Options(),
        ["TryVersion"] = () => Library.Version.Trim(),
        ["TryTable"] = () => OptionDescription.Table(),
        ["TryFiles"] = () => MeshFiles.Formats(),
        ["TryGuess"] = () => MeshFiles.Guess("a.vtu"),
        ["TryRead"] = () => MeshFiles.ReadVolume(new Mesher(), "a.nrrd")
    };

    /// <summary>
    /// Runs an attempt, the golden case, or all methods Test...() of a class, each on an object of its own.
    /// </summary>
    static int Main(string[] arguments)
    {
        if (arguments[0] == "Golden") {
            Golden.Run();
            return 0;
        }
        if (Attempts.TryGetValue(arguments[0], out Action attempt)) {
            attempt();
            return 0;
        }
        Type tests = typeof(Checks).Assembly.GetType(arguments[0], true);
        MethodInfo[] methods = tests.GetMethods(BindingFlags.Instance | BindingFlags.NonPublic | BindingFlags.Public)
            .Where(method => method.Name.StartsWith("Test")).ToArray();
        int failed = methods.Length == 0 ? 1 : 0;
        foreach (MethodInfo method in methods)
            try {
                method.Invoke(Activator.CreateInstance(tests), null);
                Console.WriteLine("ok " + method.Name);
            } catch (TargetInvocationException failure) {
                ++failed;
                Console.WriteLine("FAILED " + method.Name + ": " + failure.InnerException);
            }
        return failed == 0 ? 0 : 1;
    }

    internal static void Check(bool condition, string what)
    {
        if (!condition)
            throw new Exception("check failed: " + what);
    }

    internal static void Equal(object wanted, object found)
    {
        bool equal = StructuralComparisons.StructuralEqualityComparer.Equals(wanted, found);
        Check(equal, "wanted " + wanted + ", found " + found);
    }

    internal static void Near(double wanted, double found, double relative)
    {
        Check(Math.Abs(wanted - found) <= relative * Math.Abs(wanted), "wanted " + wanted + ", found " + found);
    }

    /// <summary>The body must throw this kind of exception, or one of its kind.</summary>
    internal static T Thrown<T>(Action body) where T : Exception
    {
        try {
            body();
        } catch (Exception failure) {
            T wanted = failure as T;
            Check(wanted != null, "wanted " + typeof(T) + ", found " + failure);
            return wanted;
        }
        throw new Exception("nothing was thrown, wanted " + typeof(T));
    }

    internal static readonly Grid Grid = new Grid(12, 13, 14);

    /// <summary>1 in a ball off the middle, 7 in a slab at high x, else 0; no symmetry between the axes.</summary>
    internal static byte[] BallLabels()
    {
        byte[] labels = new byte[12 * 13 * 14];
        for (int k = 0; k < 14; ++k)
            for (int j = 0; j < 13; ++j)
                for (int i = 0; i < 12; ++i) {
                    double r2 = (i - 4.8) * (i - 4.8) + (j - 6) * (j - 6) + (k - 7.2) * (k - 7.2);
                    labels[i + 12 * (j + 13 * k)] = (byte)(i >= 9 ? 7 : r2 < 3.6 * 3.6 ? 1 : 0);
                }
        return labels;
    }

    internal static Volume BallVolume(Mesher mesher) { return mesher.Labels(BallLabels(), Grid); }

    internal static Options Quick() { return new Options { Background = Background.Lattice, Size = 3 }; }

    internal static Mesh BallMesh(Mesher mesher)
    {
        using (Volume volume = BallVolume(mesher))
        using (Options options = Quick())
            return mesher.Mesh(volume, options);
    }

    /// <summary>A volume whose meshing takes seconds.</summary>
    internal static Volume SlowVolume(Mesher mesher)
    {
        var random = new Random(1);
        byte[] labels = new byte[40 * 40 * 40];
        for (int i = 0; i < labels.Length; ++i)
            labels[i] = (byte)random.Next(3);
        return mesher.Labels(labels, new Grid(40, 40, 40));
    }

    internal static bool Same(Mesh a, Mesh b)
    {
        return a.Points.SequenceEqual(b.Points) && a.Tets.SequenceEqual(b.Tets)
            && a.TetLabels.SequenceEqual(b.TetLabels);
    }
}
