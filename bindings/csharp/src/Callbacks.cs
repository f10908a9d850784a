using System;
using System.Runtime.InteropServices;
using System.Text;

namespace Cleft
{
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    internal delegate int NativeProgress(double fraction, IntPtr stage, IntPtr user);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    internal delegate void NativeLog(int level, IntPtr sentence, IntPtr user);

    /// <summary>Texts as the library has them: UTF-8, closed by a zero.</summary>
    internal static class Utf8
    {
        private static readonly Encoding Strict = new UTF8Encoding(false, true);

        internal static string Read(IntPtr text)
        {
            if (text == IntPtr.Zero)
                return "";
            int length = 0;
            while (Marshal.ReadByte(text, length) != 0)
                ++length;
            byte[] bytes = new byte[length];
            Marshal.Copy(text, bytes, 0, length);
            return Encoding.UTF8.GetString(bytes);
        }

        /// <summary>Reads a copy that the native module made, and frees it.</summary>
        internal static string Take(IntPtr text)
        {
            try {
                return Read(text);
            } finally {
                CleftNative.cleft_text_free(text);
            }
        }

        internal static byte[] Write(string text, string name)
        {
            if (text == null)
                throw new ArgumentNullException(name);
            if (text.IndexOf('\0') >= 0)
                throw new ArgumentException(name + " has a zero character in it", name);
            try {
                return Strict.GetBytes(text + "\0");
            } catch (EncoderFallbackException) {
                throw new ArgumentException(name + " has half a surrogate pair in it", name);
            }
        }
    }
}
