using System;
using System.IO;
using System.Linq;
using Cleft;

/// <summary>Reading and writing.</summary>
sealed class FilesTest
{
    static readonly string Data = Environment.GetEnvironmentVariable("TEST_DATA");
    readonly Mesher mesher = new Mesher();

    static void InFolder(Action<Func<string, string>> use)
    {
        string folder = Path.Combine(Path.GetTempPath(), "cleft-test-" + Guid.NewGuid());
        Directory.CreateDirectory(folder);
        try {
            use(name => Path.Combine(folder, name));
        } finally {
            Directory.Delete(folder, true);
        }
    }

    void TestMeshes()
    {
        InFolder(path => {
            Mesh mesh = Checks.BallMesh(mesher);
            foreach (string name in new[] { "ä b.vtu", "a.msh", "a.mesh" }) {
                MeshFiles.WriteMesh(mesher, mesh, path(name));
                Checks.Check(File.Exists(path(name)), name);
                Checks.Equal(Content.Mesh, MeshFiles.Guess(path(name)));
                Checks.Equal(mesh.TetCount, MeshFiles.ReadMesh(mesher, path(name)).TetCount);
            }
            File.WriteAllText(path("names.txt"), "1 heart\n7 slab\n");
            MeshFiles.ReadLabelNames(mesher, mesh, path("names.txt"));
            Checks.Equal("slab", mesh.LabelNames[7]);
            Volume volume = Checks.BallVolume(mesher);
            MeshFiles.ReadLabelNames(mesher, volume, path("names.txt"));
            Checks.Equal("heart", volume.LabelNames[1]);
            MeshFiles.WriteMesh(mesher, mesh, path("b.dat"), "msh22");
            Checks.Check(File.ReadAllText(path("b.dat")).Contains("2.2"), "no msh 2.2");
            Checks.Thrown<ArgumentException>(() => MeshFiles.WriteMesh(mesher, mesh, path("b"), "jpeg"));
            Checks.Thrown<FileFailureException>(() => MeshFiles.WriteMesh(mesher, mesh, path("none/a.vtu")));
        });
    }

    void TestVolumes()
    {
        string path = Path.Combine(Data, "mickey.nrrd");
        Volume volume = MeshFiles.ReadVolume(mesher, path);
        Checks.Check(volume.Labels.Count > 1, "no labels");
        Checks.Equal(Content.Volume, MeshFiles.Guess(path));
        var reading = new Reading { World = World.Ras, Kind = VoxelKind.Labels, Spacing = new double[] { 0, 0, 9 } };
        Volume other = MeshFiles.ReadVolume(mesher, new[] { path }, null, reading);
        Checks.Near(-volume.Grid.Affine[0], other.Grid.Affine[0], 1e-12);
        Checks.Near(9, Math.Abs(other.Grid.Affine[10]), 1e-12);
    }

    void TestScale()
    {
        string path = Path.Combine(Data, "mickey.nrrd");
        double[] millimetres = MeshFiles.ReadVolume(mesher, path).Grid.Affine;
        double[] metres = MeshFiles.ReadVolume(mesher, path, null, new Reading { Scale = 0.001 }).Grid.Affine;
        for (int i = 0; i < 12; ++i)
            Checks.Near(millimetres[i] / 1000, metres[i], 1e-12);
    }

    /// <summary>A sentence may have any letters in it, also where it is cut off.</summary>
    void TestSentences()
    {
        string name = string.Concat(Enumerable.Repeat("\u00e4\ud83d\ude00", 40));
        string folder = string.Concat(Enumerable.Repeat("/no-" + name, 5));
        foreach (string prefix in new[] { "", "a", "aa", "aaa", "aaaa", "aaaaa" }) {
            var failure =
                Checks.Thrown<FileFailureException>(() => MeshFiles.ReadMesh(mesher, "/" + prefix + folder + ".vtu"));
            Checks.Check(failure.Message.Contains("/no-" + name), failure.Message);
        }
    }

