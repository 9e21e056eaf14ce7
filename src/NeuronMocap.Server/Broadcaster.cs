using System.Globalization;
using System.Net;
using NeuronMocap.Commands;
using NeuronMocap.Protocol;
using NeuronMocap.Server.Broadcasting;
using NeuronMocap.Server.Clients;
using NeuronMocap.Server.Sources;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server;

/// <summary>
/// Sends the frames of one or more avatars over the network as Axis Neuron does, to any number of TCP clients and to UDP destinations. The
/// motion comes from sources, a recording, or a reader.
/// </summary>
/// <remarks>
/// TCP clients only have to connect; they need not send anything. A client can neither end a broadcast nor affect another client.
/// <para>
/// All members are thread-safe. One thread listens, one makes the frames of a paced broadcast, and each recipient has a thread that writes to it.
/// All of them are background threads. On .NET, the thread that makes a frame also sends it to recipients that keep up; it never waits for them. For packets
/// of a <see cref="BroadcasterOptions.Reader"/>, this is its receive thread.
/// </para>
/// </remarks>
public sealed partial class Broadcaster : IDisposable, IAsyncDisposable
{
    private readonly object _lock = new();
    private readonly FaultReport _report = new(nameof(Broadcaster));
    private readonly BroadcasterOptions _options;
    private readonly ZeroOutSource[] _actors;
    private readonly FramePlan? _plan;
    private readonly RequestForwarder? _forwarder;
    private readonly DataCommandReplies? _replies;
    private readonly BroadcastStream[] _streams;
    private readonly bool _isPacketwise;
    private readonly Pacer? _pacer;
    private readonly List<Recipient> _recipients = [];
    private readonly WorkerList _workers = new();
    private readonly TaskCompletionSource<bool> _completion = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private RecipientCounters _departed;
    private long _accepted;
    private long _refused;
    private bool _isStarted;
    private bool _hasBegun;
    private bool _hasEnded;

    /// <summary>Creates a broadcaster without starting it.</summary>
    /// <param name="options">The settings, which are copied.</param>
    /// <exception cref="ArgumentException">An option is out of range; the message names it.</exception>
    /// <exception cref="NeuronException">The file of <see cref="BroadcasterOptions.RecordingPath"/> cannot be played.</exception>
    /// <exception cref="IOException">The file of <see cref="BroadcasterOptions.RecordingPath"/> cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">Access to the file of <see cref="BroadcasterOptions.RecordingPath"/> is denied.</exception>
    public Broadcaster(BroadcasterOptions options)
        : this(options, time: null)
    {
    }

    // The time is the clock for the frames of sources. Null is the real clock.
    internal Broadcaster(BroadcasterOptions options, PacerTime? time)
    {
        _options = (options ?? throw new ArgumentNullException(nameof(options))).CopyChecked();
        _actors = UseZeroOutSources();
        FrameRate = _options.FrameRate ?? (_options.Sources.Count > 0 ? _options.Sources[0].FrameRate : 0);
        if (_options.Reader is { } reader)
        {
            _forwarder = _options.AnswerDataCommands ? new RequestForwarder(reader, _report) : null;
            _streams = CreateStreams((hasMotion, hasCalculation) => new ReaderContent(reader, hasMotion, hasCalculation));
            _pacer = new ReaderPacer(
                reader, _streams.Select(static stream => ((UnitContent)stream.Content, stream.Log!)), _forwarder is null ? null : _forwarder.Renew, OnPacerEnded, _report);
            return;
        }

        if (_options.RecordingPath is not null)
        {
            _streams = CreateStreams((hasMotion, hasCalculation) => new RecordingContent(_options, hasMotion, hasCalculation));
            _pacer = IsPaced
                ? new RecordingPacer([.. _streams.Select(static stream => ((RecordingContent)stream.Content, stream.Log!))], _options, OnPacerEnded, _report)
                : null;
            return;
        }

        FramePlan[] plans = CreatePlans(_options, FrameRate);
        _plan = plans[0];
        _replies = new DataCommandReplies(_plan, _options.DataCommandLength);
        _isPacketwise = IsPaced && new PacketSpacing(FrameRate, plans.Max(static plan => plan.PacketsPerFrame)).IsPacketwise;
        _streams = [CreateStream(_plan, _options.AnswerDataCommands ? _replies : null), .. plans.Skip(1).Select(plan => CreateStream(plan, isBeside: true))];
        _pacer = IsPaced ? new FramePacer([.. _streams.Select(static stream => ((FramePlan)stream.Content, stream.Log!))], FrameRate, OnPacerEnded, _report, time) : null;
    }

