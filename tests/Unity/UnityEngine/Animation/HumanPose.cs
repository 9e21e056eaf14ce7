namespace UnityEngine;

public struct HumanPose
{
    public Vector3 bodyPosition;
    public Quaternion bodyRotation;
    public float[] muscles;
}
