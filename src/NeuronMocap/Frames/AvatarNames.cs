using System.Collections.Concurrent;

namespace NeuronMocap.Frames;

// Caches the string of each avatar's name, so reading it in every frame allocates nothing. The cache is bounded because names come from the network.
internal static class AvatarNames
{
    private const int Limit = 1024;

    private static readonly ConcurrentDictionary<AvatarName, string> Texts = new();
    private static int _count;

    public static string GetText(AvatarName name)
    {
        if (Texts.TryGetValue(name, out string? text))
            return text;

        // A sender that invents names empties the cache from time to time. Real names return with their next frame.
        if (Interlocked.Increment(ref _count) > Limit)
        {
            Texts.Clear();
            Volatile.Write(ref _count, 0);
        }

        return Texts.GetOrAdd(name, name.ToString());
    }
}
