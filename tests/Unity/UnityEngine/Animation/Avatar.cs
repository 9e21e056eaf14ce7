namespace UnityEngine;

public class Avatar : Object
{
    internal Avatar(bool isValid, bool isHuman, HumanDescription description)
    {
        this.isValid = isValid;
        this.isHuman = isHuman;
        humanDescription = description;
    }

    private Avatar()
    {
    }

    public bool isValid { get; }

    public bool isHuman { get; }

    public HumanDescription humanDescription { get; }

    internal Quaternion[] PostRotations { get; set; } = [];

    /// <summary>Internal in Unity too, where tools find it by reflection.</summary>
    internal Quaternion GetPostRotation(int humanId) => PostRotations[humanId];
}
