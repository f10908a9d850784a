using System;
using System.Collections.Generic;
using System.Runtime.ExceptionServices;
using System.Runtime.InteropServices;
using System.Threading;

namespace Cleft
{
    /// <summary>
    /// Makes volumes, sizing fields and meshes, and tells how they are made: with how many threads, with what progress. One call
    /// runs on a Mesher at a time; another thread that tries gets an InvalidOperationException. <see cref="Cancel"/> is for
    /// other threads. Where options may be null, null stands for the defaults.
    /// </summary>
    public sealed class Mesher : NativeObject
    {
        // What the library calls: held here as long as the context knows of them.
        private readonly NativeProgress nativeProgress;
        private readonly NativeLog nativeLog;
        private ExceptionDispatchInfo thrown;
        private int busy;

        /// <summary>A mesher with one thread.</summary>
        public Mesher() : base(Create())
        {
            nativeProgress = OnProgress;
            nativeLog = OnLog;
            CleftException.Check(CleftNative.cleft_context_set_progress(Handle, nativeProgress, IntPtr.Zero));
            CleftException.Check(CleftNative.cleft_context_set_log(Handle, nativeLog, IntPtr.Zero));
        }

        private static NativeHandle Create()
        {
            NativeModules.Core();
            CleftException.Check(CleftNative.cleft_context_create(out IntPtr made));
            return new NativeHandle(made, CleftNative.cleft_context_destroy);
        }

        /// <summary>
        /// Threads that calls use, 1 to 1024, or 0 for as many as the machine has. The result does not depend on it.
        /// </summary>
        public int Threads
        {
            get { return CleftNative.cleft_context_threads(Handle); }
            set { Run(context => CleftNative.cleft_context_set_threads(context, value)); }
        }

        /// <summary>
        /// Is told the fraction done and the stage in words, on the thread that made the call: true to go on, false to stop with
        /// a CancelledException. What it throws stops the call and comes out of it. May be null.
        /// </summary>
        public Func<double, string, bool> Progress { get; set; }

        /// <summary>
        /// Is told what is worth knowing, on the thread that made the call: at first <see cref="ShowWarnings"/>. May be null.
        /// </summary>
        public Action<LogLevel, string> Log { get; set; } = ShowWarnings;

        /// <summary>Prints warnings on the standard error, and nothing else.</summary>
        public static void ShowWarnings(LogLevel level, string sentence)
        {
            if (level == LogLevel.Warning)
                Console.Error.WriteLine("cleft: warning: " + sentence);
        }

        /// <summary>Stops calls with a CancelledException when it is cancelled.</summary>
        public CancellationToken Cancellation { get; set; }

        /// <summary>Asks the call that runs on this mesher to stop soon; from any thread.</summary>
        public void Cancel() { CleftException.Check(CleftNative.cleft_context_cancel(Handle)); }

        /// <summary>Figures that the stages noted: seconds, counts, angles before and after.</summary>
        public IReadOnlyDictionary<string, double> Metrics()
        {
            var figures = new Dictionary<string, double>();
            double[] value = new double[1];
            Run(context => {
                long count = CleftNative.cleft_context_metric_count(context);
                for (long index = 0; index < count; ++index) {
                    CleftException.Check(CleftNative.cleft_context_metric(context, index, out IntPtr name, value));
                    figures[Utf8.Read(name)] = value[0];
                }
                return CleftNative.CLEFT_OK;
            });
            return figures;
        }

        /// <summary>Forgets the figures.</summary>
        public void ClearMetrics() { Run(CleftNative.cleft_context_clear_metrics); }

        // ---------------------------------------------------------------------------------------------- volumes

        /// <summary>A label map, x fastest; copied. Of the options, the smoothing is read.</summary>
        public Volume Labels(byte[] voxels, Grid grid, Options options = null)
        {
            return Labels(voxels, VoxelType.UInt8, grid, options);
        }

        /// <summary>A label map, x fastest; copied. Of the options, the smoothing is read.</summary>
        public Volume Labels(short[] voxels, Grid grid, Options options = null)
        {
            return Labels(voxels, VoxelType.Int16, grid, options);
        }

        /// <summary>A label map, x fastest; copied. Of the options, the smoothing is read.</summary>
        public Volume Labels(ushort[] voxels, Grid grid, Options options = null)
        {
            return Labels(voxels, VoxelType.UInt16, grid, options);
        }

