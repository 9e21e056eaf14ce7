using System.Net;
using NeuronMocap.Transport;

namespace NeuronMocap.Server.Osc;

/// <summary>What the options of all senders have in common, checked.</summary>
internal sealed record OscSettings(string Host, int Port, double MaxRate, float Scale, int MaxDatagramSize)
{
    // The longest message, of the longest prefix and name, fits into 512 bytes. IPv4 has no longer datagrams than 65,507.
    private const int LeastDatagram = 512;
    private const int LargestDatagram = 65_507;

    /// <summary>Checks the settings.</summary>
    /// <param name="options">Name of the class of the options, for messages.</param>
    /// <exception cref="ArgumentException">A setting is out of range, and the message names it.</exception>
    public OscSettings Checked(string options)
    {
        Require(options, !string.IsNullOrWhiteSpace(Host), nameof(Host), "must be a name or an address", Host);
        Require(options, !AddressText.HasPort(Host), nameof(Host), "must be a name or an address alone, and Port its port", Host);
        Require(options, Port is >= 1 and <= IPEndPoint.MaxPort, nameof(Port), "must be 1 to 65535", Port);
        Require(options, MaxRate is 0 or (>= 0.01 and <= 1000), nameof(MaxRate), "must be 0, or 0.01 to 1000", MaxRate);
        Require(options, Scale is > 0 and <= 1_000_000, nameof(Scale), "must be more than 0 and at most 1,000,000", Scale);
        Require(options, MaxDatagramSize is >= LeastDatagram and <= LargestDatagram, nameof(MaxDatagramSize), "must be 512 to 65,507 bytes", MaxDatagramSize);
        return this;
    }

    public static void Require(string options, bool condition, string setting, string requirement, object? value)
    {
        if (!condition)
            throw new ArgumentException(FormattableString.Invariant($"{options}.{setting} is {value ?? "null"}; it {requirement}."), setting);
    }
}