    void TestRaw()
    {
        InFolder(path => {
            byte[] labels = Checks.BallLabels();
            byte[] shorts = new byte[4 + 2 * labels.Length];
            for (int i = 0; i < labels.Length; ++i)
                shorts[5 + 2 * i] = labels[i];
            File.WriteAllBytes(path("labels.raw"), shorts);
            var raw = new RawVoxels {
                Type = VoxelType.Int16, BigEndian = true, Skip = 4, Dims = new long[] { 12, 13, 14 },
                Spacing = new double[] { 1, 1, 1 } };
            Volume volume = MeshFiles.ReadRaw(mesher, raw, null, path("labels.raw"));
            Checks.Check(Checks.Same(Checks.BallMesh(mesher), mesher.Mesh(volume, Checks.Quick())), "another mesh");
            raw.Skip = 0;
            Checks.Thrown<CleftException>(() => MeshFiles.ReadRaw(mesher, raw, null, path("labels.raw")));
            raw.Dims = new long[2];
            Checks.Thrown<ArgumentException>(() => MeshFiles.ReadRaw(mesher, raw, null, path("labels.raw")));
        });
    }

    /// <summary>
    /// The kind decides what voxels mean, not their type; the volume reports how many functions it holds.
    /// </summary>
    void TestRawKinds()
    {
        InFolder(path => {
            var voxels = Enumerable.Range(0, 8);
            File.WriteAllBytes(
                path("one.raw"), voxels.SelectMany(v => BitConverter.GetBytes((float)(v % 2))).ToArray());
            File.WriteAllBytes(
                path("two.raw"), voxels.SelectMany(v => BitConverter.GetBytes((float)(1 - v % 2))).ToArray());
            foreach (VoxelKind kind in Enum.GetValues(typeof(VoxelKind))) {
                var raw = new RawVoxels { Type = VoxelType.Float32, Dims = new long[] { 2, 2, 2 }, Kind = kind };
                bool asFunctions = kind == VoxelKind.Indicators;
                Checks.Equal(asFunctions ? 1L : 0L,
                    MeshFiles.ReadRaw(mesher, raw, null, path("one.raw")).IndicatorCount);
                Checks.Equal(asFunctions ? 2L : 0L,
                    MeshFiles.ReadRaw(mesher, raw, null, path("one.raw"), path("two.raw")).IndicatorCount);
            }
        });
    }

    void TestMetric()
    {
        InFolder(path => {
            Volume volume = Checks.BallVolume(mesher);
            Sizing sizing = mesher.ConstantMetricSizing(volume, new[] { 0.3, 0.01, -0.02, 0.4, 0.03, 0.5 });
            MeshFiles.WriteSizing(mesher, sizing, path("metric.nrrd"));
            foreach (Volume given in new[] { volume, null }) {
                float[] again = MeshFiles.ReadMetric(mesher, given, path("metric.nrrd")).CopyMetric();
                Checks.Equal(6 * volume.Grid.Voxels, again.LongLength);
                Checks.Check(again.Zip(sizing.CopyMetric(), (a, b) => Math.Abs(a - b)).Max() < 1e-5, "tensors");
            }
        });
    }

    void TestSizing()
    {
        InFolder(path => {
            Volume volume = Checks.BallVolume(mesher);
            Sizing sizing = mesher.Sizing(volume, new Options { Size = 2.5 });
            MeshFiles.WriteSizing(mesher, sizing, path("sizes.nrrd"));
            Sizing again = MeshFiles.ReadSizing(mesher, volume, path("sizes.nrrd"));
            Checks.Equal(sizing.Values.ToArray(), again.Values.ToArray());
            double[] values = MeshFiles.ReadField(mesher, path("sizes.nrrd"), out Grid grid);
            Checks.Equal(volume.Grid.Dims, grid.Dims);
            Checks.Check(values.SequenceEqual(sizing.Values.Select(value => (double)value)), "values");
        });
    }

