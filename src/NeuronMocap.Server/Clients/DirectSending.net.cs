namespace NeuronMocap.Server.Clients;

/// <summary>Whether a socket can send without waiting, so that the thread that receives for a relay may send.</summary>
internal static class DirectSending
{
    public static bool IsSupported => true;
}
