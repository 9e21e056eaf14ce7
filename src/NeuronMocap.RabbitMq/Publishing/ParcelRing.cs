namespace NeuronMocap.RabbitMq.Publishing;

// A ring with two ends, which allocates once.
internal sealed class ParcelRing(int capacity)
{
    private readonly Parcel[] _items = new Parcel[capacity];
    private int _first;

    public int Count { get; private set; }

    public Parcel this[int index] => _items[(_first + index) % _items.Length];

    public void AddLast(Parcel parcel) => _items[(_first + Count++) % _items.Length] = parcel;

    public void AddFirst(Parcel parcel)
    {
        _first = (_first + _items.Length - 1) % _items.Length;
        _items[_first] = parcel;
        Count++;
    }

    public Parcel RemoveFirst()
    {
        Parcel parcel = _items[_first];
        _first = (_first + 1) % _items.Length;
        Count--;
        return parcel;
    }

    public Parcel RemoveLast() => _items[(_first + --Count) % _items.Length];
}
