namespace UnityEngine;

public struct BoneWeight
{
    public float weight0 { get; set; }

    public float weight1 { get; set; }

    public float weight2 { get; set; }

    public float weight3 { get; set; }

    public int boneIndex0 { get; set; }

    public int boneIndex1 { get; set; }

    public int boneIndex2 { get; set; }

    public int boneIndex3 { get; set; }
}
