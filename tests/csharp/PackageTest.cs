using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Xml.Linq;
using Cleft;

/// <summary>
/// The NuGet package is laid out as NuGet wants it, and the native libraries that run are those in it.
/// </summary>
sealed class PackageTest
{
    static readonly string Folder = Environment.GetEnvironmentVariable("NUPKG_FOLDER");

    void TestLayout()
    {
        foreach (string file in new[] {
            "[Content_Types].xml", "_rels/.rels", "Cleft.nuspec", "LICENSE.txt", "lib/netstandard2.0/Cleft.dll",
            "lib/netstandard2.0/Cleft.xml", "build/netstandard2.0/Cleft.targets" })
            Checks.Check(File.Exists(Path.Combine(Folder, file)), file);
        string native = Path.Combine(Directory.GetDirectories(Path.Combine(Folder, "runtimes")).Single(), "native");
        foreach (string file in new[] {
            "libcleft.so.0", "libcleft_io.so.0", "libcleft_csharp.so", "libcleft_io_csharp.so" })
            Checks.Check(File.Exists(Path.Combine(native, file)), file);
    }

    void TestManifest()
    {
        XDocument nuspec = XDocument.Load(Path.Combine(Folder, "Cleft.nuspec"));
        XNamespace space = nuspec.Root.Name.Namespace;
        XElement metadata = nuspec.Root.Element(space + "metadata");
        Checks.Equal("Cleft", metadata.Element(space + "id").Value);
        Checks.Equal(Library.Version, metadata.Element(space + "version").Value);
        XDocument types = XDocument.Load(Path.Combine(Folder, "[Content_Types].xml"));
        var known = types.Root.Elements().Select(element => "." + element.Attribute("Extension").Value).ToArray();
        foreach (string file in Directory.GetFiles(Folder, "*", SearchOption.AllDirectories))
            Checks.Check(known.Contains(Path.GetExtension(file)), file);
    }

    void TestAssemblyHasTheVersion()
    {
        Assembly assembly = typeof(Mesher).Assembly;
        Checks.Equal(Library.Version + ".0", assembly.GetName().Version.ToString());
        Checks.Equal(Library.Version + ".0", assembly.GetCustomAttribute<AssemblyFileVersionAttribute>().Version);
        Checks.Equal(
            Library.Version, assembly.GetCustomAttribute<AssemblyInformationalVersionAttribute>().InformationalVersion);
    }

    void TestOnlyTheCoreLibraryIsNeeded()
    {
        var names = typeof(Mesher).Assembly.GetReferencedAssemblies().Select(name => name.Name).ToArray();
        Checks.Equal(new[] { "mscorlib" }, names);
    }

    void TestOnlyTheClassesArePublic()
    {
        foreach (Type type in typeof(Mesher).Assembly.GetExportedTypes())
            Checks.Check(!type.Name.StartsWith("Native") || type == typeof(NativeObject)
                || type == typeof(NativeMemoryException), type.Name);
        Checks.Check(!typeof(Mesher).Assembly.GetExportedTypes().Any(type => type.Name.StartsWith("SWIG")), "SWIG");
    }

    void TestLibrariesAreThoseOfThePackage()
    {
        MeshFiles.Formats();
        string here = Path.GetDirectoryName(Assembly.GetExecutingAssembly().Location);
        string[] loaded = File.ReadLines("/proc/self/maps").Where(line => line.Contains("libcleft"))
            .Select(line => Path.GetDirectoryName(line.Substring(line.IndexOf('/')))).Distinct().ToArray();
        Checks.Equal(new[] { here }, loaded);
    }

    static readonly string Here = Path.GetDirectoryName(Assembly.GetExecutingAssembly().Location);

    /// <summary>What a program prints that Mono runs in a folder.</summary>
    static string Run(string folder, string program, string arguments)
    {
        var start = new ProcessStartInfo(program, arguments) {
            WorkingDirectory = folder, UseShellExecute = false, RedirectStandardOutput = true,
            RedirectStandardError = true };
        start.EnvironmentVariables.Remove("LD_LIBRARY_PATH");
        using (Process process = Process.Start(start)) {
            var errors = process.StandardError.ReadToEndAsync();
            string output = process.StandardOutput.ReadToEnd();
            process.WaitForExit();
            return output + errors.Result;
        }
    }

    /// <summary>A folder with the files of these names, out of that of this program.</summary>
    static void InFolder(string[] names, Action<string> use)
    {
        string folder = Path.Combine(Path.GetTempPath(), "cleft-test-" + Guid.NewGuid());
        Directory.CreateDirectory(folder);
        try {
            foreach (string name in names)
                File.Copy(Path.Combine(Here, name), Path.Combine(folder, name));
            use(folder);
        } finally {
            Directory.Delete(folder, true);
        }
    }

    /// <summary>
    /// What a program in a folder with these libraries fails with: one sentence that names what is missing.
    /// </summary>
    static void Missing(string[] libraries, string body, params string[] wanted)
    {
        InFolder(libraries.Concat(new[] { "Cleft.dll", "Tests.exe" }).ToArray(), folder => {
            string output = Run(folder, Environment.GetEnvironmentVariable("MONO"), "Tests.exe " + body);
            foreach (string text in wanted.Concat(
                new[] { "System.DllNotFoundException: the native library '", folder }))
                Checks.Check(output.Contains(text), "no '" + text + "' in: " + output);
            Checks.Check(!output.Contains("TypeInitializationException"), output);
        });
    }

    void TestMissingLibraries()
    {
        foreach (string body in new[] { "TryMesher", "TryOptions", "TryVersion", "TryTable", "TryFiles" })
            Missing(new string[0], body, "libcleft_csharp.so' of Cleft is missing", "LD_LIBRARY_PATH");
        Missing(new[] { "libcleft_csharp.so" }, "TryMesher", "cannot be loaded (libcleft.so.0: ", "libtet1.5");
        string[] core = { "libcleft.so.0", "libcleft_csharp.so" };
        foreach (string body in new[] { "TryFiles", "TryGuess", "TryRead" })
            Missing(core, body, "libcleft_io_csharp.so' of Cleft is missing");
        Missing(core.Concat(new[] { "libcleft_io_csharp.so" }).ToArray(), "TryFiles", "(libcleft_io.so.0: ");
    }

    /// <summary>Debian's xbuild puts the native libraries beside the program.</summary>
    void TestXbuild()
    {
        InFolder(new string[0], folder => {
            string sources = Environment.GetEnvironmentVariable("TEST_SOURCES");
            File.Copy(Path.Combine(sources, "Program.csproj"), Path.Combine(folder, "Program.csproj"));
            File.WriteAllText(Path.Combine(folder, "Program.cs"),
                "static class Program { static void Main() { "
                + "System.Console.WriteLine(Cleft.MeshFiles.Formats().Count); } }");
            Run(folder, "cp", "-r " + Folder + " cleft");
            string output = Run(folder, Environment.GetEnvironmentVariable("XBUILD"), "/nologo Program.csproj");
            Checks.Check(File.Exists(Path.Combine(folder, "bin/Program.exe")), output);
            output = Run(folder, Environment.GetEnvironmentVariable("MONO"), "bin/Program.exe");
            Checks.Equal(MeshFiles.Formats().Count.ToString(), output.Trim());
        });
    }
}
