namespace UnityEngine;

public class Collider : Component
{
    public bool enabled { get; set; } = true;

    public bool isTrigger { get; set; }

    [field: NonSerialized]
    internal List<Collider> Ignored { get; } = [];
}

public class BoxCollider : Collider
{
    public Vector3 center { get; set; }

    public Vector3 size { get; set; } = Vector3.one;
}

public class SphereCollider : Collider
{
    public float radius { get; set; } = 0.5f;
}

public class CapsuleCollider : Collider
{
    public Vector3 center { get; set; }

    /// <summary>The axis of the capsule: 0 for X, 1 for Y, 2 for Z.</summary>
    public int direction { get; set; } = 1;

    public float radius { get; set; } = 0.5f;

    public float height { get; set; } = 2;
}

public class MeshCollider : Collider
{
    public bool convex { get; set; }
}
