using System.CommandLine;

namespace NeuronMocap.UnityPackager;

/// <summary>The options of the program.</summary>
internal sealed class PackagerCommand : RootCommand
{
    public PackagerCommand()
        : base("Makes the Unity package out of the folder unity-package and the netstandard2.1 libraries.")
    {
        foreach (Option option in (Option[])[Repository, Metas, Guid])
            Add(option);
    }

    public Option<DirectoryInfo> Repository { get; } = new("--repository")
    {
        HelpName = "FOLDER",
        Description = "The root of the repository. Default: the current folder.",
        DefaultValueFactory = static _ => new DirectoryInfo("."),
    };

    public Option<bool> Metas { get; } = new("--metas")
    {
        Description = "Only write the metas that are missing, and remove those of files that are gone.",
    };

    public Option<string?> Guid { get; } = new("--guid")
    {
        HelpName = "PATH",
        Description = "Only print the GUID of a file of the package, such as Runtime/Sources/MocapSource.cs.",
    };
}
