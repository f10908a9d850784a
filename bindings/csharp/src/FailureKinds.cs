// Made by tools/generate.py from include/cleft/cleft_status.h.
namespace Cleft
{
    /// <summary>Memory outside the managed heap is used up.</summary>
    public sealed class NativeMemoryException : CleftException
    {
        internal NativeMemoryException(int status, string sentence) : base(status, sentence) { }
    }

    /// <summary>An argument is out of its range.</summary>
    public class InvalidArgumentException : CleftException
    {
        internal InvalidArgumentException(int status, string sentence) : base(status, sentence) { }
    }

    /// <summary>A number is NaN or infinite.</summary>
    public sealed class NotFiniteException : InvalidArgumentException
    {
        internal NotFiniteException(int status, string sentence) : base(status, sentence) { }
    }

    /// <summary>The value of an option is out of its range.</summary>
    public sealed class InvalidOptionException : InvalidArgumentException
    {
        internal InvalidOptionException(int status, string sentence) : base(status, sentence) { }
    }

    /// <summary>Too large for numbers of 32 bits.</summary>
    public sealed class TooLargeException : CleftException
    {
        internal TooLargeException(int status, string sentence) : base(status, sentence) { }
    }

    /// <summary>Not supported by this build or format.</summary>
    public sealed class UnsupportedException : CleftException
    {
        internal UnsupportedException(int status, string sentence) : base(status, sentence) { }
    }

    /// <summary>A mesh is not valid.</summary>
    public sealed class InvalidMeshException : CleftException
    {
        internal InvalidMeshException(int status, string sentence) : base(status, sentence) { }
    }

    /// <summary>A label of the volume is not in the mesh, and the option Strict is on.</summary>
    public sealed class LabelLostException : CleftException
    {
        internal LabelLostException(int status, string sentence) : base(status, sentence) { }
    }

    /// <summary>A file cannot be read or written.</summary>
    public sealed class FileFailureException : CleftException
    {
        internal FileFailureException(int status, string sentence) : base(status, sentence) { }
    }

    /// <summary>The contents of a file break the rules of its format.</summary>
    public sealed class InvalidFormatException : CleftException
    {
        internal InvalidFormatException(int status, string sentence) : base(status, sentence) { }
    }
}
