// Made by tools/generate.py from src/capi/options.toml and include/cleft/*.h.
namespace Cleft
{
    /// <summary>Kinds of background meshes.</summary>
    public enum Background
    {
        /// <summary>Relaxed particles and their Delaunay tetrahedra, which have the best shapes.</summary>
        Particles = CleftNative.CLEFT_BACKGROUND_PARTICLES,
        /// <summary>A regular lattice, which is quick and has one size everywhere.</summary>
        Lattice = CleftNative.CLEFT_BACKGROUND_LATTICE,
        /// <summary>An adaptive lattice, which is quick and follows the sizing field.</summary>
        Octree = CleftNative.CLEFT_BACKGROUND_OCTREE
    }

    /// <summary>Rules that move background points onto interfaces.</summary>
    public enum Snap
    {
        /// <summary>By the quality of the surrounding elements.</summary>
        Quality = CleftNative.CLEFT_SNAP_QUALITY,
        /// <summary>By the safe distances of the published method.</summary>
        Safe = CleftNative.CLEFT_SNAP_SAFE,
        /// <summary>No point moves.</summary>
        None = CleftNative.CLEFT_SNAP_NONE
    }

    /// <summary>Effort spent on the worst dihedral angles.</summary>
    public enum Improvement
    {
        /// <summary>No improvement.</summary>
        Off = CleftNative.CLEFT_IMPROVE_OFF,
        /// <summary>Moderate effort, the default.</summary>
        Fast = CleftNative.CLEFT_IMPROVE_FAST,
        /// <summary>Effort until nothing improves further.</summary>
        Best = CleftNative.CLEFT_IMPROVE_BEST
    }

    /// <summary>Engines of Delaunay tetrahedra, which give the same mesh.</summary>
    public enum DelaunayEngine
    {
        /// <summary>Cleft's own, which works on all threads.</summary>
        Cleft = CleftNative.CLEFT_DELAUNAY_CLEFT,
        /// <summary>TetGen, on one thread; refused where the library has no TetGen.</summary>
        Tetgen = CleftNative.CLEFT_DELAUNAY_TETGEN
    }

    /// <summary>Types of voxels.</summary>
    public enum VoxelType
    {
        /// <summary>Unsigned whole numbers of 8 bits.</summary>
        UInt8 = CleftNative.CLEFT_TYPE_UINT8,
        /// <summary>Unsigned whole numbers of 16 bits.</summary>
        UInt16 = CleftNative.CLEFT_TYPE_UINT16,
        /// <summary>Signed whole numbers of 16 bits.</summary>
        Int16 = CleftNative.CLEFT_TYPE_INT16,
        /// <summary>Unsigned whole numbers of 32 bits.</summary>
        UInt32 = CleftNative.CLEFT_TYPE_UINT32,
        /// <summary>Signed whole numbers of 32 bits.</summary>
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

    /// <summary>Levels of log messages.</summary>
    public enum LogLevel
    {
        /// <summary>A result may not be what the user intends.</summary>
        Warning = CleftNative.CLEFT_LOG_WARNING,
        /// <summary>Useful information.</summary>
        Info = CleftNative.CLEFT_LOG_INFO,
        /// <summary>Details for finding a fault.</summary>
        Debug = CleftNative.CLEFT_LOG_DEBUG
    }

    /// <summary>Types of option values.</summary>
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
        /// <summary>Left, posterior, superior, as in ITK, DICOM and files of 3D Slicer; the default.</summary>
        Lps = CleftIoNative.CLEFT_IO_WORLD_LPS,
        /// <summary>Right, anterior, superior, as in NIfTI: x and y have the opposite sign.</summary>
        Ras = CleftIoNative.CLEFT_IO_WORLD_RAS
    }

    /// <summary>The meaning of the voxels of files.</summary>
    public enum VoxelKind
    {
        /// <summary>
        /// By the values. In one file, whole numbers (within 1/50) are labels. Fractions on both sides of 0 that change
        /// from voxel to voxel are a signed function. In several files or frames, 0 and one other whole number each are
        /// masks. Fractions are indicator functions. The component refuses anything else.
        /// </summary>
        Auto = CleftIoNative.CLEFT_IO_KIND_AUTO,
        /// <summary>Labels, fractions rounded to the nearest; or several masks.</summary>
        Labels = CleftIoNative.CLEFT_IO_KIND_LABELS,
        /// <summary>Indicator functions, from any type of voxels.</summary>
        Indicators = CleftIoNative.CLEFT_IO_KIND_INDICATORS
    }

    /// <summary>What a file most likely contains.</summary>
    public enum Content
    {
        /// <summary>Neither a volume nor a mesh, as far as the name and first bytes show.</summary>
        Unknown = CleftIoNative.CLEFT_IO_UNKNOWN,
        /// <summary>A volume.</summary>
        Volume = CleftIoNative.CLEFT_IO_VOLUME,
        /// <summary>A mesh.</summary>
        Mesh = CleftIoNative.CLEFT_IO_MESH
    }

    /// <summary>The order of the numbers of a symmetric tensor in a file.</summary>
    public enum TensorOrder
    {
        /// <summary>As the file says; six numbers of which it says nothing are refused.</summary>
        File = CleftIoNative.CLEFT_IO_ORDER_FILE,
        /// <summary>That of NRRD and of this library: xx, xy, xz, yy, yz, zz.</summary>
        Nrrd = CleftIoNative.CLEFT_IO_ORDER_NRRD,
        /// <summary>That of VTK: xx, yy, zz, xy, yz, xz.</summary>
        Vtk = CleftIoNative.CLEFT_IO_ORDER_VTK,
        /// <summary>That of NIfTI, MEDIT and mmg: xx, xy, yy, xz, yz, zz.</summary>
        Nifti = CleftIoNative.CLEFT_IO_ORDER_NIFTI
    }

    /// <summary>What gives a tetrahedron its colour.</summary>
    public enum Colouring
    {
        /// <summary>Its label, which has the same colour in every mesh.</summary>
        Label = CleftIoNative.CLEFT_IO_BY_LABEL,
        /// <summary>Its least dihedral angle, from 0 to 70 degrees.</summary>
        Angle = CleftIoNative.CLEFT_IO_BY_ANGLE,
        /// <summary>Its radius ratio, from 1 (the regular tetrahedron) to 4.</summary>
        Ratio = CleftIoNative.CLEFT_IO_BY_RATIO,
        /// <summary>Its mean edge, from the least to the greatest that are drawn, by factors.</summary>
        Size = CleftIoNative.CLEFT_IO_BY_SIZE
    }

    /// <summary>What is behind the mesh.</summary>
    public enum Backdrop
    {
        /// <summary>White.</summary>
        Light = CleftIoNative.CLEFT_IO_BACKDROP_LIGHT,
        /// <summary>Nearly black.</summary>
        Dark = CleftIoNative.CLEFT_IO_BACKDROP_DARK,
        /// <summary>Nothing: the picture is transparent there.</summary>
        None = CleftIoNative.CLEFT_IO_BACKDROP_NONE
    }
}
