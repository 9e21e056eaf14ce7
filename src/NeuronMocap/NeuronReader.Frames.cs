using System.Runtime.CompilerServices;
using NeuronMocap.Delivery;

namespace NeuronMocap;

/// <content>The ways to receive frames.</content>
public sealed partial class NeuronReader
{
    /// <summary>
    /// Occurs for every motion frame, on the receive thread. The frame lies in the receive buffer and is valid only during the call.
    /// </summary>
    /// <remarks>
    /// The reader receives nothing while a handler runs. Over TCP the server then waits and no frame is lost; over UDP, datagrams can be lost. Use a queue
    /// for work that takes long.
    /// </remarks>
    public event Action<MotionFrame>? MotionReceived
    {
        add => _pipeline.Callbacks.Motion.Add(value);
        remove => _pipeline.Callbacks.Motion.Remove(value);
    }

    /// <summary>Occurs for every calculation frame; otherwise the same as <see cref="MotionReceived"/>.</summary>
    public event Action<CalculationFrame>? CalculationReceived
    {
        add => _pipeline.Callbacks.Calculation.Add(value);
        remove => _pipeline.Callbacks.Calculation.Remove(value);
    }

    /// <summary>Occurs for every calculation frame of Axis Studio; otherwise the same as <see cref="MotionReceived"/>.</summary>
    public event Action<StudioCalculationFrame>? StudioCalculationReceived
    {
        add => _pipeline.Callbacks.StudioCalculation.Add(value);
        remove => _pipeline.Callbacks.StudioCalculation.Remove(value);
    }

    /// <summary>Opens a queue of all frames that arrive from now on. To get the first frame too, open the queue before you start the reader.</summary>
    /// <param name="capacity">Largest number of frames that can wait, 1 to 1,048,576; rounded up to a power of two.</param>
    /// <param name="name">
    /// Name of the queue in metrics and logs. Queues of the same name are counted together. Use few names, and keep them the same.
    /// </param>
    /// <returns>A new queue; dispose it when you no longer pump it.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The capacity is out of range.</exception>
    /// <exception cref="ArgumentException">The name is empty.</exception>
    public FrameQueue OpenQueue(int capacity = FrameQueue.DefaultCapacity, string name = FrameQueue.DefaultName)
    {
        if (string.IsNullOrWhiteSpace(name))
            throw new ArgumentException("The name must not be empty.", nameof(name));

        return _pipeline.OpenQueue(capacity, name);
    }

    /// <summary>
    /// Opens a queue of the frames that arrive from now on. The options can thin it to a rate, and set what happens when it is full. To get
    /// the first frame too, open the queue before you start the reader.
    /// </summary>
    /// <param name="options">Capacity, name, rate, and what happens when the queue is full; copied.</param>
    /// <returns>A new queue; dispose it when you no longer pump it.</returns>
    /// <exception cref="ArgumentException">An option is out of range; the message names it.</exception>
    public FrameQueue OpenQueue(FrameQueueOptions options)
    {
        return _pipeline.OpenQueue(Checked(options));
    }

    // For senders of poses: other packets would take the room of frames.
    internal FrameQueue OpenMotionQueue(FrameQueueOptions options) => _pipeline.OpenMotionQueue(Checked(options));

    /// <summary>Opens a view of the newest frame of each avatar, beginning now.</summary>
    /// <param name="options">Which frames the view shows; copied. Null for every frame.</param>
    /// <returns>A new view, for one thread; dispose it when you no longer use it.</returns>
    /// <exception cref="ArgumentException">An option is out of range; the message names it.</exception>
    public LatestFrames OpenLatest(LatestFramesOptions? options = null)
    {
        FrameThinning thinning = options?.Thinning ?? FrameThinning.None;
        if (thinning.FindFault() is { } fault)
            throw new ArgumentException(fault, nameof(options));

        return _pipeline.OpenLatest(thinning);
    }

