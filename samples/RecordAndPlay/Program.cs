// Records a stream, plays the recording back, and exports its motion to a BVH file. Writes take.nmrec and take.bvh in the current folder.
//
//   dotnet run --project samples/RecordAndPlay                      a simulator inside this program, for 2 seconds
//   dotnet run --project samples/RecordAndPlay -- 192.168.1.20 30   a computer that runs Axis Neuron or Axis Studio, for 30 seconds
//
// In your own project: dotnet add package NeuronMocap (and NeuronMocap.Server for the simulator).
// Exit code: 0 the playback has all received frames, 1 frames are missing or something failed, 2 wrong arguments.
using System.Globalization;
using NeuronMocap;
using NeuronMocap.Bvh;
using NeuronMocap.Recording;
using NeuronMocap.Server;

const string TakeFile = "take.nmrec";
const string BvhFile = "take.bvh";

string address = args.Length > 0 ? args[0] : "demo";
double seconds = 2;
if (args.Length > 1 && !(double.TryParse(args[1], NumberStyles.Float, CultureInfo.InvariantCulture, out seconds) && seconds is > 0 and < 1e6))
{
    Console.Error.WriteLine($"'{args[1]}' is not a number of seconds.");
    return 2;
}

using Broadcaster? demo = address is "demo" ? Broadcaster.StartDemo() : null;
try
{
    ReaderStatistics live = await RecordAsync(NeuronReaderOptions.Parse(demo is null ? address : $"{demo.LocalEndPoint}"));
    ReaderStatistics played = await PlayAsync();

    // The recording holds the bytes themselves. It includes frames that had arrived when the reader was stopped.
    return live.Frames > 0 && played.Frames == live.Frames + live.Undelivered ? 0 : 1;
}
catch (FormatException exception)
{
    Console.Error.WriteLine(exception.Message);
    return 2;
}
catch (Exception exception) when (exception is NeuronException or IOException or UnauthorizedAccessException)
{
    Console.Error.WriteLine(exception.Message);
    return 1;
}

async Task<ReaderStatistics> RecordAsync(NeuronReaderOptions options)
{
    await using var reader = new NeuronReader(options);
    reader.StatusChanged += status => Console.WriteLine(status.Message);

    // Starts before the reader, so that the recording has the first byte.
    await using StreamRecorder recorder = reader.StartRecording(TakeFile, new RecordingOptions { Overwrite = true });
    await reader.StartAsync(timeout: TimeSpan.FromSeconds(10));
    await Task.Delay(TimeSpan.FromSeconds(seconds));

    // The recording ends with its reader.
    await reader.DisposeAsync();
    await recorder.Completion;
    if (recorder.Failure is { } failure)
        throw new IOException($"The recording ended early: {failure.Message}", failure);

    Console.WriteLine($"Recorded {reader.GetStatistics().Frames} frames, {recorder.GetStatistics().WrittenBytes} bytes, to {TakeFile}");
    return reader.GetStatistics();
}

async Task<ReaderStatistics> PlayAsync()
{
    using RecordingPlayer player = RecordingPlayer.Open(TakeFile);
    player.Speed = RecordingPlayer.MaxSpeed; // 1 is the recorded speed

    // A reader of a recording supports everything that a reader of a live stream does: queues, events, BVH.
    await using var reader = new NeuronReader(player);
    await using BvhExport export = reader.ExportBvh(BvhFile, new BvhExportOptions { Overwrite = true });
    reader.Start();
    await reader.Completion;
    await export.StopAsync();
    if (export.Failure is { } failure)
        throw new IOException($"The export ended early: {failure.Message}", failure);

    Console.WriteLine($"Played {reader.GetStatistics().Frames} frames of {player.Duration.TotalSeconds:0.0} s");
    if (export.FramesWritten > 0)
    {
        BvhDocument take = BvhDocument.Load(BvhFile);
        Console.WriteLine($"Exported {take.FrameCount} frames of {take.Joints.Count} joints at {take.FrameRate:0.#} Hz to {BvhFile}");
    }

    return reader.GetStatistics();
}
