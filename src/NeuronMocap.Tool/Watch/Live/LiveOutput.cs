using System.Runtime.InteropServices;
using System.Text;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Watch.Playback;
using NeuronMocap.Tool.Watch.Recordings;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>The live view. It updates ten times a second and with every key. All its work is on one thread.</summary>
internal sealed class LiveOutput(NeuronReader reader, RecordingPlayer? player, TakeRecorder takes, ConnectionOptions connection, Stream output) : WatchOutput
{
    private static readonly TimeSpan Period = TimeSpan.FromMilliseconds(100);

    private readonly LiveState _state = new(connection) { Player = player, Takes = takes, HasKeyboard = Keyboard.IsAvailable };
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

    public override Task RunAsync(CancellationToken cancellationToken) => Task.Factory.StartNew(
        () => Run(cancellationToken), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);

    public override void Finish(ReaderStatistics statistics)
    {
        output.Write(Encoding.UTF8.GetBytes(LineOutput.DescribeEnd(statistics) + "\n"));
        output.Flush();
    }

    private void Run(CancellationToken cancellationToken)
    {
        if (OperatingSystem.IsWindows())
            Console.OutputEncoding = Encoding.UTF8;

        using LatestFrames latest = reader.OpenLatest();
        using var screen = new Screen(output);
        Keyboard keyboard = Keyboard.Open();
        using PosixSignalRegistration? resume = OperatingSystem.IsWindows()
            ? null
            : PosixSignalRegistration.Create(PosixSignal.SIGCONT, _ => screen.Invalidate());
        while (!_quit && !cancellationToken.IsCancellationRequested)
        {
            while (keyboard.TryRead(out ConsoleKeyInfo key))
                HandleKey(key);

            _state.Update(reader, latest);
            screen.Show(Dashboard.Create(_state, Screen.Width, Screen.Height), Screen.Width, Screen.Height);
            WaitHandle.WaitAny([cancellationToken.WaitHandle, keyboard.Pressed], Period);
        }
    }

    private void HandleKey(ConsoleKeyInfo key)
    {
        if (player is not null && PlaybackKeys.TryHandle(player, key))
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
                SwitchRecording();
                break;
            case { KeyChar: 'c' or 'C' }:
                _state.ResetCounters(reader);
                break;
            case { KeyChar: 'b' }:
                _state.BonePage++;
                break;
            case { KeyChar: 'B' }:
                _state.BonePage--;
                break;
            case { KeyChar: '?' or 'h' or 'H' }:
                TurnHelpPage();
                break;
            case { Key: ConsoleKey.Tab }:
                _state.SelectNextAvatar();
                break;
            case { Key: ConsoleKey.Escape }:
                _state.HelpPage = null;
                break;
        }
    }

    private void TurnHelpPage()
    {
        int next = _state.HelpPage is { } page ? page + 1 : 0;
        _state.HelpPage = next < Dashboard.CountHelpPages(_state, Screen.Width, Screen.Height) ? next : null;
    }

    private void SwitchRecording()
    {
        if (player is not null)
        {
            _state.Say("A file that is played is not recorded again.");
            return;
        }

        if (takes.Current is not { } take)
        {
            Begin();
            return;
        }

        _ = EndAsync(take);
    }

    // The disk may be slow, but the view goes on.
    private async Task EndAsync(Take take)
    {
        long arrived = takes.FramesArrived;
        await take.StopAsync(arrived).ConfigureAwait(false);
        if (take.Recorder.Failure is null)
            _state.Say(TakeRecorder.DescribeEnd(take, arrived));
    }

    private void Begin()
    {
        _state.ForgetLastRecording();
        if (takes.Begin(DateTime.Now) is { } failure)
            _state.AddFailure(failure);
        else
            _state.Events.Add(DateTime.Now, $"Recording to {takes.Current?.Recorder.CurrentPath}.");
    }
}
