using System.Diagnostics;
using System.Threading.Channels;
using NeuronMocap.Server.Broadcasting;

namespace NeuronMocap.Server.Tests;

// A pacer's time under control of the test: each step goes from one wait of the pacer to the next.
internal sealed class ManualTime : PacerTime
{
    private readonly Channel<(object Gate, int Milliseconds)> _waits = Channel.CreateUnbounded<(object, int)>();
    private long _now = Stopwatch.Frequency;

    public override long Now => Volatile.Read(ref _now);

    public double Seconds => (Now / (double)Stopwatch.Frequency) - 1;

    public override void Wait(object gate, int milliseconds)
    {
        _waits.Writer.TryWrite((gate, milliseconds));
        Monitor.Wait(gate);
    }

    // Ends the pacer's wait. Returns when it is waiting again.
    public async Task<int> PassAsync()
    {
        (object gate, int milliseconds) = await _waits.Reader.ReadAsync(TestContext.Current.CancellationToken).Soon();
        lock (gate)
        {
            _now += milliseconds * Stopwatch.Frequency / 1000;
            Monitor.PulseAll(gate);
        }

        return milliseconds;
    }
}
