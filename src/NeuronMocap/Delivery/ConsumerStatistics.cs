namespace NeuronMocap.Delivery;

// The totals of all consumers of one name, including closed ones.
internal readonly record struct ConsumerStatistics(string Name, long Dropped, long Waiting, long Skipped = 0);
