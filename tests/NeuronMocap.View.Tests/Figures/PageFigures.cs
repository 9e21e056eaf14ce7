using System.Diagnostics;
using System.Globalization;
using System.Text.Json;
using NeuronMocap.Server;
using NeuronMocap.Tool.Tests.View;
using NeuronMocap.View.Tests.Infrastructure;

namespace NeuronMocap.View.Tests.Figures;

// Measures the page. Run it alone: NEURONMOCAP_FIGURES=1 NeuronMocap.View.Tests -class "*PageFigures" -showLiveOutput
public sealed class PageFigures(SharedBrowser browser, ITestOutputHelper output)
{
    private const string Stats = "() => { const { stats, state } = window.neuronMocap; return { ...stats(), now: performance.now(), performers: state().performers.length }; }";

    [Figure]
    public async Task Main_thread_and_wire()
    {
        await MeasureAsync(1, 1280, 800);
        await MeasureAsync(3, 1280, 800);
        await MeasureAsync(1, 480, 400);
        await MeasureAsync(3, 480, 400);
        await MeasureAsync(20, 480, 400);
    }

    [Figure]
    public async Task Delay_of_twenty_performers()
    {
        const int Performers = 20;
        await using Broadcaster broadcaster = Broadcaster.StartDemo(Performers);
        await using RunningView view = await RunningView.StartAsync($"127.0.0.1:{broadcaster.LocalEndPoint!.Port}");
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link, asInstalled: true);
        await page.UntilMovingAsync(Performers);
        await page.UntilDrawnAsync(30);
        List<double> delays = [];
        for (int i = 0; i < 30; i++)
        {
            await Task.Delay(1000, TestContext.Current.CancellationToken);
            JsonElement delay = await page.EvaluateAsync("() => window.neuronMocap.stats().newestDelay");
            if (delay.ValueKind == JsonValueKind.Number)
                delays.Add(delay.GetDouble());
        }

        double Mean(int skip) => delays.Skip(skip).Take(10).Average();
        output.WriteLine(FormattableString.Invariant($"20 performers, 30 s: delay {Mean(0):0.0} ms in the first third, {Mean(10):0.0} in the second, {Mean(20):0.0} in the last, {delays.Max():0.0} at most"));
    }

    // As a person has it who opens the link in a browser that runs: the empty tab is there, and nothing looks into its requests. NEURONMOCAP_PROGRAM can
    // name an installed program, which starts faster than the one of the build.
    [Figure]
    public async Task First_picture()
    {
        IBrowser running = await browser.StartAsync(asInstalled: true);
        for (int i = 0; i < 5; i++)
        {
            await using IBrowserContext context = await running.NewContextAsync(new BrowserNewContextOptions { ViewportSize = new ViewportSize { Width = 480, Height = 400 } });
            IPage page = await context.NewPageAsync();
            await Task.Delay(TimeSpan.FromSeconds(3), TestContext.Current.CancellationToken);
            var watch = Stopwatch.StartNew();
            var start = new ProcessStartInfo(Environment.GetEnvironmentVariable("NEURONMOCAP_PROGRAM") ?? Path.Combine(AppContext.BaseDirectory, "neuron-mocap")) { RedirectStandardOutput = true, UseShellExecute = false };
            foreach (string argument in (string[])["view", "demo", "--port", "0"])
                start.ArgumentList.Add(argument);
            using Process program = Process.Start(start)!;
            try
            {
                string? line;
                do
                    line = await program.StandardOutput.ReadLineAsync(TestContext.Current.CancellationToken);
                while (line is not null && !line.Contains(" on http://", StringComparison.Ordinal));
                Assert.NotNull(line);
                TimeSpan listening = watch.Elapsed;
                await page.GotoAsync(line[line.IndexOf("http://", StringComparison.Ordinal)..], new PageGotoOptions { WaitUntil = WaitUntilState.Commit });
                await page.WaitForFunctionAsync("() => window.neuronMocap?.stats().framesShown > 0 && window.neuronMocap.stats().pictures > 0");
                output.WriteLine(FormattableString.Invariant($"first picture after {watch.Elapsed.TotalSeconds:0.00} s, the link after {listening.TotalSeconds:0.00} s"));
            }
            finally
            {
                program.Kill();
            }
        }
    }

    // Minutes from the environment, because ten are long.
    [Figure]
    public async Task Heap()
    {
        double minutes = double.Parse(Environment.GetEnvironmentVariable("NEURONMOCAP_HEAP_MINUTES") ?? "10", CultureInfo.InvariantCulture);
        await using Broadcaster broadcaster = Broadcaster.StartDemo(3);
        await using RunningView view = await RunningView.StartAsync($"127.0.0.1:{broadcaster.LocalEndPoint!.Port}");
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link, 320, 320, asInstalled: true);
        await page.UntilMovingAsync(3);
        await page.UntilDrawnAsync(100);
        ICDPSession session = await page.Page.Context.NewCDPSessionAsync(page.Page);
        var watch = Stopwatch.StartNew();
        while (watch.Elapsed.TotalMinutes < minutes)
        {
            await session.SendAsync("HeapProfiler.collectGarbage");
            JsonElement usage = (await session.SendAsync("Runtime.getHeapUsage"))!.Value;
            JsonElement stats = await page.EvaluateAsync(Stats);
            output.WriteLine(FormattableString.Invariant(
                $"{watch.Elapsed.TotalMinutes:0.0} min: {usage.GetProperty("usedSize").GetDouble() / 1e6:0.000} MB after {stats.GetProperty("framesShown").GetDouble():0} poses and {stats.GetProperty("pictures").GetDouble():0} pictures"));
            await Task.Delay(TimeSpan.FromMinutes(minutes / 10), TestContext.Current.CancellationToken);
        }
    }

    private async Task MeasureAsync(int performers, int width, int height)
    {
        await using Broadcaster broadcaster = Broadcaster.StartDemo(performers);
        await using RunningView view = await RunningView.StartAsync($"127.0.0.1:{broadcaster.LocalEndPoint!.Port}");
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link, width, height, asInstalled: true);
        await page.UntilMovingAsync(performers);

        // The first pictures compile.
        await page.UntilDrawnAsync(30);
        JsonElement before = await page.EvaluateAsync(Stats);
        await page.UntilDrawnAsync(120);
        JsonElement after = await page.EvaluateAsync(Stats);
        double seconds = Change("now") / 1000;
        double[] motion = Times("motionTimes"), whole = Times("frameTimes");
        output.WriteLine(FormattableString.Invariant(
            $"{performers} performers, {width}x{height}: {Change("pictures") / seconds:0.0} fps, main thread per picture and performer {motion.Average() / performers:0.000} ms without drawing, {whole.Average() / performers:0.000} ms with it, {Change("receivedBytes") / Change("received"):0} bytes/frame, {Change("received") / seconds / performers:0.0} frames/s"));

        double Change(string name) => after.GetProperty(name).GetDouble() - before.GetProperty(name).GetDouble();
        double[] Times(string name) => [.. after.GetProperty(name).EnumerateArray().Select(static time => time.GetDouble()).Take(120)];
    }
}
