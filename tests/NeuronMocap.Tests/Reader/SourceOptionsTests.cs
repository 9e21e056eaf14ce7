using System.Net;
using NeuronMocap.Commands;
using NeuronMocap.Recording;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Playback;

namespace NeuronMocap.Tests.Reader;

// What the options mean for a reader without a connection. Those of a connection mean nothing, except for the command channel of a source.
public sealed class SourceOptionsTests
{
    public static TheoryData<NeuronReaderOptions> WithoutEffect =>
    [
        new NeuronReaderOptions { Port = 0 },
        new NeuronReaderOptions { Host = " " },
        new NeuronReaderOptions { Transport = (TransportKind)7 },
        new NeuronReaderOptions { ConnectTimeout = Timeout.InfiniteTimeSpan },
        new NeuronReaderOptions { AllowedSenders = [null!] },
        new NeuronReaderOptions { Tls = new NeuronTlsOptions { TargetHost = " " } },
        new NeuronReaderOptions { CalculationPort = -1 },
        new NeuronReaderOptions { CalculationPort = 8013, CommandPort = 8013 },
        new NeuronReaderOptions { Port = 7001, CommandPort = 7001 },
    ];

    public static TheoryData<string, NeuronReaderOptions> WithEffect => new()
    {
        { "CommandPort is 0;", new NeuronReaderOptions { CommandPort = 0 } },
        { "Host is empty;", new NeuronReaderOptions { CommandPort = 8013, Host = " " } },
        { "Host is [::1]:7001; it must be a name or address alone. Set Port,", new NeuronReaderOptions { CommandPort = 8013, Host = "[::1]:7001" } },
        { "Host is [::1]7001; it must be a name or address alone. Set Port,", new NeuronReaderOptions { CommandPort = 8013, Host = "[::1]7001" } },
        { "Host is 10.0.0.5:7001; it must be a name or address alone. Set Port,", new NeuronReaderOptions { CommandPort = 8013, Host = "10.0.0.5:7001" } },
        { "Host is tcp://neuron;", new NeuronReaderOptions { CommandPort = 8013, Host = "tcp://neuron" } },
        { "ConnectTimeout is ", new NeuronReaderOptions { CommandPort = 8013, ConnectTimeout = Timeout.InfiniteTimeSpan } },
        { "MaxValues is 0;", new NeuronReaderOptions { MaxValues = 0 } },
        { "Reconnect is null;", new NeuronReaderOptions { Reconnect = null! } },
    };

    [Theory]
    [MemberData(nameof(WithoutEffect), DisableDiscoveryEnumeration = true)]
    public async Task An_option_without_effect_is_not_checked(NeuronReaderOptions options)
    {
        using (TemporaryFile file = Recordings.OfTcp((0, TestPackets.Motion(1))))
        using (RecordingPlayer player = RecordingPlayer.Open(file.Path))
        await using (var played = new NeuronReader(player, options))
        {
            played.Start();
            await played.Completion.Soon();
            Assert.Equal(1, played.GetStatistics().MotionFrames);
        }

        options.Source = new ListedSource(static () => new FedStream().Feed(TestPackets.Motion(1)));
        await using var reader = new NeuronReader(options);
        reader.Start();
        await reader.WaitForFramesAsync(1);
    }

    [Theory]
    [MemberData(nameof(WithEffect), DisableDiscoveryEnumeration = true)]
    public void An_option_with_an_effect_is_checked(string fault, NeuronReaderOptions options)
    {
        options.Source = new ListedSource(static () => new FedStream());
        AssertRefused(options, fault);
    }

    [Theory]
    [InlineData(TransportKind.Tcp)]
    [InlineData(TransportKind.Udp)]
    public void The_command_channel_uses_its_own_options(TransportKind transport)
    {
        NeuronCommandOptions commands = new NeuronReaderOptions
        {
            Source = new ListedSource(static () => new FedStream()),
            Transport = transport,
            Host = "studio",
            CommandPort = 8013,
            LocalAddress = IPAddress.Loopback,
            ConnectTimeout = TimeSpan.FromSeconds(7),
        }.Copy().Commands!;
        Assert.Equal(("studio", 8013, TimeSpan.FromSeconds(7)), (commands.Host, commands.Port, commands.ConnectTimeout));

        // As without a source, the address of the network from which datagrams come is not that of the host.
        Assert.Equal(transport == TransportKind.Udp ? null : IPAddress.Loopback, commands.LocalAddress);
    }

    [Theory]
    [InlineData(null)]
    [InlineData("")]
    [InlineData(" ")]
    public void A_source_needs_a_name(string? name) =>
        AssertRefused(new NeuronReaderOptions { Name = "reader", Source = new NamedSource(() => name!) }, "The Name of Source is empty;");

    [Fact]
    public void An_exception_of_the_name_goes_to_the_caller()
    {
        var options = new NeuronReaderOptions { Source = new NamedSource(static () => throw new NotSupportedException("No name.")) };
        Assert.Throws<NotSupportedException>(() => new NeuronReader(options));
        Assert.Throws<NotSupportedException>(() => { _ = NeuronDiagnostics.DiagnoseAsync(options); });
    }

    [Fact]
    public async Task The_name_is_read_once()
    {
        int reads = 0;
        await using var reader = new NeuronReader(SourceReaderTests.Options(source: new NamedSource(() => FormattableString.Invariant($"name {++reads}"))));
        var log = new StatusLog(reader);
        reader.Start();
        ConnectionStatus status = await log.WaitAsync(ConnectionState.Waiting);
        Assert.Equal(("name 1", "Receiving from name 1 has ended: there are no more bytes."), (reader.Name, status.Message));
        Assert.Equal(1, reads);
    }

    private static void AssertRefused(NeuronReaderOptions options, string fault)
    {
        Assert.StartsWith(fault, Assert.Throws<ArgumentException>(nameof(options), () => new NeuronReader(options)).Message, StringComparison.Ordinal);
        Assert.StartsWith(fault, Assert.Throws<ArgumentException>(nameof(options), () => { _ = NeuronDiagnostics.DiagnoseAsync(options); }).Message, StringComparison.Ordinal);
    }

    private sealed class NamedSource(Func<string> name) : ByteSource
    {
        public override string Name => name();

        public override ValueTask<Stream> OpenAsync(CancellationToken cancellationToken) => new(new FedStream().End());
    }
}