    /// <summary>
    /// Opens a delivery of frames and changes of status to handlers on a window's thread, for example of Windows Forms, WPF, Avalonia or MAUI. Open it
    /// before or after the reader starts. To get the first frame too, open it before.
    /// </summary>
    /// <param name="options">How to deliver; copied. Null for every frame, on the context of this thread.</param>
    /// <returns>A new delivery; add handlers to its events. Dispose it when the window closes, or dispose the reader.</returns>
    /// <exception cref="InvalidOperationException">
    /// This thread has no <see cref="SynchronizationContext"/>, and the options name none; the message says what to set.
    /// </exception>
    /// <exception cref="ArgumentException">An option is out of range; the message names it.</exception>
    public FrameDelivery OpenDelivery(FrameDeliveryOptions? options = null) => OpenDeliveryWith(options, new SystemDeliveryClock());

    // Tests have their own clock.
    internal FrameDelivery OpenDeliveryWith(FrameDeliveryOptions? options, DeliveryClock clock)
    {
        FrameDeliveryOptions how = options?.Copy() ?? new FrameDeliveryOptions();
        if (how.FindFault() is { } fault)
            throw new ArgumentException(fault, nameof(options));

        FrameDelivery delivery = _pipeline.OpenDelivery(how, clock, ended => _statusHandlers.Remove(ended.OnStatus));
        _statusHandlers.Add(delivery.OnStatus);

        // A reader that has stopped changes its status no more.
        if (Status.State == ConnectionState.Stopped)
            delivery.OnReaderStopped();
        else if (delivery.End is not null)
            _statusHandlers.Remove(delivery.OnStatus);

        return delivery;
    }

    /// <summary>Enumerates motion frames as they arrive. Starts the reader if it is not running. Each frame is a copy that stays valid.</summary>
    /// <param name="cancellationToken">Ends the enumeration with an <see cref="OperationCanceledException"/>; the reader continues.</param>
    /// <returns>
    /// All frames until the reader stops. Up to 512 frames wait for a slow loop; further frames are dropped and counted in
    /// <see cref="ReaderStatistics.Dropped"/>.
    /// </returns>
    /// <exception cref="NeuronConnectionException">
    /// Reconnecting is off, and the connection failed. If the server closes it, the enumeration ends without an exception; <see cref="Status"/> has the reason.
    /// </exception>
    public IAsyncEnumerable<MotionFrame> ReadMotionAsync(CancellationToken cancellationToken = default) =>
        ReadAsync<MotionFrame>(PacketKind.Motion, options: null, cancellationToken);

    /// <summary>
    /// Enumerates motion frames as they arrive, thinned to a rate if you wish, and chooses what happens when the loop is slow. Otherwise the same as
    /// <see cref="ReadMotionAsync(CancellationToken)"/>.
    /// </summary>
    /// <param name="options">Capacity, name, rate, and what happens when the queue is full; copied.</param>
    /// <param name="cancellationToken">Ends the enumeration with an <see cref="OperationCanceledException"/>; the reader continues.</param>
    /// <returns>The frames until the reader stops.</returns>
    /// <exception cref="ArgumentException">An option is out of range; the message names it.</exception>
    /// <exception cref="NeuronConnectionException">
    /// Reconnecting is off, and the connection failed. If the server closes it, the enumeration ends without an exception; <see cref="Status"/> has the reason.
    /// </exception>
    public IAsyncEnumerable<MotionFrame> ReadMotionAsync(FrameQueueOptions options, CancellationToken cancellationToken = default) =>
        ReadAsync<MotionFrame>(PacketKind.Motion, Checked(options), cancellationToken);

    /// <summary>Enumerates calculation frames as they arrive; otherwise the same as <see cref="ReadMotionAsync(CancellationToken)"/>.</summary>
    /// <param name="cancellationToken">Ends the enumeration with an <see cref="OperationCanceledException"/>; the reader continues.</param>
    /// <returns>All frames until the reader stops.</returns>
    /// <exception cref="NeuronConnectionException">
    /// Reconnecting is off, and the connection failed. If the server closes it, the enumeration ends without an exception; <see cref="Status"/> has the reason.
    /// </exception>
    public IAsyncEnumerable<CalculationFrame> ReadCalculationAsync(CancellationToken cancellationToken = default) =>
        ReadAsync<CalculationFrame>(PacketKind.Calculation, options: null, cancellationToken);

