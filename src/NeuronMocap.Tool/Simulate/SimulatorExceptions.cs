namespace NeuronMocap.Tool.Simulate;

/// <summary>The options contradict each other or ask for what there is not: exit code 2.</summary>
internal sealed class UsageException(string message) : Exception(message);

/// <summary>A file or a host that the options name cannot be had; the message begins with the option: exit code 1.</summary>
internal sealed class SimulatorException(string message) : Exception(message);
