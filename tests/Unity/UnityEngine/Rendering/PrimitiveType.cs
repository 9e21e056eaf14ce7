namespace UnityEngine;

public enum PrimitiveType
{
    Sphere,
    Capsule,
    Cylinder,
    Cube,
    Plane,
    Quad,
}
