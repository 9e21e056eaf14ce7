using System.Globalization;
using System.Reflection;
using NeuronMocap.Files;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Reader;

// The recordings and exports of one reader, and the metadata at the head of its recordings. Any thread.
internal sealed class ReaderRecordings
{
    private readonly object _lock = new();
    private readonly TimeSpan _stopTimeout;
    private volatile IFileOutput[] _all = [];
    private RecordingMetadata _metadata;
    private bool _ended;

    public ReaderRecordings(NeuronReaderOptions options, string name, object? receiveLock = null)
    {
        Tap = new StreamTap(receiveLock);
        _stopTimeout = options.StopTimeout / 2;
        _metadata = new RecordingMetadata()
            .With(RecordingMetadata.ProgramKey, DescribeProgram())
            .With(RecordingMetadata.ServerKey, options.Target)
            .With(RecordingMetadata.TransportKey, options.Transport.ToString())
            .With(RecordingMetadata.MaxValuesKey, options.MaxValues.ToString(CultureInfo.InvariantCulture));
        Learn(RecordingMetadata.ReaderKey, name);
        Learn(options.RotationOrder, options.SkeletonVariant);
    }

    public StreamTap Tap { get; }

    // Ended outputs stay in this list until their end is reported.
    public IReadOnlyList<IFileOutput> All => _all;

    // Whether a consumer of reports exists.
    public Func<bool> IsObserved { get; set; } = static () => false;

    // Called when a recording has begun and may need more information about the server.
    public Action Started { get; set; } = static () => { };

    // Called when a recording or an export has ended, on its thread: its end must be reported.
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

        Started();
        return recorder;
    }

    // The output ends with the reader. The caller makes sure that OnEnded is called.
    public void Add(IFileOutput output)
    {
        lock (_lock)
        {
            if (_ended)
                output.Stop();
            else
                _all = [.. _all, output];
        }

        // The output may have ended before it was added.
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
            Learn(RecordingMetadata.RotationOrderKey, knownOrder.ToString());
        if (variant is { } knownVariant)
            Learn(RecordingMetadata.SkeletonVariantKey, knownVariant.ToString());
    }

    public void Learn(BoneDimensions dimensions) => Learn(RecordingMetadata.BoneDimensionsKey, RecordingMetadata.ToText(dimensions));

    public void Learn(StreamFormat format)
    {
        if (format != StreamFormat.Unknown)
            Learn(RecordingMetadata.StreamFormatKey, format.ToString());
    }

    // Ends all outputs, and any output that is added now. Completes when their files are closed, or after half of the stop timeout.
    public async Task StopAsync()
    {
        lock (_lock)
            _ended = true;

        IFileOutput[] all = _all;
        foreach (IFileOutput output in all)
            output.Stop();

        if (all.Length > 0)
            await Task.WhenAny(Task.WhenAll(all.Select(static output => output.Ended)), Task.Delay(_stopTimeout)).ConfigureAwait(false);
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
