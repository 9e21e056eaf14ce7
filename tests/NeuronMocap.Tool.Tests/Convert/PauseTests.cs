using System.Globalization;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Tests.Gltf;
using NeuronMocap.Tool.Convert;
using NeuronMocap.Tool.Tests.Files;
using static NeuronMocap.Tool.Tests.Convert.Conversion;

namespace NeuronMocap.Tool.Tests.Convert;

/// <summary>Pauses of servers whose clock differs from the usual rate, or whose frames have no numbers at first.</summary>
public sealed class PauseTests : IDisposable
{
    private const int Before = 90 * 60;
    private const int Frames = Before + (12 * 60);

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData(60.3, 0.29)]
    [InlineData(60.3, 2)]
    [InlineData(59.7, 0.29)]
    [InlineData(59.7, 2)]
    [InlineData(60.3, 20)]
    public async Task A_pause_keeps_its_length_if_the_clock_of_the_server_is_off(double rate, double pause)
    {
        var random = new Random(1);
        using (var recording = new GlbRecording(_folder["take.nmrec"]))
        {
            for (int frame = 0; frame < Frames; frame++)
                recording.Add(1 + (frame / rate) + (frame < Before ? 0 : pause) + (random.NextDouble() * 0.004), frame);
        }

        await ConvertAsync(_folder["take.nmrec"], _folder["t.csv"]);
        await ConvertAsync(_folder["take.nmrec"], _folder["t.glb"]);

        double[] table = [.. File.ReadLines(_folder["t.csv"]).Where(static line => char.IsAsciiDigit(line[0])).Select(ReadTime)];
        Assert.Equal(Frames, table.Length);
        AssertTimes(frame => table[frame] - table[0], pause);
        float[] keys = GlbFile.Parse(File.ReadAllBytes(_folder["t.glb"])).KeyTimes(0, "Hips");
        AssertTimes(frame => keys[frame < Before ? frame : keys.Length - Frames + frame], pause);
    }

    [Theory]
    [InlineData(60.3)]
    [InlineData(59.7)]
    public async Task Another_connection_keeps_its_distance_if_the_clock_of_the_server_is_off(double rate)
    {
        using (var recording = new GlbRecording(_folder["take.nmrec"]))
        {
            for (int frame = 0; frame < Frames; frame++)
                recording.Add((frame / rate) + (frame < Before ? 0 : 2), frame < Before ? frame : frame + 1_000_000);
        }

        await ConvertAsync(_folder["take.nmrec"], _folder["t.csv"]);
        await ConvertAsync(_folder["take.nmrec"], _folder["t.glb"]);

        double[] table = [.. File.ReadLines(_folder["t.csv"]).Where(static line => char.IsAsciiDigit(line[0])).Select(ReadTime)];
        AssertTimes(frame => table[frame], 2);
        float[] keys = GlbFile.Parse(File.ReadAllBytes(_folder["t.glb"])).KeyTimes(0, "Hips");
        AssertTimes(frame => keys[frame < Before ? frame : keys.Length - Frames + frame], 2);
    }

    [Fact]
    public async Task A_pause_is_found_after_a_connection_without_numbers()
    {
        using (RecordingWriter writer = RecordingWriter.Create(_folder["take.nmrec"], RecordingMetadata.Empty.With(RecordingMetadata.RotationOrderKey, "YXZ")))
        {
            for (int frame = 0; frame < 180; frame++)
            {
                double time = (frame / 60.0) + (frame < 60 ? 0 : 2) + (frame < 120 ? 0 : 1);
                if (frame is 0 or 60)
                    writer.OpenConnection(TimeSpan.FromSeconds(time), new RecordedConnection(frame / 60, TransportKind.Tcp, string.Empty, string.Empty));

                var header = new MotionHeader { Version = frame < 60 ? DataVersion.Old : DataVersion.New, ValueCount = 354, HasDisplacement = true, FrameIndex = (uint)frame };
                byte[] packet = new byte[header.PacketSize];
                writer.WriteBytes(TimeSpan.FromSeconds(time), Math.Min(frame / 60, 1), packet.AsSpan(0, PacketEncoder.WriteMotion(packet, header, new float[354])));
            }
        }

        await ConvertAsync(_folder["take.nmrec"], _folder["t.csv"]);

        var table = new CsvTable(_folder["t.csv"]);
        Assert.Equal(180, table.RowCount);
        for (int row = 0; row < table.RowCount; row++)
            Assert.Equal(table.Number(row, "arrival"), table.Number(row, "time"), 1e-6);
    }

    [Fact]
    public void The_rate_is_read_once_for_a_pause()
    {
        int calls = 0;
        var pauses = new PauseFinder(() =>
        {
            calls++;
            return 60;
        });
        for (int frame = 0; frame < 600; frame++)
            pauses.Add(frame, frame, TimeSpan.FromSeconds((frame / 60.0) + (frame < 120 ? 0 : 1)));

        pauses.Finish();

        Pause pause = Assert.Single(pauses.Pauses);
        Assert.Equal((120, 1.0), (pause.Frame, Math.Round(pause.Length.TotalSeconds, 5)));
        Assert.Equal(2, calls);
    }

    private static void AssertTimes(Func<int, double> timeOf, double pause)
    {
        for (int frame = 0; frame < Frames; frame++)
            Assert.Equal((frame / 60.0) + (frame < Before ? 0 : pause), timeOf(frame), 0.015);
    }

    private static double ReadTime(string line) => double.Parse(line.AsSpan(0, line.IndexOf(',')), CultureInfo.InvariantCulture);
}
