namespace UnityEngine;

public class Collider : Component
{
    public bool enabled { get; set; } = true;

    public bool isTrigger { get; set; }
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
    public float radius { get; set; } = 0.5f;

    public float height { get; set; } = 2;
}

public class MeshCollider : Collider
{
    public bool convex { get; set; }
}

public class Rigidbody : Component
{
    public bool isKinematic { get; set; }

    public bool useGravity { get; set; } = true;

    public Vector3 position
    {
        get => transform.position;
        set => transform.position = value;
    }

    public Quaternion rotation
    {
        get => transform.rotation;
        set => transform.rotation = value;
    }

    public void MovePosition(Vector3 position) => this.position = position;

    public void MoveRotation(Quaternion rot) => rotation = rot;
}
