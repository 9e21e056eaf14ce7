using System.Numerics;

namespace NeuronMocap.Tool.Figures;

/// <summary>A take as moving points and lines between them. The drawing uses only these. Y is up.</summary>
internal abstract class PointMotion
{
    public abstract double FrameRate { get; }

    /// <summary>Number of frames, at least 1.</summary>
    public abstract long FrameCount { get; }

    public abstract int PointCount { get; }

    public abstract ReadOnlySpan<WireframeLine> Lines { get; }

    /// <summary>The points with a special role.</summary>
    public abstract PointRoles Roles { get; }

    /// <summary>Whether lengths are in centimetres. If not, their unit is unknown.</summary>
    public abstract bool IsInCentimetres { get; }

    public double Duration => FrameCount / FrameRate;

    /// <summary>Writes the positions of the points in the world.</summary>
    /// <param name="frame">Number of the frame, from 0.</param>
    /// <param name="points">Room for <see cref="PointCount"/> points. A coordinate is not a number if the file's value is not.</param>
    public abstract void GetPoints(long frame, Span<Vector3> points);

    /// <summary>Gets which feet are on the ground. Null if that is unknown.</summary>
    /// <param name="frame">Number of the frame, from 0.</param>
    public abstract FootContacts? GetContacts(long frame);
}

/// <summary>The points of a take with a special role. Null for a role without a point.</summary>
internal sealed record PointRoles
{
    /// <summary>The hips, or the root of the other points.</summary>
    public int Root { get; init; }

    /// <summary>The point at the top of the head, which is drawn as a circle.</summary>
    public int? HeadTop { get; init; }

    /// <summary>Points at the lower end of the left leg.</summary>
    public IReadOnlyList<int> LeftFoot { get; init; } = [];

    public IReadOnlyList<int> RightFoot { get; init; } = [];

    public int? LeftHand { get; init; }

    public int? RightHand { get; init; }

    /// <summary>The joint of the left thigh. Together with the right one it gives the facing direction.</summary>
    public int? LeftThigh { get; init; }

    public int? RightThigh { get; init; }

    public bool HasFeet => LeftFoot.Count > 0 && RightFoot.Count > 0;
}