        /// <summary>A label map, x fastest; copied. Of the options, the smoothing is read.</summary>
        public Volume Labels(int[] voxels, Grid grid, Options options = null)
        {
            return Labels(voxels, VoxelType.Int32, grid, options);
        }

        /// <summary>A label map, x fastest; copied. Of the options, the smoothing is read.</summary>
        public Volume Labels(uint[] voxels, Grid grid, Options options = null)
        {
            return Labels(voxels, VoxelType.UInt32, grid, options);
        }

        /// <summary>
        /// A label map in memory of yours, x fastest, as many voxels as the grid has; copied. For volumes outside the heap.
        /// </summary>
        public Volume Labels(IntPtr voxels, VoxelType type, Grid grid, Options options = null)
        {
            Arguments.NotNull(grid, nameof(grid));
            CheckWhole(type);
            if (voxels == IntPtr.Zero)
                throw new ArgumentNullException(nameof(voxels));
            NativeHandle how = HandleOf(options);
            return new Volume(Make((NativeHandle context, out IntPtr made) => CleftNative.cleft_volume_create_labels(
                context, (int)type, voxels, grid.Dims, grid.Affine, how, out made)));
        }

        private Volume Labels(Array voxels, VoxelType type, Grid grid, Options options)
        {
            Arguments.NotNull(voxels, nameof(voxels));
            Arguments.NotNull(grid, nameof(grid));
            grid.CheckLength(voxels, nameof(voxels));
            return Pinned(new[] { voxels }, addresses => Labels(addresses[0], type, grid, options));
        }

        private static void CheckWhole(VoxelType type)
        {
            Arguments.Defined(type, nameof(type));
            if (type == VoxelType.Float32 || type == VoxelType.Float64)
                throw new ArgumentOutOfRangeException(nameof(type), type, "a label map has whole numbers");
        }

        /// <summary>
        /// Indicator functions, one for each material, x fastest; copied: the greatest wins. One alone is a signed function,
        /// inside where it is above 0. Labels: what the materials are called, two for one function, the outside first; or null
        /// for 0, 1, 2, ...
        /// </summary>
        public Volume Indicators(double[][] fields, Grid grid, int[] labels = null)
        {
            return Indicators(fields, VoxelType.Float64, grid, labels);
        }

        /// <summary>Indicator functions of single precision; else as those of double precision.</summary>
        public Volume Indicators(float[][] fields, Grid grid, int[] labels = null)
        {
            return Indicators(fields, VoxelType.Float32, grid, labels);
        }

        private Volume Indicators(Array[] fields, VoxelType type, Grid grid, int[] labels)
        {
            Arguments.NotNull(fields, nameof(fields));
            Arguments.NotNull(grid, nameof(grid));
            if (fields.Length == 0)
                throw new ArgumentException("fields has no elements; it must have one a material", nameof(fields));
            for (int k = 0; k < fields.Length; ++k)
                grid.CheckLength(fields[k], nameof(fields), "[" + k + "]");
            if (labels != null)
                Arguments.Length(labels, fields.Length == 1 ? 2 : fields.Length, nameof(labels));
            return Pinned(fields, addresses => new Volume(Make((NativeHandle context, out IntPtr made) =>
                CleftNative.cleft_volume_create_indicators(context, (int)type, addresses, addresses.Length, grid.Dims,
                    grid.Affine, labels, out made))));
        }

        // ----------------------------------------------------------------------------------------------- sizing

        /// <summary>The sizing field of a volume, from its features and the options of sizes.</summary>
        public Sizing Sizing(Volume volume, Options options = null)
        {
            NativeHandle of = Required(volume, nameof(volume)), how = HandleOf(options);
            return new Sizing(Make((NativeHandle context, out IntPtr made) =>
                CleftNative.cleft_sizing_create(context, of, how, out made)));
        }

        /// <summary>One size everywhere, in world units.</summary>
        public Sizing ConstantSizing(Volume volume, double size)
        {
            NativeHandle of = Required(volume, nameof(volume));
            return new Sizing(Make((NativeHandle context, out IntPtr made) =>
                CleftNative.cleft_sizing_create_constant(context, of, size, out made)));
        }

        /// <summary>
        /// A sizing field of your own, one edge length above 0 a voxel, x fastest; copied. With combine, the lesser of it and of
        /// the computed field, for which the options are read.
        /// </summary>
        public Sizing Sizing(Volume volume, double[] values, bool combine = false, Options options = null)
        {
            return Sizing(volume, values, VoxelType.Float64, combine, options);
        }

