using System.Diagnostics.CodeAnalysis;

namespace NeuronMocap.Polyfills;

// Members of collections that netstandard2.0 lacks.
internal static class CollectionPolyfills
{
    public static void Deconstruct<TKey, TValue>(this KeyValuePair<TKey, TValue> pair, out TKey key, out TValue value) => (key, value) = (pair.Key, pair.Value);

    public static TValue? GetValueOrDefault<TKey, TValue>(this Dictionary<TKey, TValue> dictionary, TKey key) =>
        dictionary.TryGetValue(key, out TValue? value) ? value : default;

    public static bool Remove<TKey, TValue>(this Dictionary<TKey, TValue> dictionary, TKey key, [MaybeNullWhen(false)] out TValue value) =>
        dictionary.TryGetValue(key, out value) && dictionary.Remove(key);

    public static bool TryPeek<T>(this Queue<T> queue, [MaybeNullWhen(false)] out T item)
    {
        item = queue.Count > 0 ? queue.Peek() : default;
        return queue.Count > 0;
    }

    public static bool TryDequeue<T>(this Queue<T> queue, [MaybeNullWhen(false)] out T item)
    {
        bool isFilled = queue.Count > 0;
        item = isFilled ? queue.Dequeue() : default;
        return isFilled;
    }
}
