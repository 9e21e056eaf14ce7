using System.CommandLine;
using System.CommandLine.Parsing;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.Watch.Recordings;

/// <summary>The options of a recording.</summary>
internal sealed class RecordingArguments
{
    private const long BytesPerMegabyte = 1_000_000;
    private const int SmallestFile = 2;
    private const int LargestFile = 1_000_000;
    private const int LongestFile = 1_000_000;

    private readonly Option<string?> _record = new("--record")
    {
        HelpName = "FILE",
        Description = "Record every byte that arrives, with its time, to this file, usually named .nmrec, while the stream is shown. The file can be read "
            + "however this program ends.",
        Arity = ArgumentArity.ExactlyOne,
    };

    private readonly Option<bool> _compress = new("--record-compress") { Description = "With --record: compress the file." };

    private readonly Option<int?> _size = new("--record-size")
    {
        HelpName = "MB",
        Description = $"With --record: start a new file before one exceeds this many megabytes, {SmallestFile} to {LargestFile}. The files have numbers: "
            + "take.0001.nmrec and so on.",
        CustomParser = result => Parse(result, SmallestFile, LargestFile, "megabytes"),
        Arity = ArgumentArity.ExactlyOne,
    };

    private readonly Option<int?> _time = new("--record-time")
    {
        HelpName = "SECONDS",
        Description = $"With --record: start a new file after this many seconds, 1 to {LongestFile}.",
        CustomParser = result => Parse(result, 1, LongestFile, "seconds"),
        Arity = ArgumentArity.ExactlyOne,
    };

    private readonly Option<int?> _files = new("--record-files")
    {
        HelpName = "N",
        Description = "With --record-size or --record-time: keep the last N files and delete older ones of this recording.",
        CustomParser = result => Parse(result, 1, int.MaxValue, "files"),
        Arity = ArgumentArity.ExactlyOne,
    };

    /// <summary>The option that names the file.</summary>
    public Option File => _record;

    public Option[] All => [_record, _compress, _size, _time, _files];

    /// <summary>Adds an error for every option that needs another option.</summary>
    public void RejectContradictions(CommandResult result)
    {
        if (!Verb.IsGiven(result, _record))
        {
            foreach (Option option in ((Option[])[_compress, _size, _time, _files]).Where(option => Verb.IsGiven(result, option)))
                result.AddError($"{option.Name} needs --record: it says how to record.");

            return;
        }

        FileNames.Reject(result, _record, "a recording", ".nmrec");
        if (Verb.IsGiven(result, _files) && !Verb.IsGiven(result, _size) && !Verb.IsGiven(result, _time))
            result.AddError("--record-files needs --record-size or --record-time: without them there is only one file.");
    }

    public RecordingSettings? Read(ParseResult result, bool overwrite)
    {
        if (result.GetValue(_record) is not { } path)
            return null;

        return new RecordingSettings(path, new RecordingOptions
        {
            Overwrite = overwrite,
            Compress = result.GetValue(_compress),
            MaxFileSize = result.GetValue(_size) * BytesPerMegabyte,
            MaxFileDuration = result.GetValue(_time) is { } seconds ? TimeSpan.FromSeconds(seconds) : null,
            MaxFiles = result.GetValue(_files),
        });
    }

    private static int? Parse(ArgumentResult result, int least, int most, string unit) =>
        NumberArgument.ParseWhole(result, least, most, $"a whole number of {unit} from {least} to {most}");
}
