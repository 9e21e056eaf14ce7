using System.Diagnostics;
using NeuronMocap.Transport;

namespace NeuronMocap.Diagnostics;

// The shares of the total time for each stage. Time that a stage does not use is not given to later stages.
internal sealed record DiagnosisBudget
{
    public double Name { get; init; } = 0.25;

    public double Connecting { get; init; } = 0.25;

    public double Silence { get; init; } = 0.3;

    public double Measuring { get; init; } = 0.2;

    public double Asking { get; init; } = 0.06;

    public double OtherPorts { get; init; } = 0.13;

    // Not a share, but the time that the other ports still get after one port has the stream.
    public TimeSpan Grace { get; init; } = TimeSpan.FromMilliseconds(200);
}

// The context of an examination: what to look for, for how long, and where to report it.
internal sealed class DiagnosisContext(LinkOptions link, DiagnosisOptions options, StepLog log, CancellationToken cancellationToken)
{
    private readonly Stopwatch _watch = Stopwatch.StartNew();

    public LinkOptions Link => link;

    public DiagnosisOptions Options => options;

    public DiagnosisBudget Budget => options.Budget;

    public PacketKind Expected => options.Expected;

    public StepLog Log => log;

    public CancellationToken CancellationToken => cancellationToken;

    public TimeSpan Elapsed => _watch.Elapsed;

    public TimeSpan Share(double part)
    {
        TimeSpan left = options.Timeout - _watch.Elapsed;
        TimeSpan share = options.Timeout * part;
        return left < share ? (left > TimeSpan.Zero ? left : TimeSpan.Zero) : share;
    }

    // Waits until one of the tasks ends or the time is over. Throws if the caller has stopped the diagnosis.
    public async Task WaitAsync(TimeSpan time, params Task[] tasks)
    {
        using var limitSource = CancellationTokenSource.CreateLinkedTokenSource(cancellationToken);
        await Task.WhenAny([.. tasks, Task.Delay(time, limitSource.Token)]).ConfigureAwait(false);
        limitSource.Cancel();
        cancellationToken.ThrowIfCancellationRequested();
    }
}
