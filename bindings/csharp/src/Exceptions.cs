using System;
using System.Threading;

namespace Cleft
{
    /// <summary>A failure of the library, with one sentence on it. Each kind has a subclass.</summary>
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
            // <choice> made by tools/generate.py from include/cleft/cleft_status.h
            case CleftNative.CLEFT_ERROR_OUT_OF_MEMORY: return new NativeMemoryException(status, sentence);
            case CleftNative.CLEFT_ERROR_ARGUMENT:
            case CleftNative.CLEFT_ERROR_NULL:
            case CleftNative.CLEFT_ERROR_BUFFER: return new InvalidArgumentException(status, sentence);
            case CleftNative.CLEFT_ERROR_NOT_FINITE: return new NotFiniteException(status, sentence);
            case CleftNative.CLEFT_ERROR_OPTION: return new InvalidOptionException(status, sentence);
            case CleftNative.CLEFT_ERROR_TOO_LARGE: return new TooLargeException(status, sentence);
            case CleftNative.CLEFT_ERROR_UNSUPPORTED: return new UnsupportedException(status, sentence);
            case CleftNative.CLEFT_ERROR_INVALID_MESH: return new InvalidMeshException(status, sentence);
            case CleftNative.CLEFT_ERROR_LABEL_LOST: return new LabelLostException(status, sentence);
            case CleftNative.CLEFT_ERROR_FILE: return new FileFailureException(status, sentence);
            case CleftNative.CLEFT_ERROR_FORMAT: return new InvalidFormatException(status, sentence);
            // </choice>
            case CleftNative.CLEFT_ERROR_CANCELLED: return new CancelledException(sentence, CancellationToken.None);
            default: return new CleftException(status, sentence);
            }
        }
    }

    /// <summary>
    /// The progress function answered false, or the call was cancelled from outside: as everywhere in .NET, not a
    /// failure but an OperationCanceledException. Its token is that of the Mesher if it was the one that cancelled.
    /// </summary>
    public sealed class CancelledException : OperationCanceledException
    {
        internal CancelledException(string sentence, CancellationToken token) : base(sentence, token) { }
    }
}
