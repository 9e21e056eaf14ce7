using System.Numerics;

namespace NeuronMocap.Retargeting;

// A driven node: the bone it follows, and the rotations that account for its rest pose.
internal readonly struct RetargetLink
{
    public int Node { get; init; }

    // The bone of the stream that the node follows, and the bone that its closest driven ancestor follows, or -1.
    public int Source { get; init; }

    public int SourceAbove { get; init; }

    // Indices of the weights.
    public int Part { get; init; }

    public int Bone { get; init; }

    // Rotations from the parent's axes at rest to the source's, and from the source's axes to the node's own.
    public Quaternion Before { get; init; }

    public Quaternion After { get; init; }

    public Vector3 Handedness { get; init; }

    // At rest, the way from the closest driven ancestor to the node, in metres in the source's axes.
    public Vector3 RestWay { get; init; }

    // The factors from metres to the units of the node's position.
    public Vector3 Units { get; init; }
}
