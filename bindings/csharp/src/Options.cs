using System;

namespace Cleft
{
    /// <summary>
    /// How to mesh: new Options { SizeMax = 3, Background = Background.Octree, Strip = new[] { 0 } }. Values that are
    /// not set are the library's defaults; OptionDescription.Table() lists them with their ranges. A value out of its
    /// range throws an InvalidOptionException, and leaves the option as it was. For one thread at a time.
    /// </summary>
    public sealed class Options : NativeObject
    {
        private int[] strip = new int[0];
        private int[] only = new int[0];

        /// <summary>Options with their defaults.</summary>
        public Options() : base(Create()) { }

        private static NativeHandle Create()
        {
            NativeModules.Core();
            CleftException.Check(CleftNative.cleft_options_create(out IntPtr made));
            return new NativeHandle(made, CleftNative.cleft_options_destroy);
        }

        // <options> made by tools/generate.py from src/capi/options.toml

        /// <summary>Kind of background mesh (particles, lattice or octree; default particles).</summary>
        public Cleft.Background Background
        {
            get { return (Cleft.Background)Integer(CleftNative.CLEFT_OPTION_BACKGROUND); }
            set { Set(CleftNative.CLEFT_OPTION_BACKGROUND, (long)value); }
        }

        /// <summary>
        /// One wanted edge length everywhere, in world units. 0: the library computes it from the features of the
        /// volume (at least 0; default 0).
        /// </summary>
        public double Size
        {
            get { return Real(CleftNative.CLEFT_OPTION_SIZE); }
            set { Set(CleftNative.CLEFT_OPTION_SIZE, value); }
        }

        /// <summary>
        /// Least wanted edge length, in world units. 0: the least voxel spacing (at least 0; default 0).
        /// </summary>
        public double SizeMin
        {
            get { return Real(CleftNative.CLEFT_OPTION_SIZE_MIN); }
            set { Set(CleftNative.CLEFT_OPTION_SIZE_MIN, value); }
        }

        /// <summary>
        /// Greatest wanted edge length, in world units. Single edges may be up to 2.3 times as long. 0: a quarter of
        /// the longest side of the box, or 1.5 times its thickness if that is less (at least 0; default 0).
        /// </summary>
        public double SizeMax
        {
            get { return Real(CleftNative.CLEFT_OPTION_SIZE_MAX); }
            set { Set(CleftNative.CLEFT_OPTION_SIZE_MAX, value); }
        }

        /// <summary>
        /// Edge length at an interface divided by the local feature size. 0.5 gives a fine mesh, 2 a coarse one (0.001
        /// to 1000; default 1).
        /// </summary>
        public double FeatureScale
        {
            get { return Real(CleftNative.CLEFT_OPTION_FEATURE_SCALE); }
            set { Set(CleftNative.CLEFT_OPTION_FEATURE_SCALE, value); }
        }

        /// <summary>
        /// Greatest growth of the edge length per unit of distance (the Lipschitz constant of the sizing field). 0.15
        /// is gentle, 1 is steep (0.01 to 1; default 0.3).
        /// </summary>
        public double Gradation
        {
            get { return Real(CleftNative.CLEFT_OPTION_GRADATION); }
            set { Set(CleftNative.CLEFT_OPTION_GRADATION, value); }
        }

        /// <summary>
        /// Greatest wanted edge length at interfaces, in world units. 0: no limit (at least 0; default 0).
        /// </summary>
        public double InterfaceSize
        {
            get { return Real(CleftNative.CLEFT_OPTION_INTERFACE_SIZE); }
            set { Set(CleftNative.CLEFT_OPTION_INTERFACE_SIZE, value); }
        }

        /// <summary>
        /// Greatest distance, in world units, that triangles of an interface shall have from it. Sizes follow the
        /// curvature of the interface. -1: half the least voxel spacing; a label map says no more. 0: no limit (at
        /// least -1; default -1).
        /// </summary>
        public double SurfaceError
        {
            get { return Real(CleftNative.CLEFT_OPTION_SURFACE_ERROR); }
            set { Set(CleftNative.CLEFT_OPTION_SURFACE_ERROR, value); }
        }

