using System.Net;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Server;

/// <summary>Settings of a <see cref="CommandRelay"/>.</summary>
/// <remarks>The relay copies the settings when it is created. Later changes have no effect.</remarks>
public sealed class CommandRelayOptions
{
    /// <summary>Name or address of the computer whose command channel is passed on. It must be set.</summary>
    public string Host { get; set; } = string.Empty;

    /// <summary>Port of that command channel, 1 to 65535. Default: 8013.</summary>
    public int HostPort { get; set; } = ProtocolConstants.DefaultCommandPort;

    /// <summary>TCP port to listen on, 0 to 65535. Default: 8013.</summary>
    /// <remarks>0 takes any free port. Read it from <see cref="CommandRelay.LocalEndPoint"/>.</remarks>
    public int Port { get; set; } = ProtocolConstants.DefaultCommandPort;

    /// <summary>Address to listen on, one of this computer's. <see cref="IPAddress.Any"/> listens on all addresses. Default: loopback.</summary>
    /// <remarks>The default is loopback because every client that connects can zero out the avatars.</remarks>
    public IPAddress BindAddress { get; set; } = IPAddress.Loopback;

    /// <summary>Maximum number of simultaneous clients, 1 to 1024. Default: 32.</summary>
    /// <remarks>
    /// When the relay is full, a new client replaces the client whose connection has passed no bytes for the longest time. Clients that never sent any are
    /// replaced first. A client cannot be replaced for 2 seconds after it connected and after its last bytes. If no client can be replaced, the new
    /// connection is closed.
    /// </remarks>
    public int MaxClients { get; set; } = 32;

    /// <summary>
    /// How long a connection may pass no bytes before it is closed: 1 second to 1 day, or <see cref="Timeout.InfiniteTimeSpan"/>. Default: 1 hour.
    /// </summary>
    /// <remarks>Bytes in both directions count. The default is long because clients connect when they start and may send one request in a session.</remarks>
    public TimeSpan IdleTimeout { get; set; } = TimeSpan.FromHours(1);

    /// <summary>How long a connection to the server may take to be established, 0.1 seconds to 10 minutes. Default: 5 seconds.</summary>
    public TimeSpan ConnectTimeout { get; set; } = TimeSpan.FromSeconds(5);

    internal CommandRelayOptions CopyChecked()
    {
        Require(!string.IsNullOrWhiteSpace(Host), nameof(Host), "must be the name or the address of a server", Host);
        Require(!AddressText.HasPort(Host), nameof(Host), "must be a name or an address alone, and HostPort its port", Host);
        Require(HostPort is >= 1 and <= IPEndPoint.MaxPort, nameof(HostPort), "must be 1 to 65535", HostPort);
        Require(Port is >= 0 and <= IPEndPoint.MaxPort, nameof(Port), "must be 0 to 65535", Port);
        Require(BindAddress is not null, nameof(BindAddress), "must be an address", BindAddress);
        Require(MaxClients is >= 1 and <= 1024, nameof(MaxClients), "must be 1 to 1024", MaxClients);
        Require(
            ConnectTimeout >= TimeSpan.FromSeconds(0.1) && ConnectTimeout <= TimeSpan.FromMinutes(10),
            nameof(ConnectTimeout),
            "must be 0.1 seconds to 10 minutes",
            ConnectTimeout);
        Require(
            IdleTimeout == Timeout.InfiniteTimeSpan || (IdleTimeout >= TimeSpan.FromSeconds(1) && IdleTimeout <= TimeSpan.FromDays(1)),
            nameof(IdleTimeout),
            "must be 1 second to 1 day, or infinite",
            IdleTimeout);
        return (CommandRelayOptions)MemberwiseClone();
    }

    private static void Require(bool condition, string setting, string requirement, object? value)
    {
        if (!condition)
            throw new ArgumentException($"{nameof(CommandRelayOptions)}.{setting} is {value ?? "null"}; it {requirement}.", setting);
    }
}
