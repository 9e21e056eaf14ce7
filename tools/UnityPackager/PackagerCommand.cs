using System.CommandLine;

namespace NeuronMocap.UnityPackager;

/// <summary>The options of the program.</summary>
internal sealed class PackagerCommand : RootCommand
{
    public PackagerCommand()
        : base("Builds the netstandard2.1 libraries, and creates the Unity package from them and the folder unity-package: "
            + "NeuronMocap-VERSION.unitypackage and a UPM tarball. Checks the archives and reads them again. Without an option, writes both archives "
            + "to artifacts/unity.")
    {
        foreach (Option option in (Option[])[Output, Install, InPlace, Branch, Metas, Guid, Configuration, NoBuild, Repository])
            Add(option);
    }

    public Option<DirectoryInfo?> Output { get; } = new("--output")
    {
        HelpName = "FOLDER",
        Description = "Where to write the two archives.",
    };

    public Option<DirectoryInfo?> Install { get; } = new("--install")
    {
        HelpName = "PROJECT",
        Description = "Put the package into a Unity project, under Packages. An existing one is replaced.",
    };

    public Option<bool> InPlace { get; } = new("--in-place")
    {
        Description = "Put libraries, changelog and licence into unity-package itself, for projects that refer to that folder (\"file:../../unity-package\").",
    };

    public Option<string?> Branch { get; } = new("--branch")
    {
        HelpName = "NAME",
        Description = "Commit the complete package to this branch of the repository, for git URLs. The work tree does not change.",
    };

    public Option<bool> Metas { get; } = new("--metas")
    {
        Description = "Write missing metas, remove metas whose files are gone, and do nothing else.",
    };

    public Option<string?> Guid { get; } = new("--guid")
    {
        HelpName = "PATH",
        Description = "Print the GUID of a file of the package, such as Runtime/Sources/MocapSource.cs, and do nothing else.",
    };

    public Option<string> Configuration { get; } = new("--configuration")
    {
        HelpName = "NAME",
        Description = "The build of the libraries to use. Default: Release.",
        DefaultValueFactory = static _ => "Release",
    };

    public Option<bool> NoBuild { get; } = new("--no-build")
    {
        Description = "Use the libraries that were built last.",
    };

    public Option<DirectoryInfo?> Repository { get; } = new("--repository")
    {
        HelpName = "FOLDER",
        Description = "The root of the repository. Default: the nearest folder, from the current one upwards, that holds unity-package.",
    };
}
