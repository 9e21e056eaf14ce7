using NeuronMocap.Bvh;

namespace NeuronMocap.Tool.Watch.Export;

/// <summary>What is to be kept of the stream.</summary>
/// <param name="Path">The BVH file.</param>
/// <param name="Overwrite">Whether a file of that name is replaced.</param>
/// <param name="Avatar">The avatar; null for the first that comes.</param>
/// <param name="IsForEachAvatar">Whether every avatar gets a file.</param>
internal sealed record ExportSettings(string Path, bool Overwrite, int? Avatar, bool IsForEachAvatar)
{
    /// <summary>Options of the export.</summary>
    /// <param name="frames">Number of frames after which the run ends; null for no end.</param>
    public BvhExportOptions ToOptions(long? frames) => new()
    {
        AvatarIndex = Avatar,
        IsForEachAvatar = IsForEachAvatar,
        Overwrite = Overwrite,
        MaxFrames = frames,
    };
}
