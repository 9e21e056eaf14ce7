namespace NeuronMocap.Tool.Simulate;

/// <summary>The exception for options that contradict each other or name something that does not exist: exit code 2.</summary>
internal sealed class UsageException(string message) : Exception(message);

/// <summary>The exception for a file, host or port that is not available: exit code 1. The message starts with the option.</summary>
internal sealed class SimulatorException(string message) : Exception(message);
