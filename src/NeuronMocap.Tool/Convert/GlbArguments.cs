using System.CommandLine;
using System.CommandLine.Parsing;
using NeuronMocap.Gltf;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Files;

namespace NeuronMocap.Tool.Convert;

/// <summary>The option of convert for a GLB file.</summary>
internal sealed class GlbArguments
{
    private readonly Option<double?> _keyError = new("--key-error")
    {
        HelpName = "DEGREES",
        Description = "For .glb: leave out keys that interpolation restores within this angle, and the place of the hips within as many millimetres, 0 to 45. Default: 0, a key for each frame.",
        CustomParser = static result => NumberArgument.Parse(result, 0, GlbOptions.MaxRotationTolerance, "a number of degrees, 0 to 45"),
        Arity = ArgumentArity.ExactlyOne,
    };

    public Option[] Options => [_keyError];

    public double? ReadKeyError(ParseResult result) => result.GetValue(_keyError);

    /// <summary>Adds an error if another kind of file is written.</summary>
    public void RejectForOthers(CommandResult result, string? output)
    {
        if (output is not null && FileKinds.OfName(output) is not (null or FileKind.Glb) && result.GetResult(_keyError) is not null)
            result.AddError("--key-error is for .glb files.");
    }
}
