namespace NeuronMocap.Bvh;

/// <summary>Describes one file of an export.</summary>
/// <param name="Path">The path of the file.</param>
/// <param name="AvatarIndex">Number of the avatar on the server.</param>
/// <param name="AvatarName">Name of the avatar on the server.</param>
/// <param name="FrameCount">Number of rows so far, including repeated rows.</param>
/// <param name="RepeatedFrames">Number of rows that repeat the previous row in place of lost frames.</param>
/// <param name="LateFrames">Number of frames skipped because a later frame had arrived before them.</param>
/// <param name="FrameRate">Frames per second, as far as it is known.</param>
/// <param name="BodyOrigin">Where the OFFSETs come from.</param>
public sealed record BvhExportFile(
    string Path,
    int AvatarIndex,
    string AvatarName,
    int FrameCount,
    int RepeatedFrames,
    int LateFrames,
    double FrameRate,
    BvhBodyOrigin BodyOrigin);
