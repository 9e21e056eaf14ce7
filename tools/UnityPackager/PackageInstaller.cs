namespace NeuronMocap.UnityPackager;

/// <summary>Writes the package into folders, for users who have cloned the repository.</summary>
internal static class PackageInstaller
{
    /// <summary>
    /// Installs the package as an embedded package of a Unity project, which needs no entry in the manifest. An existing package with the same name
    /// is replaced.
    /// </summary>
    /// <returns>The path of the installed package.</returns>
    /// <exception cref="PackagerException">The folder does not hold a Unity project.</exception>
    public static string InstallInto(string project, StagedPackage package)
    {
        if (!Directory.Exists(Path.Combine(project, "Assets")) || !Directory.Exists(Path.Combine(project, "Packages")))
            throw new PackagerException($"{project} is not a Unity project: it has no folders Assets and Packages.");

        string target = Path.Combine(project, "Packages", package.Name);
        if (Directory.Exists(target))
            Directory.Delete(target, recursive: true);

        Write(package.Files, target);
        return target;
    }

    /// <summary>
    /// Writes built and mirrored files into the package's own folder. A project that refers to that folder then has a complete package.
    /// </summary>
    public static void CompleteInPlace(string packageFolder, StagedPackage package) =>
        Write(package.Files.Where(static file => MirroredFile.All.Any(mirrored => mirrored.Path == file.Key)), packageFolder);

    private static void Write(IEnumerable<KeyValuePair<string, byte[]>> files, string folder)
    {
        foreach ((string path, byte[] content) in files)
        {
            string file = Path.Combine(folder, path);
            Directory.CreateDirectory(Path.GetDirectoryName(file)!);
            File.WriteAllBytes(file, content);
        }
    }
}
