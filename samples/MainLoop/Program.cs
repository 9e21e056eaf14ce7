// A main loop as in a game: 60 turns a second. It takes frames on its own thread when it has time for them.
//
//   dotnet run --project samples/MainLoop                           a simulator inside this program, for 5 seconds
//   dotnet run --project samples/MainLoop -- 192.168.1.20 60        a computer that runs Axis Neuron or Axis Studio, for 60 seconds
//
// There are two ways to take frames. A FrameQueue has every frame in order: use it to simulate, or to keep the frames. LatestFrames has only the
// newest frame of each avatar: use it to draw. Neither makes the connection wait. Two seconds after the start, this loop pauses for half a second,
// like a game that loads a level. The queue becomes full, drops frames and counts them. The newest frame is always available.
//
// In your own project: dotnet add package NeuronMocap (and NeuronMocap.Server for the simulator).
// Exit code: 0 every frame is accounted for, 1 no frame arrived or the numbers do not add up, 2 wrong arguments.
using System.Diagnostics;
using System.Numerics;
using NeuronMocap;
using NeuronMocap.Server;

const int TurnsPerSecond = 60;
const int HitchTurn = 2 * TurnsPerSecond;

string address = args.Length > 0 ? args[0] : "demo";
int seconds = 5;
if (args.Length > 1 && !int.TryParse(args[1], out seconds))
{
    Console.Error.WriteLine($"'{args[1]}' is not a number of seconds.");
    return 2;
}

// Two frames for each turn of the loop.
using Broadcaster? demo = address is "demo" ? Broadcaster.StartDemo(frameRate: 2 * TurnsPerSecond) : null;
NeuronReaderOptions options;
try
{
    options = NeuronReaderOptions.Parse(demo is null ? address : $"{demo.LocalEndPoint}");
}
catch (FormatException exception)
{
    Console.Error.WriteLine(exception.Message);
    return 2;
}

using var reader = new NeuronReader(options);

// Both are opened before the start, so that they miss nothing. The capacity is only 16 frames, so that the pause has an effect. The default is 512.
using FrameQueue queue = reader.OpenQueue(capacity: 16);
using LatestFrames latest = reader.OpenLatest();
ConnectionStatus shown = reader.Status;
reader.Start();

var game = new Game();
long taken = 0;
var clock = Stopwatch.StartNew();
for (int turn = 1; turn <= seconds * TurnsPerSecond; turn++)
{
    // Reads the status on this thread. StatusChanged would be raised on another thread.
    ConnectionStatus status = reader.Status;
    if (status != shown)
        Console.WriteLine(status.Message);
    shown = status;

    // A frame is valid until the handler returns. The lambda is static, so the loop allocates no memory.
    taken += queue.Pump(game, static (Game game, MotionFrame frame) => game.Simulate(frame));
    if (latest.TryTakeMotion(0, out MotionFrame? newest))
        game.Draw(newest);

    if (turn == HitchTurn)
    {
        Console.WriteLine("The loop pauses for half a second.");
        Thread.Sleep(500);
    }

    if (turn % TurnsPerSecond == 0)
        Console.WriteLine($"{turn,5} turns: {taken} frames taken, {queue.Dropped} dropped, {game.Drawn} drawn, {game.Way:0} cm walked");

    // Late turns follow each other without a wait.
    TimeSpan wait = TimeSpan.FromSeconds((double)turn / TurnsPerSecond) - clock.Elapsed;
    if (wait > TimeSpan.Zero)
        Thread.Sleep(wait);
}

// A queue can still be drained after its reader has stopped.
reader.Dispose();
taken += queue.Pump(game, static (Game game, MotionFrame frame) => game.Simulate(frame));
long received = reader.GetStatistics().Frames;
Console.WriteLine($"{received} frames received = {taken} taken + {queue.Dropped} dropped; {game.Drawn} were drawn.");
return received > 0 && received == taken + queue.Dropped ? 0 : 1;

/// <summary>The game that this loop runs.</summary>
internal sealed class Game
{
    private Vector3? _hips;

    public float Way { get; private set; }

    public long Drawn { get; private set; }

    // The walked distance needs every frame. The current position needs only the newest one.
    public void Simulate(MotionFrame frame)
    {
        if (!frame.HasSkeleton)
            return;

        Vector3 hips = frame.GetPosition(Bone.Hips);
        Way += Vector3.Distance(_hips ?? hips, hips);
        _hips = hips;
    }

    public void Draw(MotionFrame frame) => Drawn++;
}
