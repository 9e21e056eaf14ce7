using System.Numerics;

namespace NeuronMocap;

/// <summary>Position and rotation of a bone, relative to its parent or to the world, as the member that gives it says.</summary>
/// <param name="Position">Centimetres; right-handed axes, Y up, X to the subject's left, Z forward.</param>
/// <param name="Rotation">A unit quaternion.</param>
public readonly record struct BoneTransform(Vector3 Position, Quaternion Rotation)
{
    /// <summary>At the origin, not turned.</summary>
    public static BoneTransform Identity => new(Vector3.Zero, Quaternion.Identity);

    /// <summary>Brings a transform that is relative to this one into the axes that this one is given in.</summary>
    /// <param name="local">A transform relative to this one, as a child's is to its parent.</param>
    /// <returns>The same place and rotation, one level up.</returns>
    public BoneTransform Apply(BoneTransform local) => new(TransformPoint(local.Position), Rotation * local.Rotation);

    /// <summary>Makes a transform relative to this one: the inverse of <see cref="Apply"/>.</summary>
    /// <param name="outer">A transform in the axes that this one is given in.</param>
    /// <returns>The same place and rotation, as a child of this one has them.</returns>
    public BoneTransform ToLocal(BoneTransform outer)
    {
        var back = Quaternion.Conjugate(Rotation);
        return new BoneTransform(Vector3.Transform(outer.Position - Position, back), back * outer.Rotation);
    }

    /// <summary>Brings a point that is relative to this transform one level up.</summary>
    /// <param name="point">Centimetres in this transform's axes.</param>
    /// <returns>Centimetres in the axes that this transform is given in.</returns>
    public Vector3 TransformPoint(Vector3 point) => Position + Vector3.Transform(point, Rotation);
}
