using System;
using System.IO;
using Cleft;

/// <summary>The golden case of tests/golden/README.md.</summary>
static class Golden
{
    static int Square(int x) { return x * x; }

    static byte LabelAt(int i, int j, int k)
    {
        if (Square(i - 10) + Square(j - 7) + Square(k - 6) <= 14)
            return 200;
        return (byte)(Square(i - 5) + Square(j - 6) + Square(k - 5) <= 17 ? 3 : 0);
    }

    internal static void Run()
    {
        byte[] labels = new byte[16 * 14 * 12];
        for (int k = 0; k < 12; ++k)
            for (int j = 0; j < 14; ++j)
                for (int i = 0; i < 16; ++i)
                    labels[i + 16 * (j + 14 * k)] = LabelAt(i, j, k);
        Grid grid = new Grid(16, 14, 12).WithAffine(1, 0, 0, -4.5, 0, 1.25, 0, 2.25, 0, 0, 1.5, 100);
        using (var mesher = new Mesher { Threads = 1 })
        using (var options = new Options { Background = Background.Particles })
        using (Volume volume = mesher.Labels(labels, grid, options))
        using (Mesh mesh = mesher.Mesh(volume, options)) {
            var bytes = new MemoryStream();
            var writer = new BinaryWriter(bytes);
            foreach (double coordinate in mesh.Points)
                writer.Write(coordinate);
            foreach (int corner in mesh.Tets)
                writer.Write(corner);
            foreach (int label in mesh.TetLabels)
                writer.Write(label);
            ulong hash = 0xcbf29ce484222325;
            foreach (byte b in bytes.ToArray())
                hash = unchecked((hash ^ b) * 0x100000001b3);
            Console.WriteLine(hash.ToString("x16"));
        }
    }
}
