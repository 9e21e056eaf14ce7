namespace NeuronMocap.Delivery;

// The totals of all queues of one name, including closed queues.
internal readonly record struct ConsumerStatistics(string Name, long Dropped, long Waiting);
