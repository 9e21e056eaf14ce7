using NeuronMocap.Protocol;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>Encodes the packets of Axis Studio (protocol.md section 9).</summary>
internal sealed class StudioFrameEncoder(FramePlan plan) : BinaryFrameEncoder(plan)
{
    private const long SecondsPerDay = 24 * 60 * 60;

    private readonly byte[] _payload = new byte[plan.StudioCalculation is null ? 0 : StudioCalculationSynthesizer.PayloadSize];

    /// <summary>Gets the timecode of a frame in the format of the two reserved fields. Frame 0 is at midnight.</summary>
    /// <param name="frame">Number of the frame.</param>
    /// <param name="rate">Frames per second.</param>
    /// <returns>The time as 0x00HHMMSS, and the number of the frame within its second.</returns>
    public static (uint Time, uint SubFrame) GetTimecode(long frame, double rate)
    {
        long seconds = (long)(frame / rate);
        if (frame >= FirstFrame(seconds + 1, rate))
            seconds++;

        long time = seconds % SecondsPerDay;
        uint packed = (uint)(((time / 3600) << 16) | ((time / 60 % 60) << 8) | (time % 60));
        return (packed, (uint)(frame - FirstFrame(seconds, rate)));
    }

    // Rates such as 29.97 are not exact. Where a frame starts a second, the product may be slightly too large.
    private static long FirstFrame(long second, double rate) => (long)Math.Ceiling((second * rate) - 1e-6);

    protected override void Stamp(Span<byte> header, long frame)
    {
        base.Stamp(header, frame);
        (uint time, uint subFrame) = GetTimecode(frame, Plan.FrameRate);
        MotionHeader.WriteTimecode(header, time, subFrame);
    }

    protected override int WriteCalculation(long frame, int avatar, Span<byte> destination)
    {
        Plan.StudioCalculation!(Plan.Sources[avatar], frame, _payload);
        var header = new StudioCalculationHeader
        {
            AvatarIndex = avatar,
            AvatarName = Plan.Names[avatar],
            FrameIndex = (uint)frame,
        };
        return PacketEncoder.WriteStudioCalculation(destination, header, _payload);
    }
}