        /// <summary>A sizing field of your own in single precision; else as that of double precision.</summary>
        public Sizing Sizing(Volume volume, float[] values, bool combine = false, Options options = null)
        {
            return Sizing(volume, values, VoxelType.Float32, combine, options);
        }

        private Sizing Sizing(Volume volume, Array values, VoxelType type, bool combine, Options options)
        {
            NativeHandle of = Required(volume, nameof(volume)), how = HandleOf(options);
            volume.Grid.CheckLength(values, nameof(values));
            return Pinned(new[] { values }, addresses => new Sizing(Make((NativeHandle context, out IntPtr made) =>
                CleftNative.cleft_sizing_create_values(context, of, (int)type, addresses[0], combine ? 1 : 0, how, out made))));
        }

        // ----------------------------------------------------------------------------------------------- meshes

        /// <summary>Meshes a volume.</summary>
        public Mesh Mesh(Volume volume, Options options = null) { return Mesh(volume, null, null, options); }

        /// <summary>Meshes a volume with a sizing field or a background mesh of your own; both may be null.</summary>
        public Mesh Mesh(Volume volume, Sizing sizing, Mesh background, Options options = null)
        {
            NativeHandle of = Required(volume, nameof(volume)), how = HandleOf(options);
            NativeHandle sizes = HandleOf(sizing), behind = HandleOf(background);
            return new Mesh(Make((NativeHandle context, out IntPtr made) =>
                CleftNative.cleft_mesh_volume(context, of, sizes, behind, how, out made)));
        }

        /// <summary>The background mesh of a sizing field: it fills the box and knows nothing of labels.</summary>
        public Mesh BackgroundMesh(Sizing sizing, Options options = null)
        {
            NativeHandle sizes = Required(sizing, nameof(sizing)), how = HandleOf(options);
            return new Mesh(Make((NativeHandle context, out IntPtr made) =>
                CleftNative.cleft_background_create(context, sizes, how, out made)));
        }

        /// <summary>Cleaves a background mesh along the interfaces of a volume.</summary>
        public Mesh Cleave(Volume volume, Mesh background, Options options = null)
        {
            NativeHandle of = Required(volume, nameof(volume)), how = HandleOf(options);
            NativeHandle behind = Required(background, nameof(background));
            return new Mesh(Make((NativeHandle context, out IntPtr made) =>
                CleftNative.cleft_mesh_cleave(context, of, behind, how, out made)));
        }

        /// <summary>Raises the worst dihedral angles of a cleaved mesh of this volume.</summary>
        public Mesh Improve(Volume volume, Mesh cleaved, Options options = null)
        {
            NativeHandle of = Required(volume, nameof(volume)), how = HandleOf(options);
            NativeHandle mesh = Required(cleaved, nameof(cleaved));
            return new Mesh(Make((NativeHandle context, out IntPtr made) =>
                CleftNative.cleft_mesh_improve(context, of, mesh, how, out made)));
        }

        /// <summary>The mesh without the labels that Options.Strip and Options.Only leave out.</summary>
        public Mesh Strip(Mesh whole, Options options)
        {
            NativeHandle mesh = Required(whole, nameof(whole)), how = Required(options, nameof(options));
            return new Mesh(Make((NativeHandle context, out IntPtr made) =>
                CleftNative.cleft_mesh_strip(context, mesh, how, out made)));
        }

        /// <summary>
        /// A mesh from arrays, which are copied: x y z of each point, 4 numbers of points a tetrahedron counted from indexBase
        /// (0 or 1), and their labels, or null for 0.
        /// </summary>
        public Mesh MeshOf(double[] points, int[] tets, int[] labels = null, int indexBase = 0)
        {
            Arguments.Groups(points, 3, "point", nameof(points));
            Arguments.Groups(tets, 4, "tetrahedron", nameof(tets));
            if (labels != null)
                Arguments.Length(labels, tets.Length / 4, nameof(labels));
            Arguments.IndexBase(indexBase, nameof(indexBase));
            return new Mesh(Make((NativeHandle context, out IntPtr made) => CleftNative.cleft_mesh_create(
                context, points.Length / 3, points, tets.Length / 4, tets, labels, indexBase, out made)));
        }

        // ------------------------------------------------------------------------------------- what meshes are

        /// <summary>The shape of the tetrahedra in figures.</summary>
        public Quality Quality(Mesh mesh)
        {
            NativeHandle of = Required(mesh, nameof(mesh));
            using (var figures = new NativeQuality()) {
                Run(context => CleftNative.cleft_mesh_quality(context, of, figures));
                return new Quality(figures);
            }
        }

