using System.Runtime.CompilerServices;
using NeuronMocap.Delivery;

namespace NeuronMocap;

/// <content>The ways in which frames reach the application.</content>
public sealed partial class NeuronReader
{
    /// <summary>
    /// Called with every motion frame, on the receive thread. The frame lies in the receive buffer and is valid during the call. While a
    /// handler runs, nothing more is received: over TCP the server then waits and nothing is lost, over UDP datagrams may be. For work
    /// that takes long, open a queue.
    /// </summary>
    public event Action<MotionFrame>? MotionReceived
    {
        add => _pipeline.Callbacks.Motion.Add(value);
        remove => _pipeline.Callbacks.Motion.Remove(value);
    }

    /// <summary>Called with every calculation frame; otherwise as <see cref="MotionReceived"/>.</summary>
    public event Action<CalculationFrame>? CalculationReceived
    {
        add => _pipeline.Callbacks.Calculation.Add(value);
        remove => _pipeline.Callbacks.Calculation.Remove(value);
    }

    /// <summary>Called with every calculation frame of Axis Studio; otherwise as <see cref="MotionReceived"/>.</summary>
    public event Action<StudioCalculationFrame>? StudioCalculationReceived
    {
        add => _pipeline.Callbacks.StudioCalculation.Add(value);
        remove => _pipeline.Callbacks.StudioCalculation.Remove(value);
    }

    /// <summary>
    /// Opens a queue of all frames that arrive from now on. To get the first one too, open it before the reader is started.
    /// </summary>
    /// <param name="capacity">Largest number of frames that can wait, 1 to 1,048,576; rounded up to a power of two.</param>
    /// <param name="name">What metrics and logs call the queue; those of one name are counted together. Names shall be few and lasting.</param>
    /// <returns>A queue of its own; dispose of it when it is no longer pumped.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The capacity is out of range.</exception>
    /// <exception cref="ArgumentException">The name is empty.</exception>
    public FrameQueue OpenQueue(int capacity = FrameQueue.DefaultCapacity, string name = FrameQueue.DefaultName)
    {
        if (string.IsNullOrWhiteSpace(name))
            throw new ArgumentException("The name must not be empty.", nameof(name));

        return _pipeline.OpenQueue(capacity, name);
    }

    /// <summary>Opens a view of the newest frame of each avatar, from now on.</summary>
    /// <returns>A view of its own, for one thread; dispose of it when it is no longer used.</returns>
    public LatestFrames OpenLatest() => _pipeline.OpenLatest();

    /// <summary>Enumerates motion frames as they arrive, starting the reader if it was not. Each frame is a copy that stays valid.</summary>
    /// <param name="cancellationToken">Ends the enumeration with an <see cref="OperationCanceledException"/>; the reader goes on.</param>
    /// <returns>
    /// Frames until the reader stops. Up to 512 wait for a slow loop; more are dropped and counted in <see cref="ReaderStatistics.Dropped"/>.
    /// </returns>
    /// <exception cref="NeuronConnectionException">Reconnecting is off, and the connection failed or was cut off.</exception>
    public IAsyncEnumerable<MotionFrame> ReadMotionAsync(CancellationToken cancellationToken = default) =>
        ReadAsync<MotionFrame>(PacketKind.Motion, cancellationToken);

    /// <summary>Enumerates calculation frames as they arrive; otherwise as <see cref="ReadMotionAsync"/>.</summary>
    /// <param name="cancellationToken">Ends the enumeration with an <see cref="OperationCanceledException"/>; the reader goes on.</param>
    /// <returns>Frames until the reader stops.</returns>
    /// <exception cref="NeuronConnectionException">Reconnecting is off, and the connection failed or was cut off.</exception>
    public IAsyncEnumerable<CalculationFrame> ReadCalculationAsync(CancellationToken cancellationToken = default) =>
        ReadAsync<CalculationFrame>(PacketKind.Calculation, cancellationToken);

    /// <summary>Enumerates Axis Studio's calculation frames as they arrive; otherwise as <see cref="ReadMotionAsync"/>.</summary>
    /// <param name="cancellationToken">Ends the enumeration with an <see cref="OperationCanceledException"/>; the reader goes on.</param>
    /// <returns>Frames until the reader stops.</returns>
    /// <exception cref="NeuronConnectionException">Reconnecting is off, and the connection failed or was cut off.</exception>
    public IAsyncEnumerable<StudioCalculationFrame> ReadStudioCalculationAsync(CancellationToken cancellationToken = default) =>
        ReadAsync<StudioCalculationFrame>(PacketKind.StudioCalculation, cancellationToken);

    private async IAsyncEnumerable<TFrame> ReadAsync<TFrame>(PacketKind kind, [EnumeratorCancellation] CancellationToken cancellationToken)
        where TFrame : AvatarFrame
    {
        using (FrameStream stream = _pipeline.OpenStream(kind))
        {
            Start();
            while (await stream.ReadAsync(cancellationToken).ConfigureAwait(false) is { } frame)
                yield return (TFrame)frame;
        }

        ConnectionStatus last = _status.Current;
        if (last.Reason is not (ConnectionReason.Requested or ConnectionReason.ClosedByPeer or ConnectionReason.EndOfRecording))
            throw new NeuronConnectionException(last.Reason, last.Message);
    }
}
