using NeuronMocap.Motion;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Skeleton;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Sources;

/// <summary>Contacts belong to the frame whose pose is shown. In the take here, the hips move by one centimetre in each frame.</summary>
public sealed class ContactTimeTests : SourceFixture
{
    private const int FrameRate = 60;
    private const int Stall = 120;
    private const int Last = 240;

    private static readonly ChannelLayout Layout = new(hasDisplacement: true, hasReference: false);

    private readonly string _file = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName() + ".nmrec");

    public override void Dispose()
    {
        base.Dispose();
        File.Delete(_file);
        GC.SuppressFinalize(this);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(12)]
    [InlineData(30)]
    public void Contacts_are_those_of_the_shown_frame_after_a_stall(int stalledFrames)
    {
        Write(stalledFrames);
        MocapSource source = Add(source =>
        {
            (source.Kind, source.File, source.Loop) = (SourceKind.Recording, _file, false);
            (source.Delay, source.Interpolation) = (200, PoseInterpolationMethod.Linear);
        });
        Performer performer = WaitForPose(source);
        Time.captureFramerate = 2 * FrameRate;
        var shown = new HashSet<int>();
        for (int i = 0; i < 2 * Last; i++)
        {
            Loop.Frame();
            float place = -100 * performer.GetPosition(Bone.Hips).x;
            int frame = Mathf.FloorToInt(place);
            bool isBetween = performer.PoseOrigin == PoseOrigin.Interpolated && frame > 0 && place - frame is > 0.05f and < 0.95f;

            // During the stall, the pose first goes on and then returns.
            if (!isBetween || Math.Abs(frame - Stall) < 3)
                continue;

            Assert.True(performer.HasMeasuredContacts);
            Assert.True(IsLeftDown(frame) == performer.Contacts.Left, $"frame {frame}, {place}");
            shown.Add(frame);
        }

        Assert.True(shown.Count > Last / 4, $"{shown.Count} frames");
        Assert.Contains(shown, static frame => frame > Stall);
    }

    private static bool IsLeftDown(int frame) => frame / 5 % 2 == 0;

    // The frames of the stall arrive with the first frame after it.
    private void Write(int stalledFrames)
    {
        using RecordingWriter writer = RecordingWriter.Create(_file);
        writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, "127.0.0.1:50000", "127.0.0.1:7001"));
        var actor = new ValuesSource(static (frame, layout, values) => values[layout.GetPositionIndex(Bone.Hips)] = frame);
        float[] motion = new float[Layout.ValueCount];
        float[] calculation = new float[CalculationFrame.FullValueCount];
        byte[] packets = new byte[64 + (Layout.ValueCount * sizeof(float)) + 64 + (calculation.Length * sizeof(float))];
        for (int frame = 0; frame < Last; frame++)
        {
            actor.WriteValues(frame, Layout, RotationOrder.YXZ, motion);
            calculation[CalculationFrame.BodyValueCount - 2] = IsLeftDown(frame) ? 1 : 0;
            int length = 64 + (motion.Length * sizeof(float));
            PacketEncoder.WriteMotion(packets.AsSpan(0, length), new MotionHeader { FrameIndex = (uint)frame, HasDisplacement = true }, motion);
            PacketEncoder.WriteCalculation(packets.AsSpan(length), new CalculationHeader { FrameIndex = (uint)frame }, calculation);
            int arrival = frame >= Stall && frame < Stall + stalledFrames ? Stall + stalledFrames : frame;
            writer.WriteBytes(TimeSpan.FromTicks(arrival * TimeSpan.TicksPerSecond / FrameRate), 0, packets);
        }
    }
}
