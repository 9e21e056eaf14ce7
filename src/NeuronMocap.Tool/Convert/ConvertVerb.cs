using System.CommandLine;
using System.CommandLine.Parsing;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Convert;

/// <summary>neuron-mocap convert: converts a file, or a part of it, to another kind of file.</summary>
internal sealed class ConvertVerb : Verb
{
    private const double LowestRate = 0.01;
    private const double HighestRate = 10_000;
    private const string Kinds = ".bvh, .nmrec (recording), .calc (calculation export), .bin or .dat (the bytes of the stream), "
        + ".glb (glTF: a figure with its animation), .csv (table)";

    private readonly TakeArguments _take = new("OUT", $"The file to write. Its name says what it becomes: {Kinds}.");

    private readonly Option<double?> _resample = new("--resample")
    {
        HelpName = "HZ",
        Description = $"Frames per second to write, {LowestRate} to {HighestRate}; poses between two frames are interpolated. Default: the rate of IN.",
        CustomParser = static result => NumberArgument.Parse(result, LowestRate, HighestRate, "a number from 0.01 to 10000"),
        Arity = ArgumentArity.ExactlyOne,
    };

    private readonly Option<RotationOrder?> _outputOrder = CommonOptions.Order("--output-order", "Rotation order to write. Default: that of IN.");

    private readonly GlbArguments _glb = new();
    private readonly TableArguments _table = new();

    public ConvertVerb()
        : base("convert", "Write a file as another kind of file, or a part of it. A line on standard error says what the new file holds and what it lacks.")
    {
        foreach (Argument file in _take.Files)
            Add(file);

        AddOptions("Options", [.. _take.Options, _resample, _outputOrder, .. _glb.Options, .. _table.Options]);
        Validators.Add(Reject);
    }

    public override IReadOnlyList<HelpExample> Examples { get; } =
    [
        new("convert take.nmrec take.bvh", "a recording as BVH; a file of any kind as any other"),
        new("convert a.bvh b.bvh --from 2 --to 5", "a part of a take"),
        new("convert a.bvh b.bvh --resample 60 --output-order XYZ", "another frame rate and another rotation order"),
        new("convert take.nmrec take.glb --key-error 0.2", "all avatars with figures for Blender, Unreal, Unity or Godot, with fewer keys"),
        new("convert take.nmrec take.csv --up z", "positions and quaternions of all bones for pandas, R or a robot, in metres and Z up"),
        new("convert dump.bin take.bvh --rate 60", "the raw bytes of a stream, at 60 frames per second"),
    ];

    public override IReadOnlyList<(int Code, string Meaning)> ExitCodes => TakeArguments.Codes;

    public override Task<int> RunAsync(ParseResult result, StandardStreams streams, CancellationToken cancellationToken)
    {
        FileSettings settings = _take.Read(result) with
        {
            FrameRate = result.GetValue(_resample),
            OutputOrder = result.GetValue(_outputOrder),
            KeyError = _glb.ReadKeyError(result),
            UpAxis = _table.ReadUpAxis(result),
            Unit = _table.ReadUnit(result),
        };
        return new ConvertTool(settings, streams).RunAsync(cancellationToken);
    }

    private void Reject(CommandResult result)
    {
        _take.RejectContradictions(result);
        _glb.RejectForOthers(result, _take.FindOutput(result));
        if (_take.FindOutput(result) is { } output && FileKinds.OfName(output) is null)
            result.AddError($"the name '{output}' does not say what to write. Known are {Kinds}.");
        _table.RejectForOthers(result, _take.FindOutput(result));
    }
}
