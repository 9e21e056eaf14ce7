namespace UnityEngine.StandIn;

/// <summary>The one thread that may touch Unity's objects: the one that made the player loop, or that ran its last frame.</summary>
internal static class MainThread
{
    private static int _id = Environment.CurrentManagedThreadId;

    public static bool IsCurrent => Environment.CurrentManagedThreadId == _id;

    public static void Claim() => _id = Environment.CurrentManagedThreadId;

    public static void Check([System.Runtime.CompilerServices.CallerMemberName] string member = "")
    {
        if (!IsCurrent)
            throw new UnityException($"{member} can only be called from the main thread.");
    }
}