        /// <summary>
        /// Greatest edge length along an interface divided by that across it. Elements are long where the interface is
        /// flat, and where voxels are long. Angles are then good in the metric of the lengths. It takes the particles
        /// background. 1: lengths are the same in all directions (1 to 1000; default 1).
        /// </summary>
        public double Anisotropy
        {
            get { return Real(CleftNative.CLEFT_OPTION_ANISOTROPY); }
            set { Set(CleftNative.CLEFT_OPTION_ANISOTROPY, value); }
        }

        /// <summary>
        /// Use edges of half the least voxel spacing, or of SizeMin, where a label is one voxel thick. The mesh then
        /// keeps such parts whole (on or off; default off).
        /// </summary>
        public bool KeepThin
        {
            get { return Integer(CleftNative.CLEFT_OPTION_KEEP_THIN) != 0; }
            set { Set(CleftNative.CLEFT_OPTION_KEEP_THIN, value ? 1L : 0L); }
        }

        /// <summary>
        /// Wanted number of tetrahedra in the kept labels, met within 10 %. The library scales the sizes for it, and
        /// MaxTets does not limit them. 0: the sizes decide (0 to 2147483647; default 0).
        /// </summary>
        public long Tets
        {
            get { return Integer(CleftNative.CLEFT_OPTION_TETS); }
            set { Set(CleftNative.CLEFT_OPTION_TETS, value); }
        }

        /// <summary>
        /// Greatest expected number of background tetrahedra. To keep to it, the library raises the least edge length,
        /// but only if size, SizeMin and tets are 0. If tets is set and labels are left out, MaxTets limits the whole
        /// mesh instead. 0: no limit (0 to 2147483647; default 10000000).
        /// </summary>
        public long MaxTets
        {
            get { return Integer(CleftNative.CLEFT_OPTION_MAX_TETS); }
            set { Set(CleftNative.CLEFT_OPTION_MAX_TETS, value); }
        }

        /// <summary>
        /// Width, in voxels, of the kernel that smooths a label map when the volume is made (2 to 6; default 5). It
        /// counts where a volume is made or read: a finished volume keeps its own.
        /// </summary>
        public int Smooth
        {
            get { return (int)Integer(CleftNative.CLEFT_OPTION_SMOOTH); }
            set { Set(CleftNative.CLEFT_OPTION_SMOOTH, (long)value); }
        }

        /// <summary>
        /// Rule that moves background points onto interfaces. The rule quality looks at the surrounding elements, and
        /// safe keeps to the safe distances of the published method. The rule none moves no point (quality, safe or
        /// none; default quality).
        /// </summary>
        public Cleft.Snap Snap
        {
            get { return (Cleft.Snap)Integer(CleftNative.CLEFT_OPTION_SNAP); }
            set { Set(CleftNative.CLEFT_OPTION_SNAP, (long)value); }
        }

        /// <summary>
        /// Effort spent on the worst dihedral angles after cleaving (off, fast or best; default fast).
        /// </summary>
        public Cleft.Improvement Improve
        {
            get { return (Cleft.Improvement)Integer(CleftNative.CLEFT_OPTION_IMPROVE); }
            set { Set(CleftNative.CLEFT_OPTION_IMPROVE, (long)value); }
        }

        /// <summary>
        /// Dihedral angle, in degrees, that no tetrahedron shall be below. A greatest angle and a greatest radius ratio
        /// go with it: 148.5 degrees and 8.0 with 25, 141.8 and 6.8 with 30. A warning says how many tetrahedra miss
        /// them. 0: 25, or 32 where improve is best (0 to 35; default 0).
        /// </summary>
        public double MinAngle
        {
            get { return Real(CleftNative.CLEFT_OPTION_MIN_ANGLE); }
            set { Set(CleftNative.CLEFT_OPTION_MIN_ANGLE, value); }
        }

        /// <summary>Number of relaxation steps of the particles (0 to 1000; default 8).</summary>
        public int Steps
        {
            get { return (int)Integer(CleftNative.CLEFT_OPTION_STEPS); }
            set { Set(CleftNative.CLEFT_OPTION_STEPS, (long)value); }
        }

        /// <summary>
        /// Number that varies the arrangement of the particles. The same seed gives the same mesh (at least 0; default
        /// 0).
        /// </summary>
        public long Seed
        {
            get { return Integer(CleftNative.CLEFT_OPTION_SEED); }
            set { Set(CleftNative.CLEFT_OPTION_SEED, value); }
        }

