using System.Text;
using NeuronMocap.Diagnostics;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Diagnostics;

// Data over an open connection.
public sealed class StreamDiagnosisTests
{
    [Fact]
    public async Task A_healthy_stream_is_described_from_the_name_to_the_rate()
    {
        using ScriptedServer server = ScriptedServer.Streaming(static i => TestPackets.Join(TestPackets.Motion(i), TestPackets.Motion(i, avatar: 1, name: "Zoe")));
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(server.Port, Diagnosing.Patient with { Measuring = 0.01 });

        // The rate depends on this machine.
        Assert.True(diagnosis.IsReceiving);
        Assert.Equal(["name", "route", "port", "first bytes", "token", "version", "format", "rate"], diagnosis.Steps.Select(static step => step.Name));
        Assert.StartsWith("FF DD 00 00 01 01", diagnosis.Step("first bytes").Detail, StringComparison.Ordinal);
        foreach (string text in (string[])["version 1.1.0.0", "354 values, displacement on, reference off", "2 avatars: 0 Char00, 1 Zoe"])
            Assert.Contains(text, diagnosis.Summary, StringComparison.Ordinal);

        Assert.Contains($"new NeuronReader(\"127.0.0.1\", {server.Port})", diagnosis.SampleCode, StringComparison.Ordinal);
        Assert.Equal([(0, "Char00"), (1, "Zoe")], diagnosis.Avatars.Select(static avatar => (avatar.Index, avatar.Name)));
        Assert.All(diagnosis.Avatars, static avatar => Assert.True(avatar is { Kind: PacketKind.Motion, Lost: 0, Frames: > 0, ValueCount: 354, HasDisplacement: true }));
    }

    [Fact]
    public async Task A_calculation_port_is_diagnosed()
    {
        using ScriptedServer motion = ScriptedServer.Streaming(static i => TestPackets.Motion(i));
        using ScriptedServer calculation = ScriptedServer.Streaming(PacketKind.Calculation);
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(
            new NeuronReaderOptions { Port = motion.Port, CalculationPort = calculation.Port }, Diagnosing.With(Diagnosing.Patient));

        Assert.True(diagnosis.IsReceiving);
        Assert.DoesNotContain(DiagnosisVerdict.CalculationUnavailable, diagnosis.Verdicts);
        Assert.Contains($"Calculation port {calculation.Port}: frames arrive.", diagnosis.Summary, StringComparison.Ordinal);
        Assert.Contains($"CalculationPort = {calculation.Port}", diagnosis.SampleCode, StringComparison.Ordinal);
        Assert.Equal(StepOutcome.Ok, diagnosis.Step("calculation first bytes").Outcome);
        Assert.Equal([PacketKind.Motion, PacketKind.Calculation], diagnosis.Avatars.Select(static avatar => avatar.Kind));
    }

    [Fact]
    public async Task A_refused_calculation_port_is_reported_without_failing_the_motion()
    {
        using ScriptedServer motion = ScriptedServer.Streaming(static i => TestPackets.Motion(i));
        var closed = new TestServer();
        int port = closed.Port;
        closed.Dispose();
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(new NeuronReaderOptions { Port = motion.Port, CalculationPort = port }, Diagnosing.With(Diagnosing.Patient));

        Assert.True(diagnosis.IsReceiving);
        Assert.Contains(DiagnosisVerdict.CalculationUnavailable, diagnosis.Verdicts);
        Assert.Contains($"Calculation port {port}: connection refused.", diagnosis.Summary, StringComparison.Ordinal);
        Assert.Contains($"tick Enable under Calculation, with port {port}. In Axis Studio switch on the broadcasting of calculation data", diagnosis.Summary, StringComparison.Ordinal);
        Assert.DoesNotContain("BVH Broadcasting", diagnosis.Summary, StringComparison.Ordinal);
        Assert.Equal(StepOutcome.Failed, diagnosis.Step("calculation port").Outcome);
    }

