using System.Reflection;
using NeuronMocap.Recording;
using NeuronMocap.Server;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Convert;

/// <summary>Converts a file, or a part of it, to another kind of file.</summary>
internal sealed class ConvertTool(FileSettings settings, StandardStreams streams)
{
    private readonly TimeRange _range = new(settings.From, settings.To);
    private readonly ConversionSummary _summary = new();

    /// <summary>Converts the file. Returns the exit code.</summary>
    public Task<int> RunAsync(CancellationToken cancellationToken) => new FileRun(settings, streams).RunAsync((output, stop) => Run(output!, stop), cancellationToken);

    private void Run(OutputFile output, CancellationToken cancellationToken)
    {
        FileKind to = FileKinds.OfName(settings.Output!)!.Value;
        FileKind from = settings.RecognizeInput();
        if (from == FileKind.Raw && settings.InputRate is null)
            _summary.AddWarning("the bytes have no times, and the rate of their timecodes, or 120 Hz, is assumed; set --rate if it differs");

        output.Write(path =>
        {
            using var progress = new ProgressLine(streams, $"writing {Path.GetFileName(settings.Output)}");
            Write(from, to, path, progress, cancellationToken);
            if (from == FileKind.Recording)
                StreamWarnings.AddDamage(_summary, settings.Input, cancellationToken);
        });
        streams.Complain(_summary.Describe(Path.GetFileName(settings.Output!)));
    }

    private void Write(FileKind from, FileKind to, string path, IProgress<double> progress, CancellationToken cancellationToken)
    {
        bool isStream = from is FileKind.Recording or FileKind.Raw;
        if (to == FileKind.Calculation && settings.OutputOrder is not null)
            throw new NeuronException("--output-order: a calculation export holds no angles.");
        if (to == FileKind.Csv && settings.OutputOrder is not null)
            throw new NeuronException("--output-order: a table holds quaternions, which have no order.");

        switch (to)
        {
            case FileKind.Bvh when from == FileKind.Bvh:
                BvhEdit.Write(settings, _range, path, _summary, progress, cancellationToken);
                break;
            case FileKind.Recording or FileKind.Raw when isStream:
                CopyStream(from, to, path, progress, cancellationToken);
                StreamWarnings.AddStream(_summary, path, to == FileKind.Recording, cancellationToken);
                break;
            case FileKind.Recording or FileKind.Raw when from == FileKind.Calculation:
                RejectForCopy("the rows of a calculation export become packets as they are");
                CalculationCopy.ToPackets(settings, _range, OpenSink(to, path, take: null), _summary, progress, cancellationToken);
                AddLossOfRaw(to);
                break;
            case FileKind.Glb:
                new GlbOutput(settings, _range, _summary, progress, cancellationToken).Write(from, path);
                break;
            case FileKind.Calculation when from == FileKind.Calculation:
                RejectForCopy("the rows of a calculation export are copied as they are");
                CalculationCopy.ToFile(settings, _range, path, _summary, progress, cancellationToken);
                break;
            case FileKind.Calculation when isStream && settings.FrameRate is null
                && CalculationRows.TryWrite(settings, _range, path, _summary, progress, cancellationToken):
                break;
            case FileKind.Csv when isStream && settings.FrameRate is null && StreamTable.TryWrite(settings, _range, path, _summary, progress, cancellationToken):
                break;
            default:
                WriteTake(from, to, path, progress, cancellationToken);
                break;
        }
    }

    private void WriteTake(FileKind from, FileKind to, string path, IProgress<double> progress, CancellationToken cancellationToken)
    {
        InputTake take = InputTake.Load(settings, from, progress, cancellationToken);
        RotationOrder order = settings.OutputOrder ?? take.Order;
        MotionSource motion = take.Range.IsAll && settings.FrameRate is null ? take.Motion : new TakePart(take.Motion, take.GetPart(), settings.FrameRate);
        switch (to)
        {
            case FileKind.Bvh:
                using (FileStream file = File.Create(path))
                    BvhOutput.Write(motion, take.Layout, order, file, progress, cancellationToken);
                break;
            case FileKind.Calculation:
                using (FileStream file = File.Create(path))
                    CalculationOutput.Write(motion, file, progress, cancellationToken);
                _summary.AddLoss("the bones' rotations and lengths (an export holds sensors and centres)");
                break;
            case FileKind.Csv:
                TakeTable.Write(settings, take, motion, path, progress, cancellationToken);
                break;
            default:
                using (IPacketSink sink = OpenSink(to, path, take with { Order = order }))
                    MotionPackets.Write(motion, take.Layout, order, new AvatarName(take.AvatarName), sink, progress, cancellationToken);
                AddLossOfRaw(to);
                break;
        }

        TakeWarnings.Add(_summary, settings, take, motion, cancellationToken);
    }