    // Tests replace it because they cannot use up all threads of a system.
    internal Action<Worker> StartWorker { get; init; } = static worker => worker.Start();

    /// <summary>Address and real port where TCP clients connect. Null before the start and without a listener.</summary>
    public IPEndPoint? LocalEndPoint { get; private set; }

    /// <summary>Address and real port where TCP clients connect for calculation packets only.</summary>
    /// <value>Null before the start, without a listener, or when <see cref="BroadcasterOptions.CalculationPort"/> is not set.</value>
    public IPEndPoint? CalculationEndPoint { get; private set; }

    /// <summary>Frames per second: the setting, or the rate of the first source.</summary>
    /// <value><see cref="BroadcasterOptions.MaxFrameRate"/> when the broadcast is not paced; 0 for a recording or a reader, which have their own times.</value>
    public double FrameRate { get; }

    /// <summary>The values that motion packets carry, from the settings or else from the first source. The default value for a recording or a reader.</summary>
    public ChannelLayout Layout => _plan?.Layout ?? default;

    internal TimeSpan ClientTimeout => _options.ClientTimeout;

    /// <summary>Completes when the broadcast is over or the broadcaster is stopped.</summary>
    /// <remarks>
    /// <para>
    /// A paced broadcast is over after its last frame, when no client is left to wait for. A client is done when it has read all frames, has
    /// disconnected, or has used up <see cref="BroadcasterOptions.CloseTimeout"/>.
    /// </para>
    /// <para>
    /// The broadcast of a reader is over when the reader has stopped. A lost connection does not end it.
    /// </para>
    /// <para>
    /// A broadcast at <see cref="BroadcasterOptions.MaxFrameRate"/> is over when all data was sent and no client is left. All data must have been
    /// sent to each destination, and to at least one client of each port. Without a port, once a reader of <see cref="CreateLocalSource"/> has come, all
    /// data must have been sent to one such reader or to a destination.
    /// </para>
    /// <para>
    /// The task fails if a source or a calculation provider throws, which closes all connections. It also fails if the system cannot create the
    /// thread that makes the frames.
    /// </para>
    /// </remarks>
    public Task Completion => _completion.Task;

    /// <summary>Gets the totals of what was sent since the start.</summary>
    /// <returns>A snapshot.</returns>
    public BroadcasterStatistics GetStatistics()
    {
        lock (_lock)
        {
            RecipientCounters total = _recipients.Aggregate(_departed, (sum, recipient) => sum.Add(recipient.Counters));
            total = total with { RequestsDropped = total.RequestsDropped + (_forwarder?.Dropped ?? 0) };
            long incomplete = (_pacer as ReaderPacer)?.IncompletePackets ?? 0;
            return new BroadcasterStatistics(
                _streams.Sum(CountClients), _streams.Where(static stream => stream.IsBeside).Sum(CountClients), _accepted, _refused, incomplete, total);
        }
    }

    /// <summary>Gets the recipients that are being served, each with its counters.</summary>
    /// <returns>A new list.</returns>
    public IReadOnlyList<BroadcasterClient> GetClients()
    {
        lock (_lock)
            return _recipients.ConvertAll(Describe);
    }

    /// <summary>Gets which sensors an avatar wears.</summary>
    /// <param name="avatarIndex">Index of the avatar, from 0.</param>
    /// <returns>The last value given to <see cref="SetCombinationMode"/>; <see cref="CombinationMode.FullBody"/> at first.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The avatar does not exist.</exception>
    public CombinationMode GetCombinationMode(int avatarIndex) => GetReplies(avatarIndex).GetMode(avatarIndex);

    /// <summary>
    /// Sets which sensors an avatar wears. Clients read the value with <see cref="DataCommandId.CombinationMode"/>; the frames do not change.
    /// </summary>
    /// <remarks>
    /// Clients that registered for this value receive it when it changes. It is documented that a server sends a registered value when it changes.
    /// It is inferred that the server does so at once, and also upon the registration, as this one does (protocol.md section 7).
    /// </remarks>
    /// <param name="avatarIndex">Index of the avatar, from 0.</param>
    /// <param name="mode">The sensors that the avatar wears. Any number is accepted, for tests of clients.</param>
    /// <exception cref="ArgumentOutOfRangeException">The avatar does not exist.</exception>
    public void SetCombinationMode(int avatarIndex, CombinationMode mode)
    {
        if (!GetReplies(avatarIndex).SetMode(avatarIndex, mode))
            return;

        lock (_lock)
        {
            foreach (ClientSession client in _recipients.OfType<ClientSession>())
                client.Push(DataCommandId.CombinationMode, avatarIndex);
        }
    }

