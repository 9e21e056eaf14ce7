using System.Globalization;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Watch;

/// <summary>
/// Kills the monitor while it records. Everything up to the last written block must be in the files. Runs a few times with the other tests, or as
/// often as an environment variable says.
/// </summary>
public sealed class RecordingKillTests
{
    private const string CountVariable = "NEURONMOCAP_KILLS";
    private const int UsualCount = 4;
    private const int ValueCount = 354;
    private const int PacketSize = 64 + (4 * ValueCount);
    private const int LargestBlock = 1024 * 1024;

    private static readonly float[] Values = [.. Enumerable.Range(0, ValueCount).Select(static value => value / 8f)];
    private static readonly string[][] Ways = [[], ["--record-compress"], ["--record-size", "2"]];

    [Fact]
    public async Task A_killed_recording_keeps_every_block_that_was_written()
    {
        int count = int.TryParse(Environment.GetEnvironmentVariable(CountVariable), CultureInfo.InvariantCulture, out int asked) ? asked : UsualCount;
        var random = new Random(count);
        var outcomes = new List<Outcome>();
        for (int i = 0; i < count; i++)
            outcomes.Add(await KillAsync(Ways[i % Ways.Length], TimeSpan.FromMilliseconds(random.Next(900))));

        TestContext.Current.TestOutputHelper!.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{count} kills: {outcomes.Sum(outcome => outcome.Files)} files with {outcomes.Sum(outcome => (long)outcome.Packets)} packets; "
            + $"{outcomes.Count(outcome => outcome.CutBytes > 0)} ended in the middle of a block, of which at most {outcomes.Max(outcome => outcome.CutBytes)} bytes were there; "
            + $"at most {outcomes.Max(outcome => outcome.Missing)} packets that the server had sent were not yet written."));
    }

    private static async Task<Outcome> KillAsync(string[] way, TimeSpan delay)
    {
        DirectoryInfo folder = Directory.CreateTempSubdirectory("neuronmocap-");
        try
        {
            int sent = 0;
            using FrameServer server = FrameServer.Pacing(number =>
            {
                Volatile.Write(ref sent, number);
                return Packet(number);
            });
            using (var monitor = new ToolProcess(
                "neuron-mocap", ["watch", server.Address, "--quiet", "--record", Path.Combine(folder.FullName, "take.nmrec"), .. way]))
            {
                while (folder.GetFiles().Length == 0)
                    await Task.Delay(1, TestContext.Current.CancellationToken);

                await Task.Delay(delay, TestContext.Current.CancellationToken);
                monitor.Kill();
            }

            return Check(folder, Volatile.Read(ref sent));
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }

    // The bytes of all files together are the start of what was sent. The last file may end in an incomplete block.
    private static Outcome Check(DirectoryInfo folder, int sent)
    {
        FileInfo[] files = [.. folder.GetFiles().OrderBy(file => file.Name, StringComparer.Ordinal)];
        var received = new MemoryStream();
        long cut = 0;
        foreach (FileInfo file in files)
        {
            // The first write to a file is its head. Without a whole head, nothing was recorded in the file yet.
            if (file.Length < 64)
            {
                Assert.Same(files[^1], file);
                break;
            }

            using RecordingReader reader = RecordingReader.Open(file.FullName);
            while (reader.TryRead(out RecordingEntry entry))
            {
                Assert.NotEqual(RecordingEntryKind.BytesLost, entry.Kind);
                Assert.NotEqual(RecordingEntryKind.Damaged, entry.Kind);
                received.Write(entry.Bytes);
            }

            foreach (RecordingProblem problem in reader.Problems)
            {
                Assert.Same(files[^1], file);
                Assert.Equal(file.Length, problem.Offset + problem.Length);
                cut += problem.Length;
            }
        }

        Assert.InRange(cut, 0, LargestBlock);
        byte[] bytes = received.ToArray();
        for (int start = 0; start < bytes.Length; start += PacketSize)
        {
            int length = Math.Min(PacketSize, bytes.Length - start);
            Assert.True(bytes.AsSpan(start, length).SequenceEqual(Packet(start / PacketSize).AsSpan(0, length)), $"Packet {start / PacketSize} is another.");
        }

        return new Outcome(files.Length, bytes.Length / PacketSize, cut, sent - (bytes.Length / PacketSize));
    }

    private static byte[] Packet(int number) => FrameServer.Motion((uint)number, Values);

    private readonly record struct Outcome(int Files, int Packets, long CutBytes, int Missing);
}
