using System.Diagnostics;
using System.Runtime.InteropServices;
using NeuronDataReaderWraper;
using NeuronMocap.Compatibility.Tests.Infrastructure;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Compatibility.Tests.Callbacks;

public sealed class AllocationTests
{
    private const int FramesPerRound = 200;

    [Theory]
    [InlineData(HeaderLayout.New)]
    [InlineData(HeaderLayout.Old)]
    public async Task A_frame_allocates_nothing(HeaderLayout layout)
    {
        byte[] frame = TestPackets.Motion(1, layout: layout);
        float[] values = new float[354];
        int frames = 0;
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        NeuronDataReader.BRRegisterFrameDataCallback(IntPtr.Zero, (_, _, header, data) =>
        {
            Marshal.Copy(data, values, 0, (ushort)Marshal.ReadInt16(header, 6));
            Interlocked.Increment(ref frames);
        });

        SendAndWait();
        SendAndWait();
        Assert.Equal(0, Allocations.LeastOfProcess(SendAndWait));

        void SendAndWait()
        {
            long start = Stopwatch.GetTimestamp();
            int wanted = Volatile.Read(ref frames) + FramesPerRound;
            for (int i = 0; i < FramesPerRound; i++)
                server.Connection.Socket.Send(frame);
            while (Volatile.Read(ref frames) < wanted)
            {
                Thread.Yield();
                if (Stopwatch.GetElapsedTime(start) > Limits.Unexpected)
                    Assert.Fail("The frames did not arrive.");
            }
        }
    }
}
