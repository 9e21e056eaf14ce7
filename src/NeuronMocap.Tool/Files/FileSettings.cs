using NeuronMocap.Calculation;
using NeuronMocap.Csv;
using NeuronMocap.Recording;
using NeuronMocap.Server.Sources;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Files;

/// <summary>Settings of the verbs for files.</summary>
/// <param name="Input">The file to read.</param>
/// <param name="Output">The file to write; null if none is written.</param>
internal sealed record FileSettings(string Input, string? Output)
{
    /// <summary>Name of the input for people, if it differs from that of the file; otherwise null.</summary>
    public string? InputName { get; init; }

    /// <summary>What a file that is written calls its source.</summary>
    public string SourceName => InputName ?? Path.GetFileName(Input);

    /// <summary>Whether an existing output may be replaced.</summary>
    public bool Overwrite { get; init; }

    /// <summary>Index of the avatar in a recording; null for the first.</summary>
    public int? Avatar { get; init; }

    /// <summary>Number of the sender in a recording of datagrams; null for the first.</summary>
    public int? Sender { get; init; }

    /// <summary>Rotation order of a stream in the input, which streams do not carry. Null for the order that the file states, or YXZ.</summary>
    public RotationOrder? InputOrder { get; init; }

    /// <summary>Rotation order to write; null for that of the input.</summary>
    public RotationOrder? OutputOrder { get; init; }

    /// <summary>Frame rate of the output in frames per second; null for that of the input.</summary>
    public double? FrameRate { get; init; }

    /// <summary>Angle by which rotations of a GLB file may differ from the frames, in degrees; null for 0.</summary>
    public double? KeyError { get; init; }

    /// <summary>Axes of a table; null for Y up.</summary>
    public UpAxis? UpAxis { get; init; }

    /// <summary>Unit of the positions in a table; null for metres.</summary>
    public LengthUnit? Unit { get; init; }

    /// <summary>Frame rate of an input without times, raw bytes or a calculation export. Null for the rate that it states, or 120.</summary>
    public double? InputRate { get; init; }

    /// <summary>Start of the output in seconds since the start of the input; null for the start.</summary>
    public double? From { get; init; }

    /// <summary>End of the output in seconds since the start of the input; null for the end.</summary>
    public double? To { get; init; }

    /// <summary>Whether info prints JSON.</summary>
    public bool Json { get; init; }

    /// <summary>Whether info has already described another file.</summary>
    public bool FollowsAnother { get; init; }

    /// <summary>Options for reading a stream in the input.</summary>
    public PlaybackOptions Playback => new() { RotationOrder = InputOrder, FrameRate = InputRate };

    /// <summary>Options for reading a calculation export in the input.</summary>
    public CalculationReadOptions Calculation => new() { FrameRate = InputRate };

    /// <summary>Options for reading a calculation export, with progress and cancellation by Ctrl+C.</summary>
    public CalculationReadOptions ReadCalculation(IProgress<double> progress, CancellationToken cancellationToken) => new()
    {
        FrameRate = InputRate,
        Progress = new ReadProgress(new FileInfo(Input).Length, progress, cancellationToken),
    };

    // A conversion to angles also has an order to write.
    private string OrderHint => Output is { } path && FileKinds.OfName(path) is FileKind.Bvh or FileKind.Recording or FileKind.Raw ? " --output-order sets the order to write." : string.Empty;

    /// <summary>Whether a frame is of the avatar and of the sender, if they are set.</summary>
    public bool Selects(AvatarFrame frame) => Selects(frame.Sender, frame.AvatarIndex);

    /// <inheritdoc cref="Selects(AvatarFrame)"/>
    public bool Selects(int sender, int avatar) => sender == (Sender ?? sender) && avatar == (Avatar ?? avatar);

    /// <summary>
    /// Whether these settings or the metadata of a recording give the rotation order of a stream. Otherwise it is assumed, because packets of Axis Neuron do
    /// not contain it.
    /// </summary>
    /// <exception cref="IOException">The input cannot be read.</exception>
    public bool KnowsOrder() => InputOrder is not null || RecordedBody.ReadMetadata(Input)?.RotationOrder is not null;

    /// <summary>Determines the kind of the input.</summary>
    /// <exception cref="NeuronException">The input cannot be read, or not with these settings.</exception>
    /// <exception cref="IOException">The input does not exist or cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">The user does not have permission to read the input.</exception>
    public FileKind RecognizeInput()
    {
        FileKind kind = FileKinds.Recognize(Input);
        string name = Path.GetFileName(Input);
        if (InputRate is not null && kind is not (FileKind.Raw or FileKind.Calculation))
            throw new NeuronException($"--rate: {name} has its own times; --rate is for bytes without times and calculation exports.");
        if (kind is FileKind.Recording or FileKind.Raw)
            return kind;

        if (InputOrder is not null)
            throw new NeuronException($"--order: {name} does not need it; the option is for streams, which do not carry their order.{OrderHint}");
        if (Avatar is not null)
            throw new NeuronException($"--avatar: {name} holds one avatar; --avatar is for streams.");
        if (Sender is not null)
            throw new NeuronException($"--sender: {name} holds one avatar; --sender is for streams.");

        return kind;
    }
}
