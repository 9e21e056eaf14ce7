namespace NeuronMocap.Server.Clients;

/// <summary>Whether a socket can send without waiting, so that the thread that publishes frames may send.</summary>
internal static class DirectSending
{
    // On Mono, a non-blocking socket that is full tries again and again inside Send, until everything is sent.
    public static bool IsSupported => false;

    public const int MaxPerSecond = 0;
}
