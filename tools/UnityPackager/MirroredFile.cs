namespace NeuronMocap.UnityPackager;

/// <summary>A file of the package that is not in its folder, because it is built or lives elsewhere in the repository.</summary>
internal sealed record MirroredFile(string Path, string Source)
{
    public const string Libraries = "Runtime/Libraries";

    /// <summary>The assemblies of the package: only our own.</summary>
    public static IReadOnlyList<string> Assemblies { get; } = ["NeuronMocap", "NeuronMocap.Compatibility", "NeuronMocap.Server"];

    /// <summary>All mirrored files. Their sources are relative to the repository.</summary>
    public static IReadOnlyList<MirroredFile> All { get; } =
    [
        new("CHANGELOG.md", "CHANGELOG.md"),
        new("LICENSE.md", "LICENSE"),
        .. Assemblies.SelectMany(static name => (MirroredFile[])[Library(name, ".dll"), Library(name, ".pdb"), Library(name, ".xml")]),
    ];

    private static MirroredFile Library(string assembly, string extension) =>
        new($"{Libraries}/{assembly}{extension}", $"src/{assembly}/bin/{{0}}/netstandard2.1/{assembly}{extension}");

    /// <summary>Gets the path of the source file.</summary>
    /// <param name="repository">The root of the repository.</param>
    /// <param name="configuration">Debug or Release.</param>
    public string SourceIn(string repository, string configuration) =>
        System.IO.Path.Combine(repository, Source.Replace("{0}", configuration, StringComparison.Ordinal));
}
