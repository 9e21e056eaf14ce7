using System.Runtime.InteropServices;
using System.Text;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Play;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>The live view: looks at the reader ten times a second and with every key, and draws. All of it on one thread.</summary>
internal sealed class LiveOutput(NeuronReader reader, RecordingPlayer? player, StreamRecorder? recorder, MonitorOptions options, Stream output) : MonitorOutput
{
    private static readonly TimeSpan Period = TimeSpan.FromMilliseconds(100);

    private readonly LiveState _state = new(options) { Player = player, Recorder = recorder };
    private bool _quit;

    public override void OnStatus(ConnectionStatus status) => _state.Events.Add(DateTime.Now, status);

    public override bool OnFileFailed(FileFailure failure)
    {
        _state.AddFailure(failure);
        return true;
    }

    public override void OnMotion(MotionFrame frame) => _state.Allocations.OnFrame();

    public override void OnCalculation(CalculationFrame frame) => _state.Allocations.OnFrame();

    public override void OnStudioCalculation(StudioCalculationFrame frame) => _state.Allocations.OnFrame();

    public override Task RunAsync(CancellationToken stop) => Task.Factory.StartNew(
        () => Run(stop), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);

    public override void Finish(ReaderStatistics statistics)
    {
        output.Write(Encoding.UTF8.GetBytes(LineOutput.DescribeEnd(statistics) + "\n"));
        output.Flush();
    }

    private void Run(CancellationToken stop)
    {
        if (OperatingSystem.IsWindows())
            Console.OutputEncoding = Encoding.UTF8;

        using LatestFrames latest = reader.OpenLatest();
        using var screen = new Screen(output);
        Keyboard keyboard = Keyboard.Open();
        using PosixSignalRegistration? resume = OperatingSystem.IsWindows()
            ? null
            : PosixSignalRegistration.Create(PosixSignal.SIGCONT, _ => screen.Invalidate());
        while (!_quit && !stop.IsCancellationRequested)
        {
            while (keyboard.TryRead(out ConsoleKeyInfo key))
                Obey(key);

            _state.Update(reader, latest);
            screen.Show(Dashboard.Create(_state, Screen.Width, Screen.Height), Screen.Width, Screen.Height);
            WaitHandle.WaitAny([stop.WaitHandle, keyboard.Pressed], Period);
        }
    }

    private void Obey(ConsoleKeyInfo key)
    {
        if (player is not null && PlaybackKeys.Obey(player, key))
            return;

        switch (key)
        {
            case { KeyChar: 'q' or 'Q' }:
                _quit = true;
                break;
            case { KeyChar: ' ' }:
                _state.IsPaused = !_state.IsPaused;
                break;
            case { KeyChar: 'r' or 'R' }:
                _state.ResetCounters(reader);
                break;
            case { KeyChar: 'b' or 'B' }:
                _state.BonePage++;
                break;
            case { KeyChar: '?' or 'h' }:
                _state.ShowsHelp = !_state.ShowsHelp;
                break;
            case { Key: ConsoleKey.Tab }:
                _state.SelectNextAvatar();
                break;
            case { Key: ConsoleKey.Escape }:
                _state.ShowsHelp = false;
                break;
        }
    }
}
