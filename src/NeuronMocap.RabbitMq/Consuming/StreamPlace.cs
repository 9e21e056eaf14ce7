using NeuronMocap.RabbitMq.Connecting;

namespace NeuronMocap.RabbitMq.Consuming;

// A message in a stream, with what tells it from one at the same offset of another stream.
internal readonly record struct StreamPlace(long Offset, string Key, long? Run, long? Number, long? Captured)
{
    // Null if the message comes from no stream.
    public static StreamPlace? Find(string key, IDictionary<string, object?>? headers) =>
        MessageHeaders.Find(headers, MessageHeaders.StreamOffset) is { } offset
            ? new StreamPlace(
                offset,
                key,
                MessageHeaders.Find(headers, MessageHeaders.Run),
                MessageHeaders.Find(headers, MessageHeaders.Number),
                MessageHeaders.Find(headers, MessageHeaders.Captured))
            : null;
}
