using NeuronMocap.Bvh;
using NeuronMocap.Calculation;
using NeuronMocap.Tool.Tests.Files;
using static NeuronMocap.Tool.Tests.Convert.Conversion;
using static NeuronMocap.Tool.Tests.Convert.TakeComparison;

namespace NeuronMocap.Data.Tests.Tool;

public sealed class TakeConversionTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    [Fact]
    public async Task The_real_take_round_trips_through_every_format()
    {
        string take = Fixtures.Require("test-take", "test.bvh");
        await ConvertAsync(take, _folder["same.bvh"]);
        Assert.Equal(await File.ReadAllBytesAsync(take, Token), await File.ReadAllBytesAsync(_folder["same.bvh"], Token));

        await ConvertAsync(take, _folder["take.nmrec"]);
        await ConvertAsync(_folder["take.nmrec"], _folder["back.bvh"]);
        AssertSame(BvhDocument.Load(take), BvhDocument.Load(_folder["back.bvh"]));

        await ConvertAsync(take, _folder["take.dat"]);
        await ConvertAsync(_folder["take.dat"], _folder["raw.nmrec"]);
        await ConvertAsync(_folder["raw.nmrec"], _folder["raw.bin"]);
        Assert.Equal(await File.ReadAllBytesAsync(_folder["take.dat"], Token), await File.ReadAllBytesAsync(_folder["raw.bin"], Token));
    }

    [Theory]
    [InlineData("MasterLiuPerformanceChar00.calc")]
    [InlineData("hiphop_up_Char00.calc")]
    [InlineData("salsa_left_Char00.calc")]
    public async Task Real_calculation_exports_round_trip_through_a_recording(string name)
    {
        string take = Fixtures.Require("calc", name);
        await ConvertAsync(take, _folder["same.calc"]);
        Assert.Equal(await File.ReadAllBytesAsync(take, Token), await File.ReadAllBytesAsync(_folder["same.calc"], Token));

        await ConvertAsync(take, _folder["take.nmrec"]);
        await ConvertAsync(_folder["take.nmrec"], _folder["back.calc"]);
        AssertSame(CalculationDocument.Load(take), CalculationDocument.Load(_folder["back.calc"]));

        await ConvertAsync(take, _folder["direct.bvh"]);
        await ConvertAsync(_folder["take.nmrec"], _folder["recorded.bvh"]);
        AssertSame(BvhDocument.Load(_folder["direct.bvh"]), BvhDocument.Load(_folder["recorded.bvh"]));
    }

    public void Dispose() => _folder.Dispose();

    private static CancellationToken Token => TestContext.Current.CancellationToken;
}
