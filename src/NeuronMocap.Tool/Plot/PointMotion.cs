using System.Numerics;
using NeuronMocap.Tool.Watch.Live;

namespace NeuronMocap.Tool.Plot;

/// <summary>A take as points that move and lines between them, which is all that is drawn of it. Y is up.</summary>
internal abstract class PointMotion
{
    public abstract double FrameRate { get; }

    /// <summary>At least 1.</summary>
    public abstract long FrameCount { get; }

    public abstract int PointCount { get; }

    public abstract ReadOnlySpan<WireframeLine> Lines { get; }

    /// <summary>Which points are whose.</summary>
    public abstract PointRoles Roles { get; }

    /// <summary>Whether lengths are centimetres; if not, nobody knows their unit.</summary>
    public abstract bool IsInCentimetres { get; }

    public double Duration => FrameCount / FrameRate;

    /// <summary>Writes where the points are in the world.</summary>
    /// <param name="frame">Number of the frame, from 0.</param>
    /// <param name="points">Room for <see cref="PointCount"/> points; a coordinate may be not a number where the file's value is.</param>
    public abstract void GetPoints(long frame, Span<Vector3> points);

    /// <summary>Which feet are on the ground; null when that is not known.</summary>
    /// <param name="frame">Number of the frame, from 0.</param>
    public abstract FootContacts? GetContacts(long frame);
}

/// <summary>Which points of a take are whose; null where there is no such one.</summary>
internal sealed record PointRoles
{
    /// <summary>The hips, or whatever the others hang from.</summary>
    public int Root { get; init; }

    /// <summary>The point at the top of the head, which is drawn as a circle.</summary>
    public int? HeadTop { get; init; }

    /// <summary>Points at the lower end of the left leg.</summary>
    public IReadOnlyList<int> LeftFoot { get; init; } = [];

    public IReadOnlyList<int> RightFoot { get; init; } = [];

    public int? LeftHand { get; init; }

    public int? RightHand { get; init; }

    /// <summary>The left thigh's joint: with the right one's it tells where the body faces.</summary>
    public int? LeftThigh { get; init; }

    public int? RightThigh { get; init; }

    public bool HasFeet => LeftFoot.Count > 0 && RightFoot.Count > 0;
}
