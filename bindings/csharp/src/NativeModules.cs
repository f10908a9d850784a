using System;
using System.Collections.Generic;
using System.IO;
using System.Runtime.InteropServices;

namespace Cleft
{
    /// <summary>
    /// Loads the native modules before the first call into each. Where one cannot be loaded, a DllNotFoundException
    /// tells what is missing and where it was looked for.
    /// </summary>
    internal static class NativeModules
    {
        private const string CoreModule = "cleft_csharp", FilesModule = "cleft_io_csharp";

        // Any function does. Not through the classes of SWIG, whose initializers would wrap the exception.
        [DllImport(CoreModule, EntryPoint = "CSharp_Cleft_cleft_has_tetgen")]
        private static extern int TouchCore();
        [DllImport(FilesModule, EntryPoint = "CSharp_Cleft_cleft_io_format_count")]
        private static extern int TouchFiles();

        [DllImport("libdl.so.2")]
        private static extern IntPtr dlopen(byte[] path, int mode);
        [DllImport("libdl.so.2")]
        private static extern IntPtr dlerror();

        private static volatile bool coreIsLoaded, filesAreLoaded;

        /// <summary>What everything needs.</summary>
        internal static void Core()
        {
            if (!coreIsLoaded)
                Load(CoreModule, TouchCore, "the Debian package libtet1.5");
            coreIsLoaded = true;
        }

        /// <summary>What reads and writes files.</summary>
        internal static void Files()
        {
            Core();
            if (!filesAreLoaded)
                Load(FilesModule, TouchFiles,
                    "the Debian packages libgdcm3.0, libtiff6, libpng16-16, libjpeg62-turbo, libdeflate0 and zlib1g");
            filesAreLoaded = true;
        }

        private static void Load(string module, Func<int> touch, string needs)
        {
            try {
                touch();
            } catch (DllNotFoundException failure) {
                throw new DllNotFoundException(Sentence("lib" + module + ".so", needs, failure.Message), failure);
            }
        }

        private static string Sentence(string file, string needs, string reason)
        {
            var folders = new List<string> { Path.GetDirectoryName(typeof(NativeModules).Assembly.Location) };
            string more = Environment.GetEnvironmentVariable("LD_LIBRARY_PATH");
            if (!string.IsNullOrEmpty(more))
                folders.AddRange(more.Split(new[] { ':' }, StringSplitOptions.RemoveEmptyEntries));
            foreach (string folder in folders)
                if (!string.IsNullOrEmpty(folder) && File.Exists(Path.Combine(folder, file)))
                    return "the native library '" + Path.Combine(folder, file) + "' cannot be loaded ("
                        + (LoaderReason(Path.Combine(folder, file)) ?? reason)
                        + "); it needs libcleft.so.0 and libcleft_io.so.0 "
                        + "of the Cleft package beside it, and " + needs;
            return "the native library '" + file + "' of Cleft is missing: it was looked for beside Cleft.dll in '"
                + folders[0] + "', in the folders of LD_LIBRARY_PATH ("
                + (string.IsNullOrEmpty(more) ? "not set" : "'" + more + "'")
                + ") and in those of the system; copy the files of runtimes/*/native in the Cleft package beside "
                + "Cleft.dll, or name their folder in LD_LIBRARY_PATH";
        }

        /// <summary>
        /// What the dynamic loader says, which names the library that is missing; null where there is no such loader.
        /// </summary>
        private static string LoaderReason(string path)
        {
            const int now = 2;
            try {
                dlerror();  // so that nothing is looked up between the next two calls
                return dlopen(Utf8.Write(path, nameof(path)), now) == IntPtr.Zero ? Utf8.Read(dlerror()) : null;
            } catch (Exception failure) when (
                failure is DllNotFoundException || failure is EntryPointNotFoundException) {
                return null;
            }
        }
    }
}
