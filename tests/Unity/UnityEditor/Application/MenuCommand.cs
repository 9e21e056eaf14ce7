namespace UnityEditor;

public sealed class MenuCommand(UnityEngine.Object? context, int userData = 0)
{
    // Null if no object was clicked, as in Unity, although the signature does not say so.
    public UnityEngine.Object context { get; } = context!;

    public int userData { get; } = userData;
}
