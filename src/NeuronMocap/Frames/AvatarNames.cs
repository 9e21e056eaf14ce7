using System.Collections.Concurrent;
using NeuronMocap.Protocol;

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

        text = name.ToString();
        if (Volatile.Read(ref _count) < Limit && Texts.TryAdd(name, text))
            Interlocked.Increment(ref _count);

        return text;
    }
}
