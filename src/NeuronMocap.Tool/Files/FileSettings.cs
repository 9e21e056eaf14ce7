using NeuronMocap.Calculation;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Files;

/// <summary>What to do with a file.</summary>
internal enum FileTask
{
    /// <summary>Say what it holds.</summary>
    Info,

    /// <summary>Write it as another kind of file.</summary>
    Convert,

    /// <summary>Draw it.</summary>
    Plot,
}

/// <summary>What the command line asks of the tools for files.</summary>
/// <param name="Task">What to do.</param>
/// <param name="Input">The file to read.</param>
/// <param name="Output">The file to write; null for <see cref="FileTask.Info"/>.</param>
internal sealed record FileSettings(FileTask Task, string Input, string? Output)
{
    /// <summary>Whether an output that is there already may be replaced.</summary>
    public bool Overwrite { get; init; }

    /// <summary>Which avatar of a recording; null for the first.</summary>
    public int? Avatar { get; init; }

    /// <summary>Of convert the order of the output; null for the input's. Otherwise that of the stream in the input, see <see cref="InputOrder"/>.</summary>
    public RotationOrder? RotationOrder { get; init; }

    /// <summary>Of convert the order of the stream in the input, whose values do not say it; null for what the file says, or YXZ.</summary>
    public RotationOrder? InputOrder { get; init; }

    /// <summary>Frames per second of the output; null for the input's.</summary>
    public double? FrameRate { get; init; }

    /// <summary>Frames per second of an input without times, raw bytes or a calculation export; null for what it says, or 120.</summary>
    public double? InputRate { get; init; }

    /// <summary>Seconds since the beginning of the input where the output begins; null for the beginning.</summary>
    public double? From { get; init; }

    /// <summary>Seconds since the beginning of the input where the output ends; null for the end.</summary>
    public double? To { get; init; }

    /// <summary>Whether info is for a program.</summary>
    public bool Json { get; init; }

    /// <summary>Whether info has told of another file before.</summary>
    public bool FollowsAnother { get; init; }

    /// <summary>How a stream in the input is to be read.</summary>
    public PlaybackOptions Playback => new() { RotationOrder = Task == FileTask.Convert ? InputOrder : RotationOrder, FrameRate = InputRate };

    /// <summary>How a calculation export in the input is to be read.</summary>
    public CalculationReadOptions Calculation => new() { FrameRate = InputRate };

    /// <summary>The same with progress, and so that Ctrl+C ends it.</summary>
    public CalculationReadOptions ReadCalculation(IProgress<double> progress, CancellationToken cancellationToken) => new()
    {
        FrameRate = InputRate,
        Progress = new ReadProgress(new FileInfo(Input).Length, progress, cancellationToken),
    };

    /// <summary>Looks into the input.</summary>
    /// <exception cref="NeuronException">It cannot be read, or not with these settings.</exception>
    /// <exception cref="IOException">It is not there, or cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">It may not be read.</exception>
    public FileKind RecognizeInput()
    {
        FileKind kind = FileKinds.Recognize(Input);
        string name = Path.GetFileName(Input);
        if (InputRate is not null && kind is not (FileKind.Raw or FileKind.Calculation))
            throw new NeuronException($"--rate: {name} has times of its own; --rate is for bytes without times and calculation exports.");
        if (kind is FileKind.Recording or FileKind.Raw)
            return kind;

        if (InputOrder is not null || (Task != FileTask.Convert && RotationOrder is not null))
            throw new NeuronException($"{(InputOrder is null ? "--order" : "--input-order")}: {name} needs none; the option is for streams, which do not carry their order.");
        if (Avatar is not null)
            throw new NeuronException($"--avatar: {name} holds one avatar; --avatar is for streams.");

        return kind;
    }
}
