using NeuronMocap.Calculation;
using NeuronMocap.Tests.Calculation;
using NeuronMocap.Tests.Server;

namespace NeuronMocap.Server.Tests.Sources;

public sealed class CalculationSourceTests
{
    [Theory]
    [InlineData(BroadcastFormat.Binary, 338)]
    [InlineData(BroadcastFormat.Text, 338)]
    [InlineData(BroadcastFormat.Binary, 946)]
    [InlineData(BroadcastFormat.Text, 946)]
    public async Task Frames_of_the_file_and_the_stream_are_equal(BroadcastFormat format, int columns)
    {
        var document = CalculationDocument.Parse(CalculationText.Utf8(CalculationText.Rows(5, columns)));
        List<CalculationFrame> received = await CalculationBroadcast.ReceiveAsync(document, format);

        Assert.Equal(5, received.Count);
        for (int i = 0; i < received.Count; i++)
            CalculationBroadcast.AssertEqual(document.GetFrame(i), received[i]);
    }
}
