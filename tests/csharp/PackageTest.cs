using System;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Xml.Linq;
using Cleft;

/// <summary>The NuGet package is laid out as NuGet wants it, and the native libraries that run are those in it.</summary>
sealed class PackageTest
{
    static readonly string Folder = Environment.GetEnvironmentVariable("NUPKG_FOLDER");

    void TestLayout()
    {
        foreach (string file in new[] { "[Content_Types].xml", "_rels/.rels", "Cleft.nuspec", "LICENSE.txt",
                                        "lib/netstandard2.0/Cleft.dll", "lib/netstandard2.0/Cleft.xml", "build/netstandard2.0/Cleft.targets" })
            Checks.Check(File.Exists(Path.Combine(Folder, file)), file);
        string native = Path.Combine(Directory.GetDirectories(Path.Combine(Folder, "runtimes")).Single(), "native");
        foreach (string file in new[] { "libcleft.so.0", "libcleft_io.so.0", "libcleft_csharp.so", "libcleft_io_csharp.so" })
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
}
