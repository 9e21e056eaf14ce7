namespace NeuronMocap;

internal struct HashCode
{
    private int _hash;

    public void Add<T>(T value) => _hash = (_hash * 31) + (value?.GetHashCode() ?? 0);

    public readonly int ToHashCode() => _hash;
}
