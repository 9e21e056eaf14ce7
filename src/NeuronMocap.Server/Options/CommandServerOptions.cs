using System.Net;
using NeuronMocap.Protocol;
using NeuronMocap.Server.Faults;

namespace NeuronMocap.Server;

/// <summary>Where a <see cref="CommandServer"/> listens, and how it answers. The server copies them when it is made; changes after that have no effect.</summary>
public sealed class CommandServerOptions
{
    /// <summary>
    /// TCP port to listen on, 0 to 65535; 0 takes any free one, which <see cref="CommandServer.LocalEndPoint"/> tells. Default: 8013.
    /// </summary>
    public int Port { get; set; } = ProtocolConstants.DefaultCommandPort;

    /// <summary>
    /// Address to listen on, one of this machine. Default: loopback, because whoever can connect can turn the actors;
    /// <see cref="IPAddress.Any"/> listens on all.
    /// </summary>
    public IPAddress BindAddress { get; set; } = IPAddress.Loopback;

    /// <summary>
    /// Largest number of clients at a time, 1 to 1024. One more takes the place of the client that has asked nothing for the longest time; those that never
    /// asked go first. A client keeps its place for 2 seconds after it connected and after each answer: where all have, the new one is closed. Default: 32.
    /// </summary>
    public int MaxClients { get; set; } = 32;

    /// <summary>
    /// How long a client may stay without asking anything before its connection is closed: 1 second to 1 day, or <see cref="Timeout.InfiniteTimeSpan"/>
    /// for ever. Bytes that are no whole request do not count. Default: 1 hour, because clients connect when they start and may ask once in a session.
    /// </summary>
    public TimeSpan IdleTimeout { get; set; } = TimeSpan.FromHours(1);

    // What the server does otherwise than it should, to test clients. Default: nothing.
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
            throw new ArgumentException($"{nameof(CommandServerOptions)}.{setting} {requirement}; it is {value}.", setting);
    }
}
