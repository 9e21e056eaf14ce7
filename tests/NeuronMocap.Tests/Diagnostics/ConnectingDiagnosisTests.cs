using System.Net;
using System.Net.Sockets;
using NeuronMocap.Diagnostics;
using NeuronMocap.Tests.Network;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Diagnostics;

// The steps before the first byte.
public sealed class ConnectingDiagnosisTests : IDisposable
{
    private readonly RefusingPort _refusing = new();

    public void Dispose() => _refusing.Dispose();

    [Theory]
    [InlineData(SocketError.HostNotFound, "spelling")]
    [InlineData(SocketError.TryAgain, "name server")]
    public async Task An_unknown_name_and_a_silent_name_server_are_distinguished(SocketError error, string said)
    {
        var link = new LinkOptions("studio", 7001) { Resolve = _ => Task.FromException<IPAddress[]>(new SocketException((int)error)) };
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(link, Diagnosing.With(Diagnosing.Patient));

        diagnosis.AssertFault(DiagnosisVerdict.HostNotFound, "name", "studio", said, "IP address");
        Assert.Single(diagnosis.Steps);
        Assert.Null(diagnosis.SampleCode);
    }

    [Fact]
    public async Task A_silent_name_server_takes_only_its_share_of_the_time()
    {
        var link = new LinkOptions("studio", 7001) { Resolve = static _ => new TaskCompletionSource<IPAddress[]>().Task };
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(link, Diagnosing.With(new DiagnosisBudget { Name = 0.002 }));
        diagnosis.AssertFault(DiagnosisVerdict.HostNotFound, "name", "no name server answers");
    }

    [Fact]
    public async Task A_port_within_the_host_name_is_recognised()
    {
        var link = new LinkOptions("studio:7001", 7001) { Resolve = static host => throw new ArgumentException("No name.", nameof(host)) };
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(link, Diagnosing.With(Diagnosing.Patient));
        diagnosis.AssertFault(DiagnosisVerdict.HostNotFound, "name", "the port is a separate option");
    }

    [Fact]
    public async Task A_short_address_is_shown_in_full()
    {
        using ScriptedServer server = ScriptedServer.Streaming();
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(
            new NeuronReaderOptions { Host = "127.1", Port = server.Port }, Diagnosing.With(Diagnosing.Patient));

        Assert.Equal(StepOutcome.Warning, diagnosis.Step("name").Outcome);
        Assert.Contains("127.0.0.1", diagnosis.Step("name").Detail, StringComparison.Ordinal);
        Assert.True(diagnosis.IsReceiving);
    }

    [Fact]
    public async Task A_foreign_local_address_is_reported()
    {
        var options = new NeuronReaderOptions { LocalAddress = IPAddress.Parse("192.0.2.77") };
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(options, Diagnosing.With(Diagnosing.Silent));
        diagnosis.AssertFault(DiagnosisVerdict.LocalAddressUnavailable, "route", "192.0.2.77", "LocalAddress");
    }

