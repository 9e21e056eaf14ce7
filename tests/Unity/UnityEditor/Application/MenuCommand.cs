namespace UnityEditor;

public sealed class MenuCommand(UnityEngine.Object? context, int userData = 0)
{
    // Null where nothing was clicked, as in Unity; its signature does not say so.
    public UnityEngine.Object context { get; } = context!;

    public int userData { get; } = userData;
}
