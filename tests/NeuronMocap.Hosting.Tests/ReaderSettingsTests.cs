using System.Net;
using Microsoft.Extensions.Configuration;
using Microsoft.Extensions.Options;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Hosting.Tests;

public sealed class ReaderSettingsTests
{
    [Fact]
    public void Every_setting_is_read()
    {
        NeuronReaderOptions options = Read(
            ("Name", "stage"), ("Transport", "udp"), ("Host", "studio"), ("Port", "7012"), ("LocalAddress", "::1"), ("SharePort", "true"),
            ("ConnectTimeout", "00:00:02"), ("SilenceTimeout", "1.5"), ("Reconnect:Enabled", "False"), ("Reconnect:InitialDelay", "0.25"),
            ("Reconnect:MaxDelay", "10"), ("RotationOrder", "XYZ"), ("SkeletonVariant", "Spine3"), ("MaxValues", "500"), ("CommandPort", "8013"),
            ("CalculationPort", "7003"), ("ReceiveThread", "dedicated"),
            ("AllowedSenders", "192.168.1.20, ::1"));

        Assert.Equal(
            ("stage", TransportKind.Udp, "studio", 7012, IPAddress.IPv6Loopback, true),
            (options.Name, options.Transport, options.Host, options.Port, options.LocalAddress, options.SharePort));
        Assert.Equal([IPAddress.Parse("192.168.1.20"), IPAddress.IPv6Loopback], options.AllowedSenders);
        Assert.Equal(ReceiveThread.Dedicated, options.ReceiveThread);
        Assert.Equal((2, 1.5), (options.ConnectTimeout.TotalSeconds, options.SilenceTimeout.TotalSeconds));
        Assert.Equal(
            (false, 0.25, 10),
            (options.Reconnect.Enabled, options.Reconnect.InitialDelay.TotalSeconds, options.Reconnect.MaxDelay.TotalSeconds));
        Assert.Equal(
            (RotationOrder.XYZ, SkeletonVariant.Spine3, 500, 8013),
            (options.RotationOrder, options.SkeletonVariant, options.MaxValues, options.CommandPort));
        Assert.Equal(7003, options.CalculationPort);
    }

    [Fact]
    public void TLS_is_read_and_can_be_turned_off()
    {
        Assert.NotNull(Read(("Tls:Enabled", "true")).Tls);
        Assert.Equal("stage", Read(("Tls:TargetHost", "stage")).Tls?.TargetHost);
        Assert.Null(Read(("Tls:Enabled", "false"), ("Tls:TargetHost", "stage")).Tls);
    }

    [Fact]
    public void Every_option_has_a_setting()
    {
        // A source is an object, which only code can create.
        IEnumerable<string> expected = typeof(NeuronReaderOptions).GetProperties()
            .Where(property => property.Name is not (nameof(NeuronReaderOptions.LoggerFactory) or nameof(NeuronReaderOptions.Reconnect) or nameof(NeuronReaderOptions.Source) or nameof(NeuronReaderOptions.Tls)))
            .Select(property => property.Name)
            .Concat(typeof(ReconnectPolicy).GetProperties().Select(property => $"Reconnect:{property.Name}"))
            .Concat(typeof(NeuronTlsOptions).GetProperties().Select(property => $"Tls:{property.Name}"))
            .Append("Tls:Enabled");
        Assert.Equal(expected.Order(StringComparer.Ordinal), ReaderSettings.Keys.Order(StringComparer.Ordinal));
    }

