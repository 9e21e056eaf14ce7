// A monitor for the console. It prints every change of the status in words, and a line for each avatar every second.
//
//   dotnet run --project samples/Monitor                            a simulator inside this program
//   dotnet run --project samples/Monitor -- 192.168.1.20            a computer that runs Axis Neuron or Axis Studio; also HOST:PORT, udp://:PORT
//   dotnet run --project samples/Monitor -- demo 300                ends after 300 frames; press Ctrl+C to end it at any time
//
// In your own project: dotnet add package NeuronMocap (and NeuronMocap.Server for the simulator).
// Exit code: 0 frames arrived, 1 no frame arrived, 2 wrong arguments.
using NeuronMocap;
using NeuronMocap.Server;

string address = args.Length > 0 ? args[0] : "demo";
long limit = long.MaxValue;
if (args.Length > 1 && !long.TryParse(args[1], out limit))
{
    Console.Error.WriteLine($"'{args[1]}' is not a number of frames.");
    return 2;
}

using Broadcaster? demo = address is "demo" ? Broadcaster.StartDemo(avatars: 2) : null;
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

await using var reader = new NeuronReader(options);
reader.StatusChanged += status => Console.WriteLine(status.Message);
Console.WriteLine("Ctrl+C ends the program.");

// Keeps the newest frame of each avatar. A monitor does not need older frames.
using LatestFrames latest = reader.OpenLatest();
reader.Start();

// Disposing the timer ends the loop below.
using var timer = new PeriodicTimer(TimeSpan.FromSeconds(1));
Console.CancelKeyPress += (_, key) =>
{
    key.Cancel = true;
    timer.Dispose();
};

while (reader.GetStatistics().Frames < limit && await timer.WaitForNextTickAsync())
{
    foreach (AvatarStatistics avatar in reader.GetAvatarStatistics())
    {
        string line = $"{avatar.AvatarName,-12} {avatar.Kind,-12} {avatar.FrameRate,6:0.0} Hz {avatar.Frames,8} frames {avatar.Lost,4} lost";
        if (latest.TryTakeMotion(avatar.AvatarIndex, out MotionFrame? frame) && frame.HasSkeleton)
            line += $"   hips at {frame.GetPosition(Bone.Hips):0.0} cm";

        Console.WriteLine(line);
    }
}

// After the stop the numbers are final.
await reader.DisposeAsync();
ReaderStatistics total = reader.GetStatistics();
Console.WriteLine($"{total.Frames} frames received, {total.Lost} lost.");
return total.Frames > 0 ? 0 : 1;
