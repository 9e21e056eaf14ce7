using System.Numerics;

namespace NeuronMocap.Retargeting;

// One driven node: what it follows, and what its rest pose makes of it.
internal readonly struct RetargetLink
{
    public int Node { get; init; }

    // The bone of the stream that it follows, and the one that the next driven node above it follows, or -1.
    public int Source { get; init; }

    public int SourceAbove { get; init; }

    // Where its weight stands.
    public int Part { get; init; }

    public int Bone { get; init; }

    // From the parent's axes at rest to the source's, and from the source's to the node's own.
    public Quaternion Before { get; init; }

    public Quaternion After { get; init; }

    public Vector3 Handedness { get; init; }
}
