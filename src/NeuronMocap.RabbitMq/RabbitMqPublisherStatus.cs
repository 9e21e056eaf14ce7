namespace NeuronMocap.RabbitMq;

/// <summary>Whether a publisher reaches its broker.</summary>
/// <param name="IsConnected">Whether frames go to the broker.</param>
/// <param name="Message">What happens, for people, in one sentence. It contains no password.</param>
public sealed record RabbitMqPublisherStatus(bool IsConnected, string Message);
