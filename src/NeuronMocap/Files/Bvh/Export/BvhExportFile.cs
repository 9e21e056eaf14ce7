namespace NeuronMocap.Bvh;

/// <summary>One file of an export.</summary>
/// <param name="Path">Where it is.</param>
/// <param name="AvatarIndex">Number of the avatar on the server.</param>
/// <param name="AvatarName">Its name there.</param>
/// <param name="FrameCount">Number of rows so far, those repeated included.</param>
/// <param name="RepeatedFrames">Number of rows that stand in for frames that were lost on the way.</param>
/// <param name="LateFrames">Number of frames left out because later ones had come before them.</param>
/// <param name="FrameRate">Frames per second, as far as it is known by now.</param>
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
