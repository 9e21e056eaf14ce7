using UnityEngine.StandIn;

namespace UnityEngine;

/// <summary>
/// A body with a pose of its own. Physics notices a changed transform, or a changed parent, in <see cref="Physics.SyncTransforms"/> and at the
/// beginning of each step. It then places the body without a velocity. Unity does not say what becomes of a move that was asked for before; here, it is
/// lost. Moves become effective in the next step. Only kinematic bodies move; forces and collisions do not exist.
/// </summary>
public class Rigidbody : Component
{
    [NonSerialized]
    private Pose _pose;

    [NonSerialized]
    private Vector3? _nextPosition;

    [NonSerialized]
    private Quaternion? _nextRotation;

    [NonSerialized]
    private long _seenChange = -1;

    public Rigidbody() => PhysicsStep.Add(this);

    /// <summary>A body that becomes kinematic stops.</summary>
    public bool isKinematic
    {
        get;

        set
        {
            if (value && !field)
                (velocity, angularVelocity) = (Vector3.zero, Vector3.zero);

            field = value;
        }
    }

    public bool useGravity { get; set; } = true;

    public float mass { get; set; } = 1;

    public RigidbodyInterpolation interpolation { get; set; }

    public CollisionDetectionMode collisionDetectionMode { get; set; }

    public Vector3 velocity { get; set; }

    /// <summary>In radians per second.</summary>
    public Vector3 angularVelocity { get; set; }

    /// <summary>Gets the position, or sets it without a move. The transform follows after the next step.</summary>
    public Vector3 position
    {
        get => Known.position;
        set => _pose = new Pose(value, Known.rotation);
    }

    /// <summary>Gets the rotation, or sets it without a move. The transform follows after the next step.</summary>
    public Quaternion rotation
    {
        get => Known.rotation;
        set => _pose = new Pose(Known.position, value);
    }

    internal int Depth
    {
        get
        {
            int depth = 0;
            for (Transform? above = transform; above is not null; above = above.Parent)
                depth++;

            return depth;
        }
    }

    internal bool IsSimulated => !IsDestroyed && !IsAsset && gameObject.activeInHierarchy;

    private Pose Known
    {
        get
        {
            Check();
            Look();
            return _pose;
        }
    }

    /// <summary>Moves a kinematic body in the next physics step, with the velocity that takes it there. Other bodies jump.</summary>
    public void MovePosition(Vector3 position)
    {
        Look();
        if (isKinematic)
            _nextPosition = position;
        else
            this.position = position;
    }

    /// <summary>Turns a kinematic body in the next physics step, with the velocity that takes it there. Other bodies jump.</summary>
    public void MoveRotation(Quaternion rot)
    {
        if (Mathf.Abs(Quaternion.Dot(rot, rot) - 1) > 1e-4f)
            Debug.LogError("Rotation quaternions must be unit length.");
        Look();
        if (isKinematic)
            _nextRotation = rot;
        else
            rotation = rot;
    }

    /// <summary>Places the body where its transform is, if the transform has changed.</summary>
    internal void Sync()
    {
        if (transform.LastChange <= _seenChange)
            return;

        _pose = new Pose(transform.position, transform.rotation);
        (_nextPosition, _nextRotation) = (null, null);
        _seenChange = Transform.Changes;
    }

    internal void Simulate(float seconds)
    {
        Pose before = Known;
        if (isKinematic)
        {
            velocity = _nextPosition is { } position ? (position - before.position) / seconds : Vector3.zero;
            angularVelocity = _nextRotation is { } rotation ? TurnBetween(before.rotation, rotation) / seconds : Vector3.zero;
        }

        _pose = new Pose(_nextPosition ?? before.position, _nextRotation ?? before.rotation);
        (_nextPosition, _nextRotation) = (null, null);
    }

    /// <summary>Writes the pose to the transform, for parents before their children.</summary>
    internal void Show() => transform.SetPositionAndRotation(_pose.position, _pose.rotation);

    internal void EndStep() => _seenChange = Transform.Changes;

    // A new body is where its transform is.
    private void Look()
    {
        if (_seenChange < 0)
            Sync();
    }

    private static Vector3 TurnBetween(Quaternion from, Quaternion to)
    {
        Quaternion turn = to * Quaternion.Inverse(from);
        if (turn.w < 0)
            turn = new Quaternion(-turn.x, -turn.y, -turn.z, -turn.w);

        var sine = new Vector3(turn.x, turn.y, turn.z);
        float length = sine.magnitude;
        return length == 0 ? sine : sine * (2 * MathF.Atan2(length, turn.w) / length);
    }
}

public enum RigidbodyInterpolation
{
    None,
    Interpolate,
    Extrapolate,
}

public enum CollisionDetectionMode
{
    Discrete,
    Continuous,
    ContinuousDynamic,
    ContinuousSpeculative,
}