    private void AddLossOfRaw(FileKind to)
    {
        if (to == FileKind.Raw)
            _summary.AddLoss("times, rotation order and body: raw bytes cannot hold them; give --rate and --order when reading");
    }

    private void CopyStream(FileKind from, FileKind to, string path, IProgress<double> progress, CancellationToken cancellationToken)
    {
        RejectForCopy("the bytes of a stream are copied as they were received");
        if (settings.InputOrder is not null)
            throw new NeuronException("--order: the bytes of a stream are copied as they were received.");
        if (settings.Avatar is not null)
            throw new NeuronException("--avatar: the bytes of a stream are copied as they were received, of all avatars.");
        if (settings.Sender is not null)
            throw new NeuronException("--sender: the bytes of a stream are copied as they were received, of all senders.");

        if (from == FileKind.Raw && to == FileKind.Recording)
        {
            using RecordingWriter recording = CreateRecording(path, Metadata());
            RawDump.CopyTo(
                settings.Input, recording, settings.Playback, _range.Start, settings.To is { } end ? TimeSpan.FromSeconds(end) : null, progress, cancellationToken);
            return;
        }

        if (from == FileKind.Raw)
            throw new NeuronException("Both files are the bytes of a stream; there is nothing to convert.");

        using RecordingReader reader = RecordingReader.Open(settings.Input);
        if (_range.From is not null)
            reader.Seek(_range.Start);

        var copy = new RecordingCopy(reader, _range, progress, cancellationToken);
        if (to == FileKind.Raw)
        {
            using FileStream file = File.Create(path);
            copy.WriteTo(file);
        }
        else
        {
            using RecordingWriter writer = RecordingWriter.Create(path, reader.Metadata, new RecordingWriterOptions { StartTime = reader.StartTime + _range.Start });
            copy.WriteTo(writer);
        }

        if (copy.Pieces == 0)
            throw new NeuronException(Quantity.Format($"No frames remain: the recording ends at {reader.Duration.TotalSeconds:0.###} s."));
    }

    private void RejectForCopy(string why)
    {
        if (settings.FrameRate is not null)
            throw new NeuronException($"--resample: {why}; only poses can be interpolated, for a .bvh file.");
        if (settings.OutputOrder is not null)
            throw new NeuronException($"--output-order: {why}.");
    }

    private IPacketSink OpenSink(FileKind kind, string path, InputTake? take)
    {
        if (kind == FileKind.Raw)
            return new RawSink(File.Create(path));

        RecordingMetadata metadata = Metadata();
        if (take is not null)
        {
            string hierarchy = SourceHierarchy.GetText(take);
            metadata = metadata
                .With(RecordingMetadata.RotationOrderKey, take.Order.ToString())
                .With(RecordingMetadata.SkeletonVariantKey, take.Motion.Variant.ToString())
                .With(RecordingMetadata.BvhHierarchyKey, hierarchy);
        }

        return new RecordingSink(CreateRecording(path, metadata));
    }

    // A converted file records only the time at which it was written.
    private RecordingWriter CreateRecording(string path, RecordingMetadata metadata) => RecordingWriter.Create(
        path, metadata, new RecordingWriterOptions { StartTime = new DateTimeOffset(File.GetLastWriteTimeUtc(settings.Input), TimeSpan.Zero) });

    private RecordingMetadata Metadata()
    {
        string? version = typeof(ConvertTool).Assembly.GetCustomAttribute<AssemblyInformationalVersionAttribute>()?.InformationalVersion;
        return RecordingMetadata.Empty
            .With(RecordingMetadata.ProgramKey, $"neuron-mocap {version}")
            .With(RecordingMetadata.ServerKey, $"the file {settings.SourceName}");
    }
}