    /// <summary>Opens the port and starts to listen. Also starts to send, unless the settings say to wait for a client.</summary>
    /// <exception cref="BroadcasterException">The port or a destination is not available. The broadcaster can be started again.</exception>
    /// <exception cref="InvalidOperationException">The broadcaster has already been started.</exception>
    /// <exception cref="ObjectDisposedException">The broadcaster has been stopped.</exception>
    public void Start()
    {
        lock (_lock)
        {
            if (_hasEnded)
                throw new ObjectDisposedException(nameof(Broadcaster), "The broadcaster has been stopped.");
            if (_isStarted)
                throw new InvalidOperationException("The broadcaster has already been started.");

            Open();
            _isStarted = true;
            foreach (BroadcastStream stream in _streams)
            {
                if (stream.Listener is not { } listener)
                    continue;

                listener.Worker.Start();
                _workers.Add(listener.Worker);
            }

            if (!_options.WaitForClient)
                Begin();
        }
    }

    /// <summary>
    /// Closes all connections at once, without waiting for clients, and ends all threads. Returns within seconds and can be called repeatedly.
    /// </summary>
    public void Stop()
    {
        Worker[] workers;
        lock (_lock)
        {
            Close(error: null);
            workers = _workers.ToArray();
        }

        WorkerList.Join(workers);
    }

    /// <summary>Stops the broadcaster, as <see cref="Stop"/> does.</summary>
    public void Dispose() => Stop();

    /// <summary>Stops the broadcaster, as <see cref="Stop"/> does, without blocking the caller.</summary>
    /// <returns>A task that completes when everything is closed.</returns>
    public ValueTask DisposeAsync() => new(Task.Run(Stop));

    // A recording and a reader have no replies to data commands.
    private DataCommandReplies GetReplies(int avatarIndex) => (uint)avatarIndex < (uint)_actors.Length
        ? _replies!
        : throw new ArgumentOutOfRangeException(nameof(avatarIndex), avatarIndex, $"The index must be at least 0 and less than the number of avatars, {_actors.Length}.");

    private bool IsPaced => !double.IsPositiveInfinity(FrameRate);

    // With a port for calculation, the second stream has it.
    private BroadcastStream[] CreateStreams(Func<bool, bool, UnitContent> create) => _options.CalculationPort is null
        ? [CreateStream(create(true, true))]
        : [CreateStream(create(true, false)), CreateStream(create(false, true), isBeside: true)];

    private BroadcastStream CreateStream(BroadcastContent content, DataCommandReplies? replies = null, bool isBeside = false) =>
        new(content, IsPaced ? new FrameLog(_options.QueueCapacity, content.PacketsPerFrame) { MaxDirect = GetMaxDirect(content) } : null, replies)
        {
            IsBeside = isBeside,
            IsPacketwise = _isPacketwise,
            Forwarder = _forwarder,
            IsDirect = _options.RecordingPath is null && DirectSending.IsSupported,
        };

    // The pacer sends to no more clients than it can without falling behind at the rate of the frames. How often a reader receives is not known.
    private int GetMaxDirect(BroadcastContent content) => _options.Reader is not null
        ? FrameLog.DefaultMaxDirect
        : (int)Math.Min(DirectSending.MaxPerSecond / (FrameRate * (_isPacketwise ? content.PacketsPerFrame : 1)), FrameLog.LargestMaxDirect);

    // One plan for each port.
    private static FramePlan[] CreatePlans(BroadcasterOptions options, double rate)
    {
        var names = new AvatarName[options.Sources.Count];
        for (int i = 0; i < names.Length; i++)
        {
            string ordinary = "Char" + i.ToString("00", CultureInfo.InvariantCulture);
            names[i] = new AvatarName(i < options.AvatarNames.Count ? options.AvatarNames[i] : ordinary);
        }

        double frameRate = double.IsPositiveInfinity(rate) ? options.Sources[0].FrameRate : rate;
        bool hasCalculation = options.Calculation is not null || options.StudioCalculation is not null;
        return options.CalculationPort is null
            ? [new FramePlan(options, names, frameRate, options.SendMotion, hasCalculation)]
            : [
                new FramePlan(options, names, frameRate, hasMotion: true, hasCalculation: false),
                new FramePlan(options, names, frameRate, hasMotion: false, hasCalculation: true),
            ];
    }

    private static BroadcasterClient Describe(Recipient recipient) =>
        new(recipient.RemoteEndPoint, recipient is UdpRecipient, recipient.Stream.IsBeside, recipient.Counters);
}
