using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Arguments;

/// <summary>The help of the program, apart from its verbs.</summary>
internal static class ProgramHelp
{
    public const string Description =
        "Motion of Perception Neuron suits, from Axis Neuron, Axis Studio or a simulator: watch it, record it, simulate it, convert it, and find out why none "
        + "arrives.";

    public static IReadOnlyList<HelpExample> Examples { get; } =
    [
        new(string.Empty, "a moving skeleton, without suit or server"),
        new("watch 192.168.1.20", "Axis Neuron on another computer, TCP port 7001"),
        new("diagnose 192.168.1.20", "no data? Finds what is wrong and which setting to change"),
        new("simulate --avatars 2", "serve programs on this computer"),
        new("convert take.nmrec take.bvh", "a recording as BVH"),
    ];

    public static IReadOnlyList<(int Code, string Meaning)> ExitCodes { get; } =
    [
        (ToolCommand.Done, "success"),
        (ToolCommand.NothingReceived, "nothing was received, or something could not be read or written; standard error says what to check"),
        (ToolCommand.BadUsage, "wrong command line"),
        (ToolCommand.Interrupted, "ended by Ctrl+C or SIGTERM before a result"),
    ];
}
