using NeuronMocap.Diagnostics;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Diagnostics;

// Diagnoses with timing for tests: long where an answer ends the wait, short where nothing will arrive.
internal static class Diagnosing
{
    public static readonly DiagnosisBudget Patient = new() { Silence = 0.5, Measuring = 0.003, Asking = 0.2, OtherPorts = 0.2 };

    public static readonly DiagnosisBudget Silent = Patient with { Silence = 0.002, Asking = 0.002, OtherPorts = 0.002 };

    public static DiagnosisOptions With(DiagnosisBudget budget) => new()
    {
        Timeout = TimeSpan.FromSeconds(60),
        UsualTcpPorts = [],
        UsualUdpPorts = [],
        Budget = budget,
    };

    public static Task<StreamDiagnosis> RunAsync(int port, DiagnosisBudget? budget = null) =>
        RunAsync(new NeuronReaderOptions { Port = port }, With(budget ?? Patient));

    public static async Task<StreamDiagnosis> RunAsync(NeuronReaderOptions options, DiagnosisOptions how)
    {
        var told = new List<DiagnosisStep>();
        StreamDiagnosis diagnosis =
            await NeuronDiagnostics.DiagnoseAsync(options, how, new Progress(told.Add), TestContext.Current.CancellationToken).Soon();
        Assert.Equal(diagnosis.Steps, told);
        return diagnosis;
    }

    // With a resolver of the test.
    public static Task<StreamDiagnosis> RunAsync(LinkOptions link, DiagnosisOptions how) =>
        NeuronDiagnostics.RunAsync(new NeuronReaderOptions(), link, how, progress: null, TestContext.Current.CancellationToken).Soon();

    public static DiagnosisStep Step(this StreamDiagnosis diagnosis, string name) =>
        Assert.Single(diagnosis.Steps, step => step.Name.Equals(name, StringComparison.Ordinal));

    // Asserts that one fault, which names a setting, stops the chain at that step and offers no code.
    public static void AssertFault(this StreamDiagnosis diagnosis, DiagnosisVerdict verdict, string step, params string[] said)
    {
        Assert.Equal(verdict, diagnosis.Verdict);
        Assert.False(diagnosis.IsReceiving);
        Assert.Equal(StepOutcome.Failed, diagnosis.Step(step).Outcome);
        foreach (string text in said)
            Assert.Contains(text, diagnosis.Summary, StringComparison.Ordinal);
    }

    private sealed class Progress(Action<DiagnosisStep> report) : IProgress<DiagnosisStep>
    {
        public void Report(DiagnosisStep value) => report(value);
    }
}

// A server that treats every client the same way, on its own port, until it is disposed.
internal sealed class ScriptedServer : IDisposable
{
    private readonly Network.TestServer _server = new();
    private readonly CancellationTokenSource _stop = new();
    private readonly Func<Network.TestConnection, CancellationToken, Task> _script;

    public ScriptedServer(Func<Network.TestConnection, CancellationToken, Task> script)
    {
        _script = script;
        _ = Task.Run(AcceptAsync);
    }

    public int Port => _server.Port;

    public static ScriptedServer Saying(byte[] bytes) => new(async (client, stop) =>
    {
        await client.SendAsync(bytes);
        await Task.Delay(Timeout.Infinite, stop);
    });

    // A stream without a pause: packets by number, one after the other.
    public static ScriptedServer Streaming(Func<int, byte[]> packet) => new(async (client, stop) =>
    {
        for (int i = 0; !stop.IsCancellationRequested; i++)
        {
            await client.SendAsync(packet(i));
            await Task.Delay(1, stop);
        }
    });

    public static ScriptedServer Streaming(PacketKind kind = PacketKind.Motion) =>
        Streaming(i => kind == PacketKind.Motion ? Network.TestPackets.Motion(i) : Network.TestPackets.Calculation(i));

    public void Dispose()
    {
        _stop.Cancel();
        _server.Dispose();
    }

    private async Task AcceptAsync()
    {
        while (!_stop.IsCancellationRequested)
            _ = ServeAsync(await _server.AcceptAsync());
    }

    private async Task ServeAsync(Network.TestConnection client)
    {
        using (client)
        {
            try
            {
                await _script(client, _stop.Token);
            }
            catch (Exception exception) when (exception is OperationCanceledException or System.Net.Sockets.SocketException)
            {
                // The diagnosis has seen enough, or the test is over.
            }
        }
    }
}