    [Theory]
    [InlineData("Prot", "7001", "Prot is not a setting of a reader; use one of Name, Transport, Host, Port")]
    [InlineData("Reconnect:Delay", "1", "Reconnect:Delay is not a setting")]
    [InlineData("Port", "seven", "Port is 'seven'; it must be a whole number.")]
    [InlineData("Transport", "1", "Transport is '1'; it must be one of Tcp, Udp.")]
    [InlineData("RotationOrder", "ZZZ", "RotationOrder is 'ZZZ'; it must be one of X")]
    [InlineData("AllowedSenders", "", "AllowedSenders is empty; leave it out to allow all senders.")]
    [InlineData("AllowedSenders", null, "AllowedSenders is empty; leave it out to allow all senders.")]
    [InlineData("AllowedSenders", " , ", "AllowedSenders is empty; leave it out to allow all senders.")]
    [InlineData("allowedSenders:0", "", "AllowedSenders is empty; leave it out to allow all senders.")]
    [InlineData("LocalAddress", "studio", "LocalAddress is 'studio'; it must be an IP address.")]
    [InlineData("AllowedSenders:0", "studio", "AllowedSenders:0 is 'studio'; it must be an IP address.")]
    [InlineData("SharePort", "yes", "SharePort is 'yes'; it must be true or false.")]
    [InlineData("ConnectTimeout", "soon", "ConnectTimeout is 'soon'; it must be a time")]
    [InlineData("SilenceTimeout", "1e400", "SilenceTimeout is '1e400'; it must be a time")]
    public void An_invalid_setting_is_named(string key, string? text, string expected)
    {
        OptionsValidationException exception = Assert.Throws<OptionsValidationException>(() => Read((key, text)));
        Assert.StartsWith(expected, Assert.Single(exception.Failures), StringComparison.Ordinal);
    }

    // What a null in JSON becomes before .NET 10.
    [Theory]
    [InlineData("Name")]
    [InlineData("LocalAddress")]
    [InlineData("RotationOrder")]
    [InlineData("SkeletonVariant")]
    [InlineData("CommandPort")]
    [InlineData("CalculationPort")]
    [InlineData("tls:targetHost")]
    public void An_empty_text_leaves_an_optional_setting_out(string key)
    {
        NeuronReaderOptions options = Read((key, string.Empty));

        Assert.Null(options.FindFault());
        Assert.Equal(
            (null, null, null, null, null, null, null),
            (options.Name, options.LocalAddress, options.RotationOrder, options.SkeletonVariant, options.CommandPort, options.CalculationPort, options.Tls));
    }

    [Fact]
    public void All_invalid_settings_are_reported_together()
    {
        OptionsValidationException exception = Assert.Throws<OptionsValidationException>(() => Read(("Port", "x"), ("MaxValues", "y")));
        Assert.Equal(2, exception.Failures.Count());
    }

    [Fact]
    public void Senders_are_read_from_an_array() => Assert.Equal(
        [IPAddress.Parse("192.168.1.20"), IPAddress.Parse("192.168.1.21")],
        Read(("AllowedSenders:0", "192.168.1.20"), ("AllowedSenders:1", "192.168.1.21")).AllowedSenders.OrderBy(static address => address.ToString()));

    [Theory]
    [InlineData("192.168.1.20", "192.168.1.20")]
    [InlineData("192.168.1.7, 192.168.1.8", "192.168.1.7", "192.168.1.8")]
    [InlineData("", "192.168.1.20", "192.168.1.21")]
    [InlineData(" , ", "192.168.1.20", "192.168.1.21")]
    public void A_list_replaces_an_array_unless_it_is_empty(string list, params string[] expected) => Assert.Equal(
        expected.Select(IPAddress.Parse),
        Read(("AllowedSenders:0", "192.168.1.20"), ("allowedSenders", list), ("AllowedSenders:1", "192.168.1.21"))
            .AllowedSenders.OrderBy(static address => address.ToString()));

    private static NeuronReaderOptions Read(params (string Key, string? Value)[] settings)
    {
        IConfiguration configuration = new ConfigurationBuilder()
            .AddInMemoryCollection(settings.Select(setting => KeyValuePair.Create($"NeuronReader:{setting.Key}", setting.Value)))
            .Build();
        var options = new NeuronReaderOptions();
        ReaderSettings.Apply(configuration.GetSection("NeuronReader"), string.Empty, folder: string.Empty, options);
        return options;
    }
}
