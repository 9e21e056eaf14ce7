using System.Net;
using NeuronMocap.Protocol;
using NeuronMocap.Server.Faults;

namespace NeuronMocap.Server;

/// <summary>Settings of a <see cref="CommandServer"/>.</summary>
/// <remarks>The server copies the settings when it is created. Later changes have no effect.</remarks>
public sealed class CommandServerOptions
{
    /// <summary>TCP port to listen on, 0 to 65535. Default: 8013.</summary>
    /// <remarks>0 takes any free port. Read it from <see cref="CommandServer.LocalEndPoint"/>.</remarks>
    public int Port { get; set; } = ProtocolConstants.DefaultCommandPort;

    /// <summary>Address to listen on, one of this computer's. <see cref="IPAddress.Any"/> listens on all addresses. Default: loopback.</summary>
    /// <remarks>The default is loopback because every client that connects can zero out the avatars.</remarks>
    public IPAddress BindAddress { get; set; } = IPAddress.Loopback;

    /// <summary>Maximum number of simultaneous clients, 1 to 1024. Default: 32.</summary>
    /// <remarks>
    /// When the server is full, a new client replaces the client that has sent no request for the longest time. Clients that never sent a request are
    /// replaced first. A client cannot be replaced for 2 seconds after it connected and after each answer. If no client can be replaced, the new
    /// connection is closed.
    /// </remarks>
    public int MaxClients { get; set; } = 32;

    /// <summary>
    /// How long a client may stay connected without sending a request: 1 second to 1 day, or <see cref="Timeout.InfiniteTimeSpan"/>. Default: 1 hour.
    /// </summary>
    /// <remarks>
    /// Bytes that are not a whole request do not count. The default is long because clients connect when they start and may send one request in a
    /// session.
    /// </remarks>
    public TimeSpan IdleTimeout { get; set; } = TimeSpan.FromHours(1);

    // Deviations from the protocol, to test clients. Default: none.
    internal CommandReplyQuirks Quirks { get; set; } = new();

    internal CommandServerOptions CopyChecked()
    {
        var copy = (CommandServerOptions)MemberwiseClone();
        Require(Port is >= 0 and <= IPEndPoint.MaxPort, nameof(Port), "must be 0 to 65535", Port);
        Require(BindAddress is not null, nameof(BindAddress), "must be an address", BindAddress);
        Require(MaxClients is >= 1 and <= 1024, nameof(MaxClients), "must be 1 to 1024", MaxClients);
        Require(
            IdleTimeout == Timeout.InfiniteTimeSpan || (IdleTimeout >= TimeSpan.FromSeconds(1) && IdleTimeout <= TimeSpan.FromDays(1)),
            nameof(IdleTimeout),
            "must be 1 second to 1 day, or infinite",
            IdleTimeout);
        Require(Quirks is not null, nameof(Quirks), "must not be null", Quirks);
        copy.Quirks = Quirks!.Copy();
        CommandReplyQuirks quirks = copy.Quirks;
        Require(quirks.ReplyId is null or (>= 0 and <= ushort.MaxValue), "Quirks.ReplyId", "must be 0 to 65535", quirks.ReplyId);
        Require(quirks.PayloadSize is null or (>= 0 and <= 1_048_576), "Quirks.PayloadSize", "must be 0 to 1,048,576", quirks.PayloadSize);
        Require(quirks.Answers is >= 0 and <= 16, "Quirks.Answers", "must be 0 to 16", quirks.Answers);
        Require(quirks.Fragment is null or >= 1, "Quirks.Fragment", "must be at least 1", quirks.Fragment);
        Require(quirks.Delay >= TimeSpan.Zero && quirks.Delay <= TimeSpan.FromMinutes(5), "Quirks.Delay", "must be 0 to 5 minutes", quirks.Delay);
        return copy;
    }

    private static void Require(bool condition, string setting, string requirement, object? value)
    {
        if (!condition)
            throw new ArgumentException($"{nameof(CommandServerOptions)}.{setting} is {value ?? "null"}; it {requirement}.", setting);
    }
}
