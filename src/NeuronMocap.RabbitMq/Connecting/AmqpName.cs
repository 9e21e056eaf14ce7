using System.Text;

namespace NeuronMocap.RabbitMq.Connecting;

// Names of exchanges and queues, and routing keys: a short string of the protocol has one byte for its length.
internal static class AmqpName
{
    public const int MaxBytes = 255;

    public static bool Fits(string name) => Encoding.UTF8.GetByteCount(name) <= MaxBytes;
}