        /// <summary>
        /// Fail if the mesh loses a kept label, or loses or breaks a piece of one of more than 30 voxels. Fail too if
        /// two kept labels meet in the mesh but not in the voxels (on or off; default off).
        /// </summary>
        public bool Strict
        {
            get { return Integer(CleftNative.CLEFT_OPTION_STRICT) != 0; }
            set { Set(CleftNative.CLEFT_OPTION_STRICT, value ? 1L : 0L); }
        }

        /// <summary>
        /// Dihedral angle, in degrees, below which tetrahedra of a user-supplied background are repaired before
        /// cleaving. 0: no repair (0 to 35; default 30).
        /// </summary>
        public double Repair
        {
            get { return Real(CleftNative.CLEFT_OPTION_REPAIR); }
            set { Set(CleftNative.CLEFT_OPTION_REPAIR, value); }
        }

        /// <summary>
        /// Thickness, in voxels, of the slabs that are meshed one by one and then joined. No size is more than a
        /// quarter of it, and the mesh differs a little from that of the whole volume. 0: the whole volume at once (0
        /// to 1000000; default 0).
        /// </summary>
        public long Block
        {
            get { return Integer(CleftNative.CLEFT_OPTION_BLOCK); }
            set { Set(CleftNative.CLEFT_OPTION_BLOCK, value); }
        }

        /// <summary>
        /// Engine that makes the tetrahedra of the particles. Both give the same mesh; a library may be built without
        /// TetGen (cleft or tetgen; default cleft).
        /// </summary>
        public Cleft.DelaunayEngine Delaunay
        {
            get { return (Cleft.DelaunayEngine)Integer(CleftNative.CLEFT_OPTION_DELAUNAY); }
            set { Set(CleftNative.CLEFT_OPTION_DELAUNAY, (long)value); }
        }

        // </options>

        /// <summary>Labels whose tetrahedra are left out of the finished mesh.</summary>
        public int[] Strip
        {
            get { return (int[])strip.Clone(); }
            set {
                Arguments.NotNull(value, nameof(Strip));
                Refused(CleftNative.cleft_options_set_strip(Handle, value, value.Length));
                strip = (int[])value.Clone();
            }
        }

        /// <summary>Labels whose tetrahedra alone are kept; none: all are.</summary>
        public int[] Only
        {
            get { return (int[])only.Clone(); }
            set {
                Arguments.NotNull(value, nameof(Only));
                Refused(CleftNative.cleft_options_set_only(Handle, value, value.Length));
                only = (int[])value.Clone();
            }
        }

        /// <summary>
        /// Sets the greatest wanted edge length inside one label, in world units; 0 removes the limit for this label.
        /// </summary>
        public Options SetLabelSize(int label, double size)
        {
            Refused(CleftNative.cleft_options_set_label_size(Handle, label, size));
            return this;
        }

        /// <summary>Sets an option by name from text, as the command line does.</summary>
        public Options Set(string name, string value)
        {
            Arguments.NotNull(name, nameof(name));
            Arguments.NotNull(value, nameof(value));
            int status = CleftNative.cleft_options_set_text(Handle, name, value);
            if (status != CleftNative.CLEFT_OK)  // in the words of the library, which are those of the caller here
                CleftException.Check(status, CleftNative.cleft_options_last_error(Handle));
            return this;
        }

        private void Set(int key, long value) { Refused(CleftNative.cleft_options_set_integer(Handle, key, value)); }

        private void Set(int key, double value) { Refused(CleftNative.cleft_options_set_real(Handle, key, value)); }

        private long Integer(int key)
        {
            long[] value = new long[1];
            Refused(CleftNative.cleft_options_get_integer(Handle, key, value));
            return value[0];
        }

        private double Real(int key)
        {
            double[] value = new double[1];
            Refused(CleftNative.cleft_options_get_real(Handle, key, value));
            return value[0];
        }

        private void Refused(int status)
        {
            if (status != CleftNative.CLEFT_OK)
                CleftException.Check(status, Wording.InCSharp(CleftNative.cleft_options_last_error(Handle)));
        }
    }
}
