using UnityEngine;

namespace UnityEditor;

public static class GameObjectUtility
{
    public static void SetParentAndAlign(GameObject child, GameObject? parent)
    {
        if (parent == null)
            return;

        child.transform.SetParent(parent.transform, false);
        child.layer = parent.layer;
    }

    public static int GetMonoBehavioursWithMissingScriptCount(GameObject go) => go.MissingScripts.Count;

    /// <summary>Removes all of them. It registers no Undo.</summary>
    public static int RemoveMonoBehavioursWithMissingScript(GameObject go)
    {
        int count = go.MissingScripts.Count;
        go.MissingScripts = [];
        return count;
    }
}
