using NeuronMocap.Bvh;

namespace NeuronMocap.Tool.Watch.Export;

/// <summary>Settings of the export.</summary>
/// <param name="Path">The BVH file.</param>
/// <param name="Overwrite">Whether an existing file is replaced.</param>
/// <param name="Avatar">Index of the avatar; null for the first that arrives.</param>
/// <param name="FilePerAvatar">Whether every avatar gets its own file.</param>
internal sealed record ExportSettings(string Path, bool Overwrite, int? Avatar, bool FilePerAvatar)
{
    /// <summary>The argument that names the file, for errors.</summary>
    public string Argument { get; init; } = "--export";

    /// <summary>Creates the options of the export.</summary>
    /// <param name="frames">Number of frames after which the run ends; null for no end.</param>
    public BvhExportOptions ToOptions(long? frames) => new()
    {
        AvatarIndex = Avatar,
        FilePerAvatar = FilePerAvatar,
        Overwrite = Overwrite,
        MaxFrames = frames,
    };
}