        /// <summary>Looks for faults. With fillsBox, the mesh is also asked to fill its bounding box.</summary>
        public Validation Validate(Mesh mesh, bool fillsBox = false)
        {
            NativeHandle of = Required(mesh, nameof(mesh));
            using (var found = new NativeValidation()) {
                string sentence = "";
                Run(context => {
                    int status = CleftNative.cleft_mesh_validate(context, of, fillsBox ? 1 : 0, found);
                    sentence = CleftNative.cleft_context_last_error(context);
                    return status;
                });
                return new Validation(found, sentence);
            }
        }

        /// <summary>The triangles between labels and those of the hull.</summary>
        public Surface Surface(Mesh mesh)
        {
            NativeHandle of = Required(mesh, nameof(mesh));
            return new Surface(Make((NativeHandle context, out IntPtr made) =>
                CleftNative.cleft_surface_create(context, of, out made)));
        }

        /// <summary>
        /// What became of each label, for a mesh that was not stripped, in the order of Volume.Labels; and which labels touch in the
        /// mesh alone.
        /// </summary>
        public Report Report(Volume volume, Mesh mesh)
        {
            NativeHandle before = Required(volume, nameof(volume)), after = Required(mesh, nameof(mesh));
            IntPtr address = Make((NativeHandle context, out IntPtr made) =>
                CleftNative.cleft_report_create(context, before, after, out made));
            using (var report = new NativeHandle(address, CleftNative.cleft_report_destroy))
                return new Report(report);
        }

        // ------------------------------------------------------------------------------------------------ calls

        internal override string Description => " of " + Threads + " threads";

        internal delegate int Maker(NativeHandle context, out IntPtr made);

        /// <summary>Runs a call that makes something, and answers its address.</summary>
        internal IntPtr Make(Maker maker)
        {
            IntPtr made = IntPtr.Zero;
            Run(context => maker(context, out made));
            return made;
        }

        /// <summary>Runs a call on this context; what a function of the user threw comes out first.</summary>
        internal void Run(Func<NativeHandle, int> call)
        {
            if (Interlocked.CompareExchange(ref busy, 1, 0) != 0)
                throw new InvalidOperationException("this Mesher is running another call; use one Mesher a thread");
            try {
                NativeHandle context = Handle;
                thrown = null;
                bool held = false;
                try {
                    context.DangerousAddRef(ref held);  // also while the sentence of a failure is read
                    int status = call(context);
                    thrown?.Throw();
                    if (status == CleftNative.CLEFT_ERROR_CANCELLED && Cancellation.IsCancellationRequested)
                        throw new CancelledException(Sentence(context), Cancellation);
                    if (status != CleftNative.CLEFT_OK)
                        CleftException.Check(status, status == CleftNative.CLEFT_ERROR_BUSY ? null : Sentence(context));
                } finally {
                    if (held)
                        context.DangerousRelease();
                    GC.KeepAlive(this);
                }
            } finally {
                Volatile.Write(ref busy, 0);
            }
        }

        private static string Sentence(NativeHandle context)
        {
            return context.IsClosed ? null : Wording.InCSharp(CleftNative.cleft_context_last_error(context));
        }

        private int OnProgress(double fraction, IntPtr stage, IntPtr user)
        {
            try {
                if (thrown != null || Cancellation.IsCancellationRequested)
                    return 1;
                Func<double, string, bool> progress = Progress;
                return progress == null || progress(fraction, Utf8.Read(stage)) ? 0 : 1;
            } catch (Exception failure) {
                thrown = ExceptionDispatchInfo.Capture(failure);
                return 1;
            }
        }

        private void OnLog(int level, IntPtr sentence, IntPtr user)
        {
            try {
                if (thrown == null)
                    Log?.Invoke((LogLevel)level, Wording.InCSharp(Utf8.Read(sentence)));
            } catch (Exception failure) {
                thrown = ExceptionDispatchInfo.Capture(failure);
            }
        }

        /// <summary>Runs something with the addresses of arrays that the collector leaves where they are.</summary>
        private static T Pinned<T>(Array[] arrays, Func<IntPtr[], T> use)
        {
            var pins = new List<GCHandle>();
            try {
                foreach (Array array in arrays)
                    pins.Add(GCHandle.Alloc(array, GCHandleType.Pinned));
                return use(pins.ConvertAll(pin => pin.AddrOfPinnedObject()).ToArray());
            } finally {
                pins.ForEach(pin => pin.Free());
            }
        }
    }
}
