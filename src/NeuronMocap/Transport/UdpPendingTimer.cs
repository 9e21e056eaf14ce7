using System.Diagnostics;

namespace NeuronMocap.Transport;

// Delivers waiting datagrams if no more datagrams arrive that would identify their server. Takes turns with the receive loop.
internal sealed class UdpPendingTimer : IDisposable
{
    private static readonly TimeSpan Period = TimeSpan.FromMilliseconds(50);

    private readonly object _lock = new();
    private readonly UdpSenders _senders;
    private readonly ReceiveGate _gate;
    private readonly Timer _timer;
    private int _isArmed;
    private bool _hasFailed;
    private bool _hasEnded;

    public UdpPendingTimer(UdpSenders senders, ReceiveGate gate)
    {
        _senders = senders;
        _gate = gate;
        _timer = new Timer(static settling => ((UdpPendingTimer)settling!).Settle(), this, Timeout.Infinite, Timeout.Infinite);
        senders.Waits = Arm;
    }

    // Called by the code that awaits the end of the receive loop. Delivers the remaining datagrams, unless a delivery failed: the state after that is
    // unknown. After this method returns, no more held datagrams are delivered.
    public void Dispose()
    {
        lock (_lock)
        {
            if (_hasEnded)
                return;

            _hasEnded = true;
            _timer.Dispose();
        }

        if (!_hasFailed && !_gate.IsInside)
            _senders.Settle(Stopwatch.GetTimestamp(), isLast: true);
    }

    // Fires once, so no further calls accumulate while a handler blocks the current one.
    private void Arm()
    {
        if (Interlocked.Exchange(ref _isArmed, 1) == 0)
            _timer.Change(Period, Timeout.InfiniteTimeSpan);
    }

    private void Settle()
    {
        // Code that awaits the gate continues in Leave or Fail, on this thread, and disposes this object.
        lock (_lock)
        {
            if (_hasEnded)
                return;

            Volatile.Write(ref _isArmed, 0);
            if (!_gate.TryEnterIdle())
            {
                Arm();
                return;
            }

            try
            {
                _senders.Settle(Stopwatch.GetTimestamp());
                if (_senders.IsWaiting)
                    Arm();
            }
            catch (Exception exception)
            {
                _hasFailed = true;
                _gate.Fail(exception);
                return;
            }

            _gate.Leave();
        }
    }
}
