using UnityEngine.StandIn;

namespace UnityEngine;

public class AvatarBuilder
{
    /// <summary>Never returns null. If an avatar is not valid, the log says why.</summary>
    public static Avatar BuildHumanAvatar(GameObject go, HumanDescription humanDescription)
    {
        go.Check();
        List<string> faults = AvatarRules.Find(go.transform, humanDescription);
        foreach (string fault in faults)
            Debug.LogError($"AvatarBuilder '{go.name}': {fault}");

        bool isValid = faults.Count == 0;
        return new Avatar(isValid, isValid, humanDescription)
        {
            name = go.name + "Avatar",
            PostRotations = isValid ? LimbGoals.FindPostRotations(go.transform, humanDescription) : [],
        };
    }

    public static Avatar BuildGenericAvatar(GameObject go, string rootMotionTransformName) => new(true, false, default) { name = go.name };
}
