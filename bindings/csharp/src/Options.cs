using System;

namespace Cleft
{
    /// <summary>
    /// How to mesh: new Options { SizeMax = 3, Background = Background.Octree, Strip = new[] { 0 } }. Values that are not set
    /// are the library's defaults; OptionDescription.Table() lists them with their ranges. A value out of its range throws an
    /// InvalidOptionException, and leaves the option as it was. For one thread at a time.
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

        /// <summary>The kind of background mesh.</summary>
        public Cleft.Background Background
        {
            get { return (Cleft.Background)Integer(CleftNative.CLEFT_OPTION_BACKGROUND); }
            set { Set(CleftNative.CLEFT_OPTION_BACKGROUND, (long)value); }
        }

        /// <summary>One edge length everywhere, in world units; 0: computed from the features of the volume.</summary>
        public double Size
        {
            get { return Real(CleftNative.CLEFT_OPTION_SIZE); }
            set { Set(CleftNative.CLEFT_OPTION_SIZE, value); }
        }

        /// <summary>The least edge length; 0: the least voxel spacing.</summary>
        public double SizeMin
        {
            get { return Real(CleftNative.CLEFT_OPTION_SIZE_MIN); }
            set { Set(CleftNative.CLEFT_OPTION_SIZE_MIN, value); }
        }

        /// <summary>
        /// The greatest wanted edge length; 0: a quarter of the longest side of the box, or its thickness times 1.5 if
        /// that is less.
        /// </summary>
        public double SizeMax
        {
            get { return Real(CleftNative.CLEFT_OPTION_SIZE_MAX); }
            set { Set(CleftNative.CLEFT_OPTION_SIZE_MAX, value); }
        }

        /// <summary>The edge length at an interface over the local feature size; 0.5 is fine, 2 is coarse.</summary>
        public double FeatureScale
        {
            get { return Real(CleftNative.CLEFT_OPTION_FEATURE_SCALE); }
            set { Set(CleftNative.CLEFT_OPTION_FEATURE_SCALE, value); }
        }

        /// <summary>The greatest growth of the edge length over a distance.</summary>
        public double Gradation
        {
            get { return Real(CleftNative.CLEFT_OPTION_GRADATION); }
            set { Set(CleftNative.CLEFT_OPTION_GRADATION, value); }
        }

        /// <summary>The greatest wanted edge length at interfaces; 0: none.</summary>
        public double InterfaceSize
        {
            get { return Real(CleftNative.CLEFT_OPTION_INTERFACE_SIZE); }
            set { Set(CleftNative.CLEFT_OPTION_INTERFACE_SIZE, value); }
        }

        /// <summary>The wanted number of tetrahedra, met within 10 %; 0: as the sizes say.</summary>
        public long Tets
        {
            get { return Integer(CleftNative.CLEFT_OPTION_TETS); }
            set { Set(CleftNative.CLEFT_OPTION_TETS, value); }
        }

        /// <summary>Do parts of labels that are one voxel thick get edges so short that they come out whole?</summary>
        public bool KeepThin
        {
            get { return Integer(CleftNative.CLEFT_OPTION_KEEP_THIN) != 0; }
            set { Set(CleftNative.CLEFT_OPTION_KEEP_THIN, value ? 1L : 0L); }
        }

        /// <summary>About how many tetrahedra there may be: where SizeMin is 0, the least edge is raised for it; 0: no limit.</summary>
        public long MaxTets
        {
            get { return Integer(CleftNative.CLEFT_OPTION_MAX_TETS); }
            set { Set(CleftNative.CLEFT_OPTION_MAX_TETS, value); }
        }

        /// <summary>
        /// The width in voxels of the kernel that smooths label maps. It counts where a volume is made or read, in Mesher.Labels() and
        /// MeshFiles.ReadVolume(): in a call with a finished volume it changes nothing.
        /// </summary>
        public int Smooth
        {
            get { return (int)Integer(CleftNative.CLEFT_OPTION_SMOOTH); }
            set { Set(CleftNative.CLEFT_OPTION_SMOOTH, (long)value); }
        }

        /// <summary>The rule that moves background points onto interfaces.</summary>
        public Cleft.Snap Snap
        {
            get { return (Cleft.Snap)Integer(CleftNative.CLEFT_OPTION_SNAP); }
            set { Set(CleftNative.CLEFT_OPTION_SNAP, (long)value); }
        }

        /// <summary>The effort spent on the worst dihedral angles.</summary>
        public Improvement Improve
        {
            get { return (Improvement)Integer(CleftNative.CLEFT_OPTION_IMPROVE); }
            set { Set(CleftNative.CLEFT_OPTION_IMPROVE, (long)value); }
        }

        /// <summary>The relaxation steps of the particles.</summary>
        public int Steps
        {
            get { return (int)Integer(CleftNative.CLEFT_OPTION_STEPS); }
            set { Set(CleftNative.CLEFT_OPTION_STEPS, (long)value); }
        }

        /// <summary>What varies the arrangement of the particles.</summary>
        public long Seed
        {
            get { return Integer(CleftNative.CLEFT_OPTION_SEED); }
            set { Set(CleftNative.CLEFT_OPTION_SEED, value); }
        }

        /// <summary>Is a lost label a failure?</summary>
        public bool Strict
        {
            get { return Integer(CleftNative.CLEFT_OPTION_STRICT) != 0; }
            set { Set(CleftNative.CLEFT_OPTION_STRICT, value ? 1L : 0L); }
        }

        /// <summary>The dihedral angle in degrees below which tetrahedra of a given background are repaired; 0: none.</summary>
        public double Repair
        {
            get { return Real(CleftNative.CLEFT_OPTION_REPAIR); }
            set { Set(CleftNative.CLEFT_OPTION_REPAIR, value); }
        }

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

        /// <summary>Sets the greatest wanted edge length inside one label, in world units; 0 takes the wish back.</summary>
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