    [Fact]
    public async Task The_old_header_is_reported()
    {
        using ScriptedServer server = ScriptedServer.Streaming(static i => TestPackets.Motion(i, layout: HeaderLayout.Old));
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(server.Port);

        Assert.True(diagnosis.IsReceiving);
        Assert.Contains(DiagnosisVerdict.OldHeader, diagnosis.Verdicts);
        Assert.Equal(StepOutcome.Warning, diagnosis.Step("version").Outcome);
        Assert.Contains("Use old header format", diagnosis.Summary, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Calculation_data_alone_fail_only_when_motion_is_expected()
    {
        using ScriptedServer server = ScriptedServer.Streaming(PacketKind.Calculation);
        DiagnosisOptions how = Diagnosing.With(Diagnosing.Patient with { OtherPorts = 0.002 });
        StreamDiagnosis motion = await Diagnosing.RunAsync(new NeuronReaderOptions { Port = server.Port }, how);
        how.Expected = PacketKind.Calculation;
        StreamDiagnosis calculation = await Diagnosing.RunAsync(new NeuronReaderOptions { Port = server.Port }, how);

        motion.AssertFault(DiagnosisVerdict.CalculationOnly, "token", "calculation data", "tick Enable under BVH");
        Assert.EndsWith($"set CalculationPort to {server.Port}.", motion.Advice, StringComparison.Ordinal);
        Assert.True(calculation.IsReceiving);
        Assert.Contains("ReadCalculationAsync", calculation.SampleCode, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Motion_on_the_next_port_is_suggested()
    {
        using ScriptedServer calculation = ScriptedServer.Streaming(PacketKind.Calculation);
        using ScriptedServer motion = ScriptedServer.Streaming();
        DiagnosisOptions how = Diagnosing.With(Diagnosing.Patient);
        how.UsualTcpPorts = [motion.Port];
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(new NeuronReaderOptions { Port = calculation.Port }, how);

        diagnosis.AssertFault(DiagnosisVerdict.CalculationOnly, "token", $"Use port {motion.Port} over TCP here");
        Assert.Equal([DiagnosisVerdict.CalculationOnly, DiagnosisVerdict.OtherPort], diagnosis.Verdicts);
        Assert.Contains($"new NeuronReader(\"127.0.0.1\", {motion.Port})", diagnosis.SampleCode, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Both_kinds_in_one_stream_pass()
    {
        using ScriptedServer server = ScriptedServer.Streaming(static i => TestPackets.Join(TestPackets.Motion(i), TestPackets.Calculation(i)));
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(server.Port);

        Assert.True(diagnosis.IsReceiving);
        Assert.Equal("0xDDFF and 0x88FF: motion (BVH) and calculation data", diagnosis.Step("token").Detail);
    }

    [Theory]
    [InlineData("0 Char00 0.00 93.02 0.00 -1.5 || \r\n", DiagnosisVerdict.MalformedText, "format", "set Format to Binary")]
    [InlineData("SSH-2.0-OpenSSH_9.6\r\n", DiagnosisVerdict.OtherProgram, "token", "SSH server (\"SSH-2.0-OpenSSH_9.6\")")]
    [InlineData("HTTP/1.1 400 Bad Request\r\n\r\n", DiagnosisVerdict.OtherProgram, "token", "web server")]
    [InlineData("\u0015\u0003\u0003\0\u0002\u0002\u0046", DiagnosisVerdict.OtherProgram, "token", "TLS")]
    [InlineData("220 mail.example ESMTP\r\n", DiagnosisVerdict.OtherProgram, "token", "mail or FTP")]
    [InlineData("CCCC\u0010\u0027\0\0\u001F\u008B\u0008\0\0\0\0\0", DiagnosisVerdict.AdvancedBvh, "token", "Advanced BVH")]
    [InlineData("Char00 A 0.00 93.02 0.00 -1.5 2.25 || \r\n", DiagnosisVerdict.MalformedText, "format", "instead of the avatar's number")]
    [InlineData("\u0001\u0002\u0003\u0004", DiagnosisVerdict.UnknownFormat, "token", "01 02 03 04")]
    public async Task Garbage_is_reported(string bytes, DiagnosisVerdict verdict, string step, string said)
    {
        using ScriptedServer server = ScriptedServer.Saying(Encoding.Latin1.GetBytes(bytes));
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(server.Port, Diagnosing.Patient with { OtherPorts = 0.002 });
        diagnosis.AssertFault(verdict, step, said);
        Assert.Null(diagnosis.SampleCode);
    }

    [Fact]
    public async Task An_ambiguous_avatar_name_is_reported()
    {
        using ScriptedServer server = ScriptedServer.Streaming(static i => TestPackets.Line(i, lead: "0 Char 02 "));
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(server.Port, Diagnosing.Patient with { OtherPorts = 0.002 });
        diagnosis.AssertFault(DiagnosisVerdict.MalformedText, "format", "Rename the avatar");
    }

    [Theory]
    [InlineData(180)]
    [InlineData(186)]
    [InlineData(354)]
    [InlineData(360)]
    public async Task Values_without_an_avatar_are_reported(int count)
    {
        string line = string.Join(' ', Enumerable.Range(0, count).Select(static value => $"{value}.50")) + "||\r\n";
        using ScriptedServer server = ScriptedServer.Streaming(_ => Encoding.ASCII.GetBytes(line));
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(server.Port, Diagnosing.Patient with { OtherPorts = 0.002 });
        diagnosis.AssertFault(DiagnosisVerdict.MalformedText, "format", "0 Char00");
        Assert.Contains("without the avatar's number and name", diagnosis.Summary, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Text_is_recognised()
    {
        using ScriptedServer server = ScriptedServer.Streaming(static i => TestPackets.Line(i));
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(server.Port);
        Assert.True(diagnosis.IsReceiving);
        Assert.Contains(DiagnosisVerdict.TextFormat, diagnosis.Verdicts);
        Assert.Equal("lines of text: motion (BVH) data", diagnosis.Step("token").Detail);
        Assert.Contains("set Format to Binary", diagnosis.Advice, StringComparison.Ordinal);
        Assert.Equal(DataVersion.None, Assert.Single(diagnosis.Avatars).Version);
    }

    [Fact]
    public async Task Axis_Studio_calculation_is_not_motion()
    {
        using ScriptedServer server = ScriptedServer.Streaming(static i => TestPackets.Studio(i));
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(server.Port, Diagnosing.Patient with { OtherPorts = 0.002 });
        diagnosis.AssertFault(DiagnosisVerdict.StudioCalculationOnly, "token", "Axis Studio's calculation data; none are motion (BVH) data");

        DiagnosisOptions how = Diagnosing.With(Diagnosing.Patient);
        how.Expected = PacketKind.StudioCalculation;
        diagnosis = await Diagnosing.RunAsync(new NeuronReaderOptions { Port = server.Port }, how);
        Assert.True(diagnosis.IsReceiving);
        Assert.Equal("0xDCCF: Axis Studio's calculation data", diagnosis.Step("token").Detail);
        Assert.Contains("ReadStudioCalculationAsync", diagnosis.SampleCode, StringComparison.Ordinal);
    }

    [Fact]
    public async Task An_unknown_version_is_reported_with_its_number()
    {
        using ScriptedServer server = ScriptedServer.Streaming(static i =>
        {
            byte[] packet = TestPackets.Motion(i);
            packet[5] = 2;
            return packet;
        });
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(server.Port, Diagnosing.Patient with { OtherPorts = 0.002 });
        diagnosis.AssertFault(DiagnosisVerdict.UnknownVersion, "version", "2.1.0.0");
    }

    [Fact]
    public async Task Counts_over_the_limit_name_the_option()
    {
        using ScriptedServer server = ScriptedServer.Streaming();
        DiagnosisOptions how = Diagnosing.With(Diagnosing.Patient with { OtherPorts = 0.002 });
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(new NeuronReaderOptions { Port = server.Port, MaxValues = 100 }, how);
        diagnosis.AssertFault(DiagnosisVerdict.TooManyValues, "format", "MaxValues");
    }

    [Fact]
    public async Task A_frame_that_never_completes_is_reported()
    {
        using ScriptedServer server = new(async static (client, stop) =>
        {
            await client.SendAsync(TestPackets.Motion(1).AsMemory(0, 700));
            client.Close();
        });
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(server.Port, Diagnosing.Patient with { OtherPorts = 0.002 });
        diagnosis.AssertFault(DiagnosisVerdict.IncompletePackets, "format", "in the middle of a frame");
    }

    [Fact]
    public async Task Packets_without_values_mean_that_nothing_plays()
    {
        using ScriptedServer server = ScriptedServer.Streaming(static i => TestPackets.Motion(i, count: 0));
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(server.Port, Diagnosing.Patient with { OtherPorts = 0.002 });
        diagnosis.AssertFault(DiagnosisVerdict.NoValues, "format", "open a take and press play");
    }

    [Fact]
    public async Task Frames_between_garbage_are_reported()
    {
        byte[] garbage = [.. Enumerable.Range(0, 5000).Select(static i => (byte)(i % 251))];
        using ScriptedServer server = ScriptedServer.Streaming(i => TestPackets.Join(TestPackets.Motion(i), garbage));
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(server.Port);

        Assert.True(diagnosis.IsReceiving);
        Assert.Contains(DiagnosisVerdict.ForeignBytes, diagnosis.Verdicts);
        Assert.Contains("% of the bytes", diagnosis.Summary, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_server_that_closes_at_once_is_reported()
    {
        using ScriptedServer server = new(static (client, _) =>
        {
            client.Close();
            return Task.CompletedTask;
        });
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(server.Port, Diagnosing.Patient with { OtherPorts = 0.002 });
        diagnosis.AssertFault(DiagnosisVerdict.ClosedImmediately, "first bytes", "forwarded port");
    }

    [Fact]
    public async Task Silence_suggests_a_disconnected_suit()
    {
        using ScriptedServer server = new(static (_, stop) => Task.Delay(Timeout.Infinite, stop));
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(server.Port, Diagnosing.Silent);
        diagnosis.AssertFault(DiagnosisVerdict.Silent, "first bytes", "no suit is connected", "BVH Broadcasting - Capture");
        Assert.Equal(StepOutcome.Ok, diagnosis.Step("question").Outcome);
    }

    [Theory]
    [InlineData((byte)'H', "HTTP/1.0 200 OK\r\n\r\n", DiagnosisVerdict.OtherProgram, "a web server's answer")]
    [InlineData((byte)0xFF, "\u00FF\u00AA\0\0\u00EB\u0003\u0004\0\0\0\0\0\0\0\u00FF\u00BB\u0001\0\0\0", DiagnosisVerdict.CommandPort, "command port")]
    [InlineData((byte)'H', "\u0001\u0002\u0003", DiagnosisVerdict.OtherProgram, "01 02 03")]
    public async Task A_request_response_server_is_reported(byte question, string answer, DiagnosisVerdict verdict, string said)
    {
        using ScriptedServer server = new(async (client, stop) =>
        {
            byte[] first = new byte[1];
            int count = await client.Socket.ReceiveAsync(first, stop);
            if (count > 0 && first[0] == question)
                await client.SendAsync(Encoding.Latin1.GetBytes(answer));
        });
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(server.Port, Diagnosing.Silent with { Asking = 0.3 });
        diagnosis.AssertFault(verdict, "question", said);
    }

    [Fact]
    public async Task A_command_port_is_no_data_port()
    {
        byte[] command = new byte[64];
        new DataCommandHeader { CommandId = DataCommandId.AvatarCount }.Write(command);
        using ScriptedServer server = ScriptedServer.Saying(command);
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(server.Port, Diagnosing.Patient with { OtherPorts = 0.002 });
        diagnosis.AssertFault(DiagnosisVerdict.CommandPort, "token", "sends commands");
    }
}
