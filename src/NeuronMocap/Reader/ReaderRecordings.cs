using System.Globalization;
using System.Reflection;
using NeuronMocap.Commands;
using NeuronMocap.Files;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Reader;

// The recordings and exports of one reader, and what is written at the head of its recordings. Any thread.
internal sealed class ReaderRecordings
{
    // Half of what a stop of the reader may take.
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(1);

    // Servers count from 0; a recording has the sizes of the first one's body.
    private const int Avatar = 0;

    private readonly object _lock = new();
    private readonly NeuronCommandOptions? _commands;
    private volatile IFileOutput[] _all = [];
    private RecordingMetadata _metadata;
    private NeuronCommandClient? _client;
    private bool _isAsking;
    private bool _ended;

    public ReaderRecordings(NeuronReaderOptions options, string name, object? gate = null)
    {
        Tap = new StreamTap(gate);
        _commands = options.Commands;
        _metadata = new RecordingMetadata()
            .With(RecordingMetadata.Program, DescribeProgram())
            .With(RecordingMetadata.Server, options.Transport == TransportKind.Udp ? $"UDP port {options.Port}" : options.Link.Target)
            .With(RecordingMetadata.TransportName, options.Transport.ToString())
            .With(RecordingMetadata.MaxValuesName, options.MaxValues.ToString(CultureInfo.InvariantCulture));
        Learn(RecordingMetadata.Reader, name);
        Learn(options.RotationOrder, options.SkeletonVariant);
    }

    public StreamTap Tap { get; }

    // Those that ended stay until the report has told it.
    public IReadOnlyList<IFileOutput> All => _all;

    // Whether somebody waits for reports.
    public Func<bool> IsObserved { get; set; } = static () => false;

    // Called when a recording or an export has ended, on its thread: somebody waits for the report.
    public Action Report { get; set; } = static () => { };

    public StreamRecorder Start(string path, RecordingOptions options, object reader)
    {
        StreamRecorder recorder;
        lock (_lock)
        {
            ObjectDisposedException.ThrowIf(_ended, reader);
            recorder = new StreamRecorder(path, options, _metadata, Tap, OnEnded);
            _all = [.. _all, recorder];
        }

        Ask();
        return recorder;
    }

    // Ends with the reader; the caller tells OnEnded.
    public void Add(IFileOutput output)
    {
        lock (_lock)
        {
            if (_ended)
                output.Stop();
            else
                _all = [.. _all, output];
        }

        // It may have ended before it was known here.
        if (output.Completion.IsCompleted)
            OnEnded(output);
    }

    public void Forget(IFileOutput output)
    {
        lock (_lock)
            _all = [.. _all.Where(other => other != output)];
    }

    public void Learn(RotationOrder? order, SkeletonVariant? variant)
    {
        if (order is { } knownOrder)
            Learn(RecordingMetadata.RotationOrderName, knownOrder.ToString());
        if (variant is { } knownVariant)
            Learn(RecordingMetadata.SkeletonVariantName, knownVariant.ToString());
    }

    public void Learn(StreamFormat format)
    {
        if (format != StreamFormat.Unknown)
            Learn(RecordingMetadata.StreamFormatName, format.ToString());
    }

    // A connection stands, or a recording began: asks the command channel, where there is one, for the sizes of the body, until it has answered.
    public void Ask()
    {
        lock (_lock)
        {
            if (_commands is null || _ended || _isAsking || !_all.OfType<StreamRecorder>().Any() || _metadata[RecordingMetadata.BoneDimensionsName] is not null)
                return;

            _isAsking = true;
            _client ??= new NeuronCommandClient(_commands);
            _ = AskAsync(_client);
        }
    }

    // Ends all of them, and those that somebody begins now. Completes when their files are closed, or after a second.
    public async Task StopAsync()
    {
        lock (_lock)
        {
            _ended = true;
            _ = _client?.DisposeAsync().AsTask();
        }

        IFileOutput[] all = _all;
        foreach (IFileOutput output in all)
            output.Stop();

        if (all.Length > 0)
            await Task.WhenAny(Task.WhenAll(all.Select(static output => output.Ended)), Task.Delay(Patience)).ConfigureAwait(false);
    }

    private void Learn(string key, string value)
    {
        lock (_lock)
        {
            if (string.Equals(_metadata[key], value, StringComparison.Ordinal) || !_metadata.TryWith(key, value, out RecordingMetadata? metadata, out _))
                return;

            _metadata = metadata;
            foreach (StreamRecorder recorder in _all.OfType<StreamRecorder>())
                recorder.SetMetadata(key, value);
        }
    }

    private async Task AskAsync(NeuronCommandClient client)
    {
        try
        {
            BoneDimensions dimensions = await client.GetBoneDimensionsAsync(Avatar).ConfigureAwait(false);
            Learn(RecordingMetadata.BoneDimensionsName, RecordingMetadata.ToText(dimensions));
        }
        catch (Exception exception) when (exception is NeuronCommandException or ObjectDisposedException)
        {
            // The status says that the command channel does not answer; the next connection asks again.
        }
        finally
        {
            lock (_lock)
                _isAsking = false;
        }
    }

    public void OnEnded(IFileOutput output)
    {
        if (IsObserved())
            Report();
        else
            Forget(output);
    }

    private static string DescribeProgram()
    {
        string library = Describe(typeof(NeuronReader).Assembly);
        return Assembly.GetEntryAssembly() is { } program ? $"{Describe(program)} ({library})" : library;
    }

    private static string Describe(Assembly assembly) => $"{assembly.GetName().Name} {assembly.GetName().Version?.ToString(3)}";
}