    [Theory]
    [InlineData(ConnectionReason.AccessDenied, DiagnosisVerdict.AccessDenied, "does not allow")]
    [InlineData(ConnectionReason.NetworkError, DiagnosisVerdict.NetworkError, "cannot send")]
    [InlineData(ConnectionReason.Unreachable, DiagnosisVerdict.Unreachable, "no route")]
    [InlineData(ConnectionReason.AddressUnavailable, DiagnosisVerdict.Unreachable, "no route")]
    public void The_systems_route_error_decides(ConnectionReason reason, DiagnosisVerdict expected, string said)
    {
        var task = new DiagnosisContext(new LinkOptions("127.255.255.255", 7001), new DiagnosisOptions(), new StepLog(progress: null), CancellationToken.None);
        ExplainedVerdict verdict = Assert.Single(TcpConclusions.NoRoute(task, reason).Verdicts);
        Assert.Equal(expected, verdict.Verdict);
        Assert.Contains(said, verdict.Text, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_refused_port_names_the_settings_of_both_programs()
    {
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(_refusing.Number, Diagnosing.Silent);

        diagnosis.AssertFault(
            DiagnosisVerdict.Refused, "port", $"127.0.0.1:{_refusing.Number}", "File > Settings > Broadcasting", "Settings > BVH Broadcasting", "TCP", "is this computer");
        Assert.Contains("inside this computer", diagnosis.Step("route").Detail, StringComparison.Ordinal);
        Assert.Equal(diagnosis.Advice, diagnosis.Summary[^diagnosis.Advice!.Length..]);
    }

    [Fact]
    public async Task A_silent_host_names_the_firewall()
    {
        using var hole = new BlackHole();
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(hole.Port, Diagnosing.Silent with { Connecting = 0.003 });
        diagnosis.AssertFault(DiagnosisVerdict.NoAnswer, "port", "Windows Defender Firewall", $"port {hole.Port}");
    }

    [Fact]
    public async Task A_host_that_answers_on_another_port_is_running()
    {
        using var hole = new BlackHole();
        DiagnosisOptions how = Diagnosing.With(Diagnosing.Silent with { Connecting = 0.003, OtherPorts = 0.015 });
        how.UsualTcpPorts = [_refusing.Number];
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(new NeuronReaderOptions { Port = hole.Port }, how);
        diagnosis.AssertFault(DiagnosisVerdict.NoAnswer, "port", "answers on other ports");
    }

    [Fact]
    public async Task A_silent_address_does_not_hide_a_working_one()
    {
        using ScriptedServer server = ScriptedServer.Streaming();
        var link = new LinkOptions("studio", server.Port)
        {
            Resolve = static _ => Task.FromResult<IPAddress[]>([IPAddress.Parse("127.0.0.2"), IPAddress.Loopback]),
        };
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(link, Diagnosing.With(Diagnosing.Patient));

        Assert.True(diagnosis.IsReceiving);
        Assert.Equal(StepOutcome.Warning, diagnosis.Step("port").Outcome);
        Assert.Contains("127.0.0.2", diagnosis.Step("port").Detail, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_stream_on_another_usual_port_is_found_with_the_code_to_receive_it()
    {
        using var other = new RefusingPort();
        using ScriptedServer server = ScriptedServer.Streaming();
        DiagnosisOptions how = Diagnosing.With(Diagnosing.Patient);
        how.UsualTcpPorts = [other.Number, server.Port];
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(new NeuronReaderOptions { Port = _refusing.Number }, how);

        diagnosis.AssertFault(DiagnosisVerdict.OtherPort, "port", $"Use port {server.Port} here");
        Assert.Contains($"new NeuronReader(\"127.0.0.1\", {server.Port})", diagnosis.SampleCode, StringComparison.Ordinal);
        Assert.Equal(StepOutcome.Warning, diagnosis.Step("other ports").Outcome);
    }

    // Without an end, the wait for the silent port would take as long.
    [Fact]
    public async Task A_found_stream_ends_the_search()
    {
        using ScriptedServer server = ScriptedServer.Streaming();
        using var silent = new ScriptedServer(static (_, stop) => Task.Delay(Timeout.Infinite, stop));
        DiagnosisOptions how = Diagnosing.With(Diagnosing.Patient with { OtherPorts = 0.05, Grace = TimeSpan.FromMinutes(20) });
        how.UsualTcpPorts = [server.Port, silent.Port];
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(new NeuronReaderOptions { Port = _refusing.Number }, how);
        diagnosis.AssertFault(DiagnosisVerdict.OtherPort, "port", $"Use port {server.Port} here");
    }

    [Fact]
    public async Task A_diagnosis_takes_no_shared_receive_thread()
    {
        using ScriptedServer server = ScriptedServer.Streaming();
        int taken = 0;
        var link = new LinkOptions("127.0.0.1", _refusing.Number)
        {
            TakeReceiver = _ =>
            {
                Interlocked.Increment(ref taken);
                return TcpReceivers.Shared.Take();
            },
        };
        DiagnosisOptions how = Diagnosing.With(Diagnosing.Patient);
        how.UsualTcpPorts = [server.Port];
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(link, how);
        Assert.Equal((DiagnosisVerdict.OtherPort, 0), (diagnosis.Verdict, taken));
    }

    [Fact]
    public async Task Calculation_data_on_another_port_show_that_the_server_runs()
    {
        using ScriptedServer server = ScriptedServer.Streaming(PacketKind.Calculation);
        DiagnosisOptions how = Diagnosing.With(Diagnosing.Patient with { OtherPorts = 0.05 });
        how.UsualTcpPorts = [server.Port];
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(new NeuronReaderOptions { Port = _refusing.Number }, how);

        diagnosis.AssertFault(DiagnosisVerdict.Refused, "port", $"TCP port {server.Port} of 127.0.0.1 has calculation data");
        Assert.Null(diagnosis.SampleCode);
    }

    [Fact]
    public async Task A_server_that_sends_over_UDP_is_found_behind_a_refused_connection()
    {
        using var sender = new DatagramSender();
        int port = FreePort.Next();
        Task<StreamDiagnosis> diagnosing = Diagnosing.RunAsync(port);
        StreamDiagnosis diagnosis = await sender.SendUntilAsync(diagnosing, port, static i => [TestPackets.Motion(i)]);

        diagnosis.AssertFault(DiagnosisVerdict.SentOverUdp, "port", $"UDP port {port} of this computer", $"{sender.EndPoint}", "choose TCP");
        Assert.Contains("TransportKind.Udp", diagnosis.SampleCode, StringComparison.Ordinal);
    }

    // The bound is the documented one. The slack is for a busy machine.
    [Theory]
    [InlineData(true, false)]
    [InlineData(false, true)]
    [InlineData(false, false)]
    public async Task A_diagnosis_keeps_to_its_time_limit(bool unknownName, bool blackHole)
    {
        using var hole = new BlackHole();
        using var server = new ScriptedServer(static (_, stop) => Task.Delay(Timeout.Infinite, stop));
        var link = new LinkOptions("studio", blackHole ? hole.Port : server.Port)
        {
            Resolve = unknownName ? static _ => new TaskCompletionSource<IPAddress[]>().Task : static _ => Task.FromResult<IPAddress[]>([IPAddress.Loopback]),
        };
        DiagnosisOptions how = Diagnosing.With(new DiagnosisBudget());
        how.Timeout = TimeSpan.FromSeconds(1);
        how.UsualTcpPorts = [hole.Port, server.Port];
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(link, how);

        Assert.False(diagnosis.IsReceiving);
        Assert.InRange(diagnosis.Elapsed, TimeSpan.Zero, TimeSpan.FromSeconds(30));
    }

    [Fact]
    public async Task The_alternative_port_scan_can_be_switched_off()
    {
        using ScriptedServer server = ScriptedServer.Streaming();
        DiagnosisOptions how = Diagnosing.With(Diagnosing.Patient);
        how.UsualTcpPorts = [server.Port];
        how.SearchOtherPorts = false;
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(new NeuronReaderOptions { Port = _refusing.Number }, how);

        Assert.Equal(DiagnosisVerdict.Refused, diagnosis.Verdict);
        Assert.Equal(["name", "route", "port"], diagnosis.Steps.Select(static step => step.Name));
    }

    [Theory]
    [InlineData(TransportKind.Tcp)]
    [InlineData(TransportKind.Udp)]
    public async Task A_cancelled_diagnosis_ends_at_once(TransportKind transport)
    {
        using ScriptedServer server = new(static (_, stop) => Task.Delay(Timeout.Infinite, stop));
        int port = transport == TransportKind.Tcp ? server.Port : 0;
        using var cancellation = new CancellationTokenSource();
        var portIsOpen = new CancelAt("port", cancellation);

        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => NeuronDiagnostics.DiagnoseAsync(
            new NeuronReaderOptions { Port = port, Transport = transport }, Diagnosing.With(Diagnosing.Patient), portIsOpen, cancellation.Token).Soon());
    }

    [Fact]
    public async Task Options_out_of_range_are_named()
    {
        ArgumentException reader = await Assert.ThrowsAsync<ArgumentException>(() => NeuronDiagnostics.DiagnoseAsync(new NeuronReaderOptions { Port = 0 }));
        Assert.Contains("Port is 0", reader.Message, StringComparison.Ordinal);
        foreach (DiagnosisOptions wrong in (DiagnosisOptions[])[new() { Timeout = TimeSpan.Zero }, new() { Expected = PacketKind.Command }])
            await Assert.ThrowsAsync<ArgumentException>(() => NeuronDiagnostics.DiagnoseAsync(new NeuronReaderOptions(), wrong));
    }

    private sealed class CancelAt(string step, CancellationTokenSource cancellation) : IProgress<DiagnosisStep>
    {
        public void Report(DiagnosisStep value)
        {
            if (value.Name.Equals(step, StringComparison.Ordinal))
                cancellation.Cancel();
        }
    }
}
