namespace NeuronMocap.Delivery;

// All queues of one name together, those that were closed included.
internal readonly record struct ConsumerStatistics(string Name, long Dropped, long Waiting);
