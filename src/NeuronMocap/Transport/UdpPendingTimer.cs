using System.Diagnostics;

namespace NeuronMocap.Transport;

// Hands out datagrams that wait until it is known whose they are, where nothing arrives any more that would tell. Takes turns with the receive loop.
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

    // When it returns, nothing is being handed out and nothing will. Called by the one who awaits the receive loop's end. What still waits is handed
    // out here, unless a delivery failed: then nobody knows what state it left.
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

    // Fires once: while a handler blocks the one call, no further ones pile up behind it.
    private void Arm()
    {
        if (Interlocked.Exchange(ref _isArmed, 1) == 0)
            _timer.Change(Period, Timeout.InfiniteTimeSpan);
    }

    private void Settle()
    {
        // Whoever awaits the gate goes on in Leave or Fail, on this thread, and disposes of this.
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
