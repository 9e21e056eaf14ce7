namespace NeuronMocap.RabbitMq.Connecting;

// Names of the headers of a message. They are part of the format that docs/guide/scale.md describes.
internal static class MessageHeaders
{
    // A random number of the publisher. A publisher that starts again has another one.
    public const string Run = "run";

    // Number of the frame among those of its avatar and kind, from 1. A step of more than 1 is a loss.
    public const string Number = "number";

    // When the publisher's reader received the frame: microseconds since 1970, UTC.
    public const string Captured = "captured";

    public const string Stage = "stage";

    public const string Avatar = "avatar";

    // Added by the broker.
    public const string StreamOffset = "x-stream-offset";

    public static long? Find(IDictionary<string, object?>? headers, string name) =>
        headers is not null && headers.TryGetValue(name, out object? value) && value is long number ? number : null;
}
