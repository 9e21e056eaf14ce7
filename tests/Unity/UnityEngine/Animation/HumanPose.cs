namespace UnityEngine;

public struct HumanPose
{
    public Vector3 bodyPosition;
    public Quaternion bodyRotation;
    public float[] muscles;

    /// <summary>Since Unity 6000.1. Relative to the body and divided by the human scale, as in clips: feet, then hands, left before right.</summary>
    public readonly ReadOnlySpan<Vector3> ikGoalPositions => GoalPositions;

    /// <summary>Since Unity 6000.1. Relative to the body, as in clips.</summary>
    public readonly ReadOnlySpan<Quaternion> internalIkGoalRotations => GoalRotations;

    internal Vector3[]? GoalPositions { readonly get; set; }

    internal Quaternion[]? GoalRotations { readonly get; set; }
}