    /// <summary>
    /// Enumerates calculation frames as they arrive; otherwise the same as <see cref="ReadMotionAsync(FrameQueueOptions, CancellationToken)"/>.
    /// </summary>
    /// <param name="options">Capacity, name, rate, and what happens when the queue is full; copied.</param>
    /// <param name="cancellationToken">Ends the enumeration with an <see cref="OperationCanceledException"/>; the reader continues.</param>
    /// <returns>The frames until the reader stops.</returns>
    /// <exception cref="ArgumentException">An option is out of range; the message names it.</exception>
    /// <exception cref="NeuronConnectionException">
    /// Reconnecting is off, and the connection failed. If the server closes it, the enumeration ends without an exception; <see cref="Status"/> has the reason.
    /// </exception>
    public IAsyncEnumerable<CalculationFrame> ReadCalculationAsync(FrameQueueOptions options, CancellationToken cancellationToken = default) =>
        ReadAsync<CalculationFrame>(PacketKind.Calculation, Checked(options), cancellationToken);

    /// <summary>Enumerates calculation frames of Axis Studio as they arrive; otherwise the same as <see cref="ReadMotionAsync(CancellationToken)"/>.</summary>
    /// <param name="cancellationToken">Ends the enumeration with an <see cref="OperationCanceledException"/>; the reader continues.</param>
    /// <returns>All frames until the reader stops.</returns>
    /// <exception cref="NeuronConnectionException">
    /// Reconnecting is off, and the connection failed. If the server closes it, the enumeration ends without an exception; <see cref="Status"/> has the reason.
    /// </exception>
    public IAsyncEnumerable<StudioCalculationFrame> ReadStudioCalculationAsync(CancellationToken cancellationToken = default) =>
        ReadAsync<StudioCalculationFrame>(PacketKind.StudioCalculation, options: null, cancellationToken);

    /// <summary>
    /// Enumerates calculation frames of Axis Studio as they arrive; otherwise the same as
    /// <see cref="ReadMotionAsync(FrameQueueOptions, CancellationToken)"/>.
    /// </summary>
    /// <param name="options">Capacity, name, rate, and what happens when the queue is full; copied.</param>
    /// <param name="cancellationToken">Ends the enumeration with an <see cref="OperationCanceledException"/>; the reader continues.</param>
    /// <returns>The frames until the reader stops.</returns>
    /// <exception cref="ArgumentException">An option is out of range; the message names it.</exception>
    /// <exception cref="NeuronConnectionException">
    /// Reconnecting is off, and the connection failed. If the server closes it, the enumeration ends without an exception; <see cref="Status"/> has the reason.
    /// </exception>
    public IAsyncEnumerable<StudioCalculationFrame> ReadStudioCalculationAsync(FrameQueueOptions options, CancellationToken cancellationToken = default) =>
        ReadAsync<StudioCalculationFrame>(PacketKind.StudioCalculation, Checked(options), cancellationToken);

    // Copies the options now, because the enumeration begins later.
    private static FrameQueueOptions Checked(FrameQueueOptions options)
    {
        ArgumentNullException.ThrowIfNull(options);
        return options.FindFault() is { } fault ? throw new ArgumentException(fault, nameof(options)) : options.Copy(defaultName: null);
    }

    private async IAsyncEnumerable<TFrame> ReadAsync<TFrame>(
        PacketKind kind, FrameQueueOptions? options, [EnumeratorCancellation] CancellationToken cancellationToken)
        where TFrame : AvatarFrame
    {
        using (FrameStream stream = _pipeline.OpenStream(kind, options))
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
