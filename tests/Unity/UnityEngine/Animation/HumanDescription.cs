namespace UnityEngine;

[Serializable]
public struct HumanDescription
{
    public HumanBone[] human;
    public SkeletonBone[] skeleton;

    public float upperArmTwist { get; set; }

    public float lowerArmTwist { get; set; }

    public float upperLegTwist { get; set; }

    public float lowerLegTwist { get; set; }

    public float armStretch { get; set; }

    public float legStretch { get; set; }

    public float feetSpacing { get; set; }

    public bool hasTranslationDoF { get; set; }
}

[Serializable]
public struct HumanBone
{
    public HumanLimit limit;

    public string boneName { get; set; }

    public string humanName { get; set; }
}

[Serializable]
public struct HumanLimit
{
    public bool useDefaultValues { get; set; }

    public Vector3 min { get; set; }

    public Vector3 max { get; set; }

    public Vector3 center { get; set; }

    public float axisLength { get; set; }
}

[Serializable]
public struct SkeletonBone
{
    public string name;
    public Vector3 position;
    public Quaternion rotation;
    public Vector3 scale;
}
