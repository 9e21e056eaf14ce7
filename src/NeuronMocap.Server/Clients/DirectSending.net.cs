namespace NeuronMocap.Server.Clients;

/// <summary>Whether a socket can send without waiting, so that the thread that publishes frames may send.</summary>
internal static class DirectSending
{
    public static bool IsSupported => true;

    // A send takes about 12 µs on a connection within one machine, less to the network. This is a fifth of the thread's time.
    public const int MaxPerSecond = 16_000;
}
