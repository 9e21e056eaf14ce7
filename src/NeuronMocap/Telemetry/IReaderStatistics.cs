using NeuronMocap.Delivery;
using NeuronMocap.Files;
using NeuronMocap.Protocol;

namespace NeuronMocap.Telemetry;

// What a reader counts. Any thread.
internal interface IReaderStatistics
{
    ConnectionState State { get; }

    // Lost frames that the next few frames may still show to be a change of the server's frequency.
    long UnsettledLoss { get; }

    ReaderStatistics GetStatistics();

    IReadOnlyList<ConsumerStatistics> GetConsumers();

    long GetSkipped(SkipReason reason);

    // Recordings and exports. Those that have ended included, until Forget.
    IReadOnlyList<IFileOutput> Outputs { get; }

    void Forget(IFileOutput output);
}
