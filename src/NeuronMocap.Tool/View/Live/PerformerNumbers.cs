using NeuronMocap.Tool.View.Performers;

namespace NeuronMocap.Tool.View.Live;

/// <summary>Gives every performer a number of its own for compact poses, which do not say who sent them. Thread-safe.</summary>
/// <remarks>The first performer with an avatar number keeps it. Others with the same number, from other senders, get a free one.</remarks>
internal sealed class PerformerNumbers
{
    // A sender can invent avatar numbers. As many as a reader counts.
    private const int Most = 1024;

    private const int FirstFree = 1000;

    private readonly Lock _lock = new();
    private readonly Dictionary<PerformerKey, int> _numbers = [];
    private readonly HashSet<int> _taken = [];

    /// <summary>Gets the number of a performer. Null if there are too many.</summary>
    public int? Find(PerformerKey key)
    {
        lock (_lock)
        {
            if (_numbers.TryGetValue(key, out int number))
                return number;
            if (_numbers.Count == Most)
                return null;

            number = key.Avatar;
            for (int next = FirstFree; !_taken.Add(number); next++)
                number = next;

            _numbers.Add(key, number);
            return number;
        }
    }
}
