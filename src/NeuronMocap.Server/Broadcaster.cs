using System.Diagnostics;
using System.Globalization;
using System.Net;
using NeuronMocap.Protocol;
using NeuronMocap.Server.Broadcasting;
using NeuronMocap.Server.Clients;
using NeuronMocap.Server.Sources;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server;

/// <summary>
/// Does on the network what Axis Neuron does: sends the frames of one or several avatars to any number of TCP clients, which connect and
/// need not say anything, and to UDP destinations.
/// <para>
/// All members may be used from any thread. Nothing that a client does ends a broadcast or reaches another client. Threads: one listens,
/// one makes the frames of a paced broadcast, and every receiver has one that writes to it, all in the background.
/// </para>
/// </summary>
public sealed partial class Broadcaster : IDisposable, IAsyncDisposable
{
    private static readonly TimeSpan JoinTimeout = TimeSpan.FromSeconds(5);

    private readonly object _lock = new();
    private readonly FaultReport _report = new(nameof(Broadcaster));
    private readonly BroadcasterOptions _options;
    private readonly ZeroOutSource[] _actors;
    private readonly FramePlan? _plan;
    private readonly RecordingContent? _recording;
    private readonly DataCommandReplies? _replies;
    private readonly BroadcastStream[] _streams;
    private readonly bool _isPacketwise;
    private readonly Pacer? _pacer;
    private readonly List<Recipient> _recipients = [];
    private readonly TaskCompletionSource<bool> _completion = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private RecipientCounters _departed;
    private long _accepted;
    private long _refused;
    private bool _isStarted;
    private bool _hasBegun;
    private bool _hasEnded;

    /// <summary>Makes a broadcaster that does nothing yet.</summary>
    /// <param name="options">The settings; copied.</param>
    /// <exception cref="ArgumentException">A setting is out of its range; the message names it.</exception>
    /// <exception cref="NeuronException">The file of <see cref="BroadcasterOptions.RecordingPath"/> is none that can be played.</exception>
    /// <exception cref="IOException">The file of <see cref="BroadcasterOptions.RecordingPath"/> cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">The file of <see cref="BroadcasterOptions.RecordingPath"/> may not be read.</exception>
    public Broadcaster(BroadcasterOptions options)
        : this(options, time: null)
    {
    }

    // Time: of the frames of sources; null for the real one.
    internal Broadcaster(BroadcasterOptions options, PacerTime? time)
    {
        _options = (options ?? throw new ArgumentNullException(nameof(options))).CopyChecked();
        _actors = UseZeroOutSources();
        FrameRate = _options.FrameRate ?? (_options.Sources.Count > 0 ? _options.Sources[0].FrameRate : 0);
        if (_options.RecordingPath is not null)
        {
            bool hasOnePort = _options.CalculationPort is null;
            _recording = new RecordingContent(_options, hasMotion: true, hasCalculation: hasOnePort);
            _streams = hasOnePort
                ? [CreateStream(_recording)]
                : [CreateStream(_recording), CreateStream(new RecordingContent(_options, hasMotion: false, hasCalculation: true), isBeside: true)];
            _pacer = IsPaced
                ? new RecordingPacer([.. _streams.Select(static stream => ((RecordingContent)stream.Content, stream.Log!))], _options, OnPacerEnded, _report)
                : null;
            return;
        }

        FramePlan[] plans = CreatePlans(_options, FrameRate);
        _plan = plans[0];
        _replies = new DataCommandReplies(_plan, _options.DataCommandLength);
        _isPacketwise = IsPaced && new PacketSpacing(FrameRate, plans.Max(static plan => plan.PacketsPerFrame)).IsPacketwise;
        _streams = [CreateStream(_plan, _options.AnswerDataCommands ? _replies : null), .. plans[1..].Select(plan => CreateStream(plan, isBeside: true))];
        _pacer = IsPaced ? new FramePacer([.. _streams.Select(static stream => ((FramePlan)stream.Content, stream.Log!))], FrameRate, OnPacerEnded, _report, time) : null;
    }

    // Replaced by tests, which cannot use up all threads of a system.
    internal Action<Worker> StartWorker { get; init; } = static worker => worker.Start();

    /// <summary>Where TCP clients connect, with the real port; null before the start and without a listener.</summary>
    public IPEndPoint? LocalEndPoint { get; private set; }

    /// <summary>
    /// Where TCP clients connect for calculation packets alone, with the real port; null before the start, and without
    /// <see cref="BroadcasterOptions.CalculationPort"/> or a listener.
    /// </summary>
    public IPEndPoint? CalculationEndPoint { get; private set; }

    /// <summary>
    /// Frames per second: the setting or the first source's own; <see cref="BroadcasterOptions.MaxFrameRate"/> when not paced;
    /// 0 for a recording, which has times of its own.
    /// </summary>
    public double FrameRate { get; }

    /// <summary>Which values the motion packets carry: the settings, and the first source where they leave it to it. Of a recording the default.</summary>
    public ChannelLayout Layout => _plan?.Layout ?? default;

