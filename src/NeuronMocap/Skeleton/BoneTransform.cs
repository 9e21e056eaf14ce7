using System.Numerics;

namespace NeuronMocap;

/// <summary>Position and rotation of a bone. The member that returns it says whether it is relative to the parent or to the world.</summary>
/// <param name="Position">Centimetres; right-handed axes, Y up, X to the subject's left, Z forward.</param>
/// <param name="Rotation">A unit quaternion.</param>
public readonly record struct BoneTransform(Vector3 Position, Quaternion Rotation)
{
    /// <summary>Gets the transform at the origin, without rotation.</summary>
    public static BoneTransform Identity => new(Vector3.Zero, Quaternion.Identity);

    /// <summary>Converts a transform relative to this one into the space that this transform is given in.</summary>
    /// <param name="local">A transform relative to this one, such as that of a child.</param>
    /// <returns>The same position and rotation, one level up.</returns>
    public BoneTransform Apply(BoneTransform local) => new(TransformPoint(local.Position), Rotation * local.Rotation);

    /// <summary>Converts a transform to one relative to this transform. It is the inverse of <see cref="Apply"/>.</summary>
    /// <param name="outer">A transform in the space that this transform is given in.</param>
    /// <returns>The same position and rotation, relative to this transform.</returns>
    public BoneTransform ToLocal(BoneTransform outer)
    {
        var back = Quaternion.Conjugate(Rotation);
        return new BoneTransform(Vector3.Transform(outer.Position - Position, back), back * outer.Rotation);
    }

    /// <summary>Converts a point relative to this transform into the space that this transform is given in.</summary>
    /// <param name="point">A point in this transform's axes, in centimetres.</param>
    /// <returns>The point one level up, in centimetres.</returns>
    public Vector3 TransformPoint(Vector3 point) => Position + Vector3.Transform(point, Rotation);
}
