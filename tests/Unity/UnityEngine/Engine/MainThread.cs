namespace UnityEngine.StandIn;

/// <summary>The only thread that may use Unity's objects: the thread that created the player loop, or ran its last frame.</summary>
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
