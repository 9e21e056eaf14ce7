using NeuronMocap.Delivery;
using NeuronMocap.Files;
using NeuronMocap.Protocol;

namespace NeuronMocap.Telemetry;

// The counters of a reader. Any thread.
internal interface IReaderStatistics
{
    ConnectionState State { get; }

    // The system's buffer for datagrams, in bytes; null for TCP.
    int? ReceiveBufferSize { get; }

    // Number of lost frames that may turn out to be a change of the server's frequency after the next few frames.
    long UnsettledLoss { get; }

    ReaderStatistics GetStatistics();

    IReadOnlyList<ConsumerStatistics> GetConsumers();

    long GetSkipped(SkipReason reason);

    // Recordings and exports, including ended ones until Forget.
    IReadOnlyList<IFileOutput> Outputs { get; }

    void Forget(IFileOutput output);
}
