using NeuronMocap.Diagnostics;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Diagnostics;

public sealed class SourceDiagnosisTests
{
    [Fact]
    public async Task Frames_of_a_source_are_judged()
    {
        StreamDiagnosis diagnosis = await RunAsync(() => new FedStream().Feed(TestPackets.Motions(0, 5)));
        Assert.True(diagnosis.IsReceiving);
        Assert.StartsWith("Frames arrive on the list: ", diagnosis.Summary, StringComparison.Ordinal);
        Assert.Equal(["source", "first bytes", "token", "version", "format"], diagnosis.Steps.Take(5).Select(static step => step.Name));
        Assert.Equal("Char00", Assert.Single(diagnosis.Avatars).Name);
        Assert.Null(diagnosis.SampleCode);
    }

    [Fact]
    public async Task A_source_that_cannot_be_opened_says_why()
    {
        StreamDiagnosis diagnosis = await RunAsync(static () => throw new NeuronConnectionException(ConnectionReason.Refused, "Nobody is there."));
        diagnosis.AssertFault(DiagnosisVerdict.Refused, "source", "Opening the list failed: Nobody is there.");
    }

    [Fact]
    public async Task A_source_that_does_not_open_in_time_is_left()
    {
        StreamDiagnosis diagnosis = await RunAsync(Diagnosing.Patient with { Connecting = 0.002 });
        diagnosis.AssertFault(DiagnosisVerdict.NoAnswer, "source", "Opening the list takes longer than 0.12 s");
    }

    [Fact]
    public async Task An_end_without_bytes_is_a_fault()
    {
        StreamDiagnosis diagnosis = await RunAsync(static () => new FedStream().End(new IOException("Cut.")));
        diagnosis.AssertFault(DiagnosisVerdict.ClosedImmediately, "first bytes", "Receiving from the list failed: Cut.");
    }

    [Fact]
    public async Task Silence_is_a_fault()
    {
        StreamDiagnosis diagnosis = await RunAsync(Diagnosing.Silent, static () => new FedStream());
        diagnosis.AssertFault(DiagnosisVerdict.Silent, "first bytes", "Nothing has arrived from the list for 0.12 s.");
    }

    [Fact]
    public async Task A_read_that_blocks_its_caller_is_silence()
    {
        StreamDiagnosis diagnosis = await RunAsync(Diagnosing.Silent, static () => new FedStream { BlocksCallers = true, IgnoresEnd = true });
        diagnosis.AssertFault(DiagnosisVerdict.Silent, "first bytes", "Nothing has arrived from the list for 0.12 s.");
    }

    [Fact]
    public async Task A_stream_that_always_has_bytes_is_left_in_time()
    {
        StreamDiagnosis diagnosis = await RunAsync(static () => new EndlessStream(TestPackets.Motions(0, 50)));
        Assert.StartsWith("Frames arrive on the list", diagnosis.Summary, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task A_cancellation_ends_the_diagnosis_of_a_stream_that_never_waits(bool isEndless)
    {
        using var cancellation = new CancellationTokenSource();
        using var stream = new FedStream { BlocksCallers = true, IgnoresEnd = true };
        int opened = 0;
        var source = new ListedSource(() =>
        {
            opened++;
            return isEndless ? new EndlessStream(TestPackets.Motions(0, 50)) : stream;
        });
        Task<StreamDiagnosis> diagnosing = NeuronDiagnostics.DiagnoseAsync(
            new NeuronReaderOptions { Source = source }, Diagnosing.With(Diagnosing.Patient with { Measuring = 0.5 }), progress: null, cancellation.Token);
        await Limits.UntilAsync(() => isEndless ? opened > 0 : stream.Waiting > 0);
        await cancellation.CancelAsync();
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => diagnosing).Soon();
    }

    private static Task<StreamDiagnosis> RunAsync(params Func<Stream>[] streams) => RunAsync(Diagnosing.Patient, streams);

    private static Task<StreamDiagnosis> RunAsync(DiagnosisBudget budget, params Func<Stream>[] streams) =>
        Diagnosing.RunAsync(new NeuronReaderOptions { Source = new ListedSource(streams) }, Diagnosing.With(budget));

    // Its reads never wait.
    private sealed class EndlessStream(byte[] bytes) : MemoryStream(bytes)
    {
        public override int Read(byte[] buffer, int offset, int count)
        {
            if (Position == Length)
                Position = 0;

            return base.Read(buffer, offset, count);
        }
    }
}
