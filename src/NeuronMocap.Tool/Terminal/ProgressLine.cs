using System.Diagnostics;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace NeuronMocap.Tool.Terminal;

/// <summary>A progress bar for long work, in one line on standard error.</summary>
/// <remarks>
/// The bar appears after a second and disappears when the work is done. If standard error is not a terminal, no bar appears. Not thread-safe.
/// </remarks>
/// <param name="streams">The streams of the program.</param>
/// <param name="work">Short description of the work.</param>
/// <param name="delay">Delay before the bar appears; null for a second.</param>
internal sealed class ProgressLine(StandardStreams streams, string work, TimeSpan? delay = null) : IProgress<double>, IDisposable
{
    private const string ShowCursor = "\e[?25h";
    private const double Fall = 0.25;
    private const int WidestBar = 40;
    private const int WidestLine = 100;

    private static readonly TimeSpan DefaultDelay = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan Interval = TimeSpan.FromMilliseconds(100);

    private readonly long _start = Stopwatch.GetTimestamp();
    private readonly ManualResetEventSlim _end = new();
    private volatile Step _step = new(1, Stopwatch.GetTimestamp());
    private double _value;
    private Task? _showing;

    /// <summary>Reports progress. It may be called for every frame. A value far below the last one starts the next step of the work.</summary>
    /// <param name="value">Progress of the step, 0 to 1.</param>
    public void Report(double value)
    {
        if (value < _value - Fall)
            _step = new Step(_step.Number + 1, Stopwatch.GetTimestamp());

        Volatile.Write(ref _value, value);
        if (_showing is null && streams.IsErrorTerminal && Stopwatch.GetElapsedTime(_start) >= (delay ?? DefaultDelay))
            _showing = Task.Factory.StartNew(Show, CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);
    }

    /// <summary>Removes the bar.</summary>
    public void Dispose()
    {
        _end.Set();
        _showing?.Wait();
        _end.Dispose();
    }

    /// <summary>Restores the terminal after work that was abandoned and may still show its bar.</summary>
    public static void Abandon(StandardStreams streams)
    {
        if (streams.IsErrorTerminal)
            streams.Error.WriteLine(ShowCursor);
    }

    /// <summary>Describes the remaining time, estimated from the elapsed time.</summary>
    /// <param name="value">Progress, 0 to 1.</param>
    /// <param name="elapsed">The elapsed time.</param>
    public static string DescribeRest(double value, TimeSpan elapsed)
    {
        double seconds = value > 0 ? Math.Ceiling(elapsed.TotalSeconds * (1 - value) / value) : double.PositiveInfinity;
        return seconds switch
        {
            < 60 => Quantity.Format($"{seconds:0} s left"),
            < 1e9 => $"{Quantity.Duration(TimeSpan.FromSeconds(seconds))} left",
            _ => string.Empty,
        };
    }

    private void Show()
    {
        IAnsiConsole console = AnsiConsole.Create(new AnsiConsoleSettings
        {
            Ansi = AnsiSupport.Yes,
            Interactive = InteractionSupport.Yes,
            Out = new AnsiConsoleOutput(streams.Error),
        });
        console.Profile.Width = Math.Min(console.Profile.Width, WidestLine);
        int bar = Math.Min(WidestBar, console.Profile.Width / 3);
        ProgressColumn[] columns =
            [new TaskDescriptionColumn { Alignment = Justify.Left }, new ProgressBarColumn { Width = bar }, new PercentageColumn(), new RestColumn(this)];
        try
        {
            console.Progress().AutoClear(enabled: true).AutoRefresh(enabled: false).Columns(columns).Start(Follow);
        }
        catch (IOException)
        {
            // The terminal was closed. The work goes on.
        }
    }

    private void Follow(ProgressContext context)
    {
        string description = Markup.Escape(TerminalText.Clean(work));
        ProgressTask task = context.AddTask(description, maxValue: 1);
        do
        {
            task.Description = _step.Number == 1 ? description : $"{description}, step {_step.Number}";
            task.Value = Math.Clamp(Volatile.Read(ref _value), 0, 1);
            context.Refresh();
        }
        while (!_end.Wait(Interval));
    }

    private sealed record Step(int Number, long Start);

    // Spectre's own column measures from the appearance of the bar.
    private sealed class RestColumn(ProgressLine line) : ProgressColumn
    {
        public override IRenderable Render(RenderOptions options, ProgressTask task, TimeSpan deltaTime) =>
            new Text(DescribeRest(task.Value, Stopwatch.GetElapsedTime(line._step.Start)), Palette.DimStyle);
    }
}
