using System.Text.Json;
using System.Xml;
using NeuronMocap.Bvh;
using NeuronMocap.Calculation;
using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Fuzz.Targets;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Convert;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Info;
using NeuronMocap.Tool.Plot;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Fuzz.Tools;

/// <summary>The verbs that read files.</summary>
internal enum FileVerb
{
    Info,
    Convert,
    Plot,
}

/// <summary>
/// The input as a file that the monitor's file tools read. Their output can be read and has bounded length. Their messages can be shown on any
/// terminal. A rejection is one sentence, and no files are left over.
/// </summary>
internal sealed class FileToolTarget(FileVerb verb)
{
    private static readonly string[] Kinds = [".bvh", ".nmrec", ".calc", ".bin"];
    private static readonly double?[] Times = [null, null, null, 0, 0.01, 0.5, 1e9];
    private static readonly double?[] Rates = [null, null, null, 30, 59.94, 1000];

    private readonly ToolFolder _folder = new();
    private readonly byte[] _file = new byte[FuzzInput.MaxLength];
    private readonly CancellationTokenSource _stop = new();

    public long CountOutput() => _folder.CountOutput();

    public void Stop() => _stop.Cancel();

    public void Run(FuzzInput input)
    {
        Span<byte> file = _file.AsSpan(0, input.Bytes.Length);
        input.Bytes.CopyTo(file);
        if (RecordingReader.IsRecording(file) && input.Random.Below(8) > 0)
            RecordingChecksums.Mend(file);

        using (FileStream target = File.Create(_folder.Input))
            target.Write(file);

        // A file has a time of writing, which a conversion keeps.
        File.SetLastWriteTimeUtc(_folder.Input, DateTime.UnixEpoch.AddYears(50));
        FileSettings settings = Choose(ref input.Random);
        int others = -1;
        try
        {
            input.Found += Run(settings, input) ? 1 : 0;
        }
        finally
        {
            others = _folder.CleanUp(settings.Output);
        }

        WrongResultException.ThrowUnless(others == 0, "{0} files are left over.", others);
    }

    private FileSettings Choose(ref FuzzRandom random)
    {
        string? output = verb switch
        {
            FileVerb.Info => null,
            FileVerb.Plot => _folder.OutputPath(".svg"),
            _ => _folder.OutputPath(random.Choose(Kinds)),
        };
        var settings = new FileSettings(_folder.Input, output) { Overwrite = true, Json = verb == FileVerb.Info && random.Below(2) == 0 };
        if (verb == FileVerb.Info)
            return settings;

        double? from = random.Choose(Times);
        double? to = random.Choose(Times);
        settings = settings with { From = from, To = to is null || to > (from ?? 0) ? to : null };
        return verb == FileVerb.Plot ? settings : settings with
        {
            FrameRate = random.Choose(Rates),
            OutputOrder = random.Below(4) == 0 ? random.Choose(Enum.GetValues<RotationOrder>()) : null,
        };
    }

    // Returns whether the tool succeeded. If not, it reports the reason in one line.
    private bool Run(FileSettings settings, FuzzInput input)
    {
        using var output = new MemoryStream();
        using var error = new StringWriter();
        using var streams = new StandardStreams(output, error, IsTerminal: input.Random.Below(2) == 0) { Columns = 80 };
        Task<int> run = verb switch
        {
            FileVerb.Info => new InfoTool(settings, streams).RunAsync(_stop.Token),
            FileVerb.Plot => new PlotTool(settings, streams).RunAsync(_stop.Token),
            _ => new ConvertTool(settings, streams).RunAsync(_stop.Token),
        };
        int code = run.GetAwaiter().GetResult();
        input.Digest.Add((long)code);
        if (code != 0)
        {
            CheckRefusal(error.ToString());
            return false;
        }

        if (settings.Output is not { } path)
            CheckPage(output.GetBuffer().AsSpan(0, (int)output.Length), settings.Json, streams.IsTerminal);
        else if (verb == FileVerb.Plot)
            CheckDrawing(path);
        else
            CheckFile(path);

        input.Digest.Add(settings.Output is { } written ? new FileInfo(written).Length : output.Length);
        return true;
    }

    private static void CheckRefusal(string error)
    {
        WrongResultException.ThrowUnless(error.StartsWith("neuron-mocap: ", StringComparison.Ordinal) && error.Length < 2_000, "A refusal says: {0}", error);
        foreach (char letter in error.AsSpan().TrimEnd("\r\n"))
            WrongResultException.ThrowUnless(!char.IsControl(letter), "A refusal has the character U+{0:X4}.", (int)letter);
    }

    private static void CheckPage(ReadOnlySpan<byte> page, bool isJson, bool isTerminal)
    {
        WrongResultException.ThrowUnless(page.Length is > 0 and < 4 * 1024 * 1024, "{0} bytes are said.", page.Length);
        if (isJson)
        {
            var reader = new Utf8JsonReader(page);
            while (reader.Read())
            {
                // The page is valid JSON to its end.
            }

            return;
        }

        // On a terminal, the program itself writes colours.
        foreach (char letter in System.Text.Encoding.UTF8.GetString(page))
            WrongResultException.ThrowUnless(isTerminal || letter == '\n' || !char.IsControl(letter), "The character U+{0:X4} reaches the output.", (int)letter);
    }

    private static void CheckDrawing(string path)
    {
        using var reader = XmlReader.Create(path);
        while (reader.Read())
        {
            // The page is valid XML to its end.
        }
    }

    private static void CheckFile(string path)
    {
        switch (Path.GetExtension(path))
        {
            case ".bvh":
                _ = BvhDocument.Load(path);
                break;
            case ".calc":
                _ = CalculationDocument.Load(path);
                break;
            case ".nmrec":
                using (RecordingReader reader = RecordingReader.Open(path))
                    WrongResultException.ThrowUnless(reader.IsComplete && reader.Problems.Count == 0, "The recording that was written is not whole.");

                break;
            default:
                WrongResultException.ThrowUnless(new FileInfo(path).Length > 0, "An empty file is written.");
                break;
        }
    }
}