    /// <summary>
    /// Ends when the broadcast is over. At a paced rate: the last frame was made, and all clients have read it, have left, or have used up
    /// <see cref="BroadcasterOptions.CloseTimeout"/>. At <see cref="BroadcasterOptions.MaxFrameRate"/>: the destinations were sent everything,
    /// at least one client of each port was, and none is left. Also ends when the broadcaster is stopped; fails when a source or a calculation writer
    /// threw, which closes all connections, or when the system had no thread left to make the frames on.
    /// </summary>
    public Task Completion => _completion.Task;

    /// <summary>Counts what was sent since the start.</summary>
    /// <returns>A snapshot.</returns>
    public BroadcasterStatistics GetStatistics()
    {
        lock (_lock)
        {
            RecipientCounters total = _recipients.Aggregate(_departed, (sum, recipient) => sum.Add(recipient.Counters));
            return new BroadcasterStatistics(_streams.Sum(CountClients), _streams.Where(stream => stream.IsBeside).Sum(CountClients), _accepted, _refused, total);
        }
    }

    /// <summary>The receivers that are served now, each with its numbers.</summary>
    /// <returns>A new list.</returns>
    public IReadOnlyList<BroadcasterClient> GetClients()
    {
        lock (_lock)
            return _recipients.ConvertAll(Describe);
    }

    /// <summary>Tells which sensors an avatar wears.</summary>
    /// <param name="avatarIndex">Number of the avatar, from 0.</param>
    /// <returns>What <see cref="SetCombinationMode"/> set last; <see cref="SensorCombination.FullBody"/> at first.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such avatar.</exception>
    public SensorCombination GetCombinationMode(int avatarIndex) => GetReplies(avatarIndex).GetMode(avatarIndex);

    /// <summary>
    /// Changes which sensors an avatar is said to wear, which is what <see cref="DataCommandId.CombinationMode"/> tells clients; the frames stay as
    /// they are. Clients that registered for it are sent the new value, unless it is the old one. That a server sends a registered value when it
    /// changes is documented, and that it does so at once, here also upon the registration, is inferred (protocol.md section 7).
    /// </summary>
    /// <param name="avatarIndex">Number of the avatar, from 0.</param>
    /// <param name="mode">What the avatar wears; any number, for tests of clients.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such avatar.</exception>
    public void SetCombinationMode(int avatarIndex, SensorCombination mode)
    {
        if (!GetReplies(avatarIndex).SetMode(avatarIndex, mode))
            return;

        lock (_lock)
        {
            foreach (TcpClientSession client in _recipients.OfType<TcpClientSession>())
                client.Push(DataCommandId.CombinationMode, avatarIndex);
        }
    }

    /// <summary>Takes the port, begins to listen and, unless told to wait for a client, to send.</summary>
    /// <exception cref="BroadcasterException">The port or a destination cannot be had. The broadcaster can be started again.</exception>
    /// <exception cref="InvalidOperationException">It was started before.</exception>
    /// <exception cref="ObjectDisposedException">It was stopped before.</exception>
    public void Start()
    {
        lock (_lock)
        {
            if (_hasEnded)
                throw new ObjectDisposedException(nameof(Broadcaster), "The broadcaster was stopped.");
            if (_isStarted)
                throw new InvalidOperationException("The broadcaster was started before.");

            Open();
            _isStarted = true;
            foreach (BroadcastStream stream in _streams)
                stream.Listener?.Worker.Start();
            if (!_options.WaitForClient)
                Begin();
        }
    }

    /// <summary>
    /// Closes all connections at once, without waiting for clients, and ends all threads. Returns within seconds; may be repeated.
    /// </summary>
    public void Stop()
    {
        Worker?[] workers;
        lock (_lock)
        {
            workers = [.. _streams.Select(stream => stream.Listener?.Worker), _pacer?.Worker, .. _recipients.ConvertAll(recipient => recipient.Worker)];
            Close(error: null);
        }

        long deadline = Stopwatch.GetTimestamp() + (long)(JoinTimeout.TotalSeconds * Stopwatch.Frequency);
        foreach (Worker? worker in workers)
            worker?.Join(deadline);
    }

    /// <summary>Does what <see cref="Stop"/> does.</summary>
    public void Dispose() => Stop();

    /// <summary>Does what <see cref="Stop"/> does, without blocking the caller.</summary>
    /// <returns>Ends when all is closed.</returns>
    public ValueTask DisposeAsync() => new(Task.Run(Stop));

    // A recording has none that could be asked for.
    private DataCommandReplies GetReplies(int avatarIndex) => (uint)avatarIndex < (uint)_actors.Length
        ? _replies!
        : throw new ArgumentOutOfRangeException(nameof(avatarIndex), avatarIndex, $"The number of avatars is {_actors.Length}; the first is 0.");

    private bool IsPaced => !double.IsPositiveInfinity(FrameRate);

    private BroadcastStream CreateStream(BroadcastContent content, DataCommandReplies? replies = null, bool isBeside = false) =>
        new(content, IsPaced ? new FrameLog(_options.QueueCapacity, content.PacketsPerFrame) : null, replies)
        {
            IsBeside = isBeside,
            IsPacketwise = _isPacketwise,
        };

    // One for each port.
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
