namespace UnityEditor;

public class AnimationClipSettings
{
    public bool loopTime { get; set; }

    public bool keepOriginalOrientation { get; set; }

    public bool keepOriginalPositionXZ { get; set; }

    public bool keepOriginalPositionY { get; set; }
}
