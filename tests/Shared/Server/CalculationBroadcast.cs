using NeuronMocap.Calculation;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Server;

// A calculation export that is broadcast and received over real TCP.
internal static class CalculationBroadcast
{
    public static async Task<List<CalculationFrame>> ReceiveAsync(CalculationDocument document, BroadcastFormat format)
    {
        var source = new CalculationSource(document);
        await using var broadcaster = new Broadcaster(new BroadcasterOptions
        {
            Sources = [source],
            Port = 0,
            FrameRate = BroadcasterOptions.MaxFrameRate,
            WaitForClient = true,
            Format = format,
            TextDecimals = 4,
            Calculation = source.WriteCalculation,
            CalculationValueCount = source.ValueCount,
        });
        broadcaster.Start();
        var received = new List<CalculationFrame>();
        await using var reader = new NeuronReader(new NeuronReaderOptions
        {
            Port = broadcaster.LocalEndPoint!.Port,
            Reconnect = { Enabled = false },
        });
        reader.CalculationReceived += frame => received.Add(frame.Clone());
        reader.Start();
        await reader.Completion.Soon();
        Assert.Equal((0L, 0L), (reader.GetStatistics().Lost, reader.GetStatistics().BytesSkipped));
        return received;
    }

    public static void AssertEqual(CalculationFrame expected, CalculationFrame actual)
    {
        Assert.Equal(expected.Values.ToArray().Select(BitConverter.SingleToInt32Bits), actual.Values.ToArray().Select(BitConverter.SingleToInt32Bits));
        Assert.Equal(expected.BoneCount, actual.BoneCount);
        Assert.Equal((expected.LeftFootContact, expected.RightFootContact), (actual.LeftFootContact, actual.RightFootContact));
        Assert.Equal(expected.AvatarIndex, actual.AvatarIndex);
        Assert.Equal(expected.FrameIndex, actual.FrameIndex ?? expected.FrameIndex);
        foreach (Bone bone in CalculationOrder.Bones[..expected.BoneCount])
        {
            Assert.Equal(expected.GetPosition(bone), actual.GetPosition(bone));
            Assert.Equal(expected.GetSensorRotation(bone), actual.GetSensorRotation(bone));
            Assert.Equal(expected.GetAngularVelocity(bone), actual.GetAngularVelocity(bone));
        }
    }
}
