using System.Collections.Concurrent;

namespace NeuronMocap.Frames;

// Makes each avatar's name a string once, so that asking for it in every frame allocates nothing. Bounded, because names come from the network.
internal static class AvatarNames
{
    private const int Limit = 1024;

    private static readonly ConcurrentDictionary<AvatarName, string> Texts = new();
    private static int _count;

    public static string GetText(AvatarName name)
    {
        if (Texts.TryGetValue(name, out string? text))
            return text;

        // A sender that makes up names empties the cache now and then; real names come back with their next frame.
        if (Interlocked.Increment(ref _count) > Limit)
        {
            Texts.Clear();
            Volatile.Write(ref _count, 0);
        }

        return Texts.GetOrAdd(name, name.ToString());
    }
}
