namespace NeuronMocap.UnityPackager;

/// <summary>Writes the package into folders, for those who have cloned the repository.</summary>
internal static class PackageInstaller
{
    /// <summary>
    /// Puts the package among the embedded packages of a Unity project, where no manifest has to name it. One of the same name is replaced.
    /// </summary>
    /// <returns>Where it is.</returns>
    /// <exception cref="PackagerException">The folder holds no Unity project.</exception>
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

    /// <summary>Puts what is built and mirrored into the package's own folder: a project that names that folder then has a complete package.</summary>
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
