namespace NeuronMocap.Server.Broadcasting;

/// <summary>Publishes what a reader receives, at once, on the thread that receives it. Ends when the reader does.</summary>
/// <remarks>The receive thread waits only for the locks of the logs. The pacer's own thread only waits for the end.</remarks>
internal sealed class ReaderPacer : Pacer, IUnitListener
{
    private readonly NeuronReader _reader;
    private readonly Part[] _parts;
    private readonly Action? _connected;
    private readonly FaultReport _report;
    private long _incompletePackets;

    /// <summary>Creates a pacer.</summary>
    /// <param name="reader">The reader, whose owner starts and disposes it.</param>
    /// <param name="streams">What to publish, and the logs to publish to.</param>
    /// <param name="connected">Called for each new connection of the reader, on its thread; null for nobody.</param>
    /// <param name="ended">See the base class.</param>
    /// <param name="report">Receives unexpected exceptions, which must not end the receive thread.</param>
    public ReaderPacer(
        NeuronReader reader, IEnumerable<(UnitContent Content, FrameLog Log)> streams, Action? connected, Action<Exception?> ended, FaultReport report)
        : base(ended, report)
    {
        (_reader, _connected, _report) = (reader, connected, report);
        _parts = [.. streams.Select(static stream => new Part(stream.Content, stream.Log))];
    }

    // Thread-safe.
    public long IncompletePackets => Interlocked.Read(ref _incompletePackets);

    public override void Open() => ReaderUnits.Add(_reader, this);

    public override void Stop()
    {
        ReaderUnits.Remove(_reader, this);
        base.Stop();
    }

    protected override void PublishAll()
    {
        using var isOver = new CancellationTokenSource();
        _ = _reader.Completion.ContinueWith(_ => Stop(), isOver.Token, TaskContinuationOptions.ExecuteSynchronously, TaskScheduler.Default);
        lock (Lock)
        {
            while (!IsStopping)
                Monitor.Wait(Lock);
        }

        // The reader may live longer and must not keep this object.
        isOver.Cancel();
    }

    void IUnitListener.OnConnected() => _connected?.Invoke();

    void IUnitListener.OnUnits(UnitBatch units, int incomplete)
    {
        try
        {
            Interlocked.Add(ref _incompletePackets, incomplete);
            foreach (Part part in _parts)
                part.Publish(units);
        }
        catch (Exception exception)
        {
            // The system is out of memory. Other broadcasters of the reader go on.
            _report.Report(exception);
        }
    }

    void IUnitListener.OnFailed(Exception exception) => _report.Report(exception);

    private sealed class Part(UnitContent content, FrameLog log)
    {
        // Null if all units belong to the part.
        private readonly UnitBatch? _own = content.Takes(isCalculation: false) && content.Takes(isCalculation: true) ? null : new UnitBatch();

        public void Publish(UnitBatch units)
        {
            if (_own is null)
            {
                log.Publish(units);
                return;
            }

            _own.RemoveUnits();
            for (int i = 0; i < units.Count; i++)
            {
                if (!content.Takes(units.IsCalculation(i)))
                    continue;

                _own.Append(units.BytesOf(i));
                _own.Cut(units.TimeOf(i), units.IsCalculation(i));
            }

            log.Publish(_own);
        }
    }
}
