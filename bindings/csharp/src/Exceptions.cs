using System;
using System.Threading;

namespace Cleft
{
    /// <summary>A failure of the library, told in one sentence. Each kind of failure has a subclass.</summary>
    public class CleftException : Exception
    {
        internal CleftException(int status, string sentence) : base(sentence) { Status = status; }

        /// <summary>The library's number for the kind of failure: negative, as in C.</summary>
        public int Status { get; }

        /// <summary>Throws the exception of a status, unless it is success.</summary>
        internal static void Check(int status, string sentence = null)
        {
            if (status != CleftNative.CLEFT_OK)
                throw Of(status, string.IsNullOrEmpty(sentence) ? CleftNative.cleft_status_string(status) : sentence);
        }

        private static Exception Of(int status, string sentence)
        {
            switch (status) {
            case CleftNative.CLEFT_ERROR_OUT_OF_MEMORY: return new NativeMemoryException(status, sentence);
            case CleftNative.CLEFT_ERROR_NULL:
            case CleftNative.CLEFT_ERROR_ARGUMENT:
            case CleftNative.CLEFT_ERROR_BUFFER: return new InvalidArgumentException(status, sentence);
            case CleftNative.CLEFT_ERROR_NOT_FINITE: return new NotFiniteException(status, sentence);
            case CleftNative.CLEFT_ERROR_OPTION: return new InvalidOptionException(status, sentence);
            case CleftNative.CLEFT_ERROR_TOO_LARGE: return new TooLargeException(status, sentence);
            case CleftNative.CLEFT_ERROR_UNSUPPORTED: return new UnsupportedException(status, sentence);
            case CleftNative.CLEFT_ERROR_INVALID_MESH: return new InvalidMeshException(status, sentence);
            case CleftNative.CLEFT_ERROR_LABEL_LOST: return new LabelLostException(status, sentence);
            case CleftNative.CLEFT_ERROR_FILE: return new FileFailureException(status, sentence);
            case CleftNative.CLEFT_ERROR_FORMAT: return new InvalidFormatException(status, sentence);
            case CleftNative.CLEFT_ERROR_CANCELLED: return new CancelledException(sentence, CancellationToken.None);
            default: return new CleftException(status, sentence);
            }
        }
    }

    /// <summary>Memory outside the managed heap is used up.</summary>
    public sealed class NativeMemoryException : CleftException
    {
        internal NativeMemoryException(int status, string sentence) : base(status, sentence) { }
    }

    /// <summary>
    /// The progress function answered false, or the call was cancelled from outside: as everywhere in .NET, not a failure but
    /// an OperationCanceledException. Its token is that of the Mesher if it was the one that cancelled.
    /// </summary>
    public sealed class CancelledException : OperationCanceledException
    {
        internal CancelledException(string sentence, CancellationToken token) : base(sentence, token) { }
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
