using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Cleft
{
    /// <summary>How to read a volume; as the file says, if nothing is set.</summary>
    public sealed class Reading
    {
        /// <summary>The axes that coordinates come out in.</summary>
        public World World { get; set; }
        /// <summary>What the voxels mean.</summary>
        public VoxelKind Kind { get; set; }
        /// <summary>Three lengths taken instead of the file's, 0 for the file's; or null. The origin stays.</summary>
        public double[] Spacing { get; set; }
        /// <summary>What the file's origin and spacing are multiplied by: 0.001 makes metres of millimetres.</summary>
        public double Scale { get; set; } = 1;

        internal NativeReading ToNative()
        {
            if (Spacing != null)
                Arguments.Length(Spacing, 3, nameof(Spacing));
            for (int axis = 0; Spacing != null && axis < 3; ++axis)
                if (Spacing[axis] != 0)
                    Arguments.Positive(Spacing[axis], nameof(Spacing));
            Arguments.Positive(Scale, nameof(Scale));
            var reading = new NativeReading {
                world = (int)Arguments.Defined(World, nameof(World)), kind = (int)Arguments.Defined(Kind, nameof(Kind)),
                scale = Scale
            };
            for (int axis = 0; Spacing != null && axis < 3; ++axis)
                reading.set_spacing(axis, Spacing[axis]);
            return reading;
        }
    }

    /// <summary>How voxels without a header lie in a file, x fastest.</summary>
    public sealed class RawVoxels
    {
        /// <summary>The type of the voxels.</summary>
        public VoxelType Type { get; set; } = VoxelType.UInt8;
        /// <summary>Does the most significant byte come first?</summary>
        public bool BigEndian { get; set; }
        /// <summary>Bytes before the first voxel.</summary>
        public long Skip { get; set; }
        /// <summary>Voxels along x, y and z.</summary>
        public long[] Dims { get; set; }
        /// <summary>Lengths of a voxel; or null for 1.</summary>
        public double[] Spacing { get; set; }
        /// <summary>What the voxels mean.</summary>
        public VoxelKind Kind { get; set; }

        internal NativeRaw ToNative()
        {
            Arguments.Length(Dims, 3, nameof(Dims));
            foreach (long voxels in Dims)
                Arguments.AtLeastOne(voxels, nameof(Dims));
            if (Spacing != null)
                Arguments.Length(Spacing, 3, nameof(Spacing));
            for (int axis = 0; Spacing != null && axis < 3; ++axis)
                Arguments.Positive(Spacing[axis], nameof(Spacing));
            if (Skip < 0)
                throw new ArgumentOutOfRangeException(nameof(Skip), Skip, "Skip must not be negative");
            var raw = new NativeRaw {
                type = (int)Arguments.Defined(Type, nameof(Type)), big_endian = BigEndian ? 1 : 0, skip = Skip,
                kind = (int)Arguments.Defined(Kind, nameof(Kind))
            };
            for (int axis = 0; axis < 3; ++axis)
                raw.set_axis(axis, Dims[axis], Spacing == null ? 0 : Spacing[axis]);
            return raw;
        }
    }

    /// <summary>A format of files.</summary>
    public sealed class FileFormat
    {
        internal FileFormat(NativeFormatDescription row)
        {
            Name = row.name;
            Number = row.format;
            Extensions = row.extensions.Split(new[] { ' ' }, StringSplitOptions.RemoveEmptyEntries);
            Text = row.text;
            ReadsMesh = (row.directions & CleftIoNative.CLEFT_IO_READS_MESH) != 0;
            WritesMesh = (row.directions & CleftIoNative.CLEFT_IO_WRITES_MESH) != 0;
            ReadsVolume = (row.directions & CleftIoNative.CLEFT_IO_READS_VOLUME) != 0;
            WritesSizing = (row.directions & CleftIoNative.CLEFT_IO_WRITES_SIZING) != 0;
        }

        internal int Number { get; }
        /// <summary>As in "msh22", to write a mesh in it.</summary>
        public string Name { get; }
        /// <summary>As in ".nii.gz".</summary>
        public IReadOnlyList<string> Extensions { get; }
        /// <summary>What it holds.</summary>
        public string Text { get; }
        /// <summary>Are meshes read?</summary>
        public bool ReadsMesh { get; }
        /// <summary>Are meshes written?</summary>
        public bool WritesMesh { get; }
        /// <summary>Are volumes read?</summary>
        public bool ReadsVolume { get; }
        /// <summary>Are sizing fields written?</summary>
        public bool WritesSizing { get; }
    }

    /// <summary>
    /// Reads and writes files. The native part is loaded when it is first used; it needs GDCM and libraries of
    /// pictures.
    /// </summary>
    public static class MeshFiles
    {
        /// <summary>The formats that are read and written.</summary>
        public static IReadOnlyList<FileFormat> Formats()
        {
            NativeModules.Files();
            var formats = new List<FileFormat>();
            for (int index = 0; index < CleftIoNative.cleft_io_format_count(); ++index)
                using (var row = new NativeFormatDescription()) {
                    CleftException.Check(CleftIoNative.cleft_io_format_info(index, row));
                    formats.Add(new FileFormat(row));
                }
            return formats;
        }

        /// <summary>What a file most likely holds.</summary>
        public static Content Guess(string path)
        {
            NativeModules.Files();
            return (Content)CleftIoNative.cleft_io_guess(Utf8.Write(path, nameof(path)));
        }

        /// <summary>
        /// Reads a volume as its file says: NIfTI, NRRD, MetaImage, TIFF, a folder with a DICOM series ...
        /// </summary>
        public static Volume ReadVolume(Mesher mesher, string path, Options options = null, Reading reading = null)
        {
            Arguments.NotNull(path, nameof(path));
            return ReadVolume(mesher, new[] { path }, options, reading);
        }

        /// <summary>Reads a volume from one file, or from one a material: masks or indicator functions.</summary>
        public static Volume ReadVolume(Mesher mesher, string[] paths, Options options = null, Reading reading = null)
        {
            Arguments.NotNull(mesher, nameof(mesher));
            Arguments.NotNull(paths, nameof(paths));
            NativeModules.Files();
            NativeHandle how = NativeObject.HandleOf(options);
            using (NativeReading native = (reading ?? new Reading()).ToNative())
                return WithPaths(paths, names => new Volume(mesher.Make((NativeHandle context, out IntPtr made) =>
                    CleftIoNative.cleft_io_read_volume(context, how, names, names.Length, native, out made))));
        }

        /// <summary>Reads voxels without a header from one file, or from one a material, as in ReadVolume().</summary>
        public static Volume ReadRaw(Mesher mesher, RawVoxels raw, Options options, params string[] paths)
        {
            Arguments.NotNull(mesher, nameof(mesher));
            Arguments.NotNull(raw, nameof(raw));
            NativeModules.Files();
            NativeHandle how = NativeObject.HandleOf(options);
            using (NativeRaw native = raw.ToNative())
                return WithPaths(paths, names => new Volume(mesher.Make((NativeHandle context, out IntPtr made) =>
                    CleftIoNative.cleft_io_read_raw(context, how, names, names.Length, native, out made))));
        }

        /// <summary>
        /// Reads a field of one number a voxel, x fastest; <paramref name="grid"/>: where the voxels lie.
        /// </summary>
        public static double[] ReadField(Mesher mesher, string path, out Grid grid, Reading reading = null)
        {
            Arguments.NotNull(mesher, nameof(mesher));
            byte[] name = Utf8.Write(path, nameof(path));
            NativeModules.Files();
            long[] dims = new long[3];
            double[] affine = new double[12];
            IntPtr values;
            using (NativeReading native = (reading ?? new Reading()).ToNative())
                values = mesher.Make((NativeHandle context, out IntPtr made) =>
                    CleftIoNative.cleft_io_read_field(context, name, native, dims, affine, out made));
            try {
                grid = new Grid(dims[0], dims[1], dims[2]).WithAffine(affine);
                double[] copy = new double[grid.Voxels];
                Marshal.Copy(values, copy, 0, copy.Length);
                return copy;
            } finally {
                CleftIoNative.cleft_io_free(values);
            }
        }

        /// <summary>Reads a sizing field of your own, from a file with the same voxels as the volume.</summary>
        public static Sizing ReadSizing(Mesher mesher, Volume volume, string path, bool combine = false,
                                        Options options = null, Reading reading = null)
        {
            Arguments.NotNull(mesher, nameof(mesher));
            byte[] name = Utf8.Write(path, nameof(path));
            NativeModules.Files();
            NativeHandle of = NativeObject.Required(volume, nameof(volume)), how = NativeObject.HandleOf(options);
            using (NativeReading native = (reading ?? new Reading()).ToNative())
                return new Sizing(mesher.Make((NativeHandle context, out IntPtr made) =>
                    CleftIoNative.cleft_io_read_sizing(context, of, name, native, combine ? 1 : 0, how, out made)));
        }

        /// <summary>
        /// Reads a metric of your own, from a file with the same voxels as the volume; null for the voxels of the file.
        /// </summary>
        public static Sizing ReadMetric(Mesher mesher, Volume volume, string path,
                                        TensorOrder order = TensorOrder.File, bool combine = false,
                                        Options options = null, Reading reading = null)
        {
            Arguments.NotNull(mesher, nameof(mesher));
            Arguments.Defined(order, nameof(order));
            byte[] name = Utf8.Write(path, nameof(path));
            NativeModules.Files();
            NativeHandle of = NativeObject.HandleOf(volume), how = NativeObject.HandleOf(options);
            using (NativeReading native = (reading ?? new Reading()).ToNative())
                return new Sizing(mesher.Make((NativeHandle context, out IntPtr made) =>
                    CleftIoNative.cleft_io_read_metric(
                        context, of, name, native, (int)order, combine ? 1 : 0, how, out made)));
        }

        /// <summary>Writes a sizing field as a volume of numbers, or of tensors if it has a metric.</summary>
        public static void WriteSizing(Mesher mesher, Sizing sizing, string path, World world = World.Lps)
        {
            Arguments.NotNull(mesher, nameof(mesher));
            byte[] name = Utf8.Write(path, nameof(path));
            NativeModules.Files();
            NativeHandle of = NativeObject.Required(sizing, nameof(sizing));
            mesher.Run(context =>
                CleftIoNative.cleft_io_write_sizing(context, of, name, (int)Arguments.Defined(world, nameof(world))));
        }

        /// <summary>Reads a mesh of tetrahedra: .vtu, .pvtu, .vtk, .vtkhdf, .mesh, .msh, .node with .ele.</summary>
        public static Mesh ReadMesh(Mesher mesher, string path)
        {
            Arguments.NotNull(mesher, nameof(mesher));
            byte[] name = Utf8.Write(path, nameof(path));
            NativeModules.Files();
            return new Mesh(mesher.Make((NativeHandle context, out IntPtr made) =>
                CleftIoNative.cleft_io_read_mesh(context, name, out made)));
        }

        /// <summary>
        /// Writes a mesh, all or nothing, in the format of that name (see Formats()), or of the extension of the path.
        /// </summary>
        public static void WriteMesh(Mesher mesher, Mesh mesh, string path, string format = null)
        {
            Arguments.NotNull(mesher, nameof(mesher));
            byte[] name = Utf8.Write(path, nameof(path));
            NativeModules.Files();
            NativeHandle of = NativeObject.Required(mesh, nameof(mesh));
            int number = format == null ? CleftIoNative.CLEFT_FORMAT_BY_NAME : NumberOf(format);
            mesher.Run(context => CleftIoNative.cleft_io_write_mesh(context, of, name, number));
        }

        /// <summary>
        /// Names the labels of a volume by a table: a label and its name a line, or a table of ITK-SNAP, FreeSurfer,
        /// MRIcron or BIDS. Not while another thread uses the volume.
        /// </summary>
        public static void ReadLabelNames(Mesher mesher, Volume volume, string path)
        {
            Arguments.NotNull(mesher, nameof(mesher));
            byte[] name = Utf8.Write(path, nameof(path));
            NativeModules.Files();
            NativeHandle of = NativeObject.Required(volume, nameof(volume));
            mesher.Run(context => CleftIoNative.cleft_io_read_volume_names(context, name, of));
        }

        /// <summary>Names the labels of a mesh by such a table. Not while another thread uses the mesh.</summary>
        public static void ReadLabelNames(Mesher mesher, Mesh mesh, string path)
        {
            Arguments.NotNull(mesher, nameof(mesher));
            byte[] name = Utf8.Write(path, nameof(path));
            NativeModules.Files();
            NativeHandle of = NativeObject.Required(mesh, nameof(mesh));
            mesher.Run(context => CleftIoNative.cleft_io_read_mesh_names(context, name, of));
        }

        /// <summary>Draws a mesh as PNG, without a screen.</summary>
        public static void WritePicture(Mesher mesher, Mesh mesh, string path, Picture picture = null)
        {
            Arguments.NotNull(mesher, nameof(mesher));
            byte[] name = Utf8.Write(path, nameof(path));
            NativeModules.Files();
            NativeHandle of = NativeObject.Required(mesh, nameof(mesh));
            Picture wanted = picture ?? new Picture();
            int[] strip = Arguments.NotNull(wanted.Strip, nameof(picture.Strip));
            int[] whole = Arguments.NotNull(wanted.Whole, nameof(picture.Whole));
            using (NativePicture look = wanted.ToNative())
                mesher.Run(context => CleftIoNative.cleft_io_write_picture(
                    context, of, strip, strip.Length, whole, whole.Length, look, name));
        }

        /// <summary>Writes a page that shows a mesh in any browser.</summary>
        public static void WriteView(Mesher mesher, Mesh mesh, string path, View view = null)
        {
            Arguments.NotNull(mesher, nameof(mesher));
            byte[] file = Utf8.Write(path, nameof(path));
            NativeModules.Files();
            NativeHandle of = NativeObject.Required(mesh, nameof(mesh));
            View page = view ?? new View();
            NativeHandle other = NativeObject.HandleOf(page.Other);
            byte[] title = View.Text(page.Title, nameof(page.Title));
            byte[] report = View.Text(page.Report, nameof(page.Report));
            byte[] names = View.Text(page.Names, nameof(page.Names));
            byte[] otherTitle = View.Text(page.OtherTitle, nameof(page.OtherTitle));
            byte[] otherReport = View.Text(page.OtherReport, nameof(page.OtherReport));
            mesher.Run(context => CleftIoNative.cleft_io_write_view(
                context, of, page.MaxTets, page.Goal, title, report, names, other, otherTitle, otherReport, file));
        }

        private static int NumberOf(string format)
        {
            var names = new List<string>();
            foreach (FileFormat row in Formats())
                if (row.WritesMesh && row.Name == format)
                    return row.Number;
                else if (row.WritesMesh)
                    names.Add(row.Name);
            throw new ArgumentException(
                "format is '" + format + "'; it must be one of " + string.Join(", ", names), nameof(format));
        }

        /// <summary>Runs something with texts that lie outside the heap for the while.</summary>
        private static T WithPaths<T>(string[] paths, Func<IntPtr[], T> use)
        {
            IntPtr[] names = new IntPtr[Arguments.NotNull(paths, nameof(paths)).Length];
            try {
                for (int i = 0; i < paths.Length; ++i) {
                    byte[] bytes = Utf8.Write(paths[i], nameof(paths));
                    names[i] = Marshal.AllocHGlobal(bytes.Length);
                    Marshal.Copy(bytes, 0, names[i], bytes.Length);
                }
                return use(names);
            } finally {
                foreach (IntPtr name in names)
                    Marshal.FreeHGlobal(name);
            }
        }
    }
}
