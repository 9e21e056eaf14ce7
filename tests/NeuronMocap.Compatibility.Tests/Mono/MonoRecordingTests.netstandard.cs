using NeuronMocap.Recording;
using NeuronMocap.Tests.Mono;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Compatibility.Tests.Mono;

/// <summary>
/// Recordings that Mono writes, reads and plays, and one written by .NET. Checksums, Deflate, senders and clocks have other implementations there.
/// </summary>
public sealed class MonoRecordingTests : IDisposable
{
    private const string Program =
        """
        using System;
        using NeuronMocap;
        using NeuronMocap.Recording;

        public static class Program
        {
            public static void Main(string[] arguments)
            {
                var options = new NeuronReaderOptions { Port = int.Parse(arguments[0]) };
                options.Reconnect.Enabled = false;
                using (var reader = new NeuronReader(options))
                {
                    StreamRecorder recorder = reader.StartRecording(arguments[1]);
                    Show("live", reader);
                    recorder.Dispose();
                    Console.WriteLine(recorder.Failure == null && recorder.GetStatistics().LostPieces == 0);
                }

                for (int i = 1; i < arguments.Length; i++)
                {
                    using (RecordedFrameReader file = RecordedFrameReader.Open(arguments[i]))
                    {
                        uint sum = 0;
                        while (file.Read())
                            sum = Add(sum, file.Frame);

                        Show("read", file.GetStatistics(), sum);
                    }

                    foreach (double speed in new[] { RecordingPlayer.MaxSpeed, 100 })
                    {
                        using (RecordingPlayer player = RecordingPlayer.Open(arguments[i]))
                        using (var reader = new NeuronReader(player))
                        {
                            player.Speed = speed;
                            player.Seek(TimeSpan.Zero);
                            Show("played", reader);
                        }
                    }
                }
            }

            private static void Show(string how, NeuronReader reader)
            {
                uint sum = 0;
                reader.MotionReceived += frame => sum = Add(sum, frame);
                reader.CalculationReceived += frame => sum = Add(sum, frame);
                reader.Start();
                reader.Completion.Wait();
                Show(how, reader.GetStatistics(), sum);
            }

            private static void Show(string how, ReaderStatistics statistics, uint sum)
            {
                Console.WriteLine(how + " " + statistics.MotionFrames + " " + statistics.CalculationFrames + " " + statistics.BytesSkipped + " " + sum);
            }

            private static uint Add(uint sum, AvatarFrame frame)
            {
                foreach (float value in frame.Values.ToArray())
                    sum = sum * 31 + (uint)BitConverter.ToInt32(BitConverter.GetBytes(value), 0);

                return sum;
            }
        }
        """;

    private readonly string _folder = Directory.CreateTempSubdirectory("neuron-mocap-mono-").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public async Task Mono_records_reads_and_plays_like_dotnet()
    {
        MonoProgram.Require();
        using var program = new MonoProgram();
        await program.CompileAsync(Program);
        byte[] sent = StreamFixture.Load("mixed").Bytes;
        using var server = new TestServer();
        (string byMono, string byDotNet) = (Path.Combine(_folder, "mono.nmrec"), Path.Combine(_folder, "dotnet.nmrec"));

        uint sum = 0;
        await using var reader = new NeuronReader(server.Options());
        reader.MotionReceived += Add;
        reader.CalculationReceived += Add;
        StreamRecorder recorder = reader.StartRecording(byDotNet, new RecordingOptions { Compress = true });
        reader.Start();
        await SendAsync(server, sent);
        await reader.Completion.Soon();
        recorder.Dispose();
        ReaderStatistics statistics = reader.GetStatistics();
        string expected = $"{statistics.MotionFrames} {statistics.CalculationFrames} {statistics.BytesSkipped} {sum}";

        Task<string[]> run = program.RunAsync($"{server.Port}", byMono, byDotNet);
        await SendAsync(server, sent);
        string[] output = await run;

        Assert.True(statistics is { MotionFrames: > 0, BytesSkipped: > 0 });
        Assert.Equal(
            [
                $"live {expected}", "True", .. Enumerable.Repeat((string[])[$"read {expected}", $"played {expected}", $"played {expected}"], 2).SelectMany(static lines => lines),
            ],
            output);
        Assert.Equal(sent, Read(byMono));

        void Add(AvatarFrame frame)
        {
            foreach (float value in frame.Values)
                sum = (sum * 31) + BitConverter.SingleToUInt32Bits(value);
        }
    }

    private static async Task SendAsync(TestServer server, byte[] bytes)
    {
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(bytes);
        connection.Close();
    }

    private static byte[] Read(string path)
    {
        using RecordingReader reader = RecordingReader.Open(path);
        Assert.True(reader.IsComplete);
        var bytes = new MemoryStream();
        while (reader.TryRead(out RecordingEntry entry))
            bytes.Write(entry.Bytes);

        Assert.Empty(reader.Problems);
        return bytes.ToArray();
    }
}
