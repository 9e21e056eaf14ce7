namespace UnityEngine;

/// <summary>
/// Moves on request, without gravity of its own. The stand-in's scene has a floor and a wall, which a test may set. isGrounded tells whether the last
/// Move touched the floor. A collider below the controller stops every Move unless its collisions are ignored.
/// </summary>
public class CharacterController : Collider
{
    public Vector3 center { get; set; }

    public float height { get; set; } = 2;

    public float radius { get; set; } = 0.5f;

    public float minMoveDistance { get; set; } = 0.001f;

    public bool isGrounded { get; private set; }

    public CollisionFlags collisionFlags { get; private set; }

    /// <summary>For tests: the height of the floor, and the x of a wall that faces -X.</summary>
    internal static float Floor { get; set; } = float.NegativeInfinity;

    internal static float Wall { get; set; } = float.PositiveInfinity;

    public CollisionFlags Move(Vector3 motion)
    {
        // A shorter way is not gone at all, and nothing is touched.
        if (motion.magnitude < minMoveDistance)
            return collisionFlags;

        isGrounded = false;
        if (IsBlockedBy(transform))
            return collisionFlags = CollisionFlags.Sides;

        Vector3 place = transform.position + motion;
        float lowest = Floor + (height / 2) - center.y;
        float farthest = Wall - radius - center.x;
        collisionFlags = (place.y <= lowest ? CollisionFlags.Below : CollisionFlags.None) | (place.x >= farthest ? CollisionFlags.Sides : CollisionFlags.None);
        isGrounded = (collisionFlags & CollisionFlags.Below) == CollisionFlags.Below;
        transform.position = new Vector3(Mathf.Min(place.x, farthest), Mathf.Max(place.y, lowest), place.z);
        return collisionFlags;
    }

    private bool IsBlockedBy(Transform parent)
    {
        for (int i = 0; i < parent.childCount; i++)
        {
            Transform child = parent.GetChild(i);
            if (child.TryGetComponent(out Collider part) && part.enabled && !part.isTrigger && !Physics.GetIgnoreCollision(this, part))
                return true;
            if (IsBlockedBy(child))
                return true;
        }

        return false;
    }

    internal static void Clear() => (Floor, Wall) = (float.NegativeInfinity, float.PositiveInfinity);
}

[Flags]
public enum CollisionFlags
{
    None = 0,
    Sides = 1,
    Above = 2,
    Below = 4,
}

public class Physics
{
    public static Vector3 gravity { get; set; } = new(0, -9.81f, 0);

    public static void SyncTransforms() => StandIn.PhysicsStep.SyncTransforms();

    public static void IgnoreCollision(Collider collider1, Collider collider2) => IgnoreCollision(collider1, collider2, true);

    public static void IgnoreCollision(Collider collider1, Collider collider2, bool ignore)
    {
        collider1.Ignored.Remove(collider2);
        collider2.Ignored.Remove(collider1);
        if (ignore)
            collider1.Ignored.Add(collider2);
    }

    public static bool GetIgnoreCollision(Collider collider1, Collider collider2) =>
        collider1.Ignored.Contains(collider2) || collider2.Ignored.Contains(collider1);
}
