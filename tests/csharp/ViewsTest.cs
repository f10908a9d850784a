using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;
using System.Threading;
using Cleft;

/// <summary>Views: without a copy, and good as long as they are held, whatever the garbage collector does.</summary>
sealed class ViewsTest
{
    readonly Mesher mesher = new Mesher();

    void TestViewsAreNoCopies()
    {
        Mesh mesh = Checks.BallMesh(mesher);
        Checks.Equal(mesh.Points.Pointer, mesh.Points.Pointer);
        Checks.Equal(mesh.Points[7], BitConverter.Int64BitsToDouble(Marshal.ReadInt64(mesh.Points.Pointer, 56)));
        double[] part = new double[5];
        mesh.Points.CopyTo(4, part);
        Checks.Equal(mesh.Points.Skip(4).Take(5).ToArray(), part);
        int[] tets = new int[4];
        mesh.Tets.CopyTo(8, tets);
        Checks.Equal(mesh.Tets.Skip(8).Take(4).ToArray(), tets);
        Checks.Equal(mesh.Points.LongCount, (long)mesh.Points.Count);
    }

    void TestDisposedWhileViewsAreHeld()
    {
        Mesh mesh = Checks.BallMesh(mesher);
        ArrayView<double> points = mesh.Points;
        mesh.Dispose();
        Checks.Check(mesh.IsDisposed && mesh.ToString() == "Mesh (disposed)", "a view keeps the mesh");
        Checks.Thrown<ObjectDisposedException>(() => mesh.CopyPoints());
        Checks.Thrown<ObjectDisposedException>(() => mesher.Quality(mesh));
        Checks.Check(points.Count > 0 && points.Sum() > 0, "the view is gone");
    }

    void TestEmptyMesh()
    {
        Mesh empty = mesher.MeshOf(new double[0], new int[0]);
        Checks.Equal(0, empty.Points.Count);
        Checks.Equal(0, empty.Tets.ToArray().Length);
    }

    void TestGarbageCollection()
    {
        double[] points = Checks.BallMesh(mesher).CopyPoints();
        var kept = new List<ArrayView<double>>();
        for (int round = 0; round < 100; ++round) {
            Mesh mesh = Checks.BallMesh(mesher);
            kept.Add(mesh.Points);
            if (round % 2 == 0)
                mesh.Dispose();  // while a view is held; the others are left to the collector
            if (round % 10 == 9) {
                kept.RemoveRange(0, kept.Count / 2);
                GC.Collect();
                GC.WaitForPendingFinalizers();
            }
        }
        foreach (ArrayView<double> view in kept)
            Checks.Equal(points, view.ToArray());
    }

    void TestCollectorsInTheMiddleOfCalls()
    {
        bool stop = false;
        var collector = new Thread(() => {
            while (!Volatile.Read(ref stop)) {
                GC.Collect();
                Thread.Sleep(1);
            }
        });
        collector.Start();
        double[] points = Checks.BallMesh(mesher).CopyPoints();
        for (int round = 0; round < 10; ++round) {
            var own = new Mesher { Progress = (fraction, stage) => true };
            Checks.Equal(points, Checks.BallMesh(own).CopyPoints());
            Checks.Equal(points[5], Checks.BallMesh(own).Points[5]);
        }
        Volatile.Write(ref stop, true);
        collector.Join();
    }
}
