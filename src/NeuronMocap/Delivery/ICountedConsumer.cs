namespace NeuronMocap.Delivery;

// A consumer that can drop or skip frames, and let frames wait. Any thread reads its figures.
internal interface ICountedConsumer
{
    string Name { get; }

    long Dropped { get; }

    long Skipped { get; }

    int Count { get; }

    // No more frames will arrive.
    void CompleteAdding();
}
