namespace UnityEngine;

[Serializable]
public struct Pose(Vector3 position, Quaternion rotation)
{
    public Vector3 position = position;
    public Quaternion rotation = rotation;

    public static Pose identity => new(Vector3.zero, Quaternion.identity);
}
