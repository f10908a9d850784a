// Made by tools/generate.py from src/capi/options.toml and include/cleft/*.h.
namespace Cleft
{
    /// <summary>Kinds of background meshes.</summary>
    public enum Background
    {
        /// <summary>Relaxed particles and their Delaunay tetrahedra: the best shapes.</summary>
        Particles = CleftNative.CLEFT_BACKGROUND_PARTICLES,
        /// <summary>A regular lattice: quick, one size everywhere.</summary>
        Lattice = CleftNative.CLEFT_BACKGROUND_LATTICE,
        /// <summary>An adaptive lattice.</summary>
        Octree = CleftNative.CLEFT_BACKGROUND_OCTREE
    }

    /// <summary>Rules that move background points onto interfaces.</summary>
    public enum Snap
    {
        /// <summary>By the quality of the elements around.</summary>
        Quality = CleftNative.CLEFT_SNAP_QUALITY,
        /// <summary>By the safe distances of the paper.</summary>
        Safe = CleftNative.CLEFT_SNAP_SAFE,
        /// <summary>Never.</summary>
        None = CleftNative.CLEFT_SNAP_NONE
    }

    /// <summary>Effort spent on the worst dihedral angles.</summary>
    public enum Improvement
    {
        /// <summary>None.</summary>
        Off = CleftNative.CLEFT_IMPROVE_OFF,
        /// <summary>Some: the default.</summary>
        Fast = CleftNative.CLEFT_IMPROVE_FAST,
        /// <summary>As much as helps.</summary>
        Best = CleftNative.CLEFT_IMPROVE_BEST
    }

    /// <summary>Types of voxels.</summary>
    public enum VoxelType
    {
        /// <summary>Whole numbers of 8 bits without sign.</summary>
        UInt8 = CleftNative.CLEFT_TYPE_UINT8,
        /// <summary>Whole numbers of 16 bits without sign.</summary>
        UInt16 = CleftNative.CLEFT_TYPE_UINT16,
        /// <summary>Whole numbers of 16 bits.</summary>
        Int16 = CleftNative.CLEFT_TYPE_INT16,
        /// <summary>Whole numbers of 32 bits without sign.</summary>
        UInt32 = CleftNative.CLEFT_TYPE_UINT32,
        /// <summary>Whole numbers of 32 bits.</summary>
        Int32 = CleftNative.CLEFT_TYPE_INT32,
        /// <summary>Real numbers, single precision.</summary>
        Float32 = CleftNative.CLEFT_TYPE_FLOAT32,
        /// <summary>Real numbers, double precision.</summary>
        Float64 = CleftNative.CLEFT_TYPE_FLOAT64
    }

    /// <summary>Sides of the box, in the axes of the voxels.</summary>
    public enum Side
    {
        /// <summary>The least x.</summary>
        XMin = CleftNative.CLEFT_SIDE_X_MIN,
        /// <summary>The greatest x.</summary>
        XMax = CleftNative.CLEFT_SIDE_X_MAX,
        /// <summary>The least y.</summary>
        YMin = CleftNative.CLEFT_SIDE_Y_MIN,
        /// <summary>The greatest y.</summary>
        YMax = CleftNative.CLEFT_SIDE_Y_MAX,
        /// <summary>The least z.</summary>
        ZMin = CleftNative.CLEFT_SIDE_Z_MIN,
        /// <summary>The greatest z.</summary>
        ZMax = CleftNative.CLEFT_SIDE_Z_MAX,
        /// <summary>No side of the box.</summary>
        Other = CleftNative.CLEFT_SIDE_OTHER
    }

    /// <summary>How much a sentence of the log matters.</summary>
    public enum LogLevel
    {
        /// <summary>Something may not be as intended.</summary>
        Warning = CleftNative.CLEFT_LOG_WARNING,
        /// <summary>Good to know.</summary>
        Info = CleftNative.CLEFT_LOG_INFO,
        /// <summary>For those who look for a fault.</summary>
        Debug = CleftNative.CLEFT_LOG_DEBUG
    }

    /// <summary>What values an option takes.</summary>
    public enum OptionType
    {
        /// <summary>Whole numbers.</summary>
        Integer = CleftNative.CLEFT_OPTION_TYPE_INTEGER,
        /// <summary>Real numbers.</summary>
        Real = CleftNative.CLEFT_OPTION_TYPE_REAL,
        /// <summary>One of several names.</summary>
        Choice = CleftNative.CLEFT_OPTION_TYPE_CHOICE,
        /// <summary>On or off.</summary>
        Flag = CleftNative.CLEFT_OPTION_TYPE_FLAG
    }

    /// <summary>Directions of the world axes.</summary>
    public enum World
    {
        /// <summary>Left, posterior, superior: ITK's, 3D Slicer's files, DICOM's; the default.</summary>
        Lps = CleftIoNative.CLEFT_IO_WORLD_LPS,
        /// <summary>Right, anterior, superior: NIfTI's; the first two coordinates change their sign.</summary>
        Ras = CleftIoNative.CLEFT_IO_WORLD_RAS
    }

    /// <summary>What the voxels of a file mean.</summary>
    public enum VoxelKind
    {
        /// <summary>
        /// By the values. One file: whole numbers are labels, also where they are up to 1/50 off; fractions on both
        /// sides of 0 that change from voxel to voxel are a signed function. Several files or frames: 0 and one other
        /// whole number each are masks; fractions are indicator functions. Anything else is refused.
        /// </summary>
        Auto = CleftIoNative.CLEFT_IO_KIND_AUTO,
        /// <summary>Labels: fractions are rounded to the nearest; or several masks.</summary>
        Labels = CleftIoNative.CLEFT_IO_KIND_LABELS,
        /// <summary>Indicator functions, of any type of voxels.</summary>
        Indicators = CleftIoNative.CLEFT_IO_KIND_INDICATORS
    }

    /// <summary>What a file holds.</summary>
    public enum Content
    {
        /// <summary>Neither a volume nor a mesh, as far as one can tell.</summary>
        Unknown = CleftIoNative.CLEFT_IO_UNKNOWN,
        /// <summary>A volume.</summary>
        Volume = CleftIoNative.CLEFT_IO_VOLUME,
        /// <summary>A mesh.</summary>
        Mesh = CleftIoNative.CLEFT_IO_MESH
    }
}
