namespace NeuronMocap.Simulator;

/// <summary>The options contradict each other or ask for what there is not: exit code 2.</summary>
internal sealed class UsageException(string message) : Exception(message);