    void TestPictures()
    {
        InFolder(path => {
            Mesh mesh = Checks.BallMesh(mesher);
            MeshFiles.WritePicture(mesher, mesh, path("a.png"));
            MeshFiles.WritePicture(mesher, mesh, path("a.png"), new Picture {
                Width = 64, Height = 48, Cut = new[] { 0.5, 0, 0.5 }, By = Colouring.Angle, Range = new[] { 0.0, 90 },
                Backdrop = Backdrop.None, View = new[] { 0.0, 0, 1 }, Up = new[] { 1.0, 0, 0 }, Zoom = 2, Edges = false,
                LineWidth = 2, Legend = true, Whole = new[] { 1 }
            });
            byte[] bytes = File.ReadAllBytes(path("a.png"));
            Checks.Equal(64, (int)bytes[19]);
            Checks.Equal(48, (int)bytes[23]);
            Checks.Equal(6, (int)bytes[25]);
            Checks.Thrown<InvalidArgumentException>(() => MeshFiles.WritePicture(
                mesher, mesh, path("a.png"), new Picture { Cut = new[] { 0, 1.5, 0 } }));
            Checks.Thrown<InvalidArgumentException>(() => MeshFiles.WritePicture(
                mesher, mesh, path("a.png"), new Picture { Strip = mesh.Labels.ToArray() }));
            Checks.Thrown<ArgumentException>(() => MeshFiles.WritePicture(
                mesher, mesh, path("a.png"), new Picture { View = new double[2] }));
            Checks.Thrown<ArgumentException>(() => MeshFiles.WritePicture(
                mesher, mesh, path("a.png"), new Picture { Width = 0 }));
        });
    }

    void TestViews()
    {
        InFolder(path => {
            Mesh mesh = Checks.BallMesh(mesher);
            MeshFiles.WriteView(mesher, mesh, path("a.html"));
            Checks.Check(File.ReadAllText(path("a.html")).Contains("<title>Mesh</title>"), "no title");
            File.WriteAllText(path("names.txt"), "1 inner\n");
            MeshFiles.WriteView(mesher, mesh, path("a.html"), new View {
                Title = "a", Report = "{\"a\":1}", Names = path("names.txt"), Goal = 15, MaxTets = 5, Other = mesh,
                OtherTitle = "b", OtherReport = "{}"
            });
            string page = File.ReadAllText(path("a.html"));
            foreach (string part in new[] {
                "<title>a | b</title>", "{\"a\":1}", "\"name\":\"inner\"", "\"goal\":15,", "\"shown_tets\":5,"
            })
                Checks.Check(page.Contains(part), "no " + part);
            Checks.Thrown<InvalidArgumentException>(() => MeshFiles.WriteView(
                mesher, mesh, path("a.html"), new View { Goal = 91 }));
            Checks.Thrown<ArgumentException>(() => MeshFiles.WriteView(
                mesher, mesh, path("a.html"), new View { Title = "a\0" }));
        });
    }

    void TestFormats()
    {
        Checks.Check(MeshFiles.Formats().Any(row => row.Name == "vtu" && row.ReadsMesh && row.WritesMesh
            && row.Extensions.Contains(".vtu")), "no vtu");
        Checks.Check(MeshFiles.Formats().Any(row => row.ReadsVolume), "no volumes");
    }

    void TestFailures()
    {
        InFolder(path => {
            File.WriteAllText(path("broken.vtu"), "not XML");
            Checks.Thrown<InvalidFormatException>(() => MeshFiles.ReadMesh(mesher, path("broken.vtu")));
            Checks.Thrown<FileFailureException>(() => MeshFiles.ReadMesh(mesher, path("a.vtu")));
            Checks.Thrown<FileFailureException>(() => MeshFiles.ReadVolume(mesher, path("a.nii")));
            Checks.Thrown<InvalidArgumentException>(() => MeshFiles.ReadVolume(mesher, new string[0]));
            Checks.Thrown<ArgumentException>(() => MeshFiles.ReadMesh(mesher, "a\0b.vtu"));
            Checks.Thrown<ArgumentException>(() => MeshFiles.ReadVolume(
                mesher, path("a.nii"), null, new Reading { Spacing = new double[2] }));
        });
    }
}
