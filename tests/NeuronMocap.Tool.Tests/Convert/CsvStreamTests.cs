using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Tests.Files;
using static NeuronMocap.Tool.Tests.Convert.Conversion;

namespace NeuronMocap.Tool.Tests.Convert;

/// <summary>Tables of streams with several avatars, losses, bursts and reconnections.</summary>
public sealed class CsvStreamTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly SyntheticSource _actor = new(60);

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task Avatars_have_rows_of_their_own_and_can_be_selected()
    {
        Record(static (recorder, frame) =>
        {
            recorder.Send(frame / 60.0, 0, 0, frame);
            recorder.Send((frame / 60.0) + 0.002, 0, 3, frame);
        }, 60);
        Assert.Contains(": 120 frames, ", await ConvertAsync(_folder["take.nmrec"], _folder["all.csv"]), StringComparison.Ordinal);
        string summary = await ConvertAsync(_folder["take.nmrec"], _folder["one.csv"], "--avatar", "3");
        Assert.Contains("not kept: 60 frames of other avatars", summary, StringComparison.Ordinal);

        var all = new CsvTable(_folder["all.csv"]);
        var one = new CsvTable(_folder["one.csv"]);
        Assert.Equal((120, 60), (all.RowCount, one.RowCount));
        Assert.Contains("# avatar 0: Actor 0", all.Comments);
        Assert.Contains("# avatar 3: Actor 3", all.Comments);
        Assert.DoesNotContain("# avatar 0: Actor 0", one.Comments);
        Assert.All(one.Column("avatar"), static avatar => Assert.Equal(3, avatar));
        for (int frame = 0; frame < 60; frame++)
        {
            Assert.Equal((0, 3), (all.Number(2 * frame, "avatar"), all.Number((2 * frame) + 1, "avatar")));
            Assert.Equal(all.Text(2 * frame, "time"), all.Text((2 * frame) + 1, "time"));
            Assert.Equal(all.Position((2 * frame) + 1, "RightHand"), one.Position(frame, "RightHand"));
        }
    }

    [Fact]
    public async Task Times_are_even_and_lost_frames_leave_holes()
    {
        // The first eight frames arrive together, later ones are late by up to 4 ms, and some are lost.
        var random = new Random(1);
        Record((recorder, frame) =>
        {
            if (frame % 37 != 30)
                recorder.Send(Math.Max(frame / 60.0, 0.12) + (random.NextDouble() * 0.004), 0, 0, frame);
        }, 240);
        string summary = await ConvertAsync(_folder["take.nmrec"], _folder["t.csv"]);
        Assert.Contains("; 6 gaps (6 frames missing); no rows left out", summary, StringComparison.Ordinal);

        var table = new CsvTable(_folder["t.csv"]);
        Assert.Equal(234, table.RowCount);
        for (int row = 1; row < table.RowCount; row++)
        {
            double frames = table.Number(row, "frame") - table.Number(0, "frame");
            Assert.Equal(frames / 60, table.Number(row, "time") - table.Number(0, "time"), 1e-6);
            Assert.True(table.Number(row, "arrival") >= table.Number(row - 1, "arrival"));
        }
    }

    [Fact]
    public async Task Another_connection_and_another_count_begin_at_their_arrival()
    {
        Record(static (recorder, frame) =>
        {
            (double start, int connection, int first) = frame < 60 ? (0, 0, 0) : frame < 120 ? (9, 0, 500_000 - 60) : (29, 1, 7 - 120);
            recorder.Send(start + (frame / 60.0), connection, 0, first + frame);
        }, 180);
        Assert.Contains("; 2 gaps; ", await ConvertAsync(_folder["take.nmrec"], _folder["t.csv"]), StringComparison.Ordinal);
        var table = new CsvTable(_folder["t.csv"]);
        Assert.Equal(180, table.RowCount);
        for (int row = 0; row < table.RowCount; row++)
            Assert.Equal(table.Number(row, "arrival"), table.Number(row, "time"), 1e-6);
    }

    [Theory]
    [InlineData(0.5)]
    [InlineData(3)]
    [InlineData(30)]
    public async Task A_pause_of_the_server_stays_though_its_numbers_go_on(double pause)
    {
        Record((recorder, frame) =>
        {
            for (int avatar = 0; avatar < 2; avatar++)
                recorder.Send((frame / 60.0) + (frame < 120 ? 0 : pause), 0, avatar, frame);
        }, 240);
        await ConvertAsync(_folder["take.nmrec"], _folder["t.csv"]);
        var table = new CsvTable(_folder["t.csv"]);
        Assert.Equal(480, table.RowCount);
        for (int row = 0; row < table.RowCount; row++)
            Assert.Equal(table.Number(row, "arrival"), table.Number(row, "time"), 1e-6);
    }

    [Fact]
    public async Task A_network_that_stalls_is_no_pause()
    {
        Record(static (recorder, frame) => recorder.Send(frame is >= 120 and < 420 ? 7 : frame / 60.0, 0, 0, frame), 600);
        await ConvertAsync(_folder["take.nmrec"], _folder["t.csv"]);
        var table = new CsvTable(_folder["t.csv"]);
        for (int row = 0; row < table.RowCount; row++)
            Assert.Equal(row / 60.0, table.Number(row, "time"), 1e-6);
    }

    [Fact]
    public async Task A_server_that_does_not_count_gives_times_of_arrival()
    {
        Record(static (recorder, frame) => recorder.Send(frame / 60.0, 0, 0, 0), 30);
        await ConvertAsync(_folder["take.nmrec"], _folder["t.csv"]);
        var table = new CsvTable(_folder["t.csv"]);
        Assert.Equal(table.Column("arrival"), table.Column("time"));
        Assert.Equal(30, table.Column("time").Distinct().Count());
    }

    [Fact]
    public async Task A_body_that_is_not_known_is_a_warning()
    {
        Record(static (recorder, frame) => recorder.Send(frame / 60.0, 0, 0, frame), 10, hasDisplacement: false);
        Assert.Contains("the default body", await ConvertAsync(_folder["take.nmrec"], _folder["t.csv"]), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Ctrl_C_leaves_nothing()
    {
        Record(static (recorder, frame) => recorder.Send(frame / 60.0, 0, 0, frame), 10);
        using var streams = new StandardStreams(Stream.Null, TextWriter.Null, IsTerminal: false);
        Assert.Equal(130, await CommandLine.RunAsync(["convert", _folder["take.nmrec"], _folder["t.csv"]], streams, new CancellationToken(canceled: true)));
        Assert.Equal(["take.nmrec"], _folder.Names);
    }

    private void Record(Action<Recorder, int> send, int frames, bool hasDisplacement = true)
    {
        using RecordingWriter writer = RecordingWriter.Create(_folder["take.nmrec"], RecordingMetadata.Empty.With(RecordingMetadata.RotationOrderKey, "YXZ"));
        var recorder = new Recorder(writer, _actor, new ChannelLayout(hasDisplacement, hasReference: false));
        for (int frame = 0; frame < frames; frame++)
            send(recorder, frame);
    }

    private sealed class Recorder(RecordingWriter writer, MotionSource actor, ChannelLayout layout)
    {
        private readonly float[] _values = new float[layout.ValueCount];
        private int _connections;
        private long _pose;

        public void Send(double time, int connection, int avatar, int index)
        {
            while (_connections <= connection)
            {
                writer.OpenConnection(TimeSpan.FromSeconds(time), new RecordedConnection(_connections++, TransportKind.Tcp, string.Empty, string.Empty));
                if (_connections > 1)
                    writer.CloseConnection(TimeSpan.FromSeconds(time), _connections - 2, "closed");
            }

            actor.WriteValues(_pose++, layout, RotationOrder.YXZ, _values);
            var header = new MotionHeader
            {
                ValueCount = _values.Length,
                HasDisplacement = layout.HasDisplacement,
                AvatarIndex = avatar,
                AvatarName = new AvatarName($"Actor {avatar}"),
                FrameIndex = (uint)index,
            };
            byte[] packet = new byte[header.PacketSize];
            writer.WriteBytes(TimeSpan.FromSeconds(time), connection, packet.AsSpan(0, PacketEncoder.WriteMotion(packet, header, _values)));
        }
    }
}
