using UnityEngine.StandIn;

namespace UnityEngine;

public static class GUILayoutUtility
{
    public static Rect GetRect(float width, float height, params GUILayoutOption[] options)
    {
        ImmediateGui.Add("Rect", "");
        return ImmediateGui.FreeRect;
    }
}
