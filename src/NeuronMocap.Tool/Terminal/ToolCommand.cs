namespace NeuronMocap.Tool.Terminal;

/// <summary>The name of the program, and its exit codes.</summary>
internal static class ToolCommand
{
    public const string Name = "neuron-mocap";

    public const int Done = 0;
    public const int NothingReceived = 1;
    public const int BadUsage = 2;
    public const int Interrupted = 130;
}
